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
/// The map, over its common denominator in lowest terms:
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
    use ::kahan_core::__private::{self as __kahan, arguments::*, Clone as _};
    impl E3 {
        /// The state variables, in order.
        pub const VARIABLES: [&'static __kahan::str; 3] = ["x", "y", "z"];
        /// The parameters, in order.
        pub const PARAMETERS: [&'static __kahan::str; 0] = [];
        /// The names of the integrals, in order.
        pub const INTEGRALS: [&'static __kahan::str; 2] = ["H", "K"];
        /// The integrals of motion of the map at `x`; `eps` is ε, half the time step.
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
            x: &__kahan::SVector<T, 3>,
            eps: T,
        ) -> __kahan::SVector<T, 2> {
            let [__s_x, __s_y, __s_z] = __kahan::components(x);
            let __t_x_squared_plus_y_squared = __s_x.clone() * __s_x.clone()
                + __s_y.clone() * __s_y.clone();
            __kahan::vector([
                __s_y.clone() / __s_x.clone(),
                __kahan::ratio::<T>(1, 2)
                    * (__t_x_squared_plus_y_squared.clone()
                        + __s_z.clone() * __s_z.clone())
                    / (__kahan::integer::<T>(1)
                        + __t_x_squared_plus_y_squared * (eps.clone() * eps.clone())),
            ])
        }
        /// The integral `H = y/x`, constant along orbits; `eps` is ε, half the time step.
        pub fn H<T: __kahan::Scalar>(&self, x: &__kahan::SVector<T, 3>, eps: T) -> T {
            self.integrals(x, eps)[0].clone()
        }
        /// The integral `K = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2))`, constant along orbits; `eps` is ε, half the time step.
        pub fn K<T: __kahan::Scalar>(&self, x: &__kahan::SVector<T, 3>, eps: T) -> T {
            self.integrals(x, eps)[1].clone()
        }
        /// The density ρ of an invariant measure ρ dx: ρ(x̃) det ∂x̃/∂x = ρ(x); `eps` is ε, half the time step.
        ///
        /// Namely
        ///
        /// ```text
        /// rho = 2/(x*y*(x^2 + y^2 + z^2))
        /// ```
        pub fn density<T: __kahan::Scalar>(
            &self,
            x: &__kahan::SVector<T, 3>,
            eps: T,
        ) -> T {
            let [__s_x, __s_y, __s_z] = __kahan::components(x);
            __kahan::integer::<T>(2)
                / ((__s_x.clone() * __s_x.clone() + __s_y.clone() * __s_y.clone()
                    + __s_z.clone() * __s_z.clone()) * (__s_y.clone() * __s_x.clone()))
        }
        /// An invariant Poisson tensor P: J P(x) Jᵀ = P(x̃) with J = ∂x̃/∂x; `eps` is ε, half the time step.
        ///
        /// Its entries, those not given being zero:
        ///
        /// ```text
        /// {y,z} = y*(1 + eps^2*(x^2 + y^2))
        /// {z,x} = -x*(1 + eps^2*(x^2 + y^2))
        /// ```
        pub fn bracket_P<T: __kahan::Scalar>(
            &self,
            x: &__kahan::SVector<T, 3>,
            eps: T,
        ) -> __kahan::SMatrix<T, 3, 3> {
            let [__s_x, __s_y, _] = __kahan::components(x);
            let __sum_1 = __kahan::integer::<T>(1)
                + (__s_x.clone() * __s_x.clone() + __s_y.clone() * __s_y.clone())
                    * (eps.clone() * eps.clone());
            __kahan::antisymmetric([
                __kahan::integer::<T>(0),
                __s_x.clone() * __sum_1.clone(),
                __s_y.clone() * __sum_1,
            ])
        }
    }
    impl E3 {
        /// Where `x` stands in a point: `x[E3::X]`.
        pub const X: __kahan::usize = 0;
        /// Where `y` stands in a point: `x[E3::Y]`.
        pub const Y: __kahan::usize = 1;
        /// Where `z` stands in a point: `x[E3::Z]`.
        pub const Z: __kahan::usize = 2;
    }
    impl __kahan::Named for E3 {
        fn variables(&self) -> &'static [&'static __kahan::str] {
            &Self::VARIABLES
        }
    }
    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 3> for E3 {
        fn field(&self, x: &__kahan::SVector<T, 3>) -> __kahan::SVector<T, 3> {
            let [__s_x, __s_y, __s_z] = __kahan::components(x);
            __kahan::vector([
                -(__s_x.clone() * __s_z.clone()),
                -(__s_z.clone() * __s_y.clone()),
                __s_x.clone() * __s_x.clone() + __s_y.clone() * __s_y.clone(),
            ])
        }
        fn field_jacobian(
            &self,
            x: &__kahan::SVector<T, 3>,
        ) -> __kahan::SMatrix<T, 3, 3> {
            let [__s_x, __s_y, __s_z] = __kahan::components(x);
            let __t_minus_z = -__s_z.clone();
            let __c_0 = __kahan::integer::<T>(0);
            let __c_2 = __kahan::integer::<T>(2);
            __kahan::matrix([
                [__t_minus_z.clone(), __c_0.clone(), -__s_x.clone()],
                [__c_0.clone(), __t_minus_z, -__s_y.clone()],
                [__s_x.clone() * __c_2.clone(), __s_y.clone() * __c_2, __c_0],
            ])
        }
        fn bilinear(
            &self,
            x: &__kahan::SVector<T, 3>,
            y: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            let [__s_x, __s_y, __s_z] = __kahan::components(x);
            let [__o_x, __o_y, __o_z] = __kahan::components(y);
            let __c_1_2 = __kahan::ratio::<T>(1, 2);
            __kahan::vector([
                -((__s_x.clone() * __o_z.clone() + __s_z.clone() * __o_x.clone())
                    * __c_1_2.clone()),
                -(__c_1_2
                    * (__o_z.clone() * __s_y.clone() + __s_z.clone() * __o_y.clone())),
                __s_x.clone() * __o_x.clone() + __s_y.clone() * __o_y.clone(),
            ])
        }
        fn polarized(
            &self,
            x: &__kahan::SVector<T, 3>,
            y: &__kahan::SVector<T, 3>,
        ) -> __kahan::SVector<T, 3> {
            __kahan::QuadraticField::bilinear(self, x, y)
        }
    }
    pub struct __Step;
    impl __kahan::Kernel<3, 2> for __Step {
        const COST: __kahan::StepCost = __kahan::StepCost::of(19, 1, 31);
        #[inline(always)]
        fn quotients<T: __kahan::Scalar>(
            __constants: &[__kahan::Padded<T>; 2],
            __state: [T; 3],
        ) -> __kahan::Option<__kahan::Quotients<T, 3>> {
            let [__e_one_over_eps, __e_half_over_eps] = __constants;
            let [__s_x, __s_y, __s_z] = __state;
            let __t_x_squared_plus_y_squared = __kahan::fenced(
                __s_x.clone() * __s_x.clone() + __s_y.clone() * __s_y.clone(),
            );
            let __reciprocal_1 = __kahan::fenced(
                __kahan::integer::<T>(-1)
                    .quotient(
                        (__e_one_over_eps.get() + __s_z.clone())
                            * __e_half_over_eps.get()
                            + __t_x_squared_plus_y_squared.clone(),
                    )?,
            );
            let __sum_1 = __kahan::fenced(
                __s_z
                    .clone()
                    .multiply_add(
                        __e_one_over_eps.get(),
                        __t_x_squared_plus_y_squared.clone(),
                    ),
            );
            __kahan::Some(
                __kahan::Quotients::over(
                    [
                        __s_x * __sum_1.clone(),
                        __s_y * __sum_1,
                        __t_x_squared_plus_y_squared * (__s_z - __e_one_over_eps.get()),
                    ],
                    __reciprocal_1,
                ),
            )
        }
    }
    pub struct __General;
    impl __kahan::Kernel<3, 2> for __General {
        const COST: __kahan::StepCost = __kahan::StepCost::of(26, 1, 35);
        #[inline(always)]
        fn quotients<T: __kahan::Scalar>(
            __constants: &[__kahan::Padded<T>; 2],
            __state: [T; 3],
        ) -> __kahan::Option<__kahan::Quotients<T, 3>> {
            let [__e_eps, __e_two_eps] = __constants;
            let [__s_x, __s_y, __s_z] = __state;
            let __t_eps_z = __kahan::fenced(__e_eps.get() * __s_z.clone());
            let __t_eps_x = __kahan::fenced(__e_eps.get() * __s_x.clone());
            let __t_eps_y = __kahan::fenced(__e_eps.get() * __s_y.clone());
            let __c_1 = __kahan::fenced(__kahan::integer::<T>(1));
            let __reciprocal_1 = __kahan::fenced(
                __kahan::integer::<T>(-2)
                    .quotient(
                        __e_two_eps.get() * __s_y.clone() * __t_eps_y.clone()
                            + (__e_two_eps.get() * __s_x.clone())
                                .multiply_add(
                                    __t_eps_x.clone(),
                                    __c_1.clone() + __t_eps_z.clone(),
                                ),
                    )?,
            );
            let __t_x_eps_x = __kahan::fenced(__s_x * __t_eps_x.clone());
            let __t_y_eps_y = __kahan::fenced(__s_y * __t_eps_y.clone());
            let __sum_1 = __kahan::fenced(
                __t_y_eps_y.clone() + (__s_z + __t_x_eps_x.clone()),
            );
            __kahan::Some(
                __kahan::Quotients::over(
                    [
                        __t_eps_x * __sum_1.clone(),
                        __t_eps_y * __sum_1,
                        (__t_eps_z - __c_1) * (__t_x_eps_x + __t_y_eps_y),
                    ],
                    __reciprocal_1,
                ),
            )
        }
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 3> for E3 {
        type Prepared = __kahan::StepOverEps<__Step, __General, T, 2, 2>;
        #[inline(always)]
        fn prepare(&self, eps: &T) -> Self::Prepared {
            Self::Prepared::new(
                eps,
                || [
                    __kahan::integer::<T>(1) / eps.clone(),
                    __kahan::ratio::<T>(1, 2) / eps.clone(),
                ],
                || [eps.clone(), eps.clone() * __kahan::integer::<T>(2)],
            )
        }
        fn jacobian(
            &self,
            x: &__kahan::SVector<T, 3>,
            eps: T,
        ) -> __kahan::SMatrix<T, 3, 3> {
            __kahan::jacobian_by_duals(self, x, &eps)
        }
        #[inline(always)]
        fn try_prepared(
            &self,
            prepared: &Self::Prepared,
            x: &__kahan::SVector<T, 3>,
            eps: &T,
        ) -> __kahan::Result<__kahan::SVector<T, 3>, __kahan::SingularStep>
        where
            T: __kahan::Pivot,
        {
            __kahan::stable_step(self, prepared, x, eps)
        }
        fn det_matrix(&self, x: &__kahan::SVector<T, 3>, eps: T) -> T {
            let [__s_x, __s_y, __s_z] = __kahan::components(x);
            let __c_2 = __kahan::integer::<T>(2);
            let __product_1 = (__s_x.clone() * __s_x.clone()
                + __s_y.clone() * __s_y.clone()) * __c_2.clone();
            __kahan::integer::<T>(1)
                + eps.clone()
                    * (__c_2 * __s_z.clone()
                        + eps.clone()
                            * (__product_1.clone()
                                + __s_z.clone()
                                    * (__s_z.clone() + __product_1 * eps.clone())))
        }
        fn rational_map(
            &self,
            x: &__kahan::SVector<T, 3>,
            eps: T,
        ) -> (__kahan::SVector<T, 3>, T) {
            let [__s_x, __s_y, __s_z] = __kahan::components(x);
            let __c_1 = __kahan::integer::<T>(1);
            let __t_z_squared = __s_z.clone() * __s_z.clone();
            let __sum_1 = __c_1.clone()
                - eps.clone() * (__t_z_squared.clone() * eps.clone());
            let __c_2 = __kahan::integer::<T>(2);
            let __t_x_squared = __s_x.clone() * __s_x.clone();
            let __t_y_squared = __s_y.clone() * __s_y.clone();
            let __t_two_z = __s_z.clone() * __c_2.clone();
            let __product_1 = __c_2.clone()
                * (__t_x_squared.clone() + __t_y_squared.clone());
            (
                __kahan::vector([
                    __sum_1.clone() * __s_x.clone(),
                    __sum_1 * __s_y.clone(),
                    __s_z.clone()
                        + eps.clone()
                            * (__product_1.clone()
                                + __s_z.clone()
                                    * (__t_two_z.clone()
                                        + eps.clone()
                                            * (__c_2.clone() * __t_x_squared + __c_2 * __t_y_squared
                                                + __t_z_squared))),
                ]),
                __c_1
                    + eps.clone()
                        * (__t_two_z
                            + eps.clone()
                                * (__product_1.clone()
                                    + __s_z.clone()
                                        * (__s_z.clone() + eps.clone() * __product_1))),
            )
        }
        fn reduced_map(
            &self,
            x: &__kahan::SVector<T, 3>,
            eps: T,
        ) -> (__kahan::SVector<T, 3>, T) {
            let [__s_x, __s_y, __s_z] = __kahan::components(x);
            let __c_1 = __kahan::integer::<T>(1);
            let __t_one_minus_z_eps = __c_1.clone() - __s_z.clone() * eps.clone();
            let __c_2 = __kahan::integer::<T>(2);
            let __t_x_squared = __s_x.clone() * __s_x.clone();
            let __t_y_squared = __s_y.clone() * __s_y.clone();
            (
                __kahan::vector([
                    __t_one_minus_z_eps.clone() * __s_x.clone(),
                    __t_one_minus_z_eps * __s_y.clone(),
                    __s_z.clone()
                        + eps.clone()
                            * (__c_2.clone() * __t_x_squared.clone()
                                + __c_2.clone() * __t_y_squared.clone()
                                + __s_z.clone() * __s_z.clone()),
                ]),
                __c_1
                    + eps.clone()
                        * (__s_z.clone()
                            + eps.clone() * (__c_2 * (__t_x_squared + __t_y_squared))),
            )
        }
    }
    impl<T: __kahan::Scalar> __kahan::ExtendScalars<T, 3> for E3 {
        type Extended<U: __kahan::Scalar> = E3;
        #[inline(always)]
        fn extend_scalars<U: __kahan::Scalar>(
            &self,
            convert: impl __kahan::Fn(&T) -> U,
        ) -> E3 {
            __kahan::Clone::clone(self)
        }
    }
    impl<T: __kahan::Scalar> __kahan::Integrals<T, 3, 2> for E3 {
        fn integral_names(&self) -> &'static [&'static __kahan::str] {
            &Self::INTEGRALS
        }
        fn integrals(
            &self,
            x: &__kahan::SVector<T, 3>,
            eps: T,
        ) -> __kahan::SVector<T, 2> {
            Self::integrals(self, x, eps)
        }
    }
};
