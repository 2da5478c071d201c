//! Defaults for ε and the first point, chosen so that a picture shows a typical orbit.

use kahan_algebra::field::Field;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_lift::{Lift, Reembedding};
use kahan_runtime::MapAt;

use crate::error::StudyError;
use crate::map::rate;
use crate::study::Study;

/// An orbit for figures.
#[derive(Clone, Debug)]
pub struct ShownOrbit {
    /// ε, half the time step.
    pub eps: Rational,
    /// The first point.
    pub start: Vec<Rational>,
    /// The minimum and maximum of each variable along the orbit.
    pub extremes: Vec<[f64; 2]>,
    /// The largest coordinate of the first point, or the length scale of the field if all are 0.
    pub size: f64,
    /// Whether the orbit stays bounded during the trial.
    pub stays: bool,
}

const STEPS: u64 = 4000;
/// An orbit has escaped if a point exceeds the size of the first point by this factor.
const ESCAPE_RATIO: f64 = 1e3;
/// The error of a lift's relations above which a smaller ε is tried.
const LARGEST_ERROR: f64 = 0.1;
/// The coordinates of first points, simple fractions for exact orbits. They differ, because points
/// with equal coordinates often lie on a symmetry axis.
const START_COORDINATES: [(i64, i64); 6] = [(1, 1), (1, 2), (1, 3), (2, 3), (1, 4), (3, 4)];
/// Pairs (p, q): first points of the size p/q times the field's length scale are tried in turn.
const START_SIZES: [(i64, i64); 6] = [(1, 1), (1, 5), (5, 1), (1, 20), (20, 1), (1, 100)];

impl Study {
    /// Returns an orbit to show; chooses ε and the start if they are not given.
    ///
    /// ε is a power of two, small compared with 1/‖f′(x)‖∞ on a trial orbit. Starts are tried until
    /// an orbit stays bounded and keeps moving. Costs some orbits of 4000 steps.
    ///
    /// # Errors
    /// [`StudyError`]: missing values, a point that does not fit, or a field that is undefined at
    /// its parameters.
    pub fn shown_orbit(
        &self,
        eps: Option<&Rational>,
        start: Option<&[Rational]>,
    ) -> Result<ShownOrbit, StudyError> {
        let start = start.map(<[Rational]>::to_vec).or_else(|| self.start());
        start.as_ref().map(|start| self.point(start)).transpose()?;
        let map = self.map()?;
        // The coefficients of a lifted field do not determine a length scale, so its length is 1.
        let is_lifted = self.lift().is_some_and(|lift| lift.order() > 0);
        let length = if is_lifted { 1.0 } else { length_scale(self.system(), map.parameters(), eps) };
        let starts =
            start.map_or_else(|| start_points(self.coordinates().len(), length), |start| vec![start]);
        let (mut best, mut refused): (Option<TrialOrbit>, _) = (None, None);
        for own in starts {
            // A start at which a new variable of a lift is undefined is skipped.
            let start = match self.point(&own) {
                Ok(start) => start,
                Err(error) => {
                    refused = Some(error);
                    continue;
                }
            };
            // `share` bounds ε·`rate`. Without a lift, `rate` overestimates frequencies.
            let share = if is_lifted { 0.1 } else { 0.2 };
            let mut rate = StepsAndRates::new(self, map.at(0.0), true).rate(&floats(&start));
            // ε follows from the largest rate so far. There are two trials. Lifted fields get up to
            // two more while no orbit stays bounded.
            for look in 0..4 {
                if look > 1 && (!is_lifted || best.as_ref().is_some_and(|best| best.shown.stays)) {
                    break;
                }
                let eps = eps.cloned().unwrap_or_else(|| round_below(share / rate));
                let mut way = StepsAndRates::new(self, map.at(eps.to_f64()), true);
                let mut followed = TrialOrbit::of(&mut way, eps, &start, length);
                followed.shown.start.clone_from(&own);
                rate = rate.max(followed.rate);
                if best.as_ref().is_none_or(|best| best.preference() < followed.preference()) {
                    best = Some(followed);
                }
            }
            if best.as_ref().is_some_and(|best| best.shown.stays && best.moves) {
                break;
            }
        }
        let mut shown = best.map(|best| best.shown).ok_or_else(|| refused.expect("there is a start"))?;
        shown.extremes = self.project(&shown.extremes);
        if !is_lifted || self.lift_start().is_none() {
            return Ok(shown);
        }
        // While errors of the lift's relations are large, ε is halved, unless it is given.
        let (start, tries) = (self.point(&shown.start)?, if eps.is_some() { 1 } else { 5 });
        let (own, mut smaller) = (shown.start.clone(), shown.eps.clone());
        shown.stays = false;
        for _ in 0..tries {
            let mut way = StepsAndRates::new(self, map.at(smaller.to_f64()), false);
            let TrialOrbit { shown: followed, error, .. } =
                TrialOrbit::of(&mut way, smaller.clone(), &start, length);
            if followed.stays {
                shown =
                    ShownOrbit { start: own.clone(), extremes: self.project(&followed.extremes), ..followed };
            }
            if shown.stays && error <= LARGEST_ERROR {
                break;
            }
            smaller = &smaller * &Rational::new(1, 2);
        }
        Ok(shown)
    }
}

/// The map, or the projected step, of a trial orbit, together with its rates.
struct StepsAndRates<'a> {
    at: MapAt<f64>,
    lift: Option<(&'a Lift, Vec<f64>)>,
    /// The projection of each step onto the relations of the lift, if requested.
    reembedding: Option<Reembedding>,
}

impl<'a> StepsAndRates<'a> {
    fn new(study: &'a Study, at: MapAt<f64>, projects: bool) -> Self {
        let lift = study.lift().filter(|lift| lift.order() > 0);
        let lift = lift.map(|lift| {
            let value =
                |name: &String| study.parameter(name).map_or(f64::NAN, |k| at.map().parameters()[k].to_f64());
            (lift, lift.parameters.iter().map(value).collect())
        });
        StepsAndRates { at, lift, reembedding: projects.then(Reembedding::default) }
    }

    fn advance(&mut self, x: &mut [f64]) {
        let StepsAndRates { at, lift, reembedding } = self;
        let step = |x: &mut [f64]| at.advance(x, 1).expect("the start is of the field");
        let (Some((lift, own)), Some(reembedding)) = (lift, reembedding) else { return step(x) };
        let (states, new) = x.split_at_mut(lift.states.len());
        if reembedding.step(states, |states| lift.embed(states, own), step) {
            new.copy_from_slice(&lift.embed(states, own));
        } else {
            states.fill(f64::NAN);
        }
    }

    fn error(&self, x: &[f64]) -> f64 {
        let Some((lift, own)) = &self.lift else { return 0.0 };
        let (states, new) = x.split_at(lift.states.len());
        let values = lift.embed(states, own).into_iter().zip(new).zip(&lift.new);
        // The work done by the forces has no expression, because it is no function of the state.
        let values = values.filter(|(_, new)| new.expression.is_some());
        values.map(|((value, own), _)| (value - own).abs() / value.abs().max(1.0)).fold(0.0, f64::max)
    }

    /// Returns ‖f′‖∞. For a lifted field, returns the square root of ‖J²‖∞, where J is the Jacobian
    /// of the original equations. For an oscillator this is the frequency.
    fn rate(&self, x: &[f64]) -> f64 {
        /// The step size of central differences, about the cube root of the rounding error.
        const DIFFERENCE_STEP: f64 = 1e-5;

        let Some((lift, own)) = &self.lift else { return rate(&self.at, x) };
        let (count, states) = (x.len(), lift.states.len());
        let mut jacobian = vec![0.0; count * count];
        self.at.field_jacobian(x, &mut jacobian).expect("the point is of the field");
        let mut original = vec![0.0; states * states];
        for k in 0..states {
            let step = DIFFERENCE_STEP * x[k].abs().max(1.0);
            let moved = |by: f64| {
                let mut point = x[..states].to_vec();
                point[k] += by;
                lift.embed(&point, own)
            };
            let (above, below) = (moved(step), moved(-step));
            for (row, entry) in original.iter_mut().skip(k).step_by(states).enumerate() {
                let row = &jacobian[row * count..][..count];
                let slopes = above.iter().zip(&below).map(|(above, below)| (above - below) / (2.0 * step));
                let through = row[states..].iter().zip(slopes).map(|(one, slope)| one * slope);
                *entry = row[k] + through.sum::<f64>();
            }
        }
        let square = |row: &[f64], k: usize| {
            let column = original.iter().skip(k).step_by(states);
            row.iter().zip(column).map(|(one, other)| one * other).sum::<f64>().abs()
        };
        let sums = original.chunks(states).map(|row| (0..states).map(|k| square(row, k)).sum::<f64>());
        sums.fold(0.0, f64::max).sqrt()
    }
}

/// A trial orbit with the numbers by which trials are compared.
struct TrialOrbit {
    shown: ShownOrbit,
    steps: u64,
    moves: bool,
    rate: f64,
    error: f64,
}

impl TrialOrbit {
    fn of(way: &mut StepsAndRates<'_>, eps: Rational, start: &[Rational], length: f64) -> Self {
        let mut x = floats(start);
        // The scales of new variables may differ, so only original variables are compared.
        let original = way.lift.as_ref().map_or(x.len(), |(lift, _)| lift.states.len());
        let size = x[..original].iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let size = if size > 0.0 { size } else { length };
        let is_within = |x: &[f64]| x[..original].iter().all(|x| x.abs() <= ESCAPE_RATIO * size);
        let mut extremes: Vec<[f64; 2]> = x.iter().map(|&x| [x, x]).collect();
        let (mut late, mut steepest, mut error, mut steps) = (extremes.clone(), 0.0f64, 0.0f64, 0);
        while steps < STEPS && is_within(&x) {
            widen(&mut extremes, &x);
            if steps == STEPS / 2 {
                late = x.iter().map(|&x| [x, x]).collect();
            }
            widen(&mut late, &x);
            if steps % 16 == 0 {
                steepest = steepest.max(way.rate(&x));
            }
            error = error.max(way.error(&x));
            steps += 1;
            way.advance(&mut x);
        }
        let spread = |ends: &[[f64; 2]]| ends.iter().fold(0.0, |most: f64, [low, high]| most.max(high - low));
        let moves = spread(&late) > 1e-3 * size;
        let shown = ShownOrbit { eps, start: start.to_vec(), extremes, size, stays: steps == STEPS };
        TrialOrbit { shown, steps, moves, rate: steepest, error }
    }

    /// Returns the sort key: bounded moving orbits are best, then bounded ones, then long ones.
    fn preference(&self) -> (bool, bool, u64) {
        (self.shown.stays && self.moves, self.shown.stays, self.steps)
    }
}

fn widen(extremes: &mut [[f64; 2]], x: &[f64]) {
    for (ends, x) in extremes.iter_mut().zip(x) {
        *ends = [ends[0].min(*x), ends[1].max(*x)];
    }
}

fn floats(start: &[Rational]) -> Vec<f64> {
    start.iter().map(Rational::to_f64).collect()
}

/// Returns the length scale of the field, a power of two at which terms of different degrees
/// balance. If all terms are quadratic, points of this size move by about this size in time ε.
fn length_scale(system: &System, parameters: &[Rational], eps: Option<&Rational>) -> f64 {
    let [constant, linear, quadratic] =
        [0, 1, 2].map(|degree| coefficient(&system.field, parameters, degree));
    let time = eps.map_or(1.0, |eps| eps.to_f64().abs());
    power_below(match (constant > 0.0, linear > 0.0, quadratic > 0.0) {
        (false, false, true) => 1.0 / (quadratic * time),
        (_, _, true) => (linear / quadratic).max((constant / quadratic).sqrt()),
        (true, true, false) => constant / linear,
        (_, _, false) => 1.0,
    })
    .unwrap_or(1.0)
}

fn coefficient(field: &Field, parameters: &[Rational], degree: u32) -> f64 {
    let at = |polynomial: &Polynomial| {
        let at_zero = polynomial.substitute(field.symbols.epsilon(), &Rational::ZERO);
        let places = parameters.iter().enumerate();
        places
            .fold(at_zero, |polynomial, (k, value)| polynomial.substitute(field.symbols.parameter(k), value))
    };
    let sizes = field.components.iter().enumerate().flat_map(|(i, component)| {
        let below = at(component.denominator()).as_constant().unwrap_or_default();
        let above = at(&field.homogeneous_part(i, degree));
        let sizes = above.terms().filter_map(|(_, above)| above.checked_div(&below));
        sizes.map(|size| size.abs().to_f64()).collect::<Vec<_>>()
    });
    sizes.fold(0.0, f64::max)
}

/// Returns the largest power of two ≤ `number`; `None` if there is no such float.
fn power_below(number: f64) -> Option<f64> {
    const EXPONENT: u64 = 0x7ff << 52;
    let power = f64::from_bits(number.to_bits() & EXPONENT);
    (number > 0.0 && power > 0.0 && power.is_finite()).then_some(power)
}

/// Returns first points to try, with sizes relative to `length`.
fn start_points(variables: usize, length: f64) -> Vec<Vec<Rational>> {
    let signs = [[1, 1], [1, -1]];
    let starts = START_SIZES.iter().flat_map(|size| signs.iter().map(move |signs| (size, signs)));
    let length = Rational::from_f64(length).expect("a length is finite");
    let coordinate = |size: &(i64, i64), sign: i64, k: usize| {
        let (above, below) = START_COORDINATES[k % START_COORDINATES.len()];
        &Rational::new(sign * above * size.0, below * size.1) * &length
    };
    starts.map(|(size, signs)| (0..variables).map(|k| coordinate(size, signs[k % 2], k)).collect()).collect()
}

/// Returns the largest power of two ≤ `bound`, or 1 for an infinite bound.
fn round_below(bound: f64) -> Rational {
    const SMALL: f64 = 1.0 / (1_u64 << 30) as f64;
    let eps = power_below(bound).unwrap_or(if bound > 0.0 { 1.0 } else { SMALL });
    Rational::from_f64(eps).expect("a power of two is finite")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Subject, Systems};

    #[test]
    fn eps_is_a_power_of_two_below_its_bound() {
        for (bound, below) in [(3.0, (2, 1)), (1.0, (1, 1)), (0.7, (1, 2)), (0.19, (1, 8)), (0.004, (1, 256))]
        {
            assert_eq!(round_below(bound), Rational::new(below.0, below.1), "{bound}");
        }
        assert!(round_below(f64::NAN).to_f64() > 0.0 && round_below(0.0).to_f64() > 0.0);
        assert_eq!(round_below(f64::INFINITY), Rational::one());
    }

    /// Chooses an orbit for q = 2^k and nu = 2^j. Returns it in units in which q = nu = 1.
    fn in_unit(text: &str, [k, j]: [i32; 2], eps: Option<f64>) -> (Vec<f64>, Vec<f64>, bool) {
        let power = |exponent: i32| f64::from(exponent).exp2();
        let field = Subject::text(text).study(&Systems).unwrap();
        let value = |name: &String| Rational::from_f64(power(if name == "q" { k } else { j }));
        let field = field.at(field.parameters().iter().map(value).collect());
        let eps = eps.map(|eps| Rational::from_f64(eps * power(-j)).unwrap());
        let shown = field.shown_orbit(eps.as_ref(), None).unwrap();
        let lengths = shown.start.iter().map(Rational::to_f64).chain([shown.size]);
        let lengths = lengths.chain(shown.extremes.into_iter().flatten()).map(|x| x * power(k));
        (lengths.collect(), vec![shown.eps.to_f64() * power(j)], shown.stays)
    }

    #[test]
    fn scenes_are_the_same_in_every_unit() {
        let fields = [
            "xdot = nu*x*(1 - q*y); ydot = nu*y*(q*x - 1);",
            "xdot = nu*y; ydot = nu*(q*x^2 - x);",
            "xdot = nu*10*(y - x); ydot = nu*(x*(28 - q*z) - y); zdot = nu*(q*x*y - 8/3*z);",
            "xdot = nu*(-y - z); ydot = nu*(x + 0.2*y); zdot = nu*(0.2/q + z*(q*x - 5.7));",
            "xdot = nu*(1/q + q*x^2);",
            "xdot = nu*(y - x); ydot = nu*(0.3/q - y);",
        ];
        for text in fields {
            for eps in [None, Some(0.01)] {
                let ordinary = in_unit(text, [0, 0], eps);
                for unit in [[300, 0], [-300, 0], [0, 50], [0, -50], [-77, 13]] {
                    assert_eq!(in_unit(text, unit, eps), ordinary, "{text} in {unit:?}");
                }
            }
        }
        // In this field q and nu occur only as a product.
        let text = "xdot = q*nu*x*(y - z); ydot = q*nu*y*(z - x); zdot = q*nu*z*(x - y);";
        for unit in [[300, 0], [-300, 0], [0, 50], [-77, 13]] {
            assert_eq!(in_unit(text, unit, Some(0.01)), in_unit(text, [0, 0], Some(0.01)), "{unit:?}");
        }
        assert_eq!(in_unit(text, [300, 0], None), in_unit(text, [0, 0], None));
    }

    #[test]
    fn an_orbit_that_stays_is_found() {
        // About half of all starts have orbits that escape, including the start of size 1.
        let field = Subject::text("xdot = y; ydot = x^2 - x;").study(&Systems).unwrap();
        let shown = field.shown_orbit(None, None).unwrap();
        assert!(shown.stays && shown.start[0] != Rational::one(), "{shown:?}");
        let given = [Rational::new(1, 7), Rational::new(0, 1)];
        let shown = field.shown_orbit(Some(&Rational::new(1, 9)), Some(&given)).unwrap();
        assert_eq!((shown.start.as_slice(), shown.eps), (&given[..], Rational::new(1, 9)));
    }

    #[test]
    fn where_none_stays_the_longest_is_taken() {
        let field = Subject::text("xdot = x^2 + 1;").study(&Systems).unwrap();
        let shown = field.shown_orbit(None, None).unwrap();
        assert_eq!(shown.start.len(), 1);
    }
}
