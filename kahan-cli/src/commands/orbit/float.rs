//! Orbits in rounded numbers: Kahan's map, or a composition of it.
//!
//! From row to row it runs as machine code. Where there is none, and where a stretch of steps ends
//! in numbers that are not finite, steppers go point by point, the stages of a composition at their
//! own ε, and find where and why the orbit ends.

use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::interpret::{Pole, Stepper, UndefinedField};
use kahan_algebra::rational::Rational;
use kahan_core::{Composition, Constant, Scheme};
use kahan_runtime::Field;
use kahan_runtime::orbit::SchemeOrbit;

use crate::numbers::Rounded;
use crate::printing::{Broken, Table};
use crate::reading::Request;

/// An orbit in rounded numbers.
pub(super) struct FloatOrbit<'a, A: Arithmetic> {
    arithmetic: &'a A,
    request: &'a Request,
    /// The map at ε: the time step, the integrals, and without a composition the step.
    map: Stepper<'a, A>,
    /// The stages of a composition that differ: the first half, and the middle one.
    stages: Vec<Stepper<'a, A>>,
    /// The same orbit as machine code.
    code: Option<SchemeOrbit>,
    state: Vec<A::Value>,
    /// The last point that was finite.
    before: Vec<A::Value>,
}

impl<'a, A: Rounded> FloatOrbit<'a, A> {
    /// The orbit at its first point, by the composition for this order (2, 4, 6 or 8).
    pub(super) fn new(
        arithmetic: &'a A,
        request: &'a Request,
        order: u32,
        parameters: &[A::Value],
        eps: &A::Value,
    ) -> Result<Self, UndefinedField> {
        let composition = Composition::of_order(order).filter(|composition| composition.stages() > 1);
        let differing = composition
            .iter()
            .flat_map(|composition| composition.coefficients().take(composition.stages().div_ceil(2)));
        let stage =
            |gamma: &Constant<'_>| arithmetic.multiply(&A::round(&Rational::from(gamma.to_ratio())), eps);
        let every_eps: Vec<A::Value> = std::iter::once(eps.clone()).chain(differing.map(stage)).collect();
        let mut steppers = Stepper::of_each(&request.system, arithmetic, parameters, &every_eps)?;
        let stages = steppers.split_off(1);
        let map = steppers.remove(0);
        let state: Vec<A::Value> = request.point.state.iter().map(A::round).collect();
        let scheme = Scheme::of(A::PRECISION).composed(composition.unwrap_or(Composition::KAHAN));
        let names = &request.system.field.symbols.parameters;
        let code = Field::of(&request.system)
            .with(names.iter().zip(&request.point.parameters))
            .ok()
            .and_then(|map| map.orbit(scheme, &request.point.eps, &request.point.state).ok())
            .filter(SchemeOrbit::is_code);
        Ok(Self { arithmetic, request, map, stages, code, before: state.clone(), state })
    }

    /// How it runs, in words.
    pub(super) fn runs_as(&self) -> &'static str {
        if self.code.is_some() { "machine code" } else { "interpreted" }
    }

    /// The names of the integrals, in order.
    pub(super) fn integral_names(&self) -> &[String] {
        self.map.integral_names()
    }

    /// Writes the point n as a row.
    pub(super) fn write(&mut self, table: &mut Table, n: i64) -> Result<(), Broken> {
        let number = self.arithmetic.constant(&Rational::from(n));
        let time = number.map(|n| self.arithmetic.multiply(&n, self.map.time_step()));
        let integrals = self.map.integrals(&self.state);
        table.row::<A>(n, std::iter::once(time.as_ref()).chain(self.state.iter().map(Some)).chain(integrals))
    }

    /// Goes from the point n to the one so many steps later; what to tell the user where there is
    /// none.
    pub(super) fn advance(&mut self, n: i64, steps: i64) -> Result<(), String> {
        if let Some(code) = &mut self.code {
            code.advance(steps.unsigned_abs());
            let is_finite = code.point().iter().all(|x| x.is_finite());
            if is_finite {
                self.state.iter_mut().zip(code.point()).for_each(|(x, entry)| *x = A::narrow(*entry));
                return Ok(());
            }
            self.code = None;
        }
        (n..n + steps).try_for_each(|n| self.advance_once(n))
    }

    fn advance_once(&mut self, n: i64) -> Result<(), String> {
        self.before.clone_from(&self.state);
        match self.step() {
            Err(Pole) if !self.stages.is_empty() => Err(self.request.stage_pole::<A>(n, &self.before)),
            Err(Pole) => Err(self.request.pole::<A>(n, &self.before, self.map.is_reduced())),
            Ok(()) if self.state.iter().all(A::is_finite) => Ok(()),
            Ok(()) => Err(self.request.overflow::<A>(n, &self.before)),
        }
    }

    /// One step of the map, or all stages of the composition: the first half, the middle one, and
    /// the half backwards.
    fn step(&mut self) -> Result<(), Pole> {
        let Some(last) = self.stages.len().checked_sub(1) else {
            return self.map.advance(&mut self.state);
        };
        for k in (0..=last).chain((0..last).rev()) {
            self.stages[k].advance(&mut self.state)?;
        }
        Ok(())
    }
}
