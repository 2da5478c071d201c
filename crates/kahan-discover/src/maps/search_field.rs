//! What is fixed and what is generic: the maps that a search looks at.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::prime_field::{Random, SplitMix64};
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;

use crate::maps::map::ModularMap;
use crate::maps::parametric_field::{Family, evaluate};
use crate::maps::stepping::Stepping;
use crate::modular::modulus::Modulus;
use crate::modular::weights::Weights;

/// A field, and ε where it is fixed.
#[derive(Clone, Debug)]
pub struct SearchField {
    family: Family,
    eps: Option<Rational>,
    weights: Weights,
}

/// A map at values of the unknowns: the parameters in order, then ε where it is not fixed.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The map.
    pub map: ModularMap,
    /// The values.
    pub unknowns: Vec<u64>,
}

/// How often values are sampled again before the map counts as undefined.
const MOST_SAMPLES: usize = 16;

/// A point of a sampled map, and its image.
#[derive(Clone, Debug)]
pub struct SampledStep {
    /// The map.
    pub sample: Sample,
    /// x
    pub here: Vec<u64>,
    /// x̃
    pub there: Vec<u64>,
}

impl Sample {
    /// A random point, and its image; `None` at a pole.
    pub fn step(self, random: &mut SplitMix64) -> Option<SampledStep> {
        let here = self.map.point(random);
        let there = self.map.next(&here)?;
        Some(SampledStep { sample: self, here, there })
    }
}

impl SampledStep {
    /// The values of a polynomial at both points; `None` where the prime divides a denominator of
    /// its coefficients.
    fn values(&self, searched: &SearchField, polynomial: &Polynomial) -> Option<[u64; 2]> {
        let value = |point| searched.evaluate(polynomial, &self.sample, point);
        Some([value(&self.here)?, value(&self.there)?])
    }

    /// Whether a polynomial has the same value at both points.
    #[must_use]
    pub fn keeps(&self, searched: &SearchField, polynomial: &Polynomial) -> bool {
        self.values(searched, polynomial).is_some_and(|[here, there]| here == there)
    }

    /// P(x̃)/P(x); `None` also where P(x) = 0.
    #[must_use]
    pub fn cofactor(&self, searched: &SearchField, polynomial: &Polynomial) -> Option<u64> {
        let modulus = self.sample.map.modulus();
        let [here, there] = self.values(searched, polynomial)?;
        Some(modulus.times(there, modulus.inverse(here)?))
    }
}

impl SearchField {
    /// The maps of a field at every ε (half the time step), or at one.
    #[must_use]
    pub fn new(field: &Field, eps: Option<Rational>) -> Self {
        let weights = Weights::of(field, eps.is_some());
        SearchField { family: Family::of(field), eps, weights }
    }

    /// The field's coefficients.
    #[must_use]
    pub fn family(&self) -> &Family {
        &self.family
    }

    /// The scaling symmetries.
    #[must_use]
    pub fn weights(&self) -> &Weights {
        &self.weights
    }

    /// ε, where it is fixed.
    #[must_use]
    pub fn eps(&self) -> Option<&Rational> {
        self.eps.as_ref()
    }

    /// The number of states n.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.family.dimension()
    }

    /// The number of unknowns: the parameters, and ε unless it is fixed.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.family.symbols().parameters.len() + usize::from(self.eps.is_none())
    }

    /// The variables of the unknowns in formulas, in order.
    #[must_use]
    pub fn unknown_variables(&self) -> Vec<Variable> {
        let symbols = self.family.symbols();
        let parameters = (0..symbols.parameters.len()).map(|k| symbols.parameter(k));
        parameters.chain(self.eps.is_none().then(|| symbols.epsilon())).collect()
    }

    /// The map at these values of the unknowns; `None` where the field divides by zero, or p
    /// divides the denominator of ε.
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

    /// The map at random values of the unknowns, at which a random point has an image; `None` if 16
    /// samples bring none.
    pub fn sample(&self, modulus: Modulus, random: &mut dyn Random) -> Option<Sample> {
        (0..MOST_SAMPLES).find_map(|_| {
            let unknowns: Vec<u64> = (0..self.unknowns()).map(|_| modulus.sample(random)).collect();
            let map = self.at(modulus, &unknowns)?;
            map.next(&map.point(random))?;
            Some(Sample { map, unknowns })
        })
    }

    /// A random point of a map with random unknowns, and its image.
    pub fn step(&self, random: &mut SplitMix64) -> Option<SampledStep> {
        self.sample(Modulus::mersenne_61(), random)?.step(random)
    }

    /// Whether the map can be inverted: whether det ∂x̃/∂x = det A(x̃,−ε)/det A(x,ε) is another
    /// than 0, as it is seen at one of three random points modulo a prime. At a fixed ε a map may
    /// collapse the space.
    pub fn is_invertible(&self, random: &mut SplitMix64) -> bool {
        (0..3).any(|_| {
            self.sample(Modulus::mersenne_61(), random).is_some_and(|sample| {
                let step = sample.map.step(&sample.map.point(random));
                step.is_some_and(|step| step.jacobian != 0)
            })
        })
    }

    /// The polynomial at the ε that is fixed.
    #[must_use]
    pub fn at_eps(&self, polynomial: Polynomial) -> Polynomial {
        match &self.eps {
            Some(eps) => polynomial.substitute(self.family.symbols().epsilon(), eps),
            None => polynomial,
        }
    }

    /// The value of a polynomial in states, parameters and ε at a point of a sampled map; `None`
    /// where the prime divides a denominator of its coefficients.
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
