fn scope() {
    let value = {
        /// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the field
        ///
        /// ```text
        /// xdot = mu*x*y
        /// ydot = x - y
        /// ```
        ///
        /// Matrix A(x,ε) = I − ε f′(x), row by row:
        ///
        /// ```text
        /// [ 1 - eps*mu*y, -eps*mu*x ]
        /// [ -eps, 1 + eps ]
        /// ```
        ///
        /// The map, over its common denominator in lowest terms:
        ///
        /// ```text
        /// x~ = x + 2*eps*(mu*x*y + eps*mu*x^2)/(1 + eps - eps*mu*y - eps^2*mu*x - eps^2*mu*y)
        /// y~ = y + 2*eps*(x - y + eps*mu*y^2)/(1 + eps - eps*mu*y - eps^2*mu*x - eps^2*mu*y)
        /// ```
        #[::core::prelude::v1::derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::cmp::PartialEq
        )]
        struct Field<T> {
            /// The parameter `mu`.
            pub mu: T,
        }
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
        #[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
        const _: () = {
            use ::kahan_core::__private as __kahan;
            use __kahan::Clone as _;
            impl<T> Field<T> {
                /// The state variables, in order.
                pub const VARIABLES: [&'static __kahan::core::primitive::str; 2] = [
                    "x",
                    "y",
                ];
                /// The parameters, in order.
                pub const PARAMETERS: [&'static __kahan::core::primitive::str; 1] = [
                    "mu",
                ];
            }
            impl<T> __kahan::Named for Field<T> {
                fn variables(
                    &self,
                ) -> &'static [&'static __kahan::core::primitive::str] {
                    &Self::VARIABLES
                }
                fn parameters(
                    &self,
                ) -> &'static [&'static __kahan::core::primitive::str] {
                    &Self::PARAMETERS
                }
            }
            impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 2> for Field<T> {
                fn field(
                    &self,
                    __state: &__kahan::SVector<T, 2>,
                ) -> __kahan::SVector<T, 2> {
                    let [__s_x, __s_y] = __kahan::components(__state);
                    let __p_mu = &self.mu;
                    __kahan::vector([
                        __s_x.clone() * __s_y.clone() * __p_mu.clone(),
                        __s_x.clone() - __s_y.clone(),
                    ])
                }
                fn field_jacobian(
                    &self,
                    __state: &__kahan::SVector<T, 2>,
                ) -> __kahan::SMatrix<T, 2, 2> {
                    let [__s_x, __s_y] = __kahan::components(__state);
                    let __p_mu = &self.mu;
                    let __c_1 = __kahan::integer::<T>(1);
                    __kahan::matrix([
                        [__s_y.clone() * __p_mu.clone(), __p_mu.clone() * __s_x.clone()],
                        [__c_1.clone(), -__c_1.clone()],
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
                    __kahan::vector([
                        (__s_x.clone() * __o_y.clone() + __s_y.clone() * __o_x.clone())
                            * __kahan::ratio::<T>(1, 2) * __p_mu.clone(),
                        __kahan::integer::<T>(0),
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
                    let __c_1_2 = __kahan::ratio::<T>(1, 2);
                    __kahan::vector([
                        (__s_x.clone() * __o_y.clone() + __s_y.clone() * __o_x.clone())
                            * __c_1_2.clone() * __p_mu.clone(),
                        __c_1_2.clone()
                            * (__s_x.clone() - __s_y.clone() + __o_x.clone()
                                - __o_y.clone()),
                    ])
                }
            }
            fn __reduced<T: __kahan::Scalar>(
                __system: &Field<T>,
                __state: &__kahan::SVector<T, 2>,
                __half_step: &T,
            ) -> (__kahan::SVector<T, 2>, T) {
                let [__s_x, __s_y] = __kahan::components(__state);
                let __p_mu = &__system.mu;
                let __c_1 = __kahan::integer::<T>(1);
                (
                    __kahan::vector([
                        (__s_x.clone() * __half_step.clone() + __s_y.clone())
                            * (__s_x.clone() * __p_mu.clone()),
                        __s_x.clone()
                            + __s_y.clone()
                                * (__half_step.clone() * (__s_y.clone() * __p_mu.clone())
                                    - __c_1.clone()),
                    ]),
                    __c_1.clone()
                        - __half_step.clone()
                            * (__p_mu.clone()
                                * (__s_y.clone()
                                    + __half_step.clone() * (__s_x.clone() + __s_y.clone()))
                                - __c_1.clone()),
                )
            }
            impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Field<T> {
                fn increment(
                    &self,
                    __state: &__kahan::SVector<T, 2>,
                    __half_step: &T,
                ) -> __kahan::Option<__kahan::SVector<T, 2>> {
                    let (__numerators, __denominator) = __reduced(
                        self,
                        __state,
                        __half_step,
                    );
                    __kahan::increment_from_quotient(
                        __numerators,
                        __denominator,
                        __half_step,
                    )
                }
                fn jacobian(
                    &self,
                    __state: &__kahan::SVector<T, 2>,
                    __half_step: T,
                ) -> __kahan::SMatrix<T, 2, 2> {
                    let __lifted = Field {
                        mu: __kahan::Dual::lift(self.mu.clone()),
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
                fn det_matrix(
                    &self,
                    __state: &__kahan::SVector<T, 2>,
                    __half_step: T,
                ) -> T {
                    let [__s_x, __s_y] = __kahan::components(__state);
                    let __p_mu = &self.mu;
                    let __c_1 = __kahan::integer::<T>(1);
                    __c_1.clone()
                        - __half_step.clone()
                            * ((__s_y.clone()
                                + (__s_x.clone() + __s_y.clone()) * __half_step.clone())
                                * __p_mu.clone() - __c_1.clone())
                }
                fn rational_map(
                    &self,
                    __state: &__kahan::SVector<T, 2>,
                    __half_step: T,
                ) -> (__kahan::SVector<T, 2>, T) {
                    let [__s_x, __s_y] = __kahan::components(__state);
                    let __p_mu = &self.mu;
                    let __c_1 = __kahan::integer::<T>(1);
                    let __sum_1 = __c_1.clone()
                        + (__s_y.clone()
                            + (__s_x.clone() - __s_y.clone()) * __half_step.clone())
                            * __p_mu.clone();
                    (
                        __kahan::vector([
                            __s_x.clone()
                                * (__c_1.clone() + __half_step.clone() * __sum_1.clone()),
                            __s_y.clone()
                                - __half_step.clone()
                                    * (__s_y.clone() * __sum_1.clone()
                                        - __s_x.clone() * __kahan::integer::<T>(2)),
                        ]),
                        __c_1.clone()
                            - __half_step.clone()
                                * (__p_mu.clone()
                                    * (__s_y.clone()
                                        + __half_step.clone() * (__s_x.clone() + __s_y.clone()))
                                    - __c_1.clone()),
                    )
                }
            }
        };
        Field {
            mu: ::core::clone::Clone::clone(&mu),
        }
    };
}
