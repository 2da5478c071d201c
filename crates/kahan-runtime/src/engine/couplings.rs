//! Sparse elimination for fields of many variables, on slices.
//!
//! In: the entries of f′(x), and ε, half the time step. Out: factors of A(x,ε) = I − εf′(x), and
//! solutions of systems with A. `kahan-algebra` chooses the order of elimination, and `kahan-core`
//! computes. If a pivot is too small, a second elimination exchanges rows.

use std::sync::OnceLock;

use kahan_algebra::elimination::{self, MOST_VARIABLES};
use kahan_core::__private::{CouplingRow, Couplings, LARGEST_FACTOR, PanelWorkspace, Supernodes};
use kahan_core::{Constant, Scalar};

use super::elimination::solve_sparse;
use super::floats::MachineFloat;

/// From this number of entries of A(x,ε) on, blocks of consecutive rows are eliminated together.
const FEWEST_IN_PANELS: usize = 16_000;

/// The sparsity pattern of A(x,ε) in the order of elimination, including fill-in.
#[derive(Debug)]
pub struct EliminationPattern {
    order: Vec<u32>,
    rows: Vec<CouplingRow>,
    columns: Vec<u32>,
    blocks: Vec<u32>,
    places: Vec<u32>,
    panels: OnceLock<Supernodes>,
}

/// The workspace of an [`EliminationPattern`]: the entries of A(x,ε), or the triangular factors.
#[derive(Clone, Debug)]
pub struct Factors<V> {
    values: Vec<V>,
    row: Vec<V>,
    panels: PanelWorkspace<V>,
}

impl<V> Default for Factors<V> {
    fn default() -> Self {
        Factors { values: Vec::new(), row: Vec::new(), panels: PanelWorkspace::default() }
    }
}

impl EliminationPattern {
    pub(super) fn of(couplings: &elimination::Couplings) -> Self {
        let number = |number: &usize| u32::try_from(*number).expect("fewer places than fill the memory");
        let list = |numbers: &[usize]| numbers.iter().map(number).collect();
        let row = |row: &elimination::Row| {
            CouplingRow::new(number(&row.start), number(&row.own), number(&row.diagonal), number(&row.end))
        };
        EliminationPattern {
            order: list(&couplings.order),
            rows: couplings.rows.iter().map(row).collect(),
            columns: list(&couplings.columns),
            blocks: list(&couplings.blocks),
            places: list(&couplings.places),
            panels: OnceLock::new(),
        }
    }

    fn couplings(&self) -> Couplings<'_> {
        let EliminationPattern { order, rows, columns, blocks, places, .. } = self;
        Couplings { order, rows, columns, blocks, places }
    }

    /// Writes A(x,ε) from the entries of f′, and resizes the workspace.
    fn filled<'a, V: Scalar>(&'a self, slopes: &[V], eps: &V, factors: &mut Factors<V>) -> Couplings<'a> {
        factors.values.resize(self.columns.len(), V::zero());
        factors.row.resize(self.order.len(), V::zero());
        let couplings = self.couplings();
        couplings.fill(slopes, eps, &mut factors.values);
        couplings
    }

    /// Factors A(x,ε) from the entries of f′(x); returns `false` if a pivot is too small.
    pub(crate) fn factor<V: Scalar>(&self, slopes: &[V], eps: &V, factors: &mut Factors<V>) -> bool {
        let couplings = self.filled(slopes, eps, factors);
        couplings.factor(&mut factors.values, &mut factors.row)
    }

    fn has_panels(&self) -> bool {
        self.columns.len() >= FEWEST_IN_PANELS
    }

    /// Returns whether elimination with pivoting stores sparse rows: A is large and not full.
    pub(super) fn are_sparse(&self) -> bool {
        let variables = self.order.len();
        variables > MOST_VARIABLES && self.columns.len() < variables * variables
    }

    pub(crate) fn factor_in_lanes<T: MachineFloat>(
        &self,
        slopes: &[T],
        eps: &T,
        factors: &mut Factors<T>,
    ) -> bool {
        if !self.has_panels() {
            return self.factor(slopes, eps, factors);
        }
        let couplings = self.filled(slopes, eps, factors);
        let supernodes = self.panels.get_or_init(|| Supernodes::of(&couplings));
        supernodes.factor(&couplings, self.are_sparse(), &mut factors.values, &mut factors.panels)
    }

    /// Factors A(x,ε) without testing pivots, and returns the maximum of min(m, q) over the pivots.
    /// Here m is the largest multiplier in a pivot's column, and q the largest quotient of an entry
    /// in its row by the pivot. Pivots with no such entry or no multiplier are skipped; `None` if
    /// all are skipped.
    ///
    /// If [`factor`](Self::factor) would return `false`, the maximum exceeds [`LARGEST_FACTOR`].
    ///
    /// [`LARGEST_FACTOR`]: kahan_core::__private::LARGEST_FACTOR
    pub(crate) fn growth<V: Scalar>(
        &self,
        slopes: &[V],
        eps: &V,
        factors: &mut Factors<V>,
        size: impl Fn(V) -> V,
        [larger, smaller]: [fn(V, V) -> V; 2],
    ) -> Option<V> {
        let couplings = self.filled(slopes, eps, factors);
        let Factors { values, row, .. } = factors;
        let mut largest: Vec<Option<V>> = vec![None; self.order.len()];
        couplings.eliminate(values, row, |turn, factor, _| {
            let factor = size(factor.clone());
            largest[turn] = Some(match largest[turn].take() {
                Some(other) => larger(other, factor),
                None => factor,
            });
        });
        let of_pivot = |(turn, factor): (usize, Option<V>)| {
            let (reciprocal, behind) = couplings.pivot(turn, values);
            let quotient = behind.iter().cloned().map(&size).reduce(larger)? * size(reciprocal.clone());
            Some(smaller(factor?, quotient))
        };
        largest.into_iter().enumerate().filter_map(of_pivot).reduce(larger)
    }

    pub(super) fn has_negative_determinant(&self, factors: &Factors<f64>) -> bool {
        self.couplings().pivots(&factors.values).filter(|pivot| **pivot < 0.0).count() % 2 == 1
    }

    /// Replaces column `column` of b by A⁻¹ times this column; b is row-major with `width` columns.
    pub(crate) fn solve<V: Scalar>(
        &self,
        factors: &mut Factors<V>,
        b: &mut [V],
        width: usize,
        column: usize,
    ) {
        self.in_order(factors, b, [width, column], |couplings, values, row| couplings.solve(values, row));
    }

    pub(super) fn solve_transposed<V: Scalar>(&self, factors: &mut Factors<V>, b: &mut [V]) {
        self.in_order(factors, b, [1, 0], |couplings, values, row| couplings.solve_transposed(values, row));
    }

    /// Puts a column of b into elimination order, applies `solve`, and restores the order.
    #[inline(always)]
    fn in_order<V: Scalar>(
        &self,
        Factors { values, row, .. }: &mut Factors<V>,
        b: &mut [V],
        [width, column]: [usize; 2],
        solve: impl FnOnce(Couplings<'_>, &[V], &mut [V]),
    ) {
        let place = |turn: u32| turn as usize * width + column;
        for (own, turn) in row.iter_mut().zip(&self.order) {
            own.clone_from(&b[place(*turn)]);
        }
        solve(self.couplings(), values, row);
        for (own, turn) in row.iter().zip(&self.order) {
            b[place(*turn)].clone_from(own);
        }
    }

    pub(super) fn entries(&self) -> Vec<(usize, usize)> {
        self.couplings().pairs().collect()
    }

    /// Replaces b by A⁻¹b, or by A⁻ᵀb if `is_transposed`, using partial pivoting. Returns whether A
    /// is singular.
    pub(super) fn solve_by_pivoting<V: Scalar + Copy>(
        &self,
        slopes: &[V],
        eps: V,
        b: &mut [V],
        is_transposed: bool,
    ) -> bool {
        let mut turns = vec![0; self.order.len()];
        for (turn, variable) in self.order.iter().enumerate() {
            turns[*variable as usize] = turn;
        }
        let mut rows: Vec<Vec<(usize, V)>> = (0..turns.len()).map(|turn| vec![(turn, V::one())]).collect();
        for ((i, j), slope) in self.couplings().pairs().zip(slopes) {
            let (i, j) = if is_transposed { (j, i) } else { (i, j) };
            let scaled = -(eps * *slope);
            if i == j {
                rows[turns[i]][0].1 += scaled;
            } else {
                rows[turns[i]].push((turns[j], scaled));
            }
        }
        rows.iter_mut().for_each(|row| row.sort_unstable_by_key(|(column, _)| *column));
        let mut own: Vec<V> = self.order.iter().map(|variable| b[*variable as usize]).collect();
        let most = V::constant(&Constant::integer(LARGEST_FACTOR));
        let is_singular = solve_sparse(rows, &mut own, most);
        for (turn, entry) in self.order.iter().zip(own) {
            b[*turn as usize] = entry;
        }
        is_singular
    }

    pub(super) fn spread<V: Scalar + Copy>(&self, slopes: &[V], matrix: &mut Vec<V>) {
        let n = self.order.len();
        matrix.clear();
        matrix.resize(n * n, V::zero());
        for ((i, j), slope) in self.couplings().pairs().zip(slopes) {
            matrix[i * n + j] = *slope;
        }
    }
}
