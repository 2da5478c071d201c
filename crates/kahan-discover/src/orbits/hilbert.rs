//! The Hilbert function of a generic orbit, and the number of integrals that it shows.

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::maps::search_field::SearchField;
use crate::maps::stepping::Stepping;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::orbits::relations::Relations;

/// h(d) for a generic orbit: the number of monomials of degree ≤ d that are independent on it.
///
/// That all monomials up to degree d are independent bounds the degree of a relation from below; it
/// does not prove that there is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hilbert {
    /// h(1), h(2), ….
    pub values: Vec<usize>,
    /// The number of monomials of degree ≤ 1, ≤ 2, …: what h is where nothing is conserved.
    pub full: Vec<usize>,
    /// The codimension of the orbit's closure as cut out by the relations seen: the number of
    /// independent algebraic integrals visible up to this degree.
    pub integrals: usize,
    /// The least degree of a relation.
    pub relation_degree: Option<u32>,
    /// The points of the longest orbit looked at.
    pub points: usize,
    /// The period, if every orbit looked at closed with the same one.
    pub period: Option<usize>,
    /// The orbits looked at: two primes, two points each, unless time ran out.
    pub orbits: usize,
    /// Whether all of them gave the same.
    pub agree: bool,
}

/// As many monomials as an orbit is looked at for, unless a degree is asked for.
const MOST_MONOMIALS: usize = 220;

/// As many for degree 2, which is looked at in more variables.
const MOST_QUADRATIC_MONOMIALS: usize = 900;

/// The highest degree, unless one is asked for.
const HIGHEST_DEGREE: u32 = 10;

/// The most monomials that are looked at, whatever the time: the relations on one orbit take their
/// square in numbers of eight bytes several times over, and their cube in products.
pub const MOST_MONOMIALS_AT_ALL: usize = 4000;

/// How often a start is sampled again when its orbit ends at a pole.
const MOST_SAMPLES: usize = 8;

/// The degree up to which relations in n variables are looked for: as high as 220 monomials allow,
/// between 2 and 10 (in more than 40 variables 1).
#[must_use]
pub fn default_degree(variables: usize) -> u32 {
    let most = |degree: u32| if degree == 2 { MOST_QUADRATIC_MONOMIALS } else { MOST_MONOMIALS };
    (2..=HIGHEST_DEGREE)
        .take_while(|&degree| Monomials::count(variables, degree) <= most(degree))
        .last()
        .unwrap_or(1)
}

/// The relations on a random orbit; `None` if all of 8 orbits end at poles, or the deadline passes.
pub fn random_relations(
    map: &impl Stepping,
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
    /// Looks at orbits modulo two primes from two points each, with random unknowns, as many as the
    /// deadline allows. `None` if the map, or every orbit, has no value, or not even one is done in
    /// time.
    ///
    /// Cost: with N = C(n + degree, n) monomials and h = h(degree), 4 N² h products.
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

    /// Looks at one orbit up to a higher degree. Its ranks are those of a generic orbit or lower,
    /// so that one orbit on which no integral is added shows that none is; where some are added,
    /// all four orbits are looked at. `None` as for [`of`](Self::of).
    ///
    /// Cost: N² h products where nothing is added.
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

    /// What one orbit shows.
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

    /// Two findings as one. Where they differ the larger ranks are the generic ones.
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

    /// The least degree up to which the relations of a generic orbit of `map` define its closure;
    /// `None` if there are none, or the deadline passes.
    pub fn defining_degree(
        &self,
        map: &impl Stepping,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<u32> {
        (self.relation_degree?..=self.degree()).find(|&degree| {
            let monomials = Monomials::new(map.dimension(), degree);
            random_relations(map, &monomials, random, deadline)
                .is_some_and(|relations| relations.codimension(map.modulus(), &monomials) == self.integrals)
        })
    }

    /// The highest degree looked at.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.values.len() as u32
    }

    /// The dimension of the orbit's closure, n minus the number of integrals.
    #[must_use]
    pub fn dimension(&self, variables: usize) -> usize {
        variables - self.integrals
    }

    /// Whether nothing is conserved up to this degree.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.relation_degree.is_none()
    }
}
