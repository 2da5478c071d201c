//! The formulas of a field, one by one, in the notation that is asked for; or what its code costs.

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

pub use plan::{Costs, Listing, Planned};

/// The most variables of a field whose matrices are written out.
const MOST_VARIABLES: usize = 500;

/// Asks for the formulas of a field, its given parameters put in, or for the plan of its code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Show {
    /// As what they are shown.
    #[serde(rename = "as", default)]
    pub form: Form,
    /// Whether the Jacobian of the map is among the formulas, which may be long.
    #[serde(default)]
    pub jacobian: bool,
}

/// As what a field is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// Formulas in the language of `kahan!`.
    #[default]
    Text,
    /// Formulas in LaTeX.
    Latex,
    /// Formulas for Python's [`SymPy`].
    Sympy,
    /// The block of `kahan!` alone, ready to paste.
    Kahan,
    /// What the generated code computes, and what that costs.
    Plan,
}

/// A field as it is shown.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Shown {
    /// All formulas.
    Formulas(Box<Sheet>),
    /// The block of `kahan!`.
    Block {
        /// The name of the system.
        system: String,
        /// The block.
        #[serde(rename = "macro")]
        block: String,
    },
    /// The plans of the code.
    Plan(Box<Planned>),
}

/// The formulas of a field, each as a text of its own. One that is beyond the budget of terms is
/// `None`, and null in JSON.
#[derive(Clone, Debug, Serialize)]
pub struct Sheet {
    /// The name of the system.
    pub system: String,
    /// What the catalog says it is, in one line.
    pub title: Option<&'static str>,
    /// The state variables.
    pub variables: Vec<String>,
    /// The parameters that are not put in.
    pub parameters: Vec<String>,
    /// f(x) with the coefficients that the map has at ε, where these depend on ε.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field_at_eps: Option<Vec<String>>,
    /// f(x) at ε = 0; f′ and Q are those of this field, too.
    pub field: Vec<String>,
    /// f′(x), row by row.
    pub field_jacobian: MatrixText,
    /// A(x,ε), row by row; A(x,ε) x̃ = b(x,ε).
    #[serde(rename = "A")]
    pub matrix: MatrixText,
    /// b(x,ε)
    #[serde(rename = "b")]
    pub rhs: Vec<String>,
    /// Q(x,x′), the second point with primes.
    pub bilinear: Vec<String>,
    /// det A(x,ε)
    #[serde(rename = "det_A")]
    pub determinant: Option<String>,
    /// The reduced map, x̃ = x + 2ε n/d in lowest terms.
    pub map: Option<Vec<String>>,
    /// ∂x̃/∂x of the map, row by row, where it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jacobian: Option<MatrixText>,
    /// What was divided out of the map; `None` if nothing was.
    pub removed_factor: Option<String>,
    /// The claims, which are proved.
    pub claims: Vec<ClaimShown>,
    /// The block of `kahan!`.
    #[serde(rename = "macro")]
    pub block: String,
    /// In [`Form::Sympy`] a script for Python, which assigns the symbols, and the matrices and the
    /// claims made of them, to the names of this sheet.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub script: Option<String>,
}

/// A claim as it is shown.
#[derive(Clone, Debug, Serialize)]
pub struct ClaimShown {
    /// Its name.
    pub name: String,
    /// `integral`, `density`, `bracket` or `drift`.
    pub kind: &'static str,
    /// The claim in the language of `kahan!`, ready to paste.
    pub statement: String,
    /// The relations under which it is made, in that language; empty where it always holds.
    pub when: String,
    /// What is not 0 where it is made, `a2 != 0`; empty where that is numbers alone.
    pub nonzero: String,
    /// Where the catalog has it from.
    pub source: Option<&'static str>,
    /// Its formulas in the notation of the sheet, left and right side: a function; of a drift the
    /// function and its next value; of a bracket an entry for each of [`pairs`](Self::pairs).
    pub equations: Vec<(String, String)>,
    /// Of a bracket the two variables of each equation.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pairs: Vec<[String; 2]>,
    /// The relations under which it is made, in the notation of the sheet.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub condition: String,
}

impl Show {
    /// Derives the formulas of a system whose claims hold, the given parameters put in before the
    /// map is reduced. Costs milliseconds up to a second, as the budget of terms bounds it.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, a field that is not defined at its parameters, one of
    /// more than 500 variables, of which only the block is shown.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Shown, StudyError> {
        study.proved()?;
        let variables = study.variables().len();
        if variables > MOST_VARIABLES && self.form != Form::Kahan {
            return Err(StudyError::LargeMatrices { variables, most: MOST_VARIABLES });
        }
        let mut system = study.specialised()?;
        let block = macro_block(&system);
        let notation: &dyn Notation = match self.form {
            Form::Text => &Text,
            Form::Latex => &Latex,
            Form::Sympy => &SymPy,
            Form::Kahan => {
                return Ok(Shown::Block { system: study.name().to_owned(), block });
            }
            Form::Plan => return Ok(Shown::Plan(Box::new(Planned::of(study.name(), &system, watch)))),
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
        let mut sheet = Sheet {
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
        sheet.script = (self.form == Form::Sympy).then(|| sympy::script(&sheet));
        Ok(Shown::Formulas(Box::new(sheet)))
    }
}

impl ClaimShown {
    /// A claim of a system, its formulas in a notation.
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
