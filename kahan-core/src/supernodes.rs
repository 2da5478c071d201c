//! Sparse LU elimination over floats by panels (supernodes). A panel is a block of consecutive rows
//! with entries in the same columns to its right. SIMD lanes reduce these rows together.
//!
//! The order of operations, and therefore the bits, are those of [`Couplings::factor`], unless
//! negligible entries are replaced by 0. On supernodes see J. W. H. Liu, E. G. Ng, B. W. Peyton,
//! SIAM J. Matrix Anal. Appl. 14 (1993) 242–252.

#[cfg(test)]
mod tests;

use core::ops::Range;
use std::vec::Vec;

use crate::ensemble::lanes::{InLanes, Lanes, OverLanes, minus_product};
use crate::field::couplings::{Couplings, LARGEST_FACTOR};
use crate::{Constant, Level};

/// The maximum number of rows in a panel, so that a panel fits a fast cache.
const MOST_ROWS: usize = 32;
/// The number of rows that are reduced together.
const ROWS_TOGETHER: usize = 4;
/// The maximum number of pivot rows that are subtracted from rows at once.
const MAX_PIVOTS_TOGETHER: usize = 16;
/// The maximum number of pivots of a panel whose pivots are applied one at a time.
const MAX_SINGLE_PIVOTS: usize = 4;
/// From this number of columns on, loops over lanes save time.
const MIN_LANE_COLUMNS: u32 = 4;

/// The panels of an elimination, and the tasks that reduce their rows.
#[derive(Clone, Debug)]
pub struct Supernodes {
    panels: Vec<Panel>,
    reductions: Vec<PanelReduction>,
    tasks: Vec<RowReduction>,
    runs: Vec<ColumnRun>,
    /// For each entry of A, the index of the entry's column within the panel.
    columns: Vec<u32>,
    lists: Vec<u32>,
}

/// Consecutive rows that have entries in the same columns to the right of their diagonal block. The
/// panel's columns are all columns in which one of these rows has an entry.
#[derive(Clone, Debug)]
struct Panel {
    rows: Range<usize>,
    width: usize,
    reductions: Range<usize>,
}

/// The reduction of one panel's rows by the pivots of an earlier panel or of the panel itself.
#[derive(Clone, Debug)]
struct PanelReduction {
    /// The index of the row after the last pivot.
    end: usize,
    /// The index, among the panel's columns, of the column after the last pivot.
    behind: usize,
    tasks: Range<usize>,
    runs: Range<usize>,
    /// The index in `lists` of the first column after the last pivot, if rows are reduced one pivot
    /// at a time.
    list: Option<usize>,
}

/// The reduction of one row, or of [`ROWS_TOGETHER`] rows, by consecutive pivots.
#[derive(Clone, Debug)]
struct RowReduction {
    /// The indices of the rows within the panel. If `is_alone` is true, only the first is used.
    rows: [u32; ROWS_TOGETHER],
    is_alone: bool,
    is_last: bool,
    first: u32,
    count: u32,
}

/// A range of panel columns in which a pivot row has entries.
#[derive(Clone, Debug)]
struct ColumnRun {
    /// In a pivot row, the number of entries after the last pivot's column and before this range.
    before: u32,
    column: u32,
    length: u32,
}

/// The memory that factorisations reuse.
#[derive(Clone, Debug)]
pub struct PanelWorkspace<T> {
    rows: Vec<T>,
    /// For each row, the magnitude below which an entry is negligible.
    limits: Vec<T>,
    /// For each column of A, the magnitude below which an entry is negligible. An entry is replaced
    /// by 0 if it is negligible in its row and in its column.
    column_limits: Vec<T>,
    factors: Vec<T>,
    uppers: Vec<usize>,
}

impl<T> Default for PanelWorkspace<T> {
    fn default() -> Self {
        let [rows, limits, column_limits, factors] = [const { Vec::new() }; 4];
        PanelWorkspace { rows, limits, column_limits, factors, uppers: Vec::new() }
    }
}

impl Supernodes {
    /// Divides the rows of the matrix into panels.
    #[must_use]
    pub fn of(couplings: &Couplings<'_>) -> Self {
        let count = couplings.rows.len();
        let mut all = Supernodes {
            panels: Vec::new(),
            reductions: Vec::new(),
            tasks: Vec::new(),
            runs: Vec::new(),
            columns: couplings.columns.to_vec(),
            lists: Vec::new(),
        };
        let (mut panel_of, mut places) = (Vec::with_capacity(count), std::vec![0; count]);
        let mut first = 0;
        while first < count {
            let mut end = first + 1;
            while end - first < MOST_ROWS && couplings.is_continued(end - 1) {
                end += 1;
            }
            panel_of.resize(end, all.panels.len());
            all.push(couplings, first..end, &panel_of, &mut places);
            first = end;
        }
        all
    }

    /// Appends the panel that consists of `rows`. `panel_of[r]` is the panel of row r, for all rows
    /// up to the last of `rows`. `places` is scratch memory.
    fn push(
        &mut self,
        couplings: &Couplings<'_>,
        rows: Range<usize>,
        panel_of: &[usize],
        places: &mut [u32],
    ) {
        let mut columns: Vec<u32> =
            rows.clone().flat_map(|row| &couplings.columns[couplings.rows[row].own()]).copied().collect();
        columns.sort_unstable();
        columns.dedup();
        for (place, column) in (0..).zip(&columns) {
            places[*column as usize] = place;
        }
        for entry in rows.clone().flat_map(|row| couplings.rows[row].own()) {
            self.columns[entry] = places[couplings.columns[entry] as usize];
        }
        let mut used: Vec<usize> =
            columns.iter().map_while(|&column| panel_of.get(column as usize)).copied().collect();
        used.dedup();
        let first_reduction = self.reductions.len();
        for pivots in used {
            let of_pivots = self.panels.get(pivots).map_or(rows.clone(), |panel| panel.rows.clone());
            let (last, first_run) = (of_pivots.end - 1, self.runs.len());
            for (before, &column) in (0..).zip(couplings.columns_right(last)) {
                let column = places[column as usize];
                match self.runs[first_run..].last_mut().filter(|run| run.column + run.length == column) {
                    Some(run) => run.length += 1,
                    None => self.runs.push(ColumnRun { before, column, length: 1 }),
                }
            }
            self.runs[first_run..].sort_by_key(|run| run.length < MIN_LANE_COLUMNS);
            let runs = first_run..self.runs.len();
            let right = couplings.columns_right(of_pivots.start);
            let is_narrow = of_pivots.start < rows.start
                && of_pivots.len() <= MAX_SINGLE_PIVOTS
                && right.len() < MIN_LANE_COLUMNS as usize * runs.len();
            let list = is_narrow.then_some(self.lists.len() + of_pivots.len() - 1);
            if is_narrow {
                self.lists.extend(right.iter().map(|&column| places[column as usize]));
            }
            let tasks = self.push_tasks(couplings, &rows, &of_pivots, is_narrow);
            let behind = places[last] as usize + 1;
            self.reductions.push(PanelReduction { end: of_pivots.end, behind, tasks, runs, list });
        }
        let reductions = first_reduction..self.reductions.len();
        self.panels.push(Panel { rows, width: columns.len(), reductions });
    }

    /// Appends the tasks that reduce a panel's rows by these pivots. If `apart` is true, each row
    /// has its own tasks.
    fn push_tasks(
        &mut self,
        couplings: &Couplings<'_>,
        rows: &Range<usize>,
        pivots: &Range<usize>,
        apart: bool,
    ) -> Range<usize> {
        let begin = self.tasks.len();
        let firsts: Vec<usize> = rows
            .clone()
            .map(|row| {
                let left = couplings.columns_left(row);
                let place = left.partition_point(|&column| (column as usize) < pivots.start);
                left.get(place).map_or(pivots.end, |&column| pivots.end.min(column as usize))
            })
            .collect();
        if pivots.start < rows.start {
            let reduced: Vec<usize> = (0..rows.len()).filter(|&r| firsts[r] < pivots.end).collect();
            let (together, others) = reduced.as_chunks::<ROWS_TOGETHER>();
            let (together, others) = if apart { (&[][..], &reduced[..]) } else { (together, others) };
            for four in together {
                self.push_together(*four, four.map(|r| firsts[r]), pivots.end);
            }
            for &r in others {
                self.push_alone(r, firsts[r]..pivots.end, false);
            }
        } else {
            for block in (0..rows.len()).step_by(ROWS_TOGETHER) {
                let own = block..rows.len().min(block + ROWS_TOGETHER);
                let mut from = rows.start;
                if block > 0 && own.len() == ROWS_TOGETHER {
                    from += block;
                    let four = core::array::from_fn(|k| block + k);
                    self.push_together(four, four.map(|r| firsts[r]), from);
                }
                for r in own {
                    self.push_alone(r, firsts[r].max(from)..rows.start + r, true);
                }
            }
        }
        begin..self.tasks.len()
    }

    /// Appends the joint reduction of `ROWS_TOGETHER` rows by the pivots before `end`. `firsts` has
    /// the first pivot of each row. Pivots of only some of the rows are applied separately.
    fn push_together(&mut self, rows: [usize; ROWS_TOGETHER], firsts: [usize; ROWS_TOGETHER], end: usize) {
        let first = firsts.into_iter().fold(0, usize::max).min(end);
        for (r, own) in rows.into_iter().zip(firsts) {
            self.push_alone(r, own.min(first)..first, false);
        }
        self.push_pivots(rows, false, first..end);
    }

    fn push_alone(&mut self, r: usize, pivots: Range<usize>, is_last: bool) {
        self.push_pivots([r, 0, 0, 0], true, pivots);
        if is_last {
            self.tasks.push(RowReduction {
                rows: [r as u32, 0, 0, 0],
                is_alone: true,
                is_last,
                first: 0,
                count: 0,
            });
        }
    }

    fn push_pivots(&mut self, rows: [usize; ROWS_TOGETHER], is_alone: bool, pivots: Range<usize>) {
        for first in pivots.clone().step_by(MAX_PIVOTS_TOGETHER) {
            let count = MAX_PIVOTS_TOGETHER.min(pivots.end - first) as u32;
            let rows = rows.map(|r| r as u32);
            self.tasks.push(RowReduction { rows, is_alone, is_last: false, first: first as u32, count });
        }
    }

    /// Replaces A by its LU factors, as [`Couplings::factor`] does. Returns `false` if a pivot is 0
    /// or too small; the values are then useless.
    ///
    /// With `flushes`, an entry is replaced by 0 if it is below [`InLanes::NEGLIGIBLE`] times the
    /// largest off-diagonal entry of its row of A, and likewise of its column. Without `flushes`,
    /// factors of distant variables can become subnormal, which is slow.
    #[must_use]
    pub fn factor<T: InLanes>(
        &self,
        couplings: &Couplings<'_>,
        flushes: bool,
        values: &mut [T],
        workspace: &mut PanelWorkspace<T>,
    ) -> bool {
        let most = T::constant(&Constant::integer(LARGEST_FACTOR));
        T::run(PanelWork { supernodes: self, couplings, flushes, most, values, workspace }, Level::Avx2)
    }
}

impl Couplings<'_> {
    fn columns_left(&self, row: usize) -> &[u32] {
        &self.columns[self.rows[row].left()]
    }

    fn columns_right(&self, row: usize) -> &[u32] {
        &self.columns[self.rows[row].right()]
    }

    /// Returns whether the next row can join the panel of this row.
    fn is_continued(&self, row: usize) -> bool {
        match self.columns_right(row).split_first() {
            Some((&next, others)) => next as usize == row + 1 && self.columns_right(row + 1) == others,
            None => false,
        }
    }
}

struct PanelWork<'a, T> {
    supernodes: &'a Supernodes,
    couplings: &'a Couplings<'a>,
    flushes: bool,
    most: T,
    values: &'a mut [T],
    workspace: &'a mut PanelWorkspace<T>,
}

impl<T: InLanes> OverLanes<T> for PanelWork<'_, T> {
    type Output = bool;
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(mut self) -> bool {
        self.set_column_limits();
        self.workspace.limits.resize(MOST_ROWS, T::zero());
        self.workspace.factors.resize(MAX_PIVOTS_TOGETHER * ROWS_TOGETHER, T::zero());
        self.workspace.uppers.resize(MAX_PIVOTS_TOGETHER, 0);
        let panels = &self.supernodes.panels;
        for panel in panels {
            if !self.has_factored::<L>(panel) {
                return false;
            }
        }
        true
    }
}

/// Returns the magnitude below which entries are negligible beside `largest`, or 0 if this
/// magnitude is not finite.
#[inline(always)]
fn negligible<T: InLanes>(largest: T) -> T {
    let limit = largest * T::NEGLIGIBLE;
    if (limit * T::zero()).is_zero() { limit } else { T::zero() }
}

#[expect(clippy::needless_range_loop, reason = "what is no plain range is not always inlined")]
impl<T: InLanes> PanelWork<'_, T> {
    /// Computes the factors of a panel. Returns `false` if a pivot is 0 or too small. Each function
    /// for reductions is called at only one place, because it is inlined and large.
    #[inline(always)]
    fn has_factored<L: Lanes<T>>(&mut self, panel: &Panel) -> bool {
        let supernodes = self.supernodes;
        let (height, width) = (panel.rows.len(), panel.width);
        if self.workspace.rows.len() < height * width {
            self.workspace.rows.resize(height * width, T::zero());
        }
        for r in 0..height {
            self.gather(panel, r);
        }
        for reduction in panel.reductions.start..panel.reductions.end {
            let reduction = &supernodes.reductions[reduction];
            for task in reduction.tasks.start..reduction.tasks.end {
                let task = &supernodes.tasks[task];
                let is_possible = if task.is_last {
                    self.has_scattered(panel, task.rows[0] as usize)
                } else if let Some(list) = reduction.list {
                    self.has_reduced_along(task, reduction, list, width)
                } else if task.is_alone {
                    self.has_reduced::<L, 1>(task, reduction, width)
                } else {
                    self.has_reduced::<L, ROWS_TOGETHER>(task, reduction, width)
                };
                if !is_possible {
                    return false;
                }
            }
        }
        true
    }

    /// Reduces a row by one pivot at a time, in the columns of a list.
    #[inline(always)]
    fn has_reduced_along(
        &mut self,
        task: &RowReduction,
        reduction: &PanelReduction,
        list: usize,
        width: usize,
    ) -> bool {
        let (r, first) = (task.rows[0] as usize, task.first as usize);
        for pivot in first..first + task.count as usize {
            let place = r * width + reduction.behind + pivot - reduction.end;
            let Some(factor) = self.factor(r, place, pivot, pivot + 1) else { return false };
            let [diagonal, behind] = self.pivot(pivot);
            let upper = &self.values[diagonal + 1..behind];
            let columns = &self.supernodes.lists[list + pivot + 1 - reduction.end..][..upper.len()];
            let own = &mut self.workspace.rows[r * width..][..width];
            for k in 0..upper.len() {
                let entry = &mut own[columns[k] as usize];
                *entry = minus_product(*entry, factor, upper[k]);
            }
        }
        true
    }

    #[inline(always)]
    fn set_column_limits(&mut self) {
        let limits = &mut self.workspace.column_limits;
        limits.clear();
        limits.resize(self.couplings.rows.len(), T::zero());
        if !self.flushes {
            return;
        }
        for row in self.couplings.rows {
            for place in row.own() {
                let largest = &mut limits[self.couplings.columns[place] as usize];
                if place + 1 != row.right().start && self.values[place].is_better_pivot(largest) {
                    *largest = self.values[place];
                }
            }
        }
        for limit in limits {
            *limit = negligible(*limit);
        }
    }

    #[inline(always)]
    fn gather(&mut self, panel: &Panel, r: usize) {
        let own = &mut self.workspace.rows[r * panel.width..][..panel.width];
        let row = &self.couplings.rows[panel.rows.start + r];
        let mut largest = T::zero();
        for place in row.own() {
            let entry = self.values[place];
            own[self.supernodes.columns[place] as usize] = entry;
            if self.flushes && place + 1 != row.right().start && entry.is_better_pivot(&largest) {
                largest = entry;
            }
        }
        self.workspace.limits[r] = negligible(largest);
    }

    /// Returns `entry`, or 0 if it is negligible in row r of the panel and in its column of A.
    #[inline(always)]
    fn flushed(&self, entry: T, r: usize, column: usize) -> T {
        let PanelWorkspace { limits, column_limits, .. } = &*self.workspace;
        let is_negligible =
            limits[r].is_better_pivot(&entry) && column_limits[column].is_better_pivot(&entry);
        if is_negligible { T::zero() } else { entry }
    }

    /// Copies row r of the panel back, with a reciprocal pivot. Returns `false` if the pivot is 0.
    #[inline(always)]
    fn has_scattered(&mut self, panel: &Panel, r: usize) -> bool {
        let own = &self.workspace.rows[r * panel.width..][..panel.width];
        let row = &self.couplings.rows[panel.rows.start + r];
        for place in row.left() {
            self.values[place] = own[self.supernodes.columns[place] as usize];
        }
        for place in row.right() {
            let entry = own[self.supernodes.columns[place] as usize];
            self.values[place] = self.flushed(entry, r, self.couplings.columns[place] as usize);
        }
        let [diagonal, _] = self.pivot(panel.rows.start + r);
        let pivot = own[self.supernodes.columns[diagonal] as usize];
        match pivot.reciprocal() {
            Some(reciprocal) if !pivot.is_zero() => self.values[diagonal] = reciprocal,
            _ => return false,
        }
        true
    }

    /// Returns the index of a pivot's entry, and the end of the pivot's row.
    #[inline(always)]
    fn pivot(&self, row: usize) -> [usize; 2] {
        let right = self.couplings.rows[row].right();
        [right.start - 1, right.end]
    }

    /// Reduces R rows together. Returns `false` if a pivot is too small.
    #[inline(always)]
    fn has_reduced<L: Lanes<T>, const R: usize>(
        &mut self,
        task: &RowReduction,
        reduction: &PanelReduction,
        width: usize,
    ) -> bool {
        let (first, count) = (task.first as usize, task.count as usize);
        let end = first + count;
        let mut places = [0; R];
        for r in 0..R {
            places[r] = task.rows[r] as usize * width;
        }
        for k in 0..count {
            let [diagonal, _] = self.pivot(first + k);
            self.workspace.uppers[k] = diagonal + count - k;
        }
        // Each pivot row has entries in the columns of the `left` later pivots.
        let left = reduction.end - end;
        let column = reduction.behind - left;
        for r in 0..R {
            for k in 0..count {
                match self.factor(task.rows[r] as usize, places[r] + column + k - count, first + k, end) {
                    Some(factor) => self.workspace.factors[k * R + r] = factor,
                    None => return false,
                }
            }
        }
        let mut run = ColumnRun { before: 0, column: column as u32, length: left as u32 };
        let mut next = reduction.runs.start;
        loop {
            self.subtract::<L, R>(places, count, &run);
            if next == reduction.runs.end {
                return true;
            }
            run = self.supernodes.runs[next].clone();
            run.before += left as u32;
            next += 1;
        }
    }

    /// Subtracts a multiple of a pivot row from a row, in the columns before `end`. Returns the
    /// multiplier, or `None` if the pivot is too small.
    #[inline(always)]
    fn factor(&mut self, row: usize, place: usize, pivot: usize, end: usize) -> Option<T> {
        let [diagonal, behind] = self.pivot(pivot);
        let reciprocal = self.values[diagonal];
        let factor = self.flushed(self.workspace.rows[place], row, pivot) * reciprocal;
        if factor.is_better_pivot(&self.most) {
            for place in diagonal + 1..behind {
                if (self.values[place] * reciprocal).is_better_pivot(&self.most) {
                    return None;
                }
            }
        }
        let own = &mut self.workspace.rows[place..][..end - pivot];
        own[0] = factor;
        let upper = &self.values[diagonal..][..end - pivot];
        for k in 1..upper.len() {
            own[k] = minus_product(own[k], factor, upper[k]);
        }
        Some(factor)
    }

    #[inline(always)]
    fn subtract<L: Lanes<T>, const R: usize>(&mut self, places: [usize; R], count: usize, run: &ColumnRun) {
        let (mut before, mut column) = (run.before as usize, run.column as usize);
        let end = column + run.length as usize;
        while column + 2 * L::WIDTH <= end {
            self.subtract_from::<L, R, 2>(places, count, before, column);
            (before, column) = (before + 2 * L::WIDTH, column + 2 * L::WIDTH);
        }
        while column + L::WIDTH <= end {
            self.subtract_from::<L, R, 1>(places, count, before, column);
            (before, column) = (before + L::WIDTH, column + L::WIDTH);
        }
        while column < end {
            self.subtract_from::<T, R, 1>(places, count, before, column);
            (before, column) = (before + 1, column + 1);
        }
    }

    #[inline(always)]
    fn subtract_from<V: Lanes<T>, const R: usize, const C: usize>(
        &mut self,
        places: [usize; R],
        count: usize,
        before: usize,
        column: usize,
    ) {
        let PanelWorkspace { rows: entries, factors, uppers, .. } = &mut *self.workspace;
        let (factors, uppers) = (&factors[..count * R], &uppers[..count]);
        let mut own = [[V::spread(&T::zero()); C]; R];
        for r in 0..R {
            for c in 0..C {
                own[r][c] = V::load(entries, places[r] + column + c * V::WIDTH);
            }
        }
        for k in 0..count {
            let mut upper = [V::spread(&T::zero()); C];
            for c in 0..C {
                upper[c] = V::load(self.values, uppers[k] + before + c * V::WIDTH);
            }
            for r in 0..R {
                let factor = V::spread(&factors[k * R + r]);
                for c in 0..C {
                    own[r][c] = minus_product(own[r][c], factor, upper[c]);
                }
            }
        }
        for r in 0..R {
            for c in 0..C {
                own[r][c].store(entries, places[r] + column + c * V::WIDTH);
            }
        }
    }
}
