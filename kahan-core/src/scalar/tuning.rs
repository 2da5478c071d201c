//! What concerns compilers and processors only: over which scalars a step is divided by ε, and
//! which values are kept from being packed.
//!
//! In: a scalar, and what the plan of a step has decided. Out: the same numbers, sooner. Which type
//! a scalar is, is known while compiling, so an optimised program asks nothing of what is asked
//! here.

use core::any::{Any, TypeId};

use super::Scalar;
use super::bounded::{Bounded, PackedDouble, PackedSingle};

/// A step over `f32` may divide by ε from 2⁻ᵏ to 2ᵏ with this k, so that no power of ε in it comes
/// near the ends of the range.
pub(crate) const BITS_OF_SINGLE_STEPS: u32 = 16;
/// The same for `f64`.
pub(crate) const BITS_OF_DOUBLE_STEPS: u32 = 64;
/// Steps over `f64` itself may divide by ε from 2 to minus this power: parts of a step, and stages
/// of a composition, whose whole ε is ordinary, then have its form, and the same bits in every unit
/// of time.
const BITS_OF_SMALL_DOUBLE_STEPS: u32 = 84;

/// Whether T is U.
#[inline(always)]
pub(crate) fn is<T: 'static, U: 'static>() -> bool {
    // The sizes first: a program that is not optimised compares types at every step, and slowly.
    size_of::<T>() == size_of::<U>() && TypeId::of::<T>() == TypeId::of::<U>()
}

/// The same value as a U, which T is.
///
/// # Panics
/// If T is another type.
#[inline(always)]
pub(crate) fn same<T: 'static, U: 'static>(number: &T) -> &U {
    match (number as &dyn Any).downcast_ref() {
        Some(number) => number,
        None => unreachable!("the caller has compared the types"),
    }
}

/// Whether T is one of the machine's floats.
#[inline(always)]
pub(crate) fn is_float<T: 'static>() -> bool {
    is::<T, f32>() || is::<T, f64>()
}

/// The j and k such that a step over T may divide by ε from 2⁻ʲ to 2ᵏ; `None` where it never may.
#[inline(always)]
fn bits_of_steps<T: 'static>() -> Option<[u32; 2]> {
    if is::<T, f64>() {
        Some([BITS_OF_SMALL_DOUBLE_STEPS, BITS_OF_DOUBLE_STEPS])
    } else if is::<T, f32>() || is::<T, Bounded<f32>>() || is::<T, Bounded<f32, PackedSingle>>() {
        Some([BITS_OF_SINGLE_STEPS; 2])
    } else if is::<T, Bounded<f64>>() || is::<T, Bounded<f64, PackedDouble>>() {
        Some([BITS_OF_DOUBLE_STEPS; 2])
    } else {
        None
    }
}

/// Whether steps over T are divided by ε where the plan has such a form.
#[inline(always)]
pub(crate) fn divides_by_eps<T: 'static>() -> bool {
    bits_of_steps::<T>().is_some()
}

/// Whether a step at this ε may be divided by it.
#[inline(always)]
pub(crate) fn may_divide_by<T: Scalar>(eps: &T) -> bool {
    bits_of_steps::<T>().is_some_and(|bits| {
        let [small, large] = bits.map(|bits| (1_u128 << bits) as f64);
        (1.0 / small..=large).contains(&eps.approximate().abs())
    })
}

/// The same number; where it is a float, in a register of its own, and where it is a bounded value,
/// its magnitude.
///
/// Compilers pack scalars that stand side by side into vectors. Where one of them is late, the
/// others wait for it, and the shuffles take longer than the operations that are saved.
#[inline(always)]
pub fn fenced<T: 'static>(mut number: T) -> T {
    let _ = change(&mut number, |single: &mut f32| *single = fence::single(*single))
        || change(&mut number, |double: &mut f64| *double = fence::double(*double))
        || change(&mut number, |bounded: &mut Bounded<f32>| *bounded = bounded.with_magnitude(fenced))
        || change(&mut number, |bounded: &mut Bounded<f64>| *bounded = bounded.with_magnitude(fenced));
    number
}

/// A component of x̃: fenced where `several` reciprocals follow on each other, as the chain of an
/// orbit is then that of one component, and in `f32`, whose vectors hold more than there is.
#[inline(always)]
pub(crate) fn component<T: 'static>(number: T, several: bool) -> T {
    if several || is::<T, f32>() { fenced(number) } else { number }
}

/// Changes a number if it is a U, and tells whether it is.
#[inline(always)]
fn change<T: 'static, U: 'static>(number: &mut T, change: impl FnOnce(&mut U)) -> bool {
    // The types first: a call of `downcast_mut` that is not reached needs no inlining.
    if is::<T, U>()
        && let Some(number) = (number as &mut dyn Any).downcast_mut()
    {
        change(number);
        return true;
    }
    false
}

/// An empty statement of the assembler, which no compiler packs across.
#[cfg(all(target_arch = "x86_64", not(miri)))]
#[allow(unsafe_code, reason = "nothing else keeps a compiler from packing scalars, and costs no instruction")]
mod fence {
    macro_rules! fence {
        ($name:ident, $float:ty) => {
            #[inline(always)]
            pub(super) fn $name(mut number: $float) -> $float {
                // SAFETY: a comment, which changes no register and touches no memory.
                unsafe {
                    core::arch::asm!(
                        "/* {0} stands alone */",
                        inout(xmm_reg) number,
                        options(pure, nomem, nostack, preserves_flags)
                    );
                }
                number
            }
        };
    }

    fence!(single, f32);
    fence!(double, f64);
}

#[cfg(not(all(target_arch = "x86_64", not(miri))))]
mod fence {
    pub(super) use core::convert::{identity as single, identity as double};
}

#[cfg(test)]
mod tests {
    use num_traits::One;

    use super::super::{Dd, Dual, Scalar};
    use super::{Bounded, PackedDouble, fenced, may_divide_by};

    #[test]
    fn floats_and_what_bounds_them_are_divided_by_an_ordinary_eps() {
        let (most, beyond) = (64_f64.exp2(), 64_f64.exp2().next_up());
        for (eps, may) in
            [(0.05, true), (-most, true), (1.0 / most, true), (beyond, false), (1.0 / beyond, false)]
        {
            assert_eq!(may_divide_by(&Bounded::<f64>::given(eps)), may, "{eps}");
            assert_eq!(may_divide_by(&Bounded::<f64, PackedDouble>::given(eps)), may, "{eps}");
            assert!(!may_divide_by(&Dd::from(eps)) && !may_divide_by(&Dual::<f64, 1>::from_value(eps)));
        }
        // Floats themselves a little further down.
        for (eps, may) in [(most, true), (beyond, false), ((-84_f64).exp2(), true), ((-85_f64).exp2(), false)]
        {
            assert_eq!(may_divide_by(&eps), may, "{eps}");
        }
        assert!(may_divide_by(&65536_f32) && !may_divide_by(&65537_f32) && !may_divide_by(&0_f32));
        assert!(!may_divide_by(&f64::NAN) && !may_divide_by(&f64::INFINITY));
    }

    #[test]
    fn a_fence_changes_no_number() {
        fn check<T: Scalar>(number: T) {
            assert_eq!(fenced(number.clone()), number);
        }
        check(0.1_f32);
        check(-0.1_f64);
        check(Dd::from(0.1));
        check(Bounded::<f64>::given(-0.1));
        check(Bounded::<f32>::one());
        check(Bounded::<f64, PackedDouble>::given(0.3));
    }
}
