//! Tests whether the denominator d(x, ε′) of a map in lowest terms has a root ε′ between 0 and ε.
//!
//! In: d as a polynomial, parameters, ε, and points x. Out: whether d(x, ·) has a root between 0
//! and ε, or at ε. Floats with an error bound decide most cases; exact numbers decide the other
//! cases.

mod roots;

use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbols;

/// In the error bound of a product, smaller factors are replaced by this number, so that the bound
/// does not underflow.
const TINY: f64 = 1.0 / (1_u128 << 110) as f64;

/// The denominator d(x, ε′) as a polynomial in the states x and in t = ε′/ε, where 0 < t ≤ 1.
#[derive(Clone, Debug)]
pub(crate) struct Denominator {
    states: Vec<Variable>,
    t: Variable,
    exact: Polynomial,
    terms: Vec<Term>,
    degree: usize,
}

#[derive(Clone, Debug)]
struct Term {
    power: usize,
    coefficient: f64,
    /// The indices of the states in the term; a state with exponent k occurs k times.
    factors: Vec<usize>,
}

impl Denominator {
    /// Substitutes numbers for parameters and ε in the denominator; `None` for nonfinite numbers.
    pub(crate) fn of(
        symbols: &Symbols,
        denominator: &Polynomial,
        parameters: &[f64],
        eps: f64,
    ) -> Option<Self> {
        let mut at = denominator.clone();
        for (k, value) in parameters.iter().enumerate() {
            at = at.substitute(symbols.parameter(k), &Rational::from_f64(*value)?);
        }
        let (eps, t) = (Rational::from_f64(eps)?, symbols.epsilon());
        let exponent =
            |exponent: u32| i32::try_from(exponent).expect("it is at most the number of variables");
        let scaled = at.terms().map(|(monomial, coefficient)| {
            let power = eps.pow(exponent(monomial.exponent(t))).expect("the exponent is not negative");
            (monomial.clone(), coefficient * &power)
        });
        let exact = Polynomial::from_terms(scaled);
        let states: Vec<Variable> = (0..symbols.dimension()).map(|i| symbols.state(i)).collect();
        let terms = exact.terms().map(|(monomial, coefficient)| {
            let factors = states
                .iter()
                .enumerate()
                .flat_map(|(i, state)| std::iter::repeat_n(i, monomial.exponent(*state) as usize));
            Term {
                power: monomial.exponent(t) as usize,
                coefficient: coefficient.to_f64(),
                factors: factors.collect(),
            }
        });
        let (terms, degree) = (terms.collect(), exact.degree_in(t) as usize);
        Some(Denominator { states, t, exact, terms, degree })
    }

    /// Returns whether d(x, ·) has a root between 0 and ε, including ε; `false` for nonfinite
    /// points.
    pub(crate) fn has_root(&self, x: &[f64]) -> bool {
        self.has_root_in_floats(x).unwrap_or_else(|| self.has_root_exactly(x))
    }

    /// Computes [`has_root`](Self::has_root) in floats; `None` if the error bound permits both
    /// answers.
    fn has_root_in_floats(&self, x: &[f64]) -> Option<bool> {
        let mut coefficients = [0.0; roots::MAX_COEFFICIENTS];
        let coefficients = coefficients.get_mut(..=self.degree)?;
        let (mut sizes, mut unknown) = (0.0, 0.0);
        for Term { power, coefficient, factors } in &self.terms {
            let (mut value, mut size) = (*coefficient, coefficient.abs().max(TINY));
            let mut is_unknown = coefficient.abs() < TINY;
            for factor in factors.iter().map(|i| x[*i]) {
                if factor == 0.0 {
                    (value, size) = (0.0, 0.0);
                    break;
                }
                value *= factor;
                size *= factor.abs().max(TINY);
                is_unknown |= factor.abs() < TINY;
            }
            if is_unknown {
                unknown += size;
            } else {
                coefficients[*power] += value;
                sizes += size;
            }
        }
        // In all, terms have at most nine rounding errors of size `sizes`, additions one per term,
        // and the Bernstein form about 200. `EPSILON` is twice a rounding error.
        let error = (self.terms.len() + 256) as f64 * f64::EPSILON * sizes + unknown;
        if sizes < TINY {
            return None;
        }
        roots::has_root_in_floats(coefficients, error)
    }

    fn has_root_exactly(&self, x: &[f64]) -> bool {
        let put = |at: Polynomial, (state, value): (&Variable, &f64)| {
            Some(at.substitute(*state, &Rational::from_f64(*value)?))
        };
        let Some(at) = self.states.iter().zip(x).try_fold(self.exact.clone(), put) else { return false };
        let mut coefficients = vec![Rational::ZERO; at.degree_in(self.t) as usize + 1];
        for (monomial, coefficient) in at.terms() {
            coefficients[monomial.exponent(self.t) as usize] = coefficient.clone();
        }
        roots::exactly(coefficients)
    }
}
