//! Linear systems whose rows are powers of given numbers: Σ cᵢ·mᵢ^k = vₖ.

use kahan_algebra::prime_field::PrimeField;

use super::dense::{self, Dense};

/// Returns for each column v the cᵢ with Σ cᵢ·mᵢ^k = vₖ, k ≥ 1, for nodes mᵢ; `None` if a node is 0
/// or two are equal.
///
/// With q = ∏_{j≠i} (z − mⱼ), the sum Σ qₖ·v_{k+1} is cᵢ·mᵢ·q(mᵢ).
pub(super) fn solutions(field: PrimeField, nodes: &[u64], columns: &[Dense]) -> Option<Vec<Dense>> {
    let master = nodes.iter().fold(vec![1], |all, &node| dense::product(field, &all, &[field.neg(node), 1]));
    nodes
        .iter()
        .map(|&node| {
            // Horner's rule from the top gives the quotient by z − node.
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
