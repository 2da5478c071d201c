//! Affine level sets, which linear relations of orbits define.
//!
//! Relations of degree 1 (y = Hx, x + y + z = c) confine an orbit to an affine subspace with fewer
//! variables. The coefficients c₁, c₂, … that vary between orbits are integrals. On a level set
//! they are constants, which formulas contain like parameters. The linear relations vanish there
//! identically, so fewer relations remain. A formula on a level set holds everywhere once each cⱼ
//! is replaced by its own formula.

use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use crate::deadline::Deadline;
use crate::integrals::pencil::{PencilEntry, SPARE_EQUATIONS};
use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::reconstruction::reconstruct;
use crate::modular::subspace::combination;
use crate::modular::weights::Weights;
use crate::orbits::hilbert::random_relations;

/// An affine level set: the states that serve as coordinates, and those coefficients of the linear
/// relations that differ between level sets.
#[derive(Clone, Debug)]
pub struct AffineSubspace {
    /// For each varying coefficient: the index of the leading monomial of its relation, and the
    /// index of the monomial that the coefficient multiplies.
    places: Vec<(usize, usize)>,
    /// The states that serve as coordinates.
    order: Vec<usize>,
}

/// The formula cⱼ = Pⱼ/Qⱼ of a coefficient that defines the level set.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// The numerator Pⱼ.
    pub numerator: Polynomial,
    /// The denominator Qⱼ.
    pub denominator: Polynomial,
}

/// The map on one affine level set, in the coordinates of the level set.
#[derive(Clone, Debug)]
pub struct MapOnSubspace {
    map: ModularMap,
    order: Vec<usize>,
    /// Each state that is no coordinate, as an affine function of the coordinates, constant term
    /// first.
    leading: Vec<(usize, Vec<u64>)>,
}

impl Coordinate {
    /// Returns the weights w of the coefficient cⱼ. Each scaling symmetry multiplies cⱼ by λ^w.
    #[must_use]
    pub fn weight(&self, weights: &Weights) -> Vec<Rational> {
        let of = |side: &Polynomial| {
            side.leading_term().map(|(monomial, _)| weights.of_monomial(monomial)).unwrap_or_default()
        };
        of(&self.numerator).iter().zip(of(&self.denominator)).map(|(above, below)| above - &below).collect()
    }
}

impl AffineSubspace {
    /// Returns the whole space with its coordinates in a given order.
    #[must_use]
    pub fn whole(order: Vec<usize>) -> Self {
        AffineSubspace { places: Vec::new(), order }
    }

    /// Returns the affine level sets of a map. Returns the whole space if orbits satisfy no linear
    /// relation, or if the coefficients that vary from orbit to orbit are not independent.
    pub fn of(map: &ModularMap, random: &mut SplitMix64) -> Self {
        let n = map.dimension();
        let whole = AffineSubspace::whole((0..n).collect());
        Self::with_relations(map, random).unwrap_or(whole)
    }

    fn with_relations(map: &ModularMap, random: &mut SplitMix64) -> Option<Self> {
        let modulus = map.modulus();
        let linear = Monomials::new(map.dimension(), 1);
        let far = Deadline::never();
        let first = random_relations(map, &linear, random, &far)?;
        let second = random_relations(map, &linear, random, &far)?;
        if first.vectors.is_empty() || first.vectors.len() != second.vectors.len() {
            return None;
        }
        let mut places = Vec::new();
        for (vector, other) in first.vectors.iter().zip(&second.vectors) {
            let varies = (0..linear.len()).filter(|&index| vector.entries[index] != other.entries[index]);
            places.extend(varies.map(|index| (vector.free, index)));
        }
        let leads =
            |state: usize| first.vectors.iter().any(|vector| linear.exponents(vector.free)[state] == 1);
        let order = (0..map.dimension()).filter(|&state| !leads(state)).collect();
        let leaf = AffineSubspace { places, order };
        // The coefficients are independent if some orbit has relations with randomly chosen
        // coefficients.
        let chosen: Vec<u64> = leaf.places.iter().map(|_| modulus.sample(random)).collect();
        let on_leaf = leaf.map_at(map.clone(), &chosen, random)?;
        let start = on_leaf.embed(&on_leaf.point(random));
        let relations = crate::orbits::relations::Relations::on_orbit(map, start, &linear, &far)?;
        let found: Option<Vec<u64>> = leaf
            .places
            .iter()
            .map(|&(leading, lower)| {
                relations
                    .vectors
                    .iter()
                    .find(|vector| vector.free == leading)
                    .map(|vector| vector.entries[lower])
            })
            .collect();
        (found? == chosen).then_some(leaf)
    }

    /// Returns the number of coefficients cⱼ that define a level set.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.places.len()
    }

    /// Returns this subspace with its coordinates in each cyclic order, forward and backward.
    pub fn orders(&self) -> impl Iterator<Item = AffineSubspace> {
        let count = self.order.len();
        let rotated = move |shift: usize| (0..count).map(move |i| self.order[(i + shift) % count]);
        (0..count).flat_map(move |shift| {
            [rotated(shift).collect::<Vec<_>>(), rotated(shift).rev().collect()]
                .map(|order| AffineSubspace { places: self.places.clone(), order })
        })
    }

    /// Returns the states that serve as coordinates.
    #[must_use]
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// Returns the map on the level set whose varying coefficients have the values `entries`.
    /// Returns `None` if the coordinates do not determine the other states.
    pub fn map_at(&self, map: ModularMap, entries: &[u64], random: &mut SplitMix64) -> Option<MapOnSubspace> {
        let modulus = *map.modulus();
        let n = map.dimension();
        let mut leading = Vec::new();
        if self.order.len() < n {
            let linear = Monomials::new(n, 1);
            let mut relations = random_relations(&map, &linear, random, &Deadline::never())?;
            for vector in &mut relations.vectors {
                for (&(free, lower), &entry) in self.places.iter().zip(entries) {
                    if free == vector.free {
                        vector.entries[lower] = entry;
                    }
                }
                let state = linear.exponents(vector.free).iter().position(|&exponent| exponent == 1)?;
                let column = |state: usize| (1..=n).find(|&index| linear.exponents(index)[state] == 1);
                let mut value = vec![modulus.opposite(vector.entries[0])];
                for &coordinate in &self.order {
                    value.push(modulus.opposite(vector.entries[column(coordinate)?]));
                }
                leading.push((state, value));
            }
            if leading.len() + self.order.len() != n
                || leading.iter().any(|(state, _)| self.order.contains(state))
            {
                return None;
            }
        }
        Some(MapOnSubspace { map, order: self.order.clone(), leading })
    }

    /// Reconstructs the formulas of the coefficients cⱼ as quotients of polynomials of degree 1.
    pub fn coordinates(
        &self,
        searched: &SearchField,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<Vec<Coordinate>> {
        let n = searched.dimension();
        let linear = Monomials::new(n, 1);
        let all: Vec<usize> = (0..linear.len()).collect();
        let states: Vec<Variable> = (0..n).map(|i| searched.family().symbols().state(i)).collect();
        let mut coordinates = Vec::new();
        for &(leading, lower) in &self.places {
            let entry = PencilEntry { leading, lower, numerator: all.clone(), denominator: all.clone() };
            let mut oracle = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
                let map = searched.at(modulus, unknowns)?;
                let mut orbits = Vec::new();
                for _ in 0..2 * all.len() + SPARE_EQUATIONS {
                    orbits.push(random_relations(&map, &linear, random, deadline)?);
                }
                let values: Vec<Vec<u64>> =
                    orbits.iter().map(|orbit| linear.values(&modulus, &orbit.start)).collect();
                let (above, below) = entry.quotient(&modulus, &orbits, &values, deadline)?;
                let scale = modulus.inverse(*below.iter().find(|&&value| value != 0)?)?;
                Some([above, below].concat().iter().map(|&value| modulus.times(value, scale)).collect())
            };
            let entries = reconstruct(&mut oracle, &searched.unknown_variables(), random, deadline)?;
            let (entries, _) = RationalFunction::over_common(&entries);
            let (above, below) = entries.split_at(linear.len());
            let [numerator, denominator] =
                [above, below].map(|side| combination(&states, &linear, &all, side));
            coordinates.push(Coordinate { numerator, denominator });
        }
        Some(coordinates)
    }
}

impl MapOnSubspace {
    /// Returns the point of the whole space with these coordinates on the level set.
    #[must_use]
    pub fn embed(&self, point: &[u64]) -> Vec<u64> {
        let modulus = self.map.modulus();
        let mut full = vec![0; self.map.dimension()];
        for (&state, &value) in self.order.iter().zip(point) {
            full[state] = value;
        }
        for (state, value) in &self.leading {
            full[*state] = modulus.plus(value[0], modulus.dot(&value[1..], point));
        }
        full
    }
}

impl ModularStep for MapOnSubspace {
    fn modulus(&self) -> &Modulus {
        self.map.modulus()
    }

    fn dimension(&self) -> usize {
        self.order.len()
    }

    fn sign_changes(&self) -> Vec<u64> {
        if self.order.len() < self.map.dimension() {
            return Vec::new();
        }
        let reordered = |generator: u64| {
            let own = self.order.iter().enumerate().filter(|(_, state)| generator >> **state & 1 == 1);
            own.fold(0, |set, (place, _)| set | 1 << place)
        };
        self.map.sign_changes().into_iter().map(reordered).collect()
    }

    fn next(&self, point: &[u64]) -> Option<Vec<u64>> {
        let next = self.map.next(&self.embed(point))?;
        Some(self.order.iter().map(|&state| next[state]).collect())
    }
}
