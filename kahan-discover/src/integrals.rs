//! Rational integrals from the relations of orbits.
//!
//! Let U be a space of polynomials any two of which have an integral as their quotient (they share their cofactor under
//! the map). On one orbit the elements of U that vanish are all of those that vanish at its start: one dimension less.
//! Conversely, relations on orbits span such a space where their span has one dimension more than those on one orbit.
//! Where relations of several integrals are mixed, an entry c of the reduced relations is an integral, and c = P/Q at many
//! starts is a linear system for P and Q.

use std::time::Instant;

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;

use crate::claims::{Claims, Formula};
use crate::hilbert::{Hilbert, random_relations};
use crate::map::{ModularMap, Stepping};
use crate::matrix::Echelon;
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::relations::{Relations, gradient, monomial_gradients};
use crate::setting::{Draw, Setting};
use crate::space::{Form, Space, lift_space};

/// A space of polynomials whose quotients are integrals, at one choice of the unknowns, with the way to find it at others.
#[derive(Clone, Debug)]
pub struct Pencil {
    /// The degree of the polynomials.
    pub degree: u32,
    /// The space; quotients of its elements are integrals.
    pub space: Space,
    source: Source,
}

/// How a pencil was found.
#[derive(Clone, Debug)]
enum Source {
    /// As the span of the relations of orbits on its own monomials.
    Span,
    /// As numerators and denominators of entries of relations.
    Entries { relation_degree: u32, entries: Vec<Entry> },
}

/// An entry of the reduced relations that is P/Q.
#[derive(Clone, Debug)]
struct Entry {
    /// The leading monomial of the relation, and the monomial of the entry.
    leading: usize,
    lower: usize,
    numerator: Vec<usize>,
    denominator: Vec<usize>,
}

/// The most unknown coefficients of P and Q together.
const MOST_COEFFICIENTS: usize = 900;

/// Equations beyond the number of unknowns.
const SPARE: usize = 4;

/// The pencils of least degree that hold `wanted` independent integrals of the map, or as many as were found before the
/// deadline; `relation_degree` is a degree up to which relations define the orbit's closure.
///
/// Cost: for P and Q with N monomials each, 2N orbits and (2N)³ products for each entry of the relations.
pub fn pencils(
    map: &ModularMap,
    relation_degree: u32,
    wanted: usize,
    highest: u32,
    random: &mut SplitMix64,
    deadline: Instant,
) -> Vec<Pencil> {
    let mut search = Search::new(map, random);
    for degree in 1..=relation_degree {
        if let Some(space) = span_of_relations(map, degree, search.random) {
            search.offer(Pencil { degree, space, source: Source::Span });
        }
        if search.rank() >= wanted {
            return search.pencils;
        }
    }
    entries_by_degree(&mut search, relation_degree, wanted, highest, deadline);
    search.pencils
}

struct Search<'a> {
    map: &'a ModularMap,
    random: &'a mut SplitMix64,
    /// Where independence is tested.
    point: Vec<u64>,
    gradients: Vec<Vec<u64>>,
    pencils: Vec<Pencil>,
}

impl<'a> Search<'a> {
    fn new(map: &'a ModularMap, random: &'a mut SplitMix64) -> Self {
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
        pairs.map(|(own, below)| modulus.minus(modulus.times(*own, *base), modulus.times(*value, *below))).collect()
    };
    others.iter().map(quotient).collect()
}

/// The span of the relations of all orbits up to a degree, if it has one dimension more than those of one orbit.
fn span_of_relations(map: &ModularMap, degree: u32, random: &mut SplitMix64) -> Option<Space> {
    let monomials = Monomials::new(map.dimension(), degree);
    let mut vectors: Vec<Vec<u64>> = Vec::new();
    let mut own = 0;
    for _ in 0..3 {
        let relations = random_relations(map, &monomials, random)?;
        own = relations.vectors.len();
        if own == 0 {
            return None;
        }
        vectors.extend(relations.vectors.into_iter().map(|vector| vector.entries));
    }
    let space = Space::spanned(map.modulus(), vectors);
    (space.dimension() == own + 1).then_some(space)
}

/// Tries P/Q of degree 1, 2, … for the entries of the relations.
fn entries_by_degree(
    search: &mut Search<'_>,
    relation_degree: u32,
    wanted: usize,
    highest: u32,
    deadline: Instant,
) {
    let map = search.map;
    let modulus = map.modulus();
    let n = map.dimension();
    let monomials = Monomials::new(n, relation_degree);
    let mut orbits: Vec<Relations> = Vec::new();
    for _ in 0..2 {
        let Some(relations) = random_relations(map, &monomials, search.random) else { return };
        orbits.push(relations);
    }
    let mut places = entry_places(&orbits, &monomials);
    for degree in 1..=highest {
        let unknown = Monomials::new(n, degree);
        let width = 2 * unknown.len();
        if width > MOST_COEFFICIENTS {
            return;
        }
        while orbits.len() < width + SPARE {
            if Instant::now() >= deadline {
                return;
            }
            let Some(relations) = random_relations(map, &monomials, search.random) else { return };
            orbits.push(relations);
        }
        let values: Vec<Vec<u64>> =
            orbits[..width + SPARE].iter().map(|orbit| unknown.values(modulus, &orbit.start)).collect();
        let all: Vec<usize> = (0..unknown.len()).collect();
        let mut found: Vec<Pencil> = Vec::new();
        places.retain(|&(leading, lower)| {
            if Instant::now() >= deadline {
                return false;
            }
            let entry = Entry { leading, lower, numerator: all.clone(), denominator: all.clone() };
            let Some((numerator, denominator)) = entry.quotient(modulus, &orbits, &values) else { return true };
            let entry = Entry {
                numerator: (0..all.len()).filter(|&index| numerator[index] != 0).collect(),
                denominator: (0..all.len()).filter(|&index| denominator[index] != 0).collect(),
                ..entry
            };
            let space = Space::spanned(modulus, vec![numerator, denominator]);
            if space.dimension() == 2 {
                let source = Source::Entries { relation_degree, entries: vec![entry] };
                found.push(Pencil { degree, space, source });
            }
            false
        });
        let mut merged = merge_by_cofactor(map, &unknown, found, search.random);
        merged.sort_by_key(|pencil| (0..pencil.space.dimension()).map(|i| pencil.space.terms(i)).sum::<usize>());
        for pencil in merged {
            search.offer(pencil);
        }
        if search.rank() >= wanted {
            return;
        }
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

impl Entry {
    /// P and Q, on all monomials of the given values, from P − cQ = 0 at the starts; `None` unless they are unique.
    fn quotient(
        &self,
        modulus: &Modulus,
        orbits: &[Relations],
        values: &[Vec<u64>],
    ) -> Option<(Vec<u64>, Vec<u64>)> {
        let width = self.numerator.len() + self.denominator.len();
        let mut rows = Vec::with_capacity(width + SPARE);
        for (orbit, values) in orbits.iter().zip(values).take(width + SPARE) {
            let relation = orbit.vectors.iter().find(|vector| vector.free == self.leading)?;
            let factor = modulus.opposite(relation.entries[self.lower]);
            let mut row: Vec<u64> = self.numerator.iter().map(|&index| values[index]).collect();
            row.extend(self.denominator.iter().map(|&index| modulus.times(factor, values[index])));
            rows.push(row);
        }
        let null = Echelon::of(modulus, rows, width).null_space(modulus);
        let [vector] = &null[..] else { return None };
        let (above, below) = vector.entries.split_at(self.numerator.len());
        let spread = |places: &[usize], entries: &[u64]| {
            let mut all = vec![0; values[0].len()];
            for (&place, &entry) in places.iter().zip(entries) {
                all[place] = entry;
            }
            all
        };
        Some((spread(&self.numerator, above), spread(&self.denominator, below)))
    }
}

/// Pencils of one degree whose elements share their cofactor P(φ(x))/P(x) become one.
fn merge_by_cofactor(
    map: &ModularMap,
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

impl Pencil {
    /// The space at other values of the unknowns; `None` where it has another form or the map has no value.
    pub fn at(
        &self,
        setting: &Setting,
        modulus: Modulus,
        unknowns: &[u64],
        random: &mut SplitMix64,
    ) -> Option<Space> {
        let map = setting.at(modulus, unknowns)?;
        let monomials = Monomials::new(map.dimension(), self.degree);
        let form = &self.space.form;
        if let Some(space) = self.span_at(&map, &monomials, random) {
            return Some(space);
        }
        let Source::Entries { relation_degree, entries } = &self.source else { return None };
        let relation_monomials = Monomials::new(map.dimension(), *relation_degree);
        let wanted = entries.iter().map(|entry| entry.numerator.len() + entry.denominator.len()).max()? + SPARE;
        let mut orbits = Vec::with_capacity(wanted);
        for _ in 0..wanted {
            orbits.push(random_relations(&map, &relation_monomials, random)?);
        }
        let values: Vec<Vec<u64>> =
            orbits.iter().map(|orbit| monomials.values(&modulus, &orbit.start)).collect();
        let mut vectors = Vec::new();
        for entry in entries {
            let (above, below) = entry.quotient(&modulus, &orbits, &values)?;
            for vector in [above, below] {
                vectors.push(form.support.iter().map(|&index| vector[index]).collect());
            }
        }
        Space::of_form(&modulus, form, vectors)
    }

    /// The span of the relations of two orbits on the space's own monomials, if that is all they have.
    fn span_at(&self, map: &ModularMap, monomials: &Monomials, random: &mut SplitMix64) -> Option<Space> {
        let modulus = map.modulus();
        let Form { support, .. } = &self.space.form;
        let mut vectors: Vec<Vec<u64>> = Vec::new();
        for _ in 0..2 {
            let length = support.len() + SPARE;
            let orbit = map.orbit(map.point(random), length);
            if orbit.len() < length {
                return None;
            }
            let rows = orbit.iter().map(|point| {
                let values = monomials.values(modulus, point);
                support.iter().map(|&index| values[index]).collect()
            });
            let null = Echelon::of(modulus, rows.collect(), support.len()).null_space(modulus);
            if null.len() + 1 != self.space.dimension() {
                return None;
            }
            vectors.extend(null.into_iter().map(|vector| vector.entries));
        }
        Space::of_form(modulus, &self.space.form, vectors)
    }
}

/// Independent integrals over ℚ with all unknowns, each proved, of least degree first: as many as there are, or as were
/// found before the deadline. `hilbert` says how many to look for.
pub fn integrals(
    setting: &Setting,
    claims: &Claims<'_>,
    hilbert: &Hilbert,
    random: &mut SplitMix64,
    deadline: Instant,
) -> Vec<Formula> {
    let (Some(lowest), wanted) = (hilbert.relation_degree, hilbert.integrals) else { return Vec::new() };
    let modulus = Modulus::mersenne_61();
    let Some(draw) = setting.draw(modulus, random) else { return Vec::new() };
    let defines = |degree: &u32, random: &mut SplitMix64| {
        let monomials = Monomials::new(setting.dimension(), *degree);
        random_relations(&draw.map, &monomials, random)
            .is_some_and(|relations| relations.codimension(&modulus, &monomials) == wanted)
    };
    let Some(relation_degree) = (lowest..=hilbert.degree()).find(|degree| defines(degree, random)) else {
        return Vec::new();
    };
    let highest = hilbert.degree().max(relation_degree);
    let pencils = pencils(&draw.map, relation_degree, wanted, highest, random, deadline);
    let symbols = setting.family().symbols();
    let mut independent = Independent::new(setting, random);
    let mut formulas: Vec<Formula> = Vec::new();
    for pencil in &pencils {
        let monomials = Monomials::new(setting.dimension(), pencil.degree);
        let at = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            pencil.at(setting, modulus, unknowns, random)
        };
        let Some(basis) = lift_space(setting, &monomials, &pencil.space.form, at, random, deadline) else {
            continue;
        };
        let Some((denominator, numerators)) = basis.split_first() else { continue };
        for numerator in numerators {
            if formulas.len() >= wanted || !independent.admits(numerator, denominator) {
                continue;
            }
            if let Some(formula) = claims.integral(symbols, formulas.len() + 1, numerator, denominator) {
                independent.keep(numerator, denominator);
                formulas.push(formula);
            }
        }
    }
    formulas
}

/// Functional independence: the rank of gradients at one random point modulo one prime. (A rank seen is a rank over ℚ.)
#[derive(Debug)]
pub struct Independent<'a> {
    setting: &'a Setting,
    draw: Option<(Draw, Vec<u64>)>,
    gradients: Vec<Vec<u64>>,
}

impl<'a> Independent<'a> {
    /// Of nothing yet.
    pub fn new(setting: &'a Setting, random: &mut SplitMix64) -> Self {
        let draw = setting.draw(Modulus::mersenne_61(), random).map(|draw| {
            let point = draw.map.point(random);
            (draw, point)
        });
        Independent { setting, draw, gradients: Vec::new() }
    }

    /// ∇(P/Q) Q²
    fn gradient(&self, numerator: &Polynomial, denominator: &Polynomial) -> Option<Vec<u64>> {
        let (draw, point) = self.draw.as_ref()?;
        let modulus = draw.map.modulus();
        let value = |polynomial: &Polynomial| self.setting.evaluate(modulus, polynomial, draw, point);
        let (above, below) = (value(numerator)?, value(denominator)?);
        let symbols = self.setting.family().symbols();
        (0..symbols.dimension())
            .map(|i| {
                let rising = value(&numerator.derivative(symbols.state(i)))?;
                let falling = value(&denominator.derivative(symbols.state(i)))?;
                Some(modulus.minus(modulus.times(rising, below), modulus.times(above, falling)))
            })
            .collect()
    }

    /// Whether P/Q is independent of what was kept.
    #[must_use]
    pub fn admits(&self, numerator: &Polynomial, denominator: &Polynomial) -> bool {
        let Some((draw, _)) = &self.draw else { return false };
        let Some(gradient) = self.gradient(numerator, denominator) else { return false };
        let mut rows = self.gradients.clone();
        rows.push(gradient);
        let wanted = rows.len();
        Echelon::of(draw.map.modulus(), rows, self.setting.dimension()).rank() == wanted
    }

    /// Keeps P/Q.
    pub fn keep(&mut self, numerator: &Polynomial, denominator: &Polynomial) {
        self.gradients.extend(self.gradient(numerator, denominator));
    }

    /// How many were kept.
    #[must_use]
    pub fn count(&self) -> usize {
        self.gradients.len()
    }
}
