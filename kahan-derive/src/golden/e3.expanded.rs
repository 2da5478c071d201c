/// The flow E3: rotations about the z axis.
#[derive(Default)]
///
/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the field
///
/// ```text
/// xdot = -x*z
/// ydot = -y*z
/// zdot = x^2 + y^2
/// ```
///
/// Matrix A(x,ε) = I − ε f′(x), row by row:
///
/// ```text
/// [ 1 + eps*z, 0, eps*x ]
/// [ 0, 1 + eps*z, eps*y ]
/// [ -2*eps*x, -2*eps*y, 1 ]
/// ```
///
/// The map in lowest terms:
///
/// ```text
/// x~ = x + 2*eps*(-x*z - eps*x^3 - eps*x*y^2)/(1 + eps*z + 2*eps^2*x^2 + 2*eps^2*y^2)
/// y~ = y + 2*eps*(-y*z - eps*x^2*y - eps*y^3)/(1 + eps*z + 2*eps^2*x^2 + 2*eps^2*y^2)
/// z~ = z + 2*eps*(x^2 + y^2 - eps*x^2*z - eps*y^2*z)/(1 + eps*z + 2*eps^2*x^2 + 2*eps^2*y^2)
/// ```
///
/// Proved while compiling:
///
/// ```text
/// integral H = y/x;
/// integral K = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
/// density rho = 2/(x*y*(x^2 + y^2 + z^2));
/// bracket P { {y,z} = y*(1 + eps^2*(x^2 + y^2)); {z,x} = -x*(1 + eps^2*(x^2 + y^2)); }
/// ```
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct E3;
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
#[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
const _: () = {
    use ::kahan_core::__private as __kahan;
    use __kahan::Clone as _;
    impl E3 {
        /// The state variables, in order.
        pub const VARIABLES: [&'static __kahan::core::primitive::str; 3] = [
            "x",
            "y",
            "z",
        ];
        /// The parameters, in order.
        pub const PARAMETERS: [&'static __kahan::core::primitive::str; 0] = [];
    }
    impl __kahan::Named for E3 {
        fn variables(&self) -> &'static [&'static __kahan::core::primitive::str] {
            &Self::VARIABLES
        }
        fn parameters(&self) -> &'static [&'static __kahan::core::primitive::str] {
            &Self::PARAMETERS
        }
    }
    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 3> for E3 {
        fn field(&self, state: &__kahan::SVector<T, 3>) -> __kahan::SVector<T, 3> {
            let [s_x, s_y, s_z] = __kahan::components(state);
            __kahan::vector([
                -(s_x.clone() * s_z.clone()),
                -(s_z.clone() * s_y.clone()),
                s_x.clone() * s_x.clone() + s_y.clone() * s_y.clone(),
            ])
        }
        fn field_jacobian(
            &self,
            state: &__kahan::SVector<T, 3>,
        ) -> __kahan::SMatrix<T, 3, 3> {
            let [s_x, s_y, s_z] = __kahan::components(state);
            let negative_1 = -s_z.clone();
            let c_0 = __kahan::integer::<T>(0);
            let c_2 = __kahan::integer::<T>(2);
            __kahan::matrix([
                [negative_1.clone(), c_0.clone(), -s_x.clone()],
                [c_0.clone(), negative_1.clone(), -s_y.clone()],
                [s_x.clone() * c_2.clone(), s_y.clone() * c_2.clone(), c_0.clone()],
            ])
        }
        fn bilinear(
            &self,
            state: &__kahan::SVector<T, 3>,
            other: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            let [s_x, s_y, s_z] = __kahan::components(state);
            let [o_x, o_y, o_z] = __kahan::components(other);
            let c_1_2 = __kahan::ratio::<T>(1, 2);
            __kahan::vector([
                -((s_x.clone() * o_z.clone() + s_z.clone() * o_x.clone())
                    * c_1_2.clone()),
                -(c_1_2.clone()
                    * (o_z.clone() * s_y.clone() + s_z.clone() * o_y.clone())),
                s_x.clone() * o_x.clone() + s_y.clone() * o_y.clone(),
            ])
        }
        fn polarized(
            &self,
            state: &__kahan::SVector<T, 3>,
            other: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            let [s_x, s_y, s_z] = __kahan::components(state);
            let [o_x, o_y, o_z] = __kahan::components(other);
            let c_1_2 = __kahan::ratio::<T>(1, 2);
            __kahan::vector([
                -((s_x.clone() * o_z.clone() + s_z.clone() * o_x.clone())
                    * c_1_2.clone()),
                -(c_1_2.clone()
                    * (o_z.clone() * s_y.clone() + s_z.clone() * o_y.clone())),
                s_x.clone() * o_x.clone() + s_y.clone() * o_y.clone(),
            ])
        }
    }
    fn reduced<T: __kahan::Scalar>(
        system: &E3,
        state: &__kahan::SVector<T, 3>,
        half_step: &T,
    ) -> (__kahan::SVector<T, 3>, T) {
        let [s_x, s_y, s_z] = __kahan::components(state);
        let sum_1 = s_x.clone() * s_x.clone() + s_y.clone() * s_y.clone();
        let sum_2 = s_z.clone() + sum_1.clone() * half_step.clone();
        (
            __kahan::vector([
                -(s_x.clone() * sum_2.clone()),
                -(s_y.clone() * sum_2.clone()),
                sum_1.clone() - half_step.clone() * (sum_1.clone() * s_z.clone()),
            ]),
            __kahan::integer::<T>(1)
                + half_step.clone()
                    * (s_z.clone()
                        + half_step.clone() * (sum_1.clone() * __kahan::integer::<T>(2))),
        )
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 3> for E3 {
        fn increment(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: &T,
        ) -> __kahan::Option<__kahan::SVector<T, 3>> {
            let (numerators, denominator) = reduced(self, state, half_step);
            __kahan::increment_from_quotient(numerators, denominator, half_step)
        }
        fn jacobian(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: T,
        ) -> __kahan::SMatrix<T, 3, 3> {
            let lifted = E3;
            __kahan::jacobian_of_reduced(
                |state, half_step| {
                    let (numerators, denominator) = reduced(&lifted, state, half_step);
                    __kahan::increment_from_quotient(numerators, denominator, half_step)
                },
                state,
                &half_step,
            )
        }
        fn det_matrix(&self, state: &__kahan::SVector<T, 3>, half_step: T) -> T {
            let [s_x, s_y, s_z] = __kahan::components(state);
            let c_2 = __kahan::integer::<T>(2);
            let product_1 = (s_x.clone() * s_x.clone() + s_y.clone() * s_y.clone())
                * c_2.clone();
            __kahan::integer::<T>(1)
                + half_step.clone()
                    * (c_2.clone() * s_z.clone()
                        + half_step.clone()
                            * (product_1.clone()
                                + s_z.clone()
                                    * (s_z.clone() + product_1.clone() * half_step.clone())))
        }
        fn rational_map(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: T,
        ) -> (__kahan::SVector<T, 3>, T) {
            let [s_x, s_y, s_z] = __kahan::components(state);
            let c_1 = __kahan::integer::<T>(1);
            let t_z_z = s_z.clone() * s_z.clone();
            let sum_1 = c_1.clone()
                - half_step.clone() * (t_z_z.clone() * half_step.clone());
            let c_2 = __kahan::integer::<T>(2);
            let t_x_x = s_x.clone() * s_x.clone();
            let t_y_y = s_y.clone() * s_y.clone();
            let product_2 = s_z.clone() * c_2.clone();
            let product_3 = c_2.clone() * (t_x_x.clone() + t_y_y.clone());
            (
                __kahan::vector([
                    sum_1.clone() * s_x.clone(),
                    sum_1.clone() * s_y.clone(),
                    s_z.clone()
                        + half_step.clone()
                            * (product_3.clone()
                                + s_z.clone()
                                    * (product_2.clone()
                                        + half_step.clone()
                                            * (c_2.clone() * t_x_x.clone() + c_2.clone() * t_y_y.clone()
                                                + t_z_z.clone()))),
                ]),
                c_1.clone()
                    + half_step.clone()
                        * (product_2.clone()
                            + half_step.clone()
                                * (product_3.clone()
                                    + s_z.clone()
                                        * (s_z.clone() + half_step.clone() * product_3.clone()))),
            )
        }
    }
    impl E3 {
        /// The names of the integrals, in order.
        pub const INTEGRALS: [&'static __kahan::core::primitive::str; 2] = ["H", "K"];
    }
    impl E3 {
        /// The integrals of motion of the map at `state`; `half_step` is ε, half the time step.
        ///
        /// In order:
        ///
        /// ```text
        /// H = y/x
        /// K = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2))
        /// ```
        ///
        /// Where a divisor is zero, floats are not finite and exact scalars panic.
        pub fn integrals<T: __kahan::Scalar>(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: T,
        ) -> __kahan::SVector<T, 2> {
            let [s_x, s_y, s_z] = __kahan::components(state);
            let sum_1 = s_x.clone() * s_x.clone() + s_y.clone() * s_y.clone();
            __kahan::vector([
                s_y.clone() / s_x.clone(),
                __kahan::ratio::<T>(1, 2) * (sum_1.clone() + s_z.clone() * s_z.clone())
                    / (__kahan::integer::<T>(1)
                        + sum_1.clone() * (half_step.clone() * half_step.clone())),
            ])
        }
    }
    impl<T: __kahan::Scalar> __kahan::Integrals<T, 3, 2> for E3 {
        fn integral_names(&self) -> &'static [&'static __kahan::core::primitive::str] {
            &Self::INTEGRALS
        }
        fn integrals(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: T,
        ) -> __kahan::SVector<T, 2> {
            Self::integrals(self, state, half_step)
        }
    }
    impl E3 {
        /// The density ρ of an invariant measure ρ dx: ρ(x̃) det ∂x̃/∂x = ρ(x); `half_step` is ε, half the time step.
        ///
        /// Namely
        ///
        /// ```text
        /// rho = 2/(x*y*(x^2 + y^2 + z^2))
        /// ```
        pub fn density<T: __kahan::Scalar>(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: T,
        ) -> T {
            let [s_x, s_y, s_z] = __kahan::components(state);
            __kahan::integer::<T>(2)
                / ((s_x.clone() * s_x.clone() + s_y.clone() * s_y.clone()
                    + s_z.clone() * s_z.clone()) * (s_y.clone() * s_x.clone()))
        }
    }
    impl E3 {
        /// An invariant Poisson tensor P: J P(x) Jᵀ = P(x̃) with J = ∂x̃/∂x; `half_step` is ε, half the time step.
        ///
        /// Its entries, those not given being zero:
        ///
        /// ```text
        /// {y,z} = y*(1 + eps^2*(x^2 + y^2))
        /// {z,x} = -x*(1 + eps^2*(x^2 + y^2))
        /// ```
        pub fn bracket_P<T: __kahan::Scalar>(
            &self,
            state: &__kahan::SVector<T, 3>,
            half_step: T,
        ) -> __kahan::SMatrix<T, 3, 3> {
            let [s_x, s_y, _] = __kahan::components(state);
            let sum_1 = __kahan::integer::<T>(1)
                + (s_x.clone() * s_x.clone() + s_y.clone() * s_y.clone())
                    * (half_step.clone() * half_step.clone());
            let p_0_1 = __kahan::integer::<T>(0);
            let p_0_2 = s_x.clone() * sum_1.clone();
            let p_1_2 = s_y.clone() * sum_1.clone();
            __kahan::matrix([
                [__kahan::integer::<T>(0), p_0_1.clone(), p_0_2.clone()],
                [-p_0_1.clone(), __kahan::integer::<T>(0), p_1_2.clone()],
                [-p_0_2.clone(), -p_1_2.clone(), __kahan::integer::<T>(0)],
            ])
        }
    }
};
