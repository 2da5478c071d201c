//! Functions whose next value follows from their value alone: F(x̃) = F(x) + c, c·F(x), or a
//! fraction that is linear in F(x) above and below.
//!
//! A space of polynomials that the map carries into itself up to a cofactor C has a matrix M with
//! P(x̃) = C(x)·M·P(x), and M acts on the quotients of its elements. The spaces are found modulo a
//! prime for each C and degree, lowest first; where one shows a function that is independent of the
//! integrals and of the drifts before, its basis and M are reconstructed, and each function that
//! `normal` reads off M is proved as a claim.

mod cofactors;
mod normal;
mod spaces;
mod triangular;

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::syntax::ClaimKind;

use crate::claims::{Claims, Formula};
use crate::deadline::Deadline;
use crate::independent::Independent;
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::reconstruct::reconstruct;
use crate::search::quotient_gradients;
use crate::search_field::{Sample, SampledStep, SearchField};
use crate::space::{Form, Space, combination, over_common, tidy};
use crate::stepping::Stepping;
use crate::writing::quotient;

use cofactors::Cofactors;
use normal::{Next, carried};
use spaces::{Carried, Points};
use triangular::Triangle;

/// The share of the time that the search may take.
pub(crate) const SHARE: f64 = 0.03;

/// Polynomials are looked at up to this degree.
const HIGHEST: u32 = 4;

/// The products that eliminations may take in all: a fraction of a second.
const MOST_PRODUCTS: usize = 20_000_000;

/// A space of more dimensions is not reconstructed.
const MOST_DIMENSIONS: usize = 8;

/// A claim of more characters is not written.
const MOST_CHARACTERS: usize = 1000;

/// A proved drift.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drift {
    /// The claim's name.
    pub name: String,
    /// The claim as a line of the language of `kahan!`: `drift F1 = … by …;`.
    pub text: String,
    /// How it goes on.
    pub kind: DriftKind,
    /// The numerator of F.
    pub numerator: Polynomial,
    /// The denominator of F.
    pub denominator: Polynomial,
}

/// How the value of a drift goes on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DriftKind {
    /// F + c, with this c.
    Sum(String),
    /// c·F, with this c.
    Multiple(String),
    /// (aF + b)/(cF + d)
    Image,
    /// A function of F and of earlier integrals and drifts.
    Link,
}

/// Independent drifts of a map, none of which follows from the integrals; `tell` hears of each.
pub(crate) fn drifts(
    searched: &SearchField,
    field: &Field,
    claims: &Claims<'_>,
    integrals: &[Formula],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
    tell: &dyn Fn(ClaimKind, &str),
) -> Vec<Drift> {
    let mut search = || {
        let cofactors = Cofactors::of(field, searched)?;
        let mut known = Independent::new(searched, random);
        let SampledStep { sample, here, .. } = known.step()?.clone();
        integrals.iter().for_each(|formula| known.keep(&formula.numerator, &formula.denominator));
        let names = integrals.iter().filter_map(Formula::name).map(str::to_owned);
        let names = names.chain((1..=searched.dimension()).map(|index| claims.name("F", Some(index))));
        let triangle = Triangle::new(&field.symbols, &cofactors.components, names.collect());
        let found = Vec::new();
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
            found,
        };
        for formula in integrals {
            search.triangle.take_integral(formula);
        }
        let mut products = 0;
        for degree in 1..=HIGHEST {
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

/// The most independent integrals that a map in n dimensions with these drifts can have, of
/// whatever degree.
///
/// With F + c, c ≠ 0, and c′·G, c′ no root of unity, the closure of each generic orbit in the plane
/// of F and G is that of the powers of (+c, ·c′), which is all of 𝔾ₐ × 𝔾ₘ. So its closure in the
/// space has dimension 2 at least, and dimension 1 with one of both.
pub(crate) fn most_integrals(drifts: &[Drift], n: usize) -> usize {
    let has_sum = drifts.iter().any(|drift| matches!(drift.kind, DriftKind::Sum(_)));
    // The roots of unity among rational functions are 1, which makes an integral, and −1.
    let has_multiple =
        drifts.iter().any(|drift| matches!(&drift.kind, DriftKind::Multiple(factor) if factor != "-1"));
    n - usize::from(has_sum) - usize::from(has_multiple)
}

/// The drifts up to the first that follows from those before and the integrals.
pub(crate) fn independent(
    mut drifts: Vec<Drift>,
    searched: &SearchField,
    integrals: &[Formula],
    random: &mut SplitMix64,
) -> Vec<Drift> {
    let mut known = Independent::new(searched, random);
    integrals.iter().for_each(|formula| known.keep(&formula.numerator, &formula.denominator));
    let is_news = |drift: &Drift| {
        let is_news = known.admits(&drift.numerator, &drift.denominator);
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
    /// Where independence is seen.
    here: Vec<u64>,
    /// The integrals, and the drifts so far.
    known: Independent<'a>,
    triangle: Triangle,
    deadline: &'a Deadline<'a>,
    tell: &'a dyn Fn(ClaimKind, &str),
    found: Vec<Drift>,
}

impl Search<'_> {
    /// Whether there are as many functions as states.
    fn is_done(&self) -> bool {
        self.known.rank_with(Vec::new()) == self.searched.dimension()
    }

    /// Looks at the spaces of one degree; `None` where the map has no value or the deadline passes.
    fn of_degree(&mut self, monomials: &Monomials, all: &[Vec<i32>], random: &mut SplitMix64) -> Option<()> {
        let modulus = *self.sample.map.modulus();
        let points = Points::new(self.searched, &self.sample, &self.cofactors, monomials, random)?;
        for exponents in all {
            let pairs = points.invariant(exponents, self.deadline)?;
            if !(2..=MOST_DIMENSIONS).contains(&pairs.len()) {
                continue;
            }
            let space =
                Space::spanned(&modulus, pairs.iter().map(|pair| pair[..monomials.len()].to_vec()).collect());
            let gradients = quotient_gradients(&modulus, monomials, &space, &self.here);
            let carried = Carried::of_form(&modulus, &space.form, &pairs)?;
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

    /// Reconstructs a space of this form with its matrix, and adds what it shows.
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
            let carried = Carried::of_form(&modulus, form, &pairs)?;
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
        // Σ vᵢPᵢ as a polynomial, and by what that is multiplied.
        let element = |vector: &Vec<RationalFunction>| {
            let (numerators, common) = over_common(&normal::image(vector, &rows));
            let whole = combination(&states, monomials, &form.support, &numerators);
            let short = tidy(symbols, &whole);
            Some((short.clone(), RationalFunction::new(common, whole.checked_div(&short)?)?))
        };
        let mut candidates = Vec::new();
        for carried in carried(&matrix, symbols.state(0)) {
            let ((above, scale_above), (below, scale_below)) =
                (element(&carried.above)?, element(&carried.below)?);
            let next = carried.next.scaled(&scale_above.checked_div(&scale_below)?)?;
            // The reciprocal is carried, too.
            let size = |side: &Polynomial| (symbols.degree(side), side.len());
            candidates.push(match next.of_reciprocal() {
                Some(next) if size(&below) > size(&above) => (below, above, next),
                _ => (above, below, next),
            });
        }
        let key = |(above, below, next): &(Polynomial, Polynomial, Next)| {
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

    /// The name of the next drift.
    fn name(&self) -> String {
        self.claims.name("F", Some(self.found.len() + 1))
    }

    /// Adds the drift above/below if its claim is short and proved.
    fn offer(&mut self, [above, below]: [&Polynomial; 2], next: &Next) {
        let name = self.name();
        let value = quotient(
            self.searched.family().symbols(),
            std::slice::from_ref(above),
            std::slice::from_ref(below),
            &[],
        );
        let Some((drift, image, kind, text)) = self.triangle.written(&name, next) else { return };
        if self.add(name, &value, &text, kind, [above, below]) {
            self.triangle.take(drift, [above, below], image);
        }
    }

    /// Adds the drifts of the states whose next value follows from the drifts before.
    fn add_links(&mut self) -> Option<()> {
        while !self.is_done() && !self.deadline.passed() {
            let name = self.name();
            let link = self.triangle.link(&name)?;
            let [above, below] = &self.triangle.in_states(&link);
            let is_news = self.known.admits(above, below);
            let (value, next) = (&link.value_text, &link.next_text);
            if !is_news || !self.add(name.clone(), value, next, DriftKind::Link, [above, below]) {
                return None;
            }
            self.triangle.keep(&name, link);
        }
        Some(())
    }

    /// Adds a drift if its claim, behind the integrals and the drifts before, is short and proved;
    /// whether it is.
    fn add(
        &mut self,
        name: String,
        value: &str,
        next: &str,
        kind: DriftKind,
        [above, below]: [&Polynomial; 2],
    ) -> bool {
        let text = format!("drift {name} = {value} by {next}{};", self.claims.condition);
        let earlier = self.found.iter().map(|drift| drift.text.as_str());
        let claims: Vec<&str> =
            self.integrals.iter().map(|formula| formula.text.as_str()).chain(earlier).collect();
        let is_added = text.len() <= MOST_CHARACTERS
            && self.claims.is_proved(&match kind {
                DriftKind::Link => format!("{} {text}", claims.join(" ")),
                _ => text.clone(),
            });
        if is_added {
            self.known.keep(above, below);
            (self.tell)(ClaimKind::Drift, &text);
            let [numerator, denominator] = [above, below].map(Clone::clone);
            self.found.push(Drift { name, text, kind, numerator, denominator });
        }
        is_added
    }
}
