//! The step from the structure of A, without expanding its determinant: block after block, the
//! states of an independent set eliminated by their pivots, which are 1, and the rest by Cramer's
//! rule.
//!
//! For a block with states K, A_KK·(x̃ − x)_K = 2ε P_K(x, x̃) with P the polarised field, x̃ being
//! known in earlier blocks and x standing for x̃ in this one. For an independent set S of K and R
//! the others, A_SS = I, so that
//!
//! ```text
//! (A_RR − A_RS·A_SR)·(x̃ − x)_R = 2ε (P_R − A_RS·P_S),      (x̃ − x)_S = 2ε P_S(x, x̃) with x̃_R put in.
//! ```
//!
//! A pivot of 1 beside entries of the size ‖εf′‖ costs that many digits in long steps. Where that
//! is [too much](super::accuracy), a block is solved whole: S is empty.

use crate::field::Field;
use crate::kahan::{polarization, scaled_matrix};
use crate::poly::{Polynomial, Variable};
use crate::rational::Rational;
use crate::symbols::Symbol;

use super::Node;
use super::candidate::Candidate;
use super::draft::Signed;
use super::minors::{self, Determinants, determinants};
use super::nesting::Goal;
use super::structure::Structure;
use super::writer::{Entry, Writer};

/// The most operations of Cramer's rule in one block; beyond, elimination with pivoting in a loop
/// is faster.
const MOST_OPERATIONS: usize = 600;
/// The most terms of a right-hand side for which all ways to distribute ε are compared.
const COMPARED_TERMS: usize = 12;
/// The most terms of an entry that is expanded.
const ENTRY_TERMS: usize = 40;

/// What all turns and scalings of one field share.
pub(super) struct Blocks<'a> {
    field: &'a Field,
    matrix: Vec<Vec<Polynomial>>,
    polarized: Vec<Polynomial>,
    structure: Structure,
}

/// How blocks are solved.
#[derive(Clone, Copy, Debug)]
pub(super) enum Manner {
    /// The states of an independent set by their pivots, the others by minors, along the row that
    /// is last after so many rotations.
    Eliminating(usize),
    /// All states by minors of at most so many operations, the rows in the order that so many
    /// others are cheaper than.
    Whole { rank: usize, operations: usize },
}

/// x̃ᵢ − xᵢ: a numerator with its sign, and its reciprocal.
type Increment = (Signed, Option<Node>);

impl<'a> Blocks<'a> {
    pub(super) fn of(field: &'a Field) -> Self {
        Blocks {
            field,
            matrix: scaled_matrix(field),
            polarized: polarization(field),
            structure: Structure::of(field),
        }
    }

    /// The candidate in one manner; `None` where a block is too large.
    pub(super) fn candidate(&self, mut writer: Writer, manner: Manner) -> Option<Candidate> {
        let still = (Signed::plus(writer.draft.zero()), None);
        let mut increments: Vec<Increment> = vec![still; self.field.dimension()];
        for block in &self.structure.blocks() {
            self.solve(block, manner, &mut writer, &mut increments)?;
        }
        let numerator = |(signed, _): &Increment| match signed.negative {
            // Its value is a part of x̃ in this plan, so a difference is not turned round.
            true => writer.draft.builder.changed_sign(signed.node),
            false => signed.node,
        };
        let numerators = increments.iter().map(numerator).collect();
        let reciprocals = increments.iter().map(|(_, reciprocal)| *reciprocal).collect();
        Some(Candidate::new(writer, numerators, reciprocals))
    }

    fn solve(
        &self,
        block: &[usize],
        manner: Manner,
        writer: &mut Writer,
        increments: &mut [Increment],
    ) -> Option<()> {
        let independent = match manner {
            Manner::Eliminating(_) => self.structure.independent(block),
            Manner::Whole { .. } => Vec::new(),
        };
        let rest: Vec<usize> = block.iter().copied().filter(|i| !independent.contains(i)).collect();
        if !rest.is_empty() {
            let mut rows = self.reduced_rows(block, &independent, &rest)?;
            let (turn, most) = match manner {
                Manner::Eliminating(turn) => (turn % rows.len(), MOST_OPERATIONS),
                Manner::Whole { rank, operations } => {
                    let order = minors::cheap_order(&pattern(&rows), rank);
                    rows = order.into_iter().map(|i| std::mem::take(&mut rows[i])).collect();
                    (0, operations.min(MOST_OPERATIONS))
                }
            };
            if minors::operations(&pattern(&rows)) > most {
                return None;
            }
            let mut written: Vec<Vec<Entry>> = rows
                .iter()
                .map(|row| {
                    let last = row.len() - 1;
                    let entry = |(j, entry): (usize, &Polynomial)| match j == last {
                        true if entry.len() <= COMPARED_TERMS => writer.cheapest_entry(entry),
                        true => writer.entry(entry, Goal::Few),
                        false => writer.entry(entry, Goal::Early),
                    };
                    row.iter().enumerate().map(entry).collect()
                })
                .collect();
            // An odd order of the rows changes all signs, which cancel in the quotients.
            written.rotate_left(turn);
            let Determinants { denominator, numerators } = determinants(writer, &written);
            let reciprocal = writer.reciprocal(&Rational::from(2), denominator.node);
            for (&i, numerator) in rest.iter().zip(numerators) {
                increments[i] = (numerator.flipped(denominator.negative), Some(reciprocal));
                self.put_next(writer, i, increments[i]);
            }
        }
        for i in independent {
            let twice_eps = Polynomial::variable(self.field.symbols.epsilon()).scale(&Rational::from(2));
            let moved = self.with_known(&self.polarized[i], block, &rest);
            let written = writer.write_cheapest(&(&twice_eps * &moved));
            increments[i] = (written, None);
            self.put_next(writer, i, increments[i]);
        }
        Some(())
    }

    /// A_RR − A_RS·A_SR with the right-hand side ε(P_R − A_RS·P_S) appended, row by row.
    fn reduced_rows(
        &self,
        block: &[usize],
        independent: &[usize],
        rest: &[usize],
    ) -> Option<Vec<Vec<Polynomial>>> {
        let eps = Polynomial::variable(self.field.symbols.epsilon());
        let right = |i: usize| &eps * &self.with_known(&self.polarized[i], block, &[]);
        let rows = rest.iter().map(|&i| {
            let eliminated = |start: Polynomial, entry: &dyn Fn(usize) -> Polynomial| {
                independent
                    .iter()
                    .filter(|&&s| !self.matrix[i][s].is_zero())
                    .fold(start, |sum, &s| &sum - &(&self.matrix[i][s] * &entry(s)))
            };
            let mut row: Vec<Polynomial> = rest
                .iter()
                .map(|&j| eliminated(self.matrix[i][j].clone(), &|s| self.matrix[s][j].clone()))
                .collect();
            row.push(eliminated(right(i), &right));
            row
        });
        let rows: Vec<Vec<Polynomial>> = rows.collect();
        rows.iter().flatten().all(|entry| entry.len() <= ENTRY_TERMS).then_some(rows)
    }

    /// The polarised field with x for x̃ in the states of the block, but for those that are known
    /// already.
    fn with_known(&self, polarized: &Polynomial, block: &[usize], known: &[usize]) -> Polynomial {
        let symbols = &self.field.symbols;
        polarized.map_variables(|variable| match symbols.symbol(variable) {
            Symbol::SecondState(i) if block.contains(&i) && !known.contains(&i) => symbols.state(i),
            _ => variable,
        })
    }

    /// x̃ᵢ = xᵢ + numerator · reciprocal, for what comes later; dropped if nothing uses it.
    fn put_next(&self, writer: &mut Writer, i: usize, (increment, reciprocal): Increment) {
        let symbols = &self.field.symbols;
        let second: Variable = symbols.variable(Symbol::SecondState(i));
        let state = writer.draft.input(symbols.state(i));
        let step = match reciprocal {
            Some(reciprocal) => writer.draft.multiply(increment.node, reciprocal),
            None => increment.node,
        };
        let next =
            writer.draft.sum(&[Signed::plus(state), Signed { node: step, negative: increment.negative }]);
        writer.put(second, next);
    }
}

/// Where entries are not zero.
fn pattern(rows: &[Vec<Polynomial>]) -> Vec<Vec<bool>> {
    rows.iter().map(|row| row.iter().map(|entry| !entry.is_zero()).collect()).collect()
}
