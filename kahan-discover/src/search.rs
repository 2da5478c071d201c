//! Rational integrals from the relations of orbits.
//!
//! Let U be a space of polynomials any two of which have an integral as their quotient (they share their cofactor under
//! the map). On one orbit the elements of U that vanish are all of those that vanish at its start: one dimension less.
//! Conversely, relations on orbits span such a space where their span has one dimension more than those on one orbit.
//! Where relations of several integrals are mixed, an entry c of the reduced relations is an integral, and c = P/Q at many
//! starts is a linear system for P and Q.

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::hilbert::random_relations;
use crate::matrix::Echelon;
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::parity::character;
use crate::pencil::{Entry, Pencil, SPARE, Source};
use crate::relations::{Relations, gradient, monomial_gradients};
use crate::space::Space;
use crate::stepping::Stepping;

/// How large formulas are looked for.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// The most unknown coefficients of P and Q together.
    pub coefficients: usize,
    /// The most terms in the states of the shortest polynomial of a pencil.
    pub terms: usize,
    /// The most orders of the variables in which entries of relations are looked at, where there
    /// are many monomials.
    pub orders: usize,
}

impl Reach {
    /// As large as the search can reach.
    pub const FULL: Self = Reach { coefficients: 900, terms: usize::MAX, orders: usize::MAX };

    /// Formulas that can be read, where bases say the rest.
    pub const SHORT: Self = Reach { coefficients: 300, terms: 60, orders: 2 };
}

/// The pencils that relations of orbits span, of least degree first, up to `relation_degree`, until `wanted` independent
/// integrals are found.
pub fn spanned_pencils<M: Stepping>(
    map: &M,
    relation_degree: u32,
    wanted: usize,
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> Vec<Pencil> {
    let mut search = Search::new(map, random);
    for degree in 1..=relation_degree {
        if let Some(space) = span_of_relations(map, degree, search.random, deadline) {
            search.offer(Pencil { degree, space, source: Source::Span });
        }
        if search.rank() >= wanted {
            break;
        }
    }
    search.pencils
}

/// The pencils of one degree in which entries of the relations up to `relation_degree` are quotients P/Q, and of no lower
/// degree, as far as they bring integrals that are independent of those whose gradients at a point `known` gives; none if the
/// deadline passes first.
///
/// Cost: for P and Q with N monomials each, 2N orbits and (2N)³ products for each entry of the relations.
pub fn pencils_of_entries<M: Stepping>(
    map: &M,
    relation_degree: u32,
    degree: u32,
    reach: Reach,
    known: impl Fn(&[u64]) -> Vec<Vec<u64>>,
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> Vec<Pencil> {
    let mut search = Search::new(map, random);
    search.gradients = known(&search.point);
    entries_of_degree(&mut search, relation_degree, degree, reach, deadline);
    search.pencils
}

struct Search<'a, M> {
    map: &'a M,
    random: &'a mut SplitMix64,
    /// Where independence is tested.
    point: Vec<u64>,
    gradients: Vec<Vec<u64>>,
    pencils: Vec<Pencil>,
}

impl<'a, M: Stepping> Search<'a, M> {
    fn new(map: &'a M, random: &'a mut SplitMix64) -> Self {
        let point = map.point(random);
        Search { map, random, point, gradients: Vec::new(), pencils: Vec::new() }
    }

    fn rank(&self) -> usize {
        Echelon::of(self.map.modulus(), self.gradients.clone(), self.map.dimension()).rank()
    }

    /// Keeps a pencil if it brings an integral that is independent of those before.
    fn offer(&mut self, pencil: Pencil) {
        let before = self.rank();
        let known = self.gradients.len();
        let monomials = Monomials::new(self.map.dimension(), pencil.degree);
        self.gradients.extend(quotient_gradients(self.map.modulus(), &monomials, &pencil.space, &self.point));
        if self.rank() > before {
            self.pencils.push(pencil);
        } else {
            self.gradients.truncate(known);
        }
    }
}

/// The gradients, up to factors, of the quotients of the elements of a space by its first.
#[must_use]
pub fn quotient_gradients(
    modulus: &Modulus,
    monomials: &Monomials,
    space: &Space,
    point: &[u64],
) -> Vec<Vec<u64>> {
    let values = monomials.values(modulus, point);
    let slopes = monomial_gradients(modulus, monomials, point);
    let evaluated: Vec<(u64, Vec<u64>)> = (0..space.dimension())
        .map(|index| {
            let element = space.element(index, monomials.len());
            let value = element.iter().zip(&values);
            let value = value.fold(0, |sum, (c, m)| modulus.plus(sum, modulus.times(*c, *m)));
            (value, gradient(modulus, &slopes, &element))
        })
        .collect();
    let Some(((base, base_slope), others)) = evaluated.split_first() else { return Vec::new() };
    // ∇(P/Q) Q² = Q ∇P − P ∇Q
    let quotient = |(value, slope): &(u64, Vec<u64>)| {
        let pairs = slope.iter().zip(base_slope);
        pairs
            .map(|(own, below)| modulus.minus(modulus.times(*own, *base), modulus.times(*value, *below)))
            .collect()
    };
    others.iter().map(quotient).collect()
}

/// The span of the relations of all orbits up to a degree, if it has one dimension more than those of one orbit.
fn span_of_relations(
    map: &impl Stepping,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline,
) -> Option<Space> {
    let monomials = Monomials::new(map.dimension(), degree);
    let mut vectors: Vec<Vec<u64>> = Vec::new();
    let mut own = 0;
    for _ in 0..3 {
        let relations = random_relations(map, &monomials, random, deadline)?;
        own = relations.vectors.len();
        if own == 0 {
            return None;
        }
        vectors.extend(relations.vectors.into_iter().map(|vector| vector.entries));
    }
    let space = Space::spanned(map.modulus(), vectors);
    (space.dimension() == own + 1).then_some(space)
}

/// Tries P/Q of one degree for the entries of the relations.
fn entries_of_degree<M: Stepping>(
    search: &mut Search<'_, M>,
    relation_degree: u32,
    degree: u32,
    reach: Reach,
    deadline: &Deadline,
) {
    let map = search.map;
    let modulus = map.modulus();
    let n = map.dimension();
    let monomials = Monomials::new(n, relation_degree);
    // P and Q have the signs of their entry and none, so that few monomials of high degree are left.
    let generators = map.sign_changes();
    if Monomials::count(n, degree) > reach.coefficients << generators.len() {
        return;
    }
    let unknown = Monomials::new(n, degree);
    let signs: Vec<u64> =
        (0..unknown.len()).map(|index| character(&generators, unknown.exponents(index))).collect();
    let of_sign =
        |sign: u64| -> Vec<usize> { (0..unknown.len()).filter(|&index| signs[index] == sign).collect() };
    let sign_of = |(leading, lower): (usize, usize)| {
        let own = |index: usize| character(&generators, monomials.exponents(index));
        own(leading) ^ own(lower)
    };
    let mut orbits: Vec<Relations> = Vec::new();
    for _ in 0..2 {
        let Some(relations) = random_relations(map, &monomials, search.random, deadline) else { return };
        orbits.push(relations);
    }
    let places = entry_places(&orbits, &monomials);
    let invariant = of_sign(0);
    let widest = places.iter().map(|&place| of_sign(sign_of(place)).len()).max().unwrap_or(0);
    let width = invariant.len() + widest;
    // Where no monomial of this degree has the signs, the degree before has shown all.
    let is_new = (unknown.up_to(degree - 1)..unknown.len())
        .any(|index| signs[index] == 0 || places.iter().any(|&place| sign_of(place) == signs[index]));
    if width > reach.coefficients || !is_new {
        return;
    }
    while orbits.len() < width + SPARE {
        let Some(relations) = random_relations(map, &monomials, search.random, deadline) else { return };
        orbits.push(relations);
    }
    let values: Vec<Vec<u64>> = orbits.iter().map(|orbit| unknown.values(modulus, &orbit.start)).collect();
    let mut found: Vec<Pencil> = Vec::new();
    for (leading, lower) in places {
        if deadline.passed() {
            return;
        }
        let numerator = of_sign(sign_of((leading, lower)));
        let entry = Entry { leading, lower, numerator, denominator: invariant.clone() };
        let Some((numerator, denominator)) = entry.quotient(modulus, &orbits, &values, deadline) else {
            continue;
        };
        let used = |vector: &[u64]| (0..vector.len()).filter(|&index| vector[index] != 0).collect();
        let entry = Entry { numerator: used(&numerator), denominator: used(&denominator), ..entry };
        let space = Space::spanned(modulus, vec![numerator, denominator]);
        if space.dimension() == 2 {
            let source = Source::Entries { relation_degree, entries: vec![entry] };
            found.push(Pencil { degree, space, source });
        }
    }
    let mut merged = merge_by_cofactor(map, &unknown, found, search.random);
    merged.sort_by_key(|pencil| (0..pencil.space.dimension()).map(|i| pencil.space.terms(i)).sum::<usize>());
    for pencil in merged {
        search.offer(pencil);
    }
}

/// The entries worth looking at: those of relations whose leading monomial no lower one divides, if they vary.
fn entry_places(orbits: &[Relations], monomials: &Monomials) -> Vec<(usize, usize)> {
    let [first, second, ..] = orbits else { return Vec::new() };
    let divides = |a: usize, b: usize| {
        monomials.exponents(a).iter().zip(monomials.exponents(b)).all(|(low, high)| low <= high)
    };
    let leading: Vec<usize> = first.vectors.iter().map(|vector| vector.free).collect();
    let mut places = Vec::new();
    for vector in &first.vectors {
        if leading.iter().any(|&lower| lower != vector.free && divides(lower, vector.free)) {
            continue;
        }
        let Some(other) = second.vectors.iter().find(|other| other.free == vector.free) else { continue };
        places.extend(
            (0..monomials.len())
                .filter(|&index| vector.entries[index] != other.entries[index])
                .map(|index| (vector.free, index)),
        );
    }
    places
}

/// Pencils of one degree whose elements share their cofactor P(φ(x))/P(x) become one.
fn merge_by_cofactor(
    map: &impl Stepping,
    monomials: &Monomials,
    pencils: Vec<Pencil>,
    random: &mut SplitMix64,
) -> Vec<Pencil> {
    let modulus = map.modulus();
    let samples: Vec<(Vec<u64>, Vec<u64>)> = (0..2)
        .filter_map(|_| {
            let point = map.point(random);
            let next = map.next(&point)?;
            Some((monomials.values(modulus, &point), monomials.values(modulus, &next)))
        })
        .collect();
    let value = |element: &[u64], values: &[u64]| {
        let products = element.iter().zip(values);
        products.fold(0, |sum, (c, m)| modulus.plus(sum, modulus.times(*c, *m)))
    };
    let cofactor = |element: &[u64]| -> Option<Vec<u64>> {
        let at = |(here, there): &(Vec<u64>, Vec<u64>)| {
            Some(modulus.times(value(element, there), modulus.inverse(value(element, here))?))
        };
        samples.iter().map(at).collect()
    };
    let mut groups: Vec<(Vec<u64>, Pencil)> = Vec::new();
    for pencil in pencils {
        let Some(own) = cofactor(&pencil.space.element(0, monomials.len())) else { continue };
        let Some((_, group)) = groups.iter_mut().find(|(known, _)| *known == own) else {
            groups.push((own, pencil));
            continue;
        };
        let elements = |space: &Space| -> Vec<Vec<u64>> {
            (0..space.dimension()).map(|index| space.element(index, monomials.len())).collect()
        };
        let joined = [elements(&group.space), elements(&pencil.space)].concat();
        let joined = Space::spanned(modulus, joined);
        if joined.dimension() > group.space.dimension() {
            if let (Source::Entries { entries, .. }, Source::Entries { entries: more, .. }) =
                (&mut group.source, pencil.source)
            {
                entries.extend(more);
            }
            group.space = joined;
        }
    }
    groups.into_iter().map(|(_, pencil)| pencil).collect()
}
