//! Every object of Kahan's method at a point, at run time, in any arithmetic: the second back end.
//!
//! Exact arithmetic gives exact answers and says where something has no value; floats give what floats give.

mod map;
mod program;
mod stepper;

pub use stepper::{Pole, Stepper};

use crate::arithmetic::{Arithmetic, determinant};
use crate::kahan::{bilinear_form, field_jacobian, polarization, scaled_matrix, scaled_rhs};
use crate::plan::{Plan, StepPlan};
use crate::poly::Variable;
use crate::symbols::Symbol;
use crate::syntax::ClaimKind;
use crate::system::{System, upper_index};

/// A system made ready for evaluation.
#[derive(Clone, Debug)]
pub struct Interpreter<'a> {
    system: &'a System,
    /// The qᵢ.
    denominators: Plan,
    field: Plan,
    field_jacobian: Plan,
    matrix: Plan,
    rhs: Plan,
    bilinear: Plan,
    polarized: Plan,
    /// The step in straight lines, within the budget.
    step: Option<StepPlan>,
}

/// Where to evaluate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point<V> {
    /// The states x.
    pub state: Vec<V>,
    /// The parameters, in order.
    pub parameters: Vec<V>,
    /// ε, half the time step.
    pub eps: V,
}

/// A bracket's name and its n×n matrix, where it has a value.
pub type NamedTensor<V> = (String, Option<Vec<Vec<V>>>);

/// All objects at a point. `None` where something has no value there.
#[derive(Clone, Debug)]
pub struct Evaluation<V> {
    /// f(x)
    pub field: Vec<V>,
    /// f′(x), row by row.
    pub field_jacobian: Vec<Vec<V>>,
    /// A(x,ε)
    pub matrix: Vec<Vec<V>>,
    /// b(x,ε)
    pub rhs: Vec<V>,
    /// det A(x,ε)
    pub det_matrix: V,
    /// x̃ of the reduced map.
    pub next: Option<Vec<V>>,
    /// ∂x̃/∂x of the reduced map.
    pub jacobian: Option<Vec<Vec<V>>>,
    /// det ∂x̃/∂x
    pub det_jacobian: Option<V>,
    /// The unconditional integrals.
    pub integrals: Vec<(String, Option<V>)>,
    /// The unconditional density; the outer `None` where none is declared.
    pub density: Option<Option<V>>,
    /// The unconditional brackets as n×n matrices.
    pub brackets: Vec<NamedTensor<V>>,
}

/// A parameter value at which the field itself divides by zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UndefinedField;

impl<'a> Interpreter<'a> {
    /// Derives and plans everything once.
    #[must_use]
    pub fn new(system: &'a System) -> Self {
        let field = &system.field;
        Interpreter {
            system,
            denominators: Plan::of(field.components.iter().map(|component| &component.denominator)),
            field: Plan::of(field.components.iter().map(|component| &component.numerator)),
            field_jacobian: Plan::of(field_jacobian(field).iter().flatten()),
            matrix: Plan::of(scaled_matrix(field).iter().flatten()),
            rhs: Plan::of(scaled_rhs(field).iter()),
            bilinear: Plan::of(bilinear_form(field).iter()),
            polarized: Plan::of(polarization(field).iter()),
            step: StepPlan::of(field),
        }
    }

    /// Everything at one point.
    ///
    /// # Errors
    /// Where a parameter makes the field divide by zero.
    pub fn evaluate<A: Arithmetic>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Result<Evaluation<A::Value>, UndefinedField> {
        let n = self.system.field.dimension();
        let divisors = self.divisors(arithmetic, point)?;
        let over_divisors = |values: Vec<A::Value>, width: usize| -> Option<Vec<A::Value>> {
            let quotients = values
                .iter()
                .enumerate()
                .map(|(index, value)| arithmetic.divide(value, &divisors[index / width]));
            quotients.collect()
        };
        let vector = |plan: &Plan, width: usize| {
            self.run(arithmetic, plan, point, None)
                .and_then(|values| over_divisors(values, width))
                .ok_or(UndefinedField)
        };
        let rows = |entries: Vec<A::Value>| entries.chunks(n).map(<[A::Value]>::to_vec).collect::<Vec<_>>();
        let matrix = rows(vector(&self.matrix, n)?);
        let next = self.next(arithmetic, point);
        let jacobian = next.as_ref().and_then(|next| self.jacobian(arithmetic, point, next));
        let det_jacobian = jacobian.as_ref().and_then(|jacobian| determinant(arithmetic, jacobian));
        Ok(Evaluation {
            field: vector(&self.field, 1)?,
            field_jacobian: rows(vector(&self.field_jacobian, n)?),
            det_matrix: determinant(arithmetic, &matrix).ok_or(UndefinedField)?,
            matrix,
            rhs: vector(&self.rhs, 1)?,
            next,
            jacobian,
            det_jacobian,
            integrals: self.functions(arithmetic, point, ClaimKind::Integral),
            density: self.functions(arithmetic, point, ClaimKind::Density).pop().map(|(_, value)| value),
            brackets: self.brackets(arithmetic, point),
        })
    }

    /// Q(x, y).
    pub fn bilinear<A: Arithmetic>(
        &self,
        arithmetic: &A,
        x: &Point<A::Value>,
        y: &[A::Value],
    ) -> Option<Vec<A::Value>> {
        self.form(arithmetic, &self.bilinear, x, y)
    }

    /// Q(x,y) + ½B(x+y) + c.
    pub fn polarized<A: Arithmetic>(
        &self,
        arithmetic: &A,
        x: &Point<A::Value>,
        y: &[A::Value],
    ) -> Option<Vec<A::Value>> {
        self.form(arithmetic, &self.polarized, x, y)
    }

    fn scaled_matrix<A: Arithmetic>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Option<Vec<Vec<A::Value>>> {
        let entries = self.run(arithmetic, &self.matrix, point, None)?;
        Some(entries.chunks(point.state.len()).map(<[A::Value]>::to_vec).collect())
    }

    fn divisors<A: Arithmetic>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Result<Vec<A::Value>, UndefinedField> {
        let values = self.run(arithmetic, &self.denominators, point, None).ok_or(UndefinedField)?;
        if values.iter().any(|value| arithmetic.is_zero(value)) { Err(UndefinedField) } else { Ok(values) }
    }

    fn form<A: Arithmetic>(
        &self,
        arithmetic: &A,
        plan: &Plan,
        x: &Point<A::Value>,
        y: &[A::Value],
    ) -> Option<Vec<A::Value>> {
        let divisors = self.divisors(arithmetic, x).ok()?;
        let values = self.run(arithmetic, plan, x, Some(y))?;
        values.iter().zip(&divisors).map(|(value, divisor)| arithmetic.divide(value, divisor)).collect()
    }

    /// The results of a plan, if all have a value.
    fn run<A: Arithmetic>(
        &self,
        arithmetic: &A,
        plan: &Plan,
        point: &Point<A::Value>,
        second: Option<&[A::Value]>,
    ) -> Option<Vec<A::Value>> {
        self.run_partly(arithmetic, plan, point, second).into_iter().collect()
    }

    fn run_partly<A: Arithmetic>(
        &self,
        arithmetic: &A,
        plan: &Plan,
        point: &Point<A::Value>,
        second: Option<&[A::Value]>,
    ) -> Vec<Option<A::Value>> {
        plan.evaluate(arithmetic, |variable| self.value_of(variable, point, second))
    }

    fn value_of<V: Clone>(&self, variable: Variable, point: &Point<V>, second: Option<&[V]>) -> V {
        match self.system.field.symbols.symbol(variable) {
            Symbol::State(i) => point.state[i].clone(),
            Symbol::Parameter(k) => point.parameters[k].clone(),
            Symbol::Epsilon => point.eps.clone(),
            Symbol::SecondState(i) => second.unwrap_or(&point.state)[i].clone(),
        }
    }

    fn functions<A: Arithmetic>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
        kind: ClaimKind,
    ) -> Vec<(String, Option<A::Value>)> {
        let value = |plan: &Plan| self.run_partly(arithmetic, plan, point, None).pop().flatten();
        self.system.accessors(kind).map(|claim| (claim.name.text.clone(), value(&claim.plan))).collect()
    }

    fn brackets<A: Arithmetic>(&self, arithmetic: &A, point: &Point<A::Value>) -> Vec<NamedTensor<A::Value>> {
        let n = point.state.len();
        let full = |upper: &[A::Value]| -> Option<Vec<Vec<A::Value>>> {
            let zero = arithmetic.constant(&crate::rational::Rational::zero())?;
            let entry = |i: usize, j: usize| match i.cmp(&j) {
                std::cmp::Ordering::Less => upper[upper_index(n, i, j)].clone(),
                std::cmp::Ordering::Equal => zero.clone(),
                std::cmp::Ordering::Greater => arithmetic.negate(&upper[upper_index(n, j, i)]),
            };
            Some((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect())
        };
        self.system
            .accessors(ClaimKind::Bracket)
            .map(|claim| {
                let upper = self.run(arithmetic, &claim.plan, point, None);
                (claim.name.text.clone(), upper.and_then(|upper| full(&upper)))
            })
            .collect()
    }
}
