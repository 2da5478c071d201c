//! Classifies the growth of the degrees of iterates by differences and ratios of degrees.

use std::fmt;

use crate::orbits::plane::GrowthProof;

/// The growth of the degrees dₙ of iterates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Growth {
    /// The degrees are constant from some iterate on.
    Bounded,
    /// The degrees grow like n. The level curves have genus 0, or the map is linearisable.
    Linear,
    /// The degrees grow like n². The map is integrable on curves of genus 1 or on abelian surfaces.
    Quadratic,
    /// The degrees grow like exp(sn) with s > 0. The map is not integrable.
    Exponential {
        /// The algebraic entropy s: the logarithm of the ratio of successive degrees.
        entropy: f64,
    },
    /// The iterates are too few, or their degrees grow in another way.
    Undecided,
}

/// A kind of growth with its evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct GrowthVerdict {
    /// The kind of growth.
    pub growth: Growth,
    /// The observation in words.
    pub evidence: String,
    /// The proof of exponential growth, or `None` if growth was only observed.
    pub proof: Option<GrowthProof>,
}

impl Growth {
    /// Returns the kind of growth in one word.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Growth::Bounded => "bounded",
            Growth::Linear => "linear",
            Growth::Quadratic => "quadratic",
            Growth::Exponential { .. } => "exponential",
            Growth::Undecided => "undecided",
        }
    }

    /// Returns the algebraic entropy, which is 0 unless growth is exponential.
    #[must_use]
    pub fn entropy(&self) -> f64 {
        match self {
            Growth::Exponential { entropy } => *entropy,
            _ => 0.0,
        }
    }
}

impl fmt::Display for Growth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// Two ratios of degrees are treated as equal if their relative difference is at most this.
const CONSTANT_RATIO_TOLERANCE: f64 = 0.08;

impl GrowthVerdict {
    /// Classifies the degrees d₀, d₁, … by the first rule that applies:
    ///
    /// 1. *Bounded* or *linear*: for the least possible k the last max(4, 2k) differences dₙ₊ₖ − dₙ
    ///    are constant. Growth is bounded if the constant is 0 and k = 1. If k > 1, a pattern of
    ///    degrees repeats.
    /// 2. *Quadratic*: the second differences over k steps are constant as in rule 1.
    /// 3. *Exponential*: the last four ratios dₙ₊₁/dₙ exceed 1.15. The last ratio r differs by at
    ///    most 8 % from the ratio two steps before. For the ratio s in the middle of the list,
    ///    r − 1 ≥ ⅔ (s − 1). For powers dₙ = nᵐ, the quotient (r − 1)/(s − 1) is about 1/2.
    /// 4. *Undecided*: no other rule applies.
    #[must_use]
    pub fn of(degrees: &[usize]) -> Self {
        let values: Vec<i128> = degrees.iter().map(|&degree| degree as i128).collect();
        let count = values.len();
        let verdict = |growth, evidence: String| GrowthVerdict { growth, evidence, proof: None };
        for (order, what) in [(1, "differences"), (2, "second differences")] {
            if let Some((period, difference, confirmed)) = constant_differences(&values, order) {
                let growth = match (order, difference) {
                    (2, _) => Growth::Quadratic,
                    (_, 0) => Growth::Bounded,
                    _ => Growth::Linear,
                };
                let steps = steps(period, difference, what);
                return verdict(growth, format!("{steps} over the last {confirmed} of {count} degrees"));
            }
        }
        match exponential(&values) {
            Some(ratio) => verdict(
                Growth::Exponential { entropy: libm::log(ratio) },
                format!("the last ratio of {count} degrees is {ratio:.4}, and the ratios are steady"),
            ),
            None => verdict(
                Growth::Undecided,
                match count {
                    1 => "not one iterate was reached".to_owned(),
                    _ => format!("{count} degrees show no constant differences and no steady ratio"),
                },
            ),
        }
    }
}

fn steps(period: usize, difference: i128, what: &str) -> String {
    match (difference, period) {
        (0, _) => "no change".to_owned(),
        (_, 1) => format!("constant {what} {difference}"),
        _ => format!("constant {what} {difference} over {period} steps, a pattern of period {period},"),
    }
}

/// Replaces `values` by their differences vₙ₊ₖ − vₙ, `order` times. Returns the least k for which
/// the last differences are equal, their common value, and their number.
fn constant_differences(values: &[i128], order: usize) -> Option<(usize, i128, usize)> {
    (1..=values.len() / (order + 2)).find_map(|period| {
        let mut differences = values.to_vec();
        for _ in 0..order {
            differences = differences.iter().zip(&differences[period..]).map(|(a, b)| b - a).collect();
        }
        let last = *differences.last()?;
        let confirmed = differences.iter().rev().take_while(|&&difference| difference == last).count();
        let is_trend = last > 0 || (last == 0 && order == 1 && period == 1);
        (is_trend && confirmed >= 4.max(2 * period)).then_some((period, last, confirmed))
    })
}

fn exponential(values: &[i128]) -> Option<f64> {
    if values.len() < 5 {
        return None;
    }
    let ratios: Vec<f64> = values.windows(2).map(|pair| pair[1] as f64 / pair[0].max(1) as f64).collect();
    let end = ratios.len() - 1;
    let last = &ratios[end.saturating_sub(3)..];
    let steady = (ratios[end] / ratios[end.saturating_sub(2)] - 1.0).abs() <= CONSTANT_RATIO_TOLERANCE;
    let kept = ratios[end] - 1.0 >= 2.0 / 3.0 * (ratios[end / 2] - 1.0);
    (last.iter().all(|&ratio| ratio > 1.15) && steady && kept).then_some(ratios[end])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn growth(degrees: impl IntoIterator<Item = usize>) -> Growth {
        GrowthVerdict::of(&degrees.into_iter().collect::<Vec<_>>()).growth
    }

    #[test]
    fn classes_of_known_sequences() {
        assert_eq!(growth([1, 2, 3, 3, 3, 3, 3]), Growth::Bounded);
        assert_eq!(growth([1, 2, 4, 6, 8, 10, 12]), Growth::Linear);
        assert_eq!(growth((0..12).map(|n| 2 * n * n + 1)), Growth::Quadratic);
        let weierstrass = (0..40).map(|n| (3 * n * n + 8) / 8 + usize::from(n % 8 == 1));
        assert_eq!(growth(weierstrass), Growth::Quadratic);
        let Growth::Exponential { entropy } = growth((0..8).map(|n| 3usize.pow(n))) else { panic!() };
        assert!((entropy - 3f64.ln()).abs() < 1e-12);
        assert_eq!(growth([1, 2, 4]), Growth::Undecided);
        assert_eq!(growth((0..30).map(|n| n * n * n + 1)), Growth::Undecided);
        assert_eq!(growth((0..12).map(|n| n * n * n + 1)), Growth::Undecided);
    }
}
