//! Finds integrals among the coefficients of reduced relations of orbits.
//!
//! Each coefficient c of a reduced relation is an integral. The condition c = P/Q at the starts of
//! many orbits is a linear system for P and Q.

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::integrals::parity::character;
use crate::integrals::pencil::{Pencil, PencilEntry, SPARE_EQUATIONS, Source};
use crate::integrals::search::{FormulaLimits, Search};
use crate::maps::modular_step::ModularStep;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::PolynomialSpace;
use crate::orbits::hilbert::random_relations;
use crate::orbits::relations::Relations;

/// Searches for coefficients of relations that equal quotients P/Q of polynomials of this degree.
pub(crate) fn entries_of_degree<M: ModularStep>(
    search: &mut Search<'_, M>,
    relation_degree: u32,
    degree: u32,
    reach: FormulaLimits,
    deadline: &Deadline<'_>,
) {
    let map = search.map;
    let modulus = map.modulus();
    let n = map.dimension();
    let monomials = Monomials::new(n, relation_degree);
    // Under a sign change of states, all monomials of P must have equal signs, and so must those of
    // Q. This excludes most monomials of high degree.
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
    let is_new = (unknown.up_to(degree - 1)..unknown.len())
        .any(|index| signs[index] == 0 || places.iter().any(|&place| sign_of(place) == signs[index]));
    if width > reach.coefficients || !is_new {
        return;
    }
    // Stores only the relations that are used, because all relations of all orbits may not fit in
    // memory.
    let keep_looked_at = |relations: &mut Relations| {
        relations.vectors.retain(|vector| places.iter().any(|&(leading, _)| leading == vector.free));
    };
    orbits.iter_mut().for_each(keep_looked_at);
    while orbits.len() < width + SPARE_EQUATIONS {
        let Some(mut relations) = random_relations(map, &monomials, search.random, deadline) else { return };
        keep_looked_at(&mut relations);
        orbits.push(relations);
    }
    let values: Vec<Vec<u64>> = orbits.iter().map(|orbit| unknown.values(modulus, &orbit.start)).collect();
    let mut found: Vec<Pencil> = Vec::new();
    for (leading, lower) in places {
        if deadline.passed() {
            return;
        }
        let numerator = of_sign(sign_of((leading, lower)));
        let entry = PencilEntry { leading, lower, numerator, denominator: invariant.clone() };
        let Some((numerator, denominator)) = entry.quotient(modulus, &orbits, &values, deadline) else {
            continue;
        };
        let used = |vector: &[u64]| (0..vector.len()).filter(|&index| vector[index] != 0).collect();
        let entry = PencilEntry { numerator: used(&numerator), denominator: used(&denominator), ..entry };
        let space = PolynomialSpace::spanned(modulus, vec![numerator, denominator]);
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

/// Returns pairs (leading monomial, monomial) for the coefficients that differ between two orbits.
/// Skips a relation if another leading monomial divides its own.
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

/// Merges pencils of equal degree whose elements P have equal cofactors P(φ(x))/P(x).
fn merge_by_cofactor(
    map: &impl ModularStep,
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
    let cofactor = |element: &[u64]| -> Option<Vec<u64>> {
        let at = |(here, there): &(Vec<u64>, Vec<u64>)| {
            Some(modulus.times(modulus.dot(element, there), modulus.inverse(modulus.dot(element, here))?))
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
        let elements = |space: &PolynomialSpace| -> Vec<Vec<u64>> {
            (0..space.dimension()).map(|index| space.element(index, monomials.len())).collect()
        };
        let joined = [elements(&group.space), elements(&pencil.space)].concat();
        let joined = PolynomialSpace::spanned(modulus, joined);
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
