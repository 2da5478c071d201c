//! The kernel of a step: what is computed for each state.

use crate::plan::{Node, Plan};

/// From the states and the prepared constants
/// ([`Input::Prepared`](crate::plan::Input::Prepared)) to the factors of the increments:
/// x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kernel {
    /// Its results are the numerators, one a component, and then the reciprocals, no two alike,
    /// each a quotient ±c/d, or ±c/d/d′, c being a power of two.
    pub plan: Plan,
    /// For each component the index of its reciprocal among these; `None` where there is no
    /// division.
    pub reciprocal_of: Vec<Option<usize>>,
}

impl Kernel {
    /// How many components the state has.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.reciprocal_of.len()
    }

    /// The numerators, one a component.
    #[must_use]
    pub fn numerators(&self) -> &[Node] {
        &self.plan.outputs[..self.dimension()]
    }

    /// The reciprocals, no two alike.
    #[must_use]
    pub fn reciprocals(&self) -> &[Node] {
        &self.plan.outputs[self.dimension()..]
    }

    /// The numerator and the reciprocal of each component, among what the plan's results are.
    ///
    /// # Panics
    /// If there are fewer `results` than the plan has.
    pub fn factors<'a, V>(&'a self, results: &'a [V]) -> impl Iterator<Item = (&'a V, Option<&'a V>)> {
        let (numerators, reciprocals) = results.split_at(self.dimension());
        let of = move |(numerator, place): (_, &Option<usize>)| (numerator, place.map(|k| &reciprocals[k]));
        numerators.iter().zip(&self.reciprocal_of).map(of)
    }
}
