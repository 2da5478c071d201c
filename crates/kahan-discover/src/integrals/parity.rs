//! Finds sign changes of states that map orbits to orbits.
//!
//! Let f(Sx) = ±S f(x) with S = diag(±1). Then the map φ satisfies φ(Sx) = Sφ(x) at ε or −ε, and S
//! maps the closure of an orbit to the closure of another orbit. The sign of a monomial m is ±1 in
//! m(Sx) = ±m(x). S multiplies the coefficient of m in a reduced relation by the signs of m and of
//! the leading monomial. If it equals P/Q, P can have monomials of a single sign, and so can Q.

/// The most generators of sign changes that are returned.
const MAX_GENERATORS: usize = 8;

/// The indices that occur an odd number of times among i, j and k, as a bit set, for a term xⱼxₖ of
/// component i. A linear term has no k, and a constant term has neither j nor k.
pub type TermSigns = u64;

/// Returns generators of the sign changes of states, each as a bit set. `terms` holds all terms of
/// a field in `states` states. Above 63 states the list is empty.
#[must_use]
pub fn sign_changes(states: usize, terms: &[TermSigns]) -> Vec<u64> {
    if states > 63 {
        return Vec::new();
    }
    // Signs sᵢ of the states and σ of time must satisfy σ·sᵢ = sⱼsₖ for each term. The condition is
    // linear over F₂, and the bit of σ is last.
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
    solutions.filter(|solution| *solution != 0).take(MAX_GENERATORS).collect()
}

/// Returns the sign of a monomial under each generator. Each sign is one bit of the result.
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
        let generators = sign_changes(3, &[0b111; 3]);
        assert_eq!(generators.len(), 3);
        assert_eq!(character(&generators, &[2, 0, 4]), 0);
        assert_ne!(character(&generators, &[1, 1, 0]), 0);
        assert!(sign_changes(1, &[0b1, 0b0]).is_empty());
    }
}
