//! A system at a starting point: its orbits, and what else is asked of it.

use std::iter::once;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::{Dd, Precision, Scheme};
use kahan_runtime::FieldText;

use crate::map::{Map, read};

use super::CannotTrade;

/// A system at a starting point, with a clock.
pub(super) struct Runner<'a> {
    pub(super) map: Map,
    orbits: kahan_runtime::Map,
    pub(super) start: Vec<Rational>,
    pub(super) clock: Clock<'a>,
}

/// The time since a moment that stays the same.
pub(super) type Clock<'a> = &'a dyn Fn() -> Duration;

/// What looks at points: the number of steps so far, and the point; whether to go on.
pub(super) type Visit<'a> = &'a mut dyn FnMut(u64, &[Dd]) -> ControlFlow<()>;

/// Numbers of steps, each larger than the one before.
pub(super) type Stops<'a> = &'a mut dyn Iterator<Item = u64>;

impl<'a> Runner<'a> {
    /// A system at these parameters and this point.
    pub(super) fn new(
        system: &System,
        parameters: &[Rational],
        start: &[Rational],
        clock: Clock<'a>,
    ) -> Result<Self, CannotTrade> {
        let (orbits, map) = read(system, parameters).map_err(CannotTrade::CannotRun)?;
        Ok(Runner { map, orbits, start: start.to_vec(), clock })
    }

    /// E6 at a point of ordinary size: what is timed in place of a field without code.
    pub(super) fn stand_in(clock: Clock<'a>) -> Result<Self, CannotTrade> {
        let field = "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);";
        let system = FieldText::new(field.to_owned(), "E6".to_owned()).unproved_system().expect("a system");
        let start = [1, -2, 3].map(|x| Rational::new(x, 4));
        Runner::new(&system, &[], &start, clock)
    }

    /// Whether its steps are code.
    pub(super) fn is_code(&self) -> bool {
        let plain = Scheme::of(Precision::Double);
        self.orbits.orbit(plain, &Rational::one(), &self.start).is_ok_and(|orbit| orbit.is_code())
    }

    /// The seconds that so many steps take from the scene's own point, without the preparations.
    pub(super) fn seconds(&self, scheme: Scheme, eps: f64, steps: u64) -> f64 {
        self.follow(scheme, eps, None, &mut once(steps), &mut |_, _| ControlFlow::Continue(()))
    }

    /// Shows the first point of an orbit with ε = `eps` and those after the numbers of steps in
    /// `stops`, which grow, while `visit` says so; the seconds that it took, without the
    /// preparations. The orbit begins at `from`, or at the scene's own point.
    pub(super) fn follow(
        &self,
        scheme: Scheme,
        eps: f64,
        from: Option<&[Dd]>,
        stops: Stops<'_>,
        visit: Visit<'_>,
    ) -> f64 {
        let exact = |entry: &Dd| &rational(entry.high()) + &rational(entry.low());
        let start = from.map_or_else(|| self.start.clone(), |point| point.iter().map(exact).collect());
        let orbit = self.orbits.orbit(scheme, &rational(eps), &start);
        let mut orbit = orbit.expect("the point has an entry for every variable");
        let begun = (self.clock)();
        let mut step = 0;
        let mut go_on = visit(step, orbit.point());
        for stop in stops {
            if go_on.is_break() {
                break;
            }
            orbit.advance(stop - step);
            step = stop;
            go_on = visit(step, orbit.point());
        }
        (self.clock)().saturating_sub(begun).as_secs_f64()
    }
}

/// A float as the number that it is.
fn rational(value: f64) -> Rational {
    Rational::from_f64(value).expect("what orbits begin with is finite")
}
