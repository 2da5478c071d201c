//! The law of an order's error on a scene: how far from the flow so many steps end up.
//!
//! In: a map, a first point, a composition. Out: measured errors on a ladder of steps, each rung twice as fine, and beyond the last
//! rung the law error ∝ steps⁻ᵖ. An error is the sum of the differences between neighbouring rungs from there on (Richardson), each the largest over the common
//! times, relative to the largest coordinate. A ladder ends once two rungs differ by 2ᵖ as they must, so it stays coarse.

use nalgebra::SVector;

use crate::{Composition, Lift};

use super::gap::{gap, norm};

/// The time that pilots cover, and what errors do beyond it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    /// At most the horizon.
    pub(super) time: f64,
    /// The horizon over that time.
    pub(super) beyond: f64,
    /// The steps of the first rung.
    first: u64,
}

/// Measured errors, the coarsest first, and what follows from them.
#[derive(Clone, Debug)]
pub(super) struct Ladder {
    pub(super) composition: Composition,
    first: u64,
    errors: [f64; RUNGS],
    len: usize,
    /// How many more steps are taken than the law says, because a trial contradicted it.
    pub(super) stretch: f64,
    /// The power of time with which the last rung's error grew over the second half.
    pub(super) power: f64,
}

const RUNGS: usize = 20;
/// The most steps of the map in one pilot orbit.
const MOST_STAGES: u64 = 1 << 17;
/// Two rungs have the order's ratio where its logarithm is within this part of what it must be, twice running,
const SLOPE: f64 = 0.15;
/// at an error that is below this.
const SMALL: f64 = 0.003;
/// Below, `f64` pilots differ by roundings.
const ROUNDINGS: f64 = 1e-12;

impl Span {
    /// First steps with ε‖f′‖ = 8 or less; a horizon that takes more than 16 of them is not run to its end.
    pub(super) fn of<M, const N: usize>(map: &M, x0: &SVector<f64, N>, horizon: f64) -> Self
    where
        M: Lift<f64, N>,
    {
        const LARGEST: f64 = 8.0;
        const MOST: f64 = 16.0;
        let steps = (0.5 * horizon * rate(map, x0) / LARGEST).ceil();
        if steps > MOST {
            let beyond = steps / MOST;
            Self { time: horizon / beyond, beyond, first: MOST as u64 }
        } else {
            Self { time: horizon, beyond: 1.0, first: steps.max(1.0) as u64 }
        }
    }
}

/// How fast the motion turns at the start: the larger of ‖f′‖∞ and ‖f‖∞/‖x‖∞.
pub(super) fn rate<M, const N: usize>(map: &M, x: &SVector<f64, N>) -> f64
where
    M: Lift<f64, N>,
{
    let slopes = map.field_jacobian(x);
    let sums = slopes.row_iter().map(|row| row.iter().map(|entry| entry.abs()).sum::<f64>());
    let slope = sums.fold(0.0, f64::max);
    let (speed, size) = (norm(&map.field(x)), norm(x));
    let rate = if size > 0.0 { slope.max(speed / size) } else { slope };
    if rate.is_finite() { rate } else { 0.0 }
}

impl Ladder {
    /// The ladder, or the time until which its last two rungs agreed, if they never came to differ as they must.
    pub(super) fn climb<M, const N: usize>(
        map: &M,
        x0: &SVector<f64, N>,
        composition: Composition,
        span: Span,
    ) -> Result<Self, f64>
    where
        M: Lift<f64, N>,
    {
        let order = f64::from(composition.order());
        let mut ladder = Self {
            composition,
            first: span.first,
            errors: [f64::INFINITY; RUNGS],
            len: 0,
            stretch: 1.0,
            power: 0.0,
        };
        let (mut agreed, mut settled) = (0.0, 0);
        while ladder.len < RUNGS {
            let steps = span.first << ladder.len;
            if 2 * steps * composition.stages() as u64 > MOST_STAGES {
                break;
            }
            let gap = gap(map, x0, composition, span.time, steps);
            let error = gap.error;
            agreed = gap.agreed;
            let before = if ladder.len > 0 { ladder.errors[ladder.len - 1] } else { f64::INFINITY };
            ladder.errors[ladder.len] = error;
            ladder.len += 1;
            ladder.power = if gap.half > 0.0 { (gap.error / gap.half).log2() } else { 0.0 };
            let falls = ((before / error).log2() / order - 1.0).abs() <= SLOPE;
            settled = if falls { settled + 1 } else { 0 };
            let is_rounding = error < ROUNDINGS;
            if gap.is_resolved && (is_rounding || (error < SMALL && settled >= 2)) {
                if is_rounding && before.is_finite() {
                    // The law knows better.
                    ladder.errors[ladder.len - 1] = error.max(before * 0.5_f64.powf(order)).min(ROUNDINGS);
                }
                ladder.sum_up();
                return Ok(ladder);
            }
        }
        Err(agreed * span.time)
    }

    /// From differences to distances from the flow: the way there leads over every finer rung, and beyond the last one over a geometric
    /// series.
    fn sum_up(&mut self) {
        let last = self.len - 1;
        self.errors[last] /= 1.0 - 0.5_f64.powi(self.composition.order() as i32);
        for rung in (0..last).rev() {
            self.errors[rung] += self.errors[rung + 1];
        }
    }

    /// The least number of steps over the pilots' time whose error is at most `error`; infinite for 0.
    pub(super) fn steps(&self, error: f64) -> f64 {
        self.stretch * self.steps_by_law(error)
    }

    fn steps_by_law(&self, error: f64) -> f64 {
        let order = f64::from(self.composition.order());
        let rungs = &self.errors[..self.len];
        // From this rung on, all do.
        let failing = rungs.iter().rposition(|measured| *measured > error);
        let steps = |rung: usize| (self.first << rung) as f64;
        match failing {
            None => steps(0),
            Some(last) if last + 1 == self.len => {
                steps(last) * (rungs[last].max(ROUNDINGS) / error).powf(1.0 / order)
            }
            // Between two rungs, by the power law through both.
            Some(rung) => {
                let (above, below) = (rungs[rung], rungs[rung + 1].max(f64::MIN_POSITIVE));
                let part = (above / error).ln() / (above / below).ln();
                if above.is_finite() { steps(rung) * part.exp2() } else { steps(rung + 1) }
            }
        }
    }

    /// The error of so many steps over the pilots' time: the inverse of [`steps`](Self::steps).
    pub(super) fn error(&self, steps: f64) -> f64 {
        let order = f64::from(self.composition.order());
        let last = self.len - 1;
        let place = (steps / self.stretch / self.first as f64).log2();
        if place >= last as f64 {
            return self.errors[last] * (0.5_f64).powf(order * (place - last as f64));
        }
        if place < 0.0 {
            return f64::INFINITY;
        }
        let rung = place as usize;
        let (above, below) = (self.errors[rung], self.errors[rung + 1].max(f64::MIN_POSITIVE));
        if above.is_finite() { above * (below / above).powf(place - rung as f64) } else { f64::INFINITY }
    }

    /// The error of so many steps over this time, by a trial; `None` where that takes too long, or roundings cover it.
    pub(super) fn trial<M, const N: usize>(
        &self,
        map: &M,
        x0: &SVector<f64, N>,
        time: f64,
        steps: u64,
    ) -> Option<f64>
    where
        M: Lift<f64, N>,
    {
        if steps.saturating_mul(2 * self.composition.stages() as u64) > MOST_STAGES {
            return None;
        }
        let gap = gap(map, x0, self.composition, time, steps);
        let error = gap.error / (1.0 - 0.5_f64.powi(self.composition.order() as i32));
        (error > ROUNDINGS).then_some(error)
    }

    /// The steps of the map that the finest rung took.
    pub(super) fn stages(&self) -> u64 {
        self.finest() * self.composition.stages() as u64
    }

    /// The steps of the finest rung that was compared, over the pilots' time.
    pub(super) fn finest(&self) -> u64 {
        self.first << (self.len - 1)
    }
}
