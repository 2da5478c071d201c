//! Bernoulli numbers, for the asymptotic series of Γ and ψ.

use kahan_core::num_rational::BigRational;
use kahan_core::num_traits::{One, Zero};

/// The number of stored Bernoulli numbers, which suffice for 256 bits at arguments of 40 or more.
const COUNT: usize = 64;

/// Returns the Bernoulli numbers B₂, …, B₁₂₈ from B₀ = 1 and Σ_{j≤m} C(m+1, j) B_j = 0 for m ≥ 1.
pub(super) fn even_numbers() -> Vec<BigRational> {
    let order = 2 * COUNT;
    let mut all: Vec<BigRational> = Vec::with_capacity(order + 1);
    for m in 0..=order {
        let mut binomial = BigRational::one();
        let mut sum = BigRational::zero();
        for (j, number) in all.iter().enumerate() {
            sum += &binomial * number;
            binomial *= ratio(m + 1 - j, j + 1);
        }
        all.push(if m == 0 { BigRational::one() } else { -sum / ratio(m + 1, 1) });
    }
    all.into_iter().skip(2).step_by(2).collect()
}

fn ratio(p: usize, q: usize) -> BigRational {
    BigRational::new(p.into(), q.into())
}

#[cfg(test)]
mod tests {
    use super::{even_numbers, ratio};

    #[test]
    fn known_bernoulli_numbers() {
        let numbers = even_numbers();
        assert_eq!(numbers[0], ratio(1, 6));
        assert_eq!(numbers[1], -ratio(1, 30));
        assert_eq!(numbers[5], -ratio(691, 2730));
        assert_eq!(numbers[9].denom(), &(2 * 3 * 5 * 11).into());
    }
}
