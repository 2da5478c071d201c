//! Evaluates field, matrices, map and claims of a system at one point, exactly or in floats.

use kahan_algebra::arithmetic::{Exact, Float32, Float64};
use kahan_algebra::interpret::Point;
use kahan_algebra::rational::Rational;
use kahan_discover::{Unwatched, Watch};
use serde::{Deserialize, Serialize};

use crate::error::StudyError;
use crate::named::{Names, by_name};
use crate::numbers::{DoubleDouble, Number, Printable, ScalarKind, exact};
use crate::rows::{Column, StoredColumn};
use crate::study::{NoStep, Study};

use super::over::{AtCell, CellEntry, column};

/// A request for field, matrices, map, Jacobian and values of the claims at a point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Evaluate {
    /// ε, half the time step.
    #[serde(with = "exact")]
    pub eps: Rational,
    /// The point, with a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The scalar of the computation, by default exact.
    #[serde(default = "exactly")]
    pub scalar: ScalarKind,
}

fn exactly() -> ScalarKind {
    ScalarKind::Exact
}

/// The values at the point; `None`, and null in JSON, for an undefined value.
#[derive(Clone, Debug, Serialize)]
pub struct Evaluated {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The parameters.
    #[serde(serialize_with = "by_name")]
    pub parameters: Names<Number>,
    /// ε, half the time step.
    pub eps: Number,
    /// The point.
    pub x: Vec<Number>,
    /// The field f(x).
    pub field: Vec<Number>,
    /// The Jacobian f′(x), row by row.
    pub field_jacobian: Vec<Vec<Number>>,
    /// The matrix A(x,ε) of Kahan's equations A(x,ε) x̃ = b(x,ε), row by row.
    #[serde(rename = "A")]
    pub matrix: Vec<Vec<Number>>,
    /// The right-hand side b(x,ε) of Kahan's equations A(x,ε) x̃ = b(x,ε).
    #[serde(rename = "b")]
    pub rhs: Vec<Number>,
    /// The determinant det A(x,ε).
    #[serde(rename = "det_A")]
    pub det_matrix: Number,
    /// The image x̃ of the point under Kahan's map, whose formula is in lowest terms.
    pub x_next: Option<Vec<Number>>,
    /// The Jacobian ∂x̃/∂x at the point, row by row.
    pub jacobian: Option<Vec<Vec<Number>>>,
    /// The determinant of the Jacobian of the map.
    pub det_jacobian: Option<Number>,
    /// The integrals claimed without a condition, or with one that holds at the parameters and ε.
    #[serde(serialize_with = "by_name")]
    pub integrals: Names<Option<Number>>,
    /// The density, if a claim of a density applies.
    pub density: Option<Number>,
    /// The brackets of the claims that apply; the matrix of each bracket is given row by row.
    #[serde(serialize_with = "by_name")]
    pub brackets: Names<Option<Vec<Vec<Number>>>>,
    /// The claimed drifts that apply. A drift gives F(x̃) as a formula G(x), for a function F. The
    /// two values are F(x) and G(x).
    #[serde(serialize_with = "by_name")]
    pub drifts: Names<Option<Vec<Number>>>,
    /// The reason why the point has no image.
    #[serde(skip)]
    pub no_step: Option<NoStep>,
}

impl Evaluate {
    /// Asks for exact values at ε = `eps` and the point `at`.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>) -> Self {
        Evaluate { eps, at, scalar: exactly() }
    }

    /// Evaluates a system whose claims hold.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, missing values, or a field that is undefined at its
    /// parameters.
    pub fn ask(&self, study: &Study, _: &dyn Watch) -> Result<Evaluated, StudyError> {
        let study = study.at_step(&self.eps)?;
        match self.scalar {
            ScalarKind::Exact => self.over(&Exact, &study),
            ScalarKind::F64 => self.over(&Float64, &study),
            ScalarKind::F32 => self.over(&Float32, &study),
            ScalarKind::Dd => self.over(&DoubleDouble, &study),
        }
    }

    fn over<A: Printable>(&self, arithmetic: &A, study: &Study) -> Result<Evaluated, StudyError> {
        let round = |values: &[Rational]| values.iter().map(A::round).collect::<Vec<_>>();
        let point = Point {
            state: round(&study.point(&self.at)?),
            parameters: round(&study.values()?),
            eps: A::round(&self.eps),
        };
        let evaluated = study.interpreter().evaluate(arithmetic, &point);
        let values = evaluated.map_err(|_| study.undefined_field_at(&self.eps))?;
        let next = values.next.filter(|next| next.iter().all(A::is_finite));
        let has_next = next.is_some();
        let is_singular = arithmetic.is_zero(&values.det_matrix);

        let vector = |values: Vec<A::Value>| values.iter().map(A::number).collect::<Vec<_>>();
        let rows = |rows: Vec<Vec<A::Value>>| rows.into_iter().map(vector).collect::<Vec<_>>();
        let number = |value: &A::Value| A::number(value);
        Ok(Evaluated {
            system: study.name().to_owned(),
            variables: study.variables().to_vec(),
            parameters: study.parameters().iter().cloned().zip(vector(point.parameters)).collect(),
            eps: A::number(&point.eps),
            x: vector(point.state),
            field: vector(values.field),
            field_jacobian: rows(values.field_jacobian),
            matrix: rows(values.matrix),
            rhs: vector(values.rhs),
            det_matrix: A::number(&values.det_matrix),
            x_next: next.map(vector),
            jacobian: values.jacobian.filter(|_| has_next).map(rows),
            det_jacobian: values.det_jacobian.filter(|_| has_next).as_ref().map(number),
            integrals: values
                .integrals
                .into_iter()
                .map(|(name, value)| (name, value.as_ref().map(number)))
                .collect(),
            density: values.density.flatten().as_ref().map(number),
            brackets: values.brackets.into_iter().map(|(name, value)| (name, value.map(rows))).collect(),
            drifts: values.drifts.into_iter().map(|(name, value)| (name, value.map(vector))).collect(),
            no_step: (!has_next).then(|| if is_singular { study.pole() } else { NoStep::Range }),
        })
    }
}

impl AtCell for Evaluate {
    fn place(&self) -> (Option<&Rational>, Option<&[Rational]>) {
        (Some(&self.eps), Some(&self.at))
    }

    fn columns(&self, variables: &[String]) -> Vec<(Column, StoredColumn)> {
        let determinants = [
            column("det_A", "determinant of the matrix of the step", StoredColumn::F64),
            column("det_jacobian", "determinant of the Jacobian of the map", StoredColumn::F64),
        ];
        let next = |name: &String| column(&format!("next_{name}"), "value one step later", StoredColumn::F64);
        variables.iter().map(next).chain(determinants).collect()
    }

    fn entries(&self, eps: &Rational, at: &[Rational], study: &Study) -> Vec<CellEntry> {
        let asked = Evaluate { eps: eps.clone(), at: at.to_vec(), ..self.clone() };
        let number = |number: Option<&Number>| CellEntry::Float(number.map_or(f64::NAN, Number::to_f64));
        let variables = study.variables().len();
        match asked.ask(study, &Unwatched) {
            Ok(values) => {
                let next = |k: usize| number(values.x_next.as_ref().map(|next| &next[k]));
                let determinants = [number(Some(&values.det_matrix)), number(values.det_jacobian.as_ref())];
                (0..variables).map(next).chain(determinants).collect()
            }
            Err(_) => vec![number(None); variables + 2],
        }
    }
}
