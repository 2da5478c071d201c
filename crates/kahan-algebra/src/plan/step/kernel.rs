//! The kernel of a step, which is repeated for each state.

use crate::plan::{Node, Plan};

/// The plan of the increments x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ from states and prepared
/// constants ([`Input::Prepared`](crate::plan::Input::Prepared)).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kernel {
    /// The plan of the kernel. The outputs are the numerators, then the distinct reciprocals. A
    /// reciprocal is ±c/d or (±c/d)/d′ with denominators d and d′ and a power of two c.
    pub plan: Plan,
    /// The index of each component's reciprocal. `None` for increments without division.
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

    /// Returns numerator and reciprocal of each component from the outputs of the plan.
    ///
    /// # Panics
    /// If `results` is shorter than the outputs of the plan.
    pub fn factors<'a, V>(&'a self, results: &'a [V]) -> impl Iterator<Item = (&'a V, Option<&'a V>)> {
        let (numerators, reciprocals) = results.split_at(self.dimension());
        let of = move |(numerator, place): (_, &Option<usize>)| (numerator, place.map(|k| &reciprocals[k]));
        numerators.iter().zip(&self.reciprocal_of).map(of)
    }
}
