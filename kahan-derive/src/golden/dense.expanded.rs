/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the field
///
/// ```text
/// xdot = 1/7*b - 1/6*x*z + 3*b*x + 3/2*y*u - y*w + 4/3*a*y + 1/3*a*z + u^2 - 2/3*u*w + 3/2*a*u + 2/3*v^2 + 9/4*b*v + 7/5*a*w + 1/6*b*x^2 + 7*c*x*y - 2*b*x*u + 2*c*x*v + 7*a*x*w - 5/6*a*y^2 + a*y*z - 2/5*c*y*v - 5/2*a*z^2 - b*z*u + a*z*v - 1/3*a*z*w + 1/2*a*u*v + 2*b*v*w + 2/3*c*w^2
/// ydot = 1/7*a + 1/4*b*x + 3/4*c*y + 3/5*b*z - 2*u*v + 4/3*c*u + 3/2*b*v + 5/4*b*w - 5/6*a*x^2 - a*x*y + 4/3*b*x*z + 7/3*c*x*u - 3/5*b*x*v + c*x*w - 3/2*b*y^2 + 7/5*b*y*z - 2/3*b*y*u + 7*b*y*v + 2/3*a*y*w - 1/2*a*z^2 + 1/4*a*z*u - 5*c*z*v - 5/2*b*z*w + 1/4*c*u^2 + 4/3*a*u*w - 1/3*a*v^2 + 3*a*v*w + a*w^2
/// zdot = 1/7*b - x*v + 2/3*a*x + 1/4*a*y + 3*a*z + 1/6*u*v + 2/3*a*u + 4*c*v + 1/4*b*w - 3/4*a*x^2 + 4/3*a*x*y - 3/4*b*x*z + 7/5*b*x*u + 1/3*b*x*w + 4/3*b*y^2 + 1/3*a*y*z - 5/4*b*y*u + 1/3*b*y*v + 4/3*b*y*w + 2/3*b*z^2 + a*z*u + 4/3*b*z*v + 7/2*a*z*w - 1/3*c*u^2 + 3/2*c*u*w + 1/5*b*v^2 - 5/2*a*v*w + 4/5*a*w^2
/// udot = 1/7*c + 1/2*x^2 + 1/4*x*u + 7/3*x*v + 5/4*b*x + 3/4*a*y - 1/2*z^2 + 1/3*z*u + 1/3*c*z + 4*b*u + 1/2*b*v + 1/4*c*w - 1/2*b*x*y - 5/3*c*x*z + 7/5*b*x*w - b*y^2 + 1/3*a*y*z + 3/4*b*y*u + 2*a*y*v + 3/5*c*y*w + 3*b*z*v + 7/2*b*z*w + 3/4*c*u^2 - 1/4*b*u*v + 2/3*c*u*w + 3/2*b*v^2 + 1/4*b*v*w + 3*b*w^2
/// vdot = 1/7*b + 7/6*x*v + 7/5*c*x + 1/6*y*z - 2*y*v + c*y + 4/3*a*z + 1/4*u^2 + 1/3*a*u + b*v + 1/2*c*w + 1/2*c*x^2 - 5/2*c*x*y + 1/2*b*x*z + 1/4*c*x*u - 5/2*b*x*w + 1/5*b*y^2 + 4/3*b*y*u + 1/5*c*y*w - 1/2*a*z^2 - 5/4*c*z*u + c*z*v + 1/2*a*z*w + c*u*v + 1/6*c*u*w + 1/2*a*v^2 + 2/3*c*v*w + 2/5*a*w^2
/// wdot = 1/7*c - 5*x^2 - 1/5*x*y + 3/2*x*v - x*w + 2*c*x + 1/2*y^2 + y*z - 5/4*y*v + 4*b*y + 2*b*z + 2/5*a*u + 3/2*b*v - 3/5*w^2 + 1/2*b*w - 2/3*c*x*z - a*x*u + 3/5*a*y*u + 1/3*c*y*w + 4/3*b*z^2 - 5/2*b*z*u - 2/5*b*z*v + 7/5*a*z*w + a*u^2 + 1/3*a*u*v - 1/3*c*u*w + 3/2*a*v^2 - 5/6*b*v*w
/// ```
/// The map is computed by elimination: its closed form exceeds the budget of terms.
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
        fn field(&self, state: &__kahan::SVector<T, 6>) -> __kahan::SVector<T, 6> {
            let [s_x, s_y, s_z, s_u, s_v, s_w] = __kahan::components(state);
            let p_a = &self.a;
            let p_b = &self.b;
            let p_c = &self.c;
            let c_6 = __kahan::integer::<T>(6);
            let product_1 = c_6.clone() * s_y.clone();
            let c_15 = __kahan::integer::<T>(15);
            let product_2 = c_6.clone() * s_v.clone();
            let c_2 = __kahan::integer::<T>(2);
            let c_5 = __kahan::integer::<T>(5);
            let product_3 = c_5.clone() * s_x.clone();
            let c_1 = __kahan::integer::<T>(1);
            let c_42 = __kahan::integer::<T>(42);
            let c_3 = __kahan::integer::<T>(3);
            let c_8 = __kahan::integer::<T>(8);
            let c_14 = __kahan::integer::<T>(14);
            let c_12 = __kahan::integer::<T>(12);
            let c_18 = __kahan::integer::<T>(18);
            let product_4 = s_w.clone() * c_8.clone();
            let c_9 = __kahan::integer::<T>(9);
            let c_7 = __kahan::integer::<T>(7);
            let t_z_u = s_z.clone() * s_u.clone();
            let c_4 = __kahan::integer::<T>(4);
            let c_21 = __kahan::integer::<T>(21);
            let t_w_w = s_w.clone() * s_w.clone();
            let product_5 = s_y.clone() * c_9.clone();
            let product_6 = c_6.clone() * s_u.clone();
            let t_v_v = s_v.clone() * s_v.clone();
            let c_1_420 = __kahan::ratio::<T>(1, 420);
            let c_40 = __kahan::integer::<T>(40);
            let c_75 = __kahan::integer::<T>(75);
            let product_7 = c_6.clone() * s_x.clone();
            let product_8 = s_u.clone() * c_4.clone();
            let product_9 = s_w.clone() * c_5.clone();
            let product_10 = s_y.clone() * c_2.clone();
            let product_11 = s_w.clone() * c_3.clone();
            let c_28 = __kahan::integer::<T>(28);
            let product_12 = c_7.clone() * t_v_v.clone();
            let product_13 = c_3.clone() * s_u.clone();
            let c_16 = __kahan::integer::<T>(16);
            let c_20 = __kahan::integer::<T>(20);
            let product_14 = s_y.clone() * c_3.clone();
            let c_24 = __kahan::integer::<T>(24);
            let product_15 = s_y.clone() * c_16.clone();
            let product_16 = c_15.clone() * s_u.clone();
            let c_35 = __kahan::integer::<T>(35);
            let product_17 = s_x.clone() * c_9.clone();
            let c_10 = __kahan::integer::<T>(10);
            let product_18 = c_2.clone() * s_u.clone();
            let product_19 = s_v.clone() * c_24.clone();
            let product_20 = s_z.clone() * c_12.clone();
            let product_21 = s_y.clone() * c_4.clone();
            let t_u_u = s_u.clone() * s_u.clone();
            let product_22 = s_z.clone() * c_3.clone();
            let product_23 = c_5.clone() * s_u.clone();
            let c_50 = __kahan::integer::<T>(50);
            let product_24 = c_15.clone() * t_v_v.clone();
            let product_25 = s_v.clone() * c_5.clone();
            let product_26 = c_15.clone() * s_v.clone();
            __kahan::vector([
                (c_14.clone()
                    * (c_2.clone()
                        * (c_5.clone()
                            * (c_21.clone() * (s_y.clone() * s_x.clone())
                                + c_2.clone() * t_w_w.clone())
                            + s_v.clone()
                                * (c_6.clone() * (product_3.clone() - s_y.clone())))
                        * p_c.clone()
                        - c_5.clone()
                            * (s_z.clone() * s_x.clone()
                                + c_6.clone() * (s_y.clone() * s_w.clone())
                                - c_4.clone() * t_v_v.clone()
                                + s_u.clone()
                                    * (s_w.clone() * c_4.clone()
                                        - (product_5.clone() + product_6.clone()))))
                    + c_5.clone()
                        * (s_x.clone()
                            * (c_14.clone()
                                * (s_x.clone() - s_u.clone() * c_12.clone() + c_18.clone()))
                            - c_3.clone()
                                * ((c_7.clone() * t_z_u.clone() - c_1.clone()) * c_4.clone()
                                    - s_v.clone()
                                        * ((product_4.clone() + c_9.clone()) * c_7.clone())))
                        * p_b.clone()
                    + (s_w.clone() * ((product_3.clone() + c_1.clone()) * c_42.clone())
                        - c_5.clone()
                            * (s_y.clone() * (s_y.clone() * c_5.clone() - c_8.clone())
                                - c_3.clone() * (s_v.clone() + c_3.clone()) * s_u.clone())
                        + s_z.clone()
                            * ((product_1.clone() - c_15.clone() * s_z.clone()
                                + product_2.clone() - c_2.clone() * s_w.clone()
                                + c_2.clone()) * c_5.clone())) * c_14.clone() * p_a.clone())
                    * c_1_420.clone(),
                -(c_1_420.clone()
                    * (c_5.clone()
                        * (p_a.clone()
                            * (c_2.clone()
                                * (c_2.clone() * (product_12.clone() - c_3.clone())
                                    + s_x.clone()
                                        * (c_7.clone() * (product_3.clone() + product_1.clone())))
                                + s_z.clone()
                                    * (c_21.clone() * (s_z.clone() * c_2.clone() - s_u.clone()))
                                - s_w.clone()
                                    * ((product_10.clone() + product_8.clone()
                                        + s_v.clone() * c_9.clone() + product_11.clone())
                                        * c_28.clone()))
                            - c_7.clone()
                                * (p_c.clone()
                                    * (c_3.clone()
                                        * (c_4.clone() * (s_w.clone() * s_x.clone())
                                            - c_20.clone() * (s_z.clone() * s_v.clone())
                                            + product_14.clone())
                                        + s_u.clone()
                                            * (s_x.clone() * c_28.clone() + product_13.clone()
                                                + c_16.clone()))
                                    - c_24.clone() * (s_v.clone() * s_u.clone())))
                        - p_b.clone()
                            * (c_7.clone()
                                * (s_z.clone()
                                    * (c_2.clone()
                                        * (s_x.clone() * c_40.clone() + s_y.clone() * c_42.clone()
                                            - s_w.clone() * c_75.clone() + c_18.clone()))
                                    - (c_5.clone()
                                        * (s_y.clone()
                                            * (c_2.clone() * (product_5.clone() + product_8.clone()))
                                            - c_3.clone() * (s_x.clone() + product_9.clone()))
                                        + s_v.clone()
                                            * (c_6.clone()
                                                * (product_7.clone()
                                                    - s_y.clone() * __kahan::integer::<T>(70)
                                                    - c_15.clone()))))))),
                -(c_1_420.clone()
                    * (c_7.clone()
                        * (c_10.clone()
                            * (s_v.clone() * (product_7.clone() - s_u.clone())
                                + p_c.clone()
                                    * (s_u.clone()
                                        * (product_18.clone() - s_w.clone() * c_9.clone())
                                        - product_19.clone()))
                            + p_a.clone()
                                * (s_w.clone()
                                    * (c_6.clone()
                                        * (s_v.clone() * __kahan::integer::<T>(25)
                                            - product_4.clone()))
                                    - c_5.clone()
                                        * (product_14.clone() + s_u.clone() * c_8.clone())
                                    + s_x.clone()
                                        * (c_5.clone()
                                            * (product_17.clone() - product_15.clone() - c_8.clone()))
                                    - s_z.clone()
                                        * ((product_10.clone() + product_6.clone()
                                            + s_w.clone() * c_21.clone() + c_18.clone())
                                            * c_10.clone())))
                        + p_b.clone()
                            * (s_z.clone()
                                * (c_35.clone()
                                    * (product_17.clone() - s_z.clone() * c_8.clone()
                                        - s_v.clone() * c_16.clone()))
                                - (c_12.clone()
                                    * (__kahan::integer::<T>(49) * (s_x.clone() * s_u.clone())
                                        + product_12.clone() + c_5.clone())
                                    + s_w.clone()
                                        * (c_35.clone()
                                            * (s_x.clone() * c_4.clone() + c_3.clone())))
                                - s_y.clone()
                                    * ((product_15.clone() - product_16.clone()
                                        + s_v.clone() * c_4.clone() + s_w.clone() * c_16.clone())
                                        * c_35.clone())))),
                -(c_1_420.clone()
                    * (p_c.clone()
                        * (c_5.clone()
                            * (s_z.clone()
                                * (c_28.clone() * (product_3.clone() - c_1.clone()))
                                - c_3.clone()
                                    * (c_21.clone() * t_u_u.clone() + c_4.clone()))
                            - s_w.clone()
                                * (c_7.clone()
                                    * (s_y.clone() * __kahan::integer::<T>(36)
                                        + s_u.clone() * c_40.clone() + c_15.clone())))
                        - c_35.clone()
                            * (s_x.clone()
                                * (product_7.clone() + product_13.clone()
                                    + s_v.clone() * c_28.clone())
                                - s_z.clone()
                                    * (c_2.clone() * (product_22.clone() - product_18.clone()))
                                + p_a.clone()
                                    * (s_y.clone()
                                        * (s_z.clone() * c_4.clone() + product_19.clone()
                                            + c_9.clone())))
                        + p_b.clone()
                            * (c_21.clone()
                                * (c_5.clone()
                                    * (s_y.clone()
                                        * (c_2.clone() * s_x.clone() + product_21.clone()
                                            - product_13.clone())
                                        - (product_3.clone() + s_u.clone() * c_16.clone()))
                                    - s_w.clone()
                                        * (c_2.clone()
                                            * (s_x.clone() * c_14.clone() + s_z.clone() * c_35.clone()
                                                + s_w.clone() * __kahan::integer::<T>(30)))
                                    - s_v.clone()
                                        * (c_5.clone()
                                            * (product_20.clone() - s_u.clone() + product_2.clone()
                                                + s_w.clone() + c_2.clone())))))),
                c_1_420.clone()
                    * (p_b.clone()
                        * (c_2.clone()
                            * (c_15.clone()
                                * (c_2.clone() * (s_v.clone() * c_7.clone() + c_1.clone())
                                    + s_x.clone()
                                        * (c_7.clone() * (s_z.clone() - product_9.clone())))
                                + s_y.clone()
                                    * (c_14.clone()
                                        * (product_14.clone() + s_u.clone() * c_20.clone()))))
                        - c_7.clone()
                            * (p_a.clone()
                                * (c_2.clone()
                                    * (s_z.clone()
                                        * (c_5.clone()
                                            * (product_22.clone() - product_11.clone() - c_8.clone()))
                                        - (product_24.clone() + c_12.clone() * t_w_w.clone()
                                            + s_u.clone() * c_10.clone())))
                                - c_5.clone()
                                    * (c_2.clone() * (s_y.clone() * s_z.clone())
                                        + c_3.clone() * t_u_u.clone()
                                        + s_v.clone()
                                            * (c_2.clone()
                                                * (s_x.clone() * c_7.clone()
                                                    - s_y.clone() * c_12.clone()))))
                        + p_c.clone()
                            * (c_7.clone()
                                * (c_3.clone()
                                    * (s_x.clone()
                                        * (s_x.clone() * c_10.clone() - s_y.clone() * c_50.clone()
                                            + product_23.clone() + c_28.clone())
                                        - c_5.clone()
                                            * (c_5.clone() * t_z_u.clone() - product_21.clone()
                                                - s_v.clone()
                                                    * (c_4.clone() * (s_z.clone() + s_u.clone()))))
                                    + s_w.clone()
                                        * (c_2.clone()
                                            * (product_1.clone() + product_23.clone()
                                                + s_v.clone() * c_20.clone() + c_15.clone()))))),
                -(c_1_420.clone()
                    * (c_4.clone()
                        * (t_w_w.clone() * __kahan::integer::<T>(63)
                            + p_c.clone()
                                * (c_5.clone()
                                    * (c_7.clone() * (s_w.clone() * s_u.clone())
                                        - c_3.clone())))
                        - s_y.clone()
                            * (c_35.clone()
                                * (c_4.clone() * (s_w.clone() * p_c.clone())
                                    + product_1.clone() + product_20.clone()
                                    - product_26.clone()))
                        + s_x.clone()
                            * (c_14.clone()
                                * (c_3.clone()
                                    * (s_x.clone() * c_50.clone() + product_10.clone()
                                        - product_26.clone() + s_w.clone() * c_10.clone())
                                    + p_c.clone()
                                        * (c_20.clone() * (s_z.clone() - c_3.clone()))))
                        + p_a.clone()
                            * (c_14.clone()
                                * (s_u.clone()
                                    * (c_2.clone()
                                        * (c_15.clone() * s_x.clone() - product_5.clone()
                                            - product_16.clone() - product_25.clone() - c_6.clone()))
                                    - c_3.clone()
                                        * (c_14.clone() * (s_z.clone() * s_w.clone())
                                            + product_24.clone())))
                        - p_b.clone()
                            * (c_14.clone()
                                * (s_z.clone()
                                    * (s_z.clone() * c_40.clone() - s_u.clone() * c_75.clone()
                                        - s_v.clone() * c_12.clone() + __kahan::integer::<T>(60))
                                    - c_5.clone()
                                        * (s_w.clone() * (product_25.clone() - c_3.clone())
                                            - c_3.clone()
                                                * (s_y.clone() * c_8.clone()
                                                    + s_v.clone() * c_3.clone())))))),
            ])
        }
        fn field_jacobian(
            &self,
            state: &__kahan::SVector<T, 6>,
        ) -> __kahan::SMatrix<T, 6, 6> {
            let [s_x, s_y, s_z, s_u, s_v, s_w] = __kahan::components(state);
            let p_a = &self.a;
            let p_b = &self.b;
            let p_c = &self.c;
            let c_1 = __kahan::integer::<T>(1);
            let c_6 = __kahan::integer::<T>(6);
            let product_1 = c_6.clone() * s_u.clone();
            let c_9 = __kahan::integer::<T>(9);
            let c_2 = __kahan::integer::<T>(2);
            let c_7 = __kahan::integer::<T>(7);
            let product_2 = c_2.clone() * s_v.clone();
            let c_42 = __kahan::integer::<T>(42);
            let t_w_a = s_w.clone() * p_a.clone();
            let c_1_6 = __kahan::ratio::<T>(1, 6);
            let c_5 = __kahan::integer::<T>(5);
            let product_3 = s_y.clone() * c_5.clone();
            let c_3 = __kahan::integer::<T>(3);
            let product_4 = s_z.clone() * c_3.clone();
            let c_4 = __kahan::integer::<T>(4);
            let c_10 = __kahan::integer::<T>(10);
            let c_35 = __kahan::integer::<T>(35);
            let product_5 = s_u.clone() * c_3.clone();
            let product_6 = c_2.clone() * s_w.clone();
            let c_1_30 = __kahan::ratio::<T>(1, 30);
            let product_7 = s_y.clone() * c_3.clone();
            let c_15 = __kahan::integer::<T>(15);
            let product_8 = s_z.clone() * c_15.clone();
            let product_9 = s_v.clone() * c_3.clone();
            let product_10 = s_x.clone() * c_2.clone();
            let product_11 = c_9.clone() * s_y.clone();
            let c_12 = __kahan::integer::<T>(12);
            let product_12 = s_w.clone() * c_4.clone();
            let product_13 = s_x.clone() * c_5.clone();
            let c_24 = __kahan::integer::<T>(24);
            let c_8 = __kahan::integer::<T>(8);
            let product_14 = s_w.clone() * c_8.clone();
            let product_15 = c_2.clone() * s_z.clone();
            let c_1_60 = __kahan::ratio::<T>(1, 60);
            let c_105 = __kahan::integer::<T>(105);
            let product_16 = s_z.clone() * c_5.clone();
            let c_21 = __kahan::integer::<T>(21);
            let t_c_w = p_c.clone() * s_w.clone();
            let product_17 = s_u.clone() * c_2.clone();
            let product_18 = s_z.clone() * __kahan::integer::<T>(80);
            let c_36 = __kahan::integer::<T>(36);
            let product_19 = s_w.clone() * c_3.clone();
            let c_20 = __kahan::integer::<T>(20);
            let c_45 = __kahan::integer::<T>(45);
            let product_20 = s_u.clone() * c_10.clone();
            let product_21 = s_x.clone() * c_3.clone();
            let c_40 = __kahan::integer::<T>(40);
            let c_75 = __kahan::integer::<T>(75);
            let c_18 = __kahan::integer::<T>(18);
            let product_22 = s_z.clone() * c_4.clone();
            let c_16 = __kahan::integer::<T>(16);
            let product_23 = s_w.clone() * c_16.clone();
            let t_b_y = p_b.clone() * s_y.clone();
            let c_1_12 = __kahan::ratio::<T>(1, 12);
            let product_24 = s_x.clone() * c_6.clone();
            let c_70 = __kahan::integer::<T>(70);
            let product_25 = c_9.clone() * s_w.clone();
            let t_c_z = p_c.clone() * s_z.clone();
            let product_26 = c_2.clone() * s_y.clone();
            let product_27 = s_u.clone() * c_4.clone();
            let product_28 = c_9.clone() * s_v.clone();
            let product_29 = c_6.clone() * s_w.clone();
            let t_x_c = s_x.clone() * p_c.clone();
            let product_30 = s_x.clone() * c_9.clone();
            let product_31 = s_y.clone() * c_8.clone();
            let product_32 = c_6.clone() * s_v.clone();
            let product_33 = s_v.clone() * c_4.clone();
            let c_28 = __kahan::integer::<T>(28);
            let product_34 = s_x.clone() * c_28.clone();
            let c_25 = __kahan::integer::<T>(25);
            let product_35 = s_x.clone() * c_12.clone();
            let t_y_a = s_y.clone() * p_a.clone();
            let product_36 = s_z.clone() * c_12.clone();
            let product_37 = s_v.clone() * c_12.clone();
            let product_38 = s_x.clone() * c_7.clone();
            let product_39 = s_v.clone() * c_5.clone();
            let product_40 = s_u.clone() * c_5.clone();
            let t_x_b = s_x.clone() * p_b.clone();
            let t_u_a = s_u.clone() * p_a.clone();
            let c_60 = __kahan::integer::<T>(60);
            __kahan::matrix([
                [
                    (c_42.clone() * t_w_a.clone() - s_z.clone()
                        + c_6.clone() * (c_7.clone() * s_y.clone() + product_2.clone())
                            * p_c.clone()
                        + (s_x.clone() - product_1.clone() + c_9.clone()) * c_2.clone()
                            * p_b.clone()) * c_1_6.clone(),
                    (c_3.clone()
                        * (c_5.clone() * (product_5.clone() - product_6.clone())
                            + p_c.clone()
                                * (c_2.clone()
                                    * (s_x.clone() * c_35.clone() - product_2.clone())))
                        - p_a.clone()
                            * ((product_3.clone() - product_4.clone() - c_4.clone())
                                * c_10.clone())) * c_1_30.clone(),
                    c_1_6.clone()
                        * (p_a.clone()
                            * (c_2.clone()
                                * (product_7.clone() - product_8.clone() + product_9.clone()
                                    - s_w.clone() + c_1.clone()))
                            - (c_6.clone() * (s_u.clone() * p_b.clone()) + s_x.clone())),
                    -(c_1_6.clone()
                        * (p_b.clone()
                            * (c_6.clone() * (product_10.clone() + s_z.clone()))
                            - (product_11.clone() + s_u.clone() * c_12.clone()
                                - product_12.clone()
                                + p_a.clone()
                                    * (c_3.clone() * (s_v.clone() + c_3.clone()))))),
                    (c_5.clone()
                        * (c_2.clone()
                            * (s_v.clone() * c_8.clone()
                                + p_a.clone()
                                    * (c_3.clone() * (product_15.clone() + s_u.clone())))
                            + p_b.clone()
                                * (c_3.clone() * (product_14.clone() + c_9.clone())))
                        + p_c.clone()
                            * ((product_13.clone() - s_y.clone()) * c_24.clone()))
                        * c_1_60.clone(),
                    (c_5.clone()
                        * (c_6.clone() * (p_b.clone() * s_v.clone())
                            + c_4.clone() * t_c_w.clone() - product_7.clone()
                            - product_17.clone())
                        + p_a.clone()
                            * (s_x.clone() * c_105.clone() - product_16.clone()
                                + c_21.clone())) * __kahan::ratio::<T>(1, 15),
                ],
                [
                    -(c_1_60.clone()
                        * ((p_a.clone() * (product_13.clone() + product_7.clone())
                            - p_c.clone()
                                * (s_u.clone() * c_7.clone() + product_19.clone()))
                            * c_20.clone()
                            - p_b.clone()
                                * (product_18.clone() - s_v.clone() * c_36.clone()
                                    + c_15.clone()))),
                    -(c_1_60.clone()
                        * (c_5.clone()
                            * (p_a.clone()
                                * (c_4.clone() * (product_21.clone() - product_6.clone()))
                                - c_9.clone() * p_c.clone())
                            + p_b.clone()
                                * (c_4.clone()
                                    * (s_y.clone() * c_45.clone() - s_z.clone() * c_21.clone()
                                        + product_20.clone() - s_v.clone() * c_105.clone())))),
                    c_1_60.clone()
                        * (p_b.clone()
                            * (c_2.clone()
                                * (s_x.clone() * c_40.clone() + s_y.clone() * c_42.clone()
                                    - s_w.clone() * c_75.clone() + c_18.clone()))
                            - c_15.clone()
                                * (c_20.clone() * (s_v.clone() * p_c.clone())
                                    + p_a.clone() * (product_22.clone() - s_u.clone()))),
                    (p_a.clone() * (product_4.clone() + product_23.clone())
                        - c_8.clone() * (t_b_y.clone() + product_9.clone())
                        + p_c.clone()
                            * (c_2.clone()
                                * (s_x.clone() * __kahan::integer::<T>(14)
                                    + product_5.clone() + c_8.clone()))) * c_1_12.clone(),
                    -(c_1_30.clone()
                        * (c_10.clone()
                            * (c_3.clone()
                                * (c_5.clone() * t_c_z.clone() + product_17.clone())
                                + p_a.clone() * (product_2.clone() - product_25.clone()))
                            + p_b.clone()
                                * (c_3.clone()
                                    * (product_24.clone() - s_y.clone() * c_70.clone()
                                        - c_15.clone())))),
                    c_1_12.clone()
                        * (c_3.clone()
                            * (c_4.clone() * t_x_c.clone()
                                - p_b.clone()
                                    * (c_5.clone() * (product_15.clone() - c_1.clone())))
                            + p_a.clone()
                                * (c_4.clone()
                                    * (product_26.clone() + product_27.clone()
                                        + product_28.clone() + product_29.clone()))),
                ],
                [
                    -(c_1_60.clone()
                        * (c_10.clone()
                            * (product_32.clone()
                                + p_a.clone()
                                    * (product_30.clone() - product_31.clone() - c_4.clone()))
                            + p_b.clone()
                                * (s_z.clone() * c_45.clone()
                                    - s_u.clone() * __kahan::integer::<T>(84)
                                    - s_w.clone() * c_20.clone()))),
                    c_1_12.clone()
                        * (p_a.clone()
                            * (s_x.clone() * c_16.clone() + product_22.clone()
                                + c_3.clone())
                            + p_b.clone()
                                * (s_y.clone() * __kahan::integer::<T>(32)
                                    - s_u.clone() * c_15.clone() + product_33.clone()
                                    + product_23.clone())),
                    -(c_1_12.clone()
                        * (p_b.clone()
                            * (product_30.clone() - s_z.clone() * c_16.clone()
                                - s_v.clone() * c_16.clone())
                            - p_a.clone()
                                * (c_2.clone()
                                    * (product_26.clone() + product_1.clone()
                                        + s_w.clone() * c_21.clone() + c_18.clone())))),
                    c_1_60.clone()
                        * (c_10.clone()
                            * (s_v.clone()
                                + p_a.clone()
                                    * (c_2.clone() * (product_4.clone() + c_2.clone())))
                            + p_b.clone()
                                * (c_3.clone()
                                    * (product_34.clone() - s_y.clone() * c_25.clone()))
                            - p_c.clone()
                                * (c_10.clone()
                                    * (product_27.clone() - product_25.clone()))),
                    c_1_30.clone()
                        * (p_b.clone()
                            * (c_2.clone()
                                * (product_3.clone() + s_z.clone() * c_20.clone()
                                    + product_32.clone()))
                            - c_5.clone()
                                * (t_w_a.clone() * c_15.clone() + product_24.clone()
                                    - s_u.clone() - p_c.clone() * c_24.clone())),
                    c_1_60.clone()
                        * (c_6.clone()
                            * (c_15.clone() * (s_u.clone() * p_c.clone())
                                + p_a.clone()
                                    * (s_z.clone() * c_35.clone() - s_v.clone() * c_25.clone()
                                        + product_23.clone()))
                            + p_b.clone()
                                * (c_5.clone()
                                    * (s_x.clone() * c_4.clone() + s_y.clone() * c_16.clone()
                                        + c_3.clone()))),
                ],
                [
                    -(c_1_60.clone()
                        * (c_5.clone()
                            * (c_20.clone() * t_c_z.clone() - product_35.clone()
                                - product_5.clone() - s_v.clone() * c_28.clone())
                            + p_b.clone()
                                * (c_3.clone()
                                    * (s_y.clone() * c_10.clone() - s_w.clone() * c_28.clone()
                                        - c_25.clone())))),
                    -(c_1_60.clone()
                        * (p_b.clone()
                            * (c_15.clone()
                                * (product_10.clone() + product_31.clone()
                                    - product_5.clone()))
                            - (t_c_w.clone() * c_36.clone()
                                + p_a.clone()
                                    * (c_5.clone()
                                        * (product_22.clone() + s_v.clone() * c_24.clone()
                                            + c_9.clone()))))),
                    -(c_1_6.clone()
                        * (p_c.clone()
                            * (c_2.clone() * (product_13.clone() - c_1.clone()))
                            - (c_2.clone()
                                * (t_y_a.clone() - product_4.clone() + s_u.clone())
                                + p_b.clone()
                                    * (c_3.clone()
                                        * (product_32.clone() + c_7.clone() * s_w.clone()))))),
                    c_1_12.clone()
                        * (product_21.clone() + product_22.clone()
                            + p_c.clone()
                                * (c_2.clone()
                                    * (s_u.clone() * c_9.clone() + product_12.clone()))
                            + p_b.clone()
                                * (c_3.clone()
                                    * (product_7.clone() - s_v.clone() + c_16.clone()))),
                    c_1_12.clone()
                        * (c_4.clone()
                            * (c_6.clone() * t_y_a.clone() + product_38.clone())
                            + p_b.clone()
                                * (c_3.clone()
                                    * (product_36.clone() - s_u.clone() + product_37.clone()
                                        + s_w.clone() + c_2.clone()))),
                    c_1_60.clone()
                        * (p_c.clone()
                            * (s_y.clone() * c_36.clone() + s_u.clone() * c_40.clone()
                                + c_15.clone())
                            + p_b.clone()
                                * (c_3.clone()
                                    * (product_34.clone() + s_z.clone() * c_70.clone()
                                        + product_39.clone()
                                        + s_w.clone() * __kahan::integer::<T>(120)))),
                ],
                [
                    c_1_60.clone()
                        * (c_10.clone()
                            * (c_7.clone() * s_v.clone()
                                + p_b.clone()
                                    * (c_3.clone() * (s_z.clone() - s_w.clone() * c_5.clone())))
                            + p_c.clone()
                                * (c_3.clone()
                                    * (s_x.clone() * c_20.clone()
                                        - s_y.clone() * __kahan::integer::<T>(50)
                                        + product_40.clone() + c_28.clone()))),
                    -(c_1_30.clone()
                        * (p_c.clone()
                            * (c_3.clone()
                                * (s_x.clone() * c_25.clone() - product_6.clone()
                                    - c_10.clone()))
                            - (c_5.clone() * (s_z.clone() - product_37.clone())
                                + p_b.clone()
                                    * (c_4.clone()
                                        * (product_7.clone() + product_20.clone()))))),
                    c_1_12.clone()
                        * (c_2.clone() * (c_3.clone() * t_x_b.clone() + s_y.clone())
                            - p_c.clone()
                                * (c_3.clone() * (product_40.clone() - product_33.clone()))
                            - p_a.clone()
                                * (c_2.clone()
                                    * (c_6.clone() * s_z.clone() - product_19.clone()
                                        - c_8.clone()))),
                    c_1_12.clone()
                        * (c_2.clone()
                            * (c_8.clone() * t_b_y.clone() + product_5.clone()
                                + c_2.clone() * p_a.clone())
                            + p_c.clone()
                                * (product_21.clone() - product_8.clone()
                                    + product_37.clone() + product_6.clone())),
                    c_1_6.clone()
                        * (c_6.clone() * (s_v.clone() * p_a.clone()) + product_38.clone()
                            - s_y.clone() * c_12.clone() + c_6.clone() * p_b.clone()
                            + p_c.clone()
                                * (c_2.clone()
                                    * (product_4.clone() + product_5.clone()
                                        + product_6.clone()))),
                    -(c_1_30.clone()
                        * (c_3.clone()
                            * (c_25.clone() * t_x_b.clone()
                                - p_a.clone() * (product_16.clone() + product_14.clone()))
                            - p_c.clone()
                                * (c_6.clone() * s_y.clone() + product_40.clone()
                                    + s_v.clone() * c_20.clone() + c_15.clone()))),
                ],
                [
                    -(c_1_30.clone()
                        * (c_3.clone()
                            * (c_10.clone() * t_u_a.clone()
                                + s_x.clone() * __kahan::integer::<T>(100)
                                + product_26.clone() - s_v.clone() * c_15.clone()
                                + s_w.clone() * c_10.clone())
                            + p_c.clone()
                                * (c_20.clone() * (s_z.clone() - c_3.clone())))),
                    c_1_60.clone()
                        * (c_36.clone() * t_u_a.clone() + t_c_w.clone() * c_20.clone()
                            - product_35.clone() + s_y.clone() * c_60.clone()
                            + s_z.clone() * c_60.clone() - s_v.clone() * c_75.clone()
                            + p_b.clone() * __kahan::integer::<T>(240)),
                    -(c_1_30.clone()
                        * (c_2.clone()
                            * (c_10.clone() * t_x_c.clone()
                                - t_w_a.clone() * c_21.clone() - s_y.clone() * c_15.clone())
                            - p_b.clone()
                                * (product_18.clone() - s_u.clone() * c_75.clone()
                                    - product_37.clone() + c_60.clone()))),
                    -(c_1_30.clone()
                        * (c_5.clone()
                            * (c_15.clone() * (p_b.clone() * s_z.clone())
                                + c_2.clone() * t_c_w.clone())
                            + p_a.clone()
                                * (c_2.clone()
                                    * (s_x.clone() * c_15.clone() - product_11.clone()
                                        - s_u.clone() * __kahan::integer::<T>(30)
                                        - product_39.clone() - c_6.clone())))),
                    -(c_1_60.clone()
                        * (p_b.clone()
                            * (c_2.clone()
                                * (product_36.clone() + s_w.clone() * c_25.clone()
                                    - c_45.clone()))
                            - c_5.clone()
                                * (c_3.clone() * (product_24.clone() - product_3.clone())
                                    + p_a.clone()
                                        * (c_4.clone() * (s_u.clone() + product_28.clone()))))),
                    c_1_30.clone()
                        * (c_6.clone()
                            * (c_7.clone() * (p_a.clone() * s_z.clone())
                                - product_13.clone() - product_29.clone())
                            - p_b.clone()
                                * (c_5.clone() * (product_39.clone() - c_3.clone()))
                            + p_c.clone() * (c_10.clone() * (s_y.clone() - s_u.clone()))),
                ],
            ])
        }
        fn bilinear(
            &self,
            state: &__kahan::SVector<T, 6>,
            other: &__kahan::SVector<T, 6>,
        ) -> __kahan::SVector<T, 6> {
            let [s_x, s_y, s_z, s_u, s_v, s_w] = __kahan::components(state);
            let [o_x, o_y, o_z, o_u, o_v, o_w] = __kahan::components(other);
            let p_a = &self.a;
            let p_b = &self.b;
            let p_c = &self.c;
            let c_3 = __kahan::integer::<T>(3);
            let product_1 = c_3.clone() * s_y.clone();
            let c_15 = __kahan::integer::<T>(15);
            let product_2 = c_15.clone() * s_z.clone();
            let c_2 = __kahan::integer::<T>(2);
            let c_42 = __kahan::integer::<T>(42);
            let t_w_second_x = o_w.clone() * s_x.clone();
            let c_10 = __kahan::integer::<T>(10);
            let t_v_second_u = o_v.clone() * s_u.clone();
            let t_v_u_second = s_v.clone() * o_u.clone();
            let c_5 = __kahan::integer::<T>(5);
            let product_3 = s_x.clone() * c_5.clone();
            let c_6 = __kahan::integer::<T>(6);
            let c_35 = __kahan::integer::<T>(35);
            let product_4 = s_v.clone() * c_2.clone();
            let c_7 = __kahan::integer::<T>(7);
            let c_4 = __kahan::integer::<T>(4);
            let product_5 = c_2.clone() * s_x.clone();
            let product_6 = s_u.clone() * c_6.clone();
            let t_v_w_second = s_v.clone() * o_w.clone();
            let t_w_v_second = s_w.clone() * o_v.clone();
            let c_9 = __kahan::integer::<T>(9);
            let product_7 = s_y.clone() * c_9.clone();
            let c_12 = __kahan::integer::<T>(12);
            let product_8 = s_w.clone() * c_4.clone();
            let product_9 = c_3.clone() * s_u.clone();
            let product_10 = s_w.clone() * c_2.clone();
            let t_z_second_x = o_z.clone() * s_x.clone();
            let t_z_x_second = s_z.clone() * o_x.clone();
            let sum_11 = t_z_second_x.clone() + t_z_x_second.clone();
            let c_8 = __kahan::integer::<T>(8);
            let t_v_v_second = s_v.clone() * o_v.clone();
            let product_12 = c_8.clone() * t_v_v_second.clone();
            let product_13 = s_y.clone() * c_2.clone();
            let product_14 = s_u.clone() * c_4.clone();
            let product_15 = s_v.clone() * c_9.clone();
            let product_16 = s_w.clone() * c_6.clone();
            let product_17 = s_z.clone() * c_4.clone();
            let t_z_u_second = s_z.clone() * o_u.clone();
            let product_18 = c_3.clone() * t_z_u_second.clone();
            let c_45 = __kahan::integer::<T>(45);
            let c_21 = __kahan::integer::<T>(21);
            let product_19 = c_10.clone() * s_u.clone();
            let c_75 = __kahan::integer::<T>(75);
            let product_20 = c_3.clone() * s_x.clone();
            let c_20 = __kahan::integer::<T>(20);
            let product_21 = s_z.clone() * c_20.clone();
            let t_y_u_second = s_y.clone() * o_u.clone();
            let t_z_w_second = s_z.clone() * o_w.clone();
            let c_14 = __kahan::integer::<T>(14);
            let t_v_z_second = s_v.clone() * o_z.clone();
            let c_1_120 = __kahan::ratio::<T>(1, 120);
            let c_16 = __kahan::integer::<T>(16);
            let product_22 = s_w.clone() * c_16.clone();
            let product_23 = s_y.clone() * c_5.clone();
            let product_24 = s_v.clone() * c_6.clone();
            let product_25 = s_x.clone() * c_9.clone();
            let c_28 = __kahan::integer::<T>(28);
            let product_26 = s_x.clone() * c_28.clone();
            let c_25 = __kahan::integer::<T>(25);
            let product_27 = s_v.clone() * c_25.clone();
            let product_28 = s_x.clone() * c_4.clone();
            let product_29 = s_y.clone() * c_8.clone();
            let product_30 = s_x.clone() * c_6.clone();
            let t_v_x_second = s_v.clone() * o_x.clone();
            let product_31 = s_v.clone() * c_5.clone();
            let product_32 = s_z.clone() * c_12.clone();
            let product_33 = s_v.clone() * c_12.clone();
            let product_34 = c_3.clone() * s_z.clone();
            let t_y_z_second = s_y.clone() * o_z.clone();
            __kahan::vector([
                (c_5.clone()
                    * (c_2.clone()
                        * (o_x.clone() * (s_x.clone() - product_6.clone())
                            - c_3.clone()
                                * (o_z.clone() * s_u.clone()
                                    - c_2.clone() * t_v_w_second.clone()
                                    - c_2.clone() * t_w_v_second.clone())
                            - o_u.clone()
                                * (c_3.clone() * (product_5.clone() + s_z.clone())))
                        * p_b.clone()
                        - (sum_11.clone() - product_12.clone()
                            - o_y.clone()
                                * (c_3.clone() * (product_9.clone() - product_10.clone()))
                            + o_w.clone()
                                * (c_2.clone()
                                    * (product_1.clone() + c_2.clone() * s_u.clone()))
                            + o_u.clone()
                                * (product_8.clone()
                                    - (product_7.clone() + s_u.clone() * c_12.clone()))))
                    + c_2.clone()
                        * (c_5.clone()
                            * (c_4.clone() * (s_w.clone() * o_w.clone())
                                + o_x.clone()
                                    * (c_3.clone()
                                        * (s_y.clone() * c_7.clone() + product_4.clone())))
                            + o_y.clone()
                                * (c_3.clone()
                                    * (s_x.clone() * c_35.clone() - product_4.clone()))
                            + o_v.clone()
                                * ((product_3.clone() - s_y.clone()) * c_6.clone()))
                        * p_c.clone()
                    + (c_42.clone() * t_w_second_x.clone()
                        - c_10.clone() * (s_y.clone() * o_y.clone())
                        + c_3.clone() * t_v_second_u.clone()
                        + c_3.clone() * t_v_u_second.clone()
                        + c_42.clone() * (s_w.clone() * o_x.clone())
                        + s_z.clone()
                            * (c_2.clone()
                                * (c_3.clone() * o_y.clone() + c_3.clone() * o_v.clone()
                                    - o_w.clone()))
                        + (product_1.clone() - product_2.clone()
                            + c_3.clone() * s_v.clone() - s_w.clone()) * c_2.clone()
                            * o_z.clone()) * c_5.clone() * p_a.clone())
                    * __kahan::ratio::<T>(1, 60),
                -((p_a.clone()
                    * (c_5.clone()
                        * (c_12.clone() * (o_y.clone() * s_x.clone())
                            - product_18.clone() + product_12.clone()
                            + o_x.clone()
                                * (c_4.clone() * (product_3.clone() + product_1.clone()))
                            + o_z.clone()
                                * (c_3.clone() * (product_17.clone() - s_u.clone()))
                            - s_w.clone()
                                * (c_4.clone()
                                    * (c_2.clone() * o_y.clone() + o_u.clone() * c_4.clone()
                                        + o_v.clone() * c_9.clone()))
                            - o_w.clone()
                                * (c_4.clone()
                                    * (product_13.clone() + product_14.clone()
                                        + product_15.clone() + product_16.clone()))))
                    - c_2.clone()
                        * (c_5.clone()
                            * (p_c.clone()
                                * (c_2.clone()
                                    * (c_3.clone()
                                        * (t_w_second_x.clone()
                                            - c_5.clone() * (s_z.clone() * o_v.clone())
                                            - c_5.clone() * t_v_z_second.clone())
                                        + o_x.clone()
                                            * (s_u.clone() * c_7.clone() + c_3.clone() * s_w.clone()))
                                    + o_u.clone()
                                        * (s_x.clone() * c_14.clone() + product_9.clone()))
                                - c_12.clone()
                                    * (t_v_second_u.clone() + t_v_u_second.clone()))
                            + p_b.clone()
                                * (o_z.clone()
                                    * (s_x.clone() * __kahan::integer::<T>(40)
                                        + s_y.clone() * c_42.clone() - s_w.clone() * c_75.clone())
                                    - (c_5.clone()
                                        * (c_4.clone() * t_y_u_second.clone()
                                            + c_15.clone() * t_z_w_second.clone())
                                        - o_x.clone()
                                            * (c_2.clone() * (product_21.clone() - product_15.clone()))
                                        + o_v.clone()
                                            * (c_6.clone()
                                                * (product_20.clone() - s_y.clone() * c_35.clone())))
                                    - o_y.clone()
                                        * (c_2.clone()
                                            * (s_y.clone() * c_45.clone() - s_z.clone() * c_21.clone()
                                                + product_19.clone()
                                                - s_v.clone() * __kahan::integer::<T>(105))))))
                    * c_1_120.clone()),
                -(c_1_120.clone()
                    * (c_2.clone()
                        * (c_5.clone()
                            * (o_u.clone()
                                * (p_c.clone()
                                    * (product_14.clone() - s_w.clone() * c_9.clone())
                                    - s_v.clone())
                                - (c_3.clone()
                                    * (c_3.clone() * (o_w.clone() * (s_u.clone() * p_c.clone()))
                                        - c_2.clone() * t_v_x_second.clone())
                                    + o_v.clone() * (s_u.clone() - product_30.clone())))
                            + p_a.clone()
                                * (c_5.clone()
                                    * (o_x.clone() * (product_25.clone() - product_29.clone())
                                        - c_3.clone()
                                            * (c_2.clone() * t_z_u_second.clone()
                                                - c_5.clone() * t_w_v_second.clone())
                                        - o_y.clone()
                                            * (c_2.clone() * (product_28.clone() + s_z.clone()))
                                        - o_z.clone()
                                            * (product_13.clone() + product_6.clone()
                                                + s_w.clone() * c_21.clone()))
                                    - o_w.clone()
                                        * (c_3.clone()
                                            * (s_z.clone() * c_35.clone() - product_27.clone()
                                                + product_22.clone()))))
                        + p_b.clone()
                            * (o_z.clone()
                                * (c_5.clone()
                                    * (product_25.clone() - s_z.clone() * c_16.clone()
                                        - s_v.clone() * c_16.clone()))
                                - (o_u.clone()
                                    * (c_3.clone()
                                        * (product_26.clone() - s_y.clone() * c_25.clone()))
                                    + o_w.clone()
                                        * (c_20.clone() * (s_x.clone() + s_y.clone() * c_4.clone()))
                                    + o_x.clone()
                                        * (s_w.clone() * c_20.clone()
                                            - (s_z.clone() * c_45.clone()
                                                - s_u.clone() * __kahan::integer::<T>(84))))
                                - o_v.clone()
                                    * (c_4.clone()
                                        * (product_23.clone() + product_21.clone()
                                            + product_24.clone()))
                                - o_y.clone()
                                    * (c_5.clone()
                                        * (s_y.clone() * __kahan::integer::<T>(32)
                                            - c_15.clone() * s_u.clone() + s_v.clone() * c_4.clone()
                                            + product_22.clone()))))),
                -(c_1_120.clone()
                    * (p_c.clone()
                        * (c_2.clone()
                            * (c_2.clone()
                                * (t_z_second_x.clone() * c_25.clone()
                                    + t_z_x_second.clone() * c_25.clone()
                                    - c_9.clone() * (s_w.clone() * o_y.clone()))
                                - o_u.clone()
                                    * (c_5.clone()
                                        * (s_u.clone() * c_9.clone() + product_8.clone()))
                                - o_w.clone()
                                    * (c_2.clone() * (product_7.clone() + product_19.clone()))))
                        - c_5.clone()
                            * (c_4.clone()
                                * (c_7.clone() * (o_v.clone() * s_x.clone())
                                    + o_z.clone() * (s_u.clone() - product_34.clone()))
                                + o_u.clone() * (product_20.clone() + product_17.clone())
                                + o_x.clone()
                                    * (s_x.clone() * c_12.clone() + product_9.clone()
                                        + s_v.clone() * c_28.clone())
                                + p_a.clone()
                                    * (c_4.clone()
                                        * (s_y.clone() * (o_z.clone() + o_v.clone() * c_6.clone())
                                            + o_y.clone() * (s_z.clone() + product_24.clone()))))
                        + p_b.clone()
                            * (c_3.clone()
                                * (c_2.clone()
                                    * (o_x.clone()
                                        * (product_23.clone() - s_w.clone() * c_14.clone())
                                        - o_z.clone()
                                            * (c_5.clone()
                                                * (product_24.clone() + s_w.clone() * c_7.clone())))
                                    - o_u.clone()
                                        * (c_5.clone() * (product_1.clone() - s_v.clone()))
                                    + o_y.clone()
                                        * (c_5.clone()
                                            * (product_5.clone() + product_29.clone()
                                                - product_9.clone()))
                                    - o_v.clone()
                                        * (c_5.clone()
                                            * (product_32.clone() - s_u.clone() + product_33.clone()
                                                + s_w.clone()))
                                    - o_w.clone()
                                        * (product_26.clone()
                                            + s_z.clone() * __kahan::integer::<T>(70)
                                            + product_31.clone()
                                            + s_w.clone() * __kahan::integer::<T>(120)))))),
                c_1_120.clone()
                    * (c_2.clone()
                        * (c_5.clone()
                            * (t_y_z_second.clone()
                                + c_3.clone() * (s_u.clone() * o_u.clone())
                                + c_7.clone() * t_v_x_second.clone()
                                + o_y.clone() * (s_z.clone() - product_33.clone())
                                + o_v.clone()
                                    * (s_x.clone() * c_7.clone() - s_y.clone() * c_12.clone()))
                            - p_a.clone()
                                * (c_3.clone()
                                    * (c_5.clone()
                                        * (o_z.clone() * (s_z.clone() * c_2.clone() - s_w.clone())
                                            - c_2.clone() * t_v_v_second.clone())
                                        - o_w.clone()
                                            * (s_z.clone() * c_5.clone() + s_w.clone() * c_8.clone())))
                            + p_b.clone()
                                * (c_5.clone()
                                    * (c_8.clone() * t_y_u_second.clone()
                                        + s_x.clone()
                                            * (c_3.clone() * (o_z.clone() - o_w.clone() * c_5.clone()))
                                        + o_x.clone()
                                            * (c_3.clone() * (s_z.clone() - s_w.clone() * c_5.clone())))
                                    + o_y.clone()
                                        * (c_4.clone() * (product_1.clone() + product_19.clone()))))
                        + p_c.clone()
                            * (c_2.clone()
                                * (c_3.clone()
                                    * (c_5.clone()
                                        * (c_2.clone() * t_v_z_second.clone()
                                            + o_x.clone() * (product_5.clone() - product_23.clone()))
                                        + o_y.clone()
                                            * (product_10.clone() - s_x.clone() * c_25.clone()))
                                    + o_v.clone()
                                        * (c_10.clone() * (product_34.clone() + product_10.clone()))
                                    + o_w.clone()
                                        * (c_2.clone()
                                            * (product_1.clone() + s_v.clone() * c_10.clone())))
                                + s_u.clone()
                                    * (c_5.clone()
                                        * (c_3.clone() * o_x.clone() - c_15.clone() * o_z.clone()
                                            + o_v.clone() * c_12.clone() + c_2.clone() * o_w.clone()))
                                + o_u.clone()
                                    * (c_5.clone()
                                        * (product_20.clone() - product_2.clone()
                                            + product_33.clone() + product_10.clone())))),
                -(c_1_120.clone()
                    * (c_3.clone()
                        * (o_w.clone()
                            * (c_4.clone() * (product_3.clone() + product_16.clone()))
                            - c_5.clone()
                                * (c_4.clone() * t_y_z_second.clone()
                                    + o_v.clone() * (product_30.clone() - product_23.clone()))
                            + o_x.clone()
                                * (c_2.clone()
                                    * (s_x.clone() * __kahan::integer::<T>(100)
                                        + product_13.clone() - c_15.clone() * s_v.clone()
                                        + s_w.clone() * c_10.clone()))
                            + o_y.clone()
                                * (product_28.clone() - s_y.clone() * c_20.clone()
                                    - product_21.clone() + product_27.clone()))
                        + p_c.clone()
                            * (c_20.clone()
                                * (c_2.clone() * sum_11.clone()
                                    + s_w.clone() * (o_u.clone() - o_y.clone())
                                    + o_w.clone() * (s_u.clone() - s_y.clone())))
                        - p_b.clone()
                            * (c_2.clone()
                                * (o_z.clone()
                                    * (s_z.clone() * __kahan::integer::<T>(80)
                                        - s_u.clone() * c_75.clone() - product_33.clone())
                                    - (c_25.clone()
                                        * (product_18.clone() + t_v_w_second.clone())
                                        + o_v.clone()
                                            * (product_32.clone() + s_w.clone() * c_25.clone()))))
                        + p_a.clone()
                            * (c_4.clone()
                                * (o_u.clone()
                                    * (c_15.clone() * s_x.clone() - product_7.clone()
                                        - s_u.clone() * __kahan::integer::<T>(30)
                                        - product_31.clone())
                                    - (c_3.clone()
                                        * (c_7.clone() * t_z_w_second.clone()
                                            + c_15.clone() * t_v_v_second.clone()
                                            + c_7.clone() * (s_w.clone() * o_z.clone()))
                                        + s_u.clone()
                                            * (o_v.clone() * c_5.clone()
                                                - (c_15.clone() * o_x.clone()
                                                    - o_y.clone() * c_9.clone()))))))),
            ])
        }
        fn polarized(
            &self,
            state: &__kahan::SVector<T, 6>,
            other: &__kahan::SVector<T, 6>,
        ) -> __kahan::SVector<T, 6> {
            let [s_x, s_y, s_z, s_u, s_v, s_w] = __kahan::components(state);
            let [o_x, o_y, o_z, o_u, o_v, o_w] = __kahan::components(other);
            let p_a = &self.a;
            let p_b = &self.b;
            let p_c = &self.c;
            let c_3 = __kahan::integer::<T>(3);
            let product_1 = c_3.clone() * s_y.clone();
            let c_15 = __kahan::integer::<T>(15);
            let product_2 = c_15.clone() * s_z.clone();
            let product_3 = c_3.clone() * s_v.clone();
            let c_1 = __kahan::integer::<T>(1);
            let c_10 = __kahan::integer::<T>(10);
            let c_5 = __kahan::integer::<T>(5);
            let product_4 = c_5.clone() * s_x.clone();
            let c_42 = __kahan::integer::<T>(42);
            let product_5 = s_y.clone() * c_5.clone();
            let c_4 = __kahan::integer::<T>(4);
            let product_6 = c_5.clone() * o_x.clone();
            let c_8 = __kahan::integer::<T>(8);
            let product_7 = s_y.clone() * c_8.clone();
            let c_14 = __kahan::integer::<T>(14);
            let c_6 = __kahan::integer::<T>(6);
            let product_8 = s_u.clone() * c_6.clone();
            let c_9 = __kahan::integer::<T>(9);
            let c_28 = __kahan::integer::<T>(28);
            let product_9 = s_w.clone() * c_8.clone();
            let c_7 = __kahan::integer::<T>(7);
            let c_2 = __kahan::integer::<T>(2);
            let product_10 = s_x.clone() * c_2.clone();
            let c_21 = __kahan::integer::<T>(21);
            let c_35 = __kahan::integer::<T>(35);
            let product_11 = s_v.clone() * c_2.clone();
            let product_12 = s_y.clone() * c_9.clone();
            let c_12 = __kahan::integer::<T>(12);
            let product_13 = c_3.clone() * s_u.clone();
            let product_14 = s_w.clone() * c_2.clone();
            let t_v_v_second = s_v.clone() * o_v.clone();
            let c_1_840 = __kahan::ratio::<T>(1, 840);
            let c_40 = __kahan::integer::<T>(40);
            let c_75 = __kahan::integer::<T>(75);
            let product_15 = s_w.clone() * c_75.clone();
            let c_18 = __kahan::integer::<T>(18);
            let c_45 = __kahan::integer::<T>(45);
            let product_16 = c_10.clone() * s_u.clone();
            let product_17 = s_x.clone() * c_6.clone();
            let c_70 = __kahan::integer::<T>(70);
            let product_18 = s_z.clone() * __kahan::integer::<T>(80);
            let c_36 = __kahan::integer::<T>(36);
            let t_y_u_second = s_y.clone() * o_u.clone();
            let product_19 = c_15.clone() * s_x.clone();
            let product_20 = s_y.clone() * c_2.clone();
            let product_21 = c_4.clone() * s_u.clone();
            let product_22 = s_w.clone() * c_6.clone();
            let product_23 = o_y.clone() * c_2.clone();
            let product_24 = s_z.clone() * c_4.clone();
            let c_84 = __kahan::integer::<T>(84);
            let c_24 = __kahan::integer::<T>(24);
            let product_25 = s_x.clone() * c_14.clone();
            let product_26 = c_3.clone() * s_w.clone();
            let c_60 = __kahan::integer::<T>(60);
            let c_16 = __kahan::integer::<T>(16);
            let product_27 = s_u.clone() * c_16.clone();
            let product_28 = o_y.clone() * c_9.clone();
            let product_29 = s_v.clone() * c_4.clone();
            let product_30 = s_w.clone() * c_16.clone();
            let product_31 = s_x.clone() * c_4.clone();
            let c_20 = __kahan::integer::<T>(20);
            let product_32 = s_z.clone() * c_20.clone();
            let product_33 = s_v.clone() * c_6.clone();
            let product_34 = s_x.clone() * c_9.clone();
            let product_35 = s_x.clone() * c_28.clone();
            let c_25 = __kahan::integer::<T>(25);
            let product_36 = s_w.clone() * c_7.clone();
            let product_37 = s_v.clone() * c_25.clone();
            let c_30 = __kahan::integer::<T>(30);
            let product_38 = s_z.clone() * c_12.clone();
            let product_39 = s_v.clone() * c_12.clone();
            let product_40 = s_v.clone() * c_5.clone();
            let product_41 = s_y.clone() * c_10.clone();
            let t_u_second_u = o_u.clone() * s_u.clone();
            let product_42 = c_3.clone() * s_x.clone();
            let product_43 = c_3.clone() * s_z.clone();
            let product_44 = c_5.clone() * s_u.clone();
            let product_45 = s_w.clone() * c_5.clone();
            let t_y_z_second = s_y.clone() * o_z.clone();
            __kahan::vector([
                (c_14.clone()
                    * (c_2.clone()
                        * (c_5.clone()
                            * (c_4.clone() * (s_w.clone() * o_w.clone())
                                + o_x.clone()
                                    * (c_3.clone()
                                        * (s_y.clone() * c_7.clone() + product_11.clone())))
                            + o_y.clone()
                                * (c_3.clone()
                                    * (s_x.clone() * c_35.clone() - product_11.clone()))
                            + o_v.clone()
                                * (c_6.clone() * (product_4.clone() - s_y.clone())))
                        * p_c.clone()
                        - c_5.clone()
                            * (o_z.clone() * s_x.clone() + s_z.clone() * o_x.clone()
                                - c_8.clone() * t_v_v_second.clone()
                                - o_y.clone()
                                    * (c_3.clone() * (product_13.clone() - product_14.clone()))
                                + o_w.clone()
                                    * (c_2.clone()
                                        * (product_1.clone() + s_u.clone() * c_2.clone()))
                                + o_u.clone()
                                    * (s_w.clone() * c_4.clone()
                                        - (product_12.clone() + s_u.clone() * c_12.clone()))))
                    + c_5.clone()
                        * (o_x.clone()
                            * ((s_x.clone() - product_8.clone() + c_9.clone())
                                * c_28.clone())
                            - c_3.clone()
                                * (c_4.clone()
                                    * (c_7.clone() * (o_z.clone() * s_u.clone())
                                        - s_x.clone() * c_21.clone() - c_2.clone())
                                    - s_v.clone()
                                        * (c_7.clone() * (o_w.clone() * c_8.clone() + c_9.clone()))
                                    + o_u.clone()
                                        * (c_28.clone() * (product_10.clone() + s_z.clone()))
                                    - o_v.clone()
                                        * ((product_9.clone() + c_9.clone()) * c_7.clone())))
                        * p_b.clone()
                    + (c_15.clone() * (s_v.clone() + c_3.clone()) * o_u.clone()
                        - (o_y.clone()
                            * (c_10.clone() * (product_5.clone() - c_4.clone()))
                            - (c_5.clone()
                                * (product_7.clone()
                                    + c_3.clone() * (o_v.clone() + c_3.clone()) * s_u.clone())
                                + s_w.clone()
                                    * (c_42.clone() * (product_6.clone() + c_1.clone()))))
                        + o_w.clone()
                            * ((product_4.clone() + c_1.clone()) * c_42.clone())
                        + s_z.clone()
                            * (c_10.clone()
                                * (c_3.clone() * o_y.clone() + c_3.clone() * o_v.clone()
                                    - o_w.clone() + c_1.clone()))
                        + (product_1.clone() - product_2.clone() + product_3.clone()
                            - s_w.clone() + c_1.clone()) * c_10.clone() * o_z.clone())
                        * c_14.clone() * p_a.clone()) * c_1_840.clone(),
                -(c_1_840.clone()
                    * (c_5.clone()
                        * (p_a.clone()
                            * (c_84.clone() * (o_y.clone() * s_x.clone())
                                - c_21.clone() * (s_z.clone() * o_u.clone())
                                + t_v_v_second.clone() * __kahan::integer::<T>(56)
                                - c_24.clone()
                                + o_x.clone()
                                    * (c_28.clone() * (product_4.clone() + product_1.clone()))
                                + o_z.clone()
                                    * (c_21.clone() * (product_24.clone() - s_u.clone()))
                                - s_w.clone()
                                    * (c_28.clone()
                                        * (product_23.clone() + o_u.clone() * c_4.clone()
                                            + o_v.clone() * c_9.clone()))
                                - o_w.clone()
                                    * (c_28.clone()
                                        * (product_20.clone() + product_21.clone()
                                            + s_v.clone() * c_9.clone() + product_22.clone())))
                            - c_7.clone()
                                * (p_c.clone()
                                    * (c_12.clone() * (o_w.clone() * s_x.clone())
                                        - c_60.clone() * (s_z.clone() * o_v.clone())
                                        - c_60.clone() * (s_v.clone() * o_z.clone())
                                        + product_12.clone() + product_27.clone()
                                        + product_28.clone()
                                        + o_x.clone()
                                            * (c_4.clone()
                                                * (s_u.clone() * c_7.clone() + product_26.clone()))
                                        + o_u.clone()
                                            * (c_2.clone()
                                                * (product_25.clone() + product_13.clone() + c_8.clone())))
                                    - c_24.clone()
                                        * (o_v.clone() * s_u.clone() + s_v.clone() * o_u.clone())))
                        - p_b.clone()
                            * (c_7.clone()
                                * (o_z.clone()
                                    * (c_2.clone()
                                        * (s_x.clone() * c_40.clone() + s_y.clone() * c_42.clone()
                                            - product_15.clone() + c_18.clone()))
                                    - (c_40.clone() * t_y_u_second.clone() - product_19.clone()
                                        - s_z.clone() * c_36.clone()
                                        - s_v.clone() * __kahan::integer::<T>(90)
                                        - product_15.clone()
                                        + o_w.clone()
                                            * (c_75.clone() * (s_z.clone() * c_2.clone() - c_1.clone()))
                                        - o_x.clone()
                                            * (product_18.clone() - s_v.clone() * c_36.clone()
                                                + c_15.clone())
                                        + o_v.clone()
                                            * (c_6.clone()
                                                * (product_17.clone() - s_y.clone() * c_70.clone()
                                                    - c_15.clone()))
                                        + o_y.clone()
                                            * (c_4.clone()
                                                * (s_y.clone() * c_45.clone() - s_z.clone() * c_21.clone()
                                                    + product_16.clone()
                                                    - s_v.clone() * __kahan::integer::<T>(105)))))))),
                -(c_1_840.clone()
                    * (c_7.clone()
                        * (c_10.clone()
                            * (s_v.clone() * (o_x.clone() * c_6.clone() - o_u.clone())
                                + o_v.clone() * (product_17.clone() - s_u.clone())
                                + p_c.clone()
                                    * (o_u.clone()
                                        * (product_21.clone() - s_w.clone() * c_9.clone())
                                        - c_3.clone()
                                            * (c_3.clone() * (o_w.clone() * s_u.clone())
                                                + s_v.clone() * c_8.clone() + o_v.clone() * c_8.clone())))
                            + p_a.clone()
                                * (o_w.clone()
                                    * (c_6.clone() * (product_37.clone() - product_30.clone()))
                                    - c_5.clone()
                                        * (o_u.clone() * c_8.clone()
                                            - (c_30.clone() * (s_w.clone() * o_v.clone())
                                                - s_x.clone() * c_8.clone() - product_1.clone()
                                                - s_u.clone() * c_8.clone())
                                            + o_y.clone() * (s_x.clone() * c_16.clone() + c_3.clone()))
                                    + o_x.clone()
                                        * (c_10.clone()
                                            * (product_34.clone() - product_7.clone() - c_4.clone()))
                                    - s_z.clone()
                                        * (c_10.clone()
                                            * (product_23.clone() + o_u.clone() * c_6.clone()
                                                + o_w.clone() * c_21.clone() + c_18.clone()))
                                    - o_z.clone()
                                        * (c_10.clone()
                                            * (product_20.clone() + product_8.clone()
                                                + s_w.clone() * c_21.clone() + c_18.clone()))))
                        + p_b.clone()
                            * (o_x.clone()
                                * (c_7.clone()
                                    * (s_z.clone() * c_45.clone() - s_u.clone() * c_84.clone()
                                        - s_w.clone() * c_20.clone()))
                                - c_3.clone()
                                    * (c_5.clone() * (product_36.clone() + c_8.clone())
                                        + o_u.clone()
                                            * (c_7.clone()
                                                * (product_35.clone() - s_y.clone() * c_25.clone())))
                                + o_z.clone()
                                    * (c_35.clone()
                                        * (product_34.clone() - s_z.clone() * c_16.clone()
                                            - s_v.clone() * c_16.clone()))
                                - o_v.clone()
                                    * (c_28.clone()
                                        * (product_5.clone() + product_32.clone()
                                            + product_33.clone()))
                                - o_w.clone()
                                    * (c_35.clone()
                                        * (product_31.clone() + s_y.clone() * c_16.clone()
                                            + c_3.clone()))
                                - o_y.clone()
                                    * (c_35.clone()
                                        * (s_y.clone() * __kahan::integer::<T>(32)
                                            - c_15.clone() * s_u.clone() + product_29.clone()
                                            + product_30.clone()))))),
                -(c_1_840.clone()
                    * (p_c.clone()
                        * (c_10.clone()
                            * (s_z.clone()
                                * (c_14.clone() * (product_6.clone() - c_1.clone()))
                                - c_3.clone()
                                    * (c_21.clone() * t_u_second_u.clone() + c_4.clone())
                                + o_z.clone()
                                    * (c_14.clone() * (product_4.clone() - c_1.clone())))
                            - s_w.clone()
                                * (c_7.clone()
                                    * (o_y.clone() * c_36.clone() + o_u.clone() * c_40.clone()
                                        + c_15.clone()))
                            - o_w.clone()
                                * (c_7.clone()
                                    * (s_y.clone() * c_36.clone() + s_u.clone() * c_40.clone()
                                        + c_15.clone())))
                        - c_35.clone()
                            * (c_4.clone()
                                * (c_7.clone() * (o_v.clone() * s_x.clone())
                                    + o_z.clone() * (s_u.clone() - product_43.clone()))
                                + o_u.clone() * (product_42.clone() + product_24.clone())
                                + o_x.clone()
                                    * (s_x.clone() * c_12.clone() + product_13.clone()
                                        + s_v.clone() * c_28.clone())
                                + p_a.clone()
                                    * (s_y.clone()
                                        * (o_z.clone() * c_4.clone() + o_v.clone() * c_24.clone()
                                            + c_9.clone())
                                        + o_y.clone()
                                            * (product_24.clone() + s_v.clone() * c_24.clone()
                                                + c_9.clone())))
                        + p_b.clone()
                            * (c_21.clone()
                                * (o_x.clone()
                                    * (product_41.clone() - s_w.clone() * c_28.clone()
                                        - c_25.clone())
                                    - c_5.clone()
                                        * (product_4.clone() + product_27.clone()
                                            + product_11.clone()
                                            + o_z.clone()
                                                * (c_2.clone() * (product_33.clone() + product_36.clone())))
                                    + o_y.clone()
                                        * (c_5.clone()
                                            * (product_10.clone() + product_7.clone()
                                                - product_13.clone()))
                                    - o_u.clone()
                                        * (c_5.clone()
                                            * (product_1.clone() - s_v.clone() + c_16.clone()))
                                    - o_w.clone()
                                        * (product_35.clone() + s_z.clone() * c_70.clone()
                                            + product_40.clone()
                                            + s_w.clone() * __kahan::integer::<T>(120))
                                    - o_v.clone()
                                        * (c_5.clone()
                                            * (product_38.clone() - s_u.clone() + product_39.clone()
                                                + s_w.clone() + c_2.clone())))))),
                c_1_840.clone()
                    * (c_2.clone()
                        * (p_b.clone()
                            * (c_5.clone()
                                * (c_2.clone()
                                    * (c_28.clone() * t_y_u_second.clone()
                                        + s_v.clone() * c_21.clone() + o_v.clone() * c_21.clone()
                                        + c_6.clone())
                                    + s_x.clone()
                                        * (c_21.clone() * (o_z.clone() - o_w.clone() * c_5.clone()))
                                    + o_x.clone()
                                        * (c_21.clone() * (s_z.clone() - product_45.clone())))
                                + o_y.clone()
                                    * (c_28.clone() * (product_1.clone() + product_16.clone())))
                            - c_7.clone()
                                * (p_a.clone()
                                    * (o_z.clone()
                                        * (c_5.clone()
                                            * (s_z.clone() * c_6.clone() - product_26.clone()
                                                - c_8.clone()))
                                        - (c_10.clone()
                                            * (c_3.clone() * t_v_v_second.clone() + product_24.clone()
                                                + s_u.clone() + o_u.clone())
                                            + o_w.clone()
                                                * (c_3.clone()
                                                    * (s_z.clone() * c_5.clone() + product_9.clone()))))
                                    - c_5.clone()
                                        * (t_y_z_second.clone() + c_3.clone() * t_u_second_u.clone()
                                            + c_7.clone() * (s_v.clone() * o_x.clone())
                                            + o_y.clone() * (s_z.clone() - product_39.clone())
                                            + o_v.clone()
                                                * (s_x.clone() * c_7.clone()
                                                    - s_y.clone() * c_12.clone()))))
                        + p_c.clone()
                            * (c_7.clone()
                                * (o_v.clone()
                                    * (c_20.clone()
                                        * (product_43.clone() + product_13.clone()
                                            + product_14.clone()))
                                    - c_3.clone()
                                        * (o_z.clone()
                                            * (c_5.clone() * (product_44.clone() - product_29.clone()))
                                            - c_2.clone()
                                                * (product_25.clone() + product_41.clone()
                                                    + product_45.clone())
                                            + o_y.clone()
                                                * (c_2.clone()
                                                    * (s_x.clone() * c_25.clone() - product_14.clone()
                                                        - c_10.clone())))
                                    + o_x.clone()
                                        * (c_3.clone()
                                            * (s_x.clone() * c_20.clone()
                                                - s_y.clone() * __kahan::integer::<T>(50)
                                                + product_44.clone() + c_28.clone()))
                                    + o_u.clone()
                                        * (c_5.clone()
                                            * (product_42.clone() - product_2.clone()
                                                + product_39.clone() + product_14.clone()))
                                    + o_w.clone()
                                        * (c_2.clone()
                                            * (s_y.clone() * c_6.clone() + product_44.clone()
                                                + s_v.clone() * c_20.clone() + c_15.clone()))))),
                -(c_1_840.clone()
                    * (c_21.clone()
                        * (o_w.clone()
                            * (c_4.clone() * (product_4.clone() + product_22.clone()))
                            - c_5.clone()
                                * (c_4.clone() * t_y_z_second.clone()
                                    + o_v.clone() * (product_17.clone() - product_5.clone()))
                            + o_x.clone()
                                * (c_2.clone()
                                    * (s_x.clone() * __kahan::integer::<T>(100)
                                        + product_20.clone() - c_15.clone() * s_v.clone()
                                        + s_w.clone() * c_10.clone()))
                            + o_y.clone()
                                * (product_31.clone() - s_y.clone() * c_20.clone()
                                    - product_32.clone() + product_37.clone()))
                        + p_c.clone()
                            * (c_20.clone()
                                * (c_2.clone()
                                    * (s_x.clone() * (c_7.clone() * (o_z.clone() - c_3.clone()))
                                        - c_3.clone())
                                    - s_w.clone() * (c_7.clone() * (o_y.clone() - o_u.clone()))
                                    + o_x.clone() * (c_14.clone() * (s_z.clone() - c_3.clone()))
                                    - o_w.clone()
                                        * (c_7.clone() * (s_y.clone() - s_u.clone()))))
                        + p_a.clone()
                            * (c_28.clone()
                                * (o_u.clone()
                                    * (product_19.clone() - product_12.clone()
                                        - s_u.clone() * c_30.clone() - product_40.clone()
                                        - c_6.clone())
                                    - (c_3.clone()
                                        * (c_7.clone() * (s_z.clone() * o_w.clone())
                                            + c_15.clone() * t_v_v_second.clone()
                                            + c_7.clone() * (s_w.clone() * o_z.clone()))
                                        + s_u.clone()
                                            * (c_6.clone()
                                                - (c_15.clone() * o_x.clone() - product_28.clone()
                                                    - o_v.clone() * c_5.clone())))))
                        - p_b.clone()
                            * (c_14.clone()
                                * (o_z.clone()
                                    * (product_18.clone() - s_u.clone() * c_75.clone()
                                        - product_39.clone() + c_60.clone())
                                    - (c_5.clone()
                                        * (c_3.clone()
                                            * (s_z.clone() * (c_5.clone() * o_u.clone() - c_4.clone())
                                                - (product_7.clone() + product_3.clone() + s_w.clone()
                                                    + o_y.clone() * c_8.clone()))
                                            + o_w.clone() * (product_40.clone() - c_3.clone()))
                                        + o_v.clone()
                                            * (product_38.clone() + s_w.clone() * c_25.clone()
                                                - c_45.clone())))))),
            ])
        }
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 6> for Dense<T> {
        fn increment(
            &self,
            state: &__kahan::SVector<T, 6>,
            half_step: &T,
        ) -> __kahan::Option<__kahan::SVector<T, 6>> {
            __kahan::increment_by_elimination(self, state, half_step)
        }
    }
};
