//! Computes greatest common divisors of multivariate polynomials over ℚ.
//!
//! Monomials are divided out first. Images modulo a prime then bound the degree of the gcd in each
//! variable. Often the bounds prove that the gcd is 1, or that variables do not occur in it.
//! Otherwise trial division or the subresultant remainder sequence finds the gcd. All results are
//! exact. The prime affects only the speed.

use kahan_syntax::rational::Rational;
use kahan_syntax::table::{Table, sorted_by_key};

use super::images::degree_bounds;
use super::{Budget, Monomial, Polynomial, Variable, WithinBudget};

/// Returns the greatest common divisor, which is primitive with positive leading coefficient. The
/// gcd of 0 and b is the primitive part of b.
///
/// # Panics
/// If a total degree exceeds 2^24 during the computation.
pub fn gcd(a: &Polynomial, b: &Polynomial) -> Polynomial {
    gcd_within(a, b, &mut Budget::unlimited()).expect("within no limit")
}

/// Returns the [`gcd`], or an error if the budget is spent.
pub fn gcd_within(a: &Polynomial, b: &Polynomial, budget: &mut Budget) -> WithinBudget<Polynomial> {
    if a.is_zero() || b.is_zero() {
        return Ok((if a.is_zero() { b } else { a }).primitive_part());
    }
    let (monomial_a, monomial_b) = (a.monomial_content(), b.monomial_content());
    let common = monomial_a.gcd(&monomial_b);
    if a.len() == 1 || b.len() == 1 {
        return Ok(Polynomial::term(common, Rational::ONE));
    }
    let stripped_a = without_monomial(a, &monomial_a);
    let stripped_b = without_monomial(b, &monomial_b);
    Ok(gcd_stripped(&stripped_a, &stripped_b, budget)?.mul_monomial(&common))
}

/// Returns the gcd of all polynomials, which is 0 if there are none. The computation stops when the
/// gcd is 1.
///
/// # Panics
/// If a total degree exceeds 2^24 during the computation.
pub fn gcd_all<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Polynomial {
    gcd_all_within(polynomials, &mut Budget::unlimited()).expect("within no limit")
}

/// Returns [`gcd_all`], or an error if the budget is spent.
pub fn gcd_all_within<'a>(
    polynomials: impl IntoIterator<Item = &'a Polynomial>,
    budget: &mut Budget,
) -> WithinBudget<Polynomial> {
    let shortest_first = sorted_by_key(polynomials, |polynomial| polynomial.len());
    let mut common = Polynomial::zero();
    for polynomial in shortest_first {
        common = gcd_within(&common, polynomial, budget)?;
        if common.is_one() {
            break;
        }
    }
    Ok(common)
}

fn without_monomial(polynomial: &Polynomial, monomial: &Monomial) -> Polynomial {
    polynomial.div_monomial(monomial).expect("the monomial content divides every term").primitive_part()
}

fn gcd_stripped(a: &Polynomial, b: &Polynomial, budget: &mut Budget) -> WithinBudget<Polynomial> {
    if a == b {
        return Ok(a.clone());
    }
    let mut bounds = degree_bounds(a, b, budget)?;
    bounds.retain(|_, bound| *bound > 0);
    if bounds.is_empty() {
        return Ok(Polynomial::one());
    }
    if !a.variables().iter().chain(&b.variables()).all(|variable| bounds.contains_key(variable)) {
        return gcd_of_coefficients(a, b, &bounds, budget);
    }
    for (divisor, multiple) in [(a, b), (b, a)] {
        let fits = bounds.iter().all(|(variable, bound)| divisor.degree_in(*variable) == *bound);
        if fits && multiple.div_within(divisor, budget)?.is_some() {
            return Ok(divisor.clone());
        }
    }
    gcd_in_main_variable(a, b, &bounds, budget)
}

/// Computes gcd(a, b), provided that it contains only variables in `bounds`. Then it is the gcd of
/// the coefficients of a and b as polynomials in all other variables.
fn gcd_of_coefficients(
    a: &Polynomial,
    b: &Polynomial,
    bounds: &Table<Variable, u32>,
    budget: &mut Budget,
) -> WithinBudget<Polynomial> {
    let outside = |variable| !bounds.contains_key(&variable);
    let (groups_a, groups_b) = (a.group(outside), b.group(outside));
    gcd_all_within(groups_a.values().chain(groups_b.values()), budget)
}

/// Computes gcd(a, b) as the gcd of the contents times the gcd of the primitive parts. Here a and b
/// are polynomials in the variable of least degree.
fn gcd_in_main_variable(
    a: &Polynomial,
    b: &Polynomial,
    bounds: &Table<Variable, u32>,
    budget: &mut Budget,
) -> WithinBudget<Polynomial> {
    let degree = |variable: Variable| a.degree_in(variable).min(b.degree_in(variable));
    let (&main, &bound) =
        bounds.iter().min_by_key(|(variable, _)| degree(**variable)).expect("some variable is left");
    let content_a = gcd_all_within(a.coefficients_in(main).values(), budget)?;
    let content_b = gcd_all_within(b.coefficients_in(main).values(), budget)?;
    if content_a.is_one() && content_b.is_one() {
        return subresultants(a, b, main, bound, budget);
    }
    let contents = gcd_within(&content_a, &content_b, budget)?;
    let rest_a = a.div_within(&content_a, budget)?.expect("a content divides");
    let rest_b = b.div_within(&content_b, budget)?.expect("a content divides");
    let parts = gcd_within(&rest_a, &rest_b, budget)?;
    Ok(contents.mul_within(&parts, budget)?.primitive_part())
}

/// Computes the gcd of a and b, which must be primitive in `main`. The degree of the gcd is at most
/// `bound`.
///
/// The method is Algorithm C of Knuth, The Art of Computer Programming 4.6.1. The gcd divides the
/// primitive part of every remainder. If such a primitive part divides a and b, it is the gcd.
fn subresultants(
    a: &Polynomial,
    b: &Polynomial,
    main: Variable,
    bound: u32,
    budget: &mut Budget,
) -> WithinBudget<Polynomial> {
    let (mut upper, mut lower) =
        if a.degree_in(main) >= b.degree_in(main) { (a.clone(), b.clone()) } else { (b.clone(), a.clone()) };
    let (mut lead, mut scale) = (Polynomial::one(), Polynomial::one());
    loop {
        let degree = lower.degree_in(main);
        if degree == 0 {
            return Ok(Polynomial::one());
        }
        if degree <= bound {
            let candidate = primitive_in(&lower, main, budget)?;
            if a.div_within(&candidate, budget)?.is_some() && b.div_within(&candidate, budget)?.is_some() {
                return Ok(candidate);
            }
        }
        let gap = upper.degree_in(main) - degree;
        let remainder = pseudo_remainder(&upper, &lower, main, budget)?;
        if remainder.is_zero() {
            return primitive_in(&lower, main, budget);
        }
        let divisor = lead.mul_within(&scale.pow_within(gap, budget)?, budget)?;
        let next = remainder.div_within(&divisor, budget)?.expect("subresultants divide exactly");
        upper = std::mem::replace(&mut lower, next.primitive_part());
        lead = upper.leading_coefficient_in(main);
        // Replaces `scale`, Knuth's h, by g^δ h^(1−δ) up to a rational factor, for g = `lead` and
        // δ = `gap`.
        if gap > 0 {
            let numerator = lead.pow_within(gap, budget)?;
            let denominator = scale.pow_within(gap - 1, budget)?;
            scale = numerator.div_within(&denominator, budget)?.expect("subresultants divide exactly");
        }
    }
}

/// Returns the remainder of lc^(δ+1)·dividend by `divisor`. Here lc is the leading coefficient of
/// `divisor`, and δ is the difference of degrees.
fn pseudo_remainder(
    dividend: &Polynomial,
    divisor: &Polynomial,
    main: Variable,
    budget: &mut Budget,
) -> WithinBudget<Polynomial> {
    let degree = divisor.degree_in(main);
    let lead = divisor.leading_coefficient_in(main);
    let mut rest = dividend.clone();
    let mut steps_left = (dividend.degree_in(main) + 1).saturating_sub(degree);
    while !rest.is_zero() && rest.degree_in(main) >= degree {
        let shift = Monomial::power(main, rest.degree_in(main) - degree);
        let subtrahend = rest.leading_coefficient_in(main).mul_within(divisor, budget)?.mul_monomial(&shift);
        rest = lead.mul_within(&rest, budget)? - subtrahend;
        budget.admit(rest.len())?;
        steps_left -= 1;
    }
    rest.mul_within(&lead.pow_within(steps_left, budget)?, budget)
}

/// Makes the polynomial primitive in `main`, with coprime integer coefficients.
fn primitive_in(polynomial: &Polynomial, main: Variable, budget: &mut Budget) -> WithinBudget<Polynomial> {
    let content = gcd_all_within(polynomial.coefficients_in(main).values(), budget)?;
    let primitive = polynomial.div_within(&content, budget)?.expect("a content divides");
    Ok(primitive.primitive_part())
}
