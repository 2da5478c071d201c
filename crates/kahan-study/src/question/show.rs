//! The formulas of a field in several notations, or the costs of its code.

mod plan;

use kahan_algebra::kahan::RationalMap;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{
    Formulas, MatrixText, Notation, Text, claim_statement, claim_text, condition_note, condition_statement,
    condition_text, macro_block,
};
use kahan_algebra::syntax::ClaimBody;
use kahan_algebra::system::{Claim, System};
use kahan_discover::Watch;
use kahan_latex::Latex;
use serde::{Deserialize, Serialize};

use crate::error::StudyError;
use crate::study::Study;
use crate::sympy::{self, SymPy};

pub use plan::{FunctionCost, Listing, ShownPlans};

/// The most variables of a field whose matrices are written out.
const MOST_VARIABLES: usize = 500;

/// A request for the formulas of a field, with the given parameter values substituted, or for the
/// costs of its generated code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Show {
    /// The form of the answer.
    #[serde(rename = "as", default)]
    pub form: ShowForm,
    /// Whether to include the Jacobian of the map, which may be a long text.
    #[serde(default)]
    pub jacobian: bool,
}

/// The form in which a field is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ShowForm {
    /// Formulas in the language of `kahan!`.
    #[default]
    Text,
    /// Formulas in LaTeX.
    Latex,
    /// Formulas for Python's [`SymPy`].
    Sympy,
    /// Only the block of `kahan!`, ready to paste.
    Kahan,
    /// The operations of the generated code, and their costs.
    Plan,
}

/// A field in one of the forms.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum ShownField {
    /// All formulas.
    Formulas(Box<FormulaSheet>),
    /// The block of `kahan!`.
    Block {
        /// The name of the system.
        system: String,
        /// The block.
        #[serde(rename = "macro")]
        block: String,
    },
    /// The operations of the generated code.
    Plan(Box<ShownPlans>),
}

/// The formulas of a field; `None` (null in JSON) for a formula with too many terms.
#[derive(Clone, Debug, Serialize)]
pub struct FormulaSheet {
    /// The name of the system.
    pub system: String,
    /// The description in the catalog.
    pub title: Option<&'static str>,
    /// The state variables.
    pub variables: Vec<String>,
    /// The parameters without values.
    pub parameters: Vec<String>,
    /// The field as a function of x and ε; `None` if ε does not occur in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field_at_eps: Option<Vec<String>>,
    /// The field f(x) from which f′ and Q are derived. If it depends on ε, this is f at ε = 0.
    pub field: Vec<String>,
    /// The Jacobian f′(x), row by row.
    pub field_jacobian: MatrixText,
    /// The matrix A(x,ε), row by row. The image x̃ solves A(x,ε) x̃ = b(x,ε).
    #[serde(rename = "A")]
    pub matrix: MatrixText,
    /// The right-hand side b(x,ε).
    #[serde(rename = "b")]
    pub rhs: Vec<String>,
    /// The bilinear form Q(x,x′); variables of the second point have primes.
    pub bilinear: Vec<String>,
    /// The determinant of A(x,ε).
    #[serde(rename = "det_A")]
    pub determinant: Option<String>,
    /// The reduced map x̃ = x + 2ε n/d, with n/d in lowest terms.
    pub map: Option<Vec<String>>,
    /// The Jacobian ∂x̃/∂x of the map, row by row, if requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jacobian: Option<MatrixText>,
    /// The factor divided out of the map, if any.
    pub removed_factor: Option<String>,
    /// The proved claims.
    pub claims: Vec<ClaimShown>,
    /// The block of `kahan!`.
    #[serde(rename = "macro")]
    pub block: String,
    /// A Python script that defines the symbols, matrices and claims of this answer; only for
    /// [`ShowForm::Sympy`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub script: Option<String>,
}

/// A claim with its formulas.
#[derive(Clone, Debug, Serialize)]
pub struct ClaimShown {
    /// The name.
    pub name: String,
    /// `integral`, `density`, `bracket` or `drift`.
    pub kind: &'static str,
    /// The claim in the language of `kahan!`, ready to paste.
    pub statement: String,
    /// The condition of the claim, in the language of `kahan!`; empty if it always holds.
    pub when: String,
    /// The divisors that must not vanish, such as `a2 != 0`; empty if all divisors are numbers.
    pub nonzero: String,
    /// The source that the catalog cites for the claim.
    pub source: Option<&'static str>,
    /// The claimed equations, each as left and right side. A drift has two equations: one for its
    /// function F(x), and one for F(x̃).
    pub equations: Vec<(String, String)>,
    /// The two variables whose bracket each equation gives; empty for other claims.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pairs: Vec<[String; 2]>,
    /// The condition in the notation of the sheet.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub condition: String,
}

impl Show {
    /// Derives the formulas of a system whose claims hold. Takes milliseconds to a second. Given
    /// parameters are substituted before the map is reduced.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, a field that is undefined at its parameters, or a
    /// field of more than 500 variables, which can only be shown as a block.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<ShownField, StudyError> {
        study.proved()?;
        let variables = study.variables().len();
        if variables > MOST_VARIABLES && self.form != ShowForm::Kahan {
            return Err(StudyError::LargeMatrices { variables, most: MOST_VARIABLES });
        }
        let mut system = study.specialised()?;
        let block = macro_block(&system);
        let notation: &dyn Notation = match self.form {
            ShowForm::Text => &Text,
            ShowForm::Latex => &Latex,
            ShowForm::Sympy => &SymPy,
            ShowForm::Kahan => {
                return Ok(ShownField::Block { system: study.name().to_owned(), block });
            }
            ShowForm::Plan => {
                return Ok(ShownField::Plan(Box::new(ShownPlans::of(study.name(), &system, watch))));
            }
        };
        system.claims.iter_mut().for_each(|claim| claim.put_values(&system.constants));
        let map = RationalMap::of(&system.field);
        let formulas = Formulas { field: &system.field, map: map.as_ref(), notation };
        let at_zero = system.field.depends_on_eps().then(|| system.at_eps(&Rational::ZERO)).flatten();
        let flow = at_zero.as_ref().map_or(&system.field, |at_zero| &at_zero.field);
        let of_flow = Formulas { field: flow, map: None, notation };
        let claims = system.claims.iter().map(|claim| ClaimShown {
            source: study.source(&claim.name.text),
            ..ClaimShown::of(&system, claim, notation)
        });
        let mut sheet = FormulaSheet {
            system: study.name().to_owned(),
            title: study.title(),
            variables: system.field.symbols.states.clone(),
            parameters: system.field.symbols.parameters.clone(),
            field_at_eps: at_zero.is_some().then(|| formulas.field()),
            field: of_flow.field(),
            field_jacobian: of_flow.field_jacobian(),
            matrix: formulas.matrix(),
            rhs: formulas.rhs(),
            bilinear: of_flow.bilinear(),
            determinant: formulas.determinant(),
            map: formulas.map(),
            jacobian: if self.jacobian { formulas.jacobian() } else { None },
            removed_factor: formulas.removed_factor(),
            claims: claims.collect(),
            block,
            script: None,
        };
        sheet.script = (self.form == ShowForm::Sympy).then(|| sympy::script(&sheet));
        Ok(ShownField::Formulas(Box::new(sheet)))
    }
}

impl ClaimShown {
    /// Writes a claim of a system in a notation.
    #[must_use]
    pub fn of(system: &System, claim: &Claim, notation: &dyn Notation) -> Self {
        let pairs = match &claim.body {
            ClaimBody::Tensor(entries) => entries
                .iter()
                .map(|entry| [&entry.row, &entry.column].map(|name| name.text.clone()))
                .collect(),
            _ => Vec::new(),
        };
        ClaimShown {
            name: claim.name.text.clone(),
            kind: claim.kind.keyword(),
            statement: claim_text(system, claim),
            when: condition_text(system, claim),
            nonzero: condition_note(system, claim),
            source: None,
            equations: claim_statement(claim, notation),
            pairs,
            condition: condition_statement(system, claim, notation),
        }
    }
}
