//! Decides exactly whether roots of a rational polynomial lie inside, on, or outside the unit
//! circle.

use kahan_algebra::poly::{Monomial, Polynomial, Variable, gcd};
use kahan_algebra::rational::Rational;
use kahan_dynamics::periodic::Stability;

pub(super) const Z: Variable = Variable(0);

type Matrix = [Vec<Rational>];

pub(super) fn product(a: &Matrix, b: &Matrix) -> Vec<Vec<Rational>> {
    let entry = |row: &[Rational], j: usize| {
        row.iter().zip(b).fold(Rational::zero(), |sum, (left, right)| &sum + &(left * &right[j]))
    };
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

/// Returns det(z·I − M), by the recurrence of Faddeev and Le Verrier.
pub(super) fn characteristic_polynomial(matrix: &Matrix) -> Polynomial {
    let n = matrix.len();
    let mut terms = vec![(Monomial::power(Z, n as u32), Rational::one())];
    // For the matrix M the recurrence is Nₖ = M·(Nₖ₋₁ + c·I), where c is the previous coefficient;
    // the next coefficient is −tr Nₖ/k.
    let mut power = vec![vec![Rational::zero(); n]; n];
    for k in 1..=n {
        let (_, last) = &terms[k - 1];
        for (i, row) in power.iter_mut().enumerate() {
            row[i] = &row[i] + last;
        }
        power = product(matrix, &power);
        let trace = (0..n).fold(Rational::zero(), |sum, i| &sum + &power[i][i]);
        terms.push((Monomial::power(Z, (n - k) as u32), &trace * &Rational::new(-1, k as i64)));
    }
    Polynomial::from_terms(terms)
}

pub(super) fn stability(polynomial: &Polynomial) -> Stability {
    let reversed = reversed(polynomial);
    // A root 0 lies inside the circle and lowers the degree of the reversed polynomial. Other roots
    // inside are reciprocals of that polynomial's roots outside.
    let is_smaller = reversed.degree() < polynomial.degree() || has_root_outside(&reversed);
    match (has_root_outside(polynomial), is_smaller) {
        (true, true) => Stability::Saddle,
        (true, false) => Stability::Repelling,
        (false, _) if gcd(polynomial, &reversed).as_constant().is_some() => Stability::Attracting,
        (false, _) => Stability::Neutral,
    }
}

/// Returns zᵈ·p(1/z), whose roots are the reciprocals of those of p.
fn reversed(polynomial: &Polynomial) -> Polynomial {
    let degree = polynomial.degree();
    Polynomial::from_terms(
        polynomial.terms().map(|(monomial, coefficient)| {
            (Monomial::power(Z, degree - monomial.degree()), coefficient.clone())
        }),
    )
}

fn has_root_outside(polynomial: &Polynomial) -> bool {
    // For real coefficients, the roots on the circle, and all pairs m, 1/m, are roots of this gcd.
    let shared = gcd(polynomial, &reversed(polynomial));
    // By Cohn's theorem, all roots of a self-reciprocal polynomial lie on the circle if and only if
    // no root of its derivative lies outside.
    if shared.as_constant().is_none() && has_root_outside(&shared.derivative(Z)) {
        return true;
    }
    let Some(mut rest) = polynomial.checked_div(&shared) else { return false };
    // Test of Schur and Cohn for a polynomial without roots on the circle. The product of its roots
    // has the absolute value |constant/leading coefficient|; if this is at least 1, a root lies
    // outside. Otherwise, by Rouché's theorem, `without_last` has as many roots outside.
    while rest.degree() > 0 {
        let leading = rest.coefficient(&Monomial::power(Z, rest.degree()));
        let last = rest.coefficient(&Monomial::one());
        let Some(ratio) = last.checked_div(&leading).filter(|ratio| ratio.abs() < Rational::one()) else {
            return true;
        };
        let without_last = &rest - &reversed(&rest).scale(&ratio);
        rest = without_last.checked_div(&Polynomial::variable(Z)).expect("the last coefficient is 0");
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[Rational]) -> Polynomial {
        let powers = (0..).map(|k| Monomial::power(Z, k));
        Polynomial::from_terms(powers.zip(coefficients.iter().cloned()))
    }

    #[test]
    fn what_roots_say_is_decided_exactly() {
        let of = |coefficients: &[i64], below: i64| {
            polynomial(&coefficients.iter().map(|c| Rational::new(*c, below)).collect::<Vec<_>>())
        };
        // The flags tell whether a polynomial has roots inside, on, and outside the circle.
        let factors = [
            (of(&[0, 1], 1), [true, false, false]),
            (of(&[-1, 2], 2), [true, false, false]),
            (of(&[1, 6], 1), [true, false, false]),
            // The roots are 0.6 ± 0.79i, with absolute value 0.99.
            (of(&[9801, -12000, 10000], 10000), [true, false, false]),
            (of(&[-1, 1], 1), [false, true, false]),
            (of(&[1, 1], 1), [false, true, false]),
            (of(&[5, -6, 5], 5), [false, true, false]),
            (of(&[1, 1, 1, 1, 1], 1), [false, true, false]),
            (of(&[-3, 1], 1), [false, false, true]),
            (of(&[2, 1], 1), [false, false, true]),
            (of(&[10201, -12000, 10000], 10000), [false, false, true]),
            // The first polynomial has the roots (3 ± √5)/2, which are reciprocals of each other.
            // The second has the roots (1 ± √5)/2, whose product is −1.
            (of(&[1, -3, 1], 1), [true, false, true]),
            (of(&[-1, -1, 1], 1), [true, false, true]),
        ];
        for (a, where_a) in &factors {
            for (b, where_b) in &factors {
                for (c, where_c) in &factors {
                    let [inside, on, outside] = [0, 1, 2].map(|k| where_a[k] || where_b[k] || where_c[k]);
                    let expected = match (inside, on, outside) {
                        (true, _, true) => Stability::Saddle,
                        (false, _, true) => Stability::Repelling,
                        (_, true, false) => Stability::Neutral,
                        (_, false, false) => Stability::Attracting,
                    };
                    let whole = &(a * b) * c;
                    assert_eq!(stability(&whole), expected, "{whole:?}");
                }
            }
        }
    }

    #[test]
    fn the_characteristic_polynomial_is_the_determinant() {
        let row = |row: [i64; 3]| row.map(Rational::from).to_vec();
        // The characteristic polynomial is (z − 2)·((z − 1)(z − 3) + 4).
        let matrix = [row([1, -2, 5]), row([2, 3, -7]), row([0, 0, 2])];
        assert_eq!(characteristic_polynomial(&matrix), polynomial(&[-14, 15, -6, 1].map(Rational::from)));
    }
}
