//! Rational cycles near cycles that were found in floats.
//!
//! In: a cycle in floats. Out: a cycle of fractions near it, if one is found, and the exact
//! characteristic polynomial of the derivative along the cycle.

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_dynamics::periodic::{PeriodicPoint, Stability};

use crate::Map;
use crate::heights::HeightsOrbit;

use super::circle::{Z, characteristic_polynomial, product, stability};

/// The largest number of decimal digits of a coordinate of a rational cycle.
pub const MOST_DIGITS: u64 = 200;
/// The largest number of multiplications of fractions for a characteristic polynomial.
const MOST_PRODUCTS: usize = 200_000;

/// A cycle over ℚ, with its multipliers.
#[derive(Clone, Debug, PartialEq)]
pub struct RationalCycle {
    /// The points. Exact arithmetic maps each point to the next, and the last to the first.
    pub points: Vec<Vec<Rational>>,
    /// The polynomial det(z·I − ∂φᵖ/∂x) in z, where φ is the map and p the period. The multipliers
    /// are its roots.
    pub polynomial: Polynomial,
    /// The stability, decided without rounding.
    pub stability: Stability,
}

impl RationalCycle {
    /// Removes as many multipliers 1 as there are independent `integrals`. The other multipliers
    /// describe perturbations that keep these integrals constant.
    #[must_use]
    pub fn on_leaf(self, integrals: usize) -> Self {
        let own = &Polynomial::variable(Z) - &Polynomial::one();
        let polynomial = (0..integrals).try_fold(self.polynomial.clone(), |rest, _| rest.checked_div(&own));
        let polynomial = polynomial.expect("an integral has the multiplier 1");
        RationalCycle { stability: stability(&polynomial), polynomial, ..self }
    }
}

impl Map {
    /// Searches for a rational cycle near a cycle in floats, for the map at ε, half the time step.
    ///
    /// Returns `None` if no fractions with small denominators form a cycle. The search ends without
    /// a result if numbers exceed 200 digits, or if it needs more than 200 000 multiplications of
    /// fractions.
    #[must_use]
    pub fn rational_cycle(&self, eps: &Rational, cycle: &PeriodicPoint) -> Option<RationalCycle> {
        /// Relative distances within which the simplest fraction is taken.
        const FRACTION_DISTANCES: [f64; 4] = [1e-14, 1e-12, 1e-10, 1e-8];

        let start = cycle.points.first()?;
        if products(start.len(), cycle.points.len()) > MOST_PRODUCTS {
            return None;
        }
        let points = FRACTION_DISTANCES.iter().find_map(|near| {
            let guess: Option<Vec<Rational>> =
                start.iter().map(|&x| simplest_fraction(x, near * cycle.size())).collect();
            self.closed_cycle(eps, &guess?, cycle.points.len())
        })?;
        let polynomial = characteristic_polynomial(&self.exact_derivative(eps, &points)?);
        Some(RationalCycle { stability: stability(&polynomial), points, polynomial })
    }

    fn exact_derivative(&self, eps: &Rational, points: &[Vec<Rational>]) -> Option<Vec<Vec<Rational>>> {
        let interpreter = Interpreter::new(self.field().system());
        let jacobians = points.iter().map(|x| {
            let at = Point { state: x.clone(), parameters: self.parameters().to_vec(), eps: eps.clone() };
            interpreter.jacobian(&Exact, &at, &interpreter.next(&Exact, &at)?)
        });
        jacobians.reduce(|before, here| Some(product(&here?, &before?)))?
    }

    fn closed_cycle(&self, eps: &Rational, start: &[Rational], period: usize) -> Option<Vec<Vec<Rational>>> {
        let orbit = HeightsOrbit::new(self.field().system(), self.parameters(), eps, start).ok()?;
        let mut orbit = orbit.within_digits(MOST_DIGITS);
        let mut points = Vec::new();
        for _ in 0..=period {
            orbit.next()?;
            points.push(orbit.point());
        }
        (points.pop()? == points[0]).then_some(points)
    }
}

/// Counts the multiplications of fractions for the derivative and its characteristic polynomial.
fn products(variables: usize, period: usize) -> usize {
    variables.saturating_pow(3).saturating_mul(variables.saturating_add(period))
}

/// Returns the fraction with the smallest denominator at a distance of at most `near` from x.
fn simplest_fraction(x: f64, near: f64) -> Option<Rational> {
    let (low, high) = (Rational::from_f64(x - near)?, Rational::from_f64(x + near)?);
    let zero = Rational::zero();
    if low <= zero && zero <= high {
        return Some(zero);
    }
    if high < zero { Some(-simplest_between(&-high, &-low)?) } else { simplest_between(&low, &high) }
}

/// Returns the simplest fraction in [low, high] by continued fractions; both ends are positive.
fn simplest_between(low: &Rational, high: &Rational) -> Option<Rational> {
    let (mut low, mut high) = (low.clone(), high.clone());
    let mut taken = Vec::new();
    let last = loop {
        let floor = Rational::from_f64(low.to_f64().floor()).filter(|floor| *floor <= low)?;
        if floor == low {
            break floor;
        }
        let next = &floor + &Rational::one();
        if next <= high {
            break next;
        }
        let one = Rational::one();
        (low, high) = (one.checked_div(&(&high - &floor))?, one.checked_div(&(&low - &floor))?);
        taken.push(floor);
        // Only a safeguard: the continued fractions of two doubles differ in an earlier term.
        if taken.len() > 100 {
            return None;
        }
    };
    taken.iter().rev().try_fold(last, |inner, floor| Some(floor + &Rational::one().checked_div(&inner)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_orbit_that_does_not_close_ends_at_the_limit_of_digits() {
        let text = "xdot = x*(1 - y); ydot = y*(x - 1);";
        let map = crate::Field::parse(text).unwrap().map().unwrap();
        let (eps, start) = (Rational::new(1, 5), [Rational::new(3, 5), Rational::one()]);
        assert_eq!(map.closed_cycle(&eps, &start, 10_000), None);
        assert_eq!(
            map.closed_cycle(&eps, &[Rational::one(), Rational::one()], 10_000).unwrap().len(),
            10_000
        );
    }

    #[test]
    fn long_cycles_of_many_variables_are_beyond_the_products() {
        assert!(products(4, 150) < MOST_PRODUCTS && products(20, 1) < MOST_PRODUCTS);
        let equation = |i: usize| format!("x{i}dot = x{i}*(x{} - 1);", (i + 1) % 24);
        let text: String = (0..24).map(equation).collect();
        let map = crate::Field::parse(&text).unwrap().map().unwrap();
        let cycle = kahan_dynamics::periodic::periodic_point(&map.at(0.1), &[0.9; 24], 1).unwrap();
        assert!(products(24, 1) > MOST_PRODUCTS);
        assert_eq!(map.rational_cycle(&Rational::new(1, 10), &cycle), None);
    }

    #[test]
    fn the_simplest_fraction_near_a_number_is_found() {
        for (x, above, below) in
            [(0.5, 1, 2), (1.0 / 3.0, 1, 3), (-22.0 / 7.0, -22, 7), (0.0, 0, 1), (1e-15, 0, 1), (41.0, 41, 1)]
        {
            assert_eq!(simplest_fraction(x, 1e-12), Some(Rational::new(above, below)), "{x}");
        }
        assert_eq!(simplest_fraction(std::f64::consts::PI, 2e-3), Some(Rational::new(22, 7)));
    }
}
