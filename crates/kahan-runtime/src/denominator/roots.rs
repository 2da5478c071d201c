//! Tests whether a univariate polynomial has a root in (0, 1]; double roots count.
//!
//! In: coefficients from the constant term upwards; the constant term is nonzero. Out: yes or no.
//! Floats with an error bound decide most cases; a Sturm sequence decides the others.

use kahan_algebra::elimination::MOST_EXPANDED;
use kahan_algebra::rational::Rational;

/// The largest number of coefficients of a tested polynomial.
pub(super) const MAX_COEFFICIENTS: usize = MOST_EXPANDED + 1;

/// The number of bisections after which floats leave a case undecided.
const MAX_HALVINGS: u32 = 12;

/// Returns whether Σ cₖtᵏ has a root in (0, 1]; `None` if an error of at most `error` in its values
/// permits both answers.
///
/// Writes the polynomial in Bernstein form, whose coefficients bound all values on the interval.
/// The first and the last coefficient are the values at the ends.
pub(super) fn has_root_in_floats(coefficients: &[f64], error: f64) -> Option<bool> {
    let mut form = [0.0; MAX_COEFFICIENTS];
    let form = form.get_mut(..coefficients.len())?;
    form.copy_from_slice(coefficients);
    let degree = form.len() - 1;
    let mut binomial = 1.0;
    for (k, entry) in form.iter_mut().enumerate() {
        *entry /= binomial;
        binomial *= (degree - k) as f64 / (k + 1) as f64;
    }
    for round in 1..=degree {
        for j in (round..=degree).rev() {
            form[j] += form[j - 1];
        }
    }
    of_form(form, error, MAX_HALVINGS)
}

fn of_form(form: &mut [f64], error: f64, halvings: u32) -> Option<bool> {
    let sign = |value: f64| i8::from(value > error) - i8::from(value < -error);
    let first = sign(form[0]);
    if first * sign(form[form.len() - 1]) < 0 {
        return Some(true);
    }
    if form.iter().all(|value| sign(*value) == first) {
        return (first != 0).then_some(false);
    }
    let halvings = halvings.checked_sub(1)?;
    // De Casteljau's algorithm bisects the interval: `left` gets the coefficients of the left half,
    // and `form` those of the right half.
    let mut left = [0.0; MAX_COEFFICIENTS];
    let left = &mut left[..form.len()];
    for (k, value) in left.iter_mut().enumerate() {
        *value = form[0];
        for j in 1..form.len() - k {
            form[j - 1] = (form[j - 1] + form[j]) / 2.0;
        }
    }
    Some(of_form(left, error, halvings)? || of_form(form, error, halvings)?)
}

/// Returns whether Σ cₖtᵏ has a root in (0, 1], by a Sturm sequence.
pub(super) fn exactly(coefficients: Vec<Rational>) -> bool {
    let sum = |polynomial: &[Rational]| polynomial.iter().fold(Rational::ZERO, |sum, c| &sum + c);
    let first = trimmed(coefficients);
    if sum(&first).is_zero() {
        return true;
    }
    let slopes = (1..).zip(first.iter().skip(1)).map(|(k, c)| c * &Rational::from(k));
    let mut next = slopes.collect::<Vec<Rational>>();
    let mut chain = vec![first];
    while !next.is_empty() {
        let rest = opposite_of_remainder(chain[chain.len() - 1].clone(), &next);
        chain.push(std::mem::replace(&mut next, rest));
    }
    let changes = |value: &dyn Fn(&[Rational]) -> Rational| {
        let values: Vec<Rational> = chain.iter().map(|own| value(own)).filter(|own| !own.is_zero()).collect();
        values.windows(2).filter(|pair| pair[0].is_negative() != pair[1].is_negative()).count()
    };
    changes(&|own| own[0].clone()) > changes(&sum)
}

fn trimmed(mut polynomial: Vec<Rational>) -> Vec<Rational> {
    while polynomial.last().is_some_and(Rational::is_zero) {
        polynomial.pop();
    }
    polynomial
}

fn opposite_of_remainder(mut polynomial: Vec<Rational>, divisor: &[Rational]) -> Vec<Rational> {
    let leading = &divisor[divisor.len() - 1];
    while let Some(shift) = polynomial.len().checked_sub(divisor.len()) {
        let highest = polynomial.pop().expect("it is as long as the divisor at least");
        let factor = highest.checked_div(leading).expect("a leading coefficient is not zero");
        for (own, by) in polynomial[shift..].iter_mut().zip(divisor) {
            *own = &*own - &(&factor * by);
        }
    }
    trimmed(polynomial).iter().map(|own| -own).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(roots: &[(i64, i64)]) -> (Vec<Rational>, bool) {
        let mut product = vec![Rational::ONE];
        for (above, below) in roots {
            let root = Rational::new(*above, *below);
            let mut next = vec![Rational::ZERO; product.len() + 1];
            for (k, c) in product.iter().enumerate() {
                next[k + 1] = &next[k + 1] + c;
                next[k] = &next[k] - &(c * &root);
            }
            product = next;
        }
        let is_inside = |(above, below): &(i64, i64)| 0 < *above && above <= below;
        (product, roots.iter().any(is_inside))
    }

    const ROOTS: [&[(i64, i64)]; 12] = [
        &[],
        &[(1, 2)],
        &[(1, 1)],
        &[(-1, 2)],
        &[(3, 2), (-1, 3)],
        &[(1, 3), (1, 3)],
        &[(1, 3), (1, 3), (5, 1)],
        &[(1, 1), (1, 1)],
        &[(1, 7), (2, 7), (3, 7), (-1, 9)],
        &[(4, 3), (4, 3), (7, 5), (-2, 1), (9, 1)],
        &[(1001, 1000)],
        &[(1, 2), (1, 2), (1, 2), (1, 2), (1, 2), (1, 2), (1, 2), (1, 2)],
    ];

    #[test]
    fn roots_are_found_where_there_are_some_and_floats_say_no_other() {
        for roots in ROOTS {
            let (coefficients, has_one) = product(roots);
            for sign in [Rational::ONE, -&Rational::ONE] {
                let signed: Vec<Rational> = coefficients.iter().map(|c| c * &sign).collect();
                let floats: Vec<f64> = signed.iter().map(Rational::to_f64).collect();
                let found = has_root_in_floats(&floats, 1e-13);
                assert!(found.is_none_or(|found| found == has_one), "{roots:?}: {found:?}");
                assert_eq!(exactly(signed), has_one, "{roots:?}");
            }
        }
    }

    /// For δ > 0, (t − 1/3)² + δ has no root; for small δ, floats cannot decide this.
    #[test]
    fn a_near_miss_is_no_root() {
        for (bits, is_open) in [(10, false), (70, true)] {
            let delta = Rational::from(2).pow(-bits).expect("2 is not zero");
            let (coefficients, _) = product(&[(1, 3), (1, 3)]);
            for (delta, has_one) in [(delta.clone(), false), (-&delta, true)] {
                let moved: Vec<Rational> =
                    [&coefficients[0] + &delta].into_iter().chain(coefficients[1..].to_vec()).collect();
                let floats: Vec<f64> = moved.iter().map(Rational::to_f64).collect();
                assert_eq!(has_root_in_floats(&floats, 1e-13), (!is_open).then_some(has_one));
                assert_eq!(exactly(moved), has_one);
            }
        }
    }

    #[test]
    fn errors_that_are_no_numbers_leave_all_open() {
        assert_eq!(has_root_in_floats(&[1.0, -2.0], f64::NAN), None);
        assert_eq!(has_root_in_floats(&[f64::INFINITY, f64::NEG_INFINITY], f64::INFINITY), None);
        assert_eq!(has_root_in_floats(&[1.0, -2.0], 1e-13), Some(true));
    }
}
