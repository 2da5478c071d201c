//! Evaluates the objects of Kahan's method at a point, in any arithmetic. In exact arithmetic,
//! undefined values are `None`, and an undefined field is an error.

mod map;

use kahan_syntax::rational::Rational;

use crate::arithmetic::{Arithmetic, OverRationals, determinant};
use crate::derived::{Derived, derive};
use crate::plan::Plan;
use crate::poly::Variable;
use crate::symbols::Symbol;
use crate::system::{System, upper_index};

/// A system with plans for evaluation.
#[derive(Clone, Debug)]
pub struct Interpreter {
    derived: Derived,
}

/// A point of evaluation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point<V> {
    /// The states x.
    pub state: Vec<V>,
    /// The parameters.
    pub parameters: Vec<V>,
    /// The parameter ε, which is half the time step.
    pub eps: V,
}

/// The name of a bracket and its n×n matrix. Undefined matrices are `None`.
pub type NamedTensor<V> = (String, Option<Vec<Vec<V>>>);

/// All objects of Kahan's method at a point. Undefined values are `None`.
#[derive(Clone, Debug)]
pub struct Evaluation<V> {
    /// The field f(x).
    pub field: Vec<V>,
    /// The Jacobian f′(x), row by row.
    pub field_jacobian: Vec<Vec<V>>,
    /// The matrix A(x,ε).
    pub matrix: Vec<Vec<V>>,
    /// The right-hand side b(x,ε).
    pub rhs: Vec<V>,
    /// The determinant det A(x,ε).
    pub det_matrix: V,
    /// The image x̃, or `None` at a pole of the reduced map.
    pub next: Option<Vec<V>>,
    /// The Jacobian ∂x̃/∂x of the reduced map.
    pub jacobian: Option<Vec<Vec<V>>>,
    /// The determinant of the Jacobian ∂x̃/∂x.
    pub det_jacobian: Option<V>,
    /// The unconditional integrals by name.
    pub integrals: Vec<(String, Option<V>)>,
    /// The unconditional density. The outer option is `None` if the system has no density.
    pub density: Option<Option<V>>,
    /// The unconditional brackets, as n×n matrices.
    pub brackets: Vec<NamedTensor<V>>,
    /// The unconditional drifts by name, each with F(x) and the claimed value G(F(x)) of F(x̃).
    pub drifts: Vec<(String, Option<Vec<V>>)>,
}

/// The error that the field divides by zero at the given parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UndefinedField;

impl Interpreter {
    /// Derives the plans of a system once for many points.
    #[must_use]
    pub fn new(system: &System) -> Self {
        Interpreter { derived: derive(system) }
    }

    fn at<'a, A: OverRationals>(&'a self, arithmetic: &'a A, point: &'a Point<A::Value>) -> Evaluator<'a, A> {
        Evaluator { derived: &self.derived, arithmetic, point }
    }

    /// Evaluates the field, the map and all other objects of [`Evaluation`] at one point.
    ///
    /// # Errors
    /// If the field divides by zero at the given parameters.
    pub fn evaluate<A: OverRationals>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Result<Evaluation<A::Value>, UndefinedField> {
        match self.derived.is_defined_at(arithmetic, &point.parameters, &point.eps) {
            true => self.at(arithmetic, point).evaluation().ok_or(UndefinedField),
            false => Err(UndefinedField),
        }
    }

    /// Returns the bilinear form Q(x, y).
    pub fn bilinear<A: OverRationals>(
        &self,
        arithmetic: &A,
        x: &Point<A::Value>,
        y: &[A::Value],
    ) -> Option<Vec<A::Value>> {
        self.at(arithmetic, x).run_with(self.derived.at_eps_zero().bilinear(), y)
    }

    /// Returns the polarised field Q(x,y) + ½B(x+y) + c.
    pub fn polarized<A: OverRationals>(
        &self,
        arithmetic: &A,
        x: &Point<A::Value>,
        y: &[A::Value],
    ) -> Option<Vec<A::Value>> {
        self.at(arithmetic, x).run_with(self.derived.at_eps_zero().polarized(), y)
    }

    /// Returns the image x̃ under the reduced map, or `None` at a pole (even for floats).
    pub fn next<A: OverRationals>(&self, arithmetic: &A, point: &Point<A::Value>) -> Option<Vec<A::Value>> {
        self.at(arithmetic, point).next()
    }

    /// Returns the Jacobian ∂x̃/∂x, where `next` is x̃. Dual numbers differentiate the reduced map.
    /// If there is no reduced map, the Jacobian is A(x,ε)⁻¹A(x̃,−ε).
    pub fn jacobian<A: OverRationals>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
        next: &[A::Value],
    ) -> Option<Vec<Vec<A::Value>>> {
        self.at(arithmetic, point).jacobian(next)
    }
}

struct Evaluator<'a, A: Arithmetic> {
    derived: &'a Derived,
    arithmetic: &'a A,
    point: &'a Point<A::Value>,
}

impl<A: OverRationals> Evaluator<'_, A> {
    fn evaluation(&self) -> Option<Evaluation<A::Value>> {
        let derived = self.derived;
        let matrix = self.matrix()?;
        let det_matrix = match &derived.det_matrix {
            Some(plan) => self.run(plan)?.pop(),
            None => determinant(self.arithmetic, &matrix),
        };
        let next = self.next();
        let jacobian = next.as_ref().and_then(|next| self.jacobian(next));
        let det_jacobian = jacobian.as_ref().and_then(|jacobian| determinant(self.arithmetic, jacobian));
        let integrals = self.run_partly(&derived.integrals, &self.point.state);
        let drifts = derived.drifts.iter().map(|(name, plan)| (name.clone(), self.run(plan)));
        let brackets = derived.brackets.iter();
        let brackets = brackets
            .map(|(name, plan)| (name.clone(), self.run(plan).and_then(|of| self.antisymmetric_matrix(&of))));
        Some(Evaluation {
            field: self.run(derived.at_eps_zero().field())?,
            field_jacobian: self.rows(derived.at_eps_zero().field_jacobian())?,
            matrix,
            rhs: self.run(derived.rhs())?,
            det_matrix: det_matrix?,
            next,
            jacobian,
            det_jacobian,
            integrals: derived.integral_names.iter().cloned().zip(integrals).collect(),
            density: derived.density.as_ref().map(|plan| self.run(plan)?.pop()),
            brackets: brackets.collect(),
            drifts: drifts.collect(),
        })
    }

    fn matrix(&self) -> Option<Vec<Vec<A::Value>>> {
        self.rows(self.derived.matrix())
    }

    fn rows(&self, plan: &Plan) -> Option<Vec<Vec<A::Value>>> {
        let entries = self.run(plan)?;
        Some(entries.chunks(self.point.state.len()).map(<[A::Value]>::to_vec).collect())
    }

    fn run(&self, plan: &Plan) -> Option<Vec<A::Value>> {
        self.run_with(plan, &self.point.state)
    }

    fn run_with(&self, plan: &Plan, second: &[A::Value]) -> Option<Vec<A::Value>> {
        self.run_partly(plan, second).into_iter().collect()
    }

    fn run_partly(&self, plan: &Plan, second: &[A::Value]) -> Vec<Option<A::Value>> {
        plan.evaluate(self.arithmetic, |input| Some(self.value_of(input.variable()?, second)))
    }

    fn value_of(&self, variable: Variable, second: &[A::Value]) -> A::Value {
        match self.derived.system.field.symbols.symbol(variable) {
            Symbol::State(i) => self.point.state[i].clone(),
            Symbol::Parameter(k) => self.point.parameters[k].clone(),
            Symbol::Epsilon => self.point.eps.clone(),
            Symbol::SecondState(i) => second[i].clone(),
        }
    }

    /// Returns an antisymmetric matrix from its entries above the diagonal, row by row.
    fn antisymmetric_matrix(&self, upper: &[A::Value]) -> Option<Vec<Vec<A::Value>>> {
        let n = self.point.state.len();
        let zero = self.arithmetic.constant(&Rational::zero())?;
        let entry = |i: usize, j: usize| match i.cmp(&j) {
            std::cmp::Ordering::Less => upper[upper_index(n, i, j)].clone(),
            std::cmp::Ordering::Equal => zero.clone(),
            std::cmp::Ordering::Greater => self.arithmetic.negate(&upper[upper_index(n, j, i)]),
        };
        Some((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect())
    }
}
