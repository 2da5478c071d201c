//! The members of a pencil P + cQ that fall apart.
//!
//! An integral P/Q may be written by any two members of its pencil, and those with factors say most
//! in the fewest letters. A polynomial F in two variables s, t of degree d is reducible over the
//! complex numbers, or its square divides it, where ∂(G/F)/∂t = ∂(H/F)/∂s has solutions G, H of
//! degree d − 1 beside the multiples of ∇F (Ruppert, J. reine angew. Math. 369, 1986; Gao, Math.
//! Comp. 72, 2003). For F = Q + cP on a random plane these linear equations are linear in c, and
//! the c for which they have solutions are the roots of a polynomial whose coefficients are
//! rational functions of the parameters and ε: this is reconstructed and factored, so that the
//! numbers of terms of P and Q do not matter. What holds: nothing is claimed here; each member is
//! one of the pencil whatever c is.

use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;

use crate::deadline::Deadline;
use crate::family::evaluate;
use crate::grading::{Grading, reconstruct_graded};
use crate::modulus::Modulus;
use crate::search_field::SearchField;
use crate::space::{over_common, tidy};

/// The products modulo a prime that one search may take: some tenths of a second.
const MOST_WORK: u64 = 200_000_000;

/// The members Q + cP that fall apart, perhaps over a larger field, and those of lower degree, as
/// far as c is a rational function of the parameters and ε; none where that is too much work.
pub(crate) fn special_members(
    searched: &SearchField,
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Vec<Polynomial> {
    found(searched, numerator, denominator).unwrap_or_default()
}

fn found(
    searched: &SearchField,
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Option<Vec<Polynomial>> {
    let symbols = searched.family().symbols();
    let degree = symbols.degree(numerator).max(symbols.degree(denominator)) as usize;
    if degree < 2 || searched.dimension() < 2 {
        return None;
    }
    let columns = (degree * (degree + 1) - 1) as u64;
    let work = columns.pow(4);
    let [above, below] = [numerator, denominator].map(|side| {
        let groups = side.group(|variable| symbols.is_state(variable)).into_iter();
        let powers = |exponents: &[(Variable, u32)]| -> Vec<(usize, u32)> {
            exponents.iter().map(|&(variable, exponent)| (usize::from(variable.0), exponent)).collect()
        };
        groups.map(|(monomial, own)| (powers(monomial.powers()), own)).collect::<Vec<_>>()
    });
    let unknowns = searched.unknown_variables();
    let mut left = MOST_WORK;
    let mut count = None;
    let mut oracle = |modulus: Modulus, values: &[u64], random: &mut SplitMix64| {
        left = left.checked_sub(work)?;
        let plane = Plane::random(modulus, searched.dimension(), degree, random);
        let side = |groups: &[(Vec<(usize, u32)>, Polynomial)]| {
            let terms = groups.iter().map(|(powers, coefficient)| {
                let value = evaluate(&modulus, coefficient, |variable| {
                    unknowns.iter().position(|known| *known == variable).map_or(0, |place| values[place])
                });
                Some((&powers[..], value?))
            });
            terms.collect::<Option<Vec<_>>>().map(|terms| plane.restricted(&terms))
        };
        let roots = spectrum(&modulus, degree, &side(&above)?, &side(&below)?, random)?;
        // Where two of them meet by accident there are fewer.
        (*count.get_or_insert(roots.len()) == roots.len()).then_some(roots)
    };
    let random = &mut SplitMix64::new(59);
    let modulus = Modulus::mersenne_61();
    let values: Vec<u64> = unknowns.iter().map(|_| modulus.sample(random)).collect();
    let count = oracle(modulus, &values, random)?.len();
    if count == 0 {
        return None;
    }
    let weights = searched.weights();
    let weight = |side: &Polynomial| {
        let mut all = side.terms().map(|(monomial, _)| weights.of_monomial(monomial));
        let first = all.next()?;
        all.all(|other| other == first).then_some(first)
    };
    let (above, below) = (weight(numerator)?, weight(denominator)?);
    let entry = |exponent: usize| {
        let factor = Rational::from((count - exponent) as i64);
        below.iter().zip(&above).map(|(below, above)| &(below - above) * &factor).collect()
    };
    let grading = Grading {
        unknowns: unknowns.iter().map(|&unknown| weights.of_variable(unknown)).collect(),
        entries: (0..count).map(entry).collect(),
    };
    let roots = reconstruct_graded(&mut oracle, &unknowns, &grading, random, &Deadline::never())?;
    let (coefficients, leading) = over_common(&roots);
    let c = symbols.variable(Symbol::SecondState(0));
    let power = |exponent: usize| {
        (0..exponent).fold(Polynomial::one(), |product, _| &product * &Polynomial::variable(c))
    };
    let sum = coefficients.iter().chain([&leading]).enumerate();
    let sum = sum.fold(Polynomial::zero(), |sum, (exponent, own)| sum + own * &power(exponent));
    let factors = kahan_factor::factors(&sum, &mut Budget::new(5_000, 5_000_000)).factors;
    let member = |(factor, _): &(Polynomial, u32)| {
        let mut parts = (factor.degree_in(c) == 1).then(|| factor.coefficients_in(c))?;
        let (slope, rest) = (parts.remove(&1)?, parts.remove(&0).unwrap_or_default());
        // c = −rest/slope
        Some(tidy(symbols, &(&(&slope * denominator) - &(&rest * numerator))))
    };
    Some(factors.iter().filter_map(member).collect())
}

/// A random plane: each state an affine function of s and t.
struct Plane {
    modulus: Modulus,
    degree: usize,
    /// By state, then by exponent: its powers, as polynomials of the degree.
    powers: Vec<Vec<Vec<u64>>>,
}

/// Where sᵃtᵇ stands among the coefficients of polynomials of this degree.
fn place(degree: usize, a: usize, b: usize) -> usize {
    a * (degree + 1) + b
}

impl Plane {
    fn random(modulus: Modulus, dimension: usize, degree: usize, random: &mut SplitMix64) -> Self {
        let mut plane = Plane { modulus, degree, powers: Vec::new() };
        for _ in 0..dimension {
            let mut one = vec![0; (degree + 1) * (degree + 1)];
            let mut form = one.clone();
            one[0] = modulus.one();
            for (a, b) in [(0, 0), (0, 1), (1, 0)] {
                form[place(degree, a, b)] = modulus.sample(random);
            }
            let mut powers = vec![one];
            for exponent in 0..degree {
                powers.push(plane.product(&powers[exponent], &form));
            }
            plane.powers.push(powers);
        }
        plane
    }

    /// The product of polynomials whose degrees add up to the plane's at most.
    fn product(&self, left: &[u64], right: &[u64]) -> Vec<u64> {
        let mut product = vec![0; left.len()];
        for (i, &own) in left.iter().enumerate().filter(|(_, own)| **own != 0) {
            for (j, &other) in right.iter().enumerate().filter(|(_, other)| **other != 0) {
                product[i + j] = self.modulus.plus(product[i + j], self.modulus.times(own, other));
            }
        }
        product
    }

    /// Σ value · ∏ states on the plane.
    fn restricted(&self, terms: &[(&[(usize, u32)], u64)]) -> Vec<u64> {
        let mut sum = vec![0; (self.degree + 1) * (self.degree + 1)];
        for (powers, value) in terms {
            let mut term = vec![0; sum.len()];
            term[0] = *value;
            for &(state, exponent) in *powers {
                term = self.product(&term, &self.powers[state][exponent as usize]);
            }
            for (entry, own) in sum.iter_mut().zip(term) {
                *entry = self.modulus.plus(*entry, own);
            }
        }
        sum
    }
}

/// The monic polynomial without its leading 1, lowest coefficient first, of the c for which Q + cP
/// falls apart, each a simple root.
fn spectrum(
    modulus: &Modulus,
    degree: usize,
    above: &[u64],
    below: &[u64],
    random: &mut SplitMix64,
) -> Option<Vec<u64>> {
    let [p, q] = [above, below].map(|side| equations(modulus, degree, side));
    let columns = p.len();
    let mut determinants = Vec::new();
    for _ in 0..2 {
        // As many combinations of the equations as there are unknowns.
        let mixers: Vec<Vec<u64>> =
            (0..columns).map(|_| (0..p[0].len()).map(|_| modulus.sample(random)).collect()).collect();
        let mixed = |side: &[Vec<u64>]| -> Vec<Vec<u64>> {
            mixers
                .iter()
                .map(|mixer| side.iter().map(|column| modulus.dot(mixer, column)).collect())
                .collect()
        };
        let (p, q) = (mixed(&p), mixed(&q));
        let points: Vec<u64> = (0..=columns as u64).map(|value| modulus.integer(value)).collect();
        let values = points.iter().map(|&c| {
            let entry = |(p, q): (&u64, &u64)| modulus.plus(*q, modulus.times(c, *p));
            let rows = p.iter().zip(&q).map(|(p, q)| p.iter().zip(q).map(entry).collect());
            determinant(modulus, rows.collect())
        });
        let values: Vec<u64> = values.collect();
        determinants.push(interpolated(modulus, &points, &values)?);
    }
    let common = gcd(modulus, determinants[0].clone(), determinants[1].clone())?;
    let slope: Vec<u64> = common
        .iter()
        .enumerate()
        .skip(1)
        .map(|(exponent, &own)| modulus.times(modulus.integer(exponent as u64), own))
        .collect();
    let repeated = gcd(modulus, common.clone(), slope).unwrap_or_else(|| vec![modulus.one()]);
    let mut simple = divided(modulus, common, &repeated).0;
    simple.pop();
    Some(simple)
}

/// F ∂G/∂t − G ∂F/∂t − F ∂H/∂s + H ∂F/∂s for each monomial in G and in H of a degree below that of
/// F, but for the highest power of s in G, so that ∇F is no solution.
fn equations(modulus: &Modulus, degree: usize, f: &[u64]) -> Vec<Vec<u64>> {
    let wide = 2 * degree;
    let mut columns = Vec::new();
    for is_first in [true, false] {
        for (i, j) in (0..degree).flat_map(|i| (0..degree - i).map(move |j| (i, j))) {
            if is_first && i + 1 == degree {
                continue;
            }
            let mut column = vec![0; wide * wide];
            for (a, b) in (0..=degree).flat_map(|a| (0..=degree - a).map(move |b| (a, b))) {
                let factor = if is_first { j as i64 - b as i64 } else { a as i64 - i as i64 };
                let value = modulus.times(f[place(degree, a, b)], modulus.integer(factor.unsigned_abs()));
                let value = if factor < 0 { modulus.opposite(value) } else { value };
                if value != 0 {
                    let (s, t) = if is_first { (a + i, b + j - 1) } else { (a + i - 1, b + j) };
                    column[s * wide + t] = modulus.plus(column[s * wide + t], value);
                }
            }
            columns.push(column);
        }
    }
    columns
}

fn determinant(modulus: &Modulus, mut rows: Vec<Vec<u64>>) -> u64 {
    let mut product = modulus.one();
    for column in 0..rows.len() {
        let Some(pivot) = (column..rows.len()).find(|&row| rows[row][column] != 0) else { return 0 };
        if pivot != column {
            rows.swap(pivot, column);
            product = modulus.opposite(product);
        }
        let (upper, lower) = rows.split_at_mut(column + 1);
        let own = &upper[column];
        product = modulus.times(product, own[column]);
        let inverse = modulus.inverse(own[column]).expect("a pivot is not zero");
        for row in lower {
            let factor = modulus.opposite(modulus.times(row[column], inverse));
            for (entry, above) in row[column..].iter_mut().zip(&own[column..]) {
                *entry = modulus.plus(*entry, modulus.times(factor, *above));
            }
        }
    }
    product
}

/// The coefficients, lowest first, of the polynomial with these values (Newton).
fn interpolated(modulus: &Modulus, points: &[u64], values: &[u64]) -> Option<Vec<u64>> {
    let mut differences = values.to_vec();
    for level in 1..points.len() {
        for index in (level..points.len()).rev() {
            let inverse = modulus.inverse(modulus.minus(points[index], points[index - level]))?;
            let rise = modulus.minus(differences[index], differences[index - 1]);
            differences[index] = modulus.times(rise, inverse);
        }
    }
    let mut sum: Vec<u64> = Vec::new();
    for (&point, &own) in points.iter().zip(&differences).rev() {
        // sum · (c − point) + own
        sum.insert(0, own);
        for index in 1..sum.len() {
            sum[index - 1] = modulus.minus(sum[index - 1], modulus.times(point, sum[index]));
        }
    }
    Some(sum)
}

/// The quotient and the rest; the divisor is not 0 and ends with a coefficient that is not 0.
fn divided(modulus: &Modulus, mut above: Vec<u64>, below: &[u64]) -> (Vec<u64>, Vec<u64>) {
    let inverse = modulus.inverse(below[below.len() - 1]).expect("the divisor has its degree");
    let mut quotient = vec![0; (above.len() + 1).saturating_sub(below.len())];
    for shift in (0..quotient.len()).rev() {
        let factor = modulus.times(above[shift + below.len() - 1], inverse);
        quotient[shift] = factor;
        for (index, own) in below.iter().enumerate() {
            above[shift + index] = modulus.minus(above[shift + index], modulus.times(factor, *own));
        }
    }
    (quotient, above)
}

/// The monic greatest common divisor; `None` of 0 and 0.
fn gcd(modulus: &Modulus, mut left: Vec<u64>, mut right: Vec<u64>) -> Option<Vec<u64>> {
    let trim = |side: &mut Vec<u64>| {
        side.truncate(side.iter().rposition(|own| *own != 0).map_or(0, |last| last + 1))
    };
    trim(&mut left);
    trim(&mut right);
    while !right.is_empty() {
        let mut rest = divided(modulus, left, &right).1;
        trim(&mut rest);
        (left, right) = (right, rest);
    }
    let inverse = modulus.inverse(*left.last()?)?;
    Some(left.iter().map(|own| modulus.times(*own, inverse)).collect())
}
