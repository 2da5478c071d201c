//! Jets of a curve (or surface) modulo a prime, which are followed through poles.
//!
//! A generic point of the curve is moved by δ in a random direction. The map acts on homogeneous
//! coordinates [X : W], which are power series in δ. After every step, common powers of δ cancel.
//! At δ = 0 the result is the image of the point. The vectors of this image and of its derivatives
//! along the curve span a vector space, whose dimension is that of the curve's image plus 1.

use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::symbols::{Symbol, Symbols};

use super::roots::root;
use super::series::Series;
use crate::maps::parametric_field::evaluate;
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;

/// Homogeneous polynomials at sampled parameters and ε. The terms are c · ∏ Xᵢ^eᵢ, where the last
/// exponent is that of W.
pub(crate) struct Homogeneous {
    modulus: Modulus,
    components: Vec<Vec<(u64, Vec<u32>)>>,
    degree: u32,
}

/// A point of a curve in homogeneous coordinates, W last, with a basis of the tangent vectors.
pub(crate) struct CurvePoint {
    point: Vec<u64>,
    tangents: Vec<Vec<u64>>,
}

/// The image of a curve after some steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// The dimension of the image. In n variables, the curve itself has the dimension n − 1.
    pub dimension: usize,
    /// Whether the image lies at infinity.
    pub is_infinite: bool,
    /// The power of δ that cancelled from all homogeneous coordinates in the last step. The first
    /// point was moved by δ off the curve.
    pub shared: usize,
    /// For each followed curve, the order in δ to which its polynomial vanishes at this image.
    pub contacts: Vec<usize>,
}

/// The reason why the image of a curve is unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoImage {
    /// All computed coefficients of a power series vanish, so longer series are needed.
    TooShort,
    SpecialPoint,
}

/// The names of states and parameters, and the values of the parameters and of ε.
pub(crate) struct Values<'a> {
    pub(crate) symbols: &'a Symbols,
    pub(crate) parameters: &'a [u64],
    pub(crate) eps: u64,
}

impl Values<'_> {
    /// Returns for each term of a polynomial in the states its coefficient modulo the prime and its
    /// exponents.
    fn terms(&self, modulus: &Modulus, polynomial: &Polynomial) -> Option<Vec<(u64, Vec<u32>)>> {
        let value = |variable: Variable| match self.symbols.symbol(variable) {
            Symbol::Parameter(k) => self.parameters[k],
            Symbol::Epsilon => self.eps,
            _ => 0,
        };
        let mut terms = Vec::new();
        for (monomial, coefficient) in polynomial.group(|variable| self.symbols.is_state(variable)) {
            let exponents = (0..self.symbols.dimension()).map(|i| monomial.exponent(self.symbols.state(i)));
            terms.push((evaluate(modulus, &coefficient, value)?, exponents.collect()));
        }
        Some(terms)
    }
}

impl Homogeneous {
    /// Makes the numerators and the denominator of a map homogeneous of equal degree.
    pub(crate) fn map(modulus: Modulus, components: &[Polynomial], values: &Values<'_>) -> Option<Self> {
        let degree = components.iter().map(|component| values.symbols.degree(component)).max()?;
        Self::of(modulus, components, values, |_| degree)
    }

    /// Makes each curve homogeneous in its own degree. Appends the coordinate W, whose zeros are
    /// the points at infinity.
    pub(crate) fn curves(modulus: Modulus, curves: &[Polynomial], values: &Values<'_>) -> Option<Self> {
        let mut all = Self::of(modulus, curves, values, |curve| values.symbols.degree(curve))?;
        let exponents = (0..=values.symbols.dimension()).map(|i| u32::from(i == values.symbols.dimension()));
        all.components.push(vec![(modulus.one(), exponents.collect())]);
        all.degree = all.degree.max(1);
        Some(all)
    }

    fn of(
        modulus: Modulus,
        polynomials: &[Polynomial],
        values: &Values<'_>,
        degree: impl Fn(&Polynomial) -> u32,
    ) -> Option<Self> {
        let mut components = Vec::with_capacity(polynomials.len());
        for polynomial in polynomials {
            let mut terms = values.terms(&modulus, polynomial)?;
            for (_, exponents) in &mut terms {
                exponents.push(degree(polynomial) - exponents.iter().sum::<u32>());
            }
            components.push(terms);
        }
        Some(Homogeneous { modulus, components, degree: polynomials.iter().map(degree).max().unwrap_or(0) })
    }

    /// Returns the images of the curve after 1, 2, … `steps` steps. Power series in δ have `length`
    /// coefficients.
    pub(crate) fn follow(
        &self,
        place: &CurvePoint,
        curves: &Homogeneous,
        steps: usize,
        length: usize,
        random: &mut SplitMix64,
    ) -> Result<Vec<Image>, NoImage> {
        let mut jet = self.moved(place, length, random);
        let mut images = Vec::with_capacity(steps);
        for _ in 0..steps {
            let next = self.values(&jet);
            let shared = next.iter().filter_map(Series::order).min().ok_or(NoImage::TooShort)?;
            let divided: Option<_> = next.into_iter().map(|series| series.divided(shared)).collect();
            jet = divided.ok_or(NoImage::SpecialPoint)?;
            let columns: Vec<Vec<u64>> = jet.iter().map(Series::leading).collect();
            let is_infinite = columns.last().is_some_and(|last| last[0] == 0);
            let width = columns[0].len();
            let dimension = Echelon::of(&self.modulus, columns, width).rank() - 1;
            let contacts: Option<_> = curves.values(&jet).iter().map(Series::order).collect();
            images.push(Image {
                dimension,
                is_infinite,
                shared,
                contacts: contacts.ok_or(NoImage::TooShort)?,
            });
        }
        Ok(images)
    }

    fn moved(&self, place: &CurvePoint, length: usize, random: &mut SplitMix64) -> Vec<Series> {
        let series = |(i, value): (usize, &u64)| {
            let slopes: Vec<u64> = place.tangents.iter().map(|tangent| tangent[i]).collect();
            let mut series = Series::constant(*value, &slopes, length);
            series.rows[0][1] = self.modulus.sample(random);
            series
        };
        place.point.iter().enumerate().map(series).collect()
    }

    fn values(&self, jet: &[Series]) -> Vec<Series> {
        let (modulus, length) = (&self.modulus, jet[0].length());
        let slopes = vec![0; jet[0].rows.len() - 1];
        let powers: Vec<Vec<Series>> = jet
            .iter()
            .map(|one| {
                let mut powers = vec![Series::constant(modulus.one(), &slopes, length)];
                for k in 0..self.degree as usize {
                    powers.push(powers[k].times(modulus, one));
                }
                powers
            })
            .collect();
        let value = |component: &Vec<(u64, Vec<u32>)>| {
            let mut sum = Series::constant(0, &slopes, length);
            for (coefficient, exponents) in component {
                let mut factors = exponents.iter().enumerate().filter(|(_, exponent)| **exponent > 0);
                let power = |(i, exponent): (usize, &u32)| &powers[i][*exponent as usize];
                let first = factors.next().map_or_else(|| powers[0][0].clone(), |one| power(one).clone());
                let product = factors.fold(first, |product, one| product.times(modulus, power(one)));
                sum.add(modulus, *coefficient, &product);
            }
            sum
        };
        self.components.iter().map(value).collect()
    }
}

impl CurvePoint {
    /// Returns a random zero of a polynomial at which the gradient is not 0.
    pub(crate) fn on(
        modulus: &Modulus,
        curve: &Polynomial,
        values: &Values<'_>,
        random: &mut SplitMix64,
    ) -> Option<Self> {
        let n = values.symbols.dimension();
        let terms = values.terms(modulus, curve)?;
        let solved = (0..n).filter(|&i| terms.iter().any(|(_, exponents)| exponents[i] > 0));
        let solved = solved.min_by_key(|&i| terms.iter().map(|(_, exponents)| exponents[i]).max())?;
        let mut point: Vec<u64> = (0..n).map(|_| modulus.sample(random)).collect();
        point[solved] = modulus.one();
        let highest = terms.iter().map(|(_, exponents)| exponents[solved]).max()?;
        let mut coefficients = vec![0; highest as usize + 1];
        for (coefficient, exponents) in &terms {
            let entry = &mut coefficients[exponents[solved] as usize];
            let term = modulus.times(*coefficient, modulus.monomial(exponents, &point));
            *entry = modulus.plus(*entry, term);
        }
        point[solved] = root(modulus, &coefficients, random)?;
        let slope = |i: usize| values.terms(modulus, &curve.derivative(values.symbols.state(i)));
        let mut gradient = Vec::with_capacity(n);
        for i in 0..n {
            let terms = slope(i)?.into_iter();
            let terms = terms.map(|(c, exponents)| modulus.times(c, modulus.monomial(&exponents, &point)));
            gradient.push(terms.fold(0, |sum, term| modulus.plus(sum, term)));
        }
        let tangents = Echelon::of(modulus, vec![gradient], n).null_space(modulus);
        if tangents.len() + 1 != n {
            return None;
        }
        point.push(modulus.one());
        let tangents = tangents.into_iter().map(|mut tangent| {
            tangent.entries.push(0);
            tangent.entries
        });
        Some(CurvePoint { point, tangents: tangents.collect() })
    }

    pub(crate) fn at_infinity(modulus: &Modulus, n: usize, random: &mut SplitMix64) -> Self {
        let mut point: Vec<u64> = (0..n).map(|_| modulus.sample(random)).collect();
        point[0] = modulus.one();
        point.push(0);
        let tangent = |i: usize| (0..=n).map(|j| if i == j { modulus.one() } else { 0 }).collect();
        CurvePoint { point, tangents: (1..n).map(tangent).collect() }
    }
}
