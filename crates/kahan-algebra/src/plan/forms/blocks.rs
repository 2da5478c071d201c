//! Solves for x̃ block by block without expanding det A.
//!
//! Let P be the polarised field in which x replaces x̃ in the states of a block K. The block
//! satisfies A_KK·(x̃ − x)_K = 2ε P_K(x, x̃). For an independent set S of states in K, A_SS is the
//! identity. With R for the other states of K,
//!
//! ```text
//! (A_RR − A_RS·A_SR)·(x̃ − x)_R = 2ε (P_R − A_RS·P_S)
//! (x̃ − x)_S = 2ε P_S(x, x̃) with x̃_R put in
//! ```
//!
//! Beside large entries, elimination loses digits. If too many are lost, forms
//! with an empty set S are tried ([accuracy](crate::plan::accuracy)).

mod solve;

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::kahan::{pattern, polarization, scaled_matrix};
use crate::poly::Polynomial;
use crate::symbols::Symbol;

use crate::plan::forms::minors;
use crate::plan::forms::minors::MOST_OPERATIONS;
use crate::plan::forms::structure::Structure;

const ENTRY_TERMS: usize = 40;

pub(in crate::plan) struct Blocks<'a> {
    field: &'a Field,
    matrix: Vec<Vec<Polynomial>>,
    polarized: Vec<Polynomial>,
    structure: Structure,
    /// The index of the first state to solve for. The images of earlier states are known.
    first: usize,
}

/// A block of states. The `independent` states do not depend on each other; `rest` are the others.
/// First, Cramer's rule for the equations `rows` gives the increments x̃ᵢ − xᵢ of `rest`. Then the
/// increments of `independent` are the polarised components `moved` times the time step.
#[derive(PartialEq)]
struct Block {
    rest: Vec<usize>,
    /// The equations of `rest` after the independent states were eliminated, with the right-hand
    /// side as last column.
    rows: Vec<Vec<Polynomial>>,
    independent: Vec<usize>,
    moved: Vec<Polynomial>,
}

/// The blocks in the order of their solution.
#[derive(PartialEq)]
pub(in crate::plan) struct BlockOrder(Vec<Block>);

impl<'a> Blocks<'a> {
    pub(in crate::plan) fn of(field: &'a Field) -> Self {
        Blocks {
            field,
            matrix: scaled_matrix(field),
            polarized: polarization(field),
            structure: Structure::of(field),
            first: 0,
        }
    }

    /// Prepares the map v ↦ ṽ of tangent vectors for known x and x̃.
    ///
    /// Symbols `SecondState` mean x + x̃ for states x, and ṽ − v for states v. This halves the
    /// number of terms. The polarised field is doubled to remove the factors ½.
    pub(in crate::plan) fn of_tangent(field: &'a Field) -> Self {
        let first = field.dimension() / 2;
        let mut blocks = Blocks { first, ..Blocks::of(field) };
        for polarized in &mut blocks.polarized {
            *polarized = polarized.scale(&Rational::from(2));
            for i in 0..2 * first {
                let [state, second] = [Symbol::State(i), Symbol::SecondState(i)]
                    .map(|symbol| Polynomial::variable(field.symbols.variable(symbol)));
                let shifted = if i < first { &second - &state } else { &second + &state };
                let parts = polarized.coefficients_in(field.symbols.variable(Symbol::SecondState(i)));
                *polarized = parts.iter().fold(Polynomial::zero(), |sum, (degree, part)| match degree {
                    0 => &sum + part,
                    _ => &sum + &(part * &shifted),
                });
            }
        }
        blocks
    }

    fn is_tangent(&self) -> bool {
        self.first > 0
    }

    /// Eliminates the independent states of each block. Returns `None` if a block is too large.
    pub(in crate::plan) fn with_elimination(&self) -> Option<BlockOrder> {
        let block = |block: Vec<usize>| {
            let independent = self.structure.independent(&block);
            self.block(&block, independent, |rows| rows).filter(|block| block.operations() <= MOST_OPERATIONS)
        };
        self.solved().map(block).collect::<Option<_>>().map(BlockOrder)
    }

    /// Returns the solutions by Cramer's rule alone, without elimination of independent states. Up
    /// to `orders` orders of rows are tried. A block needs at most `operations` operations.
    pub(in crate::plan) fn without_elimination(&self, orders: usize, operations: usize) -> Vec<BlockOrder> {
        let most = operations.min(MOST_OPERATIONS);
        let arrangement = |rank: usize| {
            let in_order = |mut rows: Vec<Vec<Polynomial>>| {
                let order = minors::cheap_order(&pattern(&rows), rank);
                order.into_iter().map(|i| std::mem::take(&mut rows[i])).collect()
            };
            let block = |block: Vec<usize>| {
                self.block(&block, Vec::new(), in_order).filter(|block| block.operations() <= most)
            };
            self.solved().map(block).collect::<Option<_>>().map(BlockOrder)
        };
        let mut distinct: Vec<BlockOrder> = Vec::new();
        for next in (0..orders).filter_map(arrangement) {
            if !distinct.contains(&next) {
                distinct.push(next);
            }
        }
        distinct
    }

    fn solved(&self) -> impl Iterator<Item = Vec<usize>> {
        self.structure.blocks().into_iter().filter(|block| block[0] >= self.first)
    }

    fn block(
        &self,
        block: &[usize],
        independent: Vec<usize>,
        in_order: impl Fn(Vec<Vec<Polynomial>>) -> Vec<Vec<Polynomial>>,
    ) -> Option<Block> {
        let rest: Vec<usize> = block.iter().copied().filter(|i| !independent.contains(i)).collect();
        let rows = if rest.is_empty() { Vec::new() } else { self.reduced_rows(block, &independent, &rest)? };
        let moved = |&i: &usize| self.with_known(&self.polarized[i], block, &rest);
        let moved = independent.iter().map(moved).collect();
        Some(Block { rest, rows: in_order(rows), independent, moved })
    }

    /// Returns the equations of the states in `rest` after the independent states were eliminated,
    /// with the right-hand side as last column.
    fn reduced_rows(
        &self,
        block: &[usize],
        independent: &[usize],
        rest: &[usize],
    ) -> Option<Vec<Vec<Polynomial>>> {
        // For tangent vectors, reciprocals are ε/det and not 2/det; therefore the rows omit ε.
        let eps = match self.is_tangent() {
            true => Polynomial::one(),
            false => Polynomial::variable(self.field.symbols.epsilon()),
        };
        let right = |i: usize| &eps * &self.with_known(&self.polarized[i], block, &[]);
        let rows = rest.iter().map(|&i| {
            let eliminated = |start: Polynomial, entry: &dyn Fn(usize) -> Polynomial| {
                let coupled = independent.iter().filter(|&&s| !self.matrix[i][s].is_zero());
                coupled.fold(start, |sum, &s| &sum - &(&self.matrix[i][s] * &entry(s)))
            };
            let entry = |&j: &usize| eliminated(self.matrix[i][j].clone(), &|s| self.matrix[s][j].clone());
            let mut row: Vec<Polynomial> = rest.iter().map(entry).collect();
            row.push(eliminated(right(i), &right));
            row
        });
        let rows: Vec<Vec<Polynomial>> = rows.collect();
        rows.iter().flatten().all(|entry| entry.len() <= ENTRY_TERMS).then_some(rows)
    }

    /// Replaces x̃ᵢ by xᵢ for each state i in `block` but not in `known`. For a tangent vector,
    /// replaces the increment ṽᵢ − vᵢ by 0 instead.
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
}

impl Block {
    fn operations(&self) -> usize {
        minors::operations(&pattern(&self.rows))
    }
}
