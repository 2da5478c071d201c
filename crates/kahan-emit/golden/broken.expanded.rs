::core::compile_error! {
    "the term `x^3` has degree 3 in the states, and Kahan's method needs a quadratic field\nhelp: `kahan lift`, or `lift=True` in Python, makes a quadratic field of it, for example with `w` for `x^2`: docs/how-to/not-quadratic.md shows how"
}
::core::compile_error! {
    "`sin(…)` is a function call: fields here are polynomial, claims rational\nhelp: `kahan lift`, or `lift=True` in Python, makes a quadratic field of it, with a state for `sin(…)`: docs/how-to/not-quadratic.md shows how"
}
/// The block has mistakes, which the compiler reports. This stands in for what it would be, and nothing that the block claims is proved.
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Broken<T> {
    /// The parameter `mu`.
    pub mu: T,
}
#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
#[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
const _: () = {
    use ::kahan_core::__private::{self as __kahan, arguments::*, Clone as _};
    impl<T> Broken<T> {
        /// The names of the integrals, in order.
        pub const INTEGRALS: [&'static __kahan::str; 1] = ["H"];
    }
    impl<T: __kahan::Scalar> Broken<T> {
        /// The block has mistakes, which the compiler reports. This stands in for what it would be, and nothing that the block claims is proved.
        pub fn integrals(
            &self,
            x: &__kahan::SVector<T, 2>,
            eps: T,
        ) -> __kahan::SVector<T, 1> {
            __kahan::vector([__kahan::integer::<T>(0)])
        }
    }
    pub struct __Step;
    impl __kahan::Kernel<2, 0> for __Step {
        const COST: __kahan::StepCost = __kahan::StepCost::of(2, 0, 3);
    }
    impl<T: __kahan::Scalar> __kahan::KahanMap<T, 2> for Broken<T> {
        type Prepared = __kahan::StraightStep<__Step, T, 0>;
        #[inline(always)]
        fn prepare(&self, eps: &T) -> Self::Prepared {
            Self::Prepared::new([])
        }
    }
};
