//! Elimination along the couplings: which entries of A(x,ε) are solved in which order, found once
//! for every state.
//!
//! In: a field whose step is too large for straight lines without pivots. Out: an order of
//! elimination, and for each row of A in that order where its entries lie, those that elimination
//! fills in among them. A step then costs what the couplings cost, and not the cube of the number
//! of variables. A variable's pivot is its entry on the diagonal, 1 − ε ∂fᵢ/∂xᵢ: rows are never
//! exchanged, so whoever computes with floats must look at what the pivots are.
//!
//! - `graph` knows which variables act on each other, and what an order fills in.
//! - `orders` proposes orders of a block: as written, in bands, by least degree.
//!
//! The blocks of a triangular field are solved one after the other: nothing fills in between them.

mod graph;
mod orders;

use kahan_syntax::diagnostics::{Diagnostic, Kind};
use kahan_syntax::table::distinct;
use kahan_syntax::token::Span;

use crate::field::Field;
use crate::kahan::{field_jacobian, pattern};
use crate::kept::Values;
use crate::plan::{DenseField, Plan, StepCost, triangular_blocks};
use crate::poly::Polynomial;

use graph::Graph;
use orders::cheapest;

/// The most variables of a field whose map is written out where that is possible. Beyond, every
/// step eliminates along the couplings.
pub const MOST_EXPANDED: usize = 8;

/// The most variables of a block that is compiled.
const MOST_VARIABLES: usize = 200;
/// The most parameters of a block that is compiled.
const MOST_PARAMETERS: usize = 2000;
/// The most entries of f′ that are not identically zero in a block of many variables that is
/// compiled.
const MOST_SLOPES: usize = 1500;

/// The most products in an elimination that is written as a straight line.
const MOST_STRAIGHT: usize = 1500;

/// The entries of A(x,ε), as elimination finds them. Rows and columns are counted in the order of
/// elimination, entries row after row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Couplings {
    /// Which variable is eliminated at each turn.
    pub order: Vec<usize>,
    /// The rows.
    pub rows: Vec<Row>,
    /// The column of each entry.
    pub columns: Vec<usize>,
    /// Where each block ends: the number of its last row and 1.
    pub blocks: Vec<usize>,
    /// Where the results of [`Self::slopes`] lie among the entries.
    pub places: Vec<usize>,
    /// The entries of f′(x) that are not identically zero.
    pub slopes: Plan,
    /// Of a field with very many products of variables the coefficients, if elimination fills A: for
    /// each component the constant, those of the variables, and those of their products xⱼxₖ with
    /// j ≤ k, row after row of that triangle. With them f is cᵢ + Σⱼ xⱼ·(bᵢⱼ + Σₖ qᵢⱼₖxₖ) with
    /// k ≥ j, and an entry of f′ is bᵢⱼ + Σₖ qᵢⱼₖxₖ, in which k = j counts twice; all sums are in
    /// this order.
    pub dense: Option<Plan>,
}

/// The places of a row's entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The first, in the column of an earlier block if there is one.
    pub start: usize,
    /// The first in the row's own block.
    pub own: usize,
    /// The one on the diagonal; those before it are eliminated.
    pub diagonal: usize,
    /// Behind the last.
    pub end: usize,
}

/// The error of a block that has too many parameters to be compiled; `None` for fewer. Derived
/// comparisons nest one expression a parameter, and rustc overflows its stack on deep ones.
#[must_use]
pub fn too_many_parameters(parameters: usize, span: Span) -> Option<Diagnostic> {
    (parameters > MOST_PARAMETERS).then(|| {
        Diagnostic::new(
            Kind::TooLarge,
            span,
            format!("{parameters} parameters are too many to compile: a block has at most {MOST_PARAMETERS}"),
            "write numbers for parameters that do not change",
        )
    })
}

/// What is wrong with a field that is to be compiled and has too many couplings for that.
#[must_use]
pub fn too_many_couplings(field: &Field, span: Span) -> Option<Diagnostic> {
    let variables = field.dimension();
    if variables <= MOST_EXPANDED {
        return None;
    }
    let slopes = field_jacobian(field).iter().flatten().filter(|slope| !slope.is_zero()).count();
    (variables > MOST_VARIABLES || slopes > MOST_SLOPES).then(|| {
        Diagnostic::new(
            Kind::TooLarge,
            span,
            format!(
                "{variables} variables with {slopes} couplings take too long to compile: a block has at most \
                 {MOST_VARIABLES} and {MOST_SLOPES}"
            ),
            "write the equations once, as a family: `for i in periodic { x[i]dot = …; }`",
        )
    })
}

impl Couplings {
    /// The couplings of a field, from f′ over its values; `dense` are its coefficients if it is
    /// dense.
    #[must_use]
    pub(crate) fn of(values: &Values, slopes: &[Vec<Polynomial>], dense: Option<&DenseField>) -> Self {
        let is_coupled = pattern(slopes);
        let graph = Graph::of(&is_coupled);
        let blocks: Vec<Vec<usize>> =
            triangular_blocks(&is_coupled).iter().map(|block| cheapest(&graph, block)).collect();
        let order = blocks.concat();
        let mut turns = vec![0; order.len()];
        order.iter().enumerate().for_each(|(turn, &i)| turns[i] = turn);
        let (mut rows, mut columns, mut ends) = (Vec::new(), Vec::new(), Vec::new());
        for block in &blocks {
            let first = rows.len();
            for (k, (row, &i)) in graph.filled(block).iter().zip(block).enumerate() {
                let start = columns.len();
                columns.extend(distinct(graph.row(i).iter().map(|&j| turns[j]).filter(|&turn| turn < first)));
                let own = columns.len();
                let diagonal = own + row.iter().take_while(|&&j| j < k).count();
                columns.extend(row.iter().map(|j| first + j));
                rows.push(Row { start, own, diagonal, end: columns.len() });
            }
            ends.push(rows.len());
        }
        let (mut places, mut written, mut entries) = (Vec::new(), Vec::new(), Vec::new());
        for (row, &i) in rows.iter().zip(&order) {
            for place in row.start..row.end {
                let j = order[columns[place]];
                let slope = &slopes[i][j];
                if !slope.is_zero() {
                    places.push(place);
                    entries.push((i, j));
                    written.push(slope);
                }
            }
        }
        let slopes = match dense {
            Some(dense) => dense.slopes(entries),
            None => values.plan(written),
        };
        let is_full = columns.len() == order.len().pow(2) && order.is_sorted();
        let dense = dense.filter(|_| is_full).map(DenseField::coefficients);
        Couplings { order, rows, columns, blocks: ends, places, slopes, dense }
    }

    /// Whether elimination is written as a straight line.
    #[must_use]
    pub fn is_straight(&self) -> bool {
        self.products() <= MOST_STRAIGHT
    }

    /// What a step costs, a product and the subtraction that follows counted twice.
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

    /// The products of elimination and of what is solved after it.
    fn products(&self) -> usize {
        let above = |place: usize| {
            let Row { diagonal, end, .. } = self.rows[self.columns[place]];
            end - diagonal
        };
        let row = |row: &Row| (row.own..row.diagonal).map(above).sum::<usize>() + row.end - row.start;
        self.rows.iter().map(row).sum()
    }

    /// Cycles from the entries to the last of the solution: a division and three multiply-adds for
    /// each pivot that waits for others.
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
