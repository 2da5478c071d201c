//! Sign changes of states that carry orbits to orbits, and the characters of monomials under them.
//!
//! If f(Sx) = ±S f(x) with S = diag(±1), the map satisfies φ(Sx) = Sφ(x), or the same with −ε, the
//! inverse: the closure of the orbit of Sx is S times that of x. An entry of the reduced relations
//! then changes by the signs of its two monomials, and P and Q with P/Q equal to it may be looked
//! for among monomials of one sign each.

/// As many generators are enough; all products of them are gone through.
const MOST: usize = 8;

/// xⱼxₖ, xⱼ or 1 in component i of a field, as the sum over F₂ of their unit vectors and that of
/// xᵢ.
pub type TermSigns = u64;

/// Generators of the sign changes S, each as the set of states whose sign it changes, one bit a
/// state; `terms` are all terms of the field in `states` states (at most 63: none beyond).
#[must_use]
pub fn sign_changes(states: usize, terms: &[TermSigns]) -> Vec<u64> {
    if states > 63 {
        return Vec::new();
    }
    // The sign of every term, σ·sᵢ = sⱼsₖ: linear over F₂ in the bits of s and σ, σ last.
    let time = 1u64 << states;
    let mut rows: Vec<u64> = terms.iter().map(|term| term | time).collect();
    let mut pivots: Vec<(usize, u64)> = Vec::new();
    for bit in 0..=states {
        let Some(found) = rows.iter().position(|row| row >> bit & 1 == 1) else { continue };
        let pivot = rows.swap_remove(found);
        for row in rows.iter_mut().chain(pivots.iter_mut().map(|(_, row)| row)) {
            if *row >> bit & 1 == 1 {
                *row ^= pivot;
            }
        }
        pivots.push((bit, pivot));
    }
    let free = (0..=states).filter(|bit| pivots.iter().all(|(pivot, _)| pivot != bit));
    let solutions = free.map(|bit| {
        let own = pivots.iter().filter(|(_, row)| row >> bit & 1 == 1);
        own.fold(1u64 << bit, |solution, (pivot, _)| solution | 1 << pivot) & !time
    });
    solutions.filter(|solution| *solution != 0).take(MOST).collect()
}

/// The signs of a monomial under the generators, one bit each.
#[must_use]
pub fn character(generators: &[u64], exponents: &[u32]) -> u64 {
    let odd = exponents.iter().enumerate().filter(|(_, exponent)| *exponent % 2 == 1);
    let odd = odd.fold(0u64, |set, (state, _)| set | 1 << state);
    let bits = generators.iter().enumerate();
    bits.fold(0, |sum, (index, generator)| sum | u64::from((generator & odd).count_ones() % 2) << index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_euler_top_has_three_sign_changes() {
        // ẋ = yz, ẏ = zx, ż = xy: every term is xyz, so each state may change its sign, and time
        // with it.
        let generators = sign_changes(3, &[0b111; 3]);
        assert_eq!(generators.len(), 3);
        assert_eq!(character(&generators, &[2, 0, 4]), 0);
        assert_ne!(character(&generators, &[1, 1, 0]), 0);
        // x changes its sign with neither term of x² + x.
        assert!(sign_changes(1, &[0b1, 0b0]).is_empty());
    }
}
