//! Newton's equations of a long cycle, condensed to the unknowns of one point.
//!
//! Let xᵢ be the points of a cycle of a map φ, and e a vector of further unknowns such as ε. The
//! equations for the corrections dxᵢ and de,
//!
//! dxᵢ₊₁ = Aᵢ dxᵢ + Bᵢ de + gᵢ
//!
//! are solved together with linear conditions, such as a fixed phase.
//!
//! # Method
//!
//! Here Aᵢ = ∂φ/∂x and Bᵢ = ∂φ/∂e at xᵢ, and gᵢ = φ(xᵢ) − xᵢ₊₁. Each dxᵢ is an affine function of
//! dx₀ and de, so N points cost N multiplications of small matrices and one small decomposition.

use kahan_core::nalgebra::{DMatrix, DVector};

use super::Differentiable;
use super::unit::ScaledMap;

pub(super) struct CondensedEquations {
    /// The matrices that map (dx₀, de, 1) to dxᵢ. Here dxᵢ is the correction of point i, and de is
    /// the correction of the further unknowns.
    affine: Vec<DMatrix<f64>>,
    /// The condition dx_N − dx₀ = 0 on these corrections, as a matrix that acts on (dx₀, de, 1).
    closing: DMatrix<f64>,
}

/// The corrections dxᵢ of all points, then those of the further unknowns e.
pub(super) struct Solution {
    pub(super) step: DVector<f64>,
    /// The smallest singular value of the condensed system divided by the largest.
    pub(super) rank: f64,
}

impl CondensedEquations {
    /// Condenses the equations at `points`. `rates(x, k)` is the derivative of the map at x with
    /// respect to further unknown k. `gaps` holds all φ(xᵢ) − xᵢ₊₁. `None` means that they are 0.
    pub(super) fn of<M: Differentiable>(
        map: &ScaledMap<M>,
        points: &[f64],
        gaps: Option<&DVector<f64>>,
        others: usize,
        rates: impl Fn(&[f64], usize) -> Vec<f64>,
    ) -> Self {
        let n = map.dimension();
        let mut rows = DMatrix::zeros(n, n + others + 1);
        rows.view_mut((0, 0), (n, n)).fill_with_identity();
        let mut affine = Vec::with_capacity(points.len() / n);
        for (i, x) in points.chunks(n).enumerate() {
            let mut next = map.derivative(x) * &rows;
            for other in 0..others {
                next.column_mut(n + other).iter_mut().zip(rates(x, other)).for_each(|(to, rate)| *to += rate);
            }
            if let Some(gaps) = gaps {
                let mut last = next.column_mut(n + others);
                last += gaps.rows(i * n, n);
            }
            affine.push(std::mem::replace(&mut rows, next));
        }
        for k in 0..n {
            rows[(k, k)] -= 1.0;
        }
        CondensedEquations { affine, closing: rows }
    }

    pub(super) fn solve(&self, conditions: &[(&DVector<f64>, f64)]) -> Option<Solution> {
        /// Singular values below this fraction of the largest one are treated as 0.
        const ZERO: f64 = 1e-13;

        let (n, columns) = (self.closing.nrows(), self.closing.ncols() - 1);
        let mut matrix = DMatrix::zeros(n + conditions.len(), columns);
        let mut right = DVector::zeros(n + conditions.len());
        matrix.rows_mut(0, n).copy_from(&self.closing.columns(0, columns));
        right.rows_mut(0, n).copy_from(&-self.closing.column(columns));
        for (place, (row, value)) in (n..).zip(conditions) {
            let mut sum = DVector::zeros(columns + 1);
            for (i, affine) in self.affine.iter().enumerate() {
                sum.gemv_tr(1.0, affine, &row.rows(i * n, n), 1.0);
            }
            let others = row.rows(self.affine.len() * n, columns - n);
            let mut last = sum.rows_mut(n, columns - n);
            last += others;
            // Only the direction of a condition matters, so each condition is scaled to norm 1.
            let length = sum.rows(0, columns).norm();
            matrix.row_mut(place).copy_from(&(sum.rows(0, columns) / length).transpose());
            right[place] = (value - sum[columns]) / length;
        }
        if !matrix.iter().chain(right.iter()).all(|entry| entry.is_finite()) {
            return None;
        }
        let svd = matrix.svd(true, true);
        let (least, largest) = (svd.singular_values.min(), svd.singular_values.max());
        let first = svd.solve(&right, ZERO * largest).ok()?;
        let unknowns = first.clone().push(1.0);
        let points = self.affine.iter().flat_map(|affine| (affine * &unknowns).as_slice().to_vec());
        let step: Vec<f64> = points.chain(first.rows(n, columns - n).iter().copied()).collect();
        let is_finite = step.iter().all(|entry| entry.is_finite());
        is_finite.then(|| Solution { step: DVector::from_vec(step), rank: least / largest })
    }
}

/// Returns a unit vector that shifts all points along the cycle. The last `others` entries are 0.
pub(super) fn phase_direction(points: &[f64], n: usize, others: usize) -> DVector<f64> {
    let len = points.len();
    let entry = |k: usize| if k < len { points[(k + n) % len] - points[(k + len - n) % len] } else { 0.0 };
    DVector::from_fn(len + others, |k, _| entry(k)).normalize()
}
