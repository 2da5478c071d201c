/// More than eight variables: a ring, closed by a parameter.
///
/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the field
///
/// ```text
/// x0dot = a*x0*(x1 - x8)
/// x1dot = x1*(x2 - x0)
/// x2dot = x2*(x3 - x1)
/// x3dot = x3*(x4 - x2)
/// x4dot = x4*(x5 - x3)
/// x5dot = x5*(x6 - x4)
/// x6dot = x6*(x7 - x5)
/// x7dot = x7*(x8 - x6)
/// x8dot = x8*(x0 - x7)
/// ```
///
/// Matrix A(x,ε) = I − ε f′(x), row by row:
///
/// ```text
/// [ 1 - eps*a*x1 + eps*a*x8, -eps*a*x0, 0, 0, 0, 0, 0, 0, eps*a*x0 ]
/// [ eps*x1, 1 + eps*x0 - eps*x2, -eps*x1, 0, 0, 0, 0, 0, 0 ]
/// [ 0, eps*x2, 1 + eps*x1 - eps*x3, -eps*x2, 0, 0, 0, 0, 0 ]
/// [ 0, 0, eps*x3, 1 + eps*x2 - eps*x4, -eps*x3, 0, 0, 0, 0 ]
/// [ 0, 0, 0, eps*x4, 1 + eps*x3 - eps*x5, -eps*x4, 0, 0, 0 ]
/// [ 0, 0, 0, 0, eps*x5, 1 + eps*x4 - eps*x6, -eps*x5, 0, 0 ]
/// [ 0, 0, 0, 0, 0, eps*x6, 1 + eps*x5 - eps*x7, -eps*x6, 0 ]
/// [ 0, 0, 0, 0, 0, 0, eps*x7, 1 + eps*x6 - eps*x8, -eps*x7 ]
/// [ -eps*x8, 0, 0, 0, 0, 0, 0, eps*x8, 1 - eps*x0 + eps*x7 ]
/// ```
/// The map solves A(x,ε)·x̃ = b(x,ε): its closed form exceeds the budget of terms. Where det A = 0 it counts as a pole.
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Coupled<T> {
    /// The parameter `a`.
    pub a: T,
}
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
#[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
const _: () = {
    use ::kahan_core::__private::{self as __kahan, arguments::*, Clone as _};
    impl<T> Coupled<T> {
        /// The state variables, in order.
        pub const VARIABLES: [&'static __kahan::str; 9] = [
            "x0",
            "x1",
            "x2",
            "x3",
            "x4",
            "x5",
            "x6",
            "x7",
            "x8",
        ];
        /// The parameters, in order.
        pub const PARAMETERS: [&'static __kahan::str; 1] = ["a"];
    }
    impl Coupled<__kahan::f64> {
        /// Where `x0` stands in a point: `x[Coupled::X0]`.
        pub const X0: __kahan::usize = 0;
        /// Where `x1` stands in a point: `x[Coupled::X1]`.
        pub const X1: __kahan::usize = 1;
        /// Where `x2` stands in a point: `x[Coupled::X2]`.
        pub const X2: __kahan::usize = 2;
        /// Where `x3` stands in a point: `x[Coupled::X3]`.
        pub const X3: __kahan::usize = 3;
        /// Where `x4` stands in a point: `x[Coupled::X4]`.
        pub const X4: __kahan::usize = 4;
        /// Where `x5` stands in a point: `x[Coupled::X5]`.
        pub const X5: __kahan::usize = 5;
        /// Where `x6` stands in a point: `x[Coupled::X6]`.
        pub const X6: __kahan::usize = 6;
        /// Where `x7` stands in a point: `x[Coupled::X7]`.
        pub const X7: __kahan::usize = 7;
        /// Where `x8` stands in a point: `x[Coupled::X8]`.
        pub const X8: __kahan::usize = 8;
    }
    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 9> for Coupled<T> {
        fn field(&self, x: &__kahan::SVector<T, 9>) -> __kahan::SVector<T, 9> {
            __kahan::vector(
                <__Coupled as __kahan::CoupledField<
                    9,
                    1,
                    27,
                    39,
                >>::field::<T>(&[self.a.clone()], __kahan::components(x)),
            )
        }
    }
    pub struct __Coupled;
    impl __kahan::CoupledField<9, 1, 27, 39> for __Coupled {
        const COUPLINGS: __kahan::Couplings<'static> = __kahan::Couplings {
            order: &[0, 2, 4, 6, 1, 5, 3, 7, 8],
            rows: &[
                __kahan::CouplingRow::new(0, 0, 0, 3),
                __kahan::CouplingRow::new(3, 3, 3, 6),
                __kahan::CouplingRow::new(6, 6, 6, 9),
                __kahan::CouplingRow::new(9, 9, 9, 12),
                __kahan::CouplingRow::new(12, 12, 14, 17),
                __kahan::CouplingRow::new(17, 17, 19, 22),
                __kahan::CouplingRow::new(22, 22, 26, 29),
                __kahan::CouplingRow::new(29, 29, 32, 34),
                __kahan::CouplingRow::new(34, 34, 38, 39),
            ],
            columns: &[
                0, 4, 8, 1, 4, 6, 2, 5, 6, 3, 5, 7, 0, 1, 4, 6, 8, 2, 3, 5, 6, 7, 1, 2,
                4, 5, 6, 7, 8, 3, 5, 6, 7, 8, 0, 4, 6, 7, 8,
            ],
            blocks: &[9],
            places: &[
                0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 17, 18, 19, 22, 23, 26,
                29, 32, 33, 34, 37, 38,
            ],
        };
        const FIELD: &'static [__kahan::Postfix<'static>] = {
            use __kahan::Postfix::*;
            &[
                State(0),
                Parameter(0),
                Multiply,
                State(1),
                State(8),
                Subtract,
                Multiply,
                Done,
                State(2),
                State(0),
                Subtract,
                State(1),
                Multiply,
                Done,
                State(3),
                State(1),
                Subtract,
                State(2),
                Multiply,
                Done,
                State(4),
                State(2),
                Subtract,
                State(3),
                Multiply,
                Done,
                State(5),
                State(3),
                Subtract,
                State(4),
                Multiply,
                Done,
                State(6),
                State(4),
                Subtract,
                State(5),
                Multiply,
                Done,
                State(7),
                State(5),
                Subtract,
                State(6),
                Multiply,
                Done,
                State(8),
                State(6),
                Subtract,
                State(7),
                Multiply,
                Done,
                State(0),
                State(7),
                Subtract,
                State(8),
                Multiply,
                Done,
            ]
        };
        const SLOPES: &'static [__kahan::Postfix<'static>] = {
            use __kahan::Postfix::*;
            &[
                State(1),
                State(8),
                Subtract,
                Parameter(0),
                Multiply,
                Done,
                Parameter(0),
                State(0),
                Multiply,
                Done,
                Parameter(0),
                State(0),
                Multiply,
                Negate,
                Done,
                State(3),
                State(1),
                Subtract,
                Done,
                State(2),
                Negate,
                Done,
                State(2),
                Done,
                State(5),
                State(3),
                Subtract,
                Done,
                State(4),
                Done,
                State(4),
                Negate,
                Done,
                State(7),
                State(5),
                Subtract,
                Done,
                State(6),
                Negate,
                Done,
                State(6),
                Done,
                State(1),
                Negate,
                Done,
                State(1),
                Done,
                State(2),
                State(0),
                Subtract,
                Done,
                State(5),
                Negate,
                Done,
                State(5),
                Done,
                State(6),
                State(4),
                Subtract,
                Done,
                State(3),
                Negate,
                Done,
                State(3),
                Done,
                State(4),
                State(2),
                Subtract,
                Done,
                State(7),
                Negate,
                Done,
                State(8),
                State(6),
                Subtract,
                Done,
                State(7),
                Done,
                State(8),
                Done,
                State(8),
                Negate,
                Done,
                State(0),
                State(7),
                Subtract,
                Done,
            ]
        };
        const COST: __kahan::StepCost = __kahan::StepCost::of(295, 9, 138);
        fn field<T: __kahan::Scalar>(__parameters: &[T; 1], x: &[T; 9]) -> [T; 9] {
            let [__s_x0, __s_x1, __s_x2, __s_x3, __s_x4, __s_x5, __s_x6, __s_x7, __s_x8,
            ] = x;
            let [__p_a] = __parameters;
            [
                __s_x0.clone() * __p_a.clone() * (__s_x1.clone() - __s_x8.clone()),
                __s_x1.clone() * (__s_x2.clone() - __s_x0.clone()),
                __s_x2.clone() * (__s_x3.clone() - __s_x1.clone()),
                __s_x3.clone() * (__s_x4.clone() - __s_x2.clone()),
                __s_x4.clone() * (__s_x5.clone() - __s_x3.clone()),
                __s_x5.clone() * (__s_x6.clone() - __s_x4.clone()),
                __s_x6.clone() * (__s_x7.clone() - __s_x5.clone()),
                __s_x7.clone() * (__s_x8.clone() - __s_x6.clone()),
                __s_x8.clone() * (__s_x0.clone() - __s_x7.clone()),
            ]
        }
        fn slopes<T: __kahan::Scalar>(__parameters: &[T; 1], x: &[T; 9]) -> [T; 27] {
            let [__s_x0, __s_x1, __s_x2, __s_x3, __s_x4, __s_x5, __s_x6, __s_x7, __s_x8,
            ] = x;
            let [__p_a] = __parameters;
            let __t_a_x0 = __p_a.clone() * __s_x0.clone();
            [
                __p_a.clone() * (__s_x1.clone() - __s_x8.clone()),
                __t_a_x0.clone(),
                -__t_a_x0,
                __s_x3.clone() - __s_x1.clone(),
                -__s_x2.clone(),
                __s_x2.clone(),
                __s_x5.clone() - __s_x3.clone(),
                __s_x4.clone(),
                -__s_x4.clone(),
                __s_x7.clone() - __s_x5.clone(),
                -__s_x6.clone(),
                __s_x6.clone(),
                -__s_x1.clone(),
                __s_x1.clone(),
                __s_x2.clone() - __s_x0.clone(),
                -__s_x5.clone(),
                __s_x5.clone(),
                __s_x6.clone() - __s_x4.clone(),
                -__s_x3.clone(),
                __s_x3.clone(),
                __s_x4.clone() - __s_x2.clone(),
                -__s_x7.clone(),
                __s_x8.clone() - __s_x6.clone(),
                __s_x7.clone(),
                __s_x8.clone(),
                -__s_x8.clone(),
                __s_x0.clone() - __s_x7.clone(),
            ]
        }
        fn velocity<T: __kahan::Scalar>(
            __parameters: &[T; 1],
            x: &[T; 9],
            eps: &T,
        ) -> __kahan::Option<[T; 9]> {
            let [__d0, __d1, __d2, __d3, __d4, __d5, __d6, __d7, __d8, __d9, __d10,
            __d11, __d12, __d13, __d14, __d15, __d16, __d17, __d18, __d19, __d20, __d21,
            __d22, __d23, __d24, __d25, __d26]: [T; 27] = Self::slopes(__parameters, x);
            let [__zero, __one]: [T; 2] = [__kahan::integer(0), __kahan::integer(1)];
            let __a0 = -(eps.clone() * __d0);
            let __a1 = -(eps.clone() * __d1);
            let __a2 = -(eps.clone() * __d2);
            let __a3 = -(eps.clone() * __d3);
            let __a4 = -(eps.clone() * __d4);
            let __a5 = -(eps.clone() * __d5);
            let __a6 = -(eps.clone() * __d6);
            let __a7 = -(eps.clone() * __d7);
            let __a8 = -(eps.clone() * __d8);
            let __a9 = -(eps.clone() * __d9);
            let __a10 = -(eps.clone() * __d10);
            let __a11 = -(eps.clone() * __d11);
            let __a12 = -(eps.clone() * __d12);
            let __a13 = -(eps.clone() * __d13);
            let __a14 = -(eps.clone() * __d14);
            let __a17 = -(eps.clone() * __d15);
            let __a18 = -(eps.clone() * __d16);
            let __a19 = -(eps.clone() * __d17);
            let __a22 = -(eps.clone() * __d18);
            let __a23 = -(eps.clone() * __d19);
            let __a26 = -(eps.clone() * __d20);
            let __a29 = -(eps.clone() * __d21);
            let __a32 = -(eps.clone() * __d22);
            let __a33 = -(eps.clone() * __d23);
            let __a34 = -(eps.clone() * __d24);
            let __a37 = -(eps.clone() * __d25);
            let __a38 = -(eps.clone() * __d26);
            let __a0 = __one.clone() + __a0;
            let __a3 = __one.clone() + __a3;
            let __a6 = __one.clone() + __a6;
            let __a9 = __one.clone() + __a9;
            let __a14 = __one.clone() + __a14;
            let __a19 = __one.clone() + __a19;
            let __a26 = __one.clone() + __a26;
            let __a32 = __one.clone() + __a32;
            let __a38 = __one.clone() + __a38;
            let __most: T = __kahan::integer(__kahan::LARGEST_FACTOR);
            let mut __is_refused = false;
            __is_refused |= __a0.is_zero();
            let __a0 = __a0.reciprocal()?;
            __is_refused |= __a3.is_zero();
            let __a3 = __a3.reciprocal()?;
            __is_refused |= __a6.is_zero();
            let __a6 = __a6.reciprocal()?;
            __is_refused |= __a9.is_zero();
            let __a9 = __a9.reciprocal()?;
            let __a12 = __a12 * __a0.clone();
            __is_refused
                |= __a12.is_better_pivot(&__most)
                    && (false || (__a1.clone() * __a0.clone()).is_better_pivot(&__most)
                        || (__a2.clone() * __a0.clone()).is_better_pivot(&__most));
            let __a14 = __a14.subtract_product(__a12.clone(), __a1.clone());
            let __a16 = __zero.clone().subtract_product(__a12.clone(), __a2.clone());
            let __a13 = __a13 * __a3.clone();
            __is_refused
                |= __a13.is_better_pivot(&__most)
                    && (false || (__a4.clone() * __a3.clone()).is_better_pivot(&__most)
                        || (__a5.clone() * __a3.clone()).is_better_pivot(&__most));
            let __a14 = __a14.subtract_product(__a13.clone(), __a4.clone());
            let __a15 = __zero.clone().subtract_product(__a13.clone(), __a5.clone());
            __is_refused |= __a14.is_zero();
            let __a14 = __a14.reciprocal()?;
            let __a17 = __a17 * __a6.clone();
            __is_refused
                |= __a17.is_better_pivot(&__most)
                    && (false || (__a7.clone() * __a6.clone()).is_better_pivot(&__most)
                        || (__a8.clone() * __a6.clone()).is_better_pivot(&__most));
            let __a19 = __a19.subtract_product(__a17.clone(), __a7.clone());
            let __a20 = __zero.clone().subtract_product(__a17.clone(), __a8.clone());
            let __a18 = __a18 * __a9.clone();
            __is_refused
                |= __a18.is_better_pivot(&__most)
                    && (false || (__a10.clone() * __a9.clone()).is_better_pivot(&__most)
                        || (__a11.clone() * __a9.clone()).is_better_pivot(&__most));
            let __a19 = __a19.subtract_product(__a18.clone(), __a10.clone());
            let __a21 = __zero.clone().subtract_product(__a18.clone(), __a11.clone());
            __is_refused |= __a19.is_zero();
            let __a19 = __a19.reciprocal()?;
            let __a22 = __a22 * __a3.clone();
            __is_refused
                |= __a22.is_better_pivot(&__most)
                    && (false || (__a4.clone() * __a3.clone()).is_better_pivot(&__most)
                        || (__a5.clone() * __a3.clone()).is_better_pivot(&__most));
            let __a24 = __zero.clone().subtract_product(__a22.clone(), __a4.clone());
            let __a26 = __a26.subtract_product(__a22.clone(), __a5.clone());
            let __a23 = __a23 * __a6.clone();
            __is_refused
                |= __a23.is_better_pivot(&__most)
                    && (false || (__a7.clone() * __a6.clone()).is_better_pivot(&__most)
                        || (__a8.clone() * __a6.clone()).is_better_pivot(&__most));
            let __a25 = __zero.clone().subtract_product(__a23.clone(), __a7.clone());
            let __a26 = __a26.subtract_product(__a23.clone(), __a8.clone());
            let __a24 = __a24 * __a14.clone();
            __is_refused
                |= __a24.is_better_pivot(&__most)
                    && (false || (__a15.clone() * __a14.clone()).is_better_pivot(&__most)
                        || (__a16.clone() * __a14.clone()).is_better_pivot(&__most));
            let __a26 = __a26.subtract_product(__a24.clone(), __a15.clone());
            let __a28 = __zero.clone().subtract_product(__a24.clone(), __a16.clone());
            let __a25 = __a25 * __a19.clone();
            __is_refused
                |= __a25.is_better_pivot(&__most)
                    && (false || (__a20.clone() * __a19.clone()).is_better_pivot(&__most)
                        || (__a21.clone() * __a19.clone()).is_better_pivot(&__most));
            let __a26 = __a26.subtract_product(__a25.clone(), __a20.clone());
            let __a27 = __zero.clone().subtract_product(__a25.clone(), __a21.clone());
            __is_refused |= __a26.is_zero();
            let __a26 = __a26.reciprocal()?;
            let __a29 = __a29 * __a9.clone();
            __is_refused
                |= __a29.is_better_pivot(&__most)
                    && (false || (__a10.clone() * __a9.clone()).is_better_pivot(&__most)
                        || (__a11.clone() * __a9.clone()).is_better_pivot(&__most));
            let __a30 = __zero.clone().subtract_product(__a29.clone(), __a10.clone());
            let __a32 = __a32.subtract_product(__a29.clone(), __a11.clone());
            let __a30 = __a30 * __a19.clone();
            __is_refused
                |= __a30.is_better_pivot(&__most)
                    && (false || (__a20.clone() * __a19.clone()).is_better_pivot(&__most)
                        || (__a21.clone() * __a19.clone()).is_better_pivot(&__most));
            let __a31 = __zero.clone().subtract_product(__a30.clone(), __a20.clone());
            let __a32 = __a32.subtract_product(__a30.clone(), __a21.clone());
            let __a31 = __a31 * __a26.clone();
            __is_refused
                |= __a31.is_better_pivot(&__most)
                    && (false || (__a27.clone() * __a26.clone()).is_better_pivot(&__most)
                        || (__a28.clone() * __a26.clone()).is_better_pivot(&__most));
            let __a32 = __a32.subtract_product(__a31.clone(), __a27.clone());
            let __a33 = __a33.subtract_product(__a31.clone(), __a28.clone());
            __is_refused |= __a32.is_zero();
            let __a32 = __a32.reciprocal()?;
            let __a34 = __a34 * __a0.clone();
            __is_refused
                |= __a34.is_better_pivot(&__most)
                    && (false || (__a1.clone() * __a0.clone()).is_better_pivot(&__most)
                        || (__a2.clone() * __a0.clone()).is_better_pivot(&__most));
            let __a35 = __zero.clone().subtract_product(__a34.clone(), __a1.clone());
            let __a38 = __a38.subtract_product(__a34.clone(), __a2.clone());
            let __a35 = __a35 * __a14.clone();
            __is_refused
                |= __a35.is_better_pivot(&__most)
                    && (false || (__a15.clone() * __a14.clone()).is_better_pivot(&__most)
                        || (__a16.clone() * __a14.clone()).is_better_pivot(&__most));
            let __a36 = __zero.clone().subtract_product(__a35.clone(), __a15.clone());
            let __a38 = __a38.subtract_product(__a35.clone(), __a16.clone());
            let __a36 = __a36 * __a26.clone();
            __is_refused
                |= __a36.is_better_pivot(&__most)
                    && (false || (__a27.clone() * __a26.clone()).is_better_pivot(&__most)
                        || (__a28.clone() * __a26.clone()).is_better_pivot(&__most));
            let __a37 = __a37.subtract_product(__a36.clone(), __a27.clone());
            let __a38 = __a38.subtract_product(__a36.clone(), __a28.clone());
            let __a37 = __a37 * __a32.clone();
            __is_refused
                |= __a37.is_better_pivot(&__most)
                    && (false
                        || (__a33.clone() * __a32.clone()).is_better_pivot(&__most));
            let __a38 = __a38.subtract_product(__a37.clone(), __a33.clone());
            __is_refused |= __a38.is_zero();
            let __a38 = __a38.reciprocal()?;
            if __is_refused {
                return __kahan::None;
            }
            let [__b0, __b1, __b2, __b3, __b4, __b5, __b6, __b7, __b8]: [T; 9] = Self::field(
                __parameters,
                x,
            );
            let __b1 = __b1
                .subtract_product(__a12.clone(), __b0.clone())
                .subtract_product(__a13.clone(), __b2.clone());
            let __b5 = __b5
                .subtract_product(__a17.clone(), __b4.clone())
                .subtract_product(__a18.clone(), __b6.clone());
            let __b3 = __b3
                .subtract_product(__a22.clone(), __b2.clone())
                .subtract_product(__a23.clone(), __b4.clone())
                .subtract_product(__a24.clone(), __b1.clone())
                .subtract_product(__a25.clone(), __b5.clone());
            let __b7 = __b7
                .subtract_product(__a29.clone(), __b6.clone())
                .subtract_product(__a30.clone(), __b5.clone())
                .subtract_product(__a31.clone(), __b3.clone());
            let __b8 = __b8
                .subtract_product(__a34.clone(), __b0.clone())
                .subtract_product(__a35.clone(), __b1.clone())
                .subtract_product(__a36.clone(), __b3.clone())
                .subtract_product(__a37.clone(), __b7.clone());
            let __b8 = __b8 * __a38;
            let __b7 = __b7.subtract_product(__a33.clone(), __b8.clone()) * __a32;
            let __b3 = __b3
                .subtract_product(__a28.clone(), __b8.clone())
                .subtract_product(__a27.clone(), __b7.clone()) * __a26;
            let __b5 = __b5
                .subtract_product(__a21.clone(), __b7.clone())
                .subtract_product(__a20.clone(), __b3.clone()) * __a19;
            let __b1 = __b1
                .subtract_product(__a16.clone(), __b8.clone())
                .subtract_product(__a15.clone(), __b3.clone()) * __a14;
            let __b6 = __b6
                .subtract_product(__a11.clone(), __b7.clone())
                .subtract_product(__a10.clone(), __b5.clone()) * __a9;
            let __b4 = __b4
                .subtract_product(__a8.clone(), __b3.clone())
                .subtract_product(__a7.clone(), __b5.clone()) * __a6;
            let __b2 = __b2
                .subtract_product(__a5.clone(), __b3.clone())
                .subtract_product(__a4.clone(), __b1.clone()) * __a3;
            let __b0 = __b0
                .subtract_product(__a2.clone(), __b8.clone())
                .subtract_product(__a1.clone(), __b1.clone()) * __a0;
            __kahan::Some([__b0, __b1, __b2, __b3, __b4, __b5, __b6, __b7, __b8])
        }
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 9> for Coupled<T> {
        type Prepared = __kahan::CoupledStep<__Coupled, T, 9, 1, 27, 39>;
        fn prepare(&self, eps: &T) -> Self::Prepared {
            __kahan::CoupledStep::new([self.a.clone()], eps.clone())
        }
        fn jacobian(
            &self,
            x: &__kahan::SVector<T, 9>,
            eps: T,
        ) -> __kahan::SMatrix<T, 9, 9> {
            self.prepare(&eps).jacobian(x)
        }
        #[inline(always)]
        fn try_prepared(
            &self,
            prepared: &Self::Prepared,
            x: &__kahan::SVector<T, 9>,
            eps: &T,
        ) -> __kahan::Result<__kahan::SVector<T, 9>, __kahan::SingularStep>
        where
            T: __kahan::Pivot,
        {
            prepared.promised(self, x)
        }
    }
};
