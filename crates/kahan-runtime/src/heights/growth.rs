//! Classifies the growth of a sequence of heights, by differences of means, least-squares lines, or
//! for short sequences by ratios.

use std::fmt;

/// The class of the growth of heights with the number of steps n.
///
/// # Rule
///
/// Let h₁ … h_N be the heights of the component that rises most.
///
/// The class is *bounded* if N ≥ 4 and the greatest height occurs in the first half.
///
/// For 4 ≤ N < 8, the class is *exponential* if it is not bounded, and if the last three ratios
/// h_n/h_{n−1} are at least 1.5 and differ by at most 5 %.
///
/// For N ≥ 8, the last 4⌊N/4⌋ heights are divided into four groups of equal length. Let d₁, d₂, d₃
/// be the first differences of the groups' means, and s₁, s₂ the second differences. If all dₖ are
/// positive, the first row whose condition holds gives the class; r and r′ are the sums of squared
/// residuals of the least-squares lines in n and in log n.
///
/// | class | condition |
/// |---|---|
/// | linear | 0.87 ≤ d₃/d₂ ≤ 1.15, r ≤ r′/2 |
/// | logarithmic | 0.87 ≤ d₃/d₂ ≤ 1.15, r′ ≤ r/2 |
/// | logarithmic | d₃/d₂ < 0.75, d₂/d₁ < 0.75, N ≥ 16 |
/// | quadratic | d₃/d₂ > 1.15, 0.7 ≤ s₂/s₁ ≤ 1.3 |
/// | exponential | d₃/d₂ ≥ 1.5, d₃/d₂ ≥ 0.9 d₂/d₁, s₂/s₁ ≥ 0.9 d₃/d₂ |
///
/// In all other cases the class is *undecided*.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// The heights h_n are bounded, so the orbit has only finitely many points.
    Bounded,
    /// h_n ~ log n.
    Logarithmic,
    /// h_n ~ n.
    Linear,
    /// h_n ~ n².
    Quadratic,
    /// log h_n ~ n. The entropy is positive, and the map is not integrable.
    Exponential,
    /// Undecided: too few steps, or no other class fits.
    Undecided,
}

impl Growth {
    /// Returns the class of h₁, h₂, … by the [rule](Growth); h₀ is not used.
    #[must_use]
    pub fn of(heights: &[f64]) -> Self {
        let n = heights.len();
        if n < 4 {
            return Growth::Undecided;
        }
        let (first, second) = heights.split_at(n / 2);
        if greatest(second) <= greatest(first) {
            return Growth::Bounded;
        }
        if n < 8 { Self::of_few(heights) } else { Self::of_quarters(heights) }
    }

    /// Returns `Linear` or `Logarithmic` if the least-squares line in n or in log n has at most
    /// half the residual of the other line, and otherwise `Undecided`.
    fn of_lines(heights: &[f64]) -> Self {
        let (linear, logarithmic) = (residual(heights, |n| n), residual(heights, libm::log));
        if 2.0 * linear <= logarithmic {
            Growth::Linear
        } else if 2.0 * logarithmic <= linear {
            Growth::Logarithmic
        } else {
            Growth::Undecided
        }
    }

    fn of_few(heights: &[f64]) -> Self {
        let ratios: Vec<f64> = heights.windows(2).rev().take(3).map(|pair| pair[1] / pair[0]).collect();
        let (low, high) = (ratios.iter().copied().fold(f64::INFINITY, f64::min), greatest(&ratios));
        if low >= 1.5 && high <= 1.05 * low { Growth::Exponential } else { Growth::Undecided }
    }

    fn of_quarters(heights: &[f64]) -> Self {
        let width = heights.len() / 4;
        let last = &heights[heights.len() - 4 * width..];
        let means: Vec<f64> = last.chunks(width).map(|q| q.iter().sum::<f64>() / width as f64).collect();
        let differences =
            |values: &[f64]| values.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<_>>();
        let first = differences(&means);
        let second = differences(&first);
        if first.iter().any(|d| *d <= 0.0) {
            return Growth::Undecided;
        }
        let (before, ratio) = (first[1] / first[0], first[2] / first[1]);
        let curvature = second[1] / second[0];
        match ratio {
            r if (0.87..=1.15).contains(&r) => Self::of_lines(heights),
            r if r < 0.75 && before < 0.75 && heights.len() >= 16 => Growth::Logarithmic,
            r if r > 1.15 && (0.7..=1.3).contains(&curvature) => Growth::Quadratic,
            r if r >= 1.5 && r >= 0.9 * before && curvature >= 0.9 * r => Growth::Exponential,
            _ => Growth::Undecided,
        }
    }
}

/// Returns the sum of squared residuals of the least squares line through (x(n), h_n), n = 1, 2, ….
fn residual(heights: &[f64], x: impl Fn(f64) -> f64) -> f64 {
    let points: Vec<(f64, f64)> = (1..).zip(heights).map(|(n, &h)| (x(f64::from(n)), h)).collect();
    let count = points.len() as f64;
    let (sum_x, sum_h) = points.iter().fold((0.0, 0.0), |(a, b), (x, h)| (a + x, b + h));
    let (mean_x, mean_h) = (sum_x / count, sum_h / count);
    let product =
        |f: fn(f64, f64) -> f64| -> f64 { points.iter().map(|(x, h)| f(x - mean_x, h - mean_h)).sum() };
    let slope = product(|x, h| x * h) / product(|x, _| x * x);
    points.iter().map(|(x, h)| (h - mean_h - slope * (x - mean_x)).powi(2)).sum()
}

fn greatest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

impl fmt::Display for Growth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Growth::Bounded => "bounded",
            Growth::Logarithmic => "logarithmic",
            Growth::Linear => "linear",
            Growth::Quadratic => "quadratic",
            Growth::Exponential => "exponential",
            Growth::Undecided => "undecided",
        })
    }
}
