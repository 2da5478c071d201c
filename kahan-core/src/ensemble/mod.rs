//! Ensembles: many trajectories advanced together, by one map or by one map per trajectory.
//!
//! The speed comes from a column per variable, from tiles that stay in the first-level cache, from
//! SIMD lanes, and with `parallel` from threads. Over floats, poles are not detected, and give
//! infinities or NaNs.

#[cfg(target_arch = "aarch64")]
mod aarch64;
pub(crate) mod advance;
pub(crate) mod columns;
mod grid;
pub(crate) mod lanes;
mod level;
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
mod one;
pub(crate) mod register_pair;
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
mod registers;
mod scalar;
mod sweep;
mod trajectory_maps;
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

/// Points of an N-dimensional state, advanced together by one map or by one map per point.
///
/// Each variable of the points is stored as one column, and points keep their order.
/// [`new`](Self::new) and [`grid`](Self::grid) build an ensemble; [`advance`](Self::advance)
/// advances its points.
///
/// # Reproducibility
/// A trajectory's bits depend only on its initial point, the map, ε, the [`Level`] and the
/// [`Reciprocal`]. [`Level::Avx2`], [`Level::Avx512`] and [`Level::Neon`] fuse multiply-adds and
/// give equal bits. [`Level::Baseline`] and [`KahanAt::step`](crate::KahanAt::step) fuse
/// only if the program is compiled for fused instructions. An ensemble runs on the highest
/// instruction set of the processor, unless [`at_level`](Self::at_level) selects another.
///
/// # Cost
/// The memory is N numbers per point. Trajectories are independent. Therefore the busiest execution
/// unit, usually the divider, determines the time.
pub struct Ensemble<T, const N: usize> {
    pub(crate) columns: Columns<T, N>,
    pub(crate) instructions: Instructions,
}

impl<T: EnsembleScalar, const N: usize> Ensemble<T, N> {
    /// Creates an ensemble of the given points.
    pub fn new(points: Vec<SVector<T, N>>) -> Self {
        Self::from_columns(Columns::new(points.len(), |i, c| points[i][c]))
    }

    fn from_columns(columns: Columns<T, N>) -> Self {
        let instructions = Instructions { level: Level::best(), reciprocal: Reciprocal::default() };
        Self { columns, instructions }
    }

    /// Selects an instruction set. Returns `None` if the processor lacks it.
    pub fn at_level(mut self, level: Level) -> Option<Self> {
        self.instructions.level = level;
        level.is_available().then_some(self)
    }

    /// Returns the instruction set in use.
    pub fn level(&self) -> Level {
        self.instructions.level
    }

    /// Selects how reciprocals are computed. The choice changes bits on [`Level::Avx512`] only.
    pub fn with_reciprocal(mut self, reciprocal: Reciprocal) -> Self {
        self.instructions.reciprocal = reciprocal;
        self
    }

    /// Returns the number of points.
    pub fn len(&self) -> usize {
        self.columns.len()
    }

    /// Returns whether the ensemble has no points.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns point `i` in the given order, or `None` if `i` ≥ [`len`](Self::len).
    pub fn point(&self, i: usize) -> Option<SVector<T, N>> {
        (i < self.len()).then(|| SVector::from_fn(|c, _| self.columns.column(c)[i]))
    }

    /// Iterates over all points in order.
    pub fn points(&self) -> impl DoubleEndedIterator<Item = SVector<T, N>> + ExactSizeIterator + '_ {
        let columns: [&[T]; N] = core::array::from_fn(|c| self.columns.column(c));
        (0..self.len()).map(move |i| SVector::from_fn(|c, _| columns[c][i]))
    }

    /// Returns the values of variable `i`, one per point, in the order of the points.
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

/// Compares the points, but not the instruction sets.
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
