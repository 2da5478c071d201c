/// A pendulum.
///
/// Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the quadratic lift
///
/// ```text
/// xdot = v
/// vdot = -g*sin_x
/// sin_xdot = v*cos_x
/// cos_xdot = -v*sin_x
/// ```
///
/// Reason for this lift: its map keeps the energy exactly. Its new variables:
///
/// ```text
/// sin_x = sin(x)
/// cos_x = cos(x)
/// ```
///
/// Relations, which hold at embedded points:
///
/// ```text
/// -1 + sin_x^2 + cos_x^2 = 0  // the map keeps (sin_x^2 + cos_x^2)/(1 + eps^2*v^2)
/// sin_x - (sin(x)) = 0
/// cos_x - (cos(x)) = 0
/// ```
///
/// The energy that the map keeps exactly:
///
/// ```text
/// 1/2*v^2 - g*cos_x - 1/2*eps^2*g^2*sin_x^2
/// ```
///
/// Matrix A(x,ε) = I − ε f′(x), row by row:
///
/// ```text
/// [ 1, -eps, 0, 0 ]
/// [ 0, 1, eps*g, 0 ]
/// [ 0, -eps*cos_x, 1, -eps*v ]
/// [ 0, eps*sin_x, eps*v, 1 ]
/// ```
///
/// The map, over its common denominator in lowest terms:
///
/// ```text
/// x~ = x + 2*eps*(v - eps*g*sin_x + eps^2*v^3 - eps^3*g*v^2*sin_x)/(1 + eps^2*v^2
///     + eps^2*g*cos_x - eps^3*g*v*sin_x)
/// v~ = v + 2*eps*(-g*sin_x - eps*g*v*cos_x)/(1 + eps^2*v^2 + eps^2*g*cos_x - eps^3*g*v*sin_x)
/// sin_x~ = sin_x + 2*eps*(v*cos_x - eps*v^2*sin_x - eps*g*sin_x*cos_x + eps^2*g*v*sin_x^2)/(1
///     + eps^2*v^2 + eps^2*g*cos_x - eps^3*g*v*sin_x)
/// cos_x~ = cos_x + 2*eps*(-v*sin_x - eps*v^2*cos_x + eps*g*sin_x^2 + eps^2*g*v*sin_x*cos_x)/(1
///     + eps^2*v^2 + eps^2*g*cos_x - eps^3*g*v*sin_x)
/// ```
///
/// Proved while compiling:
///
/// ```text
/// integral E = 1/2*v^2 - g*cos_x - eps^2*g^2*sin_x^2/2;
/// ```
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Pendulum<T> {
    /// The parameter `g`.
    pub g: T,
}
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
#[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
const _: () = {
    use ::kahan_core::__private::{self as __kahan, arguments::*, Clone as _};
    impl<T> Pendulum<T> {
        /// The state variables, in order.
        pub const VARIABLES: [&'static __kahan::str; 4] = ["x", "v", "sin_x", "cos_x"];
        /// The parameters, in order.
        pub const PARAMETERS: [&'static __kahan::str; 1] = ["g"];
        /// The variables beyond the states, in order.
        pub const NEW_VARIABLES: [&'static __kahan::str; 2] = ["sin_x", "cos_x"];
        /// Relations between the variables: each is 0 at an embedded point.
        pub const RELATIONS: [&'static __kahan::str; 3] = [
            "-1 + sin_x^2 + cos_x^2",
            "sin_x - (sin(x))",
            "cos_x - (cos(x))",
        ];
        /// The names of the integrals, in order.
        pub const INTEGRALS: [&'static __kahan::str; 1] = ["E"];
    }
    impl<T: __kahan::Scalar> Pendulum<T> {
        /// The integral `E = 1/2*v^2 - g*cos_x - eps^2*g^2*sin_x^2/2`, constant along orbits; `eps` is ε, half the time step.
        pub fn E(&self, x: &__kahan::SVector<T, 4>, eps: T) -> T {
            self.integrals(x, eps)[0].clone()
        }
    }
    impl<T> Pendulum<T> {
        /// The point of the lift that belongs to the states `x`, with first values of the new variables.
        ///
        /// They are computed in `f64`, by functions of the crate `libm`, and have the same bits everywhere.
        pub fn embed(&self, x: &__kahan::SVector<T, 2>) -> __kahan::SVector<T, 4>
        where
            T: __kahan::EmbedScalar,
        {
            let [__s_x, _] = __kahan::components_in_f64(x);
            let __e_1 = __kahan::elementary::sin(__s_x);
            let __e_2 = __kahan::elementary::cos(__s_x);
            __kahan::embedded(x, [__e_1, __e_2])
        }
        /// The states of a point of the lift.
        pub fn project(&self, x: &__kahan::SVector<T, 4>) -> __kahan::SVector<T, 2>
        where
            T: __kahan::Scalar,
        {
            __kahan::projected(x)
        }
    }
    impl Pendulum<__kahan::f64> {
        /// Where `v` stands in a point: `x[Pendulum::V]`.
        pub const V: __kahan::usize = 1;
        /// Where `sin_x` stands in a point: `x[Pendulum::SIN_X]`.
        pub const SIN_X: __kahan::usize = 2;
        /// Where `cos_x` stands in a point: `x[Pendulum::COS_X]`.
        pub const COS_X: __kahan::usize = 3;
    }
    impl<T: __kahan::Scalar> __kahan::QuadraticField<T, 4> for Pendulum<T> {
        fn field(&self, x: &__kahan::SVector<T, 4>) -> __kahan::SVector<T, 4> {
            let [_, __s_v, __s_sin_x, __s_cos_x] = __kahan::components(x);
            let __p_g = &self.g;
            __kahan::vector([
                __s_v.clone(),
                -(__s_sin_x.clone() * __p_g.clone()),
                __s_v.clone() * __s_cos_x.clone(),
                -(__s_v.clone() * __s_sin_x.clone()),
            ])
        }
    }
    pub struct __Step;
    impl __kahan::Kernel<4, 4> for __Step {
        const COST: __kahan::StepCost = __kahan::StepCost::of(32, 1, 33);
    }
    pub struct __General;
    impl __kahan::Kernel<4, 2> for __General {
        const COST: __kahan::StepCost = __kahan::StepCost::of(31, 1, 37);
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 4> for Pendulum<T> {
        type Prepared = __kahan::StepOverEps<__Step, __General, T, 4, 2>;
    }
};
