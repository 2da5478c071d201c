//! Methods for comparison with Kahan's map: explicit methods, and the flow itself.

use kahan_algebra::derived::Derived;
use kahan_algebra::plan::Plan;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;
use kahan_core::nalgebra::{SMatrix, SVector};
use kahan_core::{Dd, QuadraticField};
use kahan_dynamics::Flow;
use kahan_runtime::Map;
use kahan_runtime::interpreted::{LARGEST_DIMENSION, Padded};

use crate::count::WorkCount;
use crate::error::StudyError;
use crate::numbers::{DoubleDouble, Number, Printable, ScalarKind};

use super::maps::PointArithmetic;
use super::points::{EarlyEnd, EndReason, OrbitPoints, one_by_one, rows_in_milliseconds};
use super::{Method, NoOrbit};

struct ExplicitOrbit<'a, A: PointArithmetic> {
    arithmetic: &'a A,
    derived: &'a Derived,
    method: Method,
    parameters: Vec<A::Value>,
    eps: A::Value,
    x: Vec<A::Value>,
}

pub(super) fn explicit<'a, A: PointArithmetic>(
    arithmetic: &'a A,
    map: &'a Map,
    method: Method,
    parameters: Vec<A::Value>,
    eps: &Rational,
    start: &[Rational],
) -> Box<dyn OrbitPoints<A> + 'a> {
    let x = start.iter().map(A::round).collect();
    let derived = map.field().derived();
    Box::new(ExplicitOrbit { arithmetic, derived, method, parameters, eps: A::round(eps), x })
}

impl<A: PointArithmetic> ExplicitOrbit<'_, A> {
    /// Evaluates a list of formulas, a plan, at a point with ε = 0.
    fn values(&self, plan: &Plan, x: &[A::Value]) -> Vec<Option<A::Value>> {
        let symbols = &self.derived.system.field.symbols;
        plan.evaluate(self.arithmetic, |input| match symbols.symbol(input.variable()?) {
            Symbol::State(i) | Symbol::SecondState(i) => Some(x[i].clone()),
            Symbol::Parameter(k) => Some(self.parameters[k].clone()),
            Symbol::Epsilon => Some(A::round(&Rational::zero())),
        })
    }

    fn field(&self, x: &[A::Value]) -> Vec<A::Value> {
        let values = self.values(self.derived.field(), x).into_iter();
        values.map(|value| value.expect("the field is defined at its parameters")).collect()
    }

    fn moved(&self, h: &A::Value, k: &[A::Value]) -> Vec<A::Value> {
        let arithmetic = self.arithmetic;
        let entry = |(x, k)| arithmetic.add(x, &arithmetic.multiply(h, k));
        self.x.iter().zip(k).map(entry).collect()
    }

    /// Returns the point after a time step h = 2ε.
    fn next(&self) -> Vec<A::Value> {
        let arithmetic = self.arithmetic;
        let (half, h) = (&self.eps, arithmetic.add(&self.eps, &self.eps));
        let first = self.field(&self.x);
        if self.method == Method::Euler {
            return self.moved(&h, &first);
        }
        let second = self.field(&self.moved(half, &first));
        let third = self.field(&self.moved(half, &second));
        let fourth = self.field(&self.moved(&h, &third));
        // In the Runge–Kutta method the mean slope is (k₁ + 2k₂ + 2k₃ + k₄)/6.
        let sixth = A::round(&Rational::new(1, 6));
        let mean = |i: usize| {
            let inner = arithmetic.add(&second[i], &third[i]);
            let outer = arithmetic.add(&first[i], &fourth[i]);
            arithmetic.multiply(&sixth, &arithmetic.add(&outer, &arithmetic.add(&inner, &inner)))
        };
        self.moved(&h, &(0..first.len()).map(mean).collect::<Vec<_>>())
    }
}

impl<A: PointArithmetic> OrbitPoints<A> for ExplicitOrbit<'_, A> {
    fn row(&mut self, cells: &mut Vec<A::Cell>) {
        cells.extend(self.x.iter().map(A::cell));
        let integrals = self.values(&self.derived.integrals, &self.x).into_iter();
        cells.extend(integrals.map(A::cell_of));
    }

    fn advance(&mut self, steps: u64, progress: &WorkCount<'_>) -> Result<(), EarlyEnd> {
        one_by_one(steps, progress, || {
            let next = self.next();
            if !next.iter().all(A::is_finite) {
                return Err(EndReason::TooLarge);
            }
            self.x = next;
            Ok(())
        })
    }

    fn at_once(&self, every: u64) -> usize {
        // Exact numbers at least double their digits in each step, so each block is a single row.
        if A::KIND == ScalarKind::Exact { 1 } else { rows_in_milliseconds(self.x.len(), every) }
    }

    fn point(&self) -> Vec<Number> {
        self.x.iter().map(A::number).collect()
    }
}

/// The field f, or −f for a negative ε.
struct SignedField {
    map: Padded<Dd>,
    sign: Dd,
}

type Point = SVector<Dd, LARGEST_DIMENSION>;
type Square = SMatrix<Dd, LARGEST_DIMENSION, LARGEST_DIMENSION>;

impl QuadraticField<Dd, LARGEST_DIMENSION> for SignedField {
    fn field(&self, x: &Point) -> Point {
        self.map.field(x) * self.sign
    }

    fn field_jacobian(&self, x: &Point) -> Square {
        self.map.field_jacobian(x) * self.sign
    }

    fn bilinear(&self, x: &Point, y: &Point) -> Point {
        self.map.bilinear(x, y) * self.sign
    }

    fn polarized(&self, x: &Point, y: &Point) -> Point {
        self.map.polarized(x, y) * self.sign
    }
}

struct FlowSolution {
    field: SignedField,
    /// The time step |2ε|.
    step: Dd,
    x: Point,
}

/// Prepares the flow from its first point, at times 2ε apart.
pub(super) fn flow<A: PointArithmetic>(
    map: &Map,
    eps: &Rational,
    start: &[Rational],
) -> Result<Box<dyn OrbitPoints<A>>, StudyError> {
    let padded = map.as_padded_kahan_map::<Dd>();
    let map = padded.map_err(|why| StudyError::Orbit(NoOrbit::Flow(why)))?;
    let sign = Dd::from(if eps.is_negative() { -1.0 } else { 1.0 });
    let eps = DoubleDouble::round(eps);
    let x = Point::from_fn(|i, _| start.get(i).map_or_else(Dd::default, DoubleDouble::round));
    Ok(Box::new(FlowSolution { field: SignedField { map, sign }, step: eps * sign * Dd::from(2.0), x }))
}

impl FlowSolution {
    /// Advances by `steps` steps, and calls `see` at each point.
    fn walk<A: PointArithmetic>(
        &mut self,
        steps: u64,
        progress: &WorkCount<'_>,
        mut see: impl FnMut(&Self, u64),
    ) -> Result<(), EarlyEnd> {
        /// The most Taylor series computed at once; each takes some kilobytes.
        const MOST_SERIES: usize = 1 << 16;

        let (mut made, mut span) = (0, 1 << 10);
        while made < steps {
            span = span.min(steps - made);
            let end = self.step * Dd::from(span as f64);
            let go_on = &mut |series| series < MOST_SERIES && progress.tell(0).is_continue();
            match Flow::through(&self.field, self.x, f64::from(end), 0.0, go_on) {
                Ok(flow) => {
                    for step in 1..=span {
                        let x = flow.at(self.step * Dd::from(step as f64));
                        if !x.iter().all(|x| A::narrow(*x).is_some_and(|x| A::is_finite(&x))) {
                            return Err(EarlyEnd::Ended(made, EndReason::Escapes));
                        }
                        self.x.copy_from_slice(&x);
                        made += 1;
                        see(self, made);
                    }
                    if progress.tell(span).is_break() && made < steps {
                        return Err(EarlyEnd::Stopped(made));
                    }
                }
                Err(_) if progress.is_stopped() => return Err(EarlyEnd::Stopped(made)),
                Err(_) if span > 1 => span /= 2,
                Err(_) => return Err(EarlyEnd::Ended(made, EndReason::Escapes)),
            }
        }
        Ok(())
    }

    fn append<A: PointArithmetic>(&self, cells: &mut Vec<A::Cell>) {
        let coordinates = self.x.iter().take(self.field.map.variables().len()).copied().map(Some);
        let integrals = self.field.map.integrals(&self.x, &Dd::default());
        cells.extend(coordinates.chain(integrals).map(|number| A::cell_of(number.and_then(A::narrow))));
    }
}

impl<A: PointArithmetic> OrbitPoints<A> for FlowSolution {
    fn row(&mut self, cells: &mut Vec<A::Cell>) {
        self.append::<A>(cells);
    }

    fn advance(&mut self, steps: u64, progress: &WorkCount<'_>) -> Result<(), EarlyEnd> {
        self.walk::<A>(steps, progress, |_, _| {})
    }

    fn rows(
        &mut self,
        every: u64,
        count: usize,
        cells: &mut Vec<A::Cell>,
        progress: &WorkCount<'_>,
    ) -> Result<(), EarlyEnd> {
        self.walk::<A>(every * count as u64, progress, |solution, made| {
            if made.is_multiple_of(every) {
                solution.append::<A>(cells);
            }
        })
    }

    fn at_once(&self, every: u64) -> usize {
        rows_in_milliseconds(self.field.map.variables().len(), every)
    }

    fn point(&self) -> Vec<Number> {
        let variables = self.field.map.variables().len();
        let numbers = self.x.iter().take(variables).filter_map(|x| A::narrow(*x));
        numbers.map(|number| A::number(&number)).collect()
    }
}
