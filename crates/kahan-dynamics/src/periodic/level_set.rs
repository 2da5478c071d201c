//! A map restricted to a level set of linear integrals, in fewer variables.
//!
//! The free variables are coordinates on the level set through a point. Cycles of the restricted
//! map have multipliers along the level set only.

use kahan_core::nalgebra::DMatrix;
use kahan_core::{Scalar, Step, Stopped, Workspace};

use super::{Differentiable, Parametric};

/// The level set of linear integrals through one point. Its coordinates are the free variables,
/// which no integral determines.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelSet {
    free: Vec<usize>,
    determined: Vec<DependentVariable>,
}

#[derive(Clone, Debug, PartialEq)]
struct DependentVariable {
    index: usize,
    constant: f64,
    slopes: Vec<f64>,
}

impl LevelSet {
    /// Makes the level set through a point. Each integral Σ cₖ xₖ is a list of pairs (k, cₖ). The
    /// variable of the last pair is determined by the integral, and must not occur in other
    /// integrals.
    ///
    /// # Panics
    /// If an integral has no pair, or an index is out of range.
    #[must_use]
    pub fn through(point: &[f64], integrals: &[Vec<(usize, f64)>]) -> Self {
        let last = |integral: &Vec<(usize, f64)>| *integral.last().expect("an integral has a coefficient");
        let is_free = |k: &usize| integrals.iter().all(|integral| last(integral).0 != *k);
        let free: Vec<usize> = (0..point.len()).filter(is_free).collect();
        let determined = integrals.iter().map(|integral| {
            let (index, divisor) = last(integral);
            let total: f64 = integral.iter().map(|(k, c)| c * point[*k]).sum();
            let coefficient = |k: &usize| integral.iter().find(|(own, _)| own == k).map_or(0.0, |(_, c)| *c);
            let slopes = free.iter().map(|k| -coefficient(k) / divisor).collect();
            DependentVariable { index, constant: total / divisor, slopes }
        });
        LevelSet { determined: determined.collect(), free }
    }

    /// Returns the point with these coordinates.
    ///
    /// # Panics
    /// If the number of coordinates differs from the number of free variables.
    #[must_use]
    pub fn point<T: Scalar + From<f64>>(&self, coordinates: &[T]) -> Vec<T> {
        assert_eq!(coordinates.len(), self.free.len(), "a leaf has a coordinate for each free variable");
        let mut point = vec![T::zero(); self.free.len() + self.determined.len()];
        for (k, coordinate) in self.free.iter().zip(coordinates) {
            point[*k] = coordinate.clone();
        }
        for DependentVariable { index, constant, slopes } in &self.determined {
            let terms = slopes.iter().zip(coordinates);
            point[*index] =
                terms.fold((*constant).into(), |sum: T, (slope, y)| sum + T::from(*slope) * y.clone());
        }
        point
    }

    /// Returns the values of the free variables at a point of the level set.
    ///
    /// # Panics
    /// If the point has too few entries.
    #[must_use]
    pub fn coordinates<T: Clone>(&self, point: &[T]) -> Vec<T> {
        self.free.iter().map(|k| point[*k].clone()).collect()
    }

    /// Returns the derivative in the free variables, from the derivative `full` in all variables.
    fn derivative(&self, full: &DMatrix<f64>) -> DMatrix<f64> {
        let m = self.free.len();
        DMatrix::from_fn(m, m, |i, j| {
            let row = self.free[i];
            let through = self.determined.iter().map(|one| full[(row, one.index)] * one.slopes[j]);
            full[(row, self.free[j])] + through.sum::<f64>()
        })
    }
}

/// A map restricted to a level set that it preserves, in the coordinates of the level set.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_dynamics::periodic::{LevelSet, OnLevelSet, Stability, periodic_point};
///
/// kahan! {
///     /// An epidemic with loss of immunity; s + i + r is constant.
///     pub struct Sirs;
///     sdot = -2*s*i + r/2;
///     idot = 2*s*i - i;
///     rdot = i - r/2;
/// }
///
/// let start = [0.5, 0.2, 0.3];
/// let leaf = LevelSet::through(&start, &[vec![(0, 1.0), (1, 1.0), (2, 1.0)]]);
/// let map = OnLevelSet { map: Sirs.at(0.1), leaf: &leaf };
/// let found = periodic_point(&map, &leaf.coordinates(&start), 1).unwrap();
/// let endemic = leaf.point(&found.points[0]);
/// assert!(endemic.iter().zip([1.0 / 2.0, 1.0 / 6.0, 1.0 / 3.0]).all(|(x, y)| (x - y).abs() < 1e-12));
/// // Without the integral's own multiplier, which is 1, all are smaller than 1.
/// assert_eq!(found.stability(), Stability::Attracting);
/// ```
#[derive(Clone, Debug)]
pub struct OnLevelSet<'a, M> {
    /// The map in all variables.
    pub map: M,
    /// The level set to which the map is restricted.
    pub leaf: &'a LevelSet,
}

impl<M: Step<Scalar: From<f64>>> OnLevelSet<'_, M> {
    /// Calls `image` on a point of the level set, and updates its `coordinates`.
    fn by(
        &self,
        coordinates: &mut [M::Scalar],
        image: impl FnOnce(&mut [M::Scalar]) -> Result<(), Stopped>,
    ) -> Result<(), Stopped> {
        let mut point = self.leaf.point(coordinates);
        let ended = image(&mut point);
        coordinates.clone_from_slice(&self.leaf.coordinates(&point));
        ended
    }
}

impl<M: Step<Scalar: From<f64>>> Step for OnLevelSet<'_, M> {
    type Scalar = M::Scalar;
    type State = Vec<M::Scalar>;

    fn dimension(&self) -> usize {
        self.leaf.free.len()
    }

    fn eps(&self) -> &M::Scalar {
        self.map.eps()
    }

    #[track_caller]
    fn advance(&self, x: &mut [M::Scalar], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        self.by(x, |point| self.map.advance(point, steps, workspace))
    }

    #[track_caller]
    fn part(&self, eps: &M::Scalar, x: &mut [M::Scalar], workspace: &mut Workspace) -> Result<(), Stopped> {
        self.by(x, |point| self.map.part(eps, point, workspace))
    }
}

impl<M: Differentiable> Differentiable for OnLevelSet<'_, M> {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        self.leaf.derivative(&self.map.derivative(&self.leaf.point(x)))
    }
}

impl<M: Parametric> Parametric for OnLevelSet<'_, M> {
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        self.leaf.coordinates(&self.map.by_parameter(&self.leaf.point(x)))
    }
}
