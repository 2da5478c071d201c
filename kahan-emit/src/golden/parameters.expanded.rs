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
            let __t_y_times_100 = __kahan::integer::<T>(100) * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __t_mu_minus_nu_minus_one = __p_mu.clone() - __p_nu.clone()
                - __c_1.clone();
            let __sum_1 = __p_mu.clone()
                + __p_nu.clone() * __t_mu_minus_nu_minus_one.clone();
            let __t_ten_x = __kahan::integer::<T>(10) * __s_x.clone();
            __kahan::matrix([
                [__kahan::integer::<T>(0), __c_1],
                [
                    (__t_y_times_100.clone() - __c_981.clone() * __p_mu.clone()
                        + (__t_y_times_100 + __c_981) * __p_nu.clone())
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
    pub struct __Step;
    impl __kahan::Kernel<2, 8> for __Step {
        const COST: __kahan::StepCost = __kahan::StepCost::of(27, 1, 32);
        #[inline(always)]
        fn quotients<T: __kahan::Scalar>(
            __constants: &[__kahan::Padded<T>; 8],
            __state: [T; 2],
        ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
            let [__e_half_plus_half_nu, __e_constant_1, __e_constant_2, __e_eps,
            __e_nu_plus_one, __e_mu, __e_nu_minus_mu, __e_mu_minus_nu_times_981] = __constants;
            let [__s_x, __s_y] = __state;
            let __reciprocal_1 = __e_constant_2
                .get()
                .subtract_product(__e_half_plus_half_nu.get(), __s_x.clone())
                .subtract_product(__e_constant_1.get(), __s_y.clone())
                .reciprocal()?;
            let __t_nu_plus_one_y_times_100 = __e_nu_plus_one.get()
                * (__s_y.clone() * __kahan::integer::<T>(100));
            let __sum_1 = __t_nu_plus_one_y_times_100.clone()
                - __e_mu_minus_nu_times_981.get();
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            let __numerators = [
                __e_nu_minus_mu.get()
                    * (__kahan::integer::<T>(981)
                        .multiply_subtract(
                            __e_eps.get() * __s_x.clone(),
                            __t_nu_plus_one_y_times_100,
                        ) * __c_1_100.clone()),
                __c_1_100
                    * (__e_nu_minus_mu.get()
                        * (__e_mu.get()
                            * (__e_nu_plus_one.get()
                                * (__s_y.clone() * __kahan::integer::<T>(10))))
                        + (__s_x * __sum_1.clone() + __sum_1 * (__e_eps.get() * __s_y))),
            ];
            __kahan::over(__numerators, __reciprocal_1)
        }
    }
    pub struct __General;
    impl __kahan::Kernel<2, 7> for __General {
        const COST: __kahan::StepCost = __kahan::StepCost::of(31, 1, 41);
        #[inline(always)]
        fn quotients<T: __kahan::Scalar>(
            __constants: &[__kahan::Padded<T>; 7],
            __state: [T; 2],
        ) -> __kahan::Option<__kahan::Quotients<T, 2>> {
            let [__e_eps, __e_nu_plus_one, __e_eps_plus_eps_nu, __e_constant_1,
            __e_eps_nu_minus_eps_mu, __e_constant_2, __e_mu_minus_nu_times_981] = __constants;
            let [__s_x, __s_y] = __state;
            let __t_eps_x = __e_eps.get() * __s_x;
            let __c_100 = __kahan::integer::<T>(100);
            let __t_eps_y = __e_eps.get() * __s_y.clone();
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            let __reciprocal_1 = __kahan::integer::<T>(2)
                .quotient(
                    __e_constant_1
                        .get()
                        .subtract_product(
                            __e_nu_plus_one.get(),
                            __c_100.clone() * __t_eps_x.clone(),
                        )
                        .subtract_product(
                            __e_eps_plus_eps_nu.get(),
                            __c_100.clone() * __t_eps_y.clone(),
                        ) * __c_1_100.clone(),
                )?;
            let __c_981 = __kahan::integer::<T>(981);
            let __t_nu_plus_one_y_times_100 = __e_nu_plus_one.get() * (__c_100 * __s_y);
            let __t_ten_eps_y = __t_eps_y.clone() * __kahan::integer::<T>(10);
            let __numerators = [
                __c_1_100.clone()
                    * (__e_eps_nu_minus_eps_mu.get()
                        * __t_eps_x
                            .clone()
                            .multiply_subtract(
                                __c_981.clone(),
                                __t_nu_plus_one_y_times_100.clone(),
                            )),
                __c_1_100
                    * __e_eps_nu_minus_eps_mu
                        .get()
                        .multiply_add(
                            __t_eps_y * __c_981,
                            __t_ten_eps_y
                                .clone()
                                .multiply_add(
                                    __e_nu_plus_one
                                        .get()
                                        .multiply_subtract(__t_ten_eps_y, __e_constant_2.get()),
                                    __t_eps_x
                                        * (__t_nu_plus_one_y_times_100
                                            - __e_mu_minus_nu_times_981.get()),
                                ),
                        ),
            ];
            __kahan::over(__numerators, __reciprocal_1)
        }
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Pendulum<T> {
        type Prepared = __kahan::StepOverEps<__Step, __General, T, 8, 7>;
        #[inline(always)]
        fn prepare(&self, eps: &T) -> Self::Prepared {
            Self::Prepared::new(
                eps,
                || {
                    let __p_mu = &self.mu;
                    let __p_nu = &self.nu;
                    let __t_mu_times_1_over_20 = __kahan::ratio::<T>(1, 20)
                        * __p_mu.clone();
                    let __t_mu_nu = __p_mu.clone() * __p_nu.clone();
                    let __t_nu_squared = __p_nu.clone() * __p_nu.clone();
                    let __c_1_2 = __kahan::ratio::<T>(1, 2);
                    let __t_half_over_eps = __c_1_2.clone() / eps.clone();
                    let __c_981_200 = __kahan::ratio::<T>(981, 200);
                    let __t_nu_eps = __p_nu.clone() * eps.clone();
                    [
                        __c_1_2.clone() + __p_nu.clone() * __c_1_2.clone(),
                        __c_1_2.clone() * __t_nu_eps.clone() + __c_1_2 * eps.clone(),
                        __p_mu.clone() * __t_mu_times_1_over_20.clone()
                            - __p_nu.clone() * __t_mu_times_1_over_20.clone()
                            + (__c_981_200.clone() * (__p_mu.clone() * eps.clone())
                                + __p_mu.clone() * __t_half_over_eps.clone())
                            + (__t_mu_times_1_over_20.clone() * __t_mu_nu.clone()
                                - __t_mu_times_1_over_20 * __t_nu_squared.clone()
                                + (__t_mu_nu * __t_half_over_eps.clone()
                                    - __t_nu_squared * __t_half_over_eps.clone())
                                - (__c_981_200 * __t_nu_eps
                                    + __p_nu.clone() * __t_half_over_eps)),
                        eps.clone(),
                        __p_nu.clone() + __kahan::integer::<T>(1),
                        __p_mu.clone(),
                        __p_nu.clone() - __p_mu.clone(),
                        (__p_mu.clone() - __p_nu.clone()) * __kahan::integer::<T>(981),
                    ]
                },
                || {
                    let __p_mu = &self.mu;
                    let __p_nu = &self.nu;
                    let __t_eps_nu = eps.clone() * __p_nu.clone();
                    let __c_100 = __kahan::integer::<T>(100);
                    let __t_nu_times_100 = __p_nu.clone() * __c_100.clone();
                    let __c_10 = __kahan::integer::<T>(10);
                    let __t_eps_mu = eps.clone() * __p_mu.clone();
                    let __t_eps_mu_ten_nu = __t_eps_mu.clone()
                        * (__p_nu.clone() * __c_10.clone());
                    let __c_981 = __kahan::integer::<T>(981);
                    let __t_nu_mu = __p_nu.clone() * __p_mu.clone();
                    [
                        eps.clone(),
                        __p_nu.clone() + __kahan::integer::<T>(1),
                        eps.clone() + __t_eps_nu.clone(),
                        __c_981.clone() * (eps.clone() * __t_eps_mu.clone())
                            - __c_981.clone() * (eps.clone() * __t_eps_nu.clone())
                            - (__p_nu.clone() * __t_nu_times_100.clone()
                                + __t_eps_mu_ten_nu.clone())
                            + (__p_mu.clone() * __t_eps_mu_ten_nu.clone()
                                - __p_nu.clone() * __t_eps_mu_ten_nu
                                + (__c_100 * __p_mu.clone() - __t_nu_times_100.clone()
                                    + (__p_mu.clone() * __t_nu_times_100
                                        + __t_eps_mu.clone() * (__p_mu.clone() * __c_10)))),
                        __t_eps_nu - __t_eps_mu,
                        __p_mu.clone() * __p_mu.clone() - __t_nu_mu.clone()
                            + (__p_mu.clone() * __t_nu_mu.clone()
                                - __p_nu.clone() * __t_nu_mu),
                        __c_981 * (__p_mu.clone() - __p_nu.clone()),
                    ]
                },
            )
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
            let __t_y_times_100 = __c_100.clone() * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            -((eps.clone()
                * (eps.clone()
                    * (__t_y_times_100.clone() - __p_mu.clone() * __c_981.clone())
                    - __c_10.clone()
                        * (__p_mu.clone() * __p_mu.clone()
                            - __c_10.clone() * __s_x.clone())
                    + __p_nu.clone()
                        * (__c_100.clone() * __s_x.clone()
                            + (__t_y_times_100 + __c_981) * eps.clone()
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
            let __t_y_times_100 = __c_100.clone() * __s_y.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __t_x_times_100 = __c_100.clone() * __s_x.clone();
            let __t_mu_times_981 = __p_mu.clone() * __c_981.clone();
            let __product_2 = __c_10.clone()
                * (__p_mu.clone() * __p_mu.clone() - __c_10 * __s_x.clone());
            let __product_3 = __sum_1.clone() * __c_100;
            let __c_1_100 = __kahan::ratio::<T>(1, 100);
            let __product_4 = eps.clone()
                * (eps.clone() * (__t_y_times_100.clone() - __t_mu_times_981.clone())
                    - __product_2.clone()
                    + __p_nu.clone()
                        * (__t_x_times_100.clone()
                            + eps.clone() * (__t_y_times_100.clone() + __c_981.clone())
                            - __product_1.clone()));
            (
                __kahan::vector([
                    -((eps.clone()
                        * (__s_x.clone()
                            * (eps.clone() * (__t_y_times_100.clone() + __t_mu_times_981)
                                - __product_2
                                + __p_nu.clone()
                                    * (__t_x_times_100
                                        + (__t_y_times_100 - __c_981) * eps.clone() - __product_1))
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
            lift: impl __kahan::Fn(&T) -> U,
        ) -> Pendulum<U> {
            Pendulum {
                mu: lift(&self.mu),
                nu: lift(&self.nu),
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
            let __t_one_plus_nu = __kahan::integer::<T>(1) + __p_nu.clone();
            let __c_981 = __kahan::integer::<T>(981);
            let __t_eps_mu = eps.clone() * __p_mu.clone();
            let __product_1 = (__c_981.clone() * (eps.clone() * __p_nu.clone())
                - __c_981.clone() * __t_eps_mu.clone()
                + __t_one_plus_nu.clone()
                    * (__kahan::integer::<T>(100) * (__s_y.clone() * eps.clone())))
                * __kahan::ratio::<T>(1, 100);
            let __c_10 = __kahan::integer::<T>(10);
            let __t_ten_nu = __p_nu.clone() * __c_10.clone();
            let __t_nu_eps_mu = __p_nu.clone() * __t_eps_mu.clone();
            let __product_2 = (__p_mu.clone() * __c_10.clone() - __t_ten_nu.clone()
                + (__p_mu.clone() * __t_ten_nu.clone() + __p_mu.clone() * __t_eps_mu)
                + (__p_mu.clone() * __t_nu_eps_mu.clone()
                    - __p_nu.clone() * __t_nu_eps_mu.clone()
                    - (__p_nu.clone() * __t_ten_nu + __t_nu_eps_mu))
                - __t_one_plus_nu.clone()
                    * (__c_10.clone() * (__s_x.clone() * eps.clone())))
                * __kahan::ratio::<T>(1, 10);
            let __t_nu_mu = __p_nu.clone() * __p_mu.clone();
            let __product_3 = ((__p_mu.clone() * __p_mu.clone() - __t_nu_mu.clone()
                + (__p_mu.clone() * __t_nu_mu.clone() - __p_nu.clone() * __t_nu_mu)
                - __t_one_plus_nu.clone() * ((__s_x + __o_x) * __kahan::integer::<T>(5)))
                * (__s_dy.clone() * __c_10)
                - (__t_one_plus_nu * ((__s_y + __o_y) * __kahan::integer::<T>(50))
                    - __c_981 * (__p_mu - __p_nu)) * __s_dx.clone())
                * __kahan::ratio::<T>(1, 50);
            let __quotient_1 = eps
                .clone()
                .quotient(__product_2.clone() - eps.clone() * __product_1.clone())?;
            __kahan::Some(
                __kahan::vector([
                    __s_dx
                        - (eps * __product_3.clone() - __t_two_dy.clone() * __product_2)
                            * __quotient_1.clone(),
                    __s_dy + (__t_two_dy * __product_1 - __product_3) * __quotient_1,
                ]),
            )
        }
    }
    #[doc(hidden)]
    impl<T> __kahan::WithoutIntegrals for Pendulum<T> {}
    #[doc(hidden)]
    impl<T> __kahan::WithoutDensity for Pendulum<T> {}
    #[doc(hidden)]
    impl<T: __kahan::Integer> __kahan::IntegerParameters for Pendulum<T> {}
};
