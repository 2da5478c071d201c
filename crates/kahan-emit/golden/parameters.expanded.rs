/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the field
///
/// ```text
/// const g = 981/100
/// xdot = y
/// ydot = -g*x/(1 + nu) - (1/10)*mu*y + x*y/(mu - nu)
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
    use ::kahan_core::__private::{self as __kahan, arguments::*, Clone as _};
    impl<T> Pendulum<T> {
        /// The state variables, in order.
        pub const VARIABLES: [&'static __kahan::str; 2] = ["x", "y"];
        /// The parameters, in order.
        pub const PARAMETERS: [&'static __kahan::str; 2] = ["mu", "nu"];
    }
    impl<T> __kahan::Named for Pendulum<T> {
        fn parameters(&self) -> &'static [&'static __kahan::str] {
            &Self::PARAMETERS
        }
    }
    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 2> for Pendulum<T> {
        fn field(&self, x: &__kahan::SVector<T, 2>) -> __kahan::SVector<T, 2> {
            let [__s_x, __s_y] = __kahan::components(x);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __c_10 = __kahan::integer::<T>(10);
            let __c_1 = __kahan::integer::<T>(1);
            __kahan::vector([
                __s_y.clone(),
                (__s_y.clone()
                    * (__c_10.clone()
                        * (__c_10
                            * (__s_x.clone()
                                * (__c_1.clone() / (__p_mu.clone() - __p_nu.clone())))
                            - __p_mu.clone()))
                    - __kahan::integer::<T>(981)
                        * (__s_x.clone() * (__c_1.clone() / (__p_nu.clone() + __c_1))))
                    * __kahan::ratio::<T>(1, 100),
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
            let __reciprocal_1 = __c_1.clone() / (__p_mu.clone() - __p_nu.clone());
            __kahan::matrix([
                [__kahan::integer::<T>(0), __c_1.clone()],
                [
                    (__kahan::integer::<T>(100)
                        * (__s_y.clone() * __reciprocal_1.clone())
                        - __kahan::integer::<T>(981)
                            * (__c_1.clone() / (__p_nu.clone() + __c_1)))
                        * __kahan::ratio::<T>(1, 100),
                    (__kahan::integer::<T>(10) * (__reciprocal_1 * __s_x.clone())
                        - __p_mu.clone()) * __kahan::ratio::<T>(1, 10),
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
            __kahan::vector([
                __kahan::integer::<T>(0),
                (__s_x.clone() * __o_y.clone() + __s_y.clone() * __o_x.clone())
                    * __kahan::ratio::<T>(1, 2)
                    * (__kahan::integer::<T>(1) / (__p_mu.clone() - __p_nu.clone())),
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
            let __c_10 = __kahan::integer::<T>(10);
            let __c_1 = __kahan::integer::<T>(1);
            let __reciprocal_1 = __c_1.clone() / (__p_mu.clone() - __p_nu.clone());
            let __c_981 = __kahan::integer::<T>(981);
            let __reciprocal_2 = __c_1.clone() / (__p_nu.clone() + __c_1);
            __kahan::vector([
                (__s_y.clone() + __o_y.clone()) * __kahan::ratio::<T>(1, 2),
                ((__kahan::integer::<T>(100) * (__s_y.clone() * __reciprocal_1.clone())
                    - __c_981.clone() * __reciprocal_2.clone()) * __o_x.clone()
                    - (__c_981 * (__s_x.clone() * __reciprocal_2)
                        + __c_10.clone() * (__s_y.clone() * __p_mu.clone()))
                    + __o_y.clone()
                        * (__c_10.clone()
                            * (__c_10 * (__s_x.clone() * __reciprocal_1)
                                - __p_mu.clone()))) * __kahan::ratio::<T>(1, 200),
            ])
        }
    }
    pub struct __Step;
    impl __kahan::Kernel<2, 5> for __Step {
        const COST: __kahan::StepCost = __kahan::StepCost::of(27, 1, 37);
        #[inline(always)]
        fn quotients<T: __kahan::Scalar>(
            __constants: &[__kahan::Padded<T>; 5],
            __state: [T; 2],
        ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
            let [__e_eps, __e_constant_1, __e_constant_2, __e_ten_plus_eps_mu, __e_eps_mu,
            ] = __constants;
            let [__s_x, __s_y] = __state;
            let __t_eps_y = __e_eps.get() * __s_y.clone();
            let __sum_1 = __kahan::integer::<T>(100)
                .multiply_subtract(
                    __s_y.clone() * __e_constant_1.get(),
                    __e_constant_2.get(),
                );
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            let __product_1 = __sum_1.clone() * __c_1_100.clone();
            let __c_10 = __kahan::integer::<T>(10);
            let __product_2 = __e_constant_1
                .get()
                .multiply_subtract(
                    __c_10.clone() * __s_x.clone(),
                    __e_ten_plus_eps_mu.get(),
                ) * __kahan::ratio::<T>(1, 10);
            let __product_3 = __c_1_100
                * __sum_1.multiply_subtract(__s_x, __c_10 * (__s_y * __e_eps_mu.get()));
            let __reciprocal_1 = __kahan::integer::<T>(2)
                .quotient(
                    __e_eps.get().multiply_add(__product_1.clone(), __product_2.clone()),
                )?;
            __kahan::Some(
                __kahan::Quotients::over(
                    [
                        (__t_eps_y.clone() * __product_2)
                            .subtract_product(__e_eps.get(), __product_3.clone()),
                        -__t_eps_y.multiply_add(__product_1, __product_3),
                    ],
                    __reciprocal_1,
                ),
            )
        }
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Pendulum<T> {
        type Prepared = __kahan::StraightStep<__Step, T, 5>;
        #[inline(always)]
        fn prepare(&self, eps: &T) -> Self::Prepared {
            Self::Prepared::new({
                let __p_mu = &self.mu;
                let __p_nu = &self.nu;
                let __c_1 = __kahan::integer::<T>(1);
                let __t_eps_mu = eps.clone() * __p_mu.clone();
                [
                    eps.clone(),
                    eps.clone() * (__c_1.clone() / (__p_mu.clone() - __p_nu.clone())),
                    __kahan::integer::<T>(981)
                        * (eps.clone() * (__c_1.clone() / (__p_nu.clone() + __c_1))),
                    __kahan::integer::<T>(10) + __t_eps_mu.clone(),
                    __t_eps_mu,
                ]
            })
        }
        fn det_matrix(&self, x: &__kahan::SVector<T, 2>, eps: T) -> T {
            let [__s_x, __s_y] = __kahan::components(x);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __c_100 = __kahan::integer::<T>(100);
            let __c_1 = __kahan::integer::<T>(1);
            let __reciprocal_1 = __c_1.clone() / (__p_mu.clone() - __p_nu.clone());
            let __c_10 = __kahan::integer::<T>(10);
            -((eps.clone()
                * (__c_10.clone()
                    * (__c_10 * (__reciprocal_1.clone() * __s_x.clone())
                        - __p_mu.clone())
                    + (__c_100.clone() * (__s_y.clone() * __reciprocal_1)
                        - __kahan::integer::<T>(981)
                            * (__c_1.clone() / (__p_nu.clone() + __c_1))) * eps.clone())
                - __c_100) * __kahan::ratio::<T>(1, 100))
        }
        fn rational_map(
            &self,
            x: &__kahan::SVector<T, 2>,
            eps: T,
        ) -> (__kahan::SVector<T, 2>, T) {
            let [__s_x, __s_y] = __kahan::components(x);
            let __p_mu = &self.mu;
            let __p_nu = &self.nu;
            let __c_100 = __kahan::integer::<T>(100);
            let __c_1 = __kahan::integer::<T>(1);
            let __reciprocal_1 = __c_1.clone() / (__p_mu.clone() - __p_nu.clone());
            let __product_1 = __c_100.clone() * (__s_y.clone() * __reciprocal_1.clone());
            let __reciprocal_2 = __c_1.clone() / (__p_nu.clone() + __c_1);
            let __product_2 = __kahan::integer::<T>(981) * __reciprocal_2.clone();
            let __c_10 = __kahan::integer::<T>(10);
            let __product_3 = __c_10.clone()
                * (__c_10 * (__reciprocal_1 * __s_x.clone()) - __p_mu.clone());
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            let __sum_1 = __product_3.clone()
                + eps.clone() * (__product_1.clone() - __product_2.clone());
            (
                __kahan::vector([
                    -((eps.clone()
                        * (__s_x.clone()
                            * (__product_3 + (__product_1 + __product_2) * eps.clone())
                            - __s_y.clone() * __kahan::integer::<T>(200))
                        - __c_100.clone() * __s_x.clone()) * __c_1_100.clone()),
                    __c_1_100.clone()
                        * (__c_100.clone() * __s_y.clone()
                            + eps.clone()
                                * (__s_y.clone() * __sum_1.clone()
                                    - __kahan::integer::<T>(1962)
                                        * (__reciprocal_2 * __s_x.clone()))),
                ]),
                -(__c_1_100 * (eps.clone() * __sum_1 - __c_100)),
            )
        }
    }
    impl<T: __kahan::Scalar> __kahan::ExtendScalars<T, 2> for Pendulum<T> {
        type Extended<U: __kahan::Scalar> = Pendulum<U>;
        #[inline(always)]
        fn extend_scalars<U: __kahan::Scalar>(
            &self,
            convert: impl __kahan::Fn(&T) -> U,
        ) -> Pendulum<U> {
            Pendulum {
                mu: convert(&self.mu),
                nu: convert(&self.nu),
            }
        }
        #[inline(always)]
        fn carry_tangent(
            &self,
            eps: &T,
            x: &__kahan::SVector<T, 2>,
            y: &__kahan::SVector<T, 2>,
            v: &__kahan::SVector<T, 2>,
        ) -> __kahan::Option<__kahan::SVector<T, 2>> {
            let eps = eps.clone();
            let [__s_x, __s_y] = __kahan::components(x).clone();
            let [__o_x, __o_y] = __kahan::components(y).clone();
            let [__s_dx, __s_dy] = __kahan::components(v).clone();
            let __p_mu = self.mu.clone();
            let __p_nu = self.nu.clone();
            let __t_two_dy = __kahan::integer::<T>(2) * __s_dy.clone();
            let __reciprocal_1 = (__p_mu.clone() - __p_nu.clone()).reciprocal()?;
            let __product_1 = eps.clone() * __reciprocal_1.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __reciprocal_2 = (__p_nu + __kahan::integer::<T>(1)).reciprocal()?;
            let __product_2 = (__kahan::integer::<T>(100)
                * (__s_y.clone() * __product_1.clone())
                - __c_981.clone() * (eps.clone() * __reciprocal_2.clone()))
                * __kahan::ratio::<T>(1, 100);
            let __c_10 = __kahan::integer::<T>(10);
            let __product_3 = (__product_1 * (__s_x.clone() * __c_10.clone())
                - (__c_10.clone() + eps.clone() * __p_mu.clone()))
                * __kahan::ratio::<T>(1, 10);
            let __c_50 = __kahan::integer::<T>(50);
            let __product_4 = (__s_dy.clone() * __c_50.clone()
                * ((__s_x + __o_x) * __reciprocal_1.clone())
                - __c_10 * (__s_dy.clone() * __p_mu)
                + (__reciprocal_1 * ((__s_y + __o_y) * __c_50)
                    - __c_981 * __reciprocal_2) * __s_dx.clone())
                * __kahan::ratio::<T>(1, 50);
            let __quotient_1 = eps
                .clone()
                .quotient(__product_3.clone() + eps.clone() * __product_2.clone())?;
            __kahan::Some(
                __kahan::vector([
                    __s_dx
                        + (__t_two_dy.clone() * __product_3 - eps * __product_4.clone())
                            * __quotient_1.clone(),
                    __s_dy - (__t_two_dy * __product_2 + __product_4) * __quotient_1,
                ]),
            )
        }
    }
    #[doc(hidden)]
    impl<T> __kahan::WithoutIntegrals for Pendulum<T> {}
    #[doc(hidden)]
    impl<T> __kahan::WithoutDensity for Pendulum<T> {}
    #[doc(hidden)]
    impl<T: __kahan::PrimInt> __kahan::IntegerParameters for Pendulum<T> {}
};
