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
    use ::kahan_core::__private as __kahan;
    use __kahan::Clone as _;
    fn x() {}
    fn y() {}
    fn eps() {}
    fn prepared() {}
    fn lift() {}
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
    }
    #[::core::prelude::v1::derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct __Step<T> {
        one_over_eps: __kahan::Apart<T>,
        half_over_eps: __kahan::Apart<T>,
        __general: __General<T>,
        __is_inverse: __kahan::core::primitive::bool,
    }
    impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 3> for __Step<T> {
        const COST: __kahan::StepCost = __kahan::StepCost {
            operations: 19,
            divisions: 1,
            chain: 31,
        };
        const HAS_INVERSE_STEP: __kahan::core::primitive::bool = true;
        #[inline(always)]
        fn quotients(
            &self,
            x: &__kahan::SVector<T, 3>,
        ) -> __kahan::Option<__kahan::Quotients<T, 3>> {
            if !T::HAS_INVERSE_STEPS || !(T::CALLS_GENERAL_STEP || self.__is_inverse) {
                return self.__general.quotients(x);
            }
            if !self.__is_inverse {
                let x = __kahan::vector(__kahan::components(x).clone());
                let [__increment_1, __increment_2, __increment_3] = __kahan::general_increment(
                    &self.__general,
                    x,
                );
                return __kahan::Option::Some(__kahan::Quotients {
                    numerators: [__increment_1, __increment_2, __increment_3],
                    reciprocals: [
                        __kahan::Option::Some(__kahan::integer::<T>(1)),
                        __kahan::Option::Some(__kahan::integer::<T>(1)),
                        __kahan::Option::Some(__kahan::integer::<T>(1)),
                    ],
                });
            }
            let [__s_x, __s_y, __s_z] = __kahan::components(x).clone();
            let __t_x_squared_plus_y_squared = (__s_x.clone() * __s_x.clone()
                + __s_y.clone() * __s_y.clone())
                .alone();
            let __reciprocal_1 = (__kahan::integer::<T>(-1)
                .quotient(
                    (self.one_over_eps.0.clone() + __s_z.clone())
                        * self.half_over_eps.0.clone()
                        + __t_x_squared_plus_y_squared.clone(),
                )?)
                .alone();
            let __sum_1 = (__s_z
                .clone()
                .multiply_add(
                    self.one_over_eps.0.clone(),
                    __t_x_squared_plus_y_squared.clone(),
                ))
                .alone();
            __kahan::Option::Some(__kahan::Quotients {
                numerators: [
                    __s_x * __sum_1.clone(),
                    __s_y * __sum_1,
                    __t_x_squared_plus_y_squared * (__s_z - self.one_over_eps.0.clone()),
                ],
                reciprocals: [
                    __kahan::Option::Some(__reciprocal_1.clone()),
                    __kahan::Option::Some(__reciprocal_1.clone()),
                    __kahan::Option::Some(__reciprocal_1),
                ],
            })
        }
    }
    #[::core::prelude::v1::derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct __General<T> {
        eps: __kahan::Apart<T>,
        two_eps: __kahan::Apart<T>,
    }
    impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 3> for __General<T> {
        const COST: __kahan::StepCost = __kahan::StepCost {
            operations: 26,
            divisions: 1,
            chain: 35,
        };
        #[inline(always)]
        fn quotients(
            &self,
            x: &__kahan::SVector<T, 3>,
        ) -> __kahan::Option<__kahan::Quotients<T, 3>> {
            let [__s_x, __s_y, __s_z] = __kahan::components(x).clone();
            let __t_eps_z = (self.eps.0.clone() * __s_z.clone()).alone();
            let __t_eps_x = (self.eps.0.clone() * __s_x.clone()).alone();
            let __t_eps_y = (self.eps.0.clone() * __s_y.clone()).alone();
            let __c_1 = (__kahan::integer::<T>(1)).alone();
            let __reciprocal_1 = (__kahan::integer::<T>(-2)
                .quotient(
                    (__t_eps_y.clone() + __t_eps_y.clone()) * __t_eps_y.clone()
                        + (self.two_eps.0.clone() * __s_x.clone())
                            .multiply_add(
                                __t_eps_x.clone(),
                                __c_1.clone() + __t_eps_z.clone(),
                            ),
                )?)
                .alone();
            let __t_x_eps_x = (__s_x * __t_eps_x.clone()).alone();
            let __t_y_eps_y = (__s_y * __t_eps_y.clone()).alone();
            let __sum_1 = (__t_y_eps_y.clone() + (__s_z + __t_x_eps_x.clone())).alone();
            __kahan::Option::Some(__kahan::Quotients {
                numerators: [
                    __t_eps_x * __sum_1.clone(),
                    __t_eps_y * __sum_1,
                    (__t_eps_z - __c_1) * (__t_x_eps_x + __t_y_eps_y),
                ],
                reciprocals: [
                    __kahan::Option::Some(__reciprocal_1.clone()),
                    __kahan::Option::Some(__reciprocal_1.clone()),
                    __kahan::Option::Some(__reciprocal_1),
                ],
            })
        }
    }
    impl<T: __kahan::Scalar> __kahan::WideStep<T, 3> for __Step<T> {
        const HAS_LANES: __kahan::core::primitive::bool = true;
        type Wide<__L: __kahan::Scalar> = __General<__L>;
        #[inline(always)]
        fn widen<__L: __kahan::Scalar>(
            &self,
            __spread: impl __kahan::core::ops::Fn(&T) -> __L,
        ) -> __General<__L> {
            __General {
                eps: __kahan::Apart::new(__spread(&self.__general.eps.0)),
                two_eps: __kahan::Apart::new(__spread(&self.__general.two_eps.0)),
            }
        }
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 3> for E3 {
        type Prepared = __Step<T>;
        #[inline(always)]
        fn prepare(&self, eps: &T) -> __Step<T> {
            let __general = {
                __General {
                    eps: __kahan::Apart::new(eps.clone()),
                    two_eps: __kahan::Apart::new(eps.clone() * __kahan::integer::<T>(2)),
                }
            };
            let (__is_inverse, __divisor) = __kahan::divisor(eps);
            let eps = &__divisor;
            __Step {
                one_over_eps: __kahan::Apart::new(
                    __kahan::integer::<T>(1).over_eps(eps),
                ),
                half_over_eps: __kahan::Apart::new(
                    __kahan::ratio::<T>(1, 2).over_eps(eps),
                ),
                __general,
                __is_inverse,
            }
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
        ) -> __kahan::core::result::Result<__kahan::SVector<T, 3>, __kahan::SingularStep>
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
    impl<T: __kahan::Scalar> __kahan::Lift<T, 3> for E3 {
        type Lifted<U: __kahan::Scalar> = E3;
        #[inline(always)]
        fn lift<U: __kahan::Scalar>(
            &self,
            lift: impl __kahan::core::ops::Fn(&T) -> U,
        ) -> E3 {
            __kahan::Clone::clone(self)
        }
    }
    impl E3 {
        /// The names of the integrals, in order.
        pub const INTEGRALS: [&'static __kahan::core::primitive::str; 2] = ["H", "K"];
    }
    impl E3 {
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
    }
    impl<T: __kahan::Scalar> __kahan::Integrals<T, 3, 2> for E3 {
        fn integral_names(&self) -> &'static [&'static __kahan::core::primitive::str] {
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
    impl E3 {
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
    }
    impl E3 {
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
            let __p_0_1 = __kahan::integer::<T>(0);
            let __p_0_2 = __s_x.clone() * __sum_1.clone();
            let __p_1_2 = __s_y.clone() * __sum_1;
            __kahan::matrix([
                [__kahan::integer::<T>(0), __p_0_1.clone(), __p_0_2.clone()],
                [-__p_0_1.clone(), __kahan::integer::<T>(0), __p_1_2.clone()],
                [-__p_0_2.clone(), -__p_1_2.clone(), __kahan::integer::<T>(0)],
            ])
        }
    }
};
