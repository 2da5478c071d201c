//! Drifts: functions F whose value at the next point is F + c, c·F, or (aF + b)/(cF + d). The
//! module `triangular` also finds next values that depend on integrals and earlier drifts.
//!
//! Let P be a vector of polynomials with P(x̃) = C(x)·M·P(x), for a matrix M and a scalar C, the
//! cofactor. Then M acts on quotients of polynomials in the span of P. The search finds these spans
//! modulo a prime, for cofactors and degrees up to 4. If a span has a function independent of
//! integrals and earlier drifts, P and M are reconstructed over ℚ. The module `normal` finds drifts
//! from the Jordan form of M. Each drift is proved as a claim.

mod cofactors;
mod normal;
mod spaces;
mod triangular;

use std::slice::from_ref;

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::system::Claim;

use crate::claims::proved::{Claims, Formula};
use crate::claims::writing::quotient;
use crate::deadline::Deadline;
use crate::integrals::independence::IndependentGradients;
use crate::integrals::search::quotient_gradients;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::{Sample, SampledStep, SearchField};
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::reconstruction::reconstruct;
use crate::modular::subspace::{Form, PolynomialSpace, combination, primitive_in_states};

use cofactors::Cofactors;
use normal::{NextValue, drifts_of};
use spaces::{InvariantSpace, Points};
use triangular::TriangularSystem;

pub(crate) const TIME_SHARE: f64 = 0.03;

const HIGHEST_DEGREE: u32 = 4;

const MOST_PRODUCTS: usize = 20_000_000;

const MOST_DIMENSIONS: usize = 8;

const MOST_CHARACTERS: usize = 1000;

/// A proved drift.
#[derive(Clone, Debug)]
pub struct Drift {
    /// The claim in the language of `kahan!`, for example `drift F1 = … by …;`.
    pub text: String,
    /// The claim as read from the text.
    pub claim: Claim,
    /// The value of the drift at the next point, as a function of the drift.
    pub kind: DriftKind,
    /// The numerator of the drift, a function of the states.
    pub numerator: Polynomial,
    /// The denominator of the drift.
    pub denominator: Polynomial,
}

/// The value of a drift F at the next point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DriftKind {
    /// The next value of the drift F is F + c with this c.
    Sum(Constant),
    /// The next value of the drift F is c·F with this c.
    Multiple(Constant),
    /// The next value of the drift F is (aF + b)/(cF + d).
    Image,
    /// The next value of the drift F is a function of F and of the integrals and earlier drifts
    /// with these names.
    Link(Vec<String>),
}

/// A function of the parameters and ε that contains no state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Constant {
    /// The function.
    pub value: RationalFunction,
    /// The function in the language of `kahan!`.
    pub text: String,
}

impl DriftKind {
    /// Returns whether the map from F to its next value has infinite order. For F ↦ F + c this
    /// means c ≠ 0. For F ↦ c·F it means c ≠ ±1, because c is a rational function over ℚ.
    pub(crate) fn has_infinite_order(&self) -> bool {
        let one = RationalFunction::one();
        match self {
            DriftKind::Sum(step) => !step.value.is_zero(),
            DriftKind::Multiple(factor) => factor.value != one && factor.value != -&one,
            DriftKind::Image | DriftKind::Link(_) => false,
        }
    }
}

/// Finds and proves drifts that are independent of each other and of the integrals.
pub(crate) fn drifts(
    searched: &SearchField,
    field: &Field,
    claims: &Claims<'_>,
    integrals: &[Formula],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
    tell: &dyn Fn(&Claim, &str),
) -> Vec<Drift> {
    let mut search = || {
        let cofactors = Cofactors::of(field, searched)?;
        let known = IndependentGradients::of(searched, integrals, random);
        let SampledStep { sample, here, .. } = known.step()?.clone();
        let names = integrals.iter().map(|formula| formula.name().to_owned());
        let names = names.chain((1..=searched.dimension()).map(|index| claims.name("F", Some(index))));
        let triangle = TriangularSystem::new(&field.symbols, &cofactors.components, names.collect());
        let mut search = Search {
            searched,
            claims,
            integrals,
            cofactors,
            sample,
            here,
            known,
            triangle,
            deadline,
            tell,
            found: Vec::new(),
        };
        for formula in integrals {
            search.triangle.take_integral(formula);
        }
        let mut products = 0;
        for degree in 1..=HIGHEST_DEGREE {
            let monomials = Monomials::new(searched.dimension(), degree);
            let all = search.cofactors.of_degree(degree);
            products += all.len() * (2 * monomials.len()).pow(3);
            if products > MOST_PRODUCTS || search.is_done() || deadline.passed() {
                break;
            }
            if search.of_degree(&monomials, &all, random).is_none() {
                break;
            }
        }
        search.add_links();
        Some(search.found)
    };
    search().unwrap_or_default()
}

/// Returns an upper bound on the number of independent integrals in n dimensions with these drifts.
///
/// Suppose that each step turns a drift F into F + c with c ≠ 0, and a drift G into c′G, where c′
/// is no root of unity. The points (F + kc, c′ᵏG) are Zariski-dense in the plane. A generic orbit's
/// closure then has at least 2 dimensions, so the bound is n − 2. With only F or G it is n − 1.
pub(crate) fn most_integrals(drifts: &[Drift], n: usize) -> usize {
    let kinds = || drifts.iter().map(|drift| &drift.kind).filter(|kind| kind.has_infinite_order());
    let has_sum = kinds().any(|kind| matches!(kind, DriftKind::Sum(_)));
    let has_multiple = kinds().any(|kind| matches!(kind, DriftKind::Multiple(_)));
    n - usize::from(has_sum) - usize::from(has_multiple)
}

/// Drops the first invalid drift and all later drifts, because they may depend on it.
///
/// A drift is invalid if it is a function of `integrals` and earlier drifts, or if its claim names
/// an integral that is in the old list `before` but not in `integrals`.
pub(crate) fn independent(
    mut drifts: Vec<Drift>,
    searched: &SearchField,
    before: &[Formula],
    integrals: &[Formula],
    random: &mut SplitMix64,
) -> Vec<Drift> {
    let mut known = IndependentGradients::of(searched, integrals, random);
    let is_news = |drift: &Drift| {
        let is_named = |old: &&Formula| match &drift.kind {
            DriftKind::Link(names) => names.iter().any(|name| old.name() == name),
            _ => false,
        };
        let mut named = before.iter().filter(is_named);
        let is_news = known.admits(&drift.numerator, &drift.denominator)
            && named.all(|old| integrals.iter().any(|new| new.text == old.text));
        known.keep(&drift.numerator, &drift.denominator);
        is_news
    };
    let news = drifts.iter().map(is_news).take_while(|is_news| *is_news).count();
    drifts.truncate(news);
    drifts
}

struct Search<'a> {
    searched: &'a SearchField,
    claims: &'a Claims<'a>,
    integrals: &'a [Formula],
    cofactors: Cofactors,
    sample: Sample,
    here: Vec<u64>,
    known: IndependentGradients<'a>,
    triangle: TriangularSystem,
    deadline: &'a Deadline<'a>,
    tell: &'a dyn Fn(&Claim, &str),
    found: Vec<Drift>,
}

impl Search<'_> {
    fn is_done(&self) -> bool {
        self.known.rank_with(Vec::new()) == self.searched.dimension()
    }

    fn of_degree(&mut self, monomials: &Monomials, all: &[Vec<i32>], random: &mut SplitMix64) -> Option<()> {
        let modulus = *self.sample.map.modulus();
        let points = Points::new(self.searched, &self.sample, &self.cofactors, monomials, random)?;
        for exponents in all {
            let pairs = points.invariant(exponents, self.deadline)?;
            if !(2..=MOST_DIMENSIONS).contains(&pairs.len()) {
                continue;
            }
            let space = PolynomialSpace::spanned(
                &modulus,
                pairs.iter().map(|pair| pair[..monomials.len()].to_vec()).collect(),
            );
            let gradients = quotient_gradients(&modulus, monomials, &space, &self.here);
            let carried = InvariantSpace::of_form(&modulus, &space.form, &pairs)?;
            let known = self.known.rank_with(Vec::new());
            if !carried.is_scalar() && self.known.rank_with(gradients) > known {
                self.of_space(monomials, exponents, &space.form, random);
            }
            if self.is_done() {
                break;
            }
        }
        Some(())
    }

    /// Adds the drifts of an invariant space over ℚ with the monomials `form.support`.
    fn of_space(
        &mut self,
        monomials: &Monomials,
        exponents: &[i32],
        form: &Form,
        random: &mut SplitMix64,
    ) -> Option<()> {
        let mut oracle = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
            let sample = Sample { map: self.searched.at(modulus, unknowns)?, unknowns: unknowns.to_vec() };
            let points = Points::new(self.searched, &sample, &self.cofactors, monomials, random)?;
            let pairs = points.invariant(exponents, self.deadline)?;
            let carried = InvariantSpace::of_form(&modulus, form, &pairs)?;
            Some([carried.rows.concat(), carried.matrix.concat()].concat())
        };
        let unknowns = self.searched.unknown_variables();
        let entries = reconstruct(&mut oracle, &unknowns, random, self.deadline)?;
        let (width, size) = (form.support.len(), form.pivots.len());
        let (rows, matrix) = entries.split_at(width * size);
        let split = |entries: &[RationalFunction], width| {
            entries.chunks(width).map(<[RationalFunction]>::to_vec).collect::<Vec<_>>()
        };
        let (rows, matrix) = (split(rows, width), split(matrix, size));
        let symbols = self.searched.family().symbols();
        let states: Vec<Variable> = (0..symbols.dimension()).map(|i| symbols.state(i)).collect();
        // Returns s·Σ vᵢPᵢ and s, where the Pᵢ are the basis, and the factor s makes the sum short.
        let element = |vector: &Vec<RationalFunction>| {
            let (numerators, common) = RationalFunction::over_common(&normal::image(vector, &rows));
            let whole = combination(&states, monomials, &form.support, &numerators);
            let short = primitive_in_states(symbols, &whole);
            Some((short.clone(), RationalFunction::new(common, whole.checked_div(&short)?)?))
        };
        let mut candidates = Vec::new();
        for carried in drifts_of(&matrix, symbols.state(0)) {
            let ((above, scale_above), (below, scale_below)) =
                (element(&carried.above)?, element(&carried.below)?);
            let next = carried.next.scaled(&scale_above.checked_div(&scale_below)?)?;
            // F = above/below and 1/F are drifts. The simpler polynomial becomes the denominator.
            let size = |side: &Polynomial| (symbols.degree(side), side.len());
            candidates.push(match next.of_reciprocal() {
                Some(next) if size(&below) > size(&above) => (below, above, next),
                _ => (above, below, next),
            });
        }
        let key = |(above, below, next): &(Polynomial, Polynomial, NextValue)| {
            (next.rank(), symbols.degree(above) + symbols.degree(below), above.len() + below.len())
        };
        candidates.sort_by_key(key);
        for (above, below, next) in candidates {
            if self.known.admits(&above, &below) {
                self.offer([&above, &below], &next);
            }
        }
        Some(())
    }

    fn name(&self) -> String {
        self.claims.name("F", Some(self.found.len() + 1))
    }

    fn offer(&mut self, [above, below]: [&Polynomial; 2], next: &NextValue) {
        let name = self.name();
        let value = quotient(self.searched.family().symbols(), from_ref(above), from_ref(below), &[]);
        let Some((drift, image, kind, text)) = self.triangle.written(&name, next) else { return };
        if self.add(&name, &value, &text, kind, [above, below]) {
            self.triangle.add_drift(drift, [above, below], image);
        }
    }

    /// Adds as drifts the states whose next value is a function of the state and of earlier drifts.
    fn add_links(&mut self) -> Option<()> {
        while !self.is_done() && !self.deadline.passed() {
            let name = self.name();
            let link = self.triangle.link(&name)?;
            let [above, below] = &self.triangle.in_states(&link);
            let is_news = self.known.admits(above, below);
            let (value, next) = (&link.value_text, &link.next_text);
            let kind = DriftKind::Link(self.triangle.names(&link));
            if !is_news || !self.add(&name, value, next, kind, [above, below]) {
                return None;
            }
            self.triangle.keep(&name, link);
        }
        Some(())
    }

    /// Adds a drift if its claim is short and proved. Returns whether the drift was added.
    fn add(
        &mut self,
        name: &str,
        value: &str,
        next: &str,
        kind: DriftKind,
        [above, below]: [&Polynomial; 2],
    ) -> bool {
        let text = format!("drift {name} = {value} by {next}{};", self.claims.condition);
        let proved = || {
            let DriftKind::Link(_) = kind else { return self.claims.proved(&[], &text) };
            let integrals = self.integrals.iter().map(|formula| formula.text.as_str());
            let earlier = integrals.chain(self.found.iter().map(|drift| drift.text.as_str()));
            self.claims.proved(&earlier.collect::<Vec<_>>(), &text)
        };
        let claim = if text.len() <= MOST_CHARACTERS { proved() } else { None };
        let Some(claim) = claim else { return false };
        self.known.keep(above, below);
        (self.tell)(&claim, &text);
        let [numerator, denominator] = [above, below].map(Clone::clone);
        self.found.push(Drift { text, claim, kind, numerator, denominator });
        true
    }
}

#[cfg(test)]
mod tests {
    use kahan_algebra::{lexer, read};

    use super::*;

    #[test]
    fn a_drift_that_names_an_integral_stays_with_it() {
        let text = "xdot = 0; ydot = x*y;";
        let system = read(&lexer::lex(text).tokens).system().expect("a system");
        let searched = SearchField::new(&system.field, None);
        let claims = Claims::new(&system, &[], None);
        let symbols = &system.field.symbols;
        let [x, y] = [0, 1].map(|i| Polynomial::variable(symbols.state(i)));
        let one = Polynomial::one();
        let [before, other] = [x.clone(), &x * &x]
            .map(|side| [claims.integral(symbols, 1, &side, &one, &[]).expect("an integral")]);
        let text = "drift F1 = y by F1*(1 + eps*H1)/(1 - eps*H1);";
        let drift = Drift {
            claim: claims.proved(&[&before[0].text], text).expect("a drift"),
            text: text.to_owned(),
            kind: DriftKind::Link(vec!["H1".to_owned()]),
            numerator: y,
            denominator: one,
        };
        for (integrals, count) in [(&before, 1), (&other, 0)] {
            let mut random = SplitMix64::new(1);
            let kept = independent(vec![drift.clone()], &searched, &before, integrals, &mut random);
            assert_eq!(kept.len(), count);
        }
    }
}
