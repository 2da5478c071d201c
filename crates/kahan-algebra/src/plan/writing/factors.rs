//! Writes several polynomials as products over one set of factors. Factors come from gcds of
//! polynomials, gcds of coefficients, and quadratics whose discriminant is a square.

use kahan_syntax::rational::Rational;

use crate::poly::{Budget, Monomial, Polynomial, gcd_all_within, gcd_within};

/// The budget for the factors of polynomials. Polynomials stay unfactored if it is spent.
const FACTORING_WORK: u64 = 20_000;
const MAX_FACTORED_TERMS: usize = 60;
/// Discriminants are computed only for polynomials of at most this many terms.
const QUADRATIC_TERMS: usize = 16;

/// A polynomial written as coefficient · monomial · ∏ factor^exponent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::plan) struct Factored {
    pub(in crate::plan) coefficient: Rational,
    pub(in crate::plan) monomial: Monomial,
    pub(in crate::plan) factors: Vec<(Polynomial, u32)>,
}

impl Factored {
    pub(in crate::plan) fn exponent(&self, factor: &Polynomial) -> u32 {
        self.factors.iter().find(|(known, _)| known == factor).map_or(0, |(_, exponent)| *exponent)
    }

    pub(in crate::plan) fn without(&self, factor: &Polynomial) -> Self {
        let mut quotient = self.clone();
        for (known, exponent) in &mut quotient.factors {
            *exponent -= u32::from(known == factor);
        }
        quotient.factors.retain(|(_, exponent)| *exponent > 0);
        quotient
    }
}

pub(in crate::plan) fn factored(polynomials: &[&Polynomial]) -> Vec<Factored> {
    let base = coprime_base(polynomials);
    polynomials.iter().map(|polynomial| over_base(polynomial, &base)).collect()
}

/// Returns pairwise coprime polynomials. Each given polynomial is a product of powers of the
/// returned ones, up to monomials and constants.
fn coprime_base(polynomials: &[&Polynomial]) -> Vec<Polynomial> {
    let mut budget = Budget::new(MAX_FACTORED_TERMS * MAX_FACTORED_TERMS, FACTORING_WORK);
    let mut waiting: Vec<Polynomial> =
        polynomials.iter().map(|polynomial| primitive_core(polynomial)).collect();
    let mut base: Vec<Polynomial> = Vec::new();
    while let Some(next) = waiting.pop() {
        if next.as_constant().is_some() || base.contains(&next) {
            continue;
        }
        let mut shared = base.iter().enumerate();
        let shared =
            shared.find_map(|(index, known)| Some((index, common_factor(known, &next, &mut budget)?)));
        match shared {
            Some((index, factor)) => {
                let known = base.remove(index);
                waiting.extend(split_off(&known, factor.clone()));
                waiting.extend(split_off(&next, factor));
            }
            None => match content_factor(&next, &mut budget).or_else(|| quadratic_factor(&next, &mut budget))
            {
                Some(factor) => waiting.extend(split_off(&next, factor)),
                None => base.push(next),
            },
        }
    }
    base
}

/// Divides by common coefficients and monomials, and makes the leading coefficient positive.
fn primitive_core(polynomial: &Polynomial) -> Polynomial {
    polynomial.div_monomial(&polynomial.monomial_content()).expect("all terms have it").primitive_part()
}

fn split_off(polynomial: &Polynomial, factor: Polynomial) -> [Polynomial; 2] {
    let quotient = polynomial.checked_div(&factor).expect("a factor divides");
    [primitive_core(&quotient), primitive_core(&factor)]
}

fn common_factor(a: &Polynomial, b: &Polynomial, budget: &mut Budget) -> Option<Polynomial> {
    if a.len().max(b.len()) > MAX_FACTORED_TERMS {
        return None;
    }
    gcd_within(a, b, budget).ok().map(|gcd| primitive_core(&gcd)).filter(|gcd| gcd.as_constant().is_none())
}

/// Returns the gcd of the coefficients in some variable, if it is a polynomial of several terms.
fn content_factor(polynomial: &Polynomial, budget: &mut Budget) -> Option<Polynomial> {
    if polynomial.len() > MAX_FACTORED_TERMS || polynomial.len() < 4 {
        return None;
    }
    polynomial.variables().into_iter().find_map(|variable| {
        let coefficients: Vec<Polynomial> = polynomial.coefficients_in(variable).into_values().collect();
        // One coefficient is its own gcd; a coefficient of one term has only monomial factors.
        if coefficients.len() < 2 || coefficients.iter().any(|coefficient| coefficient.len() < 2) {
            return None;
        }
        let content = primitive_core(&gcd_all_within(&coefficients, budget).ok()?);
        (content.as_constant().is_none() && content != *polynomial).then_some(content)
    })
}

/// Returns a factor of av² + bv + c, a polynomial of degree 2 in some variable v. If b² − 4ac = s²,
/// the factor is gcd(av² + bv + c, 2av + b − s).
fn quadratic_factor(polynomial: &Polynomial, budget: &mut Budget) -> Option<Polynomial> {
    if polynomial.len() > QUADRATIC_TERMS || polynomial.len() < 4 {
        return None;
    }
    polynomial.variables().into_iter().find_map(|variable| {
        if polynomial.degree_in(variable) != 2 {
            return None;
        }
        let coefficients = polynomial.coefficients_in(variable);
        let coefficient = |degree: u32| coefficients.get(&degree).cloned().unwrap_or_default();
        let (a, b, c) = (coefficient(2), coefficient(1), coefficient(0));
        let discriminant = &(&b * &b) - &(&a * &c).scale(&Rational::from(4));
        let root = discriminant.square_root()?;
        let twice = (&a * &Polynomial::variable(variable)).scale(&Rational::from(2));
        common_factor(polynomial, &(&(&twice + &b) - &root), budget).filter(|factor| factor != polynomial)
    })
}

fn over_base(polynomial: &Polynomial, base: &[Polynomial]) -> Factored {
    let monomial = polynomial.monomial_content();
    let mut rest = polynomial.div_monomial(&monomial).expect("all terms have it");
    let mut factors = Vec::new();
    for factor in base {
        let mut exponent = 0;
        while rest.len() >= factor.len().min(2)
            && rest.as_constant().is_none()
            && let Some(quotient) = rest.checked_div(factor)
        {
            rest = quotient;
            exponent += 1;
        }
        if exponent > 0 {
            factors.push((factor.clone(), exponent));
        }
    }
    let coefficient = rest.as_constant().unwrap_or_else(Rational::one);
    if rest.as_constant().is_none() {
        factors.push((rest, 1));
    }
    Factored { coefficient, monomial, factors }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::field::Field;
    use crate::kahan::RationalMap;

    fn factors_of(text: &str) -> (Arc<Field>, Vec<Polynomial>, Vec<Factored>) {
        let field = crate::read(&kahan_syntax::lexer::lex(text).tokens).system().expect("a system").field;
        let reduced = RationalMap::of(&field).expect("the field is small").reduced;
        let mut all = reduced.increments;
        all.push(reduced.denominator);
        let factored = factored(&all.iter().collect::<Vec<_>>());
        (field, all, factored)
    }

    fn lengths(factored: &Factored) -> Vec<usize> {
        let mut lengths: Vec<usize> = factored.factors.iter().map(|(factor, _)| factor.len()).collect();
        lengths.sort_unstable();
        lengths
    }

    #[test]
    fn the_product_of_the_factors_is_the_polynomial() {
        for text in [
            "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;",
            "xdot = x*y; ydot = -x^2; zdot = y*(2*x - z);",
            "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);",
            "xdot = x*(1 - y); ydot = y*(x - 1);",
        ] {
            let (_, all, factored) = factors_of(text);
            for (polynomial, factored) in all.iter().zip(&factored) {
                let start = Polynomial::term(factored.monomial.clone(), factored.coefficient.clone());
                let powers =
                    factored.factors.iter().flat_map(|(factor, e)| std::iter::repeat_n(factor, *e as usize));
                assert_eq!(powers.fold(start, |product, factor| &product * factor), *polynomial, "{text}");
            }
        }
    }

    #[test]
    fn the_numerators_of_e6_are_products() {
        let (_, _, factored) = factors_of("xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);");
        let lengths: Vec<Vec<usize>> = factored.iter().map(lengths).collect();
        assert_eq!(lengths, [vec![3, 3], vec![4, 4], vec![3, 3], vec![7]]);
    }

    #[test]
    fn what_coefficients_share_is_a_factor() {
        let (_, _, factored) = factors_of("xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;");
        let lengths: Vec<Vec<usize>> = factored.iter().map(lengths).collect();
        assert_eq!(lengths, [vec![3], vec![3], vec![2, 2], vec![4]]);
    }
}
