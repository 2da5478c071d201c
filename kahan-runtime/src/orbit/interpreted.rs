//! An orbit by the interpreter, for what has no code.

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, FloatScalar, KahanMap, Lift, Precision, Scheme, ThroughF64};

use crate::interpreted::{Interpreted, UnsupportedDimension, VisitDimension, round, visit_dimension};

use super::Orbits;

/// An orbit that is at some point.
pub(super) trait Steps {
    /// So many steps further.
    fn advance(&mut self, steps: u64);
    /// The coordinates of the point.
    fn point(&self, point: &mut [Dd]);
}

/// An iterator over points, and the one that it is at.
struct At<O, T, const N: usize> {
    orbit: O,
    point: SVector<T, N>,
}

impl<O, T, const N: usize> Steps for At<O, T, N>
where
    O: Iterator<Item = SVector<T, N>>,
    T: FloatScalar,
    Dd: From<T>,
{
    fn advance(&mut self, steps: u64) {
        if let Some(further) = steps.checked_sub(1)
            // Orbits over floats have no end.
            && let Some(point) = self.orbit.nth(usize::try_from(further).unwrap_or(usize::MAX))
        {
            self.point = point;
        }
    }

    fn point(&self, point: &mut [Dd]) {
        point.iter_mut().zip(self.point.iter()).for_each(|(x, entry)| *x = Dd::from(*entry));
    }
}

/// An orbit after a point from which nothing is known of the next: it is not finite, or has more
/// variables than the interpreter.
pub(super) struct Nowhere;

impl Steps for Nowhere {
    fn advance(&mut self, _: u64) {}

    fn point(&self, point: &mut [Dd]) {
        point.fill(Dd::from(f64::NAN));
    }
}

/// The orbit of a scheme at its first point.
///
/// # Errors
/// [`UnsupportedDimension`].
pub(super) fn begin(
    of: &Orbits,
    scheme: Scheme,
    eps: &Rational,
    start: &[Rational],
) -> Result<Box<dyn Steps>, UnsupportedDimension> {
    let beginning = Beginning { of, scheme, eps, start };
    visit_dimension(start.len(), beginning)
}

/// What an orbit begins with.
struct Beginning<'a> {
    of: &'a Orbits,
    scheme: Scheme,
    eps: &'a Rational,
    start: &'a [Rational],
}

impl VisitDimension for Beginning<'_> {
    type Output = Box<dyn Steps>;

    fn visit<const N: usize>(self) -> Box<dyn Steps> {
        let parameters: Vec<BigRational> = self.of.parameters.iter().map(Rational::to_big).collect();
        let exact = Interpreted::<BigRational, N>::padded(&self.of.derived.system, &parameters);
        // Whoever made the subject has looked at its parameters.
        let exact = exact.unwrap_or_else(|why| unreachable!("{why}"));
        of_map(&exact, self.scheme, self.eps, self.start)
    }
}

/// The orbit of any map over ℚ in a scheme, at its first point. Coordinates that lack are 0.
pub(super) fn of_map<M, const N: usize>(
    exact: &M,
    scheme: Scheme,
    eps: &Rational,
    start: &[Rational],
) -> Box<dyn Steps>
where
    M: Lift<BigRational, N, Lifted<f32>: 'static, Lifted<f64>: 'static, Lifted<Dd>: 'static>,
{
    match scheme.precision {
        Precision::Single => in_scheme(&exact.lift(number::<f32>), scheme, eps, start),
        Precision::SingleThroughDouble => {
            in_scheme(&ThroughF64(exact.lift(number::<f32>)), scheme, eps, start)
        }
        Precision::Double => in_scheme(&exact.lift(number::<f64>), scheme, eps, start),
        Precision::DoubleDouble => in_scheme(&exact.lift(number::<Dd>), scheme, eps, start),
    }
}

fn number<T: FloatScalar>(value: &BigRational) -> T {
    round(&value.clone().into())
}

fn in_scheme<M, T, const N: usize>(map: &M, scheme: Scheme, eps: &Rational, start: &[Rational]) -> Box<dyn Steps>
where
    M: KahanMap<T, N> + 'static,
    T: FloatScalar,
    Dd: From<T>,
{
    let point = SVector::from_fn(|i, _| start.get(i).map_or_else(T::zero, round));
    let orbit = map.orbit(point, round(eps));
    match (scheme.order(), scheme.compensated) {
        (2, false) => at(orbit, point),
        (2, true) => at(orbit.compensated(), point),
        (_, false) => at(orbit.composed(scheme.composition), point),
        (_, true) => at(orbit.composed(scheme.composition).compensated(), point),
    }
}

/// An orbit after its first point.
fn at<O, T, const N: usize>(mut orbit: O, point: SVector<T, N>) -> Box<dyn Steps>
where
    O: Iterator<Item = SVector<T, N>> + 'static,
    T: FloatScalar,
    Dd: From<T>,
{
    orbit.next();
    Box::new(At { orbit, point })
}
