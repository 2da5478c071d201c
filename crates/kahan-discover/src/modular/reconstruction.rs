//! Reconstructs rational functions over ℚ from values modulo primes.
//!
//! An [`Oracle`] returns values of functions f at values of the unknowns (parameters, ε, and
//! constants of level sets). The degrees of f determine an ansatz N/D, whose coefficients solve the
//! linear equations N = fD at sampled points. The Chinese remainder theorem turns coefficients
//! modulo one or more primes into rational numbers. The result must agree with the oracle at a
//! random point modulo a random prime. Agreement is evidence but no proof.

use kahan_algebra::poly::Variable;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational_function::RationalFunction;

use crate::deadline::Deadline;
use crate::maps::parametric_field::evaluate;
use crate::modular::ansatz::MonomialSupport;
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;
use crate::modular::thiele::{SPARE_POINTS, degree};

/// A function that returns the values of rational functions at given unknowns, or `None` where they
/// are undefined.
pub type Oracle<'a> = dyn FnMut(Modulus, &[u64], &mut SplitMix64) -> Option<Vec<u64>> + 'a;

/// The most points on a line in the space of unknowns, enough for degrees up to about twenty.
const MOST_ON_LINE: usize = 48;

const MOST_PRIMES: usize = 24;

/// The most decimal digits of a numerator or denominator. Each prime exceeds 2⁶⁰, and a numerator
/// gets half of the bits of all primes. The factor 0.301 is log₁₀ 2.
pub(crate) const MOST_DIGITS: usize = MOST_PRIMES * 60 * 301 / 2000;

const MOST_SAMPLES: usize = 8;

/// Reconstructs the oracle's functions over ℚ. In the results, unknown k is `variables[k]`.
///
/// Returns `None` if degrees or coefficients are too large, the deadline passes, or the functions
/// are not rational. If each function has at most m coefficients, each prime needs m + 4 calls of
/// the oracle, and m³ multiplications for each function.
pub fn reconstruct(
    oracle: &mut Oracle<'_>,
    variables: &[Variable],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Vec<RationalFunction>> {
    let mut primes: Vec<(Modulus, Vec<Vec<u64>>)> = Vec::new();
    let mut reconstruction = Reconstruction { oracle, unknowns: variables.len(), random, deadline };
    let mut modulus = Modulus::mersenne_61();
    let shapes = reconstruction.shapes(modulus)?;
    while primes.len() < MOST_PRIMES {
        let coefficients = reconstruction.coefficients(modulus, &shapes)?;
        primes.push((modulus, coefficients));
        modulus = Modulus::random(reconstruction.random);
        let functions: Option<Vec<RationalFunction>> = shapes
            .iter()
            .enumerate()
            .map(|(index, shape)| shape.function(&primes, index, variables))
            .collect();
        if let Some(functions) = functions
            && confirms(reconstruction.oracle, &functions, variables, reconstruction.random, deadline)
        {
            return Some(functions);
        }
    }
    None
}

struct Reconstruction<'a> {
    oracle: &'a mut Oracle<'a>,
    unknowns: usize,
    random: &'a mut SplitMix64,
    deadline: &'a Deadline<'a>,
}

impl Reconstruction<'_> {
    fn point(&mut self, modulus: &Modulus) -> Vec<u64> {
        (0..self.unknowns).map(|_| modulus.sample(self.random)).collect()
    }

    fn sample(&mut self, modulus: Modulus) -> Option<(Vec<u64>, Vec<u64>)> {
        (0..MOST_SAMPLES).find_map(|_| {
            if self.deadline.passed() {
                return None;
            }
            let point = self.point(&modulus);
            let values = (self.oracle)(modulus, &point, self.random)?;
            Some((point, values))
        })
    }

    fn degrees_on_line(&mut self, modulus: Modulus, direction: &[u64]) -> Option<Vec<usize>> {
        let base = self.point(&modulus);
        let (mut points, mut values): (Vec<u64>, Vec<Vec<u64>>) = (Vec::new(), Vec::new());
        let mut wanted = 2 * 2 + 1 + SPARE_POINTS;
        let mut failures = 0;
        loop {
            while points.len() < wanted {
                if self.deadline.passed() || failures > MOST_SAMPLES {
                    return None;
                }
                let t = modulus.sample(self.random);
                let place: Vec<u64> =
                    base.iter().zip(direction).map(|(a, b)| modulus.plus(*a, modulus.times(*b, t))).collect();
                match (self.oracle)(modulus, &place, self.random) {
                    Some(found) => {
                        points.push(t);
                        values.push(found);
                    }
                    None => failures += 1,
                }
            }
            let entries = values[0].len();
            let degrees: Option<Vec<usize>> = (0..entries)
                .map(|entry| {
                    let column: Vec<u64> = values.iter().map(|row| row[entry]).collect();
                    degree(&modulus, &points, &column, self.deadline)
                })
                .collect();
            match degrees {
                Some(degrees) => return Some(degrees),
                None if self.deadline.has_stopped() || wanted >= MOST_ON_LINE => return None,
                None => wanted = (2 * wanted).min(MOST_ON_LINE),
            }
        }
    }

    fn shapes(&mut self, modulus: Modulus) -> Option<Vec<MonomialSupport>> {
        if self.unknowns == 0 {
            let (_, values) = self.sample(modulus)?;
            return Some(values.iter().map(|_| MonomialSupport { monomials: vec![Vec::new()] }).collect());
        }
        let mut by_unknown = Vec::with_capacity(self.unknowns);
        for unknown in 0..self.unknowns {
            let mut direction = vec![0; self.unknowns];
            direction[unknown] = modulus.one();
            by_unknown.push(self.degrees_on_line(modulus, &direction)?);
        }
        let direction = self.point(&modulus);
        let total = self.degrees_on_line(modulus, &direction)?;
        (0..total.len())
            .map(|entry| {
                let bounds: Vec<usize> = by_unknown.iter().map(|degrees| degrees[entry]).collect();
                MonomialSupport::within(&bounds, total[entry])
            })
            .collect()
    }

    /// Returns for each function the coefficients of its numerator, then those of its denominator.
    /// The last nonzero coefficient is 1.
    fn coefficients(&mut self, modulus: Modulus, shapes: &[MonomialSupport]) -> Option<Vec<Vec<u64>>> {
        let wanted = shapes.iter().map(|shape| 2 * shape.monomials.len()).max()? + SPARE_POINTS;
        let mut samples = Vec::with_capacity(wanted);
        for _ in 0..wanted {
            samples.push(self.sample(modulus)?);
        }
        let solve = |(entry, shape): (usize, &MonomialSupport)| {
            let width = 2 * shape.monomials.len();
            let rows = samples[..width + SPARE_POINTS].iter().map(|(point, values)| {
                let own = shape.values(&modulus, point);
                let factor = modulus.opposite(values[entry]);
                let scaled: Vec<u64> = own.iter().map(|&value| modulus.times(value, factor)).collect();
                [own, scaled].concat()
            });
            let null = Echelon::within(&modulus, rows.collect(), width, self.deadline)?.null_space(&modulus);
            match &null[..] {
                [vector] => Some(vector.entries.clone()),
                _ => None,
            }
        };
        shapes.iter().enumerate().map(solve).collect()
    }
}

/// Returns whether `functions` have the oracle's values at a random point modulo a random prime.
pub fn confirms(
    oracle: &mut Oracle<'_>,
    functions: &[RationalFunction],
    variables: &[Variable],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> bool {
    let modulus = Modulus::random(random);
    let mut reconstruction = Reconstruction { oracle, unknowns: variables.len(), random, deadline };
    reconstruction.sample(modulus).is_some_and(|(point, values)| {
        let value = |variable: Variable| {
            let place = variables.iter().position(|known| *known == variable);
            point[place.expect("functions are of these variables")]
        };
        functions.iter().zip(&values).all(|(function, expected)| {
            let above = evaluate(&modulus, function.numerator(), value);
            let below = evaluate(&modulus, function.denominator(), value);
            above.zip(below).is_some_and(|(above, below)| above == modulus.times(*expected, below))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::poly::Polynomial;
    use kahan_algebra::rational::Rational;

    #[test]
    fn rational_functions_come_back_from_their_values() {
        let large = Rational::parse("123456789012345678901/2").unwrap();
        let (a, b) = (Variable(4), Variable(9));
        let mut oracle = |modulus: Modulus, at: &[u64], _: &mut SplitMix64| {
            let seventh = modulus.rational(&Rational::new(1, 7))?;
            let above = modulus.times(modulus.integer(3), modulus.times(modulus.power(at[0], 2), at[1]));
            let below = modulus.inverse(modulus.minus(at[0], at[1]))?;
            Some(vec![modulus.times(modulus.minus(above, seventh), below), modulus.rational(&large)?, 0])
        };
        let found = reconstruct(&mut oracle, &[a, b], &mut SplitMix64::new(2), &Deadline::never()).unwrap();
        let (pa, pb) = (Polynomial::variable(a), Polynomial::variable(b));
        let above =
            (&(&pa * &pa) * &pb).scale(&Rational::from(3)) - Polynomial::constant(Rational::new(1, 7));
        assert_eq!(found[0], RationalFunction::new(above, pa - pb).unwrap());
        assert_eq!(found[1], RationalFunction::constant(large));
        assert!(found[2].is_zero());
    }

    #[test]
    fn what_is_no_rational_function_is_not_lifted() {
        let mut oracle =
            |modulus: Modulus, at: &[u64], _: &mut SplitMix64| Some(vec![modulus.power(at[0], 1 << 30)]);
        assert!(
            reconstruct(&mut oracle, &[Variable(0)], &mut SplitMix64::new(2), &Deadline::never()).is_none()
        );
    }
}
