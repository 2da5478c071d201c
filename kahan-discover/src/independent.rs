//! Functional independence of quotients of polynomials: the rank of their gradients at a random
//! point.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;

use crate::matrix::Echelon;
use crate::modulus::Modulus;
use crate::setting::{Draw, Setting};
use crate::stepping::Stepping;

/// ∇(P/Q) Q² at a point of a drawn map; `None` where the prime divides a denominator of the
/// coefficients.
#[must_use]
pub fn quotient_gradient(
    setting: &Setting,
    draw: &Draw,
    point: &[u64],
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Option<Vec<u64>> {
    let modulus = draw.map.modulus();
    let value = |polynomial: &Polynomial| setting.evaluate(modulus, polynomial, draw, point);
    let (above, below) = (value(numerator)?, value(denominator)?);
    let symbols = setting.family().symbols();
    (0..symbols.dimension())
        .map(|i| {
            let rising = value(&numerator.derivative(symbols.state(i)))?;
            let falling = value(&denominator.derivative(symbols.state(i)))?;
            Some(modulus.minus(modulus.times(rising, below), modulus.times(above, falling)))
        })
        .collect()
}

/// Functional independence: the rank of gradients at one random point modulo one prime. (A rank
/// seen is a rank over ℚ.)
#[derive(Debug)]
pub struct Independent<'a> {
    setting: &'a Setting,
    draw: Option<(Draw, Vec<u64>)>,
    gradients: Vec<Vec<u64>>,
}

impl<'a> Independent<'a> {
    /// Of nothing yet.
    pub fn new(setting: &'a Setting, random: &mut SplitMix64) -> Self {
        let draw = setting.draw(Modulus::mersenne_61(), random).map(|draw| {
            let point = draw.map.point(random);
            (draw, point)
        });
        Independent { setting, draw, gradients: Vec::new() }
    }

    fn gradient(&self, numerator: &Polynomial, denominator: &Polynomial) -> Option<Vec<u64>> {
        let (draw, point) = self.draw.as_ref()?;
        quotient_gradient(self.setting, draw, point, numerator, denominator)
    }

    /// Whether P/Q is independent of what was kept.
    #[must_use]
    pub fn admits(&self, numerator: &Polynomial, denominator: &Polynomial) -> bool {
        let Some((draw, _)) = &self.draw else { return false };
        let Some(gradient) = self.gradient(numerator, denominator) else { return false };
        let mut rows = self.gradients.clone();
        rows.push(gradient);
        let wanted = rows.len();
        Echelon::of(draw.map.modulus(), rows, self.setting.dimension()).rank() == wanted
    }

    /// Keeps P/Q.
    pub fn keep(&mut self, numerator: &Polynomial, denominator: &Polynomial) {
        self.gradients.extend(self.gradient(numerator, denominator));
    }

    /// How many were kept.
    #[must_use]
    pub fn count(&self) -> usize {
        self.gradients.len()
    }
}
