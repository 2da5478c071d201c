//! Times several runners in alternation, so that a slowdown of the machine affects all of them.

use std::time::{Duration, Instant};

#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// The number of rounds. A round times every runner once.
    pub(crate) rounds: usize,
    pub(crate) sample: Duration,
}

impl Effort {
    pub(crate) fn new(quick: bool) -> Self {
        let rounds = if quick { 15 } else { 101 };
        Self { rounds, sample: Duration::from_micros(if quick { 200 } else { 500 }) }
    }

    /// Returns whether this is a short trial instead of a measurement.
    pub(crate) fn is_quick(self) -> bool {
        self.rounds < 100
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Quartiles {
    pub(crate) low: f64,
    pub(crate) median: f64,
    pub(crate) high: f64,
}

impl Quartiles {
    /// Returns the quartiles. Panics if there are no values.
    pub(crate) fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let at = |quarter: usize| values[(values.len() - 1) * quarter / 4];
        Self { low: at(1), median: at(2), high: at(3) }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Standing {
    /// The least nanoseconds per unit of work over all rounds.
    pub(crate) nanoseconds: f64,
    pub(crate) ratio: Quartiles,
}

pub(crate) fn seconds(run: impl FnOnce()) -> f64 {
    let begun = Instant::now();
    run();
    begun.elapsed().as_secs_f64()
}

/// Times `runners` alternately. `seconds(i, units)` runs `units` units of work of runner i, and
/// returns the seconds. Panics without a runner.
pub(crate) fn race(
    runners: usize,
    effort: Effort,
    mut seconds: impl FnMut(usize, usize) -> f64,
) -> Vec<Standing> {
    let units: Vec<usize> =
        (0..runners).map(|i| calibrate(effort.sample, |units| seconds(i, units))).collect();
    let mut times = vec![Vec::with_capacity(effort.rounds); runners];
    for round in 0..effort.rounds {
        for turn in 0..runners {
            let i = (round + turn) % runners;
            times[i].push(1e9 * seconds(i, units[i]) / units[i] as f64);
        }
    }
    let ratios = |of: &[f64]| of.iter().zip(&times[0]).map(|(time, base)| time / base).collect();
    times
        .iter()
        .map(|of| Standing {
            nanoseconds: of.iter().copied().fold(f64::INFINITY, f64::min),
            ratio: Quartiles::of(ratios(of)),
        })
        .collect()
}

const PASSES: usize = 3;

/// Returns the least nanoseconds per unit of work for several races. Race i has `runners[i]`
/// runners.
///
/// All races run several times, because a disturbance may last longer than one race. Fails with the
/// first error of `seconds`; panics if a race has no runner.
pub(crate) fn least_times<E>(
    runners: &[usize],
    effort: Effort,
    mut seconds: impl FnMut(usize, usize, usize) -> Result<f64, E>,
) -> Result<Vec<Vec<f64>>, E> {
    let mut least: Vec<Vec<f64>> = runners.iter().map(|&runners| vec![f64::INFINITY; runners]).collect();
    for pass in 0..PASSES * runners.len() {
        let number = pass % runners.len();
        let mut failure = None;
        let standings = race(runners[number], effort, |i, units| {
            seconds(number, i, units).unwrap_or_else(|error| {
                failure = Some(error);
                1.0
            })
        });
        if let Some(error) = failure {
            return Err(error);
        }
        for (least, standing) in least[number].iter_mut().zip(standings) {
            *least = least.min(standing.nanoseconds);
        }
    }
    Ok(least)
}

fn calibrate(sample: Duration, mut seconds: impl FnMut(usize) -> f64) -> usize {
    let mut units = 1;
    loop {
        // The least of three times is used, because an interruption makes a time too long.
        let taken = (0..3).map(|_| seconds(units)).fold(f64::INFINITY, f64::min);
        if taken > 0.1 * sample.as_secs_f64() {
            return ((units as f64 * sample.as_secs_f64() / taken) as usize).max(1);
        }
        units *= 4;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_of_an_odd_number_of_values_are_values() {
        let Quartiles { low, median, high } = Quartiles::of(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!((low, median, high), (2.0, 3.0, 4.0));
    }

    #[test]
    fn the_least_time_is_kept_for_each_runner_of_each_race() {
        let effort = Effort { rounds: 3, sample: Duration::from_micros(20) };
        // The simulated disturbance doubles the times of the first 19 calls.
        let mut calls = 0;
        let times = least_times(&[1, 2], effort, |race, i, units| {
            calls += 1;
            let busy = if calls < 20 { 2.0 } else { 1.0 };
            Ok::<_, ()>(busy * (1 + 2 * race + i) as f64 * units as f64 * 1e-6)
        })
        .unwrap();
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
        assert!(near(times[0][0], 1e3) && near(times[1][0], 3e3) && near(times[1][1], 4e3), "{times:?}");
    }

    #[test]
    fn a_failure_ends_a_race_of_least_times() {
        let effort = Effort { rounds: 3, sample: Duration::from_micros(20) };
        assert_eq!(least_times(&[1], effort, |_, _, _| Err::<f64, _>("gone")), Err("gone"));
    }

    #[test]
    fn every_runner_runs_in_every_round_and_the_first_is_its_own_measure() {
        let effort = Effort { rounds: 7, sample: Duration::from_micros(20) };
        let mut calls = [0, 0, 0];
        let results = race(3, effort, |i, units| {
            calls[i] += 1;
            (i + 1) as f64 * units as f64 * 1e-6
        });
        assert!(calls.iter().all(|&calls| calls > effort.rounds), "{calls:?}");
        assert_eq!((results[0].ratio.low, results[0].ratio.high), (1.0, 1.0));
        assert!((results[2].ratio.median - 3.0).abs() < 1e-12);
        assert!((results[1].nanoseconds - 2000.0).abs() < 1e-9);
    }
}
