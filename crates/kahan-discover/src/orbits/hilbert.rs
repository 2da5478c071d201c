//! The Hilbert function of a generic orbit, and the number of integrals that its relations show.

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::orbits::relations::Relations;

/// The Hilbert function h(d) of a generic orbit: the number of monomials of degree ≤ d that are
/// linearly independent on the orbit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hilbert {
    /// The values h(1), h(2), ….
    pub values: Vec<usize>,
    /// The numbers of all monomials of degree ≤ 1, ≤ 2, …, which bound h.
    pub full: Vec<usize>,
    /// The number of independent algebraic integrals: the codimension of the relations' zero set.
    pub integrals: usize,
    /// The least degree of a relation, if one was observed.
    pub relation_degree: Option<u32>,
    /// The number of points of the longest orbit.
    pub points: usize,
    /// The common period of the orbits, if every orbit is periodic.
    pub period: Option<usize>,
    /// The number of orbits: two starts modulo each of two primes, unless time ran out.
    pub orbits: usize,
    /// Whether the results of all orbits are equal.
    pub agree: bool,
}

/// The default degree of relations is the highest with at most this many monomials.
const MOST_MONOMIALS: usize = 220;

/// The most monomials of degree ≤ 2 for a default degree of 2. In 40 variables there are 861.
const MOST_QUADRATIC_MONOMIALS: usize = 900;

const HIGHEST_DEGREE: u32 = 10;

/// The most monomials for any time limit. For N monomials, relations on one orbit take several
/// times N² integers of 8 bytes, and N³ multiplications.
pub const MOST_MONOMIALS_AT_ALL: usize = 4000;

const MOST_SAMPLES: usize = 8;

/// Returns the default degree of relations in n variables. The degree falls from 10 to 2 as n
/// grows, and is 1 for more than 40 variables.
#[must_use]
pub fn default_degree(variables: usize) -> u32 {
    let most = |degree: u32| if degree == 2 { MOST_QUADRATIC_MONOMIALS } else { MOST_MONOMIALS };
    (2..=HIGHEST_DEGREE)
        .take_while(|&degree| Monomials::count(variables, degree) <= most(degree))
        .last()
        .unwrap_or(1)
}

/// Returns the relations on an orbit from a random start. Returns `None` if the orbits of 8 starts
/// meet poles, or if the deadline passes.
pub fn random_relations(
    map: &impl ModularStep,
    monomials: &Monomials,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Relations> {
    for _ in 0..MOST_SAMPLES {
        if deadline.passed() {
            return None;
        }
        let found = Relations::on_orbit(map, map.point(random), monomials, deadline);
        if found.is_some() {
            return found;
        }
    }
    None
}

impl Hilbert {
    /// Follows orbits modulo two primes from two points each, with random parameters and ε.
    ///
    /// Returns `None` if the map is undefined, every orbit ends at a pole, or the deadline allows
    /// no orbit. The cost is 4 N² h(degree) multiplications, where N = C(n + degree, n) counts the
    /// monomials.
    pub fn of(
        searched: &SearchField,
        degree: u32,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<Self> {
        let monomials = Monomials::new(searched.dimension(), degree);
        let mut found: Option<Hilbert> = None;
        for modulus in [Modulus::mersenne_61(), Modulus::random(random)] {
            for _ in 0..2 {
                let map = searched.sample(modulus, random)?.map;
                let Some(relations) = random_relations(&map, &monomials, random, deadline) else {
                    return found.filter(|_| deadline.has_stopped());
                };
                let next = Hilbert::from_relations(&relations, &modulus, &monomials);
                found = Some(match found {
                    None => next,
                    Some(known) => known.with(next),
                });
            }
        }
        found
    }

    /// Follows one orbit up to a higher degree. If this orbit shows more integrals than `self`,
    /// calls [`of`](Self::of) to confirm them with several orbits. Returns `None` in the cases of
    /// [`of`](Self::of).
    pub fn further(
        &self,
        searched: &SearchField,
        degree: u32,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<Self> {
        let monomials = Monomials::new(searched.dimension(), degree);
        let modulus = Modulus::mersenne_61();
        let map = searched.sample(modulus, random)?.map;
        let relations = random_relations(&map, &monomials, random, deadline)?;
        let found = Hilbert::from_relations(&relations, &modulus, &monomials);
        if found.integrals <= self.integrals {
            return Some(Hilbert { agree: self.agree, ..found });
        }
        Self::of(searched, degree, random, deadline)
    }

    /// Returns the Hilbert function of one orbit.
    #[must_use]
    pub fn from_relations(relations: &Relations, modulus: &Modulus, monomials: &Monomials) -> Self {
        let full: Vec<usize> = (1..=monomials.degree()).map(|degree| monomials.up_to(degree)).collect();
        let values = relations.ranks[1..].to_vec();
        let first = values.iter().zip(&full).position(|(rank, full)| rank < full);
        Hilbert {
            relation_degree: first.map(|index| index as u32 + 1),
            values,
            full,
            integrals: relations.codimension(modulus, monomials),
            points: relations.points,
            period: relations.period,
            orbits: 1,
            agree: true,
        }
    }

    /// Combines the results of two orbits. The larger ranks are kept, because no orbit has larger
    /// ranks than a generic one.
    fn with(mut self, other: Hilbert) -> Self {
        self.agree &= self.values == other.values && self.integrals == other.integrals;
        if other.values > self.values {
            self.values = other.values;
            self.integrals = other.integrals;
            self.relation_degree = other.relation_degree;
        }
        self.period = self.period.filter(|period| Some(*period) == other.period);
        self.points = self.points.max(other.points);
        self.orbits += 1;
        self
    }

    /// Returns the least degree d such that the relations of degree ≤ d define the Zariski closure
    /// of a generic orbit. Returns `None` without relations, or if the deadline passes.
    pub fn defining_degree(
        &self,
        map: &impl ModularStep,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<u32> {
        (self.relation_degree?..=self.degree()).find(|&degree| {
            let monomials = Monomials::new(map.dimension(), degree);
            random_relations(map, &monomials, random, deadline)
                .is_some_and(|relations| relations.codimension(map.modulus(), &monomials) == self.integrals)
        })
    }

    /// Returns the highest degree searched.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.values.len() as u32
    }

    /// Returns the dimension of the closure of the orbit for this number of variables.
    #[must_use]
    pub fn dimension(&self, variables: usize) -> usize {
        variables - self.integrals
    }

    /// Tells whether no relation was found.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.relation_degree.is_none()
    }
}
