//! Solves A(x,ε)ᵀy = b from the entries of f′(x).

use std::collections::HashMap;

use super::Engine;
use super::couplings::{EliminationPattern, Factors};
use super::elimination::solve;
use super::floats::RuntimeFloat;

#[derive(Debug)]
pub(crate) struct TransposedSolver<'a, T> {
    variables: usize,
    /// The pattern of sparse elimination; `None` for fields that are eliminated densely.
    tables: Option<&'a EliminationPattern>,
    entries: Vec<(usize, usize)>,
    factors: Factors<T>,
    matrix: Vec<T>,
}

impl Engine {
    pub(crate) fn transposed<T>(&self) -> TransposedSolver<'_, T> {
        let variables = self.dimension();
        let tables = self.steps().form(false).couplings().map(|(_, tables)| tables);
        let entries = match tables {
            Some(tables) => tables.entries(),
            None => (0..variables).flat_map(|i| (0..variables).map(move |j| (i, j))).collect(),
        };
        TransposedSolver { variables, tables, entries, factors: Factors::default(), matrix: Vec::new() }
    }
}

impl<T: RuntimeFloat> TransposedSolver<'_, T> {
    pub(crate) fn entries(&self) -> &[(usize, usize)] {
        &self.entries
    }

    /// Returns a function that maps (i, j) to the index of ∂fᵢ/∂xⱼ among the entries of f′.
    pub(crate) fn places(&self) -> impl Fn(usize, usize) -> usize + use<T> {
        let places: HashMap<_, _> = self.entries.iter().copied().zip(0..).collect();
        move |i, j| places[&(i, j)]
    }

    /// Replaces b by A⁻ᵀb for A = I − εf′, f′ = `slopes`. If A is singular, b is not finite.
    pub(crate) fn solve(&mut self, slopes: &[T], eps: T, b: &mut [T]) {
        let n = self.variables;
        if let Some(tables) = self.tables {
            if T::factor(tables, slopes, &eps, &mut self.factors) {
                return tables.solve_transposed(&mut self.factors, b);
            }
            if tables.are_sparse() {
                tables.solve_by_pivoting(slopes, eps, b, true);
                return;
            }
        }
        let matrix = &mut self.matrix;
        matrix.clear();
        matrix.resize(n * n, T::zero());
        for ((i, j), slope) in self.entries.iter().zip(slopes) {
            matrix[j * n + i] = -(eps * *slope);
        }
        (0..n).for_each(|i| matrix[i * n + i] += T::one());
        solve(matrix, b, n);
    }
}
