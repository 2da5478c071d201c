//! Elimination for dense fields f, in loops over rows or over the points of an ensemble.
//!
//! [`velocity`] computes A(x,ε)⁻¹f(x) with A(x,ε) = I − εf′(x). For any number of lanes, the
//! operations and their order equal those of [`Couplings`](crate::__private::Couplings). Products
//! xⱼxₖ that do not occur in f are added with the coefficient 0. If all products are finite, this
//! changes at most the sign of a sum that is 0.

mod points;
#[cfg(test)]
mod tests;

use core::marker::PhantomData;
use core::ops::Range;
use std::vec::Vec;

use crate::ensemble::lanes::{InLanes, Lanes, OverLanes, minus_product};
use crate::field::couplings::LARGEST_FACTOR;
use crate::{Constant, Level};

pub use points::{points, velocities};

const PIVOTS_TOGETHER: usize = 8;
/// The number of matrix columns that are reduced in one loop.
const COLUMNS_TOGETHER: usize = 4;

/// Returns the number of coefficients of a component of a field. A component has a constant, one
/// coefficient per variable, and one per product xⱼxₖ with j ≤ k, ordered by j and then by k.
#[must_use]
pub const fn coefficients(variables: usize) -> usize {
    1 + variables + variables * (variables + 1) / 2
}

/// Returns the index of the product xⱼxₖ, j ≤ k, among the coefficients of a component.
const fn place(variables: usize, j: usize, k: usize) -> usize {
    1 + variables + j * variables - j * (j + 1) / 2 + k
}

/// Returns the height of a column, padded to a multiple of the register width.
const fn height<T: InLanes>(variables: usize) -> usize {
    variables.next_multiple_of(T::ROWS)
}

fn blocks(columns: Range<usize>) -> impl Iterator<Item = Range<usize>> {
    let whole = columns.end - columns.len() % COLUMNS_TOGETHER;
    let blocks =
        (columns.start..whole).step_by(COLUMNS_TOGETHER).map(|first| first..first + COLUMNS_TOGETHER);
    blocks.chain((whole..columns.end).map(|column| column..column + 1))
}

/// Appends the coefficients of a field to `packed`, in the order in which [`velocity`] reads them.
/// `field` holds `coefficients(variables)` numbers per component.
pub fn pack<T: InLanes>(variables: usize, field: &[T], packed: &mut Vec<T>) {
    let mut places: Vec<usize> = (0..=variables).collect();
    for block in blocks(0..variables) {
        for j in block.clone() {
            places.extend((j..block.end).map(|k| place(variables, j, k)));
        }
        for k in block.end..variables {
            places.extend(block.clone().map(|j| place(variables, j, k)));
        }
    }
    for first in (0..variables).step_by(T::ROWS) {
        for place in &places {
            let of_row = |row: usize| {
                if row < variables { field[row * coefficients(variables) + place] } else { T::zero() }
            };
            packed.extend((first..first + T::ROWS).map(of_row));
        }
    }
}

/// The memory that steps reuse.
#[derive(Clone, Debug)]
pub struct Workspace<T> {
    /// The matrix A(x,ε) column by column, followed by f(x).
    columns: Vec<T>,
    factors: Vec<T>,
    /// Pivots with an elimination factor above `LARGEST_FACTOR`.
    suspects: Vec<usize>,
}

impl<T> Default for Workspace<T> {
    fn default() -> Self {
        Workspace { columns: Vec::new(), factors: Vec::new(), suspects: Vec::new() }
    }
}

impl<T: InLanes> Workspace<T> {
    /// Returns the last column, which holds f(x) or the solution.
    #[must_use]
    pub fn last(&self, variables: usize) -> &[T] {
        &self.columns[height::<T>(variables) * variables..][..variables]
    }

    /// Returns the entry (i, j) of A(x,ε). [`assemble`] must have computed the matrix.
    #[must_use]
    pub fn entry(&self, variables: usize, [i, j]: [usize; 2]) -> T {
        self.columns[height::<T>(variables) * j + i]
    }
}

/// Computes A(x,ε)⁻¹f(x) from [packed](pack) coefficients into the [last](Workspace::last) column.
/// Returns `false` if a pivot is 0 or too small; see
/// [`Couplings::factor`](crate::__private::Couplings::factor).
#[must_use]
pub fn velocity<T: InLanes>(packed: &[T], x: &[T], eps: T, workspace: &mut Workspace<T>) -> bool {
    run(DenseWork { packed, x, eps, eliminates: true, workspace }, Level::Avx2)
}

/// Computes the matrix A(x,ε) = I − εf′(x) and the column f(x).
pub fn assemble<T: InLanes>(packed: &[T], x: &[T], eps: T, workspace: &mut Workspace<T>) {
    run(DenseWork { packed, x, eps, eliminates: false, workspace }, Level::Avx2);
}

fn run<T: InLanes>(work: DenseWork<'_, T>, level: Level) -> bool {
    let (n, height) = (work.x.len(), height::<T>(work.x.len()));
    work.workspace.columns.resize(height * (n + 1), T::zero());
    work.workspace.factors.resize(height * PIVOTS_TOGETHER, T::zero());
    T::run(work, level)
}

struct DenseWork<'a, T> {
    packed: &'a [T],
    x: &'a [T],
    eps: T,
    eliminates: bool,
    workspace: &'a mut Workspace<T>,
}

impl<T: InLanes> OverLanes<T> for DenseWork<'_, T> {
    type Output = bool;
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(self) -> bool {
        let DenseWork { packed, x, eps, eliminates, workspace } = self;
        let (variables, height) = (x.len(), height::<T>(x.len()));
        let loops = Loops::<T, L, false> { variables, height, lanes: PhantomData };
        loops.assemble(packed, x, eps, &mut workspace.columns);
        !eliminates || loops.eliminate(workspace)
    }
}

/// Loops over registers of type L. If `POINTS` is true, a lane holds a point, otherwise a row of A.
#[derive(Clone, Copy)]
struct Loops<T, L, const POINTS: bool> {
    variables: usize,
    height: usize,
    lanes: PhantomData<(T, L)>,
}

impl<T: InLanes, L: Lanes<T>, const POINTS: bool> Loops<T, L, POINTS> {
    const ENTRY: usize = if POINTS { L::WIDTH } else { 1 };
    const STEP: usize = if POINTS { 1 } else { L::WIDTH };

    #[inline(always)]
    fn at(self, i: usize, j: usize) -> usize {
        (j * self.height + i) * Self::ENTRY
    }

    #[inline(always)]
    fn column(self, j: usize) -> usize {
        self.at(0, j)
    }

    #[inline(always)]
    fn coefficient(packed: &[T], place: usize, row: usize) -> L {
        let place = place * T::ROWS + row % T::ROWS;
        if POINTS { L::spread(&packed[place]) } else { L::load(packed, place) }
    }

    #[inline(always)]
    fn state(x: &[T], k: usize) -> L {
        if POINTS { L::load(x, k * L::WIDTH) } else { L::spread(&x[k]) }
    }

    /// Returns a plain range, because compilers do not always inline `step_by`.
    #[inline(always)]
    fn registers(self, start: usize, end: usize) -> Range<usize> {
        start / L::WIDTH..end / L::WIDTH
    }

    #[inline(always)]
    fn assemble(self, packed: &[T], x: &[T], eps: T, columns: &mut [T]) {
        let n = self.variables;
        let together = coefficients(n) * T::ROWS;
        for step in 0..self.height / Self::STEP {
            let row = step * Self::STEP;
            let packed = &packed[row / T::ROWS * together..][..together];
            for j in 0..n {
                Self::coefficient(packed, 1 + j, row).store(columns, self.at(row, j));
            }
            let (mut field, mut next) = (Self::coefficient(packed, 0, row), 1 + n);
            for block in 0..n / COLUMNS_TOGETHER {
                self.block::<COLUMNS_TOGETHER>(
                    [block * COLUMNS_TOGETHER, row],
                    packed,
                    &mut next,
                    x,
                    &mut field,
                    columns,
                );
            }
            for first in n - n % COLUMNS_TOGETHER..n {
                self.block::<1>([first, row], packed, &mut next, x, &mut field, columns);
            }
            field.store(columns, self.at(row, n));
        }
        let negated = L::spread(&-eps);
        for register in self.registers(0, self.column(n)) {
            let place = register * L::WIDTH;
            (L::load(columns, place) * negated).store(columns, place);
        }
        for k in 0..n {
            for diagonal in &mut columns[self.at(k, k)..][..Self::ENTRY] {
                *diagonal = T::one() + *diagonal;
            }
        }
    }

    /// Adds the terms with xⱼxₖ, k ≥ j, to f and f′, for W successive indices j from `first` on.
    #[inline(always)]
    fn block<const W: usize>(
        self,
        [first, row]: [usize; 2],
        packed: &[T],
        next: &mut usize,
        x: &[T],
        field: &mut L,
        columns: &mut [T],
    ) {
        let mut cofactors = [*field; W];
        let (mut own, mut slopes) = (cofactors, cofactors);
        for w in 0..W {
            cofactors[w] = Self::coefficient(packed, 1 + first + w, row);
            own[w] = Self::state(x, first + w);
            slopes[w] = L::load(columns, self.at(row, first + w));
        }
        for j in 0..W {
            for k in j..W {
                let coefficient = Self::coefficient(packed, *next, row);
                *next += 1;
                let product = coefficient * own[k];
                cofactors[j] += product;
                if j == k {
                    slopes[j] += product + product;
                } else {
                    slopes[j] += product;
                    slopes[k] += coefficient * own[j];
                }
            }
        }
        let others = &mut columns[self.column(first + W)..self.column(self.variables)];
        let groups = &packed[*next * T::ROWS..];
        for k in 0..self.variables - first - W {
            let other = &mut others[self.column(k)..][..self.height * Self::ENTRY];
            let group = &groups[k * W * T::ROWS..][..W * T::ROWS];
            let (mut sum, factor) = (L::load(other, row * Self::ENTRY), Self::state(x, first + W + k));
            for w in 0..W {
                let coefficient = Self::coefficient(group, w, row);
                let product = coefficient * factor;
                cofactors[w] += product;
                slopes[w] += product;
                sum += coefficient * own[w];
            }
            sum.store(other, row * Self::ENTRY);
        }
        *next += (self.variables - first - W) * W;
        for w in 0..W {
            *field += own[w] * cofactors[w];
            slopes[w].store(columns, self.at(row, first + w));
        }
    }
}

impl<T: InLanes, L: Lanes<T>> Loops<T, L, false> {
    /// Solves the linear system whose right-hand side is the last column, in place. Returns `false`
    /// if a pivot is 0 or too small.
    #[inline(always)]
    fn eliminate(self, workspace: &mut Workspace<T>) -> bool {
        let Workspace { columns, factors, suspects } = workspace;
        let n = self.variables;
        let most = T::constant(&Constant::integer(LARGEST_FACTOR));
        suspects.clear();
        for first in (0..n).step_by(PIVOTS_TOGETHER) {
            let end = n.min(first + PIVOTS_TOGETHER);
            for k in first..end {
                match self.factors([k, k - first], most, columns, factors) {
                    None => return false,
                    Some(true) => suspects.push(k),
                    Some(false) => {}
                }
                for column in k + 1..end {
                    self.subtract::<1>(columns, factors, column, self.height, [k, k - first]);
                }
            }
            for block in blocks(end..n + 1) {
                if block.len() == COLUMNS_TOGETHER {
                    self.reduce::<COLUMNS_TOGETHER>(columns, factors, block.start, first..end);
                } else {
                    self.reduce::<1>(columns, factors, block.start, first..end);
                }
            }
        }
        let is_too_small = |&k: &usize| {
            let mut row = (k + 1..n).map(|j| columns[self.column(j) + k]);
            row.any(|entry| (entry * columns[self.column(k) + k]).is_better_pivot(&most))
        };
        if suspects.iter().any(is_too_small) {
            return false;
        }
        self.substitute_back(columns);
        true
    }

    #[inline(always)]
    fn place_of_factors(row: usize, pivot: usize) -> usize {
        (row / T::ROWS * PIVOTS_TOGETHER + pivot) * T::ROWS + row % T::ROWS
    }

    /// Replaces pivot k by its reciprocal, and stores the factor of each lower row. Returns whether
    /// a factor exceeds `most`, or `None` if the pivot is 0.
    #[inline(always)]
    fn factors(self, [k, pivot]: [usize; 2], most: T, columns: &mut [T], factors: &mut [T]) -> Option<bool> {
        let own = &mut columns[self.column(k)..][..self.height];
        if own[k].is_zero() {
            return None;
        }
        let reciprocal = own[k].reciprocal()?;
        own[k] = reciprocal;
        let start = k - k % T::ROWS;
        let mut is_large = false;
        for (r, factor) in factors[Self::place_of_factors(start, pivot)..][..T::ROWS].iter_mut().enumerate() {
            *factor = if start + r > k { own[start + r] * reciprocal } else { T::zero() };
            is_large |= factor.is_better_pivot(&most);
        }
        let (reciprocal, mut largest) = (L::spread(&reciprocal), L::spread(&T::zero()));
        for register in self.registers(start + T::ROWS, self.height) {
            let row = register * L::WIDTH;
            let factor = L::load(own, row) * reciprocal;
            largest = L::choose(factor.exceeds(largest), factor, largest);
            factor.store(factors, Self::place_of_factors(row, pivot));
        }
        Some(is_large || L::any(largest.exceeds(L::spread(&most))))
    }

    #[inline(always)]
    fn reduce<const W: usize>(self, columns: &mut [T], factors: &[T], column: usize, pivots: Range<usize>) {
        let below = pivots.end.next_multiple_of(T::ROWS);
        for k in pivots.clone() {
            self.subtract::<W>(columns, factors, column, below, [k, k - pivots.start]);
        }
        if below < self.height {
            self.subtract_all::<W>(columns, factors, column, below, pivots.start);
        }
    }

    #[inline(always)]
    fn subtract<const W: usize>(
        self,
        columns: &mut [T],
        factors: &[T],
        column: usize,
        end: usize,
        [k, pivot]: [usize; 2],
    ) {
        for w in 0..W {
            let column = &mut columns[self.column(column + w)..][..self.height];
            let upper = L::spread(&column[k]);
            for register in self.registers(k - k % T::ROWS, end) {
                let row = register * L::WIDTH;
                let factor = L::load(factors, Self::place_of_factors(row, pivot));
                minus_product(L::load(column, row), factor, upper).store(column, row);
            }
        }
    }

    /// Subtracts multiples of `PIVOTS_TOGETHER` pivot rows from all rows from the index `below` on.
    #[inline(always)]
    #[expect(clippy::needless_range_loop, reason = "what is no plain range is not always inlined")]
    fn subtract_all<const W: usize>(
        self,
        columns: &mut [T],
        factors: &[T],
        column: usize,
        below: usize,
        first: usize,
    ) {
        let columns = &mut columns[self.column(column)..][..W * self.height];
        let mut upper = [[T::zero(); W]; PIVOTS_TOGETHER];
        for k in 0..PIVOTS_TOGETHER {
            for w in 0..W {
                upper[k][w] = columns[self.column(w) + first + k];
            }
        }
        for register in self.registers(below, self.height) {
            let row = register * L::WIDTH;
            let group =
                &factors[Self::place_of_factors(row, 0) - row % T::ROWS..][..PIVOTS_TOGETHER * T::ROWS];
            let mut own = [L::spread(&T::zero()); W];
            for w in 0..W {
                own[w] = L::load(columns, self.column(w) + row);
            }
            for k in 0..PIVOTS_TOGETHER {
                let factor = L::load(group, k * T::ROWS + row % T::ROWS);
                for w in 0..W {
                    own[w] = minus_product(own[w], factor, L::spread(&upper[k][w]));
                }
            }
            for w in 0..W {
                own[w].store(columns, self.column(w) + row);
            }
        }
    }

    #[inline(always)]
    fn substitute_back(self, columns: &mut [T]) {
        let (columns, solution) = columns.split_at_mut(self.column(self.variables));
        for k in (0..self.variables).rev() {
            let column = &columns[self.column(k)..][..self.height];
            let value = solution[k] * column[k];
            solution[k] = value;
            let whole = k - k % T::ROWS;
            let spread = L::spread(&value);
            for register in self.registers(0, whole) {
                let row = register * L::WIDTH;
                minus_product(L::load(solution, row), L::load(column, row), spread).store(solution, row);
            }
            for row in whole..k {
                solution[row] = minus_product(solution[row], column[row], value);
            }
        }
    }
}
