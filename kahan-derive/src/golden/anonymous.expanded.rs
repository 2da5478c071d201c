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
        /// The map in lowest terms:
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
                    state: &__kahan::SVector<T, 2>,
                ) -> __kahan::SVector<T, 2> {
                    let [s_x, s_y] = __kahan::components(state);
                    let p_mu = &self.mu;
                    __kahan::vector([
                        s_x.clone() * s_y.clone() * p_mu.clone(),
                        s_x.clone() - s_y.clone(),
                    ])
                }
                fn field_jacobian(
                    &self,
                    state: &__kahan::SVector<T, 2>,
                ) -> __kahan::SMatrix<T, 2, 2> {
                    let [s_x, s_y] = __kahan::components(state);
                    let p_mu = &self.mu;
                    let c_1 = __kahan::integer::<T>(1);
                    __kahan::matrix([
                        [s_y.clone() * p_mu.clone(), p_mu.clone() * s_x.clone()],
                        [c_1.clone(), -c_1.clone()],
                    ])
                }
                fn bilinear(
                    &self,
                    state: &__kahan::SVector<T, 2>,
                    other: &__kahan::SVector<T, 2>,
                ) -> __kahan::SVector<T, 2> {
                    let [s_x, s_y] = __kahan::components(state);
                    let [o_x, o_y] = __kahan::components(other);
                    let p_mu = &self.mu;
                    __kahan::vector([
                        (s_x.clone() * o_y.clone() + s_y.clone() * o_x.clone())
                            * __kahan::ratio::<T>(1, 2) * p_mu.clone(),
                        __kahan::integer::<T>(0),
                    ])
                }
                fn polarized(
                    &self,
                    state: &__kahan::SVector<T, 2>,
                    other: &__kahan::SVector<T, 2>,
                ) -> __kahan::SVector<T, 2> {
                    let [s_x, s_y] = __kahan::components(state);
                    let [o_x, o_y] = __kahan::components(other);
                    let p_mu = &self.mu;
                    let c_1_2 = __kahan::ratio::<T>(1, 2);
                    __kahan::vector([
                        (s_x.clone() * o_y.clone() + s_y.clone() * o_x.clone())
                            * c_1_2.clone() * p_mu.clone(),
                        c_1_2.clone()
                            * (s_x.clone() - s_y.clone() + o_x.clone() - o_y.clone()),
                    ])
                }
            }
            fn reduced<T: __kahan::Scalar>(
                system: &Field<T>,
                state: &__kahan::SVector<T, 2>,
                half_step: &T,
            ) -> (__kahan::SVector<T, 2>, T) {
                let [s_x, s_y] = __kahan::components(state);
                let p_mu = &system.mu;
                let c_1 = __kahan::integer::<T>(1);
                (
                    __kahan::vector([
                        (s_x.clone() * half_step.clone() + s_y.clone())
                            * (s_x.clone() * p_mu.clone()),
                        s_x.clone()
                            + s_y.clone()
                                * (half_step.clone() * (s_y.clone() * p_mu.clone())
                                    - c_1.clone()),
                    ]),
                    c_1.clone()
                        - half_step.clone()
                            * (p_mu.clone()
                                * (s_y.clone()
                                    + half_step.clone() * (s_x.clone() + s_y.clone()))
                                - c_1.clone()),
                )
            }
            impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Field<T> {
                fn increment(
                    &self,
                    state: &__kahan::SVector<T, 2>,
                    half_step: &T,
                ) -> __kahan::Option<__kahan::SVector<T, 2>> {
                    let (numerators, denominator) = reduced(self, state, half_step);
                    __kahan::increment_from_quotient(numerators, denominator, half_step)
                }
                fn jacobian(
                    &self,
                    state: &__kahan::SVector<T, 2>,
                    half_step: T,
                ) -> __kahan::SMatrix<T, 2, 2> {
                    let lifted = Field {
                        mu: __kahan::Dual::lift(self.mu.clone()),
                    };
                    __kahan::jacobian_of_reduced(
                        |state, half_step| {
                            let (numerators, denominator) = reduced(
                                &lifted,
                                state,
                                half_step,
                            );
                            __kahan::increment_from_quotient(
                                numerators,
                                denominator,
                                half_step,
                            )
                        },
                        state,
                        &half_step,
                    )
                }
                fn det_matrix(&self, state: &__kahan::SVector<T, 2>, half_step: T) -> T {
                    let [s_x, s_y] = __kahan::components(state);
                    let p_mu = &self.mu;
                    let c_1 = __kahan::integer::<T>(1);
                    c_1.clone()
                        - half_step.clone()
                            * ((s_y.clone()
                                + (s_x.clone() + s_y.clone()) * half_step.clone())
                                * p_mu.clone() - c_1.clone())
                }
                fn rational_map(
                    &self,
                    state: &__kahan::SVector<T, 2>,
                    half_step: T,
                ) -> (__kahan::SVector<T, 2>, T) {
                    let [s_x, s_y] = __kahan::components(state);
                    let p_mu = &self.mu;
                    let c_1 = __kahan::integer::<T>(1);
                    let sum_1 = c_1.clone()
                        + (s_y.clone() + (s_x.clone() - s_y.clone()) * half_step.clone())
                            * p_mu.clone();
                    (
                        __kahan::vector([
                            s_x.clone()
                                * (c_1.clone() + half_step.clone() * sum_1.clone()),
                            s_y.clone()
                                - half_step.clone()
                                    * (s_y.clone() * sum_1.clone()
                                        - s_x.clone() * __kahan::integer::<T>(2)),
                        ]),
                        c_1.clone()
                            - half_step.clone()
                                * (p_mu.clone()
                                    * (s_y.clone()
                                        + half_step.clone() * (s_x.clone() + s_y.clone()))
                                    - c_1.clone()),
                    )
                }
            }
        };
        Field {
            mu: ::core::clone::Clone::clone(&mu),
        }
    };
}
