//! Tuning for compilers and processors: whether a step divides by ε, and how compilers are kept
//! from packing scalars into vectors.

use core::any::{Any, TypeId};

use super::Scalar;
use super::bounded::{Bounded, PackedDouble, PackedSingle};

/// Steps in `f32` may divide by ε if |ε| is from 2⁻¹⁶ to 2¹⁶, where powers of ε stay in range.
pub(crate) const BITS_OF_SINGLE_STEPS: u32 = 16;
/// Steps in `f64` with error bounds may divide by ε if |ε| is from 2⁻⁶⁴ to 2⁶⁴.
pub(crate) const BITS_OF_DOUBLE_STEPS: u32 = 64;
/// Plain `f64` steps may divide by ε if |ε| is from 2⁻⁸⁴ to 2⁶⁴. The lower limit is far below usual
/// ε. Therefore a step at θε with 0 < θ < 1 usually has the same form as the step at ε.
const BITS_OF_SMALL_DOUBLE_STEPS: u32 = 84;

#[inline(always)]
pub(crate) fn is<T: 'static, U: 'static>() -> bool {
    // Sizes are compared first, because comparing types in every step is slow without optimisation.
    size_of::<T>() == size_of::<U>() && TypeId::of::<T>() == TypeId::of::<U>()
}

/// Casts a number of type T to U, which must be the type T.
#[inline(always)]
pub(crate) fn same<T: 'static, U: 'static>(number: &T) -> &U {
    match (number as &dyn Any).downcast_ref() {
        Some(number) => number,
        None => unreachable!("the caller has compared the types"),
    }
}

#[inline(always)]
pub(crate) fn is_float<T: 'static>() -> bool {
    is::<T, f32>() || is::<T, f64>()
}

/// Returns j and k if steps over T may divide by ε for |ε| from 2⁻ʲ to 2ᵏ. Returns `None` if they
/// never divide by ε.
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

/// Returns whether steps over T may divide by some values of ε.
#[inline(always)]
pub(crate) fn divides_by_eps<T: 'static>() -> bool {
    bits_of_steps::<T>().is_some()
}

/// Returns whether a step at this ε may use the form that divides by ε.
#[inline(always)]
pub(crate) fn may_divide_by<T: Scalar>(eps: &T) -> bool {
    bits_of_steps::<T>().is_some_and(|bits| {
        let [small, large] = bits.map(|bits| (1_u128 << bits) as f64);
        (1.0 / small..=large).contains(&eps.approximate().abs())
    })
}

/// Returns the number unchanged, but keeps compilers from packing it into a vector with other
/// numbers. A packed vector waits for the last of its numbers, and packing costs shuffles.
#[inline(always)]
pub fn fenced<T: 'static>(mut number: T) -> T {
    let _ = change(&mut number, |single: &mut f32| *single = fence::single(*single))
        || change(&mut number, |double: &mut f64| *double = fence::double(*double))
        || change(&mut number, |bounded: &mut Bounded<f32>| *bounded = bounded.with_magnitude(fenced))
        || change(&mut number, |bounded: &mut Bounded<f64>| *bounded = bounded.with_magnitude(fenced));
    number
}

/// Returns a component of x̃. The component is [`fenced`] for `f32`, and if the step computes
/// `several` reciprocals in sequence. Packed components would slow an orbit down.
#[inline(always)]
pub(crate) fn component<T: 'static>(number: T, several: bool) -> T {
    if several || is::<T, f32>() { fenced(number) } else { number }
}

/// Applies `change` if T is the type U. Returns whether the types are equal.
#[inline(always)]
fn change<T: 'static, U: 'static>(number: &mut T, change: impl FnOnce(&mut U)) -> bool {
    if is::<T, U>()
        && let Some(number) = (number as &mut dyn Any).downcast_mut()
    {
        change(number);
        return true;
    }
    false
}

#[cfg(all(target_arch = "x86_64", not(miri)))]
#[allow(unsafe_code, reason = "nothing else keeps a compiler from packing scalars, and costs no instruction")]
mod fence {
    macro_rules! fence {
        ($name:ident, $float:ty) => {
            #[inline(always)]
            pub(super) fn $name(mut number: $float) -> $float {
                // SAFETY: the assembler text is a comment, which changes no register and no memory.
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
            assert_eq!(may_divide_by(&Bounded::<f64>::from_input(eps)), may, "{eps}");
            assert_eq!(may_divide_by(&Bounded::<f64, PackedDouble>::from_input(eps)), may, "{eps}");
            assert!(!may_divide_by(&Dd::from(eps)) && !may_divide_by(&Dual::<f64, 1>::from_value(eps)));
        }
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
        check(Bounded::<f64>::from_input(-0.1));
        check(Bounded::<f32>::one());
        check(Bounded::<f64, PackedDouble>::from_input(0.3));
    }
}
