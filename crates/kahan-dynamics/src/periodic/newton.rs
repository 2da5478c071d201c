//! Newton's method on all points of a cycle, by least norm where a whole family of cycles is near.

use kahan_core::nalgebra::{DMatrix, DVector};

use super::Differentiable;
use super::unit::InUnits;

/// A defect that is smaller than this, in units of the cycle's size, counts as none: the square of
/// a rounding. Newton's method would take a cycle at 0 to the end of the range, where numbers have
/// few digits.
pub(super) const NOTHING: f64 = f64::EPSILON * f64::EPSILON / 4.0;

/// φ(xᵢ) − xᵢ₊₁, one behind the other, the last back to the first; `None` where it is not finite.
pub(super) fn defect<M: Differentiable>(map: &InUnits<M>, cycle: &[f64]) -> Option<DVector<f64>> {
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

/// The derivative of the defect with respect to all points.
pub(super) fn slope<M: Differentiable>(map: &InUnits<M>, cycle: &DVector<f64>) -> DMatrix<f64> {
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

/// The shortest solution of least squares; singular values that are zero but for rounding count as
/// zero.
pub(super) fn least_norm(matrix: DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    /// A singular value that is 0 but for rounding, relative to the largest one.
    const ZERO: f64 = 1e-10;

    if !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let svd = matrix.svd(true, true);
    let largest = svd.singular_values.max();
    svd.solve(right, ZERO * largest).ok()
}

/// A cycle near the given one, with the size of its defect.
///
/// `None` where the map is not finite on the way.
pub(super) fn closed<M: Differentiable>(
    map: &InUnits<M>,
    cycle: DVector<f64>,
) -> Option<(DVector<f64>, f64)> {
    /// Newton's method doubles digits: what does not converge in so many does not converge.
    const ROUNDS: usize = 60;

    let mut cycle = cycle;
    let mut gaps = defect(map, cycle.as_slice())?;
    for _ in 0..ROUNDS {
        if gaps.amax() <= NOTHING {
            break;
        }
        let Some(step) = least_norm(slope(map, &cycle), &gaps) else { break };
        // Half the step, and half of that, until it is nearer.
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
