//! Scalars that support orbits through poles.

use core::mem;

use nalgebra::SVector;

use crate::scalar::Wide;
use crate::{Dd, KahanMap, Pivot, Scalar};

use super::delta_series::DeltaSeries;
use super::memory::{has_small_slopes, is_far_from_singular};

/// A scalar that supports orbits through poles: `f32`, `f64`, [`Dd`], or with the feature `exact`
/// `BigRational`.
#[expect(private_bounds, reason = "the numbers of the way through are no scalars that others could give")]
pub trait ThroughPoles: Pivot + PassageScalar {}

pub(super) trait PassageScalar: Scalar {
    type DeltaSeries: DeltaSeries<Self>;

    /// Returns whether the next state x̃ preserves enough digits of the state x. `is_flat` says
    /// whether |εf′| is known to be small. On entry `is_flat` refers to x, on return to x̃.
    fn retains_digits<M: KahanMap<Self, N>, const N: usize>(
        map: &M,
        x: &SVector<Self, N>,
        next: &SVector<Self, N>,
        eps: &Self,
        is_flat: &mut bool,
    ) -> bool;

    /// Returns whether two limits agree, up to small terms that contain the perturbation δ.
    fn are_near<const N: usize>(a: &SVector<Self, N>, b: &SVector<Self, N>) -> bool;
}

/// Two limits are treated as equal if their relative distance is below this number.
const NEAR: f64 = 1.0 / (1_u32 << 18) as f64;

fn largest<T: Scalar, const N: usize>(x: &SVector<T, N>) -> f64 {
    x.iter().map(|entry| entry.approximate().abs()).fold(0.0, f64::max)
}

macro_rules! implement_for_float {
    ($float:ty, $last_digit:expr) => {
        impl ThroughPoles for $float {}

        impl PassageScalar for $float {
            type DeltaSeries = Wide;

            #[inline(always)]
            fn retains_digits<M: KahanMap<Self, N>, const N: usize>(
                map: &M,
                x: &SVector<Self, N>,
                next: &SVector<Self, N>,
                eps: &Self,
                is_flat: &mut bool,
            ) -> bool {
                // If x̃ is much smaller than x, too many digits cancelled in x + (x̃ − x).
                let is_known = largest(x) * $last_digit <= largest(next) / 2048.0;
                let was_flat = mem::replace(is_flat, has_small_slopes(&map.matrix(next, -*eps)));
                let is_finite = next.iter().all(Pivot::is_finite_number);
                // Copies of the arguments allow a caller's loop to keep its state in registers.
                is_known && is_finite && (was_flat && *is_flat || loses_little(map, *x, *next, *eps))
            }

            fn are_near<const N: usize>(a: &SVector<Self, N>, b: &SVector<Self, N>) -> bool {
                let distance = largest(&(a - b));
                distance <= NEAR * largest(a).max(largest(b))
            }
        }
    };
}

/// Returns whether both matrices A(x,ε) and A(x̃,−ε) of a step are far from singular.
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
impl PassageScalar for num_rational::BigRational {
    type DeltaSeries = crate::scalar::Laurent<Self>;

    fn retains_digits<M: KahanMap<Self, N>, const N: usize>(
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
