//! Elimination along the couplings over floats, by panels: rows one after the other whose entries
//! right of the diagonal stand in the same columns, so that loops over lanes reduce several rows by
//! several pivots.
//!
//! In: the tables of [`Couplings`], and A(x,ε) in their places. Out: the factors in these places,
//! by the operations of [`Couplings::factor`] in their order, so with its bits. (J. W. H. Liu,
//! E. G. Ng, B. W. Peyton, SIAM J. Matrix Anal. Appl. 14 (1993) 242–252, on supernodes.)

#[cfg(test)]
mod tests;

use core::ops::Range;
use std::vec::Vec;

use crate::dense::Float;
use crate::ensemble::lanes::{Lanes, OverLanes, Register, minus_product};
use crate::field::couplings::{Couplings, LARGEST_FACTOR};
use crate::{Constant, Level};

/// The most rows of a panel: the nearest cache holds this number of rows of pivots.
const MOST_ROWS: usize = 32;
/// The rows that are reduced together.
const ROWS: usize = 4;
/// The pivots that rows are reduced by at once.
const PIVOTS: usize = 16;
/// The fewest pivots of a panel that reduce rows together, whatever their columns are.
const FEWEST: usize = 4;
/// The fewest columns in a row that loops over lanes are used for.
const SHORTEST: u32 = 4;

/// The panels of an elimination.
#[derive(Clone, Debug)]
pub struct Supernodes {
    panels: Vec<Panel>,
    reductions: Vec<Reduction>,
    /// For each row of a reduction, the first pivot that reduces it.
    first_pivots: Vec<usize>,
    runs: Vec<Run>,
    /// For each entry of A, in its panel, the column.
    columns: Vec<u32>,
    /// Columns of a panel, for the entries of rows of pivots.
    lists: Vec<u32>,
}

/// Rows one after the other. Each has, right of the diagonal, an entry in the column of the next
/// and in those of all entries that the next has there. The columns of a panel are those in which
/// some row has an entry.
#[derive(Clone, Debug)]
struct Panel {
    rows: Range<usize>,
    /// The number of columns.
    width: usize,
    /// Which of the reductions are those of the rows, in the order of their pivots.
    reductions: Range<usize>,
}

/// The rows of a panel are reduced by pivots of a panel: each row by those from some first one on.
#[derive(Clone, Debug)]
struct Reduction {
    /// The panel of the pivots.
    pivots: usize,
    /// Where the first pivots of the rows begin; rows without an entry have the end of the panel.
    first_pivots: usize,
    /// The column behind that of the last pivot.
    behind: usize,
    /// Which of the runs are the columns that are reduced, after those of the pivots: first those
    /// of [`SHORTEST`] columns or more, from the middle number on the others.
    runs: [usize; 3],
    /// Where the columns right of the first pivot stand in the lists, if rows are reduced by one
    /// pivot after the other.
    list: Option<usize>,
}

/// Columns of a panel one after the other, which a row of pivots has entries in.
#[derive(Clone, Debug)]
struct Run {
    /// The number of entries before them that the row of the last pivot has right of the diagonal.
    before: u32,
    /// The first of the columns.
    column: u32,
    length: u32,
}

/// The numbers that a factorisation is computed in.
#[derive(Clone, Debug)]
pub struct PanelWorkspace<T> {
    /// The rows of a panel, each over its columns.
    rows: Vec<T>,
    /// For each of them the magnitude below which an entry may count as 0.
    limits: Vec<T>,
    /// Such magnitudes of all columns of A: an entry that counts as 0 is below both.
    column_limits: Vec<T>,
    /// The factors by which rows are reduced together, pivot after pivot.
    factors: Vec<T>,
    /// Where the entries of the rows of pivots begin.
    uppers: Vec<usize>,
}

impl<T> Default for PanelWorkspace<T> {
    fn default() -> Self {
        let [rows, limits, column_limits, factors] = [const { Vec::new() }; 4];
        PanelWorkspace { rows, limits, column_limits, factors, uppers: Vec::new() }
    }
}

impl Supernodes {
    /// The panels of the rows.
    #[must_use]
    pub fn of(couplings: &Couplings<'_>) -> Self {
        let count = couplings.rows.len();
        let mut all = Supernodes {
            panels: Vec::new(),
            reductions: Vec::new(),
            first_pivots: Vec::new(),
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

    /// Appends a panel of these rows. `panel_of` has the panel of each row up to the last of them;
    /// `places` is a number for each row to work in.
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
            let last = self.panels.get(pivots).map_or(rows.end, |panel| panel.rows.end) - 1;
            let first_pivots = self.first_pivots.len();
            self.first_pivots.resize(first_pivots + rows.len(), last + 1);
            let first_run = self.runs.len();
            for (before, &column) in (0..).zip(couplings.columns_right(last)) {
                let column = places[column as usize];
                match self.runs[first_run..].last_mut().filter(|run| run.column + run.length == column) {
                    Some(run) => run.length += 1,
                    None => self.runs.push(Run { before, column, length: 1 }),
                }
            }
            let is_short = |run: &Run| run.length < SHORTEST;
            self.runs[first_run..].sort_by_key(is_short);
            let wide = self.runs[first_run..].partition_point(|run| !is_short(run));
            let runs = [first_run, first_run + wide, self.runs.len()];
            let first = self.panels.get(pivots).map_or(rows.start, |panel| panel.rows.start);
            let right = couplings.columns_right(first);
            let is_narrow = last - first < FEWEST && right.len() < SHORTEST as usize * (runs[2] - first_run);
            let list = is_narrow.then_some(self.lists.len());
            if is_narrow {
                self.lists.extend(right.iter().map(|&column| places[column as usize]));
            }
            let behind = places[last] as usize + 1;
            self.reductions.push(Reduction { pivots, first_pivots, behind, runs, list });
        }
        let reductions = first_reduction..self.reductions.len();
        for (r, row) in rows.clone().enumerate() {
            let mut own = self.reductions[reductions.clone()].iter();
            let mut panel = None;
            for &column in couplings.columns_left(row) {
                let of_column = panel_of[column as usize];
                if panel.replace(of_column) != Some(of_column)
                    && let Some(reduction) = own.find(|reduction| reduction.pivots == of_column)
                {
                    self.first_pivots[reduction.first_pivots + r] = column as usize;
                }
            }
        }
        self.panels.push(Panel { rows, width: columns.len(), reductions });
    }

    /// Replaces A by its factors, as [`Couplings::factor`] does. `false` where a pivot is 0, or too
    /// small; the values then are of no use.
    ///
    /// With `flushes` an entry counts as 0 that is smaller than [`Float::NEGLIGIBLE`] times the
    /// largest entry of A in its row, and in its column, beside the diagonal. Factors decay like a
    /// power of ε with the distance between variables, and processors are slow with numbers below
    /// the normal ones. A unit of a variable multiplies a row and divides a column: solutions keep
    /// their bits, in f64, in all units whose quotients are at least 2¹⁰⁰ times `NEGLIGIBLE`.
    #[must_use]
    pub fn factor<T: Float>(
        &self,
        couplings: &Couplings<'_>,
        flushes: bool,
        values: &mut [T],
        workspace: &mut PanelWorkspace<T>,
    ) -> bool {
        let most = T::constant(&Constant::integer(LARGEST_FACTOR));
        T::run(Work { supernodes: self, couplings, flushes, most, values, workspace }, Level::Avx2)
    }
}

impl Couplings<'_> {
    fn columns_left(&self, row: usize) -> &[u32] {
        &self.columns[self.rows[row].left()]
    }

    fn columns_right(&self, row: usize) -> &[u32] {
        &self.columns[self.rows[row].right()]
    }

    /// Whether the next row has, right of its diagonal, the columns of this one that are behind it.
    fn is_continued(&self, row: usize) -> bool {
        match self.columns_right(row).split_first() {
            Some((&next, others)) => next as usize == row + 1 && self.columns_right(row + 1) == others,
            None => false,
        }
    }
}

struct Work<'a, T> {
    supernodes: &'a Supernodes,
    couplings: &'a Couplings<'a>,
    flushes: bool,
    most: T,
    values: &'a mut [T],
    workspace: &'a mut PanelWorkspace<T>,
}

impl<T: Float> OverLanes<T> for Work<'_, T> {
    type Output = bool;
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(mut self) -> bool {
        self.set_column_limits();
        self.workspace.limits.resize(MOST_ROWS, T::zero());
        self.workspace.factors.resize(PIVOTS * ROWS, T::zero());
        self.workspace.uppers.resize(PIVOTS, 0);
        let panels = &self.supernodes.panels;
        for panel in panels {
            if !self.has_factored::<L>(panel) {
                return false;
            }
        }
        true
    }
}

/// The magnitude below which an entry may count as 0 beside the largest one; 0 where that is not
/// finite.
#[inline(always)]
fn negligible<T: Float>(largest: T) -> T {
    let limit = largest * T::NEGLIGIBLE;
    if (limit * T::zero()).is_zero() { limit } else { T::zero() }
}

/// Rows of a panel that are reduced together by the pivots of a reduction before `end`.
struct Together<'a, const R: usize> {
    rows: [usize; R],
    /// The first pivot of each.
    firsts: [usize; R],
    reduction: &'a Reduction,
    /// The width of their panel.
    width: usize,
    end: usize,
}

#[expect(clippy::needless_range_loop, reason = "what is no plain range is not always inlined")]
impl<T: Float> Work<'_, T> {
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
        let reductions = &supernodes.reductions[panel.reductions.start..panel.reductions.end];
        for reduction in reductions {
            let firsts = &supernodes.first_pivots[reduction.first_pivots..][..height];
            let end = supernodes.panels[reduction.pivots].rows.end;
            if end == panel.rows.end {
                return self.has_factored_itself::<L>(panel, reduction, firsts);
            }
            if let Some(list) = reduction.list {
                if !self.has_reduced_along(panel, reduction, list, firsts) {
                    return false;
                }
                continue;
            }
            let (mut rows, mut own, mut count) = ([0; ROWS], [0; ROWS], 0);
            for r in 0..height {
                if firsts[r] == end {
                    continue;
                }
                (rows[count], own[count]) = (r, firsts[r]);
                count += 1;
                if count == ROWS {
                    count = 0;
                    if !self.has_reduced::<L, ROWS>(&Together { rows, firsts: own, reduction, width, end }) {
                        return false;
                    }
                }
            }
            for k in 0..count {
                let (rows, firsts) = ([rows[k]], [own[k]]);
                if !self.has_reduced::<L, 1>(&Together { rows, firsts, reduction, width, end }) {
                    return false;
                }
            }
        }
        for r in 0..height {
            if !self.has_scattered(panel, r) {
                return false;
            }
        }
        true
    }

    /// Reduces the rows of a panel by one pivot after the other, in the columns of a list.
    #[inline(always)]
    fn has_reduced_along(
        &mut self,
        panel: &Panel,
        reduction: &Reduction,
        list: usize,
        firsts: &[usize],
    ) -> bool {
        let supernodes = self.supernodes;
        let Range { start, end } = supernodes.panels[reduction.pivots].rows;
        for r in 0..panel.rows.len() {
            for pivot in firsts[r]..end {
                let place = r * panel.width + reduction.behind + pivot - end;
                let Some(factor) = self.factor(r, place, pivot, pivot + 1) else { return false };
                let [diagonal, behind] = self.pivot(pivot);
                let upper = &self.values[diagonal + 1..behind];
                let columns = &supernodes.lists[list + pivot - start..][..upper.len()];
                let own = &mut self.workspace.rows[r * panel.width..][..panel.width];
                for k in 0..upper.len() {
                    let entry = &mut own[columns[k] as usize];
                    *entry = minus_product(*entry, factor, upper[k]);
                }
            }
        }
        true
    }

    /// Reduces the rows of a panel by each other.
    #[inline(always)]
    fn has_factored_itself<L: Lanes<T>>(
        &mut self,
        panel: &Panel,
        reduction: &Reduction,
        firsts: &[usize],
    ) -> bool {
        let (start, height, width) = (panel.rows.start, panel.rows.len(), panel.width);
        for block in 0..height.div_ceil(ROWS) {
            let first = block * ROWS;
            let last = height.min(first + ROWS);
            let are_together = first > 0 && last - first == ROWS;
            if are_together {
                let rows = [first, first + 1, first + 2, first + 3];
                let firsts = [firsts[first], firsts[first + 1], firsts[first + 2], firsts[first + 3]];
                let together = Together { rows, firsts, reduction, width, end: start + first };
                if !self.has_reduced::<L, ROWS>(&together) {
                    return false;
                }
            }
            for r in first..last {
                let from = if are_together { firsts[r].max(start + first) } else { firsts[r] };
                let alone = Together { rows: [r], firsts: [from], reduction, width, end: start + r };
                if !self.has_reduced::<L, 1>(&alone) || !self.has_scattered(panel, r) {
                    return false;
                }
            }
        }
        true
    }

    /// Finds the limits of columns; without flushing they are 0.
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

    /// Copies a row of A to row r of the panel.
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

    /// An entry of row r of the panel in a column of A, or 0 where it is negligible.
    #[inline(always)]
    fn flushed(&self, entry: T, r: usize, column: usize) -> T {
        let PanelWorkspace { limits, column_limits, .. } = &*self.workspace;
        let is_negligible =
            limits[r].is_better_pivot(&entry) && column_limits[column].is_better_pivot(&entry);
        if is_negligible { T::zero() } else { entry }
    }

    /// Copies row r of the panel back, with the reciprocal of its pivot; `false` where that is 0.
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

    /// The place of a pivot, and of the end of its row.
    #[inline(always)]
    fn pivot(&self, row: usize) -> [usize; 2] {
        let right = self.couplings.rows[row].right();
        [right.start - 1, right.end]
    }

    /// Reduces rows together; `false` where a pivot is too small.
    #[inline(always)]
    fn has_reduced<L: Lanes<T>, const R: usize>(&mut self, together: &Together<'_, R>) -> bool {
        let &Together { rows, firsts, reduction, width, end } = together;
        let mut first = firsts[0];
        if R > 1 {
            for other in firsts {
                first = first.max(other);
            }
            first = first.min(end);
            for r in 0..R {
                if firsts[r] < first {
                    let (rows, firsts) = ([rows[r]], [firsts[r]]);
                    if !self.has_reduced::<L, 1>(&Together { rows, firsts, reduction, width, end: first }) {
                        return false;
                    }
                }
            }
        }
        while first < end {
            let next = end.min(first + PIVOTS);
            if !self.has_reduced_by::<L, R>(together, first..next) {
                return false;
            }
            first = next;
        }
        true
    }

    /// Reduces rows together by these pivots.
    #[inline(always)]
    fn has_reduced_by<L: Lanes<T>, const R: usize>(
        &mut self,
        together: &Together<'_, R>,
        pivots: Range<usize>,
    ) -> bool {
        let &Together { rows, reduction, width, .. } = together;
        let Range { start: first, end } = pivots;
        let count = end - first;
        for k in 0..count {
            let [diagonal, _] = self.pivot(first + k);
            self.workspace.uppers[k] = diagonal + count - k;
        }
        // Columns of the pivots' panel behind these pivots, of which their rows have all.
        let left = self.supernodes.panels[reduction.pivots].rows.end - end;
        let column = reduction.behind - left;
        for r in 0..R {
            for k in 0..count {
                let place = rows[r] * width + column + k - count;
                match self.factor(rows[r], place, first + k, end) {
                    Some(factor) => self.workspace.factors[k * R + r] = factor,
                    None => return false,
                }
            }
        }
        self.subtract::<L, R>(together, count, 0, column, left);
        let [start, short, last] = reduction.runs;
        for run in start..short {
            let Run { before, column, length } = self.supernodes.runs[run];
            self.subtract::<L, R>(together, count, left + before as usize, column as usize, length as usize);
        }
        for run in short..last {
            let Run { before, column, length } = self.supernodes.runs[run];
            for k in 0..length as usize {
                self.subtract_from::<T, R, 1>(
                    together,
                    count,
                    left + before as usize + k,
                    column as usize + k,
                );
            }
        }
        true
    }

    /// The factor that a row is reduced by with a pivot, by which it reduces the columns before
    /// `end`; `None` where the pivot is too small. The row's entry in the pivot's column is at
    /// `place`.
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

    /// Subtracts rows of `count` pivots, times their factors, in `length` columns from `column` on.
    /// The rows of pivots have `before` entries before them.
    #[inline(always)]
    fn subtract<L: Lanes<T>, const R: usize>(
        &mut self,
        together: &Together<'_, R>,
        count: usize,
        before: usize,
        column: usize,
        length: usize,
    ) {
        let mut done = 0;
        while done + 2 * L::WIDTH <= length {
            self.subtract_from::<L, R, 2>(together, count, before + done, column + done);
            done += 2 * L::WIDTH;
        }
        while done + L::WIDTH <= length {
            self.subtract_from::<L, R, 1>(together, count, before + done, column + done);
            done += L::WIDTH;
        }
        while done < length {
            self.subtract_from::<T, R, 1>(together, count, before + done, column + done);
            done += 1;
        }
    }

    #[inline(always)]
    fn subtract_from<V: Register<T>, const R: usize, const C: usize>(
        &mut self,
        together: &Together<'_, R>,
        count: usize,
        before: usize,
        column: usize,
    ) {
        let &Together { rows, width, .. } = together;
        let PanelWorkspace { rows: entries, factors, uppers, .. } = &mut *self.workspace;
        let (factors, uppers) = (&factors[..count * R], &uppers[..count]);
        let mut own = [[V::spread(&T::zero()); C]; R];
        for r in 0..R {
            for c in 0..C {
                own[r][c] = V::load(entries, rows[r] * width + column + c * V::WIDTH);
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
                own[r][c].store(entries, rows[r] * width + column + c * V::WIDTH);
            }
        }
    }
}
