//! The scalars over which orbits go through poles.
//!
//! In: a step. Out: whether it loses so little that an orbit takes it as it is, and the numbers to
//! go on with where it does not.

use core::mem;

use nalgebra::SVector;

use crate::scalar::Wide;
use crate::{Dd, KahanMap, Pivot, Scalar};

use super::germ::Germ;
use super::memory::{has_small_slopes, is_far_from_singular};

/// A scalar over which orbits go through poles: `f32`, `f64`, [`Dd`], and with the feature `exact`
/// `BigRational`.
#[expect(private_bounds, reason = "the numbers of the way through are no scalars that others could give")]
pub trait ThroughPoles: Pivot + Followed {}

/// How orbits over a scalar are followed where ordinary steps lose too much.
pub(super) trait Followed: Scalar {
    /// The numbers of the way through.
    type Germ: Germ<Self>;

    /// Whether x̃ has as many digits of x as the step is to keep. `is_flat` is true only where |εf′|
    /// is known to be small, at x before and at x̃ afterwards.
    fn keeps<M: KahanMap<Self, N>, const N: usize>(
        map: &M,
        x: &SVector<Self, N>,
        next: &SVector<Self, N>,
        eps: &Self,
        is_flat: &mut bool,
    ) -> bool;

    /// Whether two limits are the same but for what δ leaves in them.
    fn are_near<const N: usize>(a: &SVector<Self, N>, b: &SVector<Self, N>) -> bool;
}

/// How far limits that are the same may be from each other, relative to the larger.
const NEAR: f64 = 1.0 / (1_u32 << 18) as f64;

/// The size of the largest entry.
fn largest<T: Scalar, const N: usize>(x: &SVector<T, N>) -> f64 {
    x.iter().map(|entry| entry.approximate().abs()).fold(0.0, f64::max)
}

macro_rules! implement_for_float {
    ($float:ty, $last_digit:expr) => {
        impl ThroughPoles for $float {}

        impl Followed for $float {
            type Germ = Wide;

            #[inline(always)]
            fn keeps<M: KahanMap<Self, N>, const N: usize>(
                map: &M,
                x: &SVector<Self, N>,
                next: &SVector<Self, N>,
                eps: &Self,
                is_flat: &mut bool,
            ) -> bool {
                // Where x is cancelled against x̃ − x, few digits of x̃ are left to look at.
                let is_known = largest(x) * $last_digit <= largest(next) / 2048.0;
                let was_flat = mem::replace(is_flat, has_small_slopes(&map.matrix(next, -*eps)));
                let is_finite = next.iter().all(Pivot::is_finite_number);
                // It is given copies, so that a loop keeps its state in registers.
                is_known && is_finite && (was_flat && *is_flat || loses_little(map, *x, *next, *eps))
            }

            fn are_near<const N: usize>(a: &SVector<Self, N>, b: &SVector<Self, N>) -> bool {
                let distance = largest(&(a - b));
                distance <= NEAR * largest(a).max(largest(b))
            }
        }
    };
}

/// Whether neither matrix of a step is nearly singular, where |εf′| is not known to be small.
#[cold]
#[inline(never)]
fn loses_little<M: KahanMap<T, N>, T: Scalar, const N: usize>(
    map: &M,
    x: SVector<T, N>,
    next: SVector<T, N>,
    eps: T,
) -> bool {
    is_far_from_singular(&map.matrix(&x, eps.clone())) && is_far_from_singular(&map.matrix(&next, -eps))
}

implement_for_float!(f32, f64::from(f32::EPSILON));
implement_for_float!(f64, f64::EPSILON);
implement_for_float!(Dd, f64::EPSILON * f64::EPSILON);

#[cfg(feature = "exact")]
impl ThroughPoles for num_rational::BigRational {}

#[cfg(feature = "exact")]
impl Followed for num_rational::BigRational {
    type Germ = crate::scalar::Laurent<Self>;

    fn keeps<M: KahanMap<Self, N>, const N: usize>(
        map: &M,
        _x: &SVector<Self, N>,
        next: &SVector<Self, N>,
        eps: &Self,
        _is_flat: &mut bool,
    ) -> bool {
        !num_traits::Zero::is_zero(&map.det_matrix(next, -eps.clone()))
    }

    fn are_near<const N: usize>(a: &SVector<Self, N>, b: &SVector<Self, N>) -> bool {
        a == b
    }
}
