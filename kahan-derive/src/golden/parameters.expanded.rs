/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the field
///
/// ```text
/// xdot = y
/// ydot = (x*y - 981/100*mu*x + 981/100*nu*x + nu*x*y - 1/10*mu^2*y + 1/10*mu*nu*y - 1/10*mu^2*nu*y + 1/10*mu*nu^2*y)/(mu - nu + mu*nu - nu^2)
/// ```
///
/// Matrix A(x,ε) = I − ε f′(x), row by row:
///
/// ```text
/// [ 1, -eps ]
/// [ (-eps*y + 981/100*eps*mu - 981/100*eps*nu - eps*nu*y)/(mu - nu + mu*nu - nu^2), (mu - nu - eps*x + mu*nu - nu^2 - eps*nu*x + 1/10*eps*mu^2 - 1/10*eps*mu*nu + 1/10*eps*mu^2*nu - 1/10*eps*mu*nu^2)/(mu - nu + mu*nu - nu^2) ]
/// ```
///
/// The map, over its common denominator in lowest terms:
///
/// ```text
/// x~ = x + 2*eps*(mu*y - nu*y - 981/100*eps*mu*x + 981/100*eps*nu*x + mu*nu*y - nu^2*y)/(mu - nu - eps*x + mu*nu - nu^2 - eps*nu*x - eps^2*y + 1/10*eps*mu^2 - 1/10*eps*mu*nu + 981/100*eps^2*mu - 981/100*eps^2*nu - eps^2*nu*y + 1/10*eps*mu^2*nu - 1/10*eps*mu*nu^2)
/// y~ = y + 2*eps*(x*y - 981/100*mu*x + 981/100*nu*x + nu*x*y + eps*y^2 - 1/10*mu^2*y + 1/10*mu*nu*y - 981/100*eps*mu*y + 981/100*eps*nu*y + eps*nu*y^2 - 1/10*mu^2*nu*y + 1/10*mu*nu^2*y)/(mu - nu - eps*x + mu*nu - nu^2 - eps*nu*x - eps^2*y + 1/10*eps*mu^2 - 1/10*eps*mu*nu + 981/100*eps^2*mu - 981/100*eps^2*nu - eps^2*nu*y + 1/10*eps*mu^2*nu - 1/10*eps*mu*nu^2)
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
        fn field(&self, __state: &__kahan::SVector<T, 2>) -> __kahan::SVector<T, 2> {
            let [__s_x, __s_y] = __kahan::components(__state);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __sum_1 = __p_mu.clone() - __p_nu.clone();
            let __sum_2 = __sum_1.clone() - __kahan::integer::<T>(1);
            let __c_10 = __kahan::integer::<T>(10);
            let __product_3 = __c_10.clone() * __s_x.clone();
            __kahan::vector([
                __s_y.clone(),
                -((__s_x.clone() * (__sum_1.clone() * __kahan::integer::<T>(981))
                    + __s_y.clone()
                        * (__c_10.clone()
                            * (__p_mu.clone() * __p_mu.clone() - __product_3.clone()
                                + __p_nu.clone()
                                    * (__p_mu.clone() * __sum_2.clone()
                                        - __product_3.clone())))) * __kahan::ratio::<T>(1, 100)
                    / (__p_mu.clone() + __p_nu.clone() * __sum_2.clone())),
            ])
        }
        fn field_jacobian(
            &self,
            __state: &__kahan::SVector<T, 2>,
        ) -> __kahan::SMatrix<T, 2, 2> {
            let [__s_x, __s_y] = __kahan::components(__state);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __c_1 = __kahan::integer::<T>(1);
            let __product_1 = __kahan::integer::<T>(100) * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __sum_2 = __p_mu.clone() - __p_nu.clone() - __c_1.clone();
            let __sum_3 = __p_mu.clone() + __p_nu.clone() * __sum_2.clone();
            let __product_4 = __kahan::integer::<T>(10) * __s_x.clone();
            __kahan::matrix([
                [__kahan::integer::<T>(0), __c_1.clone()],
                [
                    (__product_1.clone() - __c_981.clone() * __p_mu.clone()
                        + (__product_1.clone() + __c_981.clone()) * __p_nu.clone())
                        * __kahan::ratio::<T>(1, 100) / __sum_3.clone(),
                    -((__p_mu.clone() * __p_mu.clone() - __product_4.clone()
                        + __p_nu.clone()
                            * (__p_mu.clone() * __sum_2.clone() - __product_4.clone()))
                        * __kahan::ratio::<T>(1, 10) / __sum_3.clone()),
                ],
            ])
        }
        fn bilinear(
            &self,
            __state: &__kahan::SVector<T, 2>,
            __other: &__kahan::SVector<T, 2>,
        ) -> __kahan::SVector<T, 2> {
            let [__s_x, __s_y] = __kahan::components(__state);
            let [__o_x, __o_y] = __kahan::components(__other);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __c_1 = __kahan::integer::<T>(1);
            let __sum_1 = __p_nu.clone() + __c_1.clone();
            __kahan::vector([
                __kahan::integer::<T>(0),
                (__sum_1.clone() * (__s_y.clone() * __o_x.clone())
                    + __sum_1.clone() * __s_x.clone() * __o_y.clone())
                    * __kahan::ratio::<T>(1, 2)
                    / (__p_mu.clone()
                        + __p_nu.clone()
                            * (__p_mu.clone() - __p_nu.clone() - __c_1.clone())),
            ])
        }
        fn polarized(
            &self,
            __state: &__kahan::SVector<T, 2>,
            __other: &__kahan::SVector<T, 2>,
        ) -> __kahan::SVector<T, 2> {
            let [__s_x, __s_y] = __kahan::components(__state);
            let [__o_x, __o_y] = __kahan::components(__other);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __sum_1 = __s_y.clone() + __o_y.clone();
            let __sum_2 = __p_mu.clone() - __p_nu.clone() - __kahan::integer::<T>(1);
            let __c_10 = __kahan::integer::<T>(10);
            let __c_100 = __kahan::integer::<T>(100);
            let __c_981 = __kahan::integer::<T>(981);
            __kahan::vector([
                __sum_1.clone() * __kahan::ratio::<T>(1, 2),
                -((__p_mu.clone()
                    * (__c_981.clone() * (__s_x.clone() + __o_x.clone())
                        + __p_mu.clone() * (__sum_1.clone() * __c_10.clone()))
                    - __c_100.clone()
                        * (__o_y.clone() * __s_x.clone() + __s_y.clone() * __o_x.clone())
                    + __p_nu.clone()
                        * (__p_mu.clone()
                            * ((__s_y.clone() * __sum_2.clone()
                                + __o_y.clone() * __sum_2.clone()) * __c_10.clone())
                            - ((__o_y.clone() * __c_100.clone() + __c_981.clone())
                                * __s_x.clone()
                                + (__s_y.clone() * __c_100.clone() + __c_981.clone())
                                    * __o_x.clone()))) * __kahan::ratio::<T>(1, 200)
                    / (__p_mu.clone() + __p_nu.clone() * __sum_2.clone())),
            ])
        }
    }
    fn __reduced<T: __kahan::Scalar>(
        __system: &Pendulum<T>,
        __state: &__kahan::SVector<T, 2>,
        __half_step: &T,
    ) -> (__kahan::SVector<T, 2>, T) {
        let [__s_x, __s_y] = __kahan::components(__state);
        let __p_mu = &__system.mu;
        let __p_nu = &__system.nu;
        let __sum_1 = __p_mu.clone() - __p_nu.clone();
        let __sum_2 = __sum_1.clone() - __kahan::integer::<T>(1);
        let __c_100 = __kahan::integer::<T>(100);
        let __c_981 = __kahan::integer::<T>(981);
        let __product_3 = __c_981.clone() * (__s_x.clone() * __half_step.clone());
        let __product_4 = __c_100.clone() * __s_y.clone();
        let __c_1_100 = __kahan::ratio::<T>(1, 100);
        let __c_10 = __kahan::integer::<T>(10);
        let __sum_5 = __half_step.clone()
            * (__product_4.clone() - __p_mu.clone() * __c_981.clone())
            - __c_10.clone()
                * (__p_mu.clone() * __p_mu.clone() - __s_x.clone() * __c_10.clone())
            + __p_nu.clone()
                * (__c_100.clone() * __s_x.clone()
                    + __half_step.clone() * (__product_4.clone() + __c_981.clone())
                    - __p_mu.clone() * (__sum_2.clone() * __c_10.clone()));
        (
            __kahan::vector([
                -((__p_mu.clone() * (__product_3.clone() - __product_4.clone())
                    - __p_nu.clone()
                        * (__product_3.clone()
                            + __sum_2.clone() * __c_100.clone() * __s_y.clone()))
                    * __c_1_100.clone()),
                __c_1_100.clone()
                    * (__s_y.clone() * __sum_5.clone()
                        - __s_x.clone() * (__sum_1.clone() * __c_981.clone())),
            ]),
            -(__c_1_100.clone()
                * (__half_step.clone() * __sum_5.clone()
                    - __c_100.clone()
                        * (__p_mu.clone() + __p_nu.clone() * __sum_2.clone()))),
        )
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Pendulum<T> {
        fn increment(
            &self,
            __state: &__kahan::SVector<T, 2>,
            __half_step: &T,
        ) -> __kahan::Option<__kahan::SVector<T, 2>> {
            let (__numerators, __denominator) = __reduced(self, __state, __half_step);
            __kahan::increment_from_quotient(__numerators, __denominator, __half_step)
        }
        fn jacobian(
            &self,
            __state: &__kahan::SVector<T, 2>,
            __half_step: T,
        ) -> __kahan::SMatrix<T, 2, 2> {
            let __lifted = Pendulum {
                mu: __kahan::Dual::lift(self.mu.clone()),
                nu: __kahan::Dual::lift(self.nu.clone()),
            };
            __kahan::jacobian_of_reduced(
                |__state, __half_step| {
                    let (__numerators, __denominator) = __reduced(
                        &__lifted,
                        __state,
                        __half_step,
                    );
                    __kahan::increment_from_quotient(
                        __numerators,
                        __denominator,
                        __half_step,
                    )
                },
                __state,
                &__half_step,
            )
        }
        fn det_matrix(&self, __state: &__kahan::SVector<T, 2>, __half_step: T) -> T {
            let [__s_x, __s_y] = __kahan::components(__state);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __sum_1 = __p_mu.clone() - __p_nu.clone() - __kahan::integer::<T>(1);
            let __c_10 = __kahan::integer::<T>(10);
            let __c_100 = __kahan::integer::<T>(100);
            let __product_2 = __c_100.clone() * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __sum_3 = __p_mu.clone() + __p_nu.clone() * __sum_1.clone();
            -((__half_step.clone()
                * (__half_step.clone()
                    * (__product_2.clone() - __p_mu.clone() * __c_981.clone())
                    - __c_10.clone()
                        * (__p_mu.clone() * __p_mu.clone()
                            - __c_10.clone() * __s_x.clone())
                    + __p_nu.clone()
                        * (__c_100.clone() * __s_x.clone()
                            + (__product_2.clone() + __c_981.clone())
                                * __half_step.clone()
                            - __p_mu.clone() * (__sum_1.clone() * __c_10.clone())))
                - __c_100.clone() * __sum_3.clone()) * __kahan::ratio::<T>(1, 100)
                / __sum_3.clone())
        }
        fn rational_map(
            &self,
            __state: &__kahan::SVector<T, 2>,
            __half_step: T,
        ) -> (__kahan::SVector<T, 2>, T) {
            let [__s_x, __s_y] = __kahan::components(__state);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __sum_1 = __p_mu.clone() - __p_nu.clone();
            let __sum_2 = __sum_1.clone() - __kahan::integer::<T>(1);
            let __sum_3 = __p_mu.clone() + __p_nu.clone() * __sum_2.clone();
            let __c_10 = __kahan::integer::<T>(10);
            let __product_4 = __p_mu.clone() * (__sum_2.clone() * __c_10.clone());
            let __c_100 = __kahan::integer::<T>(100);
            let __product_5 = __c_100.clone() * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __product_6 = __c_100.clone() * __s_x.clone();
            let __product_7 = __p_mu.clone() * __c_981.clone();
            let __product_8 = __c_10.clone()
                * (__p_mu.clone() * __p_mu.clone() - __c_10.clone() * __s_x.clone());
            let __product_9 = __sum_3.clone() * __c_100.clone();
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            let __product_10 = __half_step.clone()
                * (__half_step.clone() * (__product_5.clone() - __product_7.clone())
                    - __product_8.clone()
                    + __p_nu.clone()
                        * (__product_6.clone()
                            + __half_step.clone()
                                * (__product_5.clone() + __c_981.clone())
                            - __product_4.clone()));
            (
                __kahan::vector([
                    -((__half_step.clone()
                        * (__s_x.clone()
                            * (__half_step.clone()
                                * (__product_5.clone() + __product_7.clone())
                                - __product_8.clone()
                                + __p_nu.clone()
                                    * (__product_6.clone()
                                        + (__product_5.clone() - __c_981.clone())
                                            * __half_step.clone() - __product_4.clone()))
                            - __s_y.clone()
                                * (__sum_3.clone() * __kahan::integer::<T>(200)))
                        - __s_x.clone() * __product_9.clone()) * __c_1_100.clone()
                        / __sum_3.clone()),
                    __c_1_100.clone()
                        * (__s_y.clone() * (__product_9.clone() + __product_10.clone())
                            - __sum_1.clone() * __kahan::integer::<T>(1962)
                                * (__half_step.clone() * __s_x.clone())) / __sum_3.clone(),
                ]),
                -(__c_1_100.clone() * (__product_10.clone() - __product_9.clone())
                    / __sum_3.clone()),
            )
        }
    }
};
