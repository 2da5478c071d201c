//! Finds the degree of a rational function of one variable from values of the function.
//!
//! Let the values be given at points tᵢ. Thiele's continued fraction v₀ + (t − t₀)/(v₁ + (t −
//! t₁)/(v₂ + …)) of a rational function is finite. If its last coefficient is v_L, the degree is
//! ⌈L/2⌉. Further points verify the result.

use crate::deadline::Deadline;
use crate::modular::modulus::Modulus;

/// The number of points that check the continued fraction after its computation. They miss a wrong
/// degree with a probability below (degree/p)⁴ for the prime p.
pub(crate) const SPARE_POINTS: usize = 4;

/// Returns max(deg P, deg Q) of the function P/Q in lowest terms with `values` at distinct
/// `points`. Returns `None` if more points are needed or the deadline passes. The cost is 4
/// multiplications for each pair of the first 2·degree points.
#[must_use]
pub fn degree(modulus: &Modulus, points: &[u64], values: &[u64], deadline: &Deadline<'_>) -> Option<usize> {
    let mut points = points.to_vec();
    let mut values = values.to_vec();
    for level in 0.. {
        if points.len() <= SPARE_POINTS || deadline.passed() {
            return None;
        }
        let (start, first) = (points.remove(0), values.remove(0));
        let mut differences: Vec<u64> = values.iter().map(|&value| modulus.minus(value, first)).collect();
        if differences.iter().all(|&difference| difference == 0) {
            return Some(usize::div_ceil(level, 2));
        }
        // Drops points with difference 0, because the next step divides by the differences.
        let mut kept = differences.iter().map(|&difference| difference != 0);
        points.retain(|_| kept.next().expect("one for each point"));
        differences.retain(|&difference| difference != 0);
        if !modulus.invert_all(&mut differences) {
            return None;
        }
        values = points
            .iter()
            .zip(&differences)
            .map(|(&point, &inverse)| modulus.times(modulus.minus(point, start), inverse))
            .collect();
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::prime_field::SplitMix64;

    fn sampled(a: u32, b: u32, count: usize) -> Option<usize> {
        let modulus = Modulus::mersenne_61();
        let mut random = SplitMix64::new(11);
        let points: Vec<u64> = (0..count).map(|_| modulus.sample(&mut random)).collect();
        let values = points.iter().map(|&t| {
            let above = modulus.plus(modulus.power(t, a), modulus.integer(3));
            let below = modulus.minus(modulus.power(t, b), modulus.integer(5));
            modulus.times(above, modulus.inverse(below).unwrap())
        });
        let values: Vec<u64> = values.collect();
        degree(&modulus, &points, &values, &Deadline::never())
    }

    #[test]
    fn the_degree_is_the_larger_of_both() {
        assert_eq!(sampled(0, 0, 20), Some(0));
        assert_eq!(sampled(7, 7, 40), Some(7));
        assert_eq!(sampled(7, 4, 40), Some(7));
        assert_eq!(sampled(2, 9, 40), Some(9));
        assert_eq!(sampled(40, 40, 60), None);
    }

    #[test]
    fn a_degree_is_told_when_four_points_to_spare_agree() {
        for d in [0, 1, 2, 7, 20] {
            let needed = 2 * d as usize + 1;
            assert_eq!(sampled(d, d, needed + 4), Some(d as usize));
            assert_eq!(sampled(d, d, needed + 3), None);
        }
    }

    #[test]
    fn one_spare_point_that_does_not_agree_is_enough() {
        let modulus = Modulus::mersenne_61();
        let points: Vec<u64> = (1..=7).collect();
        let values = points.iter().map(|&t| modulus.inverse(modulus.plus(t, modulus.one())).unwrap());
        let values: Vec<u64> = values.collect();
        let told = |values: &[u64]| degree(&modulus, &points, values, &Deadline::never());
        assert_eq!(told(&values), Some(1));
        for changed in 0..points.len() {
            let mut values = values.clone();
            values[changed] = modulus.plus(values[changed], modulus.one());
            assert_eq!(told(&values), None, "the value with index {changed}");
        }
    }
}
