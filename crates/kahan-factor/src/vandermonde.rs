//! Solves linear systems with Vandermonde matrices.

use kahan_algebra::prime_field::PrimeField;

use super::dense::{self, Dense};

/// For each column (v₁, v₂, …), returns the cᵢ with Σᵢ cᵢ·mᵢ^k = vₖ for all k, where mᵢ are the
/// nodes. Returns `None` if a node is 0 or two nodes are equal.
///
/// For each i, let q(z) = ∏_{j≠i} (z − mⱼ) = Σₖ qₖ·z^k. Then Σₖ qₖ·v_{k+1} = cᵢ·mᵢ·q(mᵢ) gives cᵢ.
pub(super) fn solutions(field: PrimeField, nodes: &[u64], columns: &[Dense]) -> Option<Vec<Dense>> {
    let master = nodes.iter().fold(vec![1], |all, &node| dense::product(field, &all, &[field.neg(node), 1]));
    nodes
        .iter()
        .map(|&node| {
            // Horner's rule divides the product of all z − mⱼ by z − node.
            let mut quotient = vec![0; nodes.len()];
            let mut carry = 0;
            for place in (0..nodes.len()).rev() {
                carry = field.add(field.mul(carry, node), master[place + 1]);
                quotient[place] = carry;
            }
            let at_node = quotient.iter().rev().fold(0, |sum, &c| field.add(field.mul(sum, node), c));
            let unit = field.inverse(field.mul(node, at_node))?;
            Some(columns.iter().map(|values| field.mul(dense::dot(field, &quotient, values), unit)).collect())
        })
        .collect()
}
