//! Orbits in any scheme, chosen at run time: precision, order, compensation.
//!
//! In: the plans of a field, exact values of its parameters, a scheme, ε, a first point. Out: the
//! points of the library's own orbit of that scheme, bit for bit, by machine code where it can be
//! had and else by the interpreter.

mod coded;
mod interpreted;
#[cfg(test)]
mod tests;

use kahan_algebra::Derived;
use kahan_algebra::rational::Rational;
use kahan_core::{Dd, Scheme};

use crate::interpreted::UnsupportedDimension;
use crate::machine::Codes;

use coded::Coding;
use interpreted::{Steps, begin};

/// What an orbit is of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Subject<'a> {
    /// The plans of the field, which has a value at the parameters.
    pub(crate) derived: &'a Derived,
    /// Its code.
    pub(crate) codes: &'a Codes,
    /// The values of its parameters, in order.
    pub(crate) parameters: &'a [Rational],
}

/// An orbit that is at some point, in a scheme that was chosen at run time.
pub struct SchemeOrbit<'a> {
    subject: Subject<'a>,
    scheme: Scheme,
    eps: Rational,
    engine: Engine,
    point: Vec<Dd>,
}

enum Engine {
    Code(Coding),
    Interpreter(Box<dyn Steps>),
}

impl<'a> SchemeOrbit<'a> {
    /// The orbit at its first point, each number rounded once.
    pub(crate) fn begin(
        subject: Subject<'a>,
        scheme: Scheme,
        eps: &Rational,
        start: &[Rational],
    ) -> Result<Self, UnsupportedDimension> {
        let engine = match Coding::begin(&subject, scheme, eps, start) {
            Some(code) => Engine::Code(code),
            None => Engine::Interpreter(begin(&subject, scheme, eps, start)?),
        };
        let mut orbit = SchemeOrbit {
            subject,
            scheme,
            eps: eps.clone(),
            engine,
            point: vec![Dd::default(); start.len()],
        };
        orbit.look();
        Ok(orbit)
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
        let exact = |x: &Dd| Some(&Rational::from_f64(x.high())? + &Rational::from_f64(x.low())?);
        let start: Option<Vec<Rational>> = self.point.iter().map(exact).collect();
        let orbit = start.and_then(|start| begin(&self.subject, self.scheme, &self.eps, &start).ok());
        match orbit {
            Some(mut orbit) => {
                orbit.advance(steps);
                self.engine = Engine::Interpreter(orbit);
            }
            // Beyond the dimensions of the interpreter, as at a point that is not finite, nothing is
            // known of the next one.
            None => self.engine = Engine::Interpreter(Box::new(interpreted::Nowhere)),
        }
    }
}
