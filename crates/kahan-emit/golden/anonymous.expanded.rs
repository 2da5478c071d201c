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
            use ::kahan_core::__private::{self as __kahan, arguments::*, Clone as _};
            impl<T> Field<T> {
                /// The parameters, in order.
                pub const PARAMETERS: [&'static __kahan::str; 1] = ["mu"];
            }
            pub struct __Step;
            impl __kahan::Kernel<2, 5> for __Step {
                const COST: __kahan::StepCost = __kahan::StepCost::of(17, 1, 29);
                #[inline(always)]
                fn quotients<T: __kahan::Scalar>(
                    __constants: &[__kahan::Padded<T>; 5],
                    __state: [T; 2],
                ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
                    let [__e_mu_eps, __e_mu_plus_mu_eps, __e_one_plus_one_over_eps,
                    __e_eps, __e_mu] = __constants;
                    let [__s_x, __s_y] = __state;
                    let __reciprocal_1 = __kahan::integer::<T>(-2)
                        .quotient(
                            __e_mu_plus_mu_eps
                                .get()
                                .multiply_add(
                                    __s_y.clone(),
                                    __e_mu_eps
                                        .get()
                                        .multiply_subtract(
                                            __s_x.clone(),
                                            __e_one_plus_one_over_eps.get(),
                                        ),
                                ),
                        )?;
                    __kahan::Some(
                        __kahan::Quotients::over(
                            [
                                __e_eps.get().multiply_add(__s_x.clone(), __s_y.clone())
                                    * (__e_mu.get() * __s_x.clone()),
                                __s_y
                                    .clone()
                                    .multiply_add(
                                        __e_mu_eps.get() * __s_y.clone(),
                                        __s_x - __s_y,
                                    ),
                            ],
                            __reciprocal_1,
                        ),
                    )
                }
            }
            pub struct __General;
            impl __kahan::Kernel<2, 3> for __General {
                const COST: __kahan::StepCost = __kahan::StepCost::of(17, 1, 33);
                #[inline(always)]
                fn quotients<T: __kahan::Scalar>(
                    __constants: &[__kahan::Padded<T>; 3],
                    __state: [T; 2],
                ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
                    let [__e_eps_mu, __e_eps, __e_eps_plus_one] = __constants;
                    let [__s_x, __s_y] = __state;
                    let __t_y_eps_mu_minus_one = __s_y
                        .clone()
                        .multiply_subtract(__e_eps_mu.get(), __kahan::integer::<T>(1));
                    let __t_eps_mu_x = __e_eps_mu.get() * __s_x.clone();
                    let __t_eps_x = __e_eps.get() * __s_x;
                    let __reciprocal_1 = __kahan::integer::<T>(-2)
                        .quotient(
                            __t_y_eps_mu_minus_one
                                .clone()
                                .multiply_add(
                                    __e_eps_plus_one.get(),
                                    __e_eps.get() * __t_eps_mu_x.clone(),
                                ),
                        )?;
                    __kahan::Some(
                        __kahan::Quotients::over(
                            [
                                __t_eps_mu_x * (__s_y.clone() + __t_eps_x.clone()),
                                __t_y_eps_mu_minus_one
                                    .multiply_add(__s_y * __e_eps.get(), __t_eps_x),
                            ],
                            __reciprocal_1,
                        ),
                    )
                }
            }
            impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Field<T> {
                type Prepared = __kahan::StepOverEps<__Step, __General, T, 5, 3>;
                #[inline(always)]
                fn prepare(&self, eps: &T) -> Self::Prepared {
                    Self::Prepared::new(
                        eps,
                        || {
                            let __p_mu = &self.mu;
                            let __t_mu_eps = __p_mu.clone() * eps.clone();
                            let __c_1 = __kahan::integer::<T>(1);
                            [
                                __t_mu_eps.clone(),
                                __p_mu.clone() + __t_mu_eps,
                                __c_1.clone() + __c_1 / eps.clone(),
                                eps.clone(),
                                __p_mu.clone(),
                            ]
                        },
                        || {
                            let __p_mu = &self.mu;
                            [
                                eps.clone() * __p_mu.clone(),
                                eps.clone(),
                                eps.clone() + __kahan::integer::<T>(1),
                            ]
                        },
                    )
                }
            }
            impl<T: __kahan::Scalar> __kahan::ExtendScalars<T, 2> for Field<T> {
                #[inline(always)]
                fn extend_scalars<U: __kahan::Scalar>(
                    &self,
                    convert: impl __kahan::Fn(&T) -> U,
                ) -> Field<U> {
                    Field { mu: convert(&self.mu) }
                }
            }
        };
        Field {
            mu: ::core::clone::Clone::clone(&mu),
        }
    };
}
