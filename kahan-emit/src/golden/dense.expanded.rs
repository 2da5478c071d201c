/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the field
///
/// ```text
/// xdot = 1/7*b - 1/6*x*z + 3*b*x + 3/2*y*u - y*w + 4/3*a*y + 1/3*a*z + u^2 - 2/3*u*w + 3/2*a*u
///     + 2/3*v^2 + 9/4*b*v + 7/5*a*w + 1/6*b*x^2 + 7*c*x*y - 2*b*x*u + 2*c*x*v + 7*a*x*w
///     - 5/6*a*y^2 + a*y*z - 2/5*c*y*v - 5/2*a*z^2 - b*z*u + a*z*v - 1/3*a*z*w + 1/2*a*u*v
///     + 2*b*v*w + 2/3*c*w^2
/// ydot = 1/7*a + 1/4*b*x + 3/4*c*y + 3/5*b*z - 2*u*v + 4/3*c*u + 3/2*b*v + 5/4*b*w - 5/6*a*x^2
///     - a*x*y + 4/3*b*x*z + 7/3*c*x*u - 3/5*b*x*v + c*x*w - 3/2*b*y^2 + 7/5*b*y*z - 2/3*b*y*u
///     + 7*b*y*v + 2/3*a*y*w - 1/2*a*z^2 + 1/4*a*z*u - 5*c*z*v - 5/2*b*z*w + 1/4*c*u^2 + 4/3*a*u*w
///     - 1/3*a*v^2 + 3*a*v*w + a*w^2
/// zdot = 1/7*b - x*v + 2/3*a*x + 1/4*a*y + 3*a*z + 1/6*u*v + 2/3*a*u + 4*c*v + 1/4*b*w
///     - 3/4*a*x^2 + 4/3*a*x*y - 3/4*b*x*z + 7/5*b*x*u + 1/3*b*x*w + 4/3*b*y^2 + 1/3*a*y*z
///     - 5/4*b*y*u + 1/3*b*y*v + 4/3*b*y*w + 2/3*b*z^2 + a*z*u + 4/3*b*z*v + 7/2*a*z*w - 1/3*c*u^2
///     + 3/2*c*u*w + 1/5*b*v^2 - 5/2*a*v*w + 4/5*a*w^2
/// udot = 1/7*c + 1/2*x^2 + 1/4*x*u + 7/3*x*v + 5/4*b*x + 3/4*a*y - 1/2*z^2 + 1/3*z*u + 1/3*c*z
///     + 4*b*u + 1/2*b*v + 1/4*c*w - 1/2*b*x*y - 5/3*c*x*z + 7/5*b*x*w - b*y^2 + 1/3*a*y*z
///     + 3/4*b*y*u + 2*a*y*v + 3/5*c*y*w + 3*b*z*v + 7/2*b*z*w + 3/4*c*u^2 - 1/4*b*u*v + 2/3*c*u*w
///     + 3/2*b*v^2 + 1/4*b*v*w + 3*b*w^2
/// vdot = 1/7*b + 7/6*x*v + 7/5*c*x + 1/6*y*z - 2*y*v + c*y + 4/3*a*z + 1/4*u^2 + 1/3*a*u + b*v
///     + 1/2*c*w + 1/2*c*x^2 - 5/2*c*x*y + 1/2*b*x*z + 1/4*c*x*u - 5/2*b*x*w + 1/5*b*y^2
///     + 4/3*b*y*u + 1/5*c*y*w - 1/2*a*z^2 - 5/4*c*z*u + c*z*v + 1/2*a*z*w + c*u*v + 1/6*c*u*w
///     + 1/2*a*v^2 + 2/3*c*v*w + 2/5*a*w^2
/// wdot = 1/7*c - 5*x^2 - 1/5*x*y + 3/2*x*v - x*w + 2*c*x + 1/2*y^2 + y*z - 5/4*y*v + 4*b*y
///     + 2*b*z + 2/5*a*u + 3/2*b*v - 3/5*w^2 + 1/2*b*w - 2/3*c*x*z - a*x*u + 3/5*a*y*u + 1/3*c*y*w
///     + 4/3*b*z^2 - 5/2*b*z*u - 2/5*b*z*v + 7/5*a*z*w + a*u^2 + 1/3*a*u*v - 1/3*c*u*w + 3/2*a*v^2
///     - 5/6*b*v*w
/// ```
/// The map solves A(x,ε)·x̃ = b(x,ε): its closed form exceeds the budget of terms. Where det A = 0 it counts as a pole.
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Dense<T> {
    /// The parameter `a`.
    pub a: T,
    /// The parameter `b`.
    pub b: T,
    /// The parameter `c`.
    pub c: T,
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
    impl<T> Dense<T> {
        /// The state variables, in order.
        pub const VARIABLES: [&'static __kahan::core::primitive::str; 6] = [
            "x",
            "y",
            "z",
            "u",
            "v",
            "w",
        ];
        /// The parameters, in order.
        pub const PARAMETERS: [&'static __kahan::core::primitive::str; 3] = [
            "a",
            "b",
            "c",
        ];
    }
    impl<T> __kahan::Named for Dense<T> {
        fn variables(&self) -> &'static [&'static __kahan::core::primitive::str] {
            &Self::VARIABLES
        }
        fn parameters(&self) -> &'static [&'static __kahan::core::primitive::str] {
            &Self::PARAMETERS
        }
    }
    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 6> for Dense<T> {
        fn field(&self, x: &__kahan::SVector<T, 6>) -> __kahan::SVector<T, 6> {
            let [__s_x, __s_y, __s_z, __s_u, __s_v, __s_w] = __kahan::components(x);
            let __p_a = &self.a;
            let __p_b = &self.b;
            let __p_c = &self.c;
            let __c_6 = __kahan::integer::<T>(6);
            let __t_six_y = __c_6.clone() * __s_y.clone();
            let __c_15 = __kahan::integer::<T>(15);
            let __t_six_v = __c_6.clone() * __s_v.clone();
            let __c_2 = __kahan::integer::<T>(2);
            let __c_5 = __kahan::integer::<T>(5);
            let __t_five_x = __c_5.clone() * __s_x.clone();
            let __c_1 = __kahan::integer::<T>(1);
            let __c_42 = __kahan::integer::<T>(42);
            let __c_3 = __kahan::integer::<T>(3);
            let __c_8 = __kahan::integer::<T>(8);
            let __c_14 = __kahan::integer::<T>(14);
            let __c_12 = __kahan::integer::<T>(12);
            let __c_18 = __kahan::integer::<T>(18);
            let __t_eight_w = __s_w.clone() * __c_8.clone();
            let __c_9 = __kahan::integer::<T>(9);
            let __c_7 = __kahan::integer::<T>(7);
            let __t_z_u = __s_z.clone() * __s_u.clone();
            let __c_4 = __kahan::integer::<T>(4);
            let __c_21 = __kahan::integer::<T>(21);
            let __t_w_squared = __s_w.clone() * __s_w.clone();
            let __t_nine_y = __s_y.clone() * __c_9.clone();
            let __t_six_u = __c_6.clone() * __s_u.clone();
            let __t_v_squared = __s_v.clone() * __s_v.clone();
            let __c_1_420 = __kahan::ratio::<T>(1, 420);
            let __c_40 = __kahan::integer::<T>(40);
            let __c_75 = __kahan::integer::<T>(75);
            let __t_six_x = __c_6.clone() * __s_x.clone();
            let __t_four_u = __s_u.clone() * __c_4.clone();
            let __t_five_w = __s_w.clone() * __c_5.clone();
            let __t_two_y = __s_y.clone() * __c_2.clone();
            let __t_three_w = __s_w.clone() * __c_3.clone();
            let __c_28 = __kahan::integer::<T>(28);
            let __t_seven_v_squared = __c_7.clone() * __t_v_squared.clone();
            let __t_three_u = __c_3.clone() * __s_u.clone();
            let __c_16 = __kahan::integer::<T>(16);
            let __c_20 = __kahan::integer::<T>(20);
            let __t_three_y = __s_y.clone() * __c_3.clone();
            let __c_24 = __kahan::integer::<T>(24);
            let __t_n16_y = __s_y.clone() * __c_16.clone();
            let __t_n15_u = __c_15.clone() * __s_u.clone();
            let __c_35 = __kahan::integer::<T>(35);
            let __t_nine_x = __s_x.clone() * __c_9.clone();
            let __c_10 = __kahan::integer::<T>(10);
            let __t_two_u = __c_2.clone() * __s_u.clone();
            let __t_n24_v = __s_v.clone() * __c_24.clone();
            let __t_n12_z = __s_z.clone() * __c_12.clone();
            let __t_four_y = __s_y.clone() * __c_4.clone();
            let __t_u_squared = __s_u.clone() * __s_u.clone();
            let __t_three_z = __s_z.clone() * __c_3.clone();
            let __t_five_u = __c_5.clone() * __s_u.clone();
            let __c_50 = __kahan::integer::<T>(50);
            let __t_n15_v_squared = __c_15.clone() * __t_v_squared.clone();
            let __t_five_v = __s_v.clone() * __c_5.clone();
            let __t_n15_v = __c_15.clone() * __s_v.clone();
            __kahan::vector([
                (__c_14.clone()
                    * (__c_2.clone()
                        * (__c_5.clone()
                            * (__c_21.clone() * (__s_y.clone() * __s_x.clone())
                                + __c_2.clone() * __t_w_squared.clone())
                            + __s_v.clone()
                                * (__c_6.clone() * (__t_five_x.clone() - __s_y.clone())))
                        * __p_c.clone()
                        - __c_5.clone()
                            * (__s_z.clone() * __s_x.clone()
                                + __c_6.clone() * (__s_y.clone() * __s_w.clone())
                                - __c_4.clone() * __t_v_squared
                                + __s_u.clone()
                                    * (__s_w.clone() * __c_4.clone()
                                        - (__t_nine_y.clone() + __t_six_u.clone()))))
                    + __c_5.clone()
                        * (__s_x.clone()
                            * (__c_14.clone()
                                * (__s_x.clone() - __s_u.clone() * __c_12.clone()
                                    + __c_18.clone()))
                            - __c_3.clone()
                                * ((__c_7.clone() * __t_z_u.clone() - __c_1.clone())
                                    * __c_4.clone()
                                    - __s_v.clone()
                                        * ((__t_eight_w.clone() + __c_9.clone()) * __c_7.clone())))
                        * __p_b.clone()
                    + (__s_w.clone()
                        * ((__t_five_x.clone() + __c_1.clone()) * __c_42.clone())
                        - __c_5.clone()
                            * (__s_y.clone()
                                * (__s_y.clone() * __c_5.clone() - __c_8.clone())
                                - __c_3.clone() * (__s_v.clone() + __c_3.clone())
                                    * __s_u.clone())
                        + __s_z.clone()
                            * ((__t_six_y.clone() - __c_15.clone() * __s_z.clone()
                                + __t_six_v.clone() - __c_2.clone() * __s_w.clone()
                                + __c_2.clone()) * __c_5.clone())) * __c_14.clone()
                        * __p_a.clone()) * __c_1_420.clone(),
                -(__c_1_420.clone()
                    * (__c_5.clone()
                        * (__p_a.clone()
                            * (__c_2.clone()
                                * (__c_2.clone()
                                    * (__t_seven_v_squared.clone() - __c_3.clone())
                                    + __s_x.clone()
                                        * (__c_7.clone()
                                            * (__t_five_x.clone() + __t_six_y.clone())))
                                + __s_z.clone()
                                    * (__c_21.clone()
                                        * (__s_z.clone() * __c_2.clone() - __s_u.clone()))
                                - __s_w.clone()
                                    * ((__t_two_y.clone() + __t_four_u.clone()
                                        + __s_v.clone() * __c_9.clone() + __t_three_w.clone())
                                        * __c_28.clone()))
                            - __c_7.clone()
                                * (__p_c.clone()
                                    * (__c_3.clone()
                                        * (__c_4.clone() * (__s_w.clone() * __s_x.clone())
                                            - __c_20.clone() * (__s_z.clone() * __s_v.clone())
                                            + __t_three_y.clone())
                                        + __s_u.clone()
                                            * (__s_x.clone() * __c_28.clone() + __t_three_u.clone()
                                                + __c_16.clone()))
                                    - __c_24 * (__s_v.clone() * __s_u.clone())))
                        - __p_b.clone()
                            * (__c_7.clone()
                                * (__s_z.clone()
                                    * (__c_2.clone()
                                        * (__s_x.clone() * __c_40.clone() + __s_y.clone() * __c_42
                                            - __s_w.clone() * __c_75.clone() + __c_18.clone()))
                                    - (__c_5.clone()
                                        * (__s_y.clone()
                                            * (__c_2.clone() * (__t_nine_y.clone() + __t_four_u))
                                            - __c_3.clone() * (__s_x.clone() + __t_five_w.clone()))
                                        + __s_v.clone()
                                            * (__c_6.clone()
                                                * (__t_six_x.clone()
                                                    - __s_y.clone() * __kahan::integer::<T>(70)
                                                    - __c_15.clone()))))))),
                -(__c_1_420.clone()
                    * (__c_7.clone()
                        * (__c_10.clone()
                            * (__s_v.clone() * (__t_six_x.clone() - __s_u.clone())
                                + __p_c.clone()
                                    * (__s_u.clone()
                                        * (__t_two_u.clone() - __s_w.clone() * __c_9.clone())
                                        - __t_n24_v.clone()))
                            + __p_a.clone()
                                * (__s_w.clone()
                                    * (__c_6.clone()
                                        * (__s_v.clone() * __kahan::integer::<T>(25) - __t_eight_w))
                                    - __c_5.clone()
                                        * (__t_three_y.clone() + __s_u.clone() * __c_8.clone())
                                    + __s_x.clone()
                                        * (__c_5.clone()
                                            * (__t_nine_x.clone() - __t_n16_y.clone() - __c_8.clone()))
                                    - __s_z.clone()
                                        * ((__t_two_y.clone() + __t_six_u
                                            + __s_w.clone() * __c_21.clone() + __c_18)
                                            * __c_10.clone())))
                        + __p_b.clone()
                            * (__s_z.clone()
                                * (__c_35.clone()
                                    * (__t_nine_x - __s_z.clone() * __c_8.clone()
                                        - __s_v.clone() * __c_16.clone()))
                                - (__c_12.clone()
                                    * (__kahan::integer::<T>(49)
                                        * (__s_x.clone() * __s_u.clone()) + __t_seven_v_squared
                                        + __c_5.clone())
                                    + __s_w.clone()
                                        * (__c_35.clone()
                                            * (__s_x.clone() * __c_4.clone() + __c_3.clone())))
                                - __s_y.clone()
                                    * ((__t_n16_y - __t_n15_u.clone()
                                        + __s_v.clone() * __c_4.clone()
                                        + __s_w.clone() * __c_16.clone()) * __c_35.clone())))),
                -(__c_1_420.clone()
                    * (__p_c.clone()
                        * (__c_5.clone()
                            * (__s_z.clone()
                                * (__c_28.clone() * (__t_five_x.clone() - __c_1.clone()))
                                - __c_3.clone()
                                    * (__c_21.clone() * __t_u_squared.clone() + __c_4.clone()))
                            - __s_w.clone()
                                * (__c_7.clone()
                                    * (__s_y.clone() * __kahan::integer::<T>(36)
                                        + __s_u.clone() * __c_40.clone() + __c_15.clone())))
                        - __c_35.clone()
                            * (__s_x.clone()
                                * (__t_six_x + __t_three_u.clone()
                                    + __s_v.clone() * __c_28.clone())
                                - __s_z.clone()
                                    * (__c_2.clone() * (__t_three_z.clone() - __t_two_u))
                                + __p_a.clone()
                                    * (__s_y.clone()
                                        * (__s_z.clone() * __c_4.clone() + __t_n24_v + __c_9)))
                        + __p_b.clone()
                            * (__c_21
                                * (__c_5.clone()
                                    * (__s_y.clone()
                                        * (__c_2.clone() * __s_x.clone() + __t_four_y.clone()
                                            - __t_three_u) - (__t_five_x + __s_u.clone() * __c_16))
                                    - __s_w.clone()
                                        * (__c_2.clone()
                                            * (__s_x.clone() * __c_14.clone()
                                                + __s_z.clone() * __c_35.clone()
                                                + __s_w.clone() * __kahan::integer::<T>(30)))
                                    - __s_v.clone()
                                        * (__c_5.clone()
                                            * (__t_n12_z.clone() - __s_u.clone() + __t_six_v
                                                + __s_w.clone() + __c_2.clone())))))),
                __c_1_420.clone()
                    * (__p_b.clone()
                        * (__c_2.clone()
                            * (__c_15.clone()
                                * (__c_2.clone() * (__s_v.clone() * __c_7.clone() + __c_1)
                                    + __s_x.clone()
                                        * (__c_7.clone() * (__s_z.clone() - __t_five_w)))
                                + __s_y.clone()
                                    * (__c_14.clone()
                                        * (__t_three_y + __s_u.clone() * __c_20.clone()))))
                        - __c_7.clone()
                            * (__p_a.clone()
                                * (__c_2.clone()
                                    * (__s_z.clone()
                                        * (__c_5.clone()
                                            * (__t_three_z - __t_three_w - __c_8.clone()))
                                        - (__t_n15_v_squared.clone()
                                            + __c_12.clone() * __t_w_squared.clone()
                                            + __s_u.clone() * __c_10.clone())))
                                - __c_5.clone()
                                    * (__c_2.clone() * (__s_y.clone() * __s_z.clone())
                                        + __c_3.clone() * __t_u_squared
                                        + __s_v.clone()
                                            * (__c_2.clone()
                                                * (__s_x.clone() * __c_7.clone()
                                                    - __s_y.clone() * __c_12.clone()))))
                        + __p_c.clone()
                            * (__c_7.clone()
                                * (__c_3.clone()
                                    * (__s_x.clone()
                                        * (__s_x.clone() * __c_10.clone()
                                            - __s_y.clone() * __c_50.clone() + __t_five_u.clone()
                                            + __c_28)
                                        - __c_5.clone()
                                            * (__c_5.clone() * __t_z_u - __t_four_y
                                                - __s_v.clone()
                                                    * (__c_4.clone() * (__s_z.clone() + __s_u.clone()))))
                                    + __s_w.clone()
                                        * (__c_2.clone()
                                            * (__t_six_y.clone() + __t_five_u
                                                + __s_v.clone() * __c_20.clone() + __c_15.clone()))))),
                -(__c_1_420
                    * (__c_4.clone()
                        * (__t_w_squared * __kahan::integer::<T>(63)
                            + __p_c.clone()
                                * (__c_5.clone()
                                    * (__c_7 * (__s_w.clone() * __s_u.clone())
                                        - __c_3.clone())))
                        - __s_y.clone()
                            * (__c_35
                                * (__c_4 * (__s_w.clone() * __p_c.clone()) + __t_six_y
                                    + __t_n12_z - __t_n15_v.clone()))
                        + __s_x.clone()
                            * (__c_14.clone()
                                * (__c_3.clone()
                                    * (__s_x.clone() * __c_50 + __t_two_y - __t_n15_v
                                        + __s_w.clone() * __c_10)
                                    + __p_c.clone()
                                        * (__c_20 * (__s_z.clone() - __c_3.clone()))))
                        + __p_a.clone()
                            * (__c_14.clone()
                                * (__s_u.clone()
                                    * (__c_2
                                        * (__c_15 * __s_x.clone() - __t_nine_y - __t_n15_u
                                            - __t_five_v.clone() - __c_6))
                                    - __c_3.clone()
                                        * (__c_14.clone() * (__s_z.clone() * __s_w.clone())
                                            + __t_n15_v_squared)))
                        - __p_b.clone()
                            * (__c_14
                                * (__s_z.clone()
                                    * (__s_z.clone() * __c_40 - __s_u.clone() * __c_75
                                        - __s_v.clone() * __c_12 + __kahan::integer::<T>(60))
                                    - __c_5
                                        * (__s_w.clone() * (__t_five_v - __c_3.clone())
                                            - __c_3.clone()
                                                * (__s_y.clone() * __c_8 + __s_v.clone() * __c_3)))))),
            ])
        }
        fn field_jacobian(
            &self,
            x: &__kahan::SVector<T, 6>,
        ) -> __kahan::SMatrix<T, 6, 6> {
            let [__s_x, __s_y, __s_z, __s_u, __s_v, __s_w] = __kahan::components(x);
            let __p_a = &self.a;
            let __p_b = &self.b;
            let __p_c = &self.c;
            let __c_1 = __kahan::integer::<T>(1);
            let __c_6 = __kahan::integer::<T>(6);
            let __t_six_u = __c_6.clone() * __s_u.clone();
            let __c_9 = __kahan::integer::<T>(9);
            let __c_2 = __kahan::integer::<T>(2);
            let __c_7 = __kahan::integer::<T>(7);
            let __t_two_v = __c_2.clone() * __s_v.clone();
            let __c_42 = __kahan::integer::<T>(42);
            let __t_w_a = __s_w.clone() * __p_a.clone();
            let __c_1_6 = __kahan::ratio::<T>(1, 6);
            let __c_5 = __kahan::integer::<T>(5);
            let __t_five_y = __s_y.clone() * __c_5.clone();
            let __c_3 = __kahan::integer::<T>(3);
            let __t_three_z = __s_z.clone() * __c_3.clone();
            let __c_4 = __kahan::integer::<T>(4);
            let __c_10 = __kahan::integer::<T>(10);
            let __c_35 = __kahan::integer::<T>(35);
            let __t_three_u = __s_u.clone() * __c_3.clone();
            let __t_two_w = __c_2.clone() * __s_w.clone();
            let __c_1_30 = __kahan::ratio::<T>(1, 30);
            let __t_three_y = __s_y.clone() * __c_3.clone();
            let __c_15 = __kahan::integer::<T>(15);
            let __t_n15_z = __s_z.clone() * __c_15.clone();
            let __t_three_v = __s_v.clone() * __c_3.clone();
            let __t_two_x = __s_x.clone() * __c_2.clone();
            let __t_nine_y = __c_9.clone() * __s_y.clone();
            let __c_12 = __kahan::integer::<T>(12);
            let __t_four_w = __s_w.clone() * __c_4.clone();
            let __t_five_x = __s_x.clone() * __c_5.clone();
            let __c_24 = __kahan::integer::<T>(24);
            let __c_8 = __kahan::integer::<T>(8);
            let __t_eight_w = __s_w.clone() * __c_8.clone();
            let __t_two_z = __c_2.clone() * __s_z.clone();
            let __c_1_60 = __kahan::ratio::<T>(1, 60);
            let __c_105 = __kahan::integer::<T>(105);
            let __t_five_z = __s_z.clone() * __c_5.clone();
            let __c_21 = __kahan::integer::<T>(21);
            let __t_c_w = __p_c.clone() * __s_w.clone();
            let __t_two_u = __s_u.clone() * __c_2.clone();
            let __t_n80_z = __s_z.clone() * __kahan::integer::<T>(80);
            let __c_36 = __kahan::integer::<T>(36);
            let __t_three_w = __s_w.clone() * __c_3.clone();
            let __c_20 = __kahan::integer::<T>(20);
            let __c_45 = __kahan::integer::<T>(45);
            let __t_ten_u = __s_u.clone() * __c_10.clone();
            let __t_three_x = __s_x.clone() * __c_3.clone();
            let __c_40 = __kahan::integer::<T>(40);
            let __c_75 = __kahan::integer::<T>(75);
            let __c_18 = __kahan::integer::<T>(18);
            let __t_four_z = __s_z.clone() * __c_4.clone();
            let __c_16 = __kahan::integer::<T>(16);
            let __t_n16_w = __s_w.clone() * __c_16.clone();
            let __t_b_y = __p_b.clone() * __s_y.clone();
            let __c_1_12 = __kahan::ratio::<T>(1, 12);
            let __t_six_x = __s_x.clone() * __c_6.clone();
            let __c_70 = __kahan::integer::<T>(70);
            let __t_nine_w = __c_9.clone() * __s_w.clone();
            let __t_c_z = __p_c.clone() * __s_z.clone();
            let __t_two_y = __c_2.clone() * __s_y.clone();
            let __t_four_u = __s_u.clone() * __c_4.clone();
            let __t_nine_v = __c_9.clone() * __s_v.clone();
            let __t_six_w = __c_6.clone() * __s_w.clone();
            let __t_x_c = __s_x.clone() * __p_c.clone();
            let __t_nine_x = __s_x.clone() * __c_9.clone();
            let __t_eight_y = __s_y.clone() * __c_8.clone();
            let __t_six_v = __c_6.clone() * __s_v.clone();
            let __t_four_v = __s_v.clone() * __c_4.clone();
            let __c_28 = __kahan::integer::<T>(28);
            let __t_n28_x = __s_x.clone() * __c_28.clone();
            let __c_25 = __kahan::integer::<T>(25);
            let __t_n12_x = __s_x.clone() * __c_12.clone();
            let __t_y_a = __s_y.clone() * __p_a.clone();
            let __t_n12_z = __s_z.clone() * __c_12.clone();
            let __t_n12_v = __s_v.clone() * __c_12.clone();
            let __t_seven_x = __s_x.clone() * __c_7.clone();
            let __t_five_v = __s_v.clone() * __c_5.clone();
            let __t_five_u = __s_u.clone() * __c_5.clone();
            let __t_x_b = __s_x.clone() * __p_b.clone();
            let __t_u_a = __s_u.clone() * __p_a.clone();
            let __c_60 = __kahan::integer::<T>(60);
            __kahan::matrix([
                [
                    (__c_42.clone() * __t_w_a.clone() - __s_z.clone()
                        + __c_6.clone()
                            * (__c_7.clone() * __s_y.clone() + __t_two_v.clone())
                            * __p_c.clone()
                        + (__s_x.clone() - __t_six_u.clone() + __c_9.clone())
                            * __c_2.clone() * __p_b.clone()) * __c_1_6.clone(),
                    (__c_3.clone()
                        * (__c_5.clone() * (__t_three_u.clone() - __t_two_w.clone())
                            + __p_c.clone()
                                * (__c_2.clone()
                                    * (__s_x.clone() * __c_35.clone() - __t_two_v.clone())))
                        - __p_a.clone()
                            * ((__t_five_y.clone() - __t_three_z.clone() - __c_4.clone())
                                * __c_10.clone())) * __c_1_30.clone(),
                    __c_1_6.clone()
                        * (__p_a.clone()
                            * (__c_2.clone()
                                * (__t_three_y.clone() - __t_n15_z.clone()
                                    + __t_three_v.clone() - __s_w.clone() + __c_1.clone()))
                            - (__c_6.clone() * (__s_u.clone() * __p_b.clone())
                                + __s_x.clone())),
                    -(__c_1_6.clone()
                        * (__p_b.clone()
                            * (__c_6.clone() * (__t_two_x.clone() + __s_z.clone()))
                            - (__t_nine_y.clone() + __s_u.clone() * __c_12.clone()
                                - __t_four_w.clone()
                                + __p_a.clone()
                                    * (__c_3.clone() * (__s_v.clone() + __c_3.clone()))))),
                    (__c_5.clone()
                        * (__c_2.clone()
                            * (__s_v.clone() * __c_8.clone()
                                + __p_a.clone()
                                    * (__c_3.clone() * (__t_two_z.clone() + __s_u.clone())))
                            + __p_b.clone()
                                * (__c_3.clone() * (__t_eight_w.clone() + __c_9.clone())))
                        + __p_c.clone()
                            * ((__t_five_x.clone() - __s_y.clone()) * __c_24.clone()))
                        * __c_1_60.clone(),
                    (__c_5.clone()
                        * (__c_6.clone() * (__p_b.clone() * __s_v.clone())
                            + __c_4.clone() * __t_c_w.clone() - __t_three_y.clone()
                            - __t_two_u.clone())
                        + __p_a.clone()
                            * (__s_x.clone() * __c_105.clone() - __t_five_z.clone()
                                + __c_21.clone())) * __kahan::ratio::<T>(1, 15),
                ],
                [
                    -(__c_1_60.clone()
                        * ((__p_a.clone() * (__t_five_x.clone() + __t_three_y.clone())
                            - __p_c.clone()
                                * (__s_u.clone() * __c_7.clone() + __t_three_w.clone()))
                            * __c_20.clone()
                            - __p_b.clone()
                                * (__t_n80_z.clone() - __s_v.clone() * __c_36.clone()
                                    + __c_15.clone()))),
                    -(__c_1_60.clone()
                        * (__c_5.clone()
                            * (__p_a.clone()
                                * (__c_4.clone()
                                    * (__t_three_x.clone() - __t_two_w.clone()))
                                - __c_9.clone() * __p_c.clone())
                            + __p_b.clone()
                                * (__c_4.clone()
                                    * (__s_y.clone() * __c_45.clone()
                                        - __s_z.clone() * __c_21.clone() + __t_ten_u.clone()
                                        - __s_v.clone() * __c_105)))),
                    __c_1_60.clone()
                        * (__p_b.clone()
                            * (__c_2.clone()
                                * (__s_x.clone() * __c_40.clone() + __s_y.clone() * __c_42
                                    - __s_w.clone() * __c_75.clone() + __c_18.clone()))
                            - __c_15.clone()
                                * (__c_20.clone() * (__s_v.clone() * __p_c.clone())
                                    + __p_a.clone() * (__t_four_z.clone() - __s_u.clone()))),
                    (__p_a.clone() * (__t_three_z.clone() + __t_n16_w.clone())
                        - __c_8.clone() * (__t_b_y.clone() + __t_three_v)
                        + __p_c.clone()
                            * (__c_2.clone()
                                * (__s_x.clone() * __kahan::integer::<T>(14)
                                    + __t_three_u.clone() + __c_8.clone()))) * __c_1_12.clone(),
                    -(__c_1_30.clone()
                        * (__c_10.clone()
                            * (__c_3.clone()
                                * (__c_5.clone() * __t_c_z.clone() + __t_two_u)
                                + __p_a.clone() * (__t_two_v - __t_nine_w.clone()))
                            + __p_b.clone()
                                * (__c_3.clone()
                                    * (__t_six_x.clone() - __s_y.clone() * __c_70.clone()
                                        - __c_15.clone())))),
                    __c_1_12.clone()
                        * (__c_3.clone()
                            * (__c_4.clone() * __t_x_c.clone()
                                - __p_b.clone()
                                    * (__c_5.clone() * (__t_two_z - __c_1.clone())))
                            + __p_a.clone()
                                * (__c_4.clone()
                                    * (__t_two_y.clone() + __t_four_u.clone()
                                        + __t_nine_v.clone() + __t_six_w.clone()))),
                ],
                [
                    -(__c_1_60.clone()
                        * (__c_10.clone()
                            * (__t_six_v.clone()
                                + __p_a.clone()
                                    * (__t_nine_x.clone() - __t_eight_y.clone()
                                        - __c_4.clone()))
                            + __p_b.clone()
                                * (__s_z.clone() * __c_45.clone()
                                    - __s_u.clone() * __kahan::integer::<T>(84)
                                    - __s_w.clone() * __c_20.clone()))),
                    __c_1_12.clone()
                        * (__p_a.clone()
                            * (__s_x.clone() * __c_16.clone() + __t_four_z.clone()
                                + __c_3.clone())
                            + __p_b.clone()
                                * (__s_y.clone() * __kahan::integer::<T>(32)
                                    - __s_u.clone() * __c_15.clone() + __t_four_v.clone()
                                    + __t_n16_w.clone())),
                    -(__c_1_12.clone()
                        * (__p_b.clone()
                            * (__t_nine_x - __s_z.clone() * __c_16.clone()
                                - __s_v.clone() * __c_16.clone())
                            - __p_a.clone()
                                * (__c_2.clone()
                                    * (__t_two_y.clone() + __t_six_u
                                        + __s_w.clone() * __c_21.clone() + __c_18)))),
                    __c_1_60.clone()
                        * (__c_10.clone()
                            * (__s_v.clone()
                                + __p_a.clone()
                                    * (__c_2.clone() * (__t_three_z.clone() + __c_2.clone())))
                            + __p_b.clone()
                                * (__c_3.clone()
                                    * (__t_n28_x.clone() - __s_y.clone() * __c_25.clone()))
                            - __p_c.clone()
                                * (__c_10.clone() * (__t_four_u - __t_nine_w))),
                    __c_1_30.clone()
                        * (__p_b.clone()
                            * (__c_2.clone()
                                * (__t_five_y.clone() + __s_z.clone() * __c_20.clone()
                                    + __t_six_v.clone()))
                            - __c_5.clone()
                                * (__t_w_a.clone() * __c_15.clone() + __t_six_x.clone()
                                    - __s_u.clone() - __p_c.clone() * __c_24.clone())),
                    __c_1_60.clone()
                        * (__c_6.clone()
                            * (__c_15.clone() * (__s_u.clone() * __p_c.clone())
                                + __p_a.clone()
                                    * (__s_z.clone() * __c_35 - __s_v.clone() * __c_25.clone()
                                        + __t_n16_w))
                            + __p_b.clone()
                                * (__c_5.clone()
                                    * (__s_x.clone() * __c_4.clone()
                                        + __s_y.clone() * __c_16.clone() + __c_3.clone()))),
                ],
                [
                    -(__c_1_60.clone()
                        * (__c_5.clone()
                            * (__c_20.clone() * __t_c_z - __t_n12_x.clone()
                                - __t_three_u.clone() - __s_v.clone() * __c_28.clone())
                            + __p_b.clone()
                                * (__c_3.clone()
                                    * (__s_y.clone() * __c_10.clone()
                                        - __s_w.clone() * __c_28.clone() - __c_25.clone())))),
                    -(__c_1_60.clone()
                        * (__p_b.clone()
                            * (__c_15.clone()
                                * (__t_two_x + __t_eight_y - __t_three_u.clone()))
                            - (__t_c_w.clone() * __c_36.clone()
                                + __p_a.clone()
                                    * (__c_5.clone()
                                        * (__t_four_z.clone() + __s_v.clone() * __c_24
                                            + __c_9.clone()))))),
                    -(__c_1_6.clone()
                        * (__p_c.clone() * (__c_2.clone() * (__t_five_x.clone() - __c_1))
                            - (__c_2.clone()
                                * (__t_y_a.clone() - __t_three_z.clone() + __s_u.clone())
                                + __p_b.clone()
                                    * (__c_3.clone()
                                        * (__t_six_v + __c_7.clone() * __s_w.clone()))))),
                    __c_1_12.clone()
                        * (__t_three_x.clone() + __t_four_z
                            + __p_c.clone()
                                * (__c_2.clone() * (__s_u.clone() * __c_9 + __t_four_w))
                            + __p_b.clone()
                                * (__c_3.clone()
                                    * (__t_three_y.clone() - __s_v.clone() + __c_16))),
                    __c_1_12.clone()
                        * (__c_4.clone()
                            * (__c_6.clone() * __t_y_a + __t_seven_x.clone())
                            + __p_b.clone()
                                * (__c_3.clone()
                                    * (__t_n12_z.clone() - __s_u.clone() + __t_n12_v.clone()
                                        + __s_w.clone() + __c_2.clone()))),
                    __c_1_60.clone()
                        * (__p_c.clone()
                            * (__s_y.clone() * __c_36.clone() + __s_u.clone() * __c_40
                                + __c_15.clone())
                            + __p_b.clone()
                                * (__c_3.clone()
                                    * (__t_n28_x + __s_z.clone() * __c_70 + __t_five_v.clone()
                                        + __s_w.clone() * __kahan::integer::<T>(120)))),
                ],
                [
                    __c_1_60.clone()
                        * (__c_10.clone()
                            * (__c_7.clone() * __s_v.clone()
                                + __p_b.clone()
                                    * (__c_3.clone()
                                        * (__s_z.clone() - __s_w.clone() * __c_5.clone())))
                            + __p_c.clone()
                                * (__c_3.clone()
                                    * (__s_x.clone() * __c_20.clone()
                                        - __s_y.clone() * __kahan::integer::<T>(50)
                                        + __t_five_u.clone() + __c_28))),
                    -(__c_1_30.clone()
                        * (__p_c.clone()
                            * (__c_3.clone()
                                * (__s_x.clone() * __c_25.clone() - __t_two_w.clone()
                                    - __c_10.clone()))
                            - (__c_5.clone() * (__s_z.clone() - __t_n12_v.clone())
                                + __p_b.clone()
                                    * (__c_4.clone() * (__t_three_y + __t_ten_u))))),
                    __c_1_12.clone()
                        * (__c_2.clone()
                            * (__c_3.clone() * __t_x_b.clone() + __s_y.clone())
                            - __p_c.clone()
                                * (__c_3.clone() * (__t_five_u.clone() - __t_four_v))
                            - __p_a.clone()
                                * (__c_2.clone()
                                    * (__c_6.clone() * __s_z.clone() - __t_three_w
                                        - __c_8.clone()))),
                    __c_1_12
                        * (__c_2.clone()
                            * (__c_8 * __t_b_y + __t_three_u.clone()
                                + __c_2.clone() * __p_a.clone())
                            + __p_c.clone()
                                * (__t_three_x - __t_n15_z + __t_n12_v.clone()
                                    + __t_two_w.clone())),
                    __c_1_6
                        * (__c_6.clone() * (__s_v.clone() * __p_a.clone()) + __t_seven_x
                            - __s_y.clone() * __c_12 + __c_6.clone() * __p_b.clone()
                            + __p_c.clone()
                                * (__c_2.clone()
                                    * (__t_three_z + __t_three_u + __t_two_w))),
                    -(__c_1_30.clone()
                        * (__c_3.clone()
                            * (__c_25.clone() * __t_x_b
                                - __p_a.clone() * (__t_five_z + __t_eight_w))
                            - __p_c.clone()
                                * (__c_6.clone() * __s_y.clone() + __t_five_u
                                    + __s_v.clone() * __c_20.clone() + __c_15.clone()))),
                ],
                [
                    -(__c_1_30.clone()
                        * (__c_3.clone()
                            * (__c_10.clone() * __t_u_a.clone()
                                + __s_x.clone() * __kahan::integer::<T>(100) + __t_two_y
                                - __s_v.clone() * __c_15.clone()
                                + __s_w.clone() * __c_10.clone())
                            + __p_c.clone()
                                * (__c_20.clone() * (__s_z.clone() - __c_3.clone())))),
                    __c_1_60.clone()
                        * (__c_36 * __t_u_a + __t_c_w.clone() * __c_20 - __t_n12_x
                            + __s_y.clone() * __c_60.clone()
                            + __s_z.clone() * __c_60.clone()
                            - __s_v.clone() * __c_75.clone()
                            + __p_b.clone() * __kahan::integer::<T>(240)),
                    -(__c_1_30.clone()
                        * (__c_2.clone()
                            * (__c_10.clone() * __t_x_c - __t_w_a * __c_21
                                - __s_y.clone() * __c_15.clone())
                            - __p_b.clone()
                                * (__t_n80_z - __s_u.clone() * __c_75 - __t_n12_v
                                    + __c_60))),
                    -(__c_1_30.clone()
                        * (__c_5.clone()
                            * (__c_15.clone() * (__p_b.clone() * __s_z.clone())
                                + __c_2.clone() * __t_c_w)
                            + __p_a.clone()
                                * (__c_2.clone()
                                    * (__s_x.clone() * __c_15 - __t_nine_y
                                        - __s_u.clone() * __kahan::integer::<T>(30)
                                        - __t_five_v.clone() - __c_6.clone())))),
                    -(__c_1_60
                        * (__p_b.clone()
                            * (__c_2 * (__t_n12_z + __s_w.clone() * __c_25 - __c_45))
                            - __c_5.clone()
                                * (__c_3.clone() * (__t_six_x - __t_five_y)
                                    + __p_a.clone() * (__c_4 * (__s_u.clone() + __t_nine_v))))),
                    __c_1_30
                        * (__c_6
                            * (__c_7 * (__p_a.clone() * __s_z.clone()) - __t_five_x
                                - __t_six_w)
                            - __p_b.clone() * (__c_5 * (__t_five_v - __c_3))
                            + __p_c.clone() * (__c_10 * (__s_y.clone() - __s_u.clone()))),
                ],
            ])
        }
        fn bilinear(
            &self,
            x: &__kahan::SVector<T, 6>,
            y: &__kahan::SVector<T, 6>,
        ) -> __kahan::SVector<T, 6> {
            let [__s_x, __s_y, __s_z, __s_u, __s_v, __s_w] = __kahan::components(x);
            let [__o_x, __o_y, __o_z, __o_u, __o_v, __o_w] = __kahan::components(y);
            let __p_a = &self.a;
            let __p_b = &self.b;
            let __p_c = &self.c;
            let __c_3 = __kahan::integer::<T>(3);
            let __t_three_y = __c_3.clone() * __s_y.clone();
            let __c_15 = __kahan::integer::<T>(15);
            let __t_n15_z = __c_15.clone() * __s_z.clone();
            let __c_2 = __kahan::integer::<T>(2);
            let __c_42 = __kahan::integer::<T>(42);
            let __t_w_second_x = __o_w.clone() * __s_x.clone();
            let __c_10 = __kahan::integer::<T>(10);
            let __t_v_second_u = __o_v.clone() * __s_u.clone();
            let __t_v_u_second = __s_v.clone() * __o_u.clone();
            let __c_5 = __kahan::integer::<T>(5);
            let __t_five_x = __s_x.clone() * __c_5.clone();
            let __c_6 = __kahan::integer::<T>(6);
            let __c_35 = __kahan::integer::<T>(35);
            let __t_two_v = __s_v.clone() * __c_2.clone();
            let __c_7 = __kahan::integer::<T>(7);
            let __c_4 = __kahan::integer::<T>(4);
            let __t_two_x = __c_2.clone() * __s_x.clone();
            let __t_six_u = __s_u.clone() * __c_6.clone();
            let __t_v_w_second = __s_v.clone() * __o_w.clone();
            let __t_w_v_second = __s_w.clone() * __o_v.clone();
            let __c_9 = __kahan::integer::<T>(9);
            let __t_nine_y = __s_y.clone() * __c_9.clone();
            let __c_12 = __kahan::integer::<T>(12);
            let __t_four_w = __s_w.clone() * __c_4.clone();
            let __t_three_u = __c_3.clone() * __s_u.clone();
            let __t_two_w = __s_w.clone() * __c_2.clone();
            let __t_z_second_x = __o_z.clone() * __s_x.clone();
            let __t_z_x_second = __s_z.clone() * __o_x.clone();
            let __sum_1 = __t_z_second_x.clone() + __t_z_x_second.clone();
            let __c_8 = __kahan::integer::<T>(8);
            let __t_v_v_second = __s_v.clone() * __o_v.clone();
            let __t_eight_v_v_second = __c_8.clone() * __t_v_v_second.clone();
            let __t_two_y = __s_y.clone() * __c_2.clone();
            let __t_four_u = __s_u.clone() * __c_4.clone();
            let __t_nine_v = __s_v.clone() * __c_9.clone();
            let __t_six_w = __s_w.clone() * __c_6.clone();
            let __t_four_z = __s_z.clone() * __c_4.clone();
            let __t_z_u_second = __s_z.clone() * __o_u.clone();
            let __t_three_z_u_second = __c_3.clone() * __t_z_u_second.clone();
            let __c_45 = __kahan::integer::<T>(45);
            let __c_21 = __kahan::integer::<T>(21);
            let __t_ten_u = __c_10.clone() * __s_u.clone();
            let __c_75 = __kahan::integer::<T>(75);
            let __t_three_x = __c_3.clone() * __s_x.clone();
            let __c_20 = __kahan::integer::<T>(20);
            let __t_n20_z = __s_z.clone() * __c_20.clone();
            let __t_y_u_second = __s_y.clone() * __o_u.clone();
            let __t_z_w_second = __s_z.clone() * __o_w.clone();
            let __c_14 = __kahan::integer::<T>(14);
            let __t_v_z_second = __s_v.clone() * __o_z.clone();
            let __c_1_120 = __kahan::ratio::<T>(1, 120);
            let __c_16 = __kahan::integer::<T>(16);
            let __t_n16_w = __s_w.clone() * __c_16.clone();
            let __t_five_y = __s_y.clone() * __c_5.clone();
            let __t_six_v = __s_v.clone() * __c_6.clone();
            let __t_nine_x = __s_x.clone() * __c_9.clone();
            let __c_28 = __kahan::integer::<T>(28);
            let __t_n28_x = __s_x.clone() * __c_28.clone();
            let __c_25 = __kahan::integer::<T>(25);
            let __t_n25_v = __s_v.clone() * __c_25.clone();
            let __t_four_x = __s_x.clone() * __c_4.clone();
            let __t_eight_y = __s_y.clone() * __c_8.clone();
            let __t_six_x = __s_x.clone() * __c_6.clone();
            let __t_v_x_second = __s_v.clone() * __o_x.clone();
            let __t_five_v = __s_v.clone() * __c_5.clone();
            let __t_n12_z = __s_z.clone() * __c_12.clone();
            let __t_n12_v = __s_v.clone() * __c_12.clone();
            let __t_three_z = __c_3.clone() * __s_z.clone();
            let __t_y_z_second = __s_y.clone() * __o_z.clone();
            __kahan::vector([
                (__c_5.clone()
                    * (__c_2.clone()
                        * (__o_x.clone() * (__s_x.clone() - __t_six_u.clone())
                            - __c_3.clone()
                                * (__o_z.clone() * __s_u.clone()
                                    - __c_2.clone() * __t_v_w_second.clone()
                                    - __c_2.clone() * __t_w_v_second.clone())
                            - __o_u.clone()
                                * (__c_3.clone() * (__t_two_x.clone() + __s_z.clone())))
                        * __p_b.clone()
                        - (__sum_1.clone() - __t_eight_v_v_second.clone()
                            - __o_y.clone()
                                * (__c_3.clone()
                                    * (__t_three_u.clone() - __t_two_w.clone()))
                            + __o_w.clone()
                                * (__c_2.clone()
                                    * (__t_three_y.clone() + __c_2.clone() * __s_u.clone()))
                            + __o_u.clone()
                                * (__t_four_w.clone()
                                    - (__t_nine_y.clone() + __s_u.clone() * __c_12.clone()))))
                    + __c_2.clone()
                        * (__c_5.clone()
                            * (__c_4.clone() * (__s_w.clone() * __o_w.clone())
                                + __o_x.clone()
                                    * (__c_3.clone()
                                        * (__s_y.clone() * __c_7.clone() + __t_two_v.clone())))
                            + __o_y.clone()
                                * (__c_3.clone()
                                    * (__s_x.clone() * __c_35.clone() - __t_two_v))
                            + __o_v.clone()
                                * ((__t_five_x.clone() - __s_y.clone()) * __c_6.clone()))
                        * __p_c.clone()
                    + (__c_42.clone() * __t_w_second_x.clone()
                        - __c_10.clone() * (__s_y.clone() * __o_y.clone())
                        + __c_3.clone() * __t_v_second_u.clone()
                        + __c_3.clone() * __t_v_u_second.clone()
                        + __c_42.clone() * (__s_w.clone() * __o_x.clone())
                        + __s_z.clone()
                            * (__c_2.clone()
                                * (__c_3.clone() * __o_y.clone()
                                    + __c_3.clone() * __o_v.clone() - __o_w.clone()))
                        + (__t_three_y.clone() - __t_n15_z.clone()
                            + __c_3.clone() * __s_v.clone() - __s_w.clone())
                            * __c_2.clone() * __o_z.clone()) * __c_5.clone()
                        * __p_a.clone()) * __kahan::ratio::<T>(1, 60),
                -((__p_a.clone()
                    * (__c_5.clone()
                        * (__c_12.clone() * (__o_y.clone() * __s_x.clone())
                            - __t_three_z_u_second.clone() + __t_eight_v_v_second
                            + __o_x.clone()
                                * (__c_4.clone()
                                    * (__t_five_x.clone() + __t_three_y.clone()))
                            + __o_z.clone()
                                * (__c_3.clone() * (__t_four_z.clone() - __s_u.clone()))
                            - __s_w.clone()
                                * (__c_4.clone()
                                    * (__c_2.clone() * __o_y.clone()
                                        + __o_u.clone() * __c_4.clone()
                                        + __o_v.clone() * __c_9.clone()))
                            - __o_w.clone()
                                * (__c_4.clone()
                                    * (__t_two_y.clone() + __t_four_u.clone()
                                        + __t_nine_v.clone() + __t_six_w.clone()))))
                    - __c_2.clone()
                        * (__c_5.clone()
                            * (__p_c.clone()
                                * (__c_2.clone()
                                    * (__c_3.clone()
                                        * (__t_w_second_x
                                            - __c_5.clone() * (__s_z.clone() * __o_v.clone())
                                            - __c_5.clone() * __t_v_z_second.clone())
                                        + __o_x.clone()
                                            * (__s_u.clone() * __c_7.clone()
                                                + __c_3.clone() * __s_w.clone()))
                                    + __o_u.clone()
                                        * (__s_x.clone() * __c_14.clone() + __t_three_u.clone()))
                                - __c_12.clone() * (__t_v_second_u + __t_v_u_second))
                            + __p_b.clone()
                                * (__o_z.clone()
                                    * (__s_x.clone() * __kahan::integer::<T>(40)
                                        + __s_y.clone() * __c_42 - __s_w.clone() * __c_75.clone())
                                    - (__c_5.clone()
                                        * (__c_4.clone() * __t_y_u_second.clone()
                                            + __c_15.clone() * __t_z_w_second.clone())
                                        - __o_x.clone()
                                            * (__c_2.clone() * (__t_n20_z.clone() - __t_nine_v))
                                        + __o_v.clone()
                                            * (__c_6.clone()
                                                * (__t_three_x.clone() - __s_y.clone() * __c_35.clone())))
                                    - __o_y.clone()
                                        * (__c_2.clone()
                                            * (__s_y.clone() * __c_45.clone()
                                                - __s_z.clone() * __c_21.clone() + __t_ten_u.clone()
                                                - __s_v.clone() * __kahan::integer::<T>(105))))))
                    * __c_1_120.clone()),
                -(__c_1_120.clone()
                    * (__c_2.clone()
                        * (__c_5.clone()
                            * (__o_u.clone()
                                * (__p_c.clone()
                                    * (__t_four_u - __s_w.clone() * __c_9.clone())
                                    - __s_v.clone())
                                - (__c_3.clone()
                                    * (__c_3.clone()
                                        * (__o_w.clone() * (__s_u.clone() * __p_c.clone()))
                                        - __c_2.clone() * __t_v_x_second.clone())
                                    + __o_v.clone() * (__s_u.clone() - __t_six_x.clone())))
                            + __p_a.clone()
                                * (__c_5.clone()
                                    * (__o_x.clone()
                                        * (__t_nine_x.clone() - __t_eight_y.clone())
                                        - __c_3.clone()
                                            * (__c_2.clone() * __t_z_u_second
                                                - __c_5.clone() * __t_w_v_second)
                                        - __o_y.clone()
                                            * (__c_2.clone() * (__t_four_x.clone() + __s_z.clone()))
                                        - __o_z.clone()
                                            * (__t_two_y.clone() + __t_six_u + __s_w.clone() * __c_21))
                                    - __o_w.clone()
                                        * (__c_3.clone()
                                            * (__s_z.clone() * __c_35 - __t_n25_v.clone()
                                                + __t_n16_w.clone()))))
                        + __p_b.clone()
                            * (__o_z.clone()
                                * (__c_5.clone()
                                    * (__t_nine_x - __s_z.clone() * __c_16.clone()
                                        - __s_v.clone() * __c_16))
                                - (__o_u.clone()
                                    * (__c_3.clone()
                                        * (__t_n28_x.clone() - __s_y.clone() * __c_25.clone()))
                                    + __o_w.clone()
                                        * (__c_20.clone()
                                            * (__s_x.clone() + __s_y.clone() * __c_4.clone()))
                                    + __o_x.clone()
                                        * (__s_w.clone() * __c_20.clone()
                                            - (__s_z.clone() * __c_45
                                                - __s_u.clone() * __kahan::integer::<T>(84))))
                                - __o_v.clone()
                                    * (__c_4.clone()
                                        * (__t_five_y.clone() + __t_n20_z.clone()
                                            + __t_six_v.clone()))
                                - __o_y.clone()
                                    * (__c_5.clone()
                                        * (__s_y.clone() * __kahan::integer::<T>(32)
                                            - __c_15.clone() * __s_u.clone()
                                            + __s_v.clone() * __c_4.clone() + __t_n16_w))))),
                -(__c_1_120.clone()
                    * (__p_c.clone()
                        * (__c_2.clone()
                            * (__c_2.clone()
                                * (__t_z_second_x * __c_25.clone()
                                    + __t_z_x_second * __c_25.clone()
                                    - __c_9.clone() * (__s_w.clone() * __o_y.clone()))
                                - __o_u.clone()
                                    * (__c_5.clone()
                                        * (__s_u.clone() * __c_9.clone() + __t_four_w))
                                - __o_w.clone()
                                    * (__c_2.clone()
                                        * (__t_nine_y.clone() + __t_ten_u.clone()))))
                        - __c_5.clone()
                            * (__c_4.clone()
                                * (__c_7.clone() * (__o_v.clone() * __s_x.clone())
                                    + __o_z.clone() * (__s_u.clone() - __t_three_z.clone()))
                                + __o_u.clone() * (__t_three_x.clone() + __t_four_z)
                                + __o_x.clone()
                                    * (__s_x.clone() * __c_12.clone() + __t_three_u.clone()
                                        + __s_v.clone() * __c_28)
                                + __p_a.clone()
                                    * (__c_4.clone()
                                        * (__s_y.clone() * (__o_z.clone() + __o_v.clone() * __c_6)
                                            + __o_y.clone() * (__s_z.clone() + __t_six_v.clone()))))
                        + __p_b.clone()
                            * (__c_3.clone()
                                * (__c_2.clone()
                                    * (__o_x.clone()
                                        * (__t_five_y.clone() - __s_w.clone() * __c_14)
                                        - __o_z.clone()
                                            * (__c_5.clone()
                                                * (__t_six_v + __s_w.clone() * __c_7.clone())))
                                    - __o_u.clone()
                                        * (__c_5.clone() * (__t_three_y.clone() - __s_v.clone()))
                                    + __o_y.clone()
                                        * (__c_5.clone()
                                            * (__t_two_x.clone() + __t_eight_y - __t_three_u))
                                    - __o_v.clone()
                                        * (__c_5.clone()
                                            * (__t_n12_z.clone() - __s_u.clone() + __t_n12_v.clone()
                                                + __s_w.clone()))
                                    - __o_w.clone()
                                        * (__t_n28_x + __s_z.clone() * __kahan::integer::<T>(70)
                                            + __t_five_v.clone()
                                            + __s_w.clone() * __kahan::integer::<T>(120)))))),
                __c_1_120.clone()
                    * (__c_2.clone()
                        * (__c_5.clone()
                            * (__t_y_z_second.clone()
                                + __c_3.clone() * (__s_u.clone() * __o_u.clone())
                                + __c_7.clone() * __t_v_x_second
                                + __o_y.clone() * (__s_z.clone() - __t_n12_v.clone())
                                + __o_v.clone()
                                    * (__s_x.clone() * __c_7.clone()
                                        - __s_y.clone() * __c_12.clone()))
                            - __p_a.clone()
                                * (__c_3.clone()
                                    * (__c_5.clone()
                                        * (__o_z.clone()
                                            * (__s_z.clone() * __c_2.clone() - __s_w.clone())
                                            - __c_2.clone() * __t_v_v_second.clone())
                                        - __o_w.clone()
                                            * (__s_z.clone() * __c_5.clone()
                                                + __s_w.clone() * __c_8.clone())))
                            + __p_b.clone()
                                * (__c_5.clone()
                                    * (__c_8 * __t_y_u_second
                                        + __s_x.clone()
                                            * (__c_3.clone()
                                                * (__o_z.clone() - __o_w.clone() * __c_5.clone()))
                                        + __o_x.clone()
                                            * (__c_3.clone()
                                                * (__s_z.clone() - __s_w.clone() * __c_5.clone())))
                                    + __o_y.clone()
                                        * (__c_4.clone() * (__t_three_y.clone() + __t_ten_u))))
                        + __p_c.clone()
                            * (__c_2.clone()
                                * (__c_3.clone()
                                    * (__c_5.clone()
                                        * (__c_2.clone() * __t_v_z_second
                                            + __o_x.clone() * (__t_two_x - __t_five_y.clone()))
                                        + __o_y.clone()
                                            * (__t_two_w.clone() - __s_x.clone() * __c_25.clone()))
                                    + __o_v.clone()
                                        * (__c_10.clone() * (__t_three_z + __t_two_w.clone()))
                                    + __o_w.clone()
                                        * (__c_2.clone()
                                            * (__t_three_y + __s_v.clone() * __c_10.clone())))
                                + __s_u.clone()
                                    * (__c_5.clone()
                                        * (__c_3.clone() * __o_x.clone()
                                            - __c_15.clone() * __o_z.clone() + __o_v.clone() * __c_12
                                            + __c_2.clone() * __o_w.clone()))
                                + __o_u.clone()
                                    * (__c_5.clone()
                                        * (__t_three_x - __t_n15_z + __t_n12_v.clone()
                                            + __t_two_w)))),
                -(__c_1_120
                    * (__c_3.clone()
                        * (__o_w.clone() * (__c_4.clone() * (__t_five_x + __t_six_w))
                            - __c_5.clone()
                                * (__c_4.clone() * __t_y_z_second
                                    + __o_v.clone() * (__t_six_x - __t_five_y))
                            + __o_x.clone()
                                * (__c_2.clone()
                                    * (__s_x.clone() * __kahan::integer::<T>(100) + __t_two_y
                                        - __c_15.clone() * __s_v.clone() + __s_w.clone() * __c_10))
                            + __o_y.clone()
                                * (__t_four_x - __s_y.clone() * __c_20.clone() - __t_n20_z
                                    + __t_n25_v))
                        + __p_c.clone()
                            * (__c_20
                                * (__c_2.clone() * __sum_1
                                    + __s_w.clone() * (__o_u.clone() - __o_y.clone())
                                    + __o_w.clone() * (__s_u.clone() - __s_y.clone())))
                        - __p_b.clone()
                            * (__c_2
                                * (__o_z.clone()
                                    * (__s_z.clone() * __kahan::integer::<T>(80)
                                        - __s_u.clone() * __c_75 - __t_n12_v)
                                    - (__c_25.clone() * (__t_three_z_u_second + __t_v_w_second)
                                        + __o_v.clone() * (__t_n12_z + __s_w.clone() * __c_25))))
                        + __p_a.clone()
                            * (__c_4
                                * (__o_u.clone()
                                    * (__c_15.clone() * __s_x.clone() - __t_nine_y
                                        - __s_u.clone() * __kahan::integer::<T>(30) - __t_five_v)
                                    - (__c_3
                                        * (__c_7.clone() * __t_z_w_second
                                            + __c_15.clone() * __t_v_v_second
                                            + __c_7 * (__s_w.clone() * __o_z.clone()))
                                        + __s_u.clone()
                                            * (__o_v.clone() * __c_5
                                                - (__c_15 * __o_x.clone() - __o_y.clone() * __c_9))))))),
            ])
        }
        fn polarized(
            &self,
            x: &__kahan::SVector<T, 6>,
            y: &__kahan::SVector<T, 6>,
        ) -> __kahan::SVector<T, 6> {
            let [__s_x, __s_y, __s_z, __s_u, __s_v, __s_w] = __kahan::components(x);
            let [__o_x, __o_y, __o_z, __o_u, __o_v, __o_w] = __kahan::components(y);
            let __p_a = &self.a;
            let __p_b = &self.b;
            let __p_c = &self.c;
            let __c_3 = __kahan::integer::<T>(3);
            let __t_three_y = __c_3.clone() * __s_y.clone();
            let __c_15 = __kahan::integer::<T>(15);
            let __t_n15_z = __c_15.clone() * __s_z.clone();
            let __t_three_v = __c_3.clone() * __s_v.clone();
            let __c_1 = __kahan::integer::<T>(1);
            let __c_10 = __kahan::integer::<T>(10);
            let __c_5 = __kahan::integer::<T>(5);
            let __t_five_x = __c_5.clone() * __s_x.clone();
            let __c_42 = __kahan::integer::<T>(42);
            let __t_five_y = __s_y.clone() * __c_5.clone();
            let __c_4 = __kahan::integer::<T>(4);
            let __t_five_x_second = __c_5.clone() * __o_x.clone();
            let __c_8 = __kahan::integer::<T>(8);
            let __t_eight_y = __s_y.clone() * __c_8.clone();
            let __c_14 = __kahan::integer::<T>(14);
            let __c_6 = __kahan::integer::<T>(6);
            let __t_six_u = __s_u.clone() * __c_6.clone();
            let __c_9 = __kahan::integer::<T>(9);
            let __c_28 = __kahan::integer::<T>(28);
            let __t_eight_w = __s_w.clone() * __c_8.clone();
            let __c_7 = __kahan::integer::<T>(7);
            let __c_2 = __kahan::integer::<T>(2);
            let __t_two_x = __s_x.clone() * __c_2.clone();
            let __c_21 = __kahan::integer::<T>(21);
            let __c_35 = __kahan::integer::<T>(35);
            let __t_two_v = __s_v.clone() * __c_2.clone();
            let __t_nine_y = __s_y.clone() * __c_9.clone();
            let __c_12 = __kahan::integer::<T>(12);
            let __t_three_u = __c_3.clone() * __s_u.clone();
            let __t_two_w = __s_w.clone() * __c_2.clone();
            let __t_v_v_second = __s_v.clone() * __o_v.clone();
            let __c_1_840 = __kahan::ratio::<T>(1, 840);
            let __c_40 = __kahan::integer::<T>(40);
            let __c_75 = __kahan::integer::<T>(75);
            let __t_n75_w = __s_w.clone() * __c_75.clone();
            let __c_18 = __kahan::integer::<T>(18);
            let __c_45 = __kahan::integer::<T>(45);
            let __t_ten_u = __c_10.clone() * __s_u.clone();
            let __t_six_x = __s_x.clone() * __c_6.clone();
            let __c_70 = __kahan::integer::<T>(70);
            let __t_n80_z = __s_z.clone() * __kahan::integer::<T>(80);
            let __c_36 = __kahan::integer::<T>(36);
            let __t_y_u_second = __s_y.clone() * __o_u.clone();
            let __t_n15_x = __c_15.clone() * __s_x.clone();
            let __t_two_y = __s_y.clone() * __c_2.clone();
            let __t_four_u = __c_4.clone() * __s_u.clone();
            let __t_six_w = __s_w.clone() * __c_6.clone();
            let __t_two_y_second = __o_y.clone() * __c_2.clone();
            let __t_four_z = __s_z.clone() * __c_4.clone();
            let __c_84 = __kahan::integer::<T>(84);
            let __c_24 = __kahan::integer::<T>(24);
            let __t_n14_x = __s_x.clone() * __c_14.clone();
            let __t_three_w = __c_3.clone() * __s_w.clone();
            let __c_60 = __kahan::integer::<T>(60);
            let __c_16 = __kahan::integer::<T>(16);
            let __t_n16_u = __s_u.clone() * __c_16.clone();
            let __t_nine_y_second = __o_y.clone() * __c_9.clone();
            let __t_four_v = __s_v.clone() * __c_4.clone();
            let __t_n16_w = __s_w.clone() * __c_16.clone();
            let __t_four_x = __s_x.clone() * __c_4.clone();
            let __c_20 = __kahan::integer::<T>(20);
            let __t_n20_z = __s_z.clone() * __c_20.clone();
            let __t_six_v = __s_v.clone() * __c_6.clone();
            let __t_nine_x = __s_x.clone() * __c_9.clone();
            let __t_n28_x = __s_x.clone() * __c_28.clone();
            let __c_25 = __kahan::integer::<T>(25);
            let __t_seven_w = __s_w.clone() * __c_7.clone();
            let __t_n25_v = __s_v.clone() * __c_25.clone();
            let __c_30 = __kahan::integer::<T>(30);
            let __t_n12_z = __s_z.clone() * __c_12.clone();
            let __t_n12_v = __s_v.clone() * __c_12.clone();
            let __t_five_v = __s_v.clone() * __c_5.clone();
            let __t_ten_y = __s_y.clone() * __c_10.clone();
            let __t_u_second_u = __o_u.clone() * __s_u.clone();
            let __t_three_x = __c_3.clone() * __s_x.clone();
            let __t_three_z = __c_3.clone() * __s_z.clone();
            let __t_five_u = __c_5.clone() * __s_u.clone();
            let __t_five_w = __s_w.clone() * __c_5.clone();
            let __t_y_z_second = __s_y.clone() * __o_z.clone();
            __kahan::vector([
                (__c_14.clone()
                    * (__c_2.clone()
                        * (__c_5.clone()
                            * (__c_4.clone() * (__s_w.clone() * __o_w.clone())
                                + __o_x.clone()
                                    * (__c_3.clone()
                                        * (__s_y.clone() * __c_7.clone() + __t_two_v.clone())))
                            + __o_y.clone()
                                * (__c_3.clone()
                                    * (__s_x.clone() * __c_35.clone() - __t_two_v.clone()))
                            + __o_v.clone()
                                * (__c_6.clone() * (__t_five_x.clone() - __s_y.clone())))
                        * __p_c.clone()
                        - __c_5.clone()
                            * (__o_z.clone() * __s_x.clone()
                                + __s_z.clone() * __o_x.clone()
                                - __c_8.clone() * __t_v_v_second.clone()
                                - __o_y.clone()
                                    * (__c_3.clone()
                                        * (__t_three_u.clone() - __t_two_w.clone()))
                                + __o_w.clone()
                                    * (__c_2.clone()
                                        * (__t_three_y.clone() + __s_u.clone() * __c_2.clone()))
                                + __o_u.clone()
                                    * (__s_w.clone() * __c_4.clone()
                                        - (__t_nine_y.clone() + __s_u.clone() * __c_12.clone()))))
                    + __c_5.clone()
                        * (__o_x.clone()
                            * ((__s_x.clone() - __t_six_u.clone() + __c_9.clone())
                                * __c_28.clone())
                            - __c_3.clone()
                                * (__c_4.clone()
                                    * (__c_7.clone() * (__o_z.clone() * __s_u.clone())
                                        - __s_x.clone() * __c_21.clone() - __c_2.clone())
                                    - __s_v.clone()
                                        * (__c_7.clone()
                                            * (__o_w.clone() * __c_8.clone() + __c_9.clone()))
                                    + __o_u.clone()
                                        * (__c_28.clone() * (__t_two_x.clone() + __s_z.clone()))
                                    - __o_v.clone()
                                        * ((__t_eight_w.clone() + __c_9.clone()) * __c_7.clone())))
                        * __p_b.clone()
                    + (__c_15.clone() * (__s_v.clone() + __c_3.clone()) * __o_u.clone()
                        - (__o_y.clone()
                            * (__c_10.clone() * (__t_five_y.clone() - __c_4.clone()))
                            - (__c_5.clone()
                                * (__t_eight_y.clone()
                                    + __c_3.clone() * (__o_v.clone() + __c_3.clone())
                                        * __s_u.clone())
                                + __s_w.clone()
                                    * (__c_42.clone()
                                        * (__t_five_x_second.clone() + __c_1.clone()))))
                        + __o_w.clone()
                            * ((__t_five_x.clone() + __c_1.clone()) * __c_42.clone())
                        + __s_z.clone()
                            * (__c_10.clone()
                                * (__c_3.clone() * __o_y.clone()
                                    + __c_3.clone() * __o_v.clone() - __o_w.clone()
                                    + __c_1.clone()))
                        + (__t_three_y.clone() - __t_n15_z.clone() + __t_three_v.clone()
                            - __s_w.clone() + __c_1.clone()) * __c_10.clone()
                            * __o_z.clone()) * __c_14.clone() * __p_a.clone())
                    * __c_1_840.clone(),
                -(__c_1_840.clone()
                    * (__c_5.clone()
                        * (__p_a.clone()
                            * (__c_84.clone() * (__o_y.clone() * __s_x.clone())
                                - __c_21.clone() * (__s_z.clone() * __o_u.clone())
                                + __t_v_v_second.clone() * __kahan::integer::<T>(56)
                                - __c_24.clone()
                                + __o_x.clone()
                                    * (__c_28.clone()
                                        * (__t_five_x.clone() + __t_three_y.clone()))
                                + __o_z.clone()
                                    * (__c_21.clone() * (__t_four_z.clone() - __s_u.clone()))
                                - __s_w.clone()
                                    * (__c_28.clone()
                                        * (__t_two_y_second.clone() + __o_u.clone() * __c_4.clone()
                                            + __o_v.clone() * __c_9.clone()))
                                - __o_w.clone()
                                    * (__c_28.clone()
                                        * (__t_two_y.clone() + __t_four_u.clone()
                                            + __s_v.clone() * __c_9.clone() + __t_six_w.clone())))
                            - __c_7.clone()
                                * (__p_c.clone()
                                    * (__c_12.clone() * (__o_w.clone() * __s_x.clone())
                                        - __c_60.clone() * (__s_z.clone() * __o_v.clone())
                                        - __c_60.clone() * (__s_v.clone() * __o_z.clone())
                                        + __t_nine_y.clone() + __t_n16_u.clone()
                                        + __t_nine_y_second.clone()
                                        + __o_x.clone()
                                            * (__c_4.clone()
                                                * (__s_u.clone() * __c_7.clone() + __t_three_w.clone()))
                                        + __o_u.clone()
                                            * (__c_2.clone()
                                                * (__t_n14_x.clone() + __t_three_u.clone()
                                                    + __c_8.clone())))
                                    - __c_24.clone()
                                        * (__o_v.clone() * __s_u.clone()
                                            + __s_v.clone() * __o_u.clone())))
                        - __p_b.clone()
                            * (__c_7.clone()
                                * (__o_z.clone()
                                    * (__c_2.clone()
                                        * (__s_x.clone() * __c_40.clone() + __s_y.clone() * __c_42
                                            - __t_n75_w.clone() + __c_18.clone()))
                                    - (__c_40.clone() * __t_y_u_second.clone()
                                        - __t_n15_x.clone() - __s_z.clone() * __c_36.clone()
                                        - __s_v.clone() * __kahan::integer::<T>(90) - __t_n75_w
                                        + __o_w.clone()
                                            * (__c_75.clone()
                                                * (__s_z.clone() * __c_2.clone() - __c_1.clone()))
                                        - __o_x.clone()
                                            * (__t_n80_z.clone() - __s_v.clone() * __c_36.clone()
                                                + __c_15.clone())
                                        + __o_v.clone()
                                            * (__c_6.clone()
                                                * (__t_six_x.clone() - __s_y.clone() * __c_70.clone()
                                                    - __c_15.clone()))
                                        + __o_y.clone()
                                            * (__c_4.clone()
                                                * (__s_y.clone() * __c_45.clone()
                                                    - __s_z.clone() * __c_21.clone() + __t_ten_u.clone()
                                                    - __s_v.clone() * __kahan::integer::<T>(105)))))))),
                -(__c_1_840.clone()
                    * (__c_7.clone()
                        * (__c_10.clone()
                            * (__s_v.clone()
                                * (__o_x.clone() * __c_6.clone() - __o_u.clone())
                                + __o_v.clone() * (__t_six_x.clone() - __s_u.clone())
                                + __p_c.clone()
                                    * (__o_u.clone()
                                        * (__t_four_u - __s_w.clone() * __c_9.clone())
                                        - __c_3.clone()
                                            * (__c_3.clone() * (__o_w.clone() * __s_u.clone())
                                                + __s_v.clone() * __c_8.clone()
                                                + __o_v.clone() * __c_8.clone())))
                            + __p_a.clone()
                                * (__o_w.clone()
                                    * (__c_6.clone() * (__t_n25_v.clone() - __t_n16_w.clone()))
                                    - __c_5.clone()
                                        * (__o_u.clone() * __c_8.clone()
                                            - (__c_30.clone() * (__s_w.clone() * __o_v.clone())
                                                - __s_x.clone() * __c_8.clone() - __t_three_y.clone()
                                                - __s_u.clone() * __c_8.clone())
                                            + __o_y.clone()
                                                * (__s_x.clone() * __c_16.clone() + __c_3.clone()))
                                    + __o_x.clone()
                                        * (__c_10.clone()
                                            * (__t_nine_x.clone() - __t_eight_y.clone()
                                                - __c_4.clone()))
                                    - __s_z.clone()
                                        * (__c_10.clone()
                                            * (__t_two_y_second + __o_u.clone() * __c_6.clone()
                                                + __o_w.clone() * __c_21.clone() + __c_18.clone()))
                                    - __o_z.clone()
                                        * (__c_10.clone()
                                            * (__t_two_y.clone() + __t_six_u
                                                + __s_w.clone() * __c_21.clone() + __c_18))))
                        + __p_b.clone()
                            * (__o_x.clone()
                                * (__c_7.clone()
                                    * (__s_z.clone() * __c_45.clone() - __s_u.clone() * __c_84
                                        - __s_w.clone() * __c_20.clone()))
                                - __c_3.clone()
                                    * (__c_5.clone() * (__t_seven_w.clone() + __c_8.clone())
                                        + __o_u.clone()
                                            * (__c_7.clone()
                                                * (__t_n28_x.clone() - __s_y.clone() * __c_25.clone())))
                                + __o_z.clone()
                                    * (__c_35.clone()
                                        * (__t_nine_x - __s_z.clone() * __c_16.clone()
                                            - __s_v.clone() * __c_16.clone()))
                                - __o_v.clone()
                                    * (__c_28.clone()
                                        * (__t_five_y.clone() + __t_n20_z.clone()
                                            + __t_six_v.clone()))
                                - __o_w.clone()
                                    * (__c_35.clone()
                                        * (__t_four_x.clone() + __s_y.clone() * __c_16.clone()
                                            + __c_3.clone()))
                                - __o_y.clone()
                                    * (__c_35.clone()
                                        * (__s_y.clone() * __kahan::integer::<T>(32)
                                            - __c_15.clone() * __s_u.clone() + __t_four_v.clone()
                                            + __t_n16_w))))),
                -(__c_1_840.clone()
                    * (__p_c.clone()
                        * (__c_10.clone()
                            * (__s_z.clone()
                                * (__c_14.clone() * (__t_five_x_second - __c_1.clone()))
                                - __c_3.clone()
                                    * (__c_21.clone() * __t_u_second_u.clone() + __c_4.clone())
                                + __o_z.clone()
                                    * (__c_14.clone() * (__t_five_x.clone() - __c_1)))
                            - __s_w.clone()
                                * (__c_7.clone()
                                    * (__o_y.clone() * __c_36.clone()
                                        + __o_u.clone() * __c_40.clone() + __c_15.clone()))
                            - __o_w.clone()
                                * (__c_7.clone()
                                    * (__s_y.clone() * __c_36 + __s_u.clone() * __c_40
                                        + __c_15.clone())))
                        - __c_35
                            * (__c_4.clone()
                                * (__c_7.clone() * (__o_v.clone() * __s_x.clone())
                                    + __o_z.clone() * (__s_u.clone() - __t_three_z.clone()))
                                + __o_u.clone() * (__t_three_x.clone() + __t_four_z.clone())
                                + __o_x.clone()
                                    * (__s_x.clone() * __c_12.clone() + __t_three_u.clone()
                                        + __s_v.clone() * __c_28.clone())
                                + __p_a.clone()
                                    * (__s_y.clone()
                                        * (__o_z.clone() * __c_4.clone()
                                            + __o_v.clone() * __c_24.clone() + __c_9.clone())
                                        + __o_y.clone()
                                            * (__t_four_z.clone() + __s_v.clone() * __c_24 + __c_9)))
                        + __p_b.clone()
                            * (__c_21.clone()
                                * (__o_x.clone()
                                    * (__t_ten_y.clone() - __s_w.clone() * __c_28.clone()
                                        - __c_25.clone())
                                    - __c_5.clone()
                                        * (__t_five_x.clone() + __t_n16_u + __t_two_v
                                            + __o_z.clone()
                                                * (__c_2.clone() * (__t_six_v + __t_seven_w)))
                                    + __o_y.clone()
                                        * (__c_5.clone()
                                            * (__t_two_x + __t_eight_y.clone() - __t_three_u.clone()))
                                    - __o_u.clone()
                                        * (__c_5.clone()
                                            * (__t_three_y.clone() - __s_v.clone() + __c_16))
                                    - __o_w.clone()
                                        * (__t_n28_x + __s_z.clone() * __c_70 + __t_five_v.clone()
                                            + __s_w.clone() * __kahan::integer::<T>(120))
                                    - __o_v.clone()
                                        * (__c_5.clone()
                                            * (__t_n12_z.clone() - __s_u.clone() + __t_n12_v.clone()
                                                + __s_w.clone() + __c_2.clone())))))),
                __c_1_840.clone()
                    * (__c_2.clone()
                        * (__p_b.clone()
                            * (__c_5.clone()
                                * (__c_2.clone()
                                    * (__c_28.clone() * __t_y_u_second
                                        + __s_v.clone() * __c_21.clone()
                                        + __o_v.clone() * __c_21.clone() + __c_6.clone())
                                    + __s_x.clone()
                                        * (__c_21.clone()
                                            * (__o_z.clone() - __o_w.clone() * __c_5.clone()))
                                    + __o_x.clone()
                                        * (__c_21.clone() * (__s_z.clone() - __t_five_w.clone())))
                                + __o_y.clone()
                                    * (__c_28.clone() * (__t_three_y + __t_ten_u)))
                            - __c_7.clone()
                                * (__p_a.clone()
                                    * (__o_z.clone()
                                        * (__c_5.clone()
                                            * (__s_z.clone() * __c_6.clone() - __t_three_w
                                                - __c_8.clone()))
                                        - (__c_10.clone()
                                            * (__c_3.clone() * __t_v_v_second.clone() + __t_four_z
                                                + __s_u.clone() + __o_u.clone())
                                            + __o_w.clone()
                                                * (__c_3.clone()
                                                    * (__s_z.clone() * __c_5.clone() + __t_eight_w))))
                                    - __c_5.clone()
                                        * (__t_y_z_second.clone() + __c_3.clone() * __t_u_second_u
                                            + __c_7.clone() * (__s_v.clone() * __o_x.clone())
                                            + __o_y.clone() * (__s_z.clone() - __t_n12_v.clone())
                                            + __o_v.clone()
                                                * (__s_x.clone() * __c_7.clone()
                                                    - __s_y.clone() * __c_12))))
                        + __p_c.clone()
                            * (__c_7.clone()
                                * (__o_v.clone()
                                    * (__c_20.clone()
                                        * (__t_three_z + __t_three_u + __t_two_w.clone()))
                                    - __c_3.clone()
                                        * (__o_z.clone()
                                            * (__c_5.clone() * (__t_five_u.clone() - __t_four_v))
                                            - __c_2.clone() * (__t_n14_x + __t_ten_y + __t_five_w)
                                            + __o_y.clone()
                                                * (__c_2.clone()
                                                    * (__s_x.clone() * __c_25.clone() - __t_two_w.clone()
                                                        - __c_10.clone())))
                                    + __o_x.clone()
                                        * (__c_3.clone()
                                            * (__s_x.clone() * __c_20.clone()
                                                - __s_y.clone() * __kahan::integer::<T>(50)
                                                + __t_five_u.clone() + __c_28.clone()))
                                    + __o_u.clone()
                                        * (__c_5.clone()
                                            * (__t_three_x - __t_n15_z + __t_n12_v.clone() + __t_two_w))
                                    + __o_w.clone()
                                        * (__c_2.clone()
                                            * (__s_y.clone() * __c_6.clone() + __t_five_u
                                                + __s_v.clone() * __c_20.clone() + __c_15.clone()))))),
                -(__c_1_840
                    * (__c_21
                        * (__o_w.clone() * (__c_4.clone() * (__t_five_x + __t_six_w))
                            - __c_5.clone()
                                * (__c_4.clone() * __t_y_z_second
                                    + __o_v.clone() * (__t_six_x - __t_five_y))
                            + __o_x.clone()
                                * (__c_2.clone()
                                    * (__s_x.clone() * __kahan::integer::<T>(100) + __t_two_y
                                        - __c_15.clone() * __s_v.clone() + __s_w.clone() * __c_10))
                            + __o_y.clone()
                                * (__t_four_x - __s_y.clone() * __c_20.clone() - __t_n20_z
                                    + __t_n25_v))
                        + __p_c.clone()
                            * (__c_20
                                * (__c_2
                                    * (__s_x.clone()
                                        * (__c_7.clone() * (__o_z.clone() - __c_3.clone()))
                                        - __c_3.clone())
                                    - __s_w.clone()
                                        * (__c_7.clone() * (__o_y.clone() - __o_u.clone()))
                                    + __o_x.clone()
                                        * (__c_14.clone() * (__s_z.clone() - __c_3.clone()))
                                    - __o_w.clone()
                                        * (__c_7.clone() * (__s_y.clone() - __s_u.clone()))))
                        + __p_a.clone()
                            * (__c_28
                                * (__o_u.clone()
                                    * (__t_n15_x - __t_nine_y - __s_u.clone() * __c_30
                                        - __t_five_v.clone() - __c_6.clone())
                                    - (__c_3.clone()
                                        * (__c_7.clone() * (__s_z.clone() * __o_w.clone())
                                            + __c_15.clone() * __t_v_v_second
                                            + __c_7 * (__s_w.clone() * __o_z.clone()))
                                        + __s_u.clone()
                                            * (__c_6
                                                - (__c_15 * __o_x.clone() - __t_nine_y_second
                                                    - __o_v.clone() * __c_5.clone())))))
                        - __p_b.clone()
                            * (__c_14
                                * (__o_z.clone()
                                    * (__t_n80_z - __s_u.clone() * __c_75 - __t_n12_v + __c_60)
                                    - (__c_5.clone()
                                        * (__c_3.clone()
                                            * (__s_z.clone() * (__c_5 * __o_u.clone() - __c_4)
                                                - (__t_eight_y + __t_three_v + __s_w.clone()
                                                    + __o_y.clone() * __c_8))
                                            + __o_w.clone() * (__t_five_v - __c_3))
                                        + __o_v.clone()
                                            * (__t_n12_z + __s_w.clone() * __c_25 - __c_45)))))),
            ])
        }
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 6> for Dense<T> {
        type Prepared = __kahan::Elimination<Self, T>;
        #[inline]
        fn prepare(&self, eps: &T) -> Self::Prepared {
            __kahan::Elimination::new(self.clone(), eps.clone())
        }
        #[inline(always)]
        fn try_prepared(
            &self,
            prepared: &Self::Prepared,
            x: &__kahan::SVector<T, 6>,
            eps: &T,
        ) -> __kahan::core::result::Result<__kahan::SVector<T, 6>, __kahan::SingularStep>
        where
            T: __kahan::Pivot,
        {
            __kahan::stable_step(self, prepared, x, eps)
        }
    }
    impl<T: __kahan::Scalar> __kahan::Lift<T, 6> for Dense<T> {
        type Lifted<U: __kahan::Scalar> = Dense<U>;
        #[inline(always)]
        fn lift<U: __kahan::Scalar>(
            &self,
            lift: impl __kahan::core::ops::Fn(&T) -> U,
        ) -> Dense<U> {
            Dense {
                a: lift(&self.a),
                b: lift(&self.b),
                c: lift(&self.c),
            }
        }
    }
    #[doc(hidden)]
    impl<T> __kahan::WithoutIntegrals for Dense<T> {}
    #[doc(hidden)]
    impl<T> __kahan::WithoutDensity for Dense<T> {}
    #[doc(hidden)]
    impl<T: __kahan::Integer> __kahan::IntegerParameters for Dense<T> {}
};
