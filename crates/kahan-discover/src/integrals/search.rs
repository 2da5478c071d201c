//! Finds rational integrals from the polynomial relations of orbits.
//!
//! Let U be a space of polynomials whose quotients are integrals. An element of U vanishes on an
//! orbit if it vanishes at the orbit's start, so the relations of one orbit have codimension 1 in
//! U. Conversely, let V be the span of the relations of all orbits. If the relations of each orbit
//! have codimension 1 in V, all quotients of elements of V are integrals.

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::integrals::pencil::{Pencil, Source};
use crate::integrals::relation_coefficients::entries_of_degree;
use crate::maps::modular_step::ModularStep;
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::subspace::PolynomialSpace;
use crate::orbits::hilbert::random_relations;
use crate::orbits::relations::{gradient, monomial_gradients};

/// Limits on the size of the formulas that are searched.
#[derive(Clone, Copy, Debug)]
pub struct FormulaLimits {
    /// The most unknown coefficients of numerator and denominator together.
    pub coefficients: usize,
    /// The most monomials in the shortest polynomial of a [`Pencil`]'s basis.
    pub terms: usize,
    /// The most orders of the variables to try for relations with many monomials.
    pub orders: usize,
}

impl FormulaLimits {
    /// The largest limits on formulas.
    pub const FULL: Self = FormulaLimits { coefficients: 900, terms: usize::MAX, orders: usize::MAX };

    /// The limits for a short search, if Hirota–Kimura bases or compact forms already give all
    /// integrals.
    pub const SHORT: Self = FormulaLimits { coefficients: 300, terms: 60, orders: 2 };
}

/// Finds spaces of polynomials whose quotients are integrals, as spans of relations of orbits.
///
/// The degrees ascend up to `relation_degree`. The search stops at `wanted` independent integrals.
pub fn spanned_pencils<M: ModularStep>(
    map: &M,
    relation_degree: u32,
    wanted: usize,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
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

/// Finds [`Pencil`]s of P and Q of exactly this degree, where P/Q is a coefficient of relations.
///
/// `known` returns the gradients of known functions at a point. The integrals must be independent
/// of these functions. The result is empty if the deadline passes. For P and Q with N monomials
/// each, the search needs 2N orbits, and (2N)³ multiplications for each coefficient of a relation.
pub fn pencils_of_entries<M: ModularStep>(
    map: &M,
    relation_degree: u32,
    degree: u32,
    reach: FormulaLimits,
    known: impl Fn(&[u64]) -> Vec<Vec<u64>>,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Vec<Pencil> {
    let mut search = Search::new(map, random);
    search.gradients = known(&search.point);
    entries_of_degree(&mut search, relation_degree, degree, reach, deadline);
    search.pencils
}

pub(crate) struct Search<'a, M> {
    pub(crate) map: &'a M,
    pub(crate) random: &'a mut SplitMix64,
    point: Vec<u64>,
    gradients: Vec<Vec<u64>>,
    pencils: Vec<Pencil>,
}

impl<'a, M: ModularStep> Search<'a, M> {
    fn new(map: &'a M, random: &'a mut SplitMix64) -> Self {
        let point = map.point(random);
        Search { map, random, point, gradients: Vec::new(), pencils: Vec::new() }
    }

    fn rank(&self) -> usize {
        Echelon::of(self.map.modulus(), self.gradients.clone(), self.map.dimension()).rank()
    }

    /// Accepts a pencil if it has an integral that is independent of the accepted integrals.
    pub(crate) fn offer(&mut self, pencil: Pencil) {
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

/// Returns P₀²·∇(Pᵢ/P₀), i = 1, 2, …, for the elements P₀, P₁, … of a space.
#[must_use]
pub fn quotient_gradients(
    modulus: &Modulus,
    monomials: &Monomials,
    space: &PolynomialSpace,
    point: &[u64],
) -> Vec<Vec<u64>> {
    let values = monomials.values(modulus, point);
    let slopes = monomial_gradients(modulus, monomials, point);
    let evaluated: Vec<(u64, Vec<u64>)> = (0..space.dimension())
        .map(|index| {
            let element = space.element(index, monomials.len());
            (modulus.dot(&element, &values), gradient(modulus, &slopes, &element))
        })
        .collect();
    let Some(((base, base_slope), others)) = evaluated.split_first() else { return Vec::new() };
    // The gradient of a quotient satisfies ∇(P/Q) Q² = Q ∇P − P ∇Q.
    let quotient = |(value, slope): &(u64, Vec<u64>)| {
        let pairs = slope.iter().zip(base_slope);
        pairs
            .map(|(own, below)| modulus.minus(modulus.times(*own, *base), modulus.times(*value, *below)))
            .collect()
    };
    others.iter().map(quotient).collect()
}

/// Returns the span of the relations of several orbits, if it has exactly one dimension more than
/// the relations of one orbit.
fn span_of_relations(
    map: &impl ModularStep,
    degree: u32,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<PolynomialSpace> {
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
    let space = PolynomialSpace::spanned(map.modulus(), vectors);
    (space.dimension() == own + 1).then_some(space)
}
