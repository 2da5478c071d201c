//! Newton's method for all points of a cycle at once, with steps of least norm in families of
//! cycles.

use kahan_core::nalgebra::{DMatrix, DVector};

use super::Differentiable;
use super::unit::ScaledMap;

/// Newton's method stops at this relative residual, the square of the unit roundoff. Near a cycle
/// at 0, a smaller limit leads to subnormal numbers.
pub(super) const NEGLIGIBLE_RESIDUAL: f64 = f64::EPSILON * f64::EPSILON / 4.0;

/// Returns φ(xᵢ) − xᵢ₊₁ for all points xᵢ of the cycle. Returns `None` if a number is not finite.
pub(super) fn defect<M: Differentiable>(map: &ScaledMap<M>, cycle: &[f64]) -> Option<DVector<f64>> {
    let n = map.dimension();
    let points = cycle.chunks(n);
    let next = points.clone().cycle().skip(1);
    let gaps = points.zip(next).flat_map(|(x, next)| {
        let image = map.image(x);
        image.into_iter().zip(next.to_vec()).map(|(image, next)| image - next).collect::<Vec<_>>()
    });
    let gaps = DVector::from_iterator(cycle.len(), gaps);
    gaps.iter().all(|gap| gap.is_finite()).then_some(gaps)
}

pub(super) fn slope<M: Differentiable>(map: &ScaledMap<M>, cycle: &DVector<f64>) -> DMatrix<f64> {
    let n = map.dimension();
    let period = cycle.len() / n;
    let mut slope = DMatrix::zeros(cycle.len(), cycle.len());
    for (i, x) in cycle.as_slice().chunks(n).enumerate() {
        let derivative = map.derivative(x);
        slope.view_mut((i * n, i * n), (n, n)).copy_from(&derivative);
        let next = (i + 1) % period;
        for k in 0..n {
            slope[(i * n + k, next * n + k)] -= 1.0;
        }
    }
    slope
}

/// Solves a least-squares problem, and returns the solution of least norm.
pub(super) fn least_norm_solution(matrix: DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    /// Singular values below this fraction of the largest one are treated as 0.
    const ZERO: f64 = 1e-10;

    if !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let svd = matrix.svd(true, true);
    let largest = svd.singular_values.max();
    svd.solve(right, ZERO * largest).ok()
}

/// Makes damped Newton steps from a guess. Returns the cycle and the norm of its [`defect`].
pub(super) fn newton_cycle<M: Differentiable>(
    map: &ScaledMap<M>,
    cycle: DVector<f64>,
) -> Option<(DVector<f64>, f64)> {
    const NEWTON_ITERATIONS: usize = 60;

    let mut cycle = cycle;
    let mut gaps = defect(map, cycle.as_slice())?;
    for _ in 0..NEWTON_ITERATIONS {
        if gaps.amax() <= NEGLIGIBLE_RESIDUAL {
            break;
        }
        let Some(step) = least_norm_solution(slope(map, &cycle), &gaps) else { break };
        let nearer = (0..30).find_map(|halvings| {
            let trial = &cycle - &step * 0.5f64.powi(halvings);
            let gaps_there = defect(map, trial.as_slice())?;
            (gaps_there.amax() < gaps.amax()).then_some((trial, gaps_there))
        });
        let Some((trial, gaps_there)) = nearer else { break };
        (cycle, gaps) = (trial, gaps_there);
    }
    let size = gaps.amax();
    Some((cycle, size))
}
