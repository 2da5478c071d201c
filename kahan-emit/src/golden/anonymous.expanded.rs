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
            fn x() {}
            fn y() {}
            fn eps() {}
            fn prepared() {}
            fn lift() {}
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
                fn field(&self, x: &__kahan::SVector<T, 2>) -> __kahan::SVector<T, 2> {
                    let [__s_x, __s_y] = __kahan::components(x);
                    let __p_mu = &self.mu;
                    __kahan::vector([
                        __s_x.clone() * __s_y.clone() * __p_mu.clone(),
                        __s_x.clone() - __s_y.clone(),
                    ])
                }
                fn field_jacobian(
                    &self,
                    x: &__kahan::SVector<T, 2>,
                ) -> __kahan::SMatrix<T, 2, 2> {
                    let [__s_x, __s_y] = __kahan::components(x);
                    let __p_mu = &self.mu;
                    let __c_1 = __kahan::integer::<T>(1);
                    __kahan::matrix([
                        [__s_y.clone() * __p_mu.clone(), __p_mu.clone() * __s_x.clone()],
                        [__c_1.clone(), -__c_1],
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
                    __kahan::vector([
                        (__s_x.clone() * __o_y.clone() + __s_y.clone() * __o_x.clone())
                            * __kahan::ratio::<T>(1, 2) * __p_mu.clone(),
                        __kahan::integer::<T>(0),
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
                    let __c_1_2 = __kahan::ratio::<T>(1, 2);
                    __kahan::vector([
                        (__s_x.clone() * __o_y.clone() + __s_y.clone() * __o_x.clone())
                            * __c_1_2.clone() * __p_mu.clone(),
                        __c_1_2
                            * (__s_x.clone() - __s_y.clone() + __o_x.clone()
                                - __o_y.clone()),
                    ])
                }
            }
            #[::core::prelude::v1::derive(::core::clone::Clone, ::core::marker::Copy)]
            pub struct __Step<T> {
                mu_half_eps: __kahan::Apart<T>,
                mu_half_eps_plus_half_mu: __kahan::Apart<T>,
                half_plus_half_over_eps: __kahan::Apart<T>,
                eps: __kahan::Apart<T>,
                eps_mu: __kahan::Apart<T>,
                mu: __kahan::Apart<T>,
                __general: __General<T>,
                __is_inverse: __kahan::core::primitive::bool,
            }
            impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 2> for __Step<T> {
                const COST: __kahan::StepCost = __kahan::StepCost {
                    operations: 16,
                    divisions: 2,
                    chain: 25,
                };
                const HAS_INVERSE_STEP: __kahan::core::primitive::bool = true;
                #[inline(always)]
                fn quotients(
                    &self,
                    x: &__kahan::SVector<T, 2>,
                ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
                    if !T::HAS_INVERSE_STEPS
                        || !(T::CALLS_GENERAL_STEP || self.__is_inverse)
                    {
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
                            reciprocals: [__kahan::Option::None, __kahan::Option::None],
                        });
                    }
                    let [__s_x, __s_y] = __kahan::components(x).clone();
                    let __sum_1 = self
                        .half_plus_half_over_eps
                        .0
                        .clone()
                        .subtract_product(self.mu_half_eps.0.clone(), __s_x.clone())
                        .subtract_product(
                            self.mu_half_eps_plus_half_mu.0.clone(),
                            __s_y.clone(),
                        );
                    let __quotient_1 = (self
                        .eps
                        .0
                        .clone()
                        .multiply_add(__s_x.clone(), __s_y.clone())
                        * (self.mu.0.clone() * __s_x.clone()))
                        .quotient(__sum_1.clone())?;
                    let __quotient_2 = __s_y
                        .clone()
                        .multiply_add(
                            __s_y.clone() * self.eps_mu.0.clone(),
                            __s_x - __s_y,
                        )
                        .quotient(__sum_1)?;
                    __kahan::Option::Some(__kahan::Quotients {
                        numerators: [__quotient_1, __quotient_2],
                        reciprocals: [__kahan::Option::None, __kahan::Option::None],
                    })
                }
            }
            #[::core::prelude::v1::derive(::core::clone::Clone, ::core::marker::Copy)]
            pub struct __General<T> {
                eps_mu: __kahan::Apart<T>,
                eps: __kahan::Apart<T>,
                eps_plus_one: __kahan::Apart<T>,
            }
            impl<T: __kahan::Scalar> __kahan::PreparedStep<T, 2> for __General<T> {
                const COST: __kahan::StepCost = __kahan::StepCost {
                    operations: 17,
                    divisions: 1,
                    chain: 33,
                };
                #[inline(always)]
                fn quotients(
                    &self,
                    x: &__kahan::SVector<T, 2>,
                ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
                    let [__s_x, __s_y] = __kahan::components(x).clone();
                    let __t_y_eps_mu_minus_one = __s_y
                        .clone()
                        .multiply_subtract(
                            self.eps_mu.0.clone(),
                            __kahan::integer::<T>(1),
                        );
                    let __t_eps_mu_x = self.eps_mu.0.clone() * __s_x.clone();
                    let __t_eps_x = self.eps.0.clone() * __s_x;
                    let __reciprocal_1 = __kahan::integer::<T>(-2)
                        .quotient(
                            __t_y_eps_mu_minus_one
                                .clone()
                                .multiply_add(
                                    self.eps_plus_one.0.clone(),
                                    self.eps.0.clone() * __t_eps_mu_x.clone(),
                                ),
                        )?;
                    __kahan::Option::Some(__kahan::Quotients {
                        numerators: [
                            __t_eps_mu_x * (__s_y.clone() + __t_eps_x.clone()),
                            __t_y_eps_mu_minus_one
                                .multiply_add(__s_y * self.eps.0.clone(), __t_eps_x),
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
                        eps_mu: __kahan::Apart::new(__spread(&self.__general.eps_mu.0)),
                        eps: __kahan::Apart::new(__spread(&self.__general.eps.0)),
                        eps_plus_one: __kahan::Apart::new(
                            __spread(&self.__general.eps_plus_one.0),
                        ),
                    }
                }
            }
            impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Field<T> {
                type Prepared = __Step<T>;
                #[inline(always)]
                fn prepare(&self, eps: &T) -> __Step<T> {
                    let __general = {
                        let __p_mu = &self.mu;
                        __General {
                            eps_mu: __kahan::Apart::new(eps.clone() * __p_mu.clone()),
                            eps: __kahan::Apart::new(eps.clone()),
                            eps_plus_one: __kahan::Apart::new(
                                eps.clone() + __kahan::integer::<T>(1),
                            ),
                        }
                    };
                    let (__is_inverse, __divisor) = __kahan::divisor(eps);
                    let eps = &__divisor;
                    let __p_mu = &self.mu;
                    let __c_1_2 = __kahan::ratio::<T>(1, 2);
                    let __t_mu_half_eps = __p_mu.clone()
                        * (__c_1_2.clone() * eps.clone());
                    __Step {
                        mu_half_eps: __kahan::Apart::new(__t_mu_half_eps.clone()),
                        mu_half_eps_plus_half_mu: __kahan::Apart::new(
                            __t_mu_half_eps + __c_1_2.clone() * __p_mu.clone(),
                        ),
                        half_plus_half_over_eps: __kahan::Apart::new(
                            __c_1_2.clone() + __c_1_2.over_eps(eps),
                        ),
                        eps: __kahan::Apart::new(eps.clone()),
                        eps_mu: __kahan::Apart::new(eps.clone() * __p_mu.clone()),
                        mu: __kahan::Apart::new(__p_mu.clone()),
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
                ) -> __kahan::core::result::Result<
                    __kahan::SVector<T, 2>,
                    __kahan::SingularStep,
                >
                where
                    T: __kahan::Pivot,
                {
                    __kahan::stable_step(self, prepared, x, eps)
                }
                fn det_matrix(&self, x: &__kahan::SVector<T, 2>, eps: T) -> T {
                    let [__s_x, __s_y] = __kahan::components(x);
                    let __p_mu = &self.mu;
                    let __c_1 = __kahan::integer::<T>(1);
                    __c_1.clone()
                        - eps.clone()
                            * ((__s_y.clone()
                                + (__s_x.clone() + __s_y.clone()) * eps.clone())
                                * __p_mu.clone() - __c_1)
                }
                fn rational_map(
                    &self,
                    x: &__kahan::SVector<T, 2>,
                    eps: T,
                ) -> (__kahan::SVector<T, 2>, T) {
                    let [__s_x, __s_y] = __kahan::components(x);
                    let __p_mu = &self.mu;
                    let __c_1 = __kahan::integer::<T>(1);
                    let __sum_1 = __c_1.clone()
                        + (__s_y.clone() + (__s_x.clone() - __s_y.clone()) * eps.clone())
                            * __p_mu.clone();
                    (
                        __kahan::vector([
                            __s_x.clone()
                                * (__c_1.clone() + eps.clone() * __sum_1.clone()),
                            __s_y.clone()
                                - eps.clone()
                                    * (__s_y.clone() * __sum_1
                                        - __s_x.clone() * __kahan::integer::<T>(2)),
                        ]),
                        __c_1.clone()
                            - eps.clone()
                                * (__p_mu.clone()
                                    * (__s_y.clone()
                                        + eps.clone() * (__s_x.clone() + __s_y.clone())) - __c_1),
                    )
                }
            }
            impl<T: __kahan::Scalar> __kahan::Lift<T, 2> for Field<T> {
                type Lifted<U: __kahan::Scalar> = Field<U>;
                #[inline(always)]
                fn lift<U: __kahan::Scalar>(
                    &self,
                    lift: impl __kahan::core::ops::Fn(&T) -> U,
                ) -> Field<U> {
                    Field { mu: lift(&self.mu) }
                }
            }
            #[doc(hidden)]
            impl<T> __kahan::WithoutIntegrals for Field<T> {}
            #[doc(hidden)]
            impl<T> __kahan::WithoutDensity for Field<T> {}
            #[doc(hidden)]
            impl<T: __kahan::Integer> __kahan::IntegerParameters for Field<T> {}
        };
        Field {
            mu: ::core::clone::Clone::clone(&mu),
        }
    };
}
