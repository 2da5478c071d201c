//! Newton's equations around a long cycle, reduced to as many unknowns as one point has.
//!
//! In: a map, the points of a cycle, and how the map depends on a few further unknowns e, as ε.
//! Out: solutions of
//!
//! dxᵢ₊₁ = Aᵢ dxᵢ + Bᵢ de + gᵢ
//!
//! around the cycle that meet further conditions. All dxᵢ are affine functions of dx₀ and de, so
//! that a cycle of N points costs N products of small matrices and one small decomposition.

use kahan_core::nalgebra::{DMatrix, DVector};

use super::Differentiable;
use super::unit::InUnits;

/// The equations of one cycle.
pub(super) struct Condensed {
    /// dxᵢ as a function of (dx₀, de, 1), for each i.
    affine: Vec<DMatrix<f64>>,
    /// φ's image of the last of them, less dx₀: what has to vanish.
    closing: DMatrix<f64>,
}

/// A solution: the points' part, one behind the other, and behind them de.
pub(super) struct Solution {
    pub(super) step: DVector<f64>,
    /// The ratio of the smallest singular value of the equations to the largest: 0 where they have
    /// several solutions.
    pub(super) rank: f64,
}

impl Condensed {
    /// Returns the equations at these points. `rates` are the derivatives of the map by each of
    /// `others` further unknowns; `gaps` are the gᵢ, 0 where there are none.
    pub(super) fn of<M: Differentiable>(
        map: &InUnits<M>,
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
        // After the last step dx₀ comes again.
        for k in 0..n {
            rows[(k, k)] -= 1.0;
        }
        Condensed { affine, closing: rows }
    }

    /// Solves them together with conditions r·(dx, de) = s.
    pub(super) fn solve(&self, conditions: &[(&DVector<f64>, f64)]) -> Option<Solution> {
        /// A singular value that is 0 but for rounding, relative to the largest one.
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
            // Of length 1, as its length is no part of the condition.
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

/// The direction along the cycle, of length 1, in which its points may slide; 0 for `others`
/// further unknowns.
pub(super) fn along(points: &[f64], n: usize, others: usize) -> DVector<f64> {
    let len = points.len();
    let entry = |k: usize| if k < len { points[(k + n) % len] - points[(k + len - n) % len] } else { 0.0 };
    DVector::from_fn(len + others, |k, _| entry(k)).normalize()
}
