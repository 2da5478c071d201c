//! Orbits in any scheme, chosen at run time: precision, order, compensation.
//!
//! In: the plans of a field, exact values of its parameters, a scheme, ε, a first point. Out: the
//! points of the library's own orbit of that scheme, bit for bit, by machine code where it can be
//! had and else by the interpreter.

mod coded;
mod interpreted;
#[cfg(test)]
mod tests;

use kahan_algebra::rational::Rational;
use kahan_core::{Composition, Dd, FloatScalar, Scheme};

use crate::Map;

use coded::Coding;
use interpreted::Interpreting;

/// An orbit that is at some point, in a scheme that was chosen at run time; begun by
/// [`Map::orbit`].
#[derive(Debug)]
pub struct SchemeOrbit {
    engine: Engine,
    /// The same orbit interpreted, put at a point where something is asked about it.
    interpreter: Interpreting,
    point: Vec<Dd>,
}

#[derive(Clone, Debug)]
enum Engine {
    Code(Coding),
    Interpreter(Box<Interpreting>),
}

/// Where an orbit ends: no step leads from there to a point that is finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct End {
    /// How many steps led there.
    pub steps: u64,
    /// Whether the step from there divides by a number that is exactly 0; where not, the numbers
    /// leave the range.
    pub is_pole: bool,
}

impl SchemeOrbit {
    /// The orbit of a map at its first point, which has a coordinate a variable.
    pub(crate) fn begin(map: &Map, scheme: Scheme, eps: &Rational, start: &[Rational]) -> Self {
        let interpreter = Interpreting::begin(map, scheme, eps, start);
        let engine = match Coding::begin(map, scheme, eps, start) {
            Some(code) => Engine::Code(code),
            None => Engine::Interpreter(Box::new(interpreter.clone())),
        };
        let mut orbit = SchemeOrbit { engine, interpreter, point: vec![Dd::default(); start.len()] };
        orbit.look();
        orbit
    }

    /// Whether it is machine code.
    #[must_use]
    pub fn is_code(&self) -> bool {
        matches!(self.engine, Engine::Code(_))
    }

    /// The point.
    #[must_use]
    pub fn point(&self) -> &[Dd] {
        &self.point
    }

    /// The integrals that are claimed without `when`, at the point, in the numbers that steps are
    /// computed in. What divides by zero there is not finite.
    #[must_use]
    pub fn integrals(&mut self) -> Vec<Dd> {
        self.interpreter.put(&self.point);
        self.interpreter.integrals()
    }

    /// So many steps further. Where a step has no value, the point is not finite from then on.
    pub fn advance(&mut self, steps: u64) {
        match &mut self.engine {
            Engine::Code(code) => {
                if !code.advance(steps) {
                    self.interpret(steps);
                }
            }
            Engine::Interpreter(orbit) => orbit.advance(steps),
        }
        self.look();
    }

    /// So many steps further, or to the last point that is finite.
    ///
    /// # Errors
    /// [`End`] where that comes before; what a compensated orbit carries beside its point is not
    /// looked at to say why.
    pub fn advance_while_finite(&mut self, steps: u64) -> Result<(), End> {
        let start = self.engine.clone();
        self.advance(steps);
        let Some(largest) = steps.checked_ilog2().filter(|_| !self.is_finite()) else { return Ok(()) };
        self.return_to(start);
        let mut taken = 0;
        // What is not finite stays so: the steps that are left to take are a sum of powers of 2.
        for power in (0..=largest).rev() {
            let before = self.engine.clone();
            self.advance(1 << power);
            if self.is_finite() {
                taken += 1 << power;
            } else {
                self.return_to(before);
            }
        }
        self.interpreter.put(&self.point);
        Err(End { steps: taken, is_pole: self.interpreter.divides_by_zero() })
    }

    fn return_to(&mut self, engine: Engine) {
        self.engine = engine;
        self.look();
    }

    fn is_finite(&self) -> bool {
        self.point.iter().all(|x| x.is_finite())
    }

    fn look(&mut self) {
        match &self.engine {
            Engine::Code(code) => code.point(&mut self.point),
            Engine::Interpreter(orbit) => orbit.point(&mut self.point),
        }
    }

    /// Goes on by the interpreter, from the point before.
    fn interpret(&mut self, steps: u64) {
        let mut orbit = self.interpreter.clone();
        orbit.put(&self.point);
        orbit.advance(steps);
        self.engine = Engine::Interpreter(Box::new(orbit));
    }
}

/// ε of each stage that differs, the middle one last.
fn stages<G: FloatScalar>(composition: Composition, eps: G) -> Vec<G> {
    let differing = composition.coefficients().take(composition.stages().div_ceil(2));
    match composition.stages() {
        1 => vec![eps],
        _ => differing.map(|gamma| G::constant(gamma) * eps).collect(),
    }
}
