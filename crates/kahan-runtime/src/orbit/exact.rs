//! Exact orbits. Points are projective integer coordinates; fractions are computed on demand.
//!
//! To test whether an integral is constant, let N/D be its value at the point, and p/q its value at
//! the first point. The products N q and D p are compared, which costs less than reducing N/D.

use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;

use crate::dimension::Argument;
use crate::fraction::Fractions;
use crate::heights::{HeightsOrbit, ProjectiveMap};
use crate::{DimensionError, Fraction, Map};

/// An orbit in exact numbers with its current point; begun by [`Map::exact_orbit`].
#[derive(Clone, Debug)]
pub struct ExactOrbit {
    map: Map,
    eps: Rational,
    orbit: HeightsOrbit,
    first: Vec<Option<Fraction>>,
}

impl Map {
    /// Begins the exact orbit from `start` at ε, half the time step.
    ///
    /// # Errors
    /// [`DimensionError`] if `start` does not have one entry for each variable.
    pub fn exact_orbit(&self, eps: &Rational, start: &[Rational]) -> Result<ExactOrbit, DimensionError> {
        DimensionError::check(Argument::State, start.len(), self.field().variables().len())?;
        let (system, parameters) = (self.field().system(), self.parameters());
        let map = match &self.field().derived().map {
            map @ Some(_) => ProjectiveMap::of(system, map.as_ref(), parameters, eps),
            // Fields of many variables have no rational map in `derived`, so it is derived here.
            None => ProjectiveMap::new(system, parameters, eps),
        };
        let map = map.expect("a map is at parameters where its field is defined");
        let mut orbit = HeightsOrbit::begin(map, start);
        // The first item of the iterator is the first point itself.
        orbit.next();
        let mut exact = ExactOrbit { map: self.clone(), eps: eps.clone(), orbit, first: Vec::new() };
        let first = exact.integrals(&exact.state());
        exact.first = first.into_iter().map(|value| value.map(Fraction::reduced)).collect();
        Ok(exact)
    }
}

impl ExactOrbit {
    /// Makes one step; returns `false` at a pole, where det A = 0.
    pub fn advance(&mut self) -> bool {
        self.orbit.next().is_some()
    }

    /// Returns the coordinates of the point, and the integrals claimed without `when`, all in
    /// lowest terms. An integral that divides by zero at the point is `None`.
    #[must_use]
    pub fn values(&self) -> (Vec<Fraction>, Vec<Option<Fraction>>) {
        let state = self.state();
        let integrals = self.integrals(&state).into_iter().zip(&self.first).map(|(value, first)| {
            let value = value?;
            let conserved = first.as_ref().filter(|first| value.equals(first));
            Some(conserved.cloned().unwrap_or_else(|| value.reduced()))
        });
        let integrals = integrals.collect();
        (state.into_iter().map(Fraction::reduced).collect(), integrals)
    }

    /// Returns the map.
    #[must_use]
    pub fn map(&self) -> &Map {
        &self.map
    }

    /// Returns the coordinates of the point.
    #[must_use]
    pub fn point(&self) -> Vec<Rational> {
        self.orbit.point()
    }

    fn state(&self) -> Vec<Fraction> {
        let unit = Fraction::from(self.orbit.projective_map().unit());
        let (weight, x) = self.orbit.projective_point().split_last().expect("W stands last");
        x.iter().map(|x| unit.times_quotient(x, weight)).collect()
    }

    fn integrals(&self, state: &[Fraction]) -> Vec<Option<Fraction>> {
        let derived = self.map.field().derived();
        let symbols = &derived.system.field.symbols;
        derived.integrals.evaluate(&Fractions, |input| {
            Some(match symbols.symbol(input.variable()?) {
                Symbol::State(i) | Symbol::SecondState(i) => state[i].clone(),
                Symbol::Parameter(k) => Fraction::from(&self.map.parameters()[k]),
                Symbol::Epsilon => Fraction::from(&self.eps),
            })
        })
    }
}
