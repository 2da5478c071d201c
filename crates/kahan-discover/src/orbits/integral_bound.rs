//! Computes upper bounds on the number of integrals from fixed points of the map.
//!
//! One zero of the field modulo a prime proves a bound ([`integral_bound`]). Zeros are found by
//! trial: some states are random, and equations with one remaining unknown are solved.

use kahan_algebra::prime_field::{PrimeField, SplitMix64};

use crate::deadline::Deadline;
use crate::maps::map::{ModularMap, Term};
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;

/// An upper bound on the number of integrals, with its proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IntegralBound {
    /// The greatest number of independent rational integrals that the map can have at generic ε.
    pub integrals: usize,
    /// The prime modulo which the bound is proved.
    pub prime: u64,
    /// The zero of the field modulo the prime that gives the bound.
    pub zero: Vec<u64>,
    /// The values of the parameters modulo the prime.
    pub parameters: Vec<u64>,
}

/// Each prime p is 3 modulo 4, so the square roots of a are ±a^((p+1)/4). The field has zeros more
/// often modulo a small prime. Modulo a large prime, fewer eigenvalues are equal by chance.
const PRIMES: [u64; 6] = [1_000_003, 7, 31, 11, 103, 19];

/// The most variables of a field. The eigenvalues cost n⁴ multiplications for n variables.
const MOST_VARIABLES: usize = 24;

/// The most trials if a bound would not shorten the search for integrals.
pub const FEW_TRIALS: usize = 24_000;

/// The most trials if the bound may save a long search.
pub const MANY_TRIALS: usize = 400_000;

/// The most multiplications of all trials together. One trial takes about n³ multiplications in n
/// variables.
const MAX_PRODUCTS: usize = 100_000_000;

const TRIALS_A_SAMPLE: usize = 40;

/// Returns the least bound found in `trials` trials, or the first bound that is at most `enough`.
///
/// Returns `None` if no zero was found, ε is fixed, the field depends on ε, or there are more than
/// 24 variables.
///
/// Let L = f′(x₀) at a zero x₀ of f. The map has the Jacobian (I − εL)⁻¹(I + εL) there, with the
/// eigenvalues μ = (1 + ελ)/(1 − ελ) for the eigenvalues λ of L. Suppose that k independent
/// rational integrals exist. Their lowest terms at x₀ give k independent rational functions that
/// the Jacobian preserves (Ziglin's lemma). The diagonal part of the Jacobian preserves these
/// functions, too. So k ≤ n − s if s of the μ are multiplicatively independent. In ε, μ has the
/// zero −1/λ and the pole 1/λ. Only λ and −λ share them, so s counts the different λ² ≠ 0.
///
/// The argument holds over every field of characteristic ≠ 2. If k independent integrals over ℚ(ε)
/// exist, k also exist for the map modulo a prime (Ziglin's lemma for the valuation). One zero
/// modulo one prime is therefore a proof.
pub fn integral_bound(
    searched: &SearchField,
    enough: usize,
    trials: usize,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<IntegralBound> {
    let n = searched.dimension();
    if searched.eps().is_some() || searched.family().depends_on_eps() || n > MOST_VARIABLES {
        return None;
    }
    let mut lowest: Option<IntegralBound> = None;
    let trials = trials.min(MAX_PRODUCTS / (n * n * n).max(1));
    for sample in 0..trials / TRIALS_A_SAMPLE {
        let prime = PRIMES[sample % PRIMES.len()];
        // Multiple eigenvalues are found by a derivative modulo the prime, which must exceed n.
        if prime <= n as u64 {
            continue;
        }
        let modulus = Modulus::of(PrimeField::new(prime).expect("the numbers listed are primes"));
        let unknowns: Vec<u64> = (0..searched.unknowns()).map(|_| modulus.sample(random)).collect();
        let Some(map) = searched.at(modulus, &unknowns) else { continue };
        for _ in 0..TRIALS_A_SAMPLE {
            if deadline.passed() {
                return lowest;
            }
            let Some(zero) = zero_of_field(&map, &modulus, random) else { continue };
            let (_, slopes) = map.field(&zero);
            let integrals = n - different_squares(&modulus, &slopes);
            if lowest.as_ref().is_none_or(|known| integrals < known.integrals) {
                let plain = |values: &[u64]| values.iter().map(|&value| modulus.residue(value)).collect();
                let parameters = plain(&unknowns[..unknowns.len() - 1]);
                lowest = Some(IntegralBound { integrals, prime, zero: plain(&zero), parameters });
                if integrals <= enough {
                    return lowest;
                }
            }
        }
    }
    lowest
}

fn zero_of_field(map: &ModularMap, modulus: &Modulus, random: &mut SplitMix64) -> Option<Vec<u64>> {
    let components = map.components();
    let mut values: Vec<Option<u64>> = vec![None; components.len()];
    loop {
        let mut solved = None;
        for terms in &components {
            match restricted(terms, &values, modulus) {
                RestrictedComponent::Constant(0) | RestrictedComponent::Several => {}
                RestrictedComponent::Constant(_) => return None,
                RestrictedComponent::Single { state, coefficients } => {
                    solved = Some((state, root(coefficients, modulus, random)?));
                    break;
                }
            }
        }
        let (state, value) = match solved {
            Some(found) => found,
            None => {
                let open: Vec<usize> = (0..values.len()).filter(|&state| values[state].is_none()).collect();
                if open.is_empty() {
                    return values.into_iter().collect();
                }
                let value = match random.below(4) {
                    0 => 0,
                    1 => modulus.one(),
                    _ => modulus.sample(random),
                };
                (open[random.below(open.len() as u64) as usize], value)
            }
        };
        values[state] = Some(value);
    }
}

/// A component of the field after the known states are substituted.
enum RestrictedComponent {
    /// The component has this constant value.
    Constant(u64),
    /// The component is c₀ + c₁x + c₂x² for one unknown state x.
    Single { state: usize, coefficients: [u64; 3] },
    /// The component depends on several unknown states.
    Several,
}

fn restricted(terms: &[Term], values: &[Option<u64>], modulus: &Modulus) -> RestrictedComponent {
    let mut coefficients = [0; 3];
    let mut only = None;
    for term in terms {
        let states = [term.first, term.second].into_iter().flatten();
        let known = states.clone().filter_map(|state| values[state]);
        let coefficient = known.fold(term.coefficient, |product, value| modulus.times(product, value));
        if coefficient == 0 {
            continue;
        }
        let mut degree = 0;
        for state in states.filter(|&state| values[state].is_none()) {
            if *only.get_or_insert(state) != state {
                return RestrictedComponent::Several;
            }
            degree += 1;
        }
        coefficients[degree] = modulus.plus(coefficients[degree], coefficient);
    }
    match only {
        Some(state) if coefficients[1..] != [0, 0] => RestrictedComponent::Single { state, coefficients },
        _ => RestrictedComponent::Constant(coefficients[0]),
    }
}

/// Returns a random root of c₀ + c₁x + c₂x², where c₁ and c₂ are not both 0.
fn root([c0, c1, c2]: [u64; 3], modulus: &Modulus, random: &mut SplitMix64) -> Option<u64> {
    let quotient = |above: u64, below: u64| Some(modulus.times(above, modulus.inverse(below)?));
    if c2 == 0 {
        return quotient(modulus.opposite(c0), c1);
    }
    let four = modulus.integer(4);
    let discriminant = modulus.minus(modulus.times(c1, c1), modulus.times(four, modulus.times(c0, c2)));
    let sqrt = modulus.power(discriminant, ((modulus.prime() + 1) / 4) as u32);
    if modulus.times(sqrt, sqrt) != discriminant {
        return None;
    }
    let sqrt = if random.below(2) == 0 { sqrt } else { modulus.opposite(sqrt) };
    quotient(modulus.minus(sqrt, c1), modulus.plus(c2, c2))
}

/// Returns the number of different λ² ≠ 0 for eigenvalues λ in the algebraic closure. The prime
/// must exceed the number n of rows. The cost is n⁴ multiplications.
fn different_squares(modulus: &Modulus, matrix: &[Vec<u64>]) -> usize {
    let mut polynomial = characteristic(modulus, &product(modulus, matrix, matrix));
    polynomial.drain(..polynomial.iter().take_while(|&&coefficient| coefficient == 0).count());
    let slope = (1..polynomial.len())
        .map(|power| modulus.times(modulus.integer(power as u64), polynomial[power]))
        .collect();
    let degree = polynomial.len() - 1;
    let repeated = common_degree(modulus, polynomial, slope);
    degree - repeated
}

fn product(modulus: &Modulus, left: &[Vec<u64>], right: &[Vec<u64>]) -> Vec<Vec<u64>> {
    let column = |j: usize| -> Vec<u64> { right.iter().map(|row| row[j]).collect() };
    let columns: Vec<Vec<u64>> = (0..right.len()).map(column).collect();
    let entries = |row: &Vec<u64>| columns.iter().map(|column| modulus.dot(row, column)).collect();
    left.iter().map(entries).collect()
}

/// Returns the coefficients of det(t − M), lowest first, by Faddeev and LeVerrier's recursion.
fn characteristic(modulus: &Modulus, matrix: &[Vec<u64>]) -> Vec<u64> {
    let n = matrix.len();
    let mut coefficients = vec![0; n + 1];
    coefficients[n] = modulus.one();
    let mut auxiliary = vec![vec![0; n]; n];
    for k in 1..=n {
        // Mₖ = M Mₖ₋₁ + cₙ₋ₖ₊₁ I and cₙ₋ₖ = −tr(M Mₖ)/k, where cₖ is the coefficient of tᵏ.
        auxiliary = product(modulus, matrix, &auxiliary);
        for (i, row) in auxiliary.iter_mut().enumerate() {
            row[i] = modulus.plus(row[i], coefficients[n - k + 1]);
        }
        let moved = product(modulus, matrix, &auxiliary);
        let trace = (0..n).fold(0, |sum, i| modulus.plus(sum, moved[i][i]));
        let inverse = modulus.inverse(modulus.integer(k as u64)).expect("the prime is larger than n");
        coefficients[n - k] = modulus.opposite(modulus.times(trace, inverse));
    }
    coefficients
}

/// Returns the degree of the greatest common divisor of two polynomials with constant terms first.
/// The polynomial `above` must be nonzero.
fn common_degree(modulus: &Modulus, mut above: Vec<u64>, mut below: Vec<u64>) -> usize {
    loop {
        while below.last() == Some(&0) {
            below.pop();
        }
        let Some(&leading) = below.last() else { return above.len() - 1 };
        let inverse = modulus.inverse(leading).expect("a leading coefficient is not 0");
        while above.len() >= below.len() {
            let factor = modulus.times(above.pop().expect("it has more coefficients"), inverse);
            let shift = above.len() + 1 - below.len();
            for (place, coefficient) in below[..below.len() - 1].iter().enumerate() {
                let entry = &mut above[shift + place];
                *entry = modulus.minus(*entry, modulus.times(factor, *coefficient));
            }
        }
        std::mem::swap(&mut above, &mut below);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::{lexer, read};

    fn of(text: &str, eps: Option<kahan_algebra::rational::Rational>) -> Option<usize> {
        let field = read(&lexer::lex(text).tokens).system().expect("a system").field;
        let searched = SearchField::new(&field, eps);
        integral_bound(&searched, 0, FEW_TRIALS, &mut SplitMix64::new(1), &Deadline::never())
            .map(|found| found.integrals)
    }

    #[test]
    fn eigenvalues_are_counted_by_their_squares() {
        let modulus = Modulus::of(PrimeField::new(1_000_003).unwrap());
        let count = |values: &[i64]| {
            let n = values.len();
            let entry = |i: usize, j: usize| match j.cmp(&i) {
                std::cmp::Ordering::Less => 0,
                std::cmp::Ordering::Equal if values[i] < 0 => {
                    modulus.opposite(modulus.integer(values[i].unsigned_abs()))
                }
                std::cmp::Ordering::Equal => modulus.integer(values[i].unsigned_abs()),
                std::cmp::Ordering::Greater => modulus.integer((3 * i + 5 * j + 1) as u64),
            };
            let rows: Vec<Vec<u64>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
            different_squares(&modulus, &rows)
        };
        assert_eq!(count(&[0]), 0);
        assert_eq!(count(&[0, 0, 0]), 0);
        assert_eq!(count(&[1, -1]), 1);
        assert_eq!(count(&[2, 2, 2]), 1);
        assert_eq!(count(&[1, 2, 3]), 3);
        assert_eq!(count(&[0, 1, -1, 2, -2, 5]), 3);
    }

    #[test]
    fn ceilings_of_fields_whose_integrals_are_known() {
        assert_eq!(of("xdot = y; ydot = 6*x^2 - a;", None), Some(1));
        assert_eq!(of("xdot = x*(y - z); ydot = y*(z - x); zdot = z*(x - y);", None), Some(2));
        assert_eq!(of("xdot = a1*y*z; ydot = a2*z*x; zdot = a3*x*y;", None), Some(2));
        let five = "adot = a*(b + c - d - e); bdot = b*(c + d - e - a); cdot = c*(d + e - a - b);
            ddot = d*(e + a - b - c); edot = e*(a + b - c - d);";
        assert_eq!(of(five, None), Some(3));
        assert_eq!(of("xdot = 2*x; ydot = -3*y;", None), Some(0));
        assert_eq!(of("xdot = x; ydot = -y;", None), Some(1));
        assert_eq!(of("xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z;", None), Some(0));
        assert_eq!(of("xdot = x^2 + y*z + 1; ydot = x*y - z^2; zdot = y^2 + 3*x;", None), Some(0));
        assert_eq!(of("xdot = 1; ydot = x;", None), None);
        assert_eq!(of("xdot = y^2; ydot = 0;", None), Some(2));
        let dense = "xdot = x^2 - 3*x*y + 2*y*z + w^2 - x + 2*y + 1; ydot = 2*x^2 + x*y - 5*y*z + z*w + 3;
            zdot = x*z - 4*y^2 + 7*x - y + 2*w; wdot = w*x - 3*y*z + z^2 - 5;";
        assert_eq!(of(dense, None), Some(0));
        assert_eq!(of("xdot = 2*x/(1 + eps^2); ydot = y;", None), None);
        assert_eq!(of("xdot = 2*x; ydot = -3*y;", Some(kahan_algebra::rational::Rational::one())), None);
    }
}
