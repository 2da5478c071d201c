//! Computes the square-free decomposition f = ∏ fₖ^k, where the fₖ are square-free and pairwise
//! coprime (Yun, "On square-free decomposition algorithms", SYMSAC 1976).

use kahan_algebra::poly::{Budget, OverBudget, Polynomial, Variable, gcd_all_within, gcd_within};

/// Decomposes a primitive polynomial. A short budget may leave factors that are not square-free.
pub(super) fn square_free(polynomial: &Polynomial, budget: &mut Budget) -> Vec<(Polynomial, u32)> {
    let Some(main) = polynomial.variables().into_iter().min_by_key(|v| polynomial.degree_in(*v)) else {
        return Vec::new();
    };
    let Ok((content, rest)) = content_and_rest(polynomial, main, budget) else {
        return vec![(polynomial.clone(), 1)];
    };
    let mut factors = square_free_by_yun(&rest, main, budget).unwrap_or_else(|_| vec![(rest, 1)]);
    factors.extend(square_free(&content, budget));
    factors
}

fn content_and_rest(
    polynomial: &Polynomial,
    main: Variable,
    budget: &mut Budget,
) -> Result<(Polynomial, Polynomial), OverBudget> {
    let content = gcd_all_within(polynomial.coefficients_in(main).values(), budget)?;
    let rest = polynomial.div_within(&content, budget)?.expect("a content divides");
    Ok((content, rest.primitive_part()))
}

pub(super) fn square_free_by_yun(
    polynomial: &Polynomial,
    main: Variable,
    budget: &mut Budget,
) -> Result<Vec<(Polynomial, u32)>, OverBudget> {
    let derivative = polynomial.derivative(main);
    let repeated = gcd_within(polynomial, &derivative, budget)?;
    if repeated.is_one() {
        return Ok(vec![(polynomial.clone(), 1)]);
    }
    let quotient = |a: &Polynomial, b: &Polynomial, budget: &mut Budget| {
        Ok(a.div_within(b, budget)?.expect("a common divisor divides"))
    };
    // Write ∏ fᵢⁱ for the polynomial and fᵢ′ for the derivatives by `main`. Before step k, `left`
    // is ∏_{i≥k} fᵢ and `slope` is Σ_{i≥k} (i − k + 1)·fᵢ′·∏_{j≥k, j≠i} fⱼ.
    let mut left = quotient(polynomial, &repeated, budget)?;
    let mut slope = quotient(&derivative, &repeated, budget)?;
    let mut factors = Vec::new();
    for exponent in 1.. {
        if left.as_constant().is_some() {
            break;
        }
        let rest = &slope - &left.derivative(main);
        let factor = gcd_within(&left, &rest, budget)?;
        left = quotient(&left, &factor, budget)?;
        slope = quotient(&rest, &factor, budget)?;
        if factor.as_constant().is_none() {
            factors.push((factor, exponent));
        }
    }
    Ok(factors)
}
