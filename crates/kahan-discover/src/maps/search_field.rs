//! Fields, and their maps at random values of the unknowns. The unknowns are the parameters, and ε
//! unless it is fixed.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::prime_field::{Random, SplitMix64};
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;

use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::maps::parametric_field::{ParametricField, evaluate};
use crate::modular::modulus::Modulus;
use crate::modular::weights::Weights;

/// A field with a fixed or generic ε.
#[derive(Clone, Debug)]
pub struct SearchField {
    family: ParametricField,
    eps: Option<Rational>,
    weights: Weights,
}

/// A map, and the values of the parameters and ε with which it was formed.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The map.
    pub map: ModularMap,
    /// The values of the parameters in order, then of ε unless it is fixed.
    pub unknowns: Vec<u64>,
}

const MOST_SAMPLES: usize = 16;

/// A point of a map at random unknowns, and the image of the point.
#[derive(Clone, Debug)]
pub struct SampledStep {
    /// The map with the values of its unknowns.
    pub sample: Sample,
    /// The point x.
    pub here: Vec<u64>,
    /// The image x̃.
    pub there: Vec<u64>,
}

impl Sample {
    /// Returns a random point x and its image x̃ under the map. Returns `None` at a pole.
    pub fn step(self, random: &mut SplitMix64) -> Option<SampledStep> {
        let here = self.map.point(random);
        let there = self.map.next(&here)?;
        Some(SampledStep { sample: self, here, there })
    }
}

impl SampledStep {
    fn values(&self, searched: &SearchField, polynomial: &Polynomial) -> Option<[u64; 2]> {
        let value = |point| searched.evaluate(polynomial, &self.sample, point);
        Some([value(&self.here)?, value(&self.there)?])
    }

    /// Returns whether a polynomial has equal values at the point and at the image.
    #[must_use]
    pub fn keeps(&self, searched: &SearchField, polynomial: &Polynomial) -> bool {
        self.values(searched, polynomial).is_some_and(|[here, there]| here == there)
    }

    /// Returns P(x̃)/P(x) for a polynomial P. Returns `None` if P(x) = 0, or if the prime divides a
    /// denominator of the coefficients.
    #[must_use]
    pub fn cofactor(&self, searched: &SearchField, polynomial: &Polynomial) -> Option<u64> {
        let modulus = self.sample.map.modulus();
        let [here, there] = self.values(searched, polynomial)?;
        Some(modulus.times(there, modulus.inverse(here)?))
    }
}

impl SearchField {
    /// Prepares the maps of a field at generic ε (half the time step), or at the given ε.
    #[must_use]
    pub fn new(field: &Field, eps: Option<Rational>) -> Self {
        let weights = Weights::of(field, eps.is_some());
        SearchField { family: ParametricField::of(field), eps, weights }
    }

    /// Returns the field with its coefficients as polynomials in the parameters and ε.
    #[must_use]
    pub fn family(&self) -> &ParametricField {
        &self.family
    }

    /// Returns the scaling symmetries of the map.
    #[must_use]
    pub fn weights(&self) -> &Weights {
        &self.weights
    }

    /// Returns the value of ε if it is fixed.
    #[must_use]
    pub fn eps(&self) -> Option<&Rational> {
        self.eps.as_ref()
    }

    /// Returns the number of states n.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.family.dimension()
    }

    /// Returns the number of parameters, plus one if ε is generic.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.family.symbols().parameters.len() + usize::from(self.eps.is_none())
    }

    /// Returns the variables of the parameters in order, then of ε unless it is fixed.
    #[must_use]
    pub fn unknown_variables(&self) -> Vec<Variable> {
        let symbols = self.family.symbols();
        let parameters = (0..symbols.parameters.len()).map(|k| symbols.parameter(k));
        parameters.chain(self.eps.is_none().then(|| symbols.epsilon())).collect()
    }

    /// Returns the map at these values of the unknowns. Returns `None` if a denominator of the
    /// field, or the denominator of a fixed ε, is 0 modulo the prime.
    #[must_use]
    pub fn at(&self, modulus: Modulus, unknowns: &[u64]) -> Option<ModularMap> {
        let (parameters, eps) = match &self.eps {
            Some(eps) => (unknowns, modulus.rational(eps)?),
            None => {
                let (eps, parameters) = unknowns.split_last()?;
                (parameters, *eps)
            }
        };
        self.family.at(modulus, parameters, eps)
    }

    /// Chooses random values of the unknowns until the map is defined at a random point. Returns
    /// `None` after 16 failures.
    pub fn sample(&self, modulus: Modulus, random: &mut dyn Random) -> Option<Sample> {
        (0..MOST_SAMPLES).find_map(|_| {
            let unknowns: Vec<u64> = (0..self.unknowns()).map(|_| modulus.sample(random)).collect();
            let map = self.at(modulus, &unknowns)?;
            map.next(&map.point(random))?;
            Some(Sample { map, unknowns })
        })
    }

    /// Samples a map at random unknowns, and returns a random point with its image.
    pub fn step(&self, random: &mut SplitMix64) -> Option<SampledStep> {
        self.sample(Modulus::mersenne_61(), random)?.step(random)
    }

    /// Tells whether det ∂x̃/∂x ≠ 0 at one of three random points. At a fixed ε, the determinant
    /// may vanish everywhere.
    pub fn is_invertible(&self, random: &mut SplitMix64) -> bool {
        (0..3).any(|_| {
            self.sample(Modulus::mersenne_61(), random).is_some_and(|sample| {
                let step = sample.map.step(&sample.map.point(random));
                step.is_some_and(|step| step.jacobian != 0)
            })
        })
    }

    /// Substitutes the value of ε if it is fixed.
    #[must_use]
    pub fn at_eps(&self, polynomial: Polynomial) -> Polynomial {
        match &self.eps {
            Some(eps) => polynomial.substitute(self.family.symbols().epsilon(), eps),
            None => polynomial,
        }
    }

    /// Evaluates a polynomial in states, parameters and ε at a point of a sampled map. Returns
    /// `None` if the prime divides a denominator of the coefficients.
    #[must_use]
    pub fn evaluate(&self, polynomial: &Polynomial, sample: &Sample, point: &[u64]) -> Option<u64> {
        let symbols = self.family.symbols();
        let parameters = symbols.parameters.len();
        let value = |variable: Variable| match symbols.symbol(variable) {
            Symbol::State(i) | Symbol::SecondState(i) => point[i],
            Symbol::Parameter(k) => sample.unknowns[k],
            Symbol::Epsilon => sample.unknowns.get(parameters).copied().unwrap_or_else(|| sample.map.eps()),
        };
        evaluate(sample.map.modulus(), polynomial, value)
    }
}
