//! Formulas of the state, and the sections where they vanish.

use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;
use kahan_runtime::{MapAt, RuntimePoint};

use crate::error::StudyError;
use crate::formula::{Formula, formula_of};
use crate::study::Study;

/// Reads a formula, and substitutes `parameters` and `eps`. Error messages call the formula `what`.
fn formula_at(
    system: &System,
    parameters: &[Rational],
    eps: &Rational,
    what: &'static str,
    text: &str,
) -> Result<Formula, StudyError> {
    let symbols = &system.field.symbols;
    let parameters = symbols.parameters.iter().cloned().zip(parameters);
    let known = parameters.chain([("eps".to_owned(), eps)]);
    let known: Vec<(String, f64)> = known.map(|(name, value)| (name, value.to_f64())).collect();
    let integrals = system.accessors(ClaimKind::Integral).map(|claim| claim.name.text.as_str());
    let variables: Vec<&str> = symbols.states.iter().map(String::as_str).chain(integrals).collect();
    formula_of(&variables, text, &known).map_err(|why| StudyError::Formula { what, why })
}

impl Study {
    /// Reads a formula in the variables, the integrals claimed without a condition, the parameters
    /// and `eps`. Error messages call the formula `what`.
    ///
    /// # Errors
    /// [`StudyError::Formula`], or missing values.
    pub fn formula(&self, eps: &Rational, what: &'static str, text: &str) -> Result<Formula, StudyError> {
        formula_at(self.system(), &self.values()?, eps, what, text)
    }
}

/// A function of the state whose zeros form a section.
#[derive(Clone, Debug)]
pub struct Plane(pub(super) Formula);

impl Plane {
    /// Reads the formula of a section, at these values of the parameters and this ε.
    ///
    /// # Errors
    /// [`StudyError::Formula`], or [`StudyError::ConstantPlane`] if the formula is constant.
    pub fn of(
        system: &System,
        parameters: &[Rational],
        eps: &Rational,
        text: &str,
    ) -> Result<Self, StudyError> {
        let formula = formula_at(system, parameters, eps, "plane", text)?;
        match formula.last_variable() {
            Some(_) => Ok(Plane(formula)),
            None => Err(StudyError::ConstantPlane { text: text.to_owned() }),
        }
    }

    /// Returns the largest variable index in the formula. Integrals count as further variables.
    #[must_use]
    pub fn last_variable(&self) -> Option<usize> {
        self.0.last_variable()
    }

    /// Returns the formula as a function of the point.
    pub fn height<'a>(&'a self, at: &'a MapAt<f64>) -> impl Fn(&[f64]) -> f64 + 'a {
        // The values of integrals follow the variables, and are computed only if needed.
        let variables = at.map().field().variables().len();
        let has_integrals = self.last_variable().is_some_and(|last| last >= variables);
        let integrals = at.map().field().integrals().len();
        let formula = self.0.clone().function();
        move |x| {
            if !has_integrals {
                return formula(x);
            }
            let mut known: RuntimePoint<f64> = x.iter().copied().collect();
            known.resize(x.len() + integrals, 0.0);
            // Both slices have the lengths that the field requires, so the call succeeds.
            let _ = at.integrals(x, &mut known[x.len()..]);
            formula(&known)
        }
    }
}
