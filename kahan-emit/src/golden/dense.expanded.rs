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
    use ::kahan_core::__private::{self as __kahan, arguments::*, Clone as _};
    impl<T> Dense<T> {
        /// The state variables, in order.
        pub const VARIABLES: [&'static __kahan::str; 6] = ["x", "y", "z", "u", "v", "w"];
        /// The parameters, in order.
        pub const PARAMETERS: [&'static __kahan::str; 3] = ["a", "b", "c"];
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 6> for Dense<T> {
        type Prepared = __kahan::Elimination<Self, T>;
        #[inline]
        fn prepare(&self, eps: &T) -> Self::Prepared {
            __kahan::Elimination::new(self.clone(), eps.clone())
        }
    }
    impl<T: __kahan::Scalar> __kahan::Lift<T, 6> for Dense<T> {
        #[inline(always)]
        fn lift<U: __kahan::Scalar>(&self, lift: impl __kahan::Fn(&T) -> U) -> Dense<U> {
            Dense {
                a: lift(&self.a),
                b: lift(&self.b),
                c: lift(&self.c),
            }
        }
    }
};
