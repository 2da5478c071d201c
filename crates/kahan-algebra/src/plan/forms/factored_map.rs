//! The reduced map, with numerators and denominator as products of a common set of factors.

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::kahan::RationalMap;
use crate::poly::{Monomial, Polynomial};

use crate::plan::forms::candidate::Candidate;
use crate::plan::writing::factors::{Factored, factored};
use crate::plan::writing::nesting::FormGoal;
use crate::plan::writing::numerators::{Power, Products};
use crate::plan::writing::plan_draft::Signed;
use crate::plan::writing::writer::Writer;

pub(in crate::plan) struct FactoredMap<'a> {
    pub(in crate::plan) field: &'a Field,
    pub(in crate::plan) map: &'a RationalMap,
    pub(in crate::plan) numerators: Vec<Factored>,
    pub(in crate::plan) denominator: Factored,
    pub(in crate::plan) empty: Vec<Writer>,
}

impl<'a> FactoredMap<'a> {
    pub(in crate::plan) fn of(field: &'a Field, map: &'a RationalMap) -> Self {
        let reduced = &map.reduced;
        let moving = reduced.increments.iter().filter(|increment| !increment.is_zero());
        let all: Vec<&Polynomial> = [&reduced.denominator].into_iter().chain(moving).collect();
        let mut over_base = factored(&all).into_iter();
        let zero =
            || Factored { coefficient: Rational::zero(), monomial: Monomial::one(), factors: Vec::new() };
        let mut next = || over_base.next().expect("one for each polynomial");
        let denominator = next();
        let numerator = |increment: &Polynomial| if increment.is_zero() { zero() } else { next() };
        let numerators = reduced.increments.iter().map(numerator).collect();
        FactoredMap { field, map, numerators, denominator, empty: Writer::empty(field) }
    }

    pub(in crate::plan) fn moving(&self) -> impl Iterator<Item = &Factored> {
        self.numerators.iter().filter(|numerator| !numerator.coefficient.is_zero())
    }

    /// Writes each numerator without the factor `without`, multiplied by a power of ε.
    pub(in crate::plan) fn written_numerators(
        &self,
        writer: &mut Writer,
        power: impl Fn(&Factored) -> Power,
        without: Option<&Polynomial>,
    ) -> Vec<Signed> {
        let mut products = Products::new();
        for numerator in &self.numerators {
            let product = without.map_or_else(|| numerator.clone(), |factor| numerator.without(factor));
            products.push_with(writer, &product, power(numerator));
        }
        products.finish(writer)
    }

    /// If the denominator is p·q and some components need only the division by p, returns p and q.
    pub(in crate::plan) fn two_factors(&self) -> Option<(&Polynomial, &Polynomial)> {
        let [(one, 1), (two, 1)] = &self.denominator.factors[..] else { return None };
        if !self.denominator.monomial.is_one()
            || !(&self.denominator.coefficient * &self.denominator.coefficient).is_one()
        {
            return None;
        }
        let is_needed = |factor: &Polynomial| self.moving().all(|numerator| numerator.exponent(factor) == 0);
        match (is_needed(one), is_needed(two)) {
            (true, false) => Some((one, two)),
            (false, true) => Some((two, one)),
            _ => None,
        }
    }

    /// Writes a candidate for the denominator p·q with `factors` [p, q]. Numerators with the factor
    /// q are divided only by p, and multiplied by ε^`short`; the others by p·q and by ε^`long`.
    pub(in crate::plan) fn divided_twice(
        &self,
        factors: [&Polynomial; 2],
        other: &Polynomial,
        c: &Rational,
        [short, long]: [Power; 2],
    ) -> Option<Candidate> {
        let mut writer = self.empty.last()?.clone();
        let [needed, partner] = factors.map(|factor| writer.write_scaled(factor, FormGoal::Early));
        let reciprocal = writer.reciprocal(c, needed.node);
        // This quotient is (c/p)/q. Compilers would pack two independent divisions into one slower
        // vector division.
        let both = writer.draft.builder.divide(reciprocal, partner.node);
        let is_short = |numerator: &Factored| numerator.exponent(other) > 0;
        let power = |numerator: &Factored| if is_short(numerator) { short } else { long };
        let numerators = self.written_numerators(&mut writer, power, Some(other));
        let constant_flips = self.denominator.coefficient.is_negative();
        let over = |(numerator, product): (Signed, &Factored)| {
            let flips = constant_flips ^ needed.negative;
            match is_short(product) {
                true => (numerator, reciprocal, flips),
                false => (numerator, both, flips ^ partner.negative),
            }
        };
        Some(Candidate::over(writer, numerators.into_iter().zip(&self.numerators).map(over)))
    }
}
