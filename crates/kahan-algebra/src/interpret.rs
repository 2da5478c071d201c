//! Every object of Kahan's method at a point, at run time, in any arithmetic: the second back end.
//!
//! Exact arithmetic gives exact answers and says where something has no value; floats give what
//! floats give.

mod map;

use kahan_syntax::rational::Rational;

use crate::arithmetic::{Arithmetic, determinant};
use crate::derived::{Derived, derive};
use crate::plan::Plan;
use crate::poly::Variable;
use crate::symbols::Symbol;
use crate::system::{System, upper_index};

/// A system made ready for evaluation.
#[derive(Clone, Debug)]
pub struct Interpreter {
    derived: Derived,
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
    /// The unconditional drifts: F(x), and F(x̃) by the recurrence.
    pub drifts: Vec<(String, Option<Vec<V>>)>,
}

/// A parameter value at which the field itself divides by zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UndefinedField;

impl Interpreter {
    /// Derives and plans everything once.
    #[must_use]
    pub fn new(system: &System) -> Self {
        Interpreter { derived: derive(system) }
    }

    /// Everything at one point.
    ///
    /// # Errors
    /// Where a parameter makes the field divide by zero.
    pub fn evaluate<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Result<Evaluation<A::Value>, UndefinedField> {
        let derived = &self.derived;
        if !derived.is_defined_at(arithmetic, &point.parameters, &point.eps) {
            return Err(UndefinedField);
        }
        let vector = |plan: &Plan| self.run(arithmetic, plan, point, None).ok_or(UndefinedField);
        let rows = |entries: Vec<A::Value>| -> Vec<Vec<A::Value>> {
            entries.chunks(point.state.len()).map(<[A::Value]>::to_vec).collect()
        };
        let matrix = rows(vector(derived.matrix())?);
        let det_matrix = match &derived.det_matrix {
            Some(plan) => vector(plan)?.pop(),
            None => determinant(arithmetic, &matrix),
        };
        let next = self.next(arithmetic, point);
        let jacobian = next.as_ref().and_then(|next| self.jacobian(arithmetic, point, next));
        let det_jacobian = jacobian.as_ref().and_then(|jacobian| determinant(arithmetic, jacobian));
        let integrals = self.run_partly(arithmetic, &derived.integrals, point, None);
        let drifts = derived.drifts.iter();
        let drifts = drifts.map(|(name, plan)| (name.clone(), self.run(arithmetic, plan, point, None)));
        Ok(Evaluation {
            field: vector(derived.at_eps_zero().field())?,
            field_jacobian: rows(vector(derived.at_eps_zero().field_jacobian())?),
            matrix,
            rhs: vector(derived.rhs())?,
            det_matrix: det_matrix.ok_or(UndefinedField)?,
            next,
            jacobian,
            det_jacobian,
            integrals: derived.integral_names.iter().cloned().zip(integrals).collect(),
            density: derived.density.as_ref().map(|plan| self.run(arithmetic, plan, point, None)?.pop()),
            brackets: self.brackets(arithmetic, point),
            drifts: drifts.collect(),
        })
    }

    /// Q(x, y).
    pub fn bilinear<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        x: &Point<A::Value>,
        y: &[A::Value],
    ) -> Option<Vec<A::Value>> {
        self.run(arithmetic, self.derived.at_eps_zero().bilinear(), x, Some(y))
    }

    /// Q(x,y) + ½B(x+y) + c.
    pub fn polarized<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        x: &Point<A::Value>,
        y: &[A::Value],
    ) -> Option<Vec<A::Value>> {
        self.run(arithmetic, self.derived.at_eps_zero().polarized(), x, Some(y))
    }

    /// A(x,ε), row by row.
    fn matrix<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Option<Vec<Vec<A::Value>>> {
        let entries = self.run(arithmetic, self.derived.matrix(), point, None)?;
        Some(entries.chunks(point.state.len()).map(<[A::Value]>::to_vec).collect())
    }

    /// The results of a plan, if all have a value.
    fn run<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        plan: &Plan,
        point: &Point<A::Value>,
        second: Option<&[A::Value]>,
    ) -> Option<Vec<A::Value>> {
        self.run_partly(arithmetic, plan, point, second).into_iter().collect()
    }

    fn run_partly<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        plan: &Plan,
        point: &Point<A::Value>,
        second: Option<&[A::Value]>,
    ) -> Vec<Option<A::Value>> {
        plan.evaluate(arithmetic, |input| Some(self.value_of(input.variable()?, point, second)))
    }

    fn value_of<V: Clone>(&self, variable: Variable, point: &Point<V>, second: Option<&[V]>) -> V {
        match self.derived.system.field.symbols.symbol(variable) {
            Symbol::State(i) => point.state[i].clone(),
            Symbol::Parameter(k) => point.parameters[k].clone(),
            Symbol::Epsilon => point.eps.clone(),
            Symbol::SecondState(i) => second.unwrap_or(&point.state)[i].clone(),
        }
    }

    fn brackets<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Vec<NamedTensor<A::Value>> {
        let n = point.state.len();
        let full = |upper: &[A::Value]| -> Option<Vec<Vec<A::Value>>> {
            let zero = arithmetic.constant(&Rational::zero())?;
            let entry = |i: usize, j: usize| match i.cmp(&j) {
                std::cmp::Ordering::Less => upper[upper_index(n, i, j)].clone(),
                std::cmp::Ordering::Equal => zero.clone(),
                std::cmp::Ordering::Greater => arithmetic.negate(&upper[upper_index(n, j, i)]),
            };
            Some((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect())
        };
        let named = self.derived.brackets.iter().map(|(name, plan)| {
            let upper = self.run(arithmetic, plan, point, None);
            (name.clone(), upper.and_then(|upper| full(&upper)))
        });
        named.collect()
    }
}
