/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the field
///
/// ```text
/// xdot = y
/// ydot = (x*y - 981/100*mu*x + 981/100*nu*x + nu*x*y - 1/10*mu^2*y + 1/10*mu*nu*y
///     - 1/10*mu^2*nu*y + 1/10*mu*nu^2*y)/(mu - nu + mu*nu - nu^2)
/// ```
///
/// Matrix A(x,ε) = I − ε f′(x), row by row:
///
/// ```text
/// [ 1, -eps ]
/// [ (-eps*y + 981/100*eps*mu - 981/100*eps*nu - eps*nu*y)/(mu - nu + mu*nu - nu^2), (mu - nu
///     - eps*x + mu*nu - nu^2 - eps*nu*x + 1/10*eps*mu^2 - 1/10*eps*mu*nu + 1/10*eps*mu^2*nu
///     - 1/10*eps*mu*nu^2)/(mu - nu + mu*nu - nu^2) ]
/// ```
///
/// The map, over its common denominator in lowest terms:
///
/// ```text
/// x~ = x + 2*eps*(mu*y - nu*y - 981/100*eps*mu*x + 981/100*eps*nu*x + mu*nu*y - nu^2*y)/(mu
///     - nu - eps*x + mu*nu - nu^2 - eps*nu*x - eps^2*y + 1/10*eps*mu^2 - 1/10*eps*mu*nu
///     + 981/100*eps^2*mu - 981/100*eps^2*nu - eps^2*nu*y + 1/10*eps*mu^2*nu - 1/10*eps*mu*nu^2)
/// y~ = y + 2*eps*(x*y - 981/100*mu*x + 981/100*nu*x + nu*x*y + eps*y^2 - 1/10*mu^2*y
///     + 1/10*mu*nu*y - 981/100*eps*mu*y + 981/100*eps*nu*y + eps*nu*y^2 - 1/10*mu^2*nu*y
///     + 1/10*mu*nu^2*y)/(mu - nu - eps*x + mu*nu - nu^2 - eps*nu*x - eps^2*y + 1/10*eps*mu^2
///     - 1/10*eps*mu*nu + 981/100*eps^2*mu - 981/100*eps^2*nu - eps^2*nu*y + 1/10*eps*mu^2*nu
///     - 1/10*eps*mu*nu^2)
/// ```
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub(crate) struct Pendulum<T> {
    /// The damping.
    pub mu: T,
    /// The parameter `nu`.
    pub nu: T,
}
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
    impl<T> Pendulum<T> {
        /// The state variables, in order.
        pub const VARIABLES: [&'static __kahan::core::primitive::str; 2] = ["x", "y"];
        /// The parameters, in order.
        pub const PARAMETERS: [&'static __kahan::core::primitive::str; 2] = ["mu", "nu"];
    }
    impl<T> __kahan::Named for Pendulum<T> {
        fn variables(&self) -> &'static [&'static __kahan::core::primitive::str] {
            &Self::VARIABLES
        }
        fn parameters(&self) -> &'static [&'static __kahan::core::primitive::str] {
            &Self::PARAMETERS
        }
    }
    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 2> for Pendulum<T> {
        fn field(&self, x: &__kahan::SVector<T, 2>) -> __kahan::SVector<T, 2> {
            let [__s_x, __s_y] = __kahan::components(x);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __t_mu_minus_nu = __p_mu.clone() - __p_nu.clone();
            let __t_mu_minus_nu_minus_one = __t_mu_minus_nu.clone()
                - __kahan::integer::<T>(1);
            let __c_10 = __kahan::integer::<T>(10);
            let __t_ten_x = __c_10.clone() * __s_x.clone();
            __kahan::vector([
                __s_y.clone(),
                -((__s_x.clone() * (__t_mu_minus_nu * __kahan::integer::<T>(981))
                    + __s_y.clone()
                        * (__c_10
                            * (__p_mu.clone() * __p_mu.clone() - __t_ten_x.clone()
                                + __p_nu.clone()
                                    * (__p_mu.clone() * __t_mu_minus_nu_minus_one.clone()
                                        - __t_ten_x)))) * __kahan::ratio::<T>(1, 100)
                    / (__p_mu.clone() + __p_nu.clone() * __t_mu_minus_nu_minus_one)),
            ])
        }
        fn field_jacobian(
            &self,
            x: &__kahan::SVector<T, 2>,
        ) -> __kahan::SMatrix<T, 2, 2> {
            let [__s_x, __s_y] = __kahan::components(x);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __c_1 = __kahan::integer::<T>(1);
            let __t_n100_y = __kahan::integer::<T>(100) * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __t_mu_minus_nu_minus_one = __p_mu.clone() - __p_nu.clone()
                - __c_1.clone();
            let __sum_1 = __p_mu.clone()
                + __p_nu.clone() * __t_mu_minus_nu_minus_one.clone();
            let __t_ten_x = __kahan::integer::<T>(10) * __s_x.clone();
            __kahan::matrix([
                [__kahan::integer::<T>(0), __c_1],
                [
                    (__t_n100_y.clone() - __c_981.clone() * __p_mu.clone()
                        + (__t_n100_y + __c_981) * __p_nu.clone())
                        * __kahan::ratio::<T>(1, 100) / __sum_1.clone(),
                    -((__p_mu.clone() * __p_mu.clone() - __t_ten_x.clone()
                        + __p_nu.clone()
                            * (__p_mu.clone() * __t_mu_minus_nu_minus_one - __t_ten_x))
                        * __kahan::ratio::<T>(1, 10) / __sum_1),
                ],
            ])
        }
        fn bilinear(
            &self,
            x: &__kahan::SVector<T, 2>,
            y: &__kahan::SVector<T, 2>,
        ) -> __kahan::SVector<T, 2> {
            let [__s_x, __s_y] = __kahan::components(x);
            let [__o_x, __o_y] = __kahan::components(y);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __c_1 = __kahan::integer::<T>(1);
            let __t_nu_plus_one = __p_nu.clone() + __c_1.clone();
            __kahan::vector([
                __kahan::integer::<T>(0),
                (__t_nu_plus_one.clone() * (__s_y.clone() * __o_x.clone())
                    + __t_nu_plus_one * __s_x.clone() * __o_y.clone())
                    * __kahan::ratio::<T>(1, 2)
                    / (__p_mu.clone()
                        + __p_nu.clone() * (__p_mu.clone() - __p_nu.clone() - __c_1)),
            ])
        }
        fn polarized(
            &self,
            x: &__kahan::SVector<T, 2>,
            y: &__kahan::SVector<T, 2>,
        ) -> __kahan::SVector<T, 2> {
            let [__s_x, __s_y] = __kahan::components(x);
            let [__o_x, __o_y] = __kahan::components(y);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __t_y_plus_y_second = __s_y.clone() + __o_y.clone();
            let __t_mu_minus_nu_minus_one = __p_mu.clone() - __p_nu.clone()
                - __kahan::integer::<T>(1);
            let __c_10 = __kahan::integer::<T>(10);
            let __c_100 = __kahan::integer::<T>(100);
            let __c_981 = __kahan::integer::<T>(981);
            __kahan::vector([
                __t_y_plus_y_second.clone() * __kahan::ratio::<T>(1, 2),
                -((__p_mu.clone()
                    * (__c_981.clone() * (__s_x.clone() + __o_x.clone())
                        + __p_mu.clone() * (__t_y_plus_y_second * __c_10.clone()))
                    - __c_100.clone()
                        * (__o_y.clone() * __s_x.clone() + __s_y.clone() * __o_x.clone())
                    + __p_nu.clone()
                        * (__p_mu.clone()
                            * ((__s_y.clone() * __t_mu_minus_nu_minus_one.clone()
                                + __o_y.clone() * __t_mu_minus_nu_minus_one.clone())
                                * __c_10)
                            - ((__o_y.clone() * __c_100.clone() + __c_981.clone())
                                * __s_x.clone()
                                + (__s_y.clone() * __c_100 + __c_981) * __o_x.clone())))
                    * __kahan::ratio::<T>(1, 200)
                    / (__p_mu.clone() + __p_nu.clone() * __t_mu_minus_nu_minus_one)),
            ])
        }
    }
    #[::core::prelude::v1::derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct __Step<T> {
        half_plus_half_nu: __kahan::Apart<T>,
        constant_1: __kahan::Apart<T>,
        constant_2: __kahan::Apart<T>,
        eps: __kahan::Apart<T>,
        nu_plus_one: __kahan::Apart<T>,
        mu: __kahan::Apart<T>,
        nu_minus_mu: __kahan::Apart<T>,
        n981_times_mu_minus_nu: __kahan::Apart<T>,
        __general: __General<T>,
        __is_inverse: __kahan::core::primitive::bool,
    }
    impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 2> for __Step<T> {
        const COST: __kahan::StepCost = __kahan::StepCost {
            operations: 27,
            divisions: 1,
            chain: 32,
        };
        const HAS_INVERSE_STEP: __kahan::core::primitive::bool = true;
        #[inline(always)]
        fn quotients(
            &self,
            x: &__kahan::SVector<T, 2>,
        ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
            if !T::HAS_INVERSE_STEPS || !(T::CALLS_GENERAL_STEP || self.__is_inverse) {
                return self.__general.quotients(x);
            }
            if !self.__is_inverse {
                let x = __kahan::vector(__kahan::components(x).clone());
                let [__increment_1, __increment_2] = __kahan::general_increment(
                    &self.__general,
                    x,
                );
                return __kahan::Option::Some(__kahan::Quotients {
                    numerators: [__increment_1, __increment_2],
                    reciprocals: [
                        __kahan::Option::Some(__kahan::integer::<T>(1)),
                        __kahan::Option::Some(__kahan::integer::<T>(1)),
                    ],
                });
            }
            let [__s_x, __s_y] = __kahan::components(x).clone();
            let __reciprocal_1 = self
                .constant_2
                .0
                .clone()
                .subtract_product(self.half_plus_half_nu.0.clone(), __s_x.clone())
                .subtract_product(self.constant_1.0.clone(), __s_y.clone())
                .reciprocal()?;
            let __t_nu_plus_one_n100_y = self.nu_plus_one.0.clone()
                * (__s_y.clone() * __kahan::integer::<T>(100));
            let __sum_1 = __t_nu_plus_one_n100_y.clone()
                - self.n981_times_mu_minus_nu.0.clone();
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            __kahan::Option::Some(__kahan::Quotients {
                numerators: [
                    self.nu_minus_mu.0.clone()
                        * (__kahan::integer::<T>(981)
                            .multiply_subtract(
                                self.eps.0.clone() * __s_x.clone(),
                                __t_nu_plus_one_n100_y,
                            ) * __c_1_100.clone()),
                    __c_1_100
                        * (self.nu_minus_mu.0.clone()
                            * (self.mu.0.clone()
                                * (self.nu_plus_one.0.clone()
                                    * (__s_y.clone() * __kahan::integer::<T>(10))))
                            + (__s_x * __sum_1.clone()
                                + __sum_1 * (self.eps.0.clone() * __s_y))),
                ],
                reciprocals: [
                    __kahan::Option::Some(__reciprocal_1.clone()),
                    __kahan::Option::Some(__reciprocal_1),
                ],
            })
        }
    }
    #[::core::prelude::v1::derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct __General<T> {
        eps: __kahan::Apart<T>,
        nu_plus_one: __kahan::Apart<T>,
        eps_plus_eps_nu: __kahan::Apart<T>,
        constant_1: __kahan::Apart<T>,
        eps_nu_minus_eps_mu: __kahan::Apart<T>,
        constant_2: __kahan::Apart<T>,
        n981_times_mu_minus_nu: __kahan::Apart<T>,
    }
    impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 2> for __General<T> {
        const COST: __kahan::StepCost = __kahan::StepCost {
            operations: 31,
            divisions: 1,
            chain: 41,
        };
        #[inline(always)]
        fn quotients(
            &self,
            x: &__kahan::SVector<T, 2>,
        ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
            let [__s_x, __s_y] = __kahan::components(x).clone();
            let __t_eps_x = self.eps.0.clone() * __s_x;
            let __c_100 = __kahan::integer::<T>(100);
            let __t_eps_y = self.eps.0.clone() * __s_y.clone();
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            let __reciprocal_1 = __kahan::integer::<T>(2)
                .quotient(
                    self
                        .constant_1
                        .0
                        .clone()
                        .subtract_product(
                            self.nu_plus_one.0.clone(),
                            __c_100.clone() * __t_eps_x.clone(),
                        )
                        .subtract_product(
                            self.eps_plus_eps_nu.0.clone(),
                            __c_100.clone() * __t_eps_y.clone(),
                        ) * __c_1_100.clone(),
                )?;
            let __c_981 = __kahan::integer::<T>(981);
            let __t_nu_plus_one_n100_y = self.nu_plus_one.0.clone() * (__c_100 * __s_y);
            let __t_ten_eps_y = __t_eps_y.clone() * __kahan::integer::<T>(10);
            __kahan::Option::Some(__kahan::Quotients {
                numerators: [
                    __c_1_100.clone()
                        * (self.eps_nu_minus_eps_mu.0.clone()
                            * __t_eps_x
                                .clone()
                                .multiply_subtract(
                                    __c_981.clone(),
                                    __t_nu_plus_one_n100_y.clone(),
                                )),
                    __c_1_100
                        * self
                            .eps_nu_minus_eps_mu
                            .0
                            .clone()
                            .multiply_add(
                                __t_eps_y * __c_981,
                                __t_ten_eps_y
                                    .clone()
                                    .multiply_add(
                                        self
                                            .nu_plus_one
                                            .0
                                            .clone()
                                            .multiply_subtract(
                                                __t_ten_eps_y,
                                                self.constant_2.0.clone(),
                                            ),
                                        __t_eps_x
                                            * (__t_nu_plus_one_n100_y
                                                - self.n981_times_mu_minus_nu.0.clone()),
                                    ),
                            ),
                ],
                reciprocals: [
                    __kahan::Option::Some(__reciprocal_1.clone()),
                    __kahan::Option::Some(__reciprocal_1),
                ],
            })
        }
    }
    impl<T: __kahan::Scalar> __kahan::WideStep<T, 2> for __Step<T> {
        const HAS_LANES: __kahan::core::primitive::bool = true;
        type Wide<__L: __kahan::Scalar> = __General<__L>;
        #[inline(always)]
        fn widen<__L: __kahan::Scalar>(
            &self,
            __spread: impl __kahan::core::ops::Fn(&T) -> __L,
        ) -> __General<__L> {
            __General {
                eps: __kahan::Apart::new(__spread(&self.__general.eps.0)),
                nu_plus_one: __kahan::Apart::new(
                    __spread(&self.__general.nu_plus_one.0),
                ),
                eps_plus_eps_nu: __kahan::Apart::new(
                    __spread(&self.__general.eps_plus_eps_nu.0),
                ),
                constant_1: __kahan::Apart::new(__spread(&self.__general.constant_1.0)),
                eps_nu_minus_eps_mu: __kahan::Apart::new(
                    __spread(&self.__general.eps_nu_minus_eps_mu.0),
                ),
                constant_2: __kahan::Apart::new(__spread(&self.__general.constant_2.0)),
                n981_times_mu_minus_nu: __kahan::Apart::new(
                    __spread(&self.__general.n981_times_mu_minus_nu.0),
                ),
            }
        }
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Pendulum<T> {
        type Prepared = __Step<T>;
        #[inline(always)]
        fn prepare(&self, eps: &T) -> __Step<T> {
            let __general = {
                let __p_mu = &self.mu;
                let __p_nu = &self.nu;
                let __t_eps_nu = eps.clone() * __p_nu.clone();
                let __c_100 = __kahan::integer::<T>(100);
                let __t_n100_nu = __p_nu.clone() * __c_100.clone();
                let __c_10 = __kahan::integer::<T>(10);
                let __t_eps_mu = eps.clone() * __p_mu.clone();
                let __t_eps_mu_ten_nu = __t_eps_mu.clone()
                    * (__p_nu.clone() * __c_10.clone());
                let __c_981 = __kahan::integer::<T>(981);
                let __t_nu_mu = __p_nu.clone() * __p_mu.clone();
                __General {
                    eps: __kahan::Apart::new(eps.clone()),
                    nu_plus_one: __kahan::Apart::new(
                        __p_nu.clone() + __kahan::integer::<T>(1),
                    ),
                    eps_plus_eps_nu: __kahan::Apart::new(
                        eps.clone() + __t_eps_nu.clone(),
                    ),
                    constant_1: __kahan::Apart::new(
                        __c_981.clone() * (eps.clone() * __t_eps_mu.clone())
                            - __c_981.clone() * (eps.clone() * __t_eps_nu.clone())
                            - (__p_nu.clone() * __t_n100_nu.clone()
                                + __t_eps_mu_ten_nu.clone())
                            + (__p_mu.clone() * __t_eps_mu_ten_nu.clone()
                                - __p_nu.clone() * __t_eps_mu_ten_nu
                                + (__c_100 * __p_mu.clone() - __t_n100_nu.clone()
                                    + (__p_mu.clone() * __t_n100_nu
                                        + __t_eps_mu.clone() * (__p_mu.clone() * __c_10)))),
                    ),
                    eps_nu_minus_eps_mu: __kahan::Apart::new(__t_eps_nu - __t_eps_mu),
                    constant_2: __kahan::Apart::new(
                        __p_mu.clone() * __p_mu.clone() - __t_nu_mu.clone()
                            + (__p_mu.clone() * __t_nu_mu.clone()
                                - __p_nu.clone() * __t_nu_mu),
                    ),
                    n981_times_mu_minus_nu: __kahan::Apart::new(
                        __c_981 * (__p_mu.clone() - __p_nu.clone()),
                    ),
                }
            };
            let (__is_inverse, __divisor) = __kahan::divisor(eps);
            let eps = &__divisor;
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __t_n1_20_mu = __kahan::ratio::<T>(1, 20) * __p_mu.clone();
            let __t_mu_nu = __p_mu.clone() * __p_nu.clone();
            let __t_nu_squared = __p_nu.clone() * __p_nu.clone();
            let __c_1_2 = __kahan::ratio::<T>(1, 2);
            let __t_half_over_eps = __c_1_2.clone().over_eps(eps);
            let __c_981_200 = __kahan::ratio::<T>(981, 200);
            let __t_nu_eps = __p_nu.clone() * eps.clone();
            __Step {
                half_plus_half_nu: __kahan::Apart::new(
                    __c_1_2.clone() + __p_nu.clone() * __c_1_2.clone(),
                ),
                constant_1: __kahan::Apart::new(
                    __c_1_2.clone() * __t_nu_eps.clone() + __c_1_2 * eps.clone(),
                ),
                constant_2: __kahan::Apart::new(
                    __p_mu.clone() * __t_n1_20_mu.clone()
                        - __p_nu.clone() * __t_n1_20_mu.clone()
                        + (__c_981_200.clone() * (__p_mu.clone() * eps.clone())
                            + __p_mu.clone() * __t_half_over_eps.clone())
                        + (__t_n1_20_mu.clone() * __t_mu_nu.clone()
                            - __t_n1_20_mu * __t_nu_squared.clone()
                            + (__t_mu_nu * __t_half_over_eps.clone()
                                - __t_nu_squared * __t_half_over_eps.clone())
                            - (__c_981_200 * __t_nu_eps
                                + __p_nu.clone() * __t_half_over_eps)),
                ),
                eps: __kahan::Apart::new(eps.clone()),
                nu_plus_one: __kahan::Apart::new(
                    __p_nu.clone() + __kahan::integer::<T>(1),
                ),
                mu: __kahan::Apart::new(__p_mu.clone()),
                nu_minus_mu: __kahan::Apart::new(__p_nu.clone() - __p_mu.clone()),
                n981_times_mu_minus_nu: __kahan::Apart::new(
                    (__p_mu.clone() - __p_nu.clone()) * __kahan::integer::<T>(981),
                ),
                __general,
                __is_inverse,
            }
        }
        fn jacobian(
            &self,
            x: &__kahan::SVector<T, 2>,
            eps: T,
        ) -> __kahan::SMatrix<T, 2, 2> {
            __kahan::jacobian_by_duals(self, x, &eps)
        }
        #[inline(always)]
        fn try_prepared(
            &self,
            prepared: &Self::Prepared,
            x: &__kahan::SVector<T, 2>,
            eps: &T,
        ) -> __kahan::core::result::Result<__kahan::SVector<T, 2>, __kahan::SingularStep>
        where
            T: __kahan::Pivot,
        {
            __kahan::stable_step(self, prepared, x, eps)
        }
        fn det_matrix(&self, x: &__kahan::SVector<T, 2>, eps: T) -> T {
            let [__s_x, __s_y] = __kahan::components(x);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __t_mu_minus_nu_minus_one = __p_mu.clone() - __p_nu.clone()
                - __kahan::integer::<T>(1);
            let __sum_1 = __p_mu.clone()
                + __p_nu.clone() * __t_mu_minus_nu_minus_one.clone();
            let __c_10 = __kahan::integer::<T>(10);
            let __c_100 = __kahan::integer::<T>(100);
            let __t_n100_y = __c_100.clone() * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            -((eps.clone()
                * (eps.clone() * (__t_n100_y.clone() - __p_mu.clone() * __c_981.clone())
                    - __c_10.clone()
                        * (__p_mu.clone() * __p_mu.clone()
                            - __c_10.clone() * __s_x.clone())
                    + __p_nu.clone()
                        * (__c_100.clone() * __s_x.clone()
                            + (__t_n100_y + __c_981) * eps.clone()
                            - __p_mu.clone() * (__t_mu_minus_nu_minus_one * __c_10)))
                - __sum_1.clone() * __c_100) * __kahan::ratio::<T>(1, 100) / __sum_1)
        }
        fn rational_map(
            &self,
            x: &__kahan::SVector<T, 2>,
            eps: T,
        ) -> (__kahan::SVector<T, 2>, T) {
            let [__s_x, __s_y] = __kahan::components(x);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __t_mu_minus_nu = __p_mu.clone() - __p_nu.clone();
            let __t_mu_minus_nu_minus_one = __t_mu_minus_nu.clone()
                - __kahan::integer::<T>(1);
            let __sum_1 = __p_mu.clone()
                + __p_nu.clone() * __t_mu_minus_nu_minus_one.clone();
            let __c_10 = __kahan::integer::<T>(10);
            let __product_1 = __p_mu.clone()
                * (__t_mu_minus_nu_minus_one * __c_10.clone());
            let __c_100 = __kahan::integer::<T>(100);
            let __t_n100_y = __c_100.clone() * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __t_n100_x = __c_100.clone() * __s_x.clone();
            let __t_n981_mu = __p_mu.clone() * __c_981.clone();
            let __product_2 = __c_10.clone()
                * (__p_mu.clone() * __p_mu.clone() - __c_10 * __s_x.clone());
            let __product_3 = __sum_1.clone() * __c_100;
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            let __product_4 = eps.clone()
                * (eps.clone() * (__t_n100_y.clone() - __t_n981_mu.clone())
                    - __product_2.clone()
                    + __p_nu.clone()
                        * (__t_n100_x.clone()
                            + eps.clone() * (__t_n100_y.clone() + __c_981.clone())
                            - __product_1.clone()));
            (
                __kahan::vector([
                    -((eps.clone()
                        * (__s_x.clone()
                            * (eps.clone() * (__t_n100_y.clone() + __t_n981_mu)
                                - __product_2
                                + __p_nu.clone()
                                    * (__t_n100_x + (__t_n100_y - __c_981) * eps.clone()
                                        - __product_1))
                            - __s_y.clone()
                                * (__sum_1.clone() * __kahan::integer::<T>(200)))
                        - __s_x.clone() * __product_3.clone()) * __c_1_100.clone()
                        / __sum_1.clone()),
                    __c_1_100.clone()
                        * (__s_y.clone() * (__product_3.clone() + __product_4.clone())
                            - __t_mu_minus_nu * __kahan::integer::<T>(1962)
                                * (eps.clone() * __s_x.clone())) / __sum_1.clone(),
                ]),
                -(__c_1_100 * (__product_4 - __product_3) / __sum_1),
            )
        }
    }
    impl<T: __kahan::Scalar> __kahan::Lift<T, 2> for Pendulum<T> {
        type Lifted<U: __kahan::Scalar> = Pendulum<U>;
        #[inline(always)]
        fn lift<U: __kahan::Scalar>(
            &self,
            lift: impl __kahan::core::ops::Fn(&T) -> U,
        ) -> Pendulum<U> {
            Pendulum {
                mu: lift(&self.mu),
                nu: lift(&self.nu),
            }
        }
    }
    #[doc(hidden)]
    impl<T> __kahan::WithoutIntegrals for Pendulum<T> {}
    #[doc(hidden)]
    impl<T> __kahan::WithoutDensity for Pendulum<T> {}
    #[doc(hidden)]
    impl<T: __kahan::Integer> __kahan::IntegerParameters for Pendulum<T> {}
};
