//! Lifts factors of a polynomial in x and y from y = point to all y (Hensel's lemma).
//!
//! The lift works with monic polynomials in x whose coefficients are power series in t = y − point.
//! At the end each monic factor is multiplied by a polynomial in y that makes the series
//! polynomials (Geddes, Czapor and Labahn, Algorithms for Computer Algebra, 1992, section 6.6).
//! Powers of factors are lifted as a whole, and roots are taken at the end.

use kahan_algebra::prime_field::PrimeField;

use super::dense::{self, Dense};

/// The coefficients of a polynomial in x and y. Row i holds the coefficient of xⁱ, which is a
/// polynomial in y or in t = y − point.
pub(super) type BivariateCoefficients = Vec<Vec<u64>>;

pub(super) struct LiftingProblem<'a> {
    /// The polynomial to factor, or its product with a polynomial in y. All rows have equal length.
    pub(super) whole: &'a BivariateCoefficients,
    pub(super) factors: &'a [(Dense, u32)],
    /// For each factor: a multiple of its leading coefficient, by powers of y. Each multiple has as
    /// many entries as a row of `whole`.
    pub(super) multipliers: &'a [Dense],
    pub(super) point: u64,
}

/// Lifts each factor to a polynomial in x and y whose leading coefficient is the factor's
/// multiplier. Returns `None` if the leading coefficient of `whole` is 0 at y = `point`, or if two
/// factors have a common root there.
pub(super) fn lift(field: PrimeField, question: &LiftingProblem<'_>) -> Option<Vec<BivariateCoefficients>> {
    let LiftingProblem { whole, factors, multipliers, point } = question;
    let len = whole[0].len();
    let shifted: BivariateCoefficients = whole.iter().map(|row| shift(field, row, *point)).collect();
    let unit = reciprocal(field, shifted.last()?)?;
    let monic: BivariateCoefficients =
        shifted.iter().map(|row| dense::product_to(field, row, &unit, len)).collect();
    let mut powers: Vec<Dense> = Vec::new();
    for (factor, exponent) in *factors {
        let factor = dense::monic(field, factor);
        powers.push((0..*exponent).fold(vec![1], |power, _| dense::product(field, &power, &factor)));
    }
    let lifted = lift_monic(field, &monic, powers)?;
    let mut results = Vec::new();
    for ((lifted, (_, exponent)), multiplier) in lifted.into_iter().zip(*factors).zip(*multipliers) {
        let degree = lifted[0].len() - 1;
        let root = root(field, transposed(&lifted, degree + 1), *exponent, len)?;
        let multiplier = shift(field, multiplier, *point);
        let back = field.neg(*point);
        let row = |row: &Dense| shift(field, &dense::product_to(field, row, &multiplier, len), back);
        results.push(root.iter().map(row).collect());
    }
    Some(results)
}

/// Lifts monic factors from t = 0. Returns the coefficients of each factor by powers of t. The
/// coefficients are polynomials in x.
fn lift_monic(
    field: PrimeField,
    whole: &BivariateCoefficients,
    factors: Vec<Dense>,
) -> Option<Vec<Vec<Dense>>> {
    let by_t = transposed(whole, whole[0].len());
    let inverses = dense::partial_fractions(field, &factors)?;
    // The entry products[i] is the product of the factors 0 to i.
    let mut products: Vec<Vec<Dense>> = Vec::new();
    for factor in &factors {
        let one = vec![1];
        let before = products.last().map_or(&one, |product| &product[0]);
        products.push(vec![dense::product(field, before, factor)]);
    }
    if products.last()?[0] != by_t[0] {
        return None;
    }
    let mut lifted: Vec<Vec<Dense>> = factors.into_iter().map(|factor| vec![factor]).collect();
    for step in 1..by_t.len() {
        for index in 0..lifted.len() {
            let mut sums = vec![0; whole.len()];
            if index > 0 {
                for other in 1..=step {
                    let factor = &lifted[index][step - other];
                    dense::add_product(field, &mut sums, &products[index - 1][other], factor);
                }
            }
            products[index].push(dense::reduced(field, &sums));
        }
        let error = dense::difference(field, &by_t[step], &products[lifted.len() - 1][step]);
        let mut before: Dense = Vec::new();
        for index in 0..lifted.len() {
            let image = lifted[index][0].clone();
            let digit = dense::remainder(field, &dense::product(field, &error, &inverses[index]), &image);
            let mut sums = vec![0; whole.len()];
            dense::add_product(field, &mut sums, &before, &image);
            match index {
                0 => dense::add_product(field, &mut sums, &digit, &[1]),
                _ => dense::add_product(field, &mut sums, &products[index - 1][0], &digit),
            }
            before = dense::trimmed(dense::reduced(field, &sums));
            for (own, &more) in products[index][step].iter_mut().zip(&before) {
                *own = field.add(*own, more);
            }
            lifted[index].push(digit);
        }
    }
    Some(lifted)
}

fn transposed(rows: &[Dense], columns: usize) -> BivariateCoefficients {
    let column = |place: usize| rows.iter().map(|row| row.get(place).copied().unwrap_or(0)).collect();
    (0..columns).map(column).collect()
}

/// Returns the monic polynomial in x whose k-th power is `power`, where k is `exponent`.
///
/// Let h₀ = 1, h₁, … and r₀ = 1, r₁, … be the coefficients of `power` and of the root, leading ones
/// first. Then m·rₘ = Σ_{l=1..m} (l/k − (m − l))·hₗ·r_{m−l} (Knuth, The Art of Computer Programming
/// 4.7).
fn root(
    field: PrimeField,
    power: BivariateCoefficients,
    exponent: u32,
    len: usize,
) -> Option<BivariateCoefficients> {
    if exponent == 1 {
        return Some(power);
    }
    let alpha = field.inverse(u64::from(exponent) % field.prime())?;
    let degree = (power.len() - 1) / exponent as usize;
    let mut root: BivariateCoefficients = vec![power[power.len() - 1].clone()];
    for m in 1..=degree {
        let mut sums = vec![0; len];
        for l in 1..=m {
            let weight = field.sub(field.mul(alpha, l as u64), (m - l) as u64);
            let scaled = scaled(field, &power[power.len() - 1 - l], weight);
            dense::add_product(field, &mut sums, &scaled, &root[m - l]);
        }
        let unit = field.inverse(m as u64)?;
        root.push(scaled(field, &dense::reduced(field, &sums), unit));
    }
    root.reverse();
    Some(root)
}

fn scaled(field: PrimeField, row: &[u64], factor: u64) -> Dense {
    row.iter().map(|&value| field.mul(value, factor)).collect()
}

/// Returns the coefficients of the polynomial a(y + c) with c = `by`.
fn shift(field: PrimeField, a: &[u64], by: u64) -> Dense {
    let mut shifted = a.to_vec();
    for done in 0..a.len() {
        for place in (done + 1..a.len()).rev() {
            shifted[place - 1] = field.add(shifted[place - 1], field.mul(shifted[place], by));
        }
    }
    shifted
}

/// Returns the first `a.len()` coefficients of the power series 1/a. Returns `None` if a(0) = 0.
fn reciprocal(field: PrimeField, a: &[u64]) -> Option<Dense> {
    let unit = field.inverse(*a.first()?)?;
    let mut inverse = vec![unit];
    for step in 1..a.len() {
        let known: Dense = inverse.iter().rev().copied().collect();
        let sum = dense::dot(field, &a[1..=step], &known);
        inverse.push(field.mul(field.neg(sum), unit));
    }
    Some(inverse)
}
