//! The kernel of a step, which consists of the operations that are repeated for each state.

use crate::plan::{Node, Plan};

/// The plan that computes the increments x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ from states and
/// prepared constants ([`Input::Prepared`](crate::plan::Input::Prepared)).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kernel {
    /// The plan of the kernel. Its outputs are one numerator for each component, then the distinct
    /// reciprocals. A reciprocal is ±c/d or ±c/d/d′, where d and d′ are denominators and c is a
    /// power of two.
    pub plan: Plan,
    /// For each component the index of its reciprocal; `None` if the increment needs no division.
    pub reciprocal_of: Vec<Option<usize>>,
}

impl Kernel {
    /// Returns the number of components.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.reciprocal_of.len()
    }

    /// Returns the numerators, one for each component.
    #[must_use]
    pub fn numerators(&self) -> &[Node] {
        &self.plan.outputs[..self.dimension()]
    }

    /// Returns the distinct reciprocals.
    #[must_use]
    pub fn reciprocals(&self) -> &[Node] {
        &self.plan.outputs[self.dimension()..]
    }

    /// Returns the numerator and the reciprocal of each component. `results` are the values of the
    /// plan's outputs.
    ///
    /// # Panics
    /// If `results` is shorter than the outputs of the plan.
    pub fn factors<'a, V>(&'a self, results: &'a [V]) -> impl Iterator<Item = (&'a V, Option<&'a V>)> {
        let (numerators, reciprocals) = results.split_at(self.dimension());
        let of = move |(numerator, place): (_, &Option<usize>)| (numerator, place.map(|k| &reciprocals[k]));
        numerators.iter().zip(&self.reciprocal_of).map(of)
    }
}
