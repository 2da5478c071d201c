//! Claims become reduced rational functions here, and tensors become claims.

use crate::plan::{Node, PlanBuilder};
use crate::poly::{Budget, Variable};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;
use crate::syntax::{ClaimBody, ClaimKind, Entry, Name};
use crate::system::{Claim, Condition, upper_index};
use crate::token::Span;

use super::expression::expression;
use super::reduced::Reduced;
use super::{PoissonError, PoissonTensor};

/// What a claim states, as functions in lowest terms of states, parameters and ε: one for an integral or a density, the
/// entries above the diagonal (in the order of [`upper_index`]) for a bracket. What stands behind `when` is put in.
///
/// Cost: one operation on reduced functions, with its gcds, for each step of the claim's plan.
///
/// # Errors
/// [`PoissonError::UndefinedClaim`] where the claim divides by zero identically (perhaps only at the values behind
/// `when`), [`PoissonError::OverBudget`] where it is too large.
pub fn claim_functions(claim: &Claim, budget: &mut Budget) -> Result<Vec<RationalFunction>, PoissonError> {
    let fixed = |variable: Variable| claim.conditions.iter().find(|known| known.variable == variable);
    let values = claim.plan.evaluate(&Reduced::new(budget), |variable| {
        Ok(match fixed(variable) {
            Some(condition) => condition.value.clone(),
            None => RationalFunction::variable(variable),
        })
    });
    let undefined = || PoissonError::UndefinedClaim { name: claim.name.text.clone() };
    values.into_iter().map(|value| Ok(value.ok_or_else(undefined)??)).collect()
}

impl PoissonTensor {
    /// The tensor as a claim `bracket NAME { … } when …` of a system with these symbols, to be proved
    /// ([`prove_all`](crate::prove::prove_all), once it stands among the system's claims) and rendered
    /// ([`claim_text`](crate::render::claim_text) in the macro's language, [`claim_statement`](crate::render::claim_statement)
    /// in LaTeX).
    ///
    /// Zero entries are left out. In dimension 3 the entries are {x,y}, {y,z}, {z,x}, in others those above the diagonal,
    /// row by row. `name` should be a name that nothing else in the system has; the system's reader checks it.
    /// The places of the names point nowhere in particular.
    #[must_use]
    pub fn claim(&self, symbols: &Symbols, name: &str, conditions: Vec<Condition>) -> Claim {
        let n = self.dimension();
        let mut places: Vec<(usize, usize)> = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).collect();
        if n == 3 {
            places = vec![(0, 1), (1, 2), (2, 0)];
        }
        // A block refuses a bracket without entries; the prover then says that a zero one states nothing.
        let shown =
            |&(i, j): &(usize, usize)| self.is_zero() && (i, j) == (0, 1) || !self.entry(i, j).is_zero();
        let entries = places.into_iter().filter(shown).map(|(i, j)| Entry {
            row: nowhere(&symbols.states[i]),
            column: nowhere(&symbols.states[j]),
            value: expression(symbols, &self.entry(i, j)),
        });
        Claim {
            kind: ClaimKind::Bracket,
            name: nowhere(name),
            body: Some(ClaimBody::Tensor(entries.collect())),
            plan: self.plan(),
            conditions,
        }
    }

    fn plan(&self) -> crate::plan::Plan {
        let mut builder = PlanBuilder::default();
        let nodes: Vec<Node> = self
            .entries()
            .iter()
            .map(|entry| {
                let numerator = builder.polynomial(entry.numerator());
                let denominator = builder.polynomial(entry.denominator());
                builder.divide(numerator, denominator)
            })
            .collect();
        debug_assert!(nodes.len() == upper_index(self.dimension(), self.dimension() - 1, self.dimension()));
        builder.finish(&nodes)
    }
}

fn nowhere(text: &str) -> Name {
    Name { text: text.to_owned(), span: Span::token(0) }
}
