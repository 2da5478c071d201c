//! Orbits in every kind of arithmetic, behind one face.
//!
//! In: a map over ℚ, from which every scalar rounds its own, a first point, a scheme, ε. Out: the
//! library's own orbit of that scheme, as something that walks. This is all of the trade that is
//! compiled once for every map, so it holds nothing else.

use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, FloatScalar, KahanMap, Lift, Precision, Scalar, Scheme, ThroughF64};
use kahan_runtime::interpreted;

/// An orbit.
pub(super) trait Walk {
    /// So many points further on, its first point being the first; `None` where there is no point.
    fn nth(&mut self, points: usize) -> Option<Vec<Dd>>;
}

impl<O, T, const N: usize> Walk for O
where
    O: Iterator<Item = SVector<T, N>>,
    T: FloatScalar,
    Dd: From<T>,
{
    fn nth(&mut self, points: usize) -> Option<Vec<Dd>> {
        Some(widened(&Iterator::nth(self, points)?))
    }
}

/// The coordinates of a point; not written into every orbit that has such points.
#[inline(never)]
fn widened<T: FloatScalar, const N: usize>(point: &SVector<T, N>) -> Vec<Dd>
where
    Dd: From<T>,
{
    point.iter().map(|entry| Dd::from(*entry)).collect()
}

/// What is done with an orbit.
pub(super) type Walker<'a> = &'a mut dyn FnMut(&mut dyn Walk);

/// Hands over the orbit of a map in a scheme. `start` has at most N coordinates; those
/// that lack are 0.
pub(super) fn walk<M, const N: usize>(
    exact: &M,
    start: &[BigRational],
    scheme: Scheme,
    eps: f64,
    walker: Walker<'_>,
) where
    M: Lift<BigRational, N>,
{
    match scheme.precision {
        Precision::Single => carried(&exact.lift::<f32>(round), start, scheme, eps, walker),
        Precision::SingleThroughDouble => {
            carried(&ThroughF64(exact.lift::<f32>(round)), start, scheme, eps, walker);
        }
        Precision::Double => carried(&exact.lift::<f64>(round), start, scheme, eps, walker),
        // Compensation makes no sense where no rounding is ever seen.
        Precision::DoubleDouble => plain(&exact.lift::<Dd>(round), start, scheme, eps, walker),
    }
}

/// The orbit, compensated where the scheme is.
fn carried<M, T, const N: usize>(map: &M, start: &[BigRational], scheme: Scheme, eps: f64, walker: Walker<'_>)
where
    M: KahanMap<T, N>,
    T: FloatScalar,
    Dd: From<T>,
{
    if !scheme.compensated {
        return plain(map, start, scheme, eps, walker);
    }
    let orbit = map.orbit(point(start), round(&rational(eps))).compensated();
    match scheme.order() {
        2 => walker(&mut { orbit }),
        _ => walker(&mut orbit.composed(scheme.composition)),
    }
}

fn plain<M, T, const N: usize>(map: &M, start: &[BigRational], scheme: Scheme, eps: f64, walker: Walker<'_>)
where
    M: KahanMap<T, N>,
    T: FloatScalar,
    Dd: From<T>,
{
    let orbit = map.orbit(point(start), round(&rational(eps)));
    match scheme.order() {
        2 => walker(&mut { orbit }),
        _ => walker(&mut orbit.composed(scheme.composition)),
    }
}

/// The point over a scalar.
pub(super) fn point<T: Scalar, const N: usize>(exact: &[BigRational]) -> SVector<T, N> {
    SVector::from_fn(|i, _| exact.get(i).map_or_else(T::zero, round))
}

pub(super) fn round<T: Scalar>(value: &BigRational) -> T {
    interpreted::round(&value.clone().into())
}

/// A float as the number that it is; 0 for what is none.
pub(super) fn rational(value: f64) -> BigRational {
    BigRational::from_float(value).unwrap_or_else(|| BigRational::from_integer(0.into()))
}
