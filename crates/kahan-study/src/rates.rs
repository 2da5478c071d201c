//! Checks whether steps resolve the fast components of a field.
//!
//! Kahan's map multiplies a component of rate λ by (1 + ελ)/(1 − ελ), which is close to exp(2ελ)
//! only for small |2ελ|. For λ < −1/ε, where |2ελ| > 2, a decaying component changes sign in each
//! step.

use kahan_runtime::MapAt;

use crate::study::Study;

const MOST_POINTS: u64 = 16;

/// The largest number of points that are checked if the field has more than [`MANY_VARIABLES`]
/// variables.
const MOST_OF_MANY: u64 = 4;

/// Above this number of variables, evaluating f′ costs more than computing a row of an orbit table.
const MANY_VARIABLES: usize = 32;

/// Steps with |2ελ| above this bound do not resolve a component that changes at the rate λ.
const UNRESOLVED_RATE: f64 = 2.0;

/// The growth of a vector is measured over 32 multiplications by f′, the field's Jacobian, after 16
/// multiplications that are not measured.
const PRODUCT_COUNTS: [u32; 2] = [16, 32];

/// The rates of a field at points of an orbit.
pub struct Rates {
    at: MapAt<f64>,
    variables: usize,
    jacobian: Vec<f64>,
    /// The number of checked points, and the number of those with an unresolved component.
    points: [u32; 2],
    largest: f64,
}

impl Study {
    /// Prepares a check of the field's rates against steps of 2ε. Returns `None` if ε is 0.
    #[must_use]
    pub fn rates(&self, eps: f64) -> Option<Rates> {
        let map = self.map().ok().filter(|_| eps != 0.0 && eps.is_finite())?;
        let variables = self.variables().len();
        let jacobian = vec![0.0; variables.pow(2)];
        Some(Rates { at: map.at(eps), variables, jacobian, points: [0; 2], largest: 0.0 })
    }
}

impl Rates {
    /// Returns k if every k-th of the `rows` points of an orbit should be [checked](Self::inspect).
    #[must_use]
    pub fn stride(&self, rows: u64) -> u64 {
        let most = if self.variables > MANY_VARIABLES { MOST_OF_MANY } else { MOST_POINTS };
        rows.div_ceil(most).max(1)
    }

    /// Returns the number of variables of a point.
    #[must_use]
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// Checks a point. Computes f′ and, if its norm is large, about 50 products of f′ and a vector.
    pub fn inspect(&mut self, x: &[f64]) {
        let Self { at, jacobian, points: [count, fast], largest, .. } = self;
        if !x.iter().all(|x| x.is_finite()) || at.field_jacobian(x, jacobian).is_err() {
            return;
        }
        *count += 1;
        let step = 2.0 * at.eps().abs();
        // The ∞-norm of f′ bounds every eigenvalue.
        let bound = jacobian.chunks_exact(x.len()).map(|row| row.iter().map(|entry| entry.abs()).sum());
        if bound.fold(0.0, f64::max) * step > UNRESOLVED_RATE {
            let size = spectral_radius(jacobian, x.len()) * step;
            *fast += u32::from(size > UNRESOLVED_RATE);
            *largest = largest.max(size);
        }
    }

    /// Returns a warning if at least half of the checked points have fast components.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        let [count, fast] = self.points;
        // Round to two significant digits.
        let largest = || format!("{:.1e}", self.largest).parse().unwrap_or(self.largest);
        (fast > 0 && 2 * fast >= count).then(|| {
            format!(
                "fast components are not resolved: |2 eps lambda| is up to {} for an eigenvalue lambda of f' along the orbit, \
                 and should be below {UNRESOLVED_RATE}",
                largest()
            )
        })
    }
}

/// Estimates the spectral radius by power iteration, as the mean growth factor of a vector.
fn spectral_radius(matrix: &[f64], n: usize) -> f64 {
    // Power iteration may keep a symmetry of the start vector, so this vector has none.
    let mut x: Vec<f64> = (0..n).map(|k| 1.0 + (k as f64 * 0.618).fract()).collect();
    let mut product = vec![0.0; n];
    let [before, measured] = PRODUCT_COUNTS;
    let mut growth = 0.0;
    for made in 0..before + measured {
        for (entry, row) in product.iter_mut().zip(matrix.chunks_exact(n)) {
            *entry = row.iter().zip(&x).map(|(a, x)| a * x).sum();
        }
        let length = product.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        // The length is 0 if the matrix is nilpotent, and not finite if its entries are too large.
        if length == 0.0 || !length.is_finite() {
            return length;
        }
        product.iter_mut().for_each(|entry| *entry /= length);
        std::mem::swap(&mut x, &mut product);
        if made >= before {
            growth += libm::log(length);
        }
    }
    libm::exp(growth / f64::from(measured))
}

#[cfg(test)]
mod tests {
    use super::spectral_radius;

    #[test]
    fn the_spectral_radius_is_that_of_the_largest_eigenvalue() {
        let oscillator = [0.0, 1.0, -1e4, 0.0];
        let decay = [-100.0, 100.0, 0.0, -1.0];
        // The matrix has the eigenvalues 3 ± 4i and 1.
        let spiral = [3.0, 4.0, 0.0, -4.0, 3.0, 0.0, 7.0, 0.0, 1.0];
        let found =
            [spectral_radius(&oscillator, 2), spectral_radius(&decay, 2), spectral_radius(&spiral, 3)];
        for (found, wanted) in found.into_iter().zip([100.0, 100.0, 5.0]) {
            assert!((found / wanted - 1.0).abs() < 0.02, "{found} {wanted}");
        }
        assert_eq!(spectral_radius(&[0.0, 1e9, 0.0, 0.0], 2), 0.0);
    }
}
