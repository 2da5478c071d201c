//! Writes the solution of all blocks as candidate forms of a step.

use std::ops::Range;

use kahan_syntax::rational::Rational;

use crate::poly::{Polynomial, Variable};
use crate::symbols::Symbol;

use super::Block;
use super::BlockOrder;
use super::Blocks;
use crate::plan::Node;
use crate::plan::forms::candidate::Candidate;
use crate::plan::forms::minors::{Determinants, determinants};
use crate::plan::writing::nesting::FormGoal;
use crate::plan::writing::plan_draft::Signed;
use crate::plan::writing::writer::{MatrixEntry, Writer};

/// For right-hand sides of at most this many terms, all ways to multiply ε into them are compared.
const COMPARED_TERMS: usize = 12;

/// The numerator of the increment x̃ᵢ − xᵢ, and the reciprocal that multiplies it, if any.
type Increment = (Signed, Option<Node>);

#[derive(Clone)]
struct Solution {
    writer: Writer,
    increments: Vec<Increment>,
}

impl BlockOrder {
    /// Returns the numbers of places by which rows are rotated: 0, 1, …, at most `most` of them.
    fn row_rotations(&self, most: usize) -> Range<usize> {
        let is_as_before = |turn: &usize| {
            self.0.iter().all(|block| block.rows.is_empty() || turn.is_multiple_of(block.rows.len()))
        };
        0..(1..most).find(is_as_before).unwrap_or(most)
    }
}

impl Blocks<'_> {
    /// Returns a candidate for each rotation of rows. The first block's rows are written only once.
    pub(in super::super) fn candidates(
        &self,
        empty: &Writer,
        arrangement: &BlockOrder,
        turns: usize,
    ) -> Vec<Candidate> {
        let Some((first, others)) = arrangement.0.split_first() else { return Vec::new() };
        let mut start = self.start(empty);
        let rows = start.written_rows(first);
        let candidate = |turn: usize| {
            let mut solution = start.clone();
            self.solve(first, rows.clone(), turn, &mut solution);
            for block in others {
                let rows = solution.written_rows(block);
                self.solve(block, rows, turn, &mut solution);
            }
            solution.candidate(self.first)
        };
        arrangement.row_rotations(turns).map(candidate).collect()
    }

    fn start(&self, empty: &Writer) -> Solution {
        let mut writer = empty.clone();
        self.put_sums(&mut writer);
        let still = (Signed::plus(writer.draft.zero()), None);
        Solution { writer, increments: vec![still; self.field.dimension()] }
    }

    fn solve(&self, block: &Block, mut rows: Vec<Vec<MatrixEntry>>, turn: usize, solution: &mut Solution) {
        let Solution { writer, increments } = solution;
        if !rows.is_empty() {
            let turn = turn % rows.len();
            rows.rotate_left(turn);
            let Determinants { denominator, numerators } = determinants(writer, &rows);
            let reciprocal = match self.is_tangent() {
                true => writer.eps_over(denominator.node),
                false => writer.reciprocal(&Rational::from(2), denominator.node),
            };
            for (&i, numerator) in block.rest.iter().zip(numerators) {
                increments[i] = (numerator.flipped(denominator.negative), Some(reciprocal));
                self.put_next(writer, i, increments[i]);
            }
        }
        let eps = Polynomial::variable(self.field.symbols.epsilon());
        let time = eps.scale(&Rational::from(if self.is_tangent() { 1 } else { 2 }));
        for (&i, moved) in block.independent.iter().zip(&block.moved) {
            let written = writer.write_cheapest(&(&time * moved));
            increments[i] = (written, None);
            self.put_next(writer, i, increments[i]);
        }
    }

    /// Replaces `SecondState(i)` by xᵢ + x̃ᵢ for each state with a known image x̃ᵢ.
    fn put_sums(&self, writer: &mut Writer) {
        for i in 0..self.first {
            let second = self.field.symbols.variable(Symbol::SecondState(i));
            let [state, next] =
                [self.field.symbols.state(i), second].map(|variable| writer.draft.input(variable));
            let sum = writer.draft.sum(&[Signed::plus(state), Signed::plus(next)]);
            writer.put(second, sum);
        }
    }

    /// Writes x̃ᵢ = xᵢ + numerator · reciprocal. For a tangent vector, writes the increment only.
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

impl Solution {
    fn written_rows(&mut self, block: &Block) -> Vec<Vec<MatrixEntry>> {
        let writer = &mut self.writer;
        let mut written_row = |row: &Vec<Polynomial>| {
            let last = row.len() - 1;
            let entry = |(j, entry): (usize, &Polynomial)| match j == last {
                true if entry.len() <= COMPARED_TERMS => writer.cheapest_entry(entry),
                true => writer.entry(entry, FormGoal::Few),
                false => writer.entry(entry, FormGoal::Early),
            };
            row.iter().enumerate().map(entry).collect()
        };
        block.rows.iter().map(&mut written_row).collect()
    }

    fn candidate(self, first: usize) -> Candidate {
        let Solution { mut writer, increments } = self;
        let increments = &increments[first..];
        let numerator = |(signed, _): &Increment| match signed.negative {
            true => writer.draft.builder.changed_sign(signed.node),
            false => signed.node,
        };
        let numerators = increments.iter().map(numerator).collect();
        let reciprocals = increments.iter().map(|(_, reciprocal)| *reciprocal).collect();
        Candidate::new(writer, numerators, reciprocals)
    }
}
