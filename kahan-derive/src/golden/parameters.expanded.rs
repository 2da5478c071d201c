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
/// The map in lowest terms:
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
        fn field(&self, state: &__kahan::SVector<T, 2>) -> __kahan::SVector<T, 2> {
            let [s_x, s_y] = __kahan::components(state);
            let p_mu = &self.mu;
            let p_nu = &self.nu;
            let sum_1 = p_mu.clone() - p_nu.clone();
            let sum_2 = sum_1.clone() - __kahan::integer::<T>(1);
            let c_10 = __kahan::integer::<T>(10);
            let product_3 = c_10.clone() * s_x.clone();
            __kahan::vector([
                s_y.clone(),
                -((s_x.clone() * (sum_1.clone() * __kahan::integer::<T>(981))
                    + s_y.clone()
                        * (c_10.clone()
                            * (p_mu.clone() * p_mu.clone() - product_3.clone()
                                + p_nu.clone()
                                    * (p_mu.clone() * sum_2.clone() - product_3.clone()))))
                    * __kahan::ratio::<T>(1, 100)
                    / (p_mu.clone() + p_nu.clone() * sum_2.clone())),
            ])
        }
        fn field_jacobian(
            &self,
            state: &__kahan::SVector<T, 2>,
        ) -> __kahan::SMatrix<T, 2, 2> {
            let [s_x, s_y] = __kahan::components(state);
            let p_mu = &self.mu;
            let p_nu = &self.nu;
            let c_1 = __kahan::integer::<T>(1);
            let product_1 = __kahan::integer::<T>(100) * s_y.clone();
            let c_981 = __kahan::integer::<T>(981);
            let sum_2 = p_mu.clone() - p_nu.clone() - c_1.clone();
            let sum_3 = p_mu.clone() + p_nu.clone() * sum_2.clone();
            let product_4 = __kahan::integer::<T>(10) * s_x.clone();
            __kahan::matrix([
                [__kahan::integer::<T>(0), c_1.clone()],
                [
                    (product_1.clone() - c_981.clone() * p_mu.clone()
                        + (product_1.clone() + c_981.clone()) * p_nu.clone())
                        * __kahan::ratio::<T>(1, 100) / sum_3.clone(),
                    -((p_mu.clone() * p_mu.clone() - product_4.clone()
                        + p_nu.clone()
                            * (p_mu.clone() * sum_2.clone() - product_4.clone()))
                        * __kahan::ratio::<T>(1, 10) / sum_3.clone()),
                ],
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
            let p_nu = &self.nu;
            let c_1 = __kahan::integer::<T>(1);
            let sum_1 = p_nu.clone() + c_1.clone();
            __kahan::vector([
                __kahan::integer::<T>(0),
                (sum_1.clone() * (s_y.clone() * o_x.clone())
                    + sum_1.clone() * s_x.clone() * o_y.clone())
                    * __kahan::ratio::<T>(1, 2)
                    / (p_mu.clone()
                        + p_nu.clone() * (p_mu.clone() - p_nu.clone() - c_1.clone())),
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
            let p_nu = &self.nu;
            let sum_1 = s_y.clone() + o_y.clone();
            let sum_2 = p_mu.clone() - p_nu.clone() - __kahan::integer::<T>(1);
            let c_10 = __kahan::integer::<T>(10);
            let c_100 = __kahan::integer::<T>(100);
            let c_981 = __kahan::integer::<T>(981);
            __kahan::vector([
                sum_1.clone() * __kahan::ratio::<T>(1, 2),
                -((p_mu.clone()
                    * (c_981.clone() * (s_x.clone() + o_x.clone())
                        + p_mu.clone() * (sum_1.clone() * c_10.clone()))
                    - c_100.clone()
                        * (o_y.clone() * s_x.clone() + s_y.clone() * o_x.clone())
                    + p_nu.clone()
                        * (p_mu.clone()
                            * ((s_y.clone() * sum_2.clone()
                                + o_y.clone() * sum_2.clone()) * c_10.clone())
                            - ((o_y.clone() * c_100.clone() + c_981.clone())
                                * s_x.clone()
                                + (s_y.clone() * c_100.clone() + c_981.clone())
                                    * o_x.clone()))) * __kahan::ratio::<T>(1, 200)
                    / (p_mu.clone() + p_nu.clone() * sum_2.clone())),
            ])
        }
    }
    fn reduced<T: __kahan::Scalar>(
        system: &Pendulum<T>,
        state: &__kahan::SVector<T, 2>,
        half_step: &T,
    ) -> (__kahan::SVector<T, 2>, T) {
        let [s_x, s_y] = __kahan::components(state);
        let p_mu = &system.mu;
        let p_nu = &system.nu;
        let sum_1 = p_mu.clone() - p_nu.clone();
        let sum_2 = sum_1.clone() - __kahan::integer::<T>(1);
        let c_100 = __kahan::integer::<T>(100);
        let c_981 = __kahan::integer::<T>(981);
        let product_3 = c_981.clone() * (s_x.clone() * half_step.clone());
        let product_4 = c_100.clone() * s_y.clone();
        let c_1_100 = __kahan::ratio::<T>(1, 100);
        let c_10 = __kahan::integer::<T>(10);
        let sum_5 = half_step.clone()
            * (product_4.clone() - p_mu.clone() * c_981.clone())
            - c_10.clone() * (p_mu.clone() * p_mu.clone() - s_x.clone() * c_10.clone())
            + p_nu.clone()
                * (c_100.clone() * s_x.clone()
                    + half_step.clone() * (product_4.clone() + c_981.clone())
                    - p_mu.clone() * (sum_2.clone() * c_10.clone()));
        (
            __kahan::vector([
                -((p_mu.clone() * (product_3.clone() - product_4.clone())
                    - p_nu.clone()
                        * (product_3.clone()
                            + sum_2.clone() * c_100.clone() * s_y.clone()))
                    * c_1_100.clone()),
                c_1_100.clone()
                    * (s_y.clone() * sum_5.clone()
                        - s_x.clone() * (sum_1.clone() * c_981.clone())),
            ]),
            -(c_1_100.clone()
                * (half_step.clone() * sum_5.clone()
                    - c_100.clone() * (p_mu.clone() + p_nu.clone() * sum_2.clone()))),
        )
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Pendulum<T> {
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
            let lifted = Pendulum {
                mu: __kahan::Dual::lift(self.mu.clone()),
                nu: __kahan::Dual::lift(self.nu.clone()),
            };
            __kahan::jacobian_of_reduced(
                |state, half_step| {
                    let (numerators, denominator) = reduced(&lifted, state, half_step);
                    __kahan::increment_from_quotient(numerators, denominator, half_step)
                },
                state,
                &half_step,
            )
        }
        fn det_matrix(&self, state: &__kahan::SVector<T, 2>, half_step: T) -> T {
            let [s_x, s_y] = __kahan::components(state);
            let p_mu = &self.mu;
            let p_nu = &self.nu;
            let sum_1 = p_mu.clone() - p_nu.clone() - __kahan::integer::<T>(1);
            let c_10 = __kahan::integer::<T>(10);
            let c_100 = __kahan::integer::<T>(100);
            let product_2 = c_100.clone() * s_y.clone();
            let c_981 = __kahan::integer::<T>(981);
            let sum_3 = p_mu.clone() + p_nu.clone() * sum_1.clone();
            -((half_step.clone()
                * (half_step.clone() * (product_2.clone() - p_mu.clone() * c_981.clone())
                    - c_10.clone()
                        * (p_mu.clone() * p_mu.clone() - c_10.clone() * s_x.clone())
                    + p_nu.clone()
                        * (c_100.clone() * s_x.clone()
                            + (product_2.clone() + c_981.clone()) * half_step.clone()
                            - p_mu.clone() * (sum_1.clone() * c_10.clone())))
                - c_100.clone() * sum_3.clone()) * __kahan::ratio::<T>(1, 100)
                / sum_3.clone())
        }
        fn rational_map(
            &self,
            state: &__kahan::SVector<T, 2>,
            half_step: T,
        ) -> (__kahan::SVector<T, 2>, T) {
            let [s_x, s_y] = __kahan::components(state);
            let p_mu = &self.mu;
            let p_nu = &self.nu;
            let sum_1 = p_mu.clone() - p_nu.clone();
            let sum_2 = sum_1.clone() - __kahan::integer::<T>(1);
            let sum_3 = p_mu.clone() + p_nu.clone() * sum_2.clone();
            let c_10 = __kahan::integer::<T>(10);
            let product_4 = p_mu.clone() * (sum_2.clone() * c_10.clone());
            let c_100 = __kahan::integer::<T>(100);
            let product_5 = c_100.clone() * s_y.clone();
            let c_981 = __kahan::integer::<T>(981);
            let product_6 = c_100.clone() * s_x.clone();
            let product_7 = p_mu.clone() * c_981.clone();
            let product_8 = c_10.clone()
                * (p_mu.clone() * p_mu.clone() - c_10.clone() * s_x.clone());
            let product_9 = sum_3.clone() * c_100.clone();
            let c_1_100 = __kahan::ratio::<T>(1, 100);
            let product_10 = half_step.clone()
                * (half_step.clone() * (product_5.clone() - product_7.clone())
                    - product_8.clone()
                    + p_nu.clone()
                        * (product_6.clone()
                            + half_step.clone() * (product_5.clone() + c_981.clone())
                            - product_4.clone()));
            (
                __kahan::vector([
                    -((half_step.clone()
                        * (s_x.clone()
                            * (half_step.clone()
                                * (product_5.clone() + product_7.clone())
                                - product_8.clone()
                                + p_nu.clone()
                                    * (product_6.clone()
                                        + (product_5.clone() - c_981.clone()) * half_step.clone()
                                        - product_4.clone()))
                            - s_y.clone() * (sum_3.clone() * __kahan::integer::<T>(200)))
                        - s_x.clone() * product_9.clone()) * c_1_100.clone()
                        / sum_3.clone()),
                    c_1_100.clone()
                        * (s_y.clone() * (product_9.clone() + product_10.clone())
                            - sum_1.clone() * __kahan::integer::<T>(1962)
                                * (half_step.clone() * s_x.clone())) / sum_3.clone(),
                ]),
                -(c_1_100.clone() * (product_10.clone() - product_9.clone())
                    / sum_3.clone()),
            )
        }
    }
};
