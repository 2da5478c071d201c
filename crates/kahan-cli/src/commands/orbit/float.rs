//! Orbits in rounded numbers: Kahan's map, or a composition of it. The map is prepared once for all
//! first points.

use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::interpret::UndefinedField;
use kahan_algebra::rational::Rational;
use kahan_core::{Composition, Scheme};
use kahan_runtime::orbit::{End, SchemeOrbit};
use kahan_runtime::{Field, Map};

use crate::numbers::Rounded;
use crate::printing::{Broken, Table};
use crate::reading::Request;

/// A map in rounded numbers.
pub(super) struct FloatMap<'a, A: Arithmetic> {
    arithmetic: &'a A,
    request: &'a Request,
    field: Field,
    map: Map,
    scheme: Scheme,
    time_step: A::Value,
}

/// An orbit in rounded numbers.
pub(super) struct FloatOrbit<'a, A: Arithmetic> {
    map: &'a FloatMap<'a, A>,
    orbit: SchemeOrbit,
}

impl<'a, A: Rounded> FloatMap<'a, A> {
    /// The map, or its composition for this order (2, 4, 6 or 8).
    pub(super) fn new(
        arithmetic: &'a A,
        request: &'a Request,
        order: u32,
        parameters: &[A::Value],
        eps: &A::Value,
    ) -> Result<Self, UndefinedField> {
        let composition = Composition::of_order(order).expect("orders are 2, 4, 6 and 8");
        let scheme = Scheme::of(A::PRECISION).composed(composition);
        let field = Field::of(&request.system);
        // What differs exactly may be one number in the scalar.
        if !field.derived().is_defined_at(arithmetic, parameters) {
            return Err(UndefinedField);
        }
        let values = field.parameters().iter().zip(&request.point.parameters);
        let map = field.with(values).map_err(|_| UndefinedField)?;
        let time_step = arithmetic.add(eps, eps);
        Ok(Self { arithmetic, request, field, map, scheme, time_step })
    }

    /// The orbit at its first point.
    pub(super) fn orbit(&'a self, start: &[Rational]) -> FloatOrbit<'a, A> {
        let orbit = self.map.orbit(self.scheme, &self.request.point.eps, start);
        FloatOrbit { map: self, orbit: orbit.expect("the point has been read for this field") }
    }

    /// The names of the integrals, in order.
    pub(super) fn integral_names(&self) -> &[String] {
        self.field.integrals()
    }
}

impl<A: Rounded> FloatOrbit<'_, A> {
    /// How it runs, in words.
    pub(super) fn runs_as(&self) -> &'static str {
        if self.orbit.is_code() { "machine code" } else { "interpreted" }
    }

    /// Writes the point n as a row.
    pub(super) fn write(&mut self, table: &mut Table, n: i64) -> Result<(), Broken> {
        let FloatMap { arithmetic, time_step, .. } = self.map;
        let number = arithmetic.constant(&Rational::from(n));
        let time = number.map(|n| arithmetic.multiply(&n, time_step));
        let integrals = self.orbit.integrals();
        let values: Vec<A::Value> =
            self.orbit.point().iter().chain(&integrals).map(|x| A::narrow(*x)).collect();
        table.row::<A>(n, std::iter::once(time.as_ref()).chain(values.iter().map(Some)))
    }

    /// Goes from the point n to the one so many steps later; what to tell the user where there is
    /// none.
    pub(super) fn advance(&mut self, n: i64, steps: i64) -> Result<(), String> {
        self.orbit.advance_while_finite(steps.unsigned_abs()).map_err(|end| self.why(n, end))
    }

    /// Why the orbit ends so many steps after the point n.
    fn why(&self, n: i64, End { steps, is_pole }: End) -> String {
        let n = n.saturating_add_unsigned(steps);
        let last: Vec<A::Value> = self.orbit.point().iter().map(|x| A::narrow(*x)).collect();
        let FloatMap { request, field, scheme, .. } = self.map;
        match (is_pole, scheme.composition.stages() > 1) {
            (true, true) => request.stage_pole::<A>(n, &last),
            (true, false) => request.pole::<A>(n, &last, field.derived().map.is_some()),
            (false, _) => request.overflow::<A>(n, &last),
        }
    }
}
