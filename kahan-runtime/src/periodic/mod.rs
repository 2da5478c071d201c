//! Periodic points of maps that are read at run time, and proofs over ℚ of those that are rational.
//!
//! In: a map at its ε for [`kahan_core::periodic`], and a cycle that this found. Out: fractions whose
//! orbit closes exactly, where there are such near the cycle.

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::DMatrix;
use kahan_core::periodic::{Differentiable, Parametric, PeriodicPoint};

use crate::heights::HeightsOrbit;
use crate::{Map, MapAt};

impl Differentiable for MapAt<f64> {
    fn dimension(&self) -> usize {
        self.map().field().variables().len()
    }

    /// # Panics
    /// If `x` has not an entry a variable.
    fn image(&self, x: &[f64]) -> Vec<f64> {
        let mut image = vec![0.0; x.len()];
        assert!(self.step(x, &mut image).is_ok(), "{} numbers for another number of variables", x.len());
        image
    }

    /// # Panics
    /// If `x` has not an entry a variable.
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        let mut rows = vec![0.0; x.len() * x.len()];
        assert!(self.jacobian(x, &mut rows).is_ok(), "{} numbers for another number of variables", x.len());
        DMatrix::from_row_slice(x.len(), x.len(), &rows)
    }
}

/// A map whose derivative by one of its parameters, or by ε, is known, too; made by
/// [`MapAt::by`].
#[derive(Clone, Debug)]
pub struct ParametricAt {
    at: MapAt<f64>,
    /// The place of the parameter; that of ε is behind all of them.
    place: usize,
}

impl MapAt<f64> {
    /// This map, as one of those at all values of ε, or of the parameter at this place in
    /// [`Field::parameters`](crate::Field::parameters).
    ///
    /// # Panics
    /// If there is no such parameter.
    #[must_use]
    pub fn by(&self, parameter: Option<usize>) -> ParametricAt {
        let parameters = self.map().parameters().len();
        assert!(parameter.is_none_or(|place| place < parameters), "the map has {parameters} parameters");
        ParametricAt { at: self.clone(), place: parameter.unwrap_or(parameters) }
    }
}

impl Differentiable for ParametricAt {
    fn dimension(&self) -> usize {
        self.at.dimension()
    }

    fn image(&self, x: &[f64]) -> Vec<f64> {
        self.at.image(x)
    }

    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        self.at.derivative(x)
    }
}

impl Parametric for ParametricAt {
    /// # Panics
    /// If `x` has not an entry a variable.
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        self.at.by_constant(self.place, x).expect("x has an entry a variable")
    }
}

impl Map {
    /// The rational cycle near one in floats: its points, proved by `==` to be carried into each
    /// other by the map at this ε, half the time step, the last into the first. `None` where no
    /// fractions with denominators of a few digits are.
    ///
    /// Cost: an exact orbit over the period for each of some guesses.
    #[must_use]
    pub fn rational_cycle(&self, eps: &Rational, cycle: &PeriodicPoint) -> Option<Vec<Vec<Rational>>> {
        /// How far the simplest fraction may be from a number, the nearest first.
        const NEAR: [f64; 4] = [1e-14, 1e-12, 1e-10, 1e-8];

        let start = cycle.points.first()?;
        NEAR.iter().find_map(|near| {
            let guess: Option<Vec<Rational>> =
                start.iter().map(|&x| simplest(x, near * x.abs().max(1.0))).collect();
            self.closed(eps, &guess?, cycle.points.len())
        })
    }

    /// The orbit of a point, if it closes after so many steps.
    fn closed(&self, eps: &Rational, start: &[Rational], period: usize) -> Option<Vec<Vec<Rational>>> {
        let mut orbit = HeightsOrbit::new(self.field().system(), self.parameters(), eps, start).ok()?;
        let mut points = Vec::new();
        for _ in 0..=period {
            orbit.next()?;
            points.push(orbit.point());
        }
        (points.pop()? == points[0]).then_some(points)
    }
}

/// The fraction with the smallest denominator that is at most `near` from a number.
fn simplest(x: f64, near: f64) -> Option<Rational> {
    let (low, high) = (Rational::from_f64(x - near)?, Rational::from_f64(x + near)?);
    let zero = Rational::zero();
    if low <= zero && zero <= high {
        return Some(zero);
    }
    if high < zero { Some(-between(&-high, &-low)?) } else { between(&low, &high) }
}

/// The simplest fraction from `low` to `high`, both above 0, by their continued fractions.
fn between(low: &Rational, high: &Rational) -> Option<Rational> {
    let (mut low, mut high) = (low.clone(), high.clone());
    // What was taken off, from the outside to the inside.
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
        // Doubles have no more than this.
        if taken.len() > 100 {
            return None;
        }
    };
    taken.iter().rev().try_fold(last, |inner, floor| Some(floor + &Rational::one().checked_div(&inner)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Field;
    use kahan_core::periodic::periodic_point;

    #[test]
    fn the_simplest_fraction_near_a_number_is_found() {
        for (x, above, below) in
            [(0.5, 1, 2), (1.0 / 3.0, 1, 3), (-22.0 / 7.0, -22, 7), (0.0, 0, 1), (1e-15, 0, 1), (41.0, 41, 1)]
        {
            assert_eq!(simplest(x, 1e-12), Some(Rational::new(above, below)), "{x}");
        }
        assert_eq!(simplest(std::f64::consts::PI, 2e-3), Some(Rational::new(22, 7)));
    }

    #[test]
    fn equilibria_of_the_flow_are_fixed_points_of_the_map() {
        // Roots 1/3 and −2, and the line between them.
        let map = Field::parse("xdot = (3*x - 1)*(x + 2); ydot = x - 1/3 - y;").unwrap().map().unwrap();
        let eps = Rational::new(1, 9);
        for (start, x, y) in [
            ([0.3, 0.1], Rational::new(1, 3), Rational::zero()),
            ([-1.9, -2.0], Rational::new(-2, 1), Rational::new(-7, 3)),
        ] {
            let cycle = periodic_point(&map.at(eps.to_f64()), &start, 1).unwrap();
            assert_eq!(map.rational_cycle(&eps, &cycle), Some(vec![vec![x, y]]));
        }
    }

    #[test]
    fn a_rational_cycle_of_three_is_proved() {
        // In one variable the map is a Möbius transformation, here of order 3: with the discriminant
        // −3 of the field it turns by the angle whose tangent is √3.
        let map = Field::parse("xdot = x^2 + x + 1;").unwrap().map().unwrap();
        let eps = Rational::one();
        let at = map.at(1.0);
        let cycle = periodic_point(&at, &[0.2], 3).unwrap();
        assert_eq!((cycle.points.len(), cycle.family), (3, 1));
        let proved = map.rational_cycle(&eps, &cycle).unwrap();
        assert_eq!((proved.len(), &proved[0][0]), (3, &Rational::new(1, 5)));
    }

    #[test]
    fn derivatives_by_eps_and_by_parameters_are_those_of_the_formulas() {
        // (x̃ − x)/2ε = F(x,x̃) gives A(x,ε) ∂x̃/∂ε = (x̃ − x)/ε and A(x,ε) ∂x̃/∂p = 2ε ∂F/∂p.
        let text = "xdot = r*x*y + s; ydot = y - x^2/r;";
        let map = Field::parse(text).unwrap().with([("r", 0.75), ("s", 1.5)]).unwrap();
        let (eps, x) = (0.125, [0.5, -0.25]);
        let at = map.at(eps);
        let next = at.image(&x);
        let mut rows = [0.0; 4];
        at.matrix(&x, &mut rows).unwrap();
        let moved = [next[0] - x[0], next[1] - x[1]];
        // ∂F/∂r = ((x·ỹ + x̃·y)/2, x·x̃/r²) and ∂F/∂s = (1, 0)
        let by_r = [(x[0] * next[1] + next[0] * x[1]) / 2.0, x[0] * next[0] / (0.75 * 0.75)];
        let expected = [
            (None, moved.map(|entry| entry / eps)),
            (Some(0), by_r.map(|entry| 2.0 * eps * entry)),
            (Some(1), [2.0 * eps, 0.0]),
        ];
        for (parameter, right) in expected {
            let slope = at.by(parameter).by_parameter(&x);
            for i in 0..2 {
                let left = rows[2 * i] * slope[0] + rows[2 * i + 1] * slope[1];
                // Some ten roundings of numbers of size 1.
                assert!((left - right[i]).abs() < 1e-15 * 4.0, "{parameter:?}: {left} for {}", right[i]);
            }
        }
    }

    #[test]
    fn the_derivative_by_eps_goes_through_elimination_too() {
        // In ten variables the step is elimination along the couplings.
        let equation = |i: usize| format!("x{i}dot = x{i}*x{} - x{}/2 + 1/3;", (i + 1) % 10, (i + 7) % 10);
        let map = Field::parse(&(0..10).map(equation).collect::<String>()).unwrap().map().unwrap();
        let (eps, x) = (0.125, [0.5, -0.25, 1.0, 0.75, -0.5, 0.25, -1.0, 0.125, 0.375, 0.625]);
        let at = map.at(eps);
        let (next, slope) = (at.image(&x), at.by(None).by_parameter(&x));
        let mut rows = [0.0; 100];
        at.matrix(&x, &mut rows).unwrap();
        for (i, row) in rows.chunks(10).enumerate() {
            let left: f64 = row.iter().zip(&slope).map(|(entry, slope)| entry * slope).sum();
            // The slopes are below 4, and some tens of roundings.
            assert!((left - (next[i] - x[i]) / eps).abs() < 1e-14, "{i}: {left}");
        }
    }
}
