//! The step from the structure of A, without expanding its determinant: block after block, the
//! states of an independent set eliminated by their pivots, which are 1, and the rest by Cramer's
//! rule.
//!
//! For a block with states K, A_KK·(x̃ − x)_K = 2ε P_K(x, x̃) with P the polarised field, x̃ being
//! known in earlier blocks and x standing for x̃ in this one. For an independent set S of K and R
//! the others, A_SS = I, so that
//!
//! ```text
//! (A_RR − A_RS·A_SR)·(x̃ − x)_R = 2ε (P_R − A_RS·P_S)
//! (x̃ − x)_S = 2ε P_S(x, x̃) with x̃_R put in
//! ```
//!
//! A pivot of 1 beside entries of the size ‖εf′‖ costs that many digits in long steps. Where that
//! is [too much](super::accuracy), a block is solved whole: S is empty.

use std::ops::Range;

use crate::field::Field;
use crate::kahan::{polarization, scaled_matrix};
use crate::poly::{Polynomial, Variable};
use crate::rational::Rational;
use crate::symbols::Symbol;

use super::Node;
use super::candidate::Candidate;
use super::draft::Signed;
use super::minors::{self, Determinants, MOST_OPERATIONS, determinants};
use super::nesting::Goal;
use super::structure::Structure;
use super::writer::{Entry, Writer};

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
    /// The states that are solved for come from here on; those before them are known at both
    /// points.
    first: usize,
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
            first: 0,
        }
    }

    /// For the tangent vector v of a variational field, where x̃ is known besides x.
    ///
    /// Second states stand for x + x̃ and ṽ − v: then half of the terms of the polarised field
    /// cancel, and none of the others has a factor ½ that the field does not have, if it is
    /// doubled.
    pub(super) fn of_tangent(field: &'a Field) -> Self {
        let first = field.dimension() / 2;
        let mut blocks = Blocks { first, ..Blocks::of(field) };
        for polarized in &mut blocks.polarized {
            *polarized = polarized.scale(&Rational::from(2));
            for i in 0..2 * first {
                let [state, second] = [Symbol::State(i), Symbol::SecondState(i)]
                    .map(|symbol| Polynomial::variable(field.symbols.variable(symbol)));
                let shifted = if i < first { &second - &state } else { &second + &state };
                // Second states have degree 1 at most.
                let parts = polarized.coefficients_in(field.symbols.variable(Symbol::SecondState(i)));
                *polarized = parts.iter().fold(Polynomial::zero(), |sum, (degree, part)| match degree {
                    0 => &sum + part,
                    _ => &sum + &(part * &shifted),
                });
            }
        }
        blocks
    }

    /// Whether this is a tangent vector, whose polarised field is doubled.
    fn is_tangent(&self) -> bool {
        self.first > 0
    }

    /// The turns in which blocks are eliminated, at most `most` of them: after some, the rows of
    /// each block stand as they did.
    pub(super) fn turns(&self, most: usize) -> Range<usize> {
        let rows = |block: &[usize]| block.len() - self.structure.independent(block).len();
        let is_as_before = |turn: &usize| {
            self.solved().map(|block| rows(&block)).all(|rows| rows == 0 || turn.is_multiple_of(rows))
        };
        0..(1..most).find(is_as_before).unwrap_or(most)
    }

    /// The blocks that are solved for.
    fn solved(&self) -> impl Iterator<Item = Vec<usize>> {
        self.structure.blocks().into_iter().filter(|block| block[0] >= self.first)
    }

    /// The candidate in one manner; `None` where a block is too large.
    pub(super) fn candidate(&self, mut writer: Writer, manner: Manner) -> Option<Candidate> {
        self.put_sums(&mut writer);
        let still = (Signed::plus(writer.draft.zero()), None);
        let mut increments: Vec<Increment> = vec![still; self.field.dimension()];
        for block in self.solved() {
            self.solve(&block, manner, &mut writer, &mut increments)?;
        }
        let increments = &increments[self.first..];
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
            let reciprocal = match self.is_tangent() {
                true => writer.eps_over(denominator.node),
                false => writer.reciprocal(&Rational::from(2), denominator.node),
            };
            for (&i, numerator) in rest.iter().zip(numerators) {
                increments[i] = (numerator.flipped(denominator.negative), Some(reciprocal));
                self.put_next(writer, i, increments[i]);
            }
        }
        for i in independent {
            let eps = Polynomial::variable(self.field.symbols.epsilon());
            let time = eps.scale(&Rational::from(if self.is_tangent() { 1 } else { 2 }));
            let moved = self.with_known(&self.polarized[i], block, &rest);
            let written = writer.write_cheapest(&(&time * &moved));
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
        // A tangent vector has it in the reciprocal.
        let eps = match self.is_tangent() {
            true => Polynomial::one(),
            false => Polynomial::variable(self.field.symbols.epsilon()),
        };
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
    /// already; of a tangent vector, without their increments.
    fn with_known(&self, polarized: &Polynomial, block: &[usize], known: &[usize]) -> Polynomial {
        let symbols = &self.field.symbols;
        if self.is_tangent() {
            let unknown = block.iter().filter(|i| !known.contains(i));
            return unknown.fold(polarized.clone(), |polarized, &i| {
                polarized.substitute(symbols.variable(Symbol::SecondState(i)), &Rational::zero())
            });
        }
        polarized.map_variables(|variable| match symbols.symbol(variable) {
            Symbol::SecondState(i) if block.contains(&i) && !known.contains(&i) => symbols.state(i),
            _ => variable,
        })
    }

    /// x + x̃ of the states that are known.
    fn put_sums(&self, writer: &mut Writer) {
        for i in 0..self.first {
            let second = self.field.symbols.variable(Symbol::SecondState(i));
            let [state, next] =
                [self.field.symbols.state(i), second].map(|variable| writer.draft.input(variable));
            let sum = writer.draft.sum(&[Signed::plus(state), Signed::plus(next)]);
            writer.put(second, sum);
        }
    }

    /// x̃ᵢ = xᵢ + numerator · reciprocal, for what comes later; dropped if nothing uses it. Of a
    /// tangent vector, the increment alone.
    fn put_next(&self, writer: &mut Writer, i: usize, (increment, reciprocal): Increment) {
        let symbols = &self.field.symbols;
        let second: Variable = symbols.variable(Symbol::SecondState(i));
        let state = writer.draft.input(symbols.state(i));
        let step = match reciprocal {
            Some(reciprocal) => writer.draft.multiply(increment.node, reciprocal),
            None => increment.node,
        };
        let step = Signed { node: step, negative: increment.negative };
        let next = match self.is_tangent() {
            true => writer.draft.node(step),
            false => writer.draft.sum(&[Signed::plus(state), step]),
        };
        writer.put(second, next);
    }
}

/// Where entries are not zero.
fn pattern(rows: &[Vec<Polynomial>]) -> Vec<Vec<bool>> {
    rows.iter().map(|row| row.iter().map(|entry| !entry.is_zero()).collect()).collect()
}
