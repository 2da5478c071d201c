//! Collects the candidate forms of a step.

use kahan_syntax::rational::Rational;
use kahan_syntax::table::sorted_by_key;

use crate::field::Field;
use crate::kahan::{RationalMap, scaled_matrix};
use crate::poly::Polynomial;
use crate::rational_function::RationalFunction;
use crate::subexpressions::FieldWithSubexpressions;

use crate::plan::forms::blocks::Blocks;
use crate::plan::forms::candidate::Candidate;
use crate::plan::forms::factored_map::FactoredMap;
use crate::plan::forms::minors::{Determinants, determinants};
use crate::plan::forms::products;
use crate::plan::writing::nesting::FormGoal;
use crate::plan::writing::numerators::{Power, Products};
use crate::plan::writing::plan_draft::Signed;
use crate::plan::writing::writer::{MatrixEntry, Writer};

struct WithDenominator {
    writer: Writer,
    denominator: Signed,
    numerators: Option<Vec<Signed>>,
}

/// Numerators are written as products only for the cheapest denominators, at most this many.
const TRIED_DENOMINATORS: usize = 2;
/// If the factors of the numerators have more terms in total than this, numerators are written as
/// determinants where possible.
const FACTOR_TERMS: usize = 32;

/// This many rotations of the rows are compared, for fields of at most `COMPARED_TERMS` terms.
const ROW_ROTATIONS: usize = 3;
/// Orders of rows are compared for fields of at most this many terms.
const COMPARED_TERMS: usize = 60;
/// The reduced map is written out if it has at most this many terms, or if no other form exists.
const WRITTEN_TERMS: usize = 120;

/// This many orders of rows are compared for blocks without elimination.
const ROW_ORDERS: usize = 3;

pub(in crate::plan) struct Forms<'a> {
    pub(in crate::plan) best: Candidate,
    factored: Option<FactoredMap<'a>>,
}

impl Forms<'_> {
    /// Returns candidates that may take less time per step of a single orbit than `recurrence`.
    pub(in crate::plan) fn of_one_orbit(&self, recurrence: u64) -> Vec<Candidate> {
        let Some(factored) = &self.factored else { return Vec::new() };
        let over_time_step = factored.over_time_step(recurrence);
        factored.with_two_divisions().into_iter().chain(over_time_step).collect()
    }
}

/// Finds the cheapest form of a field's step. If `kept` is given, its products of sums are not
/// expanded. Returns `None` if the field is too large for straight-line code.
pub(crate) fn forms<'a>(
    field: &'a Field,
    kept: Option<&FieldWithSubexpressions>,
    map: Option<&'a RationalMap>,
) -> Option<Forms<'a>> {
    if let Some(kept) = kept {
        let best = products::candidates(field, kept).into_iter().min_by_key(|form| form.price)?;
        return Some(Forms { best, factored: None });
    }
    let mut candidates: Vec<Candidate> = Vec::new();
    if has_blocks(field, map) {
        let blocks = Blocks::of(field);
        let turns = if terms(field) > COMPARED_TERMS { 1 } else { ROW_ROTATIONS };
        if let Some(eliminating) = blocks.with_elimination() {
            let empty = Writer::empty(field);
            candidates.extend(empty.iter().flat_map(|empty| blocks.candidates(empty, &eliminating, turns)));
        }
    }
    let map = map.filter(|map| candidates.is_empty() || map.reduced.terms() <= WRITTEN_TERMS);
    let factored = map.map(|map| FactoredMap::of(field, map));
    candidates.extend(factored.as_ref().and_then(FactoredMap::best));
    let best = candidates.into_iter().min_by_key(|form| form.price)?;
    Some(Forms { best, factored })
}

fn has_blocks(field: &Field, map: Option<&RationalMap>) -> bool {
    map.is_none_or(|map| field.dimension() > 3 && map.reduced.common_factor.as_constant().is_some())
}

/// Returns forms that may lose fewer digits in long steps than `best`, with the cheapest form
/// first. Each form costs at most 3/2 times as much as `best`.
pub(crate) fn steady_forms(field: &Field, map: Option<&RationalMap>, best: &Candidate) -> Vec<Candidate> {
    if !has_blocks(field, map) {
        return Vec::new();
    }
    let blocks = Blocks::of(field);
    let orders = blocks.without_elimination(ROW_ORDERS, 2 * best.operations);
    let empty = Writer::empty(field);
    let whole =
        empty.iter().flat_map(|empty| orders.iter().flat_map(|order| blocks.candidates(empty, order, 1)));
    let is_affordable =
        |form: &Candidate| 2 * form.price <= 3 * best.price && 2 * form.operations <= 3 * best.operations;
    sorted_by_key(whole.filter(is_affordable), |form| form.price)
}

fn terms(field: &Field) -> usize {
    field.numerators().map(Polynomial::len).sum()
}

impl WithDenominator {
    fn price(&mut self) -> u64 {
        let draft = &mut self.writer.draft;
        FormGoal::Early.price(draft.size_of(self.denominator.node), draft.ready(self.denominator.node))
    }
}

impl FactoredMap<'_> {
    fn best(&self) -> Option<Candidate> {
        let starts = self.empty.iter().flat_map(|empty| self.denominators(empty));
        let starts = starts.map(|mut start| (start.price(), start));
        let starts = sorted_by_key(starts, |(price, _)| *price);
        let has_determinants = starts.iter().any(|(_, start)| start.numerators.is_some());
        let mut to_try =
            if has_determinants && self.factor_terms() > FACTOR_TERMS { 0 } else { TRIED_DENOMINATORS };
        let mut best: Option<Candidate> = None;
        for (_, start) in starts {
            if start.numerators.is_none() {
                if to_try == 0 {
                    continue;
                }
                to_try -= 1;
            }
            let candidate = self.finish(start);
            if best.as_ref().is_none_or(|best| candidate.price < best.price) {
                best = Some(candidate);
            }
        }
        best
    }

    fn factor_terms(&self) -> usize {
        let factors = self.numerators.iter().flat_map(|numerator| &numerator.factors);
        factors.map(|(factor, _)| factor.len()).sum()
    }

    /// Writes the denominator in nested form, as a product, and as a determinant of A.
    fn denominators(&self, empty: &Writer) -> Vec<WithDenominator> {
        let mut starts = Vec::new();
        let polynomial = &self.map.reduced.denominator;
        let mut writer = empty.clone();
        let denominator = writer.write_scaled(polynomial, FormGoal::Early);
        starts.push(WithDenominator { writer, denominator, numerators: None });
        if self.denominator.factors.len() > 1 {
            let mut writer = empty.clone();
            let mut products = Products::new();
            products.push(&mut writer, &self.denominator, FormGoal::Early);
            let denominator = products.finish(&mut writer).remove(0);
            writer.remember_scaled(polynomial, denominator);
            starts.push(WithDenominator { writer, denominator, numerators: None });
        }
        starts.extend(self.determinants(empty));
        starts
    }

    /// Writes the denominator as a determinant of A, if there are two or three states and no common
    /// factor was divided out of the map.
    fn determinants(&self, empty: &Writer) -> Vec<WithDenominator> {
        let n = self.field.dimension();
        if self.map.reduced.common_factor.as_constant().is_none() || !(2..=3).contains(&n) {
            return Vec::new();
        }
        let matrix = scaled_matrix(self.field);
        let mut starts = Vec::new();
        // Each row is tried as the last in Laplace expansion. With two rows, the forms are equal.
        for last in if n == 2 { 1..2 } else { 0..n } {
            let mut writer = empty.clone();
            let Determinants { denominator, numerators } = self.expanded(&mut writer, &matrix, last);
            // If nothing was divided out of the map, this determinant is the reduced denominator.
            if map_is_unscaled(self.map) {
                writer.remember_scaled(&self.map.reduced.denominator, denominator);
                starts.push(WithDenominator { writer: writer.clone(), denominator, numerators: None });
            }
            if map_is_unscaled(self.map) && empty.scaling.folds {
                let mut writer = empty.clone();
                let denominator = writer.write_scaled(&self.map.reduced.denominator, FormGoal::Early);
                let Determinants { numerators, .. } = self.expanded(&mut writer, &matrix, last);
                starts.push(WithDenominator { writer, denominator, numerators: Some(numerators) });
            }
            starts.push(WithDenominator { writer, denominator, numerators: Some(numerators) });
        }
        starts
    }

    fn expanded(&self, writer: &mut Writer, matrix: &[Vec<Polynomial>], last: usize) -> Determinants {
        let eps = Polynomial::variable(self.field.symbols.epsilon());
        let row = |(row, component): (&Vec<Polynomial>, &RationalFunction)| {
            let right = &eps * component.numerator();
            row.iter().chain([&right]).map(|entry| writer.entry(entry, FormGoal::Few)).collect()
        };
        let mut rows: Vec<Vec<MatrixEntry>> = matrix.iter().zip(&self.field.components).map(row).collect();
        // A rotation of three rows keeps their determinant. For two rows, (last + 1) % 2 is 0.
        rows.rotate_left((last + 1) % matrix.len());
        determinants(writer, &rows)
    }

    fn finish(&self, start: WithDenominator) -> Candidate {
        let WithDenominator { mut writer, denominator, numerators } = start;
        let reciprocal = writer.reciprocal(&Rational::from(2), denominator.node);
        let numerators =
            numerators.unwrap_or_else(|| self.written_numerators(&mut writer, |_| Power::Eps, None));
        let over = |numerator| (numerator, reciprocal, denominator.negative);
        Candidate::over(writer, numerators.into_iter().map(over))
    }

    /// Returns a form with two divisions for a denominator with [two factors](Self::two_factors).
    /// Some components are divided by the first factor only.
    fn with_two_divisions(&self) -> Option<Candidate> {
        let (needed, other) = self.two_factors()?;
        self.divided_twice([needed, other], other, &Rational::from(2), [Power::Eps, Power::Eps])
    }
}

/// Returns whether no common factor was divided out of the map.
fn map_is_unscaled(map: &RationalMap) -> bool {
    map.denominator == map.reduced.denominator
}
