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
    map: Map,
    scheme: Scheme,
    eps: Rational,
    engine: Engine,
    point: Vec<Dd>,
}

#[derive(Debug)]
enum Engine {
    Code(Coding),
    Interpreter(Interpreting),
}

impl SchemeOrbit {
    /// The orbit of a map at its first point, which has a coordinate a variable.
    pub(crate) fn begin(map: &Map, scheme: Scheme, eps: &Rational, start: &[Rational]) -> Self {
        let engine = match Coding::begin(map, scheme, eps, start) {
            Some(code) => Engine::Code(code),
            None => Engine::Interpreter(Interpreting::begin(map, scheme, eps, start)),
        };
        let point = vec![Dd::default(); start.len()];
        let mut orbit = SchemeOrbit { map: map.clone(), scheme, eps: eps.clone(), engine, point };
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

    fn look(&mut self) {
        match &self.engine {
            Engine::Code(code) => code.point(&mut self.point),
            Engine::Interpreter(orbit) => orbit.point(&mut self.point),
        }
    }

    /// Goes on by the interpreter, from the point before.
    fn interpret(&mut self, steps: u64) {
        let mut orbit = Interpreting::from_point(&self.map, self.scheme, &self.eps, &self.point);
        orbit.advance(steps);
        self.engine = Engine::Interpreter(orbit);
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
