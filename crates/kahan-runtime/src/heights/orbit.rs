//! Iterates over an exact orbit in projective integers, with the heights of every point.

use dashu_int::ops::{BitTest, UnsignedAbs};
use dashu_int::{IBig, UBig};
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;

use super::content::{ContentPredictor, PrimitivePoint, longest};
use super::integers::{denominator, numerator, short_gcd};
use super::logarithm::{decimal_digits, natural_logarithm};
use super::map::{ProjectiveMap, UndefinedField};
use super::reduction::common_factors;
use super::report::{Heights, Stop};

/// An iterator over the heights h(x₀), h(x₁), … of an exact orbit of Kahan's map.
///
/// Points are projective integers without a common factor. The orbit ends at a pole or at a bound
/// on digits; [`stopped`](Self::stopped) returns the reason.
///
/// ```
/// use kahan_algebra::rational::Rational;
/// use kahan_runtime::heights::{Growth, HeightsOrbit};
///
/// let text = kahan_systems::registry::find("e3").unwrap().text();
/// let system = kahan_algebra::read(&kahan_algebra::lexer::lex(text).tokens).system().expect("a system");
/// let start = [Rational::new(3, 7), Rational::new(11, 13), Rational::new(23, 47)];
/// let mut orbit = HeightsOrbit::new(&system, &[], &Rational::new(1, 2), &start).unwrap();
/// let heights_of_x: Vec<f64> = orbit.by_ref().skip(1).take(50).map(|heights| heights.logarithms[0]).collect();
/// assert_eq!(Growth::of(&heights_of_x), Growth::Linear);
/// assert_eq!(orbit.point().len(), 3);
/// ```
#[derive(Clone, Debug)]
pub struct HeightsOrbit {
    map: ProjectiveMap,
    /// The current point (X₁, …, X_n, W).
    point: Vec<IBig>,
    /// gcd(Xᵢ, W) for each i.
    factors: Vec<UBig>,
    before: Option<Vec<IBig>>,
    content: ContentPredictor,
    max_digits: Option<u64>,
    step: Option<usize>,
    stopped: Option<Stop>,
    bits: PointBits,
}

/// The bits of the longest coordinate of the previous and of the current point; at first both 0.
#[derive(Clone, Copy, Debug, Default)]
struct PointBits {
    before: usize,
    now: usize,
}

impl PointBits {
    fn growth(self) -> f64 {
        self.now as f64 / self.before.max(1) as f64
    }
}

impl HeightsOrbit {
    /// Begins the orbit of `system` from `start` at ε, half the time step. Parameter values have
    /// the order of declaration.
    ///
    /// # Errors
    /// [`UndefinedField`] if the field divides by zero at the parameters.
    ///
    /// # Panics
    /// If the number of coordinates or of parameter values differs from the system's.
    pub fn new(
        system: &System,
        parameters: &[Rational],
        eps: &Rational,
        start: &[Rational],
    ) -> Result<Self, UndefinedField> {
        assert_eq!(start.len(), system.field.dimension(), "one coordinate a state");
        Ok(Self::begin(ProjectiveMap::new(system, parameters, eps)?, start))
    }

    pub(crate) fn begin(map: ProjectiveMap, start: &[Rational]) -> Self {
        HeightsOrbit {
            point: map.point(start),
            factors: Vec::new(),
            map,
            before: None,
            content: ContentPredictor::default(),
            max_digits: None,
            step: None,
            stopped: None,
            bits: PointBits::default(),
        }
    }

    /// Ends the orbit before a numerator or denominator has more than `max_digits` decimal digits.
    #[must_use]
    pub fn within_digits(self, max_digits: u64) -> Self {
        HeightsOrbit { max_digits: Some(max_digits), ..self }
    }

    /// Returns the reason why the orbit ended; `None` while it continues.
    #[must_use]
    pub fn stopped(&self) -> Option<Stop> {
        self.stopped
    }

    /// Returns the map.
    #[must_use]
    pub fn projective_map(&self) -> &ProjectiveMap {
        &self.map
    }

    /// Returns the point whose heights were yielded last, in lowest terms; x₀ before the first
    /// yield.
    #[must_use]
    pub fn point(&self) -> Vec<Rational> {
        self.map.coordinates(&self.point)
    }

    /// Returns the current point as integers (X₁, …, X_n, W) without a common factor. The integers
    /// stand for xᵢ = σXᵢ/W, where σ is [`ProjectiveMap::unit`].
    #[must_use]
    pub fn projective_point(&self) -> &[IBig] {
        &self.point
    }

    fn advance(&mut self) -> Result<Heights, Stop> {
        let Some(step) = self.step else {
            let (weight, x) = self.point.split_last().ok_or(Stop::Pole)?;
            self.factors = common_factors(x, &weight.unsigned_abs(), &[], &[]);
            let heights = heights(0, &self.map, &self.point, &self.factors);
            return if self.is_too_long(&heights) { Err(Stop::Digits) } else { Ok(heights) };
        };
        self.check_expected_digits()?;
        let image = self.map.apply(&self.point, &self.factors);
        if image.point.last().is_none_or(IBig::is_zero) {
            return Err(Stop::Pole);
        }
        let size = longest(&image.point);
        let PrimitivePoint { mut point, weight_parts } =
            self.content.divide_out(image, self.before.as_deref());
        let (weight, x) = point.split_last().ok_or(Stop::Pole)?;
        let mut factors = common_factors(x, &weight.unsigned_abs(), &weight_parts, &self.factors);
        let rest = common_of(&factors);
        self.content.left(&rest, size);
        if rest > UBig::ONE {
            point.iter_mut().for_each(|x| *x /= &rest);
            factors.iter_mut().for_each(|factor| *factor /= &rest);
        }
        let heights = heights(step + 1, &self.map, &point, &factors);
        if self.is_too_long(&heights) {
            return Err(Stop::Digits);
        }
        self.bits = PointBits { before: longest(&self.point), now: longest(&point) };
        self.before = Some(std::mem::replace(&mut self.point, point));
        self.factors = factors;
        Ok(heights)
    }

    /// Returns an error if the next point is expected to have more than twice the allowed digits. A
    /// smaller excess is found only after the step.
    pub(super) fn check_expected_digits(&self) -> Result<(), Stop> {
        let expected = self.bits.now as f64 * self.bits.growth() * std::f64::consts::LOG10_2;
        match self.max_digits {
            Some(max_digits) if expected > 2.0 * max_digits as f64 => Err(Stop::Digits),
            _ => Ok(()),
        }
    }

    /// Estimates the time of the next step, relative to the last step.
    pub(super) fn slowdown(&self) -> f64 {
        self.bits.growth().powi(2)
    }

    fn is_too_long(&self, heights: &Heights) -> bool {
        self.max_digits.is_some_and(|max_digits| heights.longest() > max_digits)
    }
}

impl Iterator for HeightsOrbit {
    type Item = Heights;

    fn next(&mut self) -> Option<Heights> {
        if self.stopped.is_some() {
            return None;
        }
        let heights = self.advance().map_err(|stop| self.stopped = Some(stop)).ok()?;
        self.step = Some(heights.step);
        Some(heights)
    }
}

fn heights(step: usize, map: &ProjectiveMap, point: &[IBig], factors: &[UBig]) -> Heights {
    let weight = point.last().map(UnsignedAbs::unsigned_abs).expect("W stands last");
    let (above, below) = (numerator(map.unit()).unsigned_abs(), denominator(map.unit()));
    let logarithm = |(x, factor): (&IBig, &UBig)| {
        let (x, weight) = (x.unsigned_abs() / factor, &weight / factor);
        // Let X/W and σ = s/t be in lowest terms. The coordinate σX/W is sX/(tW), and gcd(sX, tW) =
        // gcd(s, W)·gcd(t, X).
        let lost = short_gcd(&above, &weight) * short_gcd(&below, &x);
        let larger = (&above * x).max(&below * weight) / lost;
        let logarithm = natural_logarithm(&larger);
        (logarithm, decimal_digits(&larger, logarithm))
    };
    let (logarithms, digits) = point.iter().zip(factors).map(logarithm).unzip();
    Heights { step, logarithms, digits }
}

/// Returns the gcd of all gcd(Xᵢ, W); begins with the shortest.
fn common_of(factors: &[UBig]) -> UBig {
    let mut factors: Vec<&UBig> = factors.iter().collect();
    factors.sort_by_key(|factor| factor.bit_len());
    let mut factors = factors.into_iter();
    let shortest = factors.next().cloned().unwrap_or(UBig::ONE);
    factors.fold(shortest, |common, factor| short_gcd(&common, factor))
}
