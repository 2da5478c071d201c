//! The mean exponential growth factor of nearby orbits.

use super::TangentMap;
use super::carried::{Carried, Indicator, IndicatorObserver};
use super::growth::Size;

/// An observer of MEGNO, the mean exponential growth factor of nearby orbits. With the tangent
/// vector vₖ after k steps,
///
/// Y(n) = (2/n)·Σ k·log(|vₖ|/|vₖ₋₁|), k = 1, …, n.
///
/// The report holds Y(n) and the mean of Y(1), …, Y(n). The mean tends to 2 for quasi-periodic
/// motion, and to 0 if tangent vectors stay bounded. For chaotic motion the mean grows like λt/2,
/// where t = 2εn is the time and λ is the largest Lyapunov exponent. P. M. Cincotta, C. M.
/// Giordano, C. Simó, Physica D 182 (2003) 151.
///
/// `Megno::new(&map)` takes a [`TangentMap`]. A step costs a tangent vector and a logarithm.
pub type Megno<M> = IndicatorObserver<MeanGrowth, M, 1>;

/// The partial sums of MEGNO.
#[derive(Clone, Debug, Default)]
pub struct MeanGrowth {
    first: f64,
    /// The sum of log(|vₖ|/|v₀|) over the tangent vectors vₖ after k = 0, …, n − 1 of n steps.
    before: f64,
    last: f64,
    sum: f64,
    steps: u64,
}

/// The report of [`Megno`], NaN without a step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Megnos {
    /// The mean of Y(1), …, Y(n) over all n steps; see [`Megno`].
    pub mean: f64,
    /// The value Y(n) at the last step n; see [`Megno`].
    pub last: f64,
}

impl MeanGrowth {
    /// Returns Y(n) = 2·(log |vₙ| − (log |v₀| + … + log |vₙ₋₁|)/n), where |v₀| = 1.
    fn value(&self) -> f64 {
        2.0 * (self.last - self.before / self.steps as f64)
    }
}

impl Indicator<1> for MeanGrowth {
    type Report = Megnos;

    const LOOKS_AT_EACH: bool = true;

    fn new(_first: [Size; 1]) -> Self {
        Self::default()
    }

    fn read_lengths(&mut self, step: u64, [size]: [Size; 1]) {
        let ln = 0.5 * size.ln();
        if step == 0 {
            self.first = ln;
            return;
        }
        self.steps = step;
        self.before += self.last;
        self.last = ln - self.first;
        self.sum += self.value();
    }

    fn report<M: TangentMap>(self, _carried: Carried<M, 1>) -> Megnos {
        Megnos { mean: self.sum / self.steps as f64, last: self.value() }
    }
}
