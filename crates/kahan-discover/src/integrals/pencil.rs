//! Pencils: spaces of polynomials whose quotients are integrals.

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::maps::modular_step::ModularStep;
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::{Form, PolynomialSpace, spread_to_monomials};
use crate::orbits::hilbert::random_relations;
use crate::orbits::relations::Relations;

/// A linear system gets this many more equations than unknowns.
pub(crate) const SPARE_EQUATIONS: usize = 4;

/// A space of polynomials whose quotients are integrals, at one choice of the parameters and ε.
#[derive(Clone, Debug)]
pub struct Pencil {
    /// The degree of the polynomials.
    pub degree: u32,
    /// The space of polynomials.
    pub space: PolynomialSpace,
    pub(crate) source: Source,
}

/// The method by which a pencil was found.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// The span of the relations on several orbits.
    Span,
    /// The numerators P and denominators Q of those coefficients of relations on orbits that equal
    /// integrals P/Q.
    Entries { relation_degree: u32, entries: Vec<PencilEntry> },
}

/// A coefficient of a reduced relation that equals an integral P/Q.
#[derive(Clone, Debug)]
pub(crate) struct PencilEntry {
    /// The index of the relation's leading monomial.
    pub(crate) leading: usize,
    /// The index of the monomial whose coefficient equals P/Q.
    pub(crate) lower: usize,
    pub(crate) numerator: Vec<usize>,
    pub(crate) denominator: Vec<usize>,
}

impl PencilEntry {
    /// Finds the P/Q that equals, at each orbit's start, the coefficient of monomial `lower` in the
    /// relation with leading monomial `leading`. Returns `None` unless there is exactly one P/Q.
    pub(crate) fn quotient(
        &self,
        modulus: &Modulus,
        orbits: &[Relations],
        values: &[Vec<u64>],
        deadline: &Deadline<'_>,
    ) -> Option<(Vec<u64>, Vec<u64>)> {
        let width = self.numerator.len() + self.denominator.len();
        let mut rows = Vec::with_capacity(width + SPARE_EQUATIONS);
        for (orbit, values) in orbits.iter().zip(values).take(width + SPARE_EQUATIONS) {
            let relation = orbit.vectors.iter().find(|vector| vector.free == self.leading)?;
            let factor = modulus.opposite(relation.entries[self.lower]);
            let mut row: Vec<u64> = self.numerator.iter().map(|&index| values[index]).collect();
            row.extend(self.denominator.iter().map(|&index| modulus.times(factor, values[index])));
            rows.push(row);
        }
        let null = Echelon::null_vectors(modulus, rows, width, deadline)?;
        let [vector] = &null[..] else { return None };
        let (above, below) = vector.split_at(self.numerator.len());
        let spread =
            |places: &[usize], entries: &[u64]| spread_to_monomials(places, entries, values[0].len());
        Some((spread(&self.numerator, above), spread(&self.denominator, below)))
    }
}

impl Pencil {
    /// Computes the space again at the parameters and ε of `map`. Returns `None` if its leading
    /// monomials differ from those of `self.space`, the map is undefined, or the deadline passes.
    pub fn at(
        &self,
        map: &impl ModularStep,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<PolynomialSpace> {
        let modulus = *map.modulus();
        let monomials = Monomials::new(map.dimension(), self.degree);
        let form = &self.space.form;
        if let Some(space) = self.span_at(map, &monomials, random, deadline) {
            return Some(space);
        }
        let Source::Entries { relation_degree, entries } = &self.source else { return None };
        let relation_monomials = Monomials::new(map.dimension(), *relation_degree);
        let wanted = entries.iter().map(|entry| entry.numerator.len() + entry.denominator.len()).max()?
            + SPARE_EQUATIONS;
        let mut orbits = Vec::with_capacity(wanted);
        for _ in 0..wanted {
            let mut relations = random_relations(map, &relation_monomials, random, deadline)?;
            relations.vectors.retain(|vector| entries.iter().any(|entry| entry.leading == vector.free));
            orbits.push(relations);
        }
        let values: Vec<Vec<u64>> =
            orbits.iter().map(|orbit| monomials.values(&modulus, &orbit.start)).collect();
        let mut vectors = Vec::new();
        for entry in entries {
            let (above, below) = entry.quotient(&modulus, &orbits, &values, deadline)?;
            for vector in [above, below] {
                vectors.push(form.support.iter().map(|&index| vector[index]).collect());
            }
        }
        PolynomialSpace::of_form(&modulus, form, vectors)
    }

    /// Returns the span of all relations between the pencil's monomials on two orbits.
    fn span_at(
        &self,
        map: &impl ModularStep,
        monomials: &Monomials,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> Option<PolynomialSpace> {
        let modulus = map.modulus();
        let Form { support, .. } = &self.space.form;
        let mut vectors: Vec<Vec<u64>> = Vec::new();
        for _ in 0..2 {
            let length = support.len() + SPARE_EQUATIONS;
            let orbit = map.orbit(map.point(random), length);
            if orbit.len() < length {
                return None;
            }
            let rows = orbit.iter().map(|point| {
                let values = monomials.values(modulus, point);
                support.iter().map(|&index| values[index]).collect()
            });
            let null = Echelon::null_vectors(modulus, rows.collect(), support.len(), deadline)?;
            if null.len() + 1 != self.space.dimension() {
                return None;
            }
            vectors.extend(null);
        }
        PolynomialSpace::of_form(modulus, &self.space.form, vectors)
    }
}
