//! Many trajectories at once, of one map or each of its own.
//!
//! In: initial points. Out: the points some steps later, at the limit of the machine: one column a
//! variable, tiles that stay in the nearest cache, registers of several trajectories, chosen at run
//! time, threads with `parallel`. What a step is lies elsewhere: an ensemble runs the prepared step
//! of a map, the same code over other scalars. A pole is not looked for; it shows as numbers that
//! are not finite.

#[cfg(target_arch = "aarch64")]
mod aarch64;
pub(crate) mod advance;
pub(crate) mod columns;
mod each;
mod grid;
pub(crate) mod lanes;
mod level;
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
mod one;
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
mod registers;
mod scalar;
mod sweep;
pub(crate) mod twice;
#[cfg(target_arch = "x86_64")]
mod x86_64;

use core::fmt;
use std::vec::Vec;

use nalgebra::SVector;

use columns::Columns;
use level::Instructions;

pub use advance::Advances;
pub use grid::Axis;
pub use level::{Level, Reciprocal};
pub use scalar::EnsembleScalar;

/// Points of an N-dimensional state, advanced together by one map or each by its own.
///
/// One column a variable; the points keep their order. Made by [`new`](Self::new) or
/// [`grid`](Self::grid), moved by [`advance`](Self::advance).
///
/// # The same bits every time
/// A trajectory's bits depend on its initial point, the map, ε and the [`Level`] alone: not on the
/// run, its place, the number of points, or the number of threads. Levels differ from each other
/// and from [`KahanAt::step`](crate::KahanAt::step) where one of them fuses multiply-adds and the
/// other does not: [`Level::Avx2`], [`Level::Avx512`] and [`Level::Neon`] always do, and have the
/// same bits, [`Level::Baseline`] and `step` where the program is compiled for it. An ensemble runs
/// on the largest level of the processor; [`at_level`](Self::at_level) pins another one.
///
/// # Cost
/// N numbers of memory a point. The processor works on many trajectories side by side, so that none
/// waits for the results of another step: the time is that of the unit with most to do, mostly the
/// one that divides.
pub struct Ensemble<T, const N: usize> {
    pub(crate) columns: Columns<T, N>,
    pub(crate) instructions: Instructions,
}

impl<T: EnsembleScalar, const N: usize> Ensemble<T, N> {
    /// The ensemble of these points, in this order.
    pub fn new(points: Vec<SVector<T, N>>) -> Self {
        Self::from_columns(Columns::new(points.len(), |i, c| points[i][c]))
    }

    fn from_columns(columns: Columns<T, N>) -> Self {
        let instructions = Instructions { level: Level::best(), reciprocal: Reciprocal::default() };
        Self { columns, instructions }
    }

    /// The same ensemble, run on another level; `None` if this processor lacks it.
    pub fn at_level(mut self, level: Level) -> Option<Self> {
        self.instructions.level = level;
        level.is_available().then_some(self)
    }

    /// The level that the ensemble runs on.
    pub fn level(&self) -> Level {
        self.instructions.level
    }

    /// The same ensemble with another way of computing reciprocals, which changes bits on
    /// [`Level::Avx512`] only.
    pub fn with_reciprocal(mut self, reciprocal: Reciprocal) -> Self {
        self.instructions.reciprocal = reciprocal;
        self
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.columns.len()
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Point `i`, in the order in which they were given; `None` from [`len`](Self::len) on.
    pub fn point(&self, i: usize) -> Option<SVector<T, N>> {
        (i < self.len()).then(|| SVector::from_fn(|c, _| self.columns.column(c)[i]))
    }

    /// All points in order.
    pub fn points(&self) -> impl DoubleEndedIterator<Item = SVector<T, N>> + ExactSizeIterator + '_ {
        let columns: [&[T]; N] = core::array::from_fn(|c| self.columns.column(c));
        (0..self.len()).map(move |i| SVector::from_fn(|c, _| columns[c][i]))
    }

    /// Variable `i` of all points: one number a point, in order.
    ///
    /// # Panics
    /// If `i` is not less than N.
    pub fn column(&self, i: usize) -> &[T] {
        assert!(i < N, "variable {i} of a state of {N}");
        self.columns.column(i)
    }
}

impl<T: EnsembleScalar, const N: usize> Clone for Ensemble<T, N> {
    fn clone(&self) -> Self {
        Self { columns: self.columns.clone(), instructions: self.instructions }
    }
}

/// Two are equal where their points are, whatever they run on.
impl<T: EnsembleScalar, const N: usize> PartialEq for Ensemble<T, N> {
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len() && (0..N).all(|c| self.column(c) == other.column(c))
    }
}

impl<T: EnsembleScalar, const N: usize> fmt::Debug for Ensemble<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.points().map(|point| point.data.0)).finish()
    }
}
