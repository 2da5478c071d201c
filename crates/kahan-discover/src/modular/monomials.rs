//! Monomials of the states up to a degree, in ascending order, and their values at a point.

use crate::modular::modulus::Modulus;

/// The monomials of n variables, ascending by degree, then lexicographically with x₁ > … > xₙ.
#[derive(Clone, Debug)]
pub struct Monomials {
    variables: usize,
    exponents: Vec<Vec<u32>>,
    /// For each monomial except 1: the index of an earlier monomial and the variable by which to
    /// multiply it.
    recipes: Vec<(usize, usize)>,
    counts: Vec<usize>,
}

impl Monomials {
    /// Lists the monomials of degree at most `degree` in n variables.
    #[must_use]
    pub fn new(variables: usize, degree: u32) -> Self {
        let mut monomials = Monomials {
            variables,
            exponents: vec![vec![0; variables]],
            recipes: vec![(0, 0)],
            counts: vec![1],
        };
        for _ in 0..degree {
            let end = monomials.exponents.len();
            for variable in (0..variables).rev() {
                let begin = if end == 1 { 0 } else { monomials.counts[monomials.counts.len() - 2] };
                for earlier in begin..end {
                    // Each product is made once: by multiplication with its variable of lowest
                    // index.
                    if monomials.exponents[earlier][..variable].iter().all(|&exponent| exponent == 0) {
                        let mut exponents = monomials.exponents[earlier].clone();
                        exponents[variable] += 1;
                        monomials.exponents.push(exponents);
                        monomials.recipes.push((earlier, variable));
                    }
                }
            }
            monomials.counts.push(monomials.exponents.len());
        }
        monomials
    }

    /// Returns C(n + degree, n), the number of monomials of degree at most `degree` in n variables.
    #[must_use]
    pub fn count(variables: usize, degree: u32) -> usize {
        (1..=variables as u128)
            .fold(1u128, |count, k| count.saturating_mul(u128::from(degree) + k) / k)
            .try_into()
            .unwrap_or(usize::MAX)
    }

    /// Returns the number of monomials.
    #[must_use]
    pub fn len(&self) -> usize {
        self.exponents.len()
    }

    /// Returns `false`, as the monomial 1 is always present.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        false
    }

    /// Returns the number of variables.
    #[must_use]
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// Returns the highest degree of a monomial.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.counts.len() as u32 - 1
    }

    /// Returns the number of monomials of degree at most `degree`.
    ///
    /// # Panics
    /// If `degree` exceeds the highest degree of the list.
    #[must_use]
    pub fn up_to(&self, degree: u32) -> usize {
        self.counts[degree as usize]
    }

    /// Returns the exponents of the monomial with this index.
    #[must_use]
    pub fn exponents(&self, index: usize) -> &[u32] {
        &self.exponents[index]
    }

    /// Evaluates all monomials with one multiplication each.
    #[must_use]
    pub fn values(&self, modulus: &Modulus, point: &[u64]) -> Vec<u64> {
        let mut values = Vec::with_capacity(self.len());
        values.push(modulus.one());
        for &(earlier, variable) in &self.recipes[1..] {
            values.push(modulus.times(values[earlier], point[variable]));
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_monomial_stands_once_in_ascending_order() {
        let monomials = Monomials::new(3, 4);
        assert_eq!(monomials.len(), 35);
        assert_eq!(monomials.up_to(2), 10);
        for degree in 0..=4 {
            assert_eq!(monomials.up_to(degree), Monomials::count(3, degree));
        }
        let key = |index: usize| {
            let exponents = monomials.exponents(index);
            (exponents.iter().sum::<u32>(), exponents.to_vec())
        };
        assert!((1..monomials.len()).all(|index| key(index - 1) < key(index)));
    }
}
