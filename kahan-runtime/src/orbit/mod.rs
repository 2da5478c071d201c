//! Orbits in any scheme, chosen at run time: precision, order, compensation.
//!
//! In: the plans of a field, exact values of its parameters, a scheme, ε, a first point. Out: the
//! points of the library's own orbit of that scheme, bit for bit, by machine code where it can be
//! had and else by the interpreter.

mod coded;
mod interpreted;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;
use kahan_algebra::system::System;
use kahan_algebra::{Derived, derive};
use kahan_core::{Dd, Scheme};

use crate::interpreted::{CannotInterpret, UnsupportedDimension};
use crate::machine::Codes;

use coded::Coding;
use interpreted::{Nowhere, Steps, begin};

/// The map of a field at parameters, whose orbits are begun in any scheme.
///
/// Copies share the code.
#[derive(Clone, Debug)]
pub struct Orbits {
    derived: Arc<Derived>,
    codes: Arc<Codes>,
    parameters: Arc<[Rational]>,
}

/// An orbit that is at some point, in a scheme that was chosen at run time.
pub struct SchemeOrbit {
    of: Orbits,
    scheme: Scheme,
    eps: Rational,
    engine: Engine,
    point: Vec<Dd>,
}

enum Engine {
    Code(Coding),
    Interpreter(Box<dyn Steps>),
}

impl Orbits {
    /// The map of a system at these values of its parameters, in their order.
    ///
    /// Cost: deriving the map; its step is planned, and compiled, when an orbit asks for it.
    ///
    /// # Errors
    /// [`CannotInterpret`]: another number of parameters, or a field that divides by zero.
    pub fn of(system: &System, parameters: &[Rational]) -> Result<Self, CannotInterpret> {
        let symbols = &system.field.symbols;
        if symbols.parameters.len() != parameters.len() {
            let (found, given) = (symbols.parameters.len(), parameters.len());
            return Err(CannotInterpret::Parameters { found, given });
        }
        let derived = derive(system);
        let divisors = derived.divisors.evaluate(&Exact, |variable| match symbols.symbol(variable) {
            Symbol::Parameter(k) => parameters[k].clone(),
            // Divisors are free of everything else.
            _ => Rational::zero(),
        });
        if divisors.iter().any(|value| value.as_ref().is_none_or(Rational::is_zero)) {
            return Err(CannotInterpret::Undefined);
        }
        Ok(Orbits { derived: derived.into(), codes: Arc::default(), parameters: parameters.into() })
    }

    /// The orbit in a scheme at its first point; `eps` is ε, half the time step. Each number is
    /// rounded once.
    ///
    /// Cost: the first orbit of its kind compiles its step, which takes some tens of microseconds
    /// for three variables.
    ///
    /// # Errors
    /// [`UnsupportedDimension`], where there is no code.
    ///
    /// # Panics
    /// If the point has another number of coordinates than the field has variables.
    pub fn begin(
        &self,
        scheme: Scheme,
        eps: &Rational,
        start: &[Rational],
    ) -> Result<SchemeOrbit, UnsupportedDimension> {
        let variables = self.derived.system.field.dimension();
        assert_eq!(start.len(), variables, "a point has a coordinate for each variable");
        let engine = match Coding::begin(self, scheme, eps, start) {
            Some(code) => Engine::Code(code),
            None => Engine::Interpreter(begin(self, scheme, eps, start)?),
        };
        let (of, eps, point) = (self.clone(), eps.clone(), vec![Dd::default(); variables]);
        let mut orbit = SchemeOrbit { of, scheme, eps, engine, point };
        orbit.look();
        Ok(orbit)
    }
}

impl SchemeOrbit {
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
        let orbit = start.and_then(|start| begin(&self.of, self.scheme, &self.eps, &start).ok());
        let mut orbit = orbit.unwrap_or_else(|| Box::new(Nowhere));
        orbit.advance(steps);
        self.engine = Engine::Interpreter(orbit);
    }
}

impl core::fmt::Debug for SchemeOrbit {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { scheme, eps, point, .. } = self;
        f.debug_struct("SchemeOrbit").field("scheme", scheme).field("eps", eps).field("point", point).finish_non_exhaustive()
    }
}
