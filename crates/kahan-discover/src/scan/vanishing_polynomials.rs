//! Finds polynomials of low degree in the scanned parameters that vanish only at special grid
//! points, where degrees or ranks are not generic.
//!
//! Simple polynomials come first: those that fix one parameter, then linear polynomials, then those
//! with two monomials. A special point at which an earlier polynomial vanishes does not count for
//! later ones. Coefficients are computed modulo a prime of 61 bits.

use std::collections::BTreeSet;

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;

use crate::modular::matrix::Echelon;
use crate::modular::modulus::{Modulus, rational_from_residue};
use crate::modular::monomials::Monomials;

pub(super) struct Grid {
    /// The values of the parameters, with one row for each point.
    pub(super) points: Vec<Vec<Rational>>,
    pub(super) special: Vec<bool>,
}

/// A polynomial that vanishes only at special points, where degrees or ranks are not generic.
pub(super) struct VanishingPolynomial {
    /// The polynomial, whose variable with index k stands for the scanned parameter k.
    pub(super) polynomial: Polynomial,
    /// The indices of the special points at which the polynomial vanishes.
    pub(super) points: Vec<usize>,
}

/// The number of zeros required beyond the number of coefficients of a polynomial.
const SPARE_POINTS: usize = 2;
/// A polynomial with c coefficients and z zeros at special points is rejected if p^(z − c) exceeds
/// this. Here p is the fraction of points that are special.
const MAX_COINCIDENCE_PROBABILITY: f64 = 0.01;
/// The number of random sets of special points. For each set, a linear polynomial is tried.
const POINT_CHOICES: usize = 3000;
const MOST_NAMES: usize = 4;
const HIGHEST_DEGREE: u32 = 3;
const LARGEST: u64 = 1000;
/// The largest number of special points from which candidates are made.
const MOST_POINTS: usize = 600;

/// Finds polynomials that vanish at special points, the simplest first. Special points at which a
/// polynomial of `known` vanishes do not count.
pub(super) fn vanishing_polynomials(grid: &Grid, known: &[VanishingPolynomial]) -> Vec<VanishingPolynomial> {
    let mut search = Search::new(grid);
    search.open.retain(|at| known.iter().all(|shape| !shape.points.contains(at)));
    search.single_values();
    search.linear();
    search.two_monomials();
    search.found
}

struct Search<'a> {
    grid: &'a Grid,
    modulus: Modulus,
    residues: Vec<Vec<u64>>,
    /// The indices of the parameters with more than one value.
    names: Vec<usize>,
    /// The indices of the special points at which no polynomial found so far vanishes.
    open: Vec<usize>,
    found: Vec<VanishingPolynomial>,
}

impl<'a> Search<'a> {
    fn new(grid: &'a Grid) -> Self {
        let modulus = Modulus::mersenne_61();
        let residue = |value: &Rational| modulus.rational(value).unwrap_or_default();
        let residues = grid.points.iter().map(|point| point.iter().map(residue).collect()).collect();
        let count = grid.points.first().map_or(0, Vec::len);
        let varies = |&k: &usize| grid.points.iter().any(|point| point[k] != grid.points[0][k]);
        let names = (0..count).filter(varies).collect();
        let open = (0..grid.points.len()).filter(|&index| grid.special[index]).collect();
        Search { grid, modulus, residues, names, open, found: Vec::new() }
    }

    fn single_values(&mut self) {
        for name in self.names.clone() {
            let values: BTreeSet<Rational> =
                self.open.iter().map(|&at| self.grid.points[at][name].clone()).collect();
            for value in values {
                let polynomial = &Polynomial::variable(variable(name)) - &Polynomial::constant(value);
                self.admit(polynomial, 1);
            }
        }
    }

    /// Tries linear polynomials through random special points that are no zeros of earlier
    /// polynomials. Polynomials in few parameters come first.
    fn linear(&mut self) {
        let mut random = SplitMix64::new(0);
        for size in 2..=self.names.len().min(MOST_NAMES) {
            for names in subsets(&self.names, size) {
                let mut tried = BTreeSet::new();
                for _ in 0..POINT_CHOICES {
                    if self.open.len() < size + SPARE_POINTS {
                        return;
                    }
                    let chosen: Vec<usize> =
                        (0..size).map(|_| self.open[sample(&mut random, self.open.len())]).collect();
                    let Some(entries) = self.plane(&names, &chosen) else { continue };
                    if tried.insert(entries.clone())
                        && let Some(polynomial) = self.linear_polynomial(&names, &entries)
                    {
                        self.admit(polynomial, size);
                    }
                }
            }
        }
    }

    fn plane(&self, names: &[usize], points: &[usize]) -> Option<Vec<u64>> {
        let echelon = self.affine(names, points);
        let [vector] = &echelon.null_space(&self.modulus)[..] else { return None };
        vector.entries[1..].iter().all(|entry| *entry != 0).then(|| vector.entries.clone())
    }

    fn affine(&self, names: &[usize], points: &[usize]) -> Echelon {
        let row = |&at: &usize| {
            let values = names.iter().map(|&name| self.residues[at][name]);
            std::iter::once(self.modulus.one()).chain(values).collect()
        };
        Echelon::of(&self.modulus, points.iter().map(row).collect(), names.len() + 1)
    }

    fn linear_polynomial(&self, names: &[usize], entries: &[u64]) -> Option<Polynomial> {
        let monomials =
            std::iter::once(Monomial::one()).chain(names.iter().map(|&k| Monomial::variable(variable(k))));
        let coefficients =
            entries.iter().map(|entry| self.small_rational(*entry)).collect::<Option<Vec<_>>>()?;
        Some(Polynomial::from_terms(monomials.zip(coefficients)).primitive_part())
    }

    /// Tries equations m = c m′ for coprime monomials m and m′. The number c is the most frequent
    /// value of m/m′ at special points where no polynomial found so far vanishes.
    fn two_monomials(&mut self) {
        let monomials = Monomials::new(self.names.len(), HIGHEST_DEGREE);
        let mut pairs: Vec<(usize, usize)> = (0..monomials.len())
            .flat_map(|high| (0..high).map(move |low| (high, low)))
            .filter(|&(high, low)| {
                let both = monomials.exponents(high).iter().zip(monomials.exponents(low));
                both.clone().all(|(a, b)| *a == 0 || *b == 0)
                    && both.filter(|(a, b)| **a + **b > 0).count() > 1
            })
            .collect();
        let degree = |index: usize| monomials.exponents(index).iter().sum::<u32>();
        pairs.sort_by_key(|&(high, low)| degree(high) + degree(low));
        for (high, low) in pairs {
            if let Some(quotient) = self.usual_quotient(&monomials, high, low) {
                let written = |index: usize| -> Monomial {
                    let exponents = self.names.iter().zip(monomials.exponents(index));
                    exponents.map(|(&name, &exponent)| (variable(name), exponent)).collect()
                };
                let terms = [(written(high), Rational::one()), (written(low), -&quotient)];
                self.admit(Polynomial::from_terms(terms).primitive_part(), 2);
            }
        }
    }

    fn usual_quotient(&self, monomials: &Monomials, high: usize, low: usize) -> Option<Rational> {
        let chosen = self.open.iter().take(MOST_POINTS);
        let mut quotients: Vec<u64> = chosen
            .filter_map(|&at| {
                let point: Vec<u64> = self.names.iter().map(|&name| self.residues[at][name]).collect();
                let value = |index: usize| self.modulus.monomial(monomials.exponents(index), &point);
                let quotient = self.modulus.times(value(high), self.modulus.inverse(value(low))?);
                (quotient != 0).then_some(quotient)
            })
            .collect();
        quotients.sort_unstable();
        let runs = quotients.chunk_by(|a, b| a == b);
        let longest = runs.max_by_key(|run| run.len()).filter(|run| run.len() > SPARE_POINTS)?;
        self.small_rational(longest[0])
    }

    fn small_rational(&self, residue: u64) -> Option<Rational> {
        let value =
            rational_from_residue(&self.modulus.residue(residue).into(), &self.modulus.prime().into())?;
        let is_small =
            |text: &str| text.trim_start_matches('-').parse().is_ok_and(|size: u64| size <= LARGEST);
        value.to_string().split('/').all(is_small).then_some(value)
    }

    /// Accepts a polynomial if it vanishes at special points only, and at enough of them where no
    /// earlier polynomial vanishes.
    fn admit(&mut self, polynomial: Polynomial, coefficients: usize) {
        let modulus = self.modulus;
        let terms: Vec<(Monomial, u64)> = polynomial
            .terms()
            .map(|(monomial, value)| (monomial.clone(), modulus.rational(value).unwrap_or_default()))
            .collect();
        let vanishes = |at: &usize| {
            let value = terms.iter().fold(0, |sum, (monomial, coefficient)| {
                let product = monomial.powers().iter().fold(*coefficient, |product, &(name, exponent)| {
                    let value = self.residues[*at][usize::from(name.0)];
                    modulus.times(product, modulus.power(value, exponent))
                });
                modulus.plus(sum, product)
            });
            value == 0
        };
        let own: Vec<usize> = self.open.iter().copied().filter(vanishes).collect();
        if own.len() < coefficients + SPARE_POINTS {
            return;
        }
        let linear = usize::from(polynomial.degree() == 1);
        let rank = self.affine(&self.names, &own).rank();
        if rank + linear < self.names.len() + 1 {
            return;
        }
        let points: Vec<usize> = (0..self.grid.points.len()).filter(vanishes).collect();
        let ordinary = self.grid.special.iter().filter(|special| !**special).count();
        let share = self.open.len() as f64 / (self.open.len() + ordinary) as f64;
        let is_chance = libm::pow(share, (own.len() - coefficients) as f64) > MAX_COINCIDENCE_PROBABILITY;
        if is_chance || points.iter().any(|&at| !self.grid.special[at]) {
            return;
        }
        self.open.retain(|at| !own.contains(at));
        self.found.push(VanishingPolynomial { polynomial, points });
    }
}

fn variable(name: usize) -> Variable {
    Variable(u16::try_from(name).expect("a grid has few names"))
}

fn sample(random: &mut SplitMix64, count: usize) -> usize {
    usize::try_from(random.below(count as u64)).expect("it is less than a usize")
}

fn subsets(of: &[usize], size: usize) -> Vec<Vec<usize>> {
    if size == 0 {
        return vec![Vec::new()];
    }
    (0..of.len())
        .flat_map(|first| {
            subsets(&of[first + 1..], size - 1).into_iter().map(move |rest| [vec![of[first]], rest].concat())
        })
        .collect()
}
