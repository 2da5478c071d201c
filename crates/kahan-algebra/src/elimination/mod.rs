//! Plans the sparse elimination of A(x,ε) = I − εf′(x). One plan serves all points x.
//!
//! The result lists the positions of all entries, fill-in included. The pivots are the diagonal
//! entries, which begin as 1 − ε ∂fᵢ/∂xᵢ. Rows are never exchanged, so callers must check that no
//! pivot is too small. The blocks of a triangular field are eliminated one after another.

mod graph;
mod orders;

use kahan_syntax::diagnostics::{Diagnostic, Kind};
use kahan_syntax::table::sorted_by_key;
use kahan_syntax::token::Span;

use crate::field::Field;
use crate::kahan::SparseRows;
use crate::plan::{DenseField, Plan, StepCost, triangular_blocks};
use crate::subexpressions::Subexpressions;

use graph::{Graph, positions};
use orders::cheapest;

/// The largest dimension of a field whose map may be written as expanded formulas. Steps of larger
/// fields always use elimination.
pub const MOST_EXPANDED: usize = 8;

/// The most variables that a block of `kahan!` may have in compiled code.
pub const MOST_VARIABLES: usize = 200;
const MOST_PARAMETERS: usize = 2000;
/// The most nonzero entries of f′ in a block of `kahan!` with more than `MOST_EXPANDED` variables.
const MOST_SLOPES: usize = 1500;

/// The most multiplications of an elimination that is written as straight-line code, not as loops.
const MOST_STRAIGHT: usize = 1500;

/// The entries of A(x,ε) that may become nonzero during elimination, by rows. Rows and columns are
/// numbered in order of elimination.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Couplings {
    /// The variable that is eliminated at each position.
    pub order: Vec<usize>,
    /// The rows.
    pub rows: Vec<Row>,
    /// The column of each entry.
    pub columns: Vec<usize>,
    /// The index after the last row of each block.
    pub blocks: Vec<usize>,
    /// For each output of [`Self::slopes`], the index of its entry in [`Self::columns`].
    pub places: Vec<usize>,
    /// The plan of the entries of f′(x) that are not identically zero.
    pub slopes: Plan,
}

/// The positions in the list of entries at which a row and its parts begin and end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The position of the first entry. Entries before `own` are in columns of earlier blocks.
    pub start: usize,
    /// The position of the first entry in the row's own block.
    pub own: usize,
    /// The position of the diagonal entry. Earlier entries are eliminated.
    pub diagonal: usize,
    /// The position after the last entry of the row.
    pub end: usize,
}

/// Returns a diagnostic if a block has too many parameters. For a struct with very many fields, the
/// code of `derive(PartialEq)` overflows the stack of rustc.
#[must_use]
pub fn too_many_parameters(parameters: usize, span: Span) -> Option<Diagnostic> {
    (parameters > MOST_PARAMETERS).then(|| {
        let message =
            format!("{parameters} parameters are too many to compile: a block has at most {MOST_PARAMETERS}");
        let help = "write numbers for parameters that do not change";
        Diagnostic::new(Kind::TooLarge, span, message, help)
    })
}

/// Returns a diagnostic if the field has too many variables or too many nonzero entries of f′.
#[must_use]
pub fn too_many_couplings(field: &Field, span: Span) -> Option<Diagnostic> {
    let variables = field.dimension();
    if variables <= MOST_EXPANDED {
        return None;
    }
    let is_state = |variable| field.symbols.is_state(variable);
    let slopes = field.components.iter().map(|component| component.numerator().gradient(is_state).len());
    let slopes: usize = slopes.sum();
    (variables > MOST_VARIABLES || slopes > MOST_SLOPES).then(|| {
        let message = format!(
            "{variables} variables with {slopes} couplings take too long to compile: a block has at most \
             {MOST_VARIABLES} and {MOST_SLOPES}"
        );
        let help = "write the equations once, as a family: `for i in periodic { x[i]dot = …; }`";
        Diagnostic::new(Kind::TooLarge, span, message, help)
    })
}

impl Couplings {
    /// Returns the entries of A for a field with Jacobian `slopes`. The entries of `slopes` may
    /// contain the named subexpressions `values`.
    #[must_use]
    pub(crate) fn of(values: &Subexpressions, slopes: &SparseRows) -> Self {
        let depends: Vec<Vec<usize>> =
            slopes.iter().map(|row| row.iter().map(|(j, _)| *j).collect()).collect();
        let mut blocks = triangular_blocks(&depends);
        let mut all_filled = Vec::with_capacity(blocks.len());
        for (graph, block) in Graph::of_blocks(&depends, &blocks).iter().zip(&mut blocks) {
            let (order, filled) = cheapest(graph);
            *block = order.into_iter().map(|place| block[place]).collect();
            all_filled.push(filled);
        }
        let order = blocks.concat();
        let turns = positions(&order);
        let (mut rows, mut columns, mut ends) = (Vec::new(), Vec::new(), Vec::new());
        let (mut places, mut written) = (Vec::new(), Vec::new());
        for (block, filled) in blocks.iter().zip(all_filled) {
            let first = rows.len();
            for (filled, &i) in filled.rows.iter().zip(block) {
                let by_turns =
                    sorted_by_key(slopes[i].iter().map(|(j, slope)| (turns[*j], slope)), |of| of.0);
                let start = columns.len();
                columns.extend(by_turns.iter().map(|of| of.0).take_while(|&turn| turn < first));
                let own = columns.len();
                columns.extend(filled.columns.iter().map(|j| first + j));
                for (turn, slope) in by_turns {
                    let place = columns[start..].binary_search(&turn).expect("each entry has a place");
                    places.push(start + place);
                    written.push(slope);
                }
                rows.push(Row { start, own, diagonal: own + filled.diagonal, end: columns.len() });
            }
            ends.push(rows.len());
        }
        let slopes = values.plan(written);
        Couplings { order, rows, columns, blocks: ends, places, slopes }
    }

    /// Returns the entries of A for a dense field: all n² entries, row by row.
    #[must_use]
    pub(crate) fn of_all(dense: &DenseField) -> Self {
        let n = dense.dimension();
        let row = |i: usize| Row { start: i * n, own: i * n, diagonal: i * n + i, end: (i + 1) * n };
        let entries: Vec<(usize, usize)> = dense.entries().filter(|entry| dense.depends(*entry)).collect();
        Couplings {
            order: (0..n).collect(),
            rows: (0..n).map(row).collect(),
            columns: (0..n * n).map(|place| place % n).collect(),
            blocks: vec![n],
            places: entries.iter().map(|(i, j)| i * n + j).collect(),
            slopes: dense.slopes(entries),
        }
    }

    /// Returns whether elimination is written as straight-line code.
    #[must_use]
    pub fn is_straight(&self) -> bool {
        self.products() <= MOST_STRAIGHT
    }

    /// Returns the cost of a step. Subtracting a product is counted as two operations.
    #[must_use]
    pub fn cost(&self, field: &Plan) -> StepCost {
        let (of_slopes, of_field, n) = (self.slopes.cost(), field.cost(), self.order.len());
        let scaled = 2 * self.places.len() + n;
        let operations =
            of_slopes.operations() + of_field.operations() + scaled + 2 * self.products() + 3 * n;
        let critical_path =
            of_slopes.critical_path.max(of_field.critical_path) as usize + self.critical_path();
        let count = |number: usize| {
            u32::try_from(number).expect("fields that are eliminated have a most of variables")
        };
        StepCost { operations: count(operations), divisions: count(n), critical_path: count(critical_path) }
    }

    fn products(&self) -> usize {
        let above = |place: usize| {
            let Row { diagonal, end, .. } = self.rows[self.columns[place]];
            end - diagonal
        };
        let row = |row: &Row| (row.own..row.diagonal).map(above).sum::<usize>() + row.end - row.start;
        self.rows.iter().map(row).sum()
    }

    /// Returns the latency in cycles of the longest chain of dependent pivots. A pivot takes one
    /// division and three multiply-adds.
    fn critical_path(&self) -> usize {
        const PIVOT: usize = 26;
        let mut chains: Vec<usize> = Vec::with_capacity(self.rows.len());
        for row in &self.rows {
            let before = self.columns[row.start..row.diagonal].iter().map(|&j| chains[j]).max();
            chains.push(before.unwrap_or(0) + PIVOT);
        }
        chains.into_iter().max().unwrap_or(0)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    //! Random lists of dependences to test blocks, orders and fill-in.

    use kahan_syntax::table::distinct;

    use crate::prime_field::SplitMix64;

    pub(crate) fn below(random: &mut SplitMix64, end: usize) -> usize {
        usize::try_from(random.below(end as u64)).expect("below a usize")
    }

    pub(crate) fn permutation(random: &mut SplitMix64, n: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..n).collect();
        (1..n).for_each(|k| order.swap(k, below(random, k + 1)));
        order
    }

    pub(crate) fn random_rows(random: &mut SplitMix64, n: usize, mutual: bool) -> Vec<Vec<usize>> {
        let mut rows = vec![Vec::new(); n];
        for _ in 0..n * (1 + below(random, 5)) / 2 {
            let (i, j) = (below(random, n), below(random, n));
            rows[i].push(j);
            if mutual {
                rows[j].push(i);
            }
        }
        rows.into_iter().map(distinct).collect()
    }
}
