//! Distributes the systems and trials of a survey over threads.

use std::sync::{Mutex, PoisonError};

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::Dd;
use kahan_core::num_rational::BigRational;
use kahan_runtime::interpreted::{LARGEST_DIMENSION, UnsupportedDimension};
use kahan_runtime::threads::for_each;
use kahan_runtime::{Field, FieldText, Map};
use kahan_study::WorkCount;
use kahan_study::trade::CannotRun;

use super::float::Float;
use super::judge::{self, ExactMap};
use super::random_fields::odd::odd;
use super::tally::Tally;
use super::trial::{PreparedTrials, with_special_inputs};

#[derive(Debug)]
pub(crate) struct TestedMap {
    pub(crate) target: TrialTarget,
    pub(crate) map: Map,
}

/// The parameters and the exact map of a system, used to draw points and to judge steps.
#[derive(Debug)]
pub(crate) struct TrialTarget {
    pub(crate) name: String,
    pub(crate) parameters: Vec<Option<Rational>>,
    /// Whether parameters are drawn from the whole range of floats.
    pub(crate) is_odd: bool,
    pub(crate) judge: Box<dyn ExactMap>,
}

impl TestedMap {
    /// Prepares a system under a name. A parameter without a given value is drawn for each trial.
    pub(crate) fn new(
        name: &str,
        system: &System,
        parameters: Vec<Option<Rational>>,
    ) -> Result<Self, CannotRun> {
        let variables = system.field.dimension();
        if variables > LARGEST_DIMENSION {
            return Err(CannotRun::Dimension(UnsupportedDimension(variables)));
        }
        let names = &system.field.symbols.parameters;
        let values = (1..).zip(&parameters).map(value_or_any);
        let map = Field::of(system).with(names.iter().zip(values)).map_err(CannotRun::Parameters)?;
        let judge = judge::of(system);
        Ok(Self { target: TrialTarget { name: name.to_owned(), parameters, is_odd: false, judge }, map })
    }

    /// Prepares a random field whose parameters are drawn for each trial.
    pub(crate) fn drawn(name: &str, block: String) -> Self {
        let system = FieldText::new(block, name.to_owned()).unproved_system();
        let system = system.expect("the generator writes fields that can be read");
        let parameters = vec![None; system.field.symbols.parameters.len()];
        Self::new(name, &system, parameters).expect("the generator writes fields that can be run")
    }

    /// Lets trials draw extreme parameters and points.
    pub(crate) fn of_odd_temper(mut self) -> Self {
        self.target.is_odd = true;
        self
    }
}

/// Returns the given value of parameter k, or a value at which denominators are probably not 0.
fn value_or_any((k, given): (i64, &Option<Rational>)) -> BigRational {
    match given {
        Some(value) => value.to_big(),
        None => BigRational::new((7 + 5 * k * k).into(), (3 + k).into()),
    }
}

/// Runs `trials` trials for each of `f32`, `f64` and `Dd`, cycling through the systems.
///
/// Equally many points are near poles, near removable poles, of mixed magnitudes, and ordinary.
/// Further trials have subnormal inputs, nonfinite inputs or large steps.
pub(crate) fn survey(tried: &[TestedMap], trials: u64, seed: u64, count: &WorkCount<'_>) -> Tally {
    on_threads(tried, trials, seed, count.threads(), count)
}

fn on_threads(tried: &[TestedMap], trials: u64, seed: u64, threads: usize, count: &WorkCount<'_>) -> Tally {
    let mut tally = Tally::default();
    tally.add(of_scalar(&PreparedTrials::<f32>::new(tried, trials, seed), threads, count));
    tally.add(of_scalar(&PreparedTrials::<f64>::new(tried, trials, seed), threads, count));
    tally.add(of_scalar(&PreparedTrials::<Dd>::new(tried, trials, seed), threads, count));
    tally
}

pub(crate) fn total(trials: u64) -> u64 {
    3 * with_special_inputs(trials)
}

/// Runs trials of `fields` random fields with extreme coefficients. Every twentieth field has ten
/// times as many trials.
pub(crate) fn survey_odd(fields: usize, trials: u64, seed: u64, count: &WorkCount<'_>) -> Tally {
    let all = Mutex::new(Tally::default());
    for_each(fields, Some(count.threads()), &|k| {
        if count.is_stopped() {
            return;
        }
        let field = odd(seed, k);
        let tried = [TestedMap::drawn(&field.name, field.block()).of_odd_temper()];
        let own = if k % 20 == 19 { 10 * trials } else { trials };
        // Each field draws from its own random stream.
        let seed = seed.wrapping_add((k as u64 + 1) << 32);
        let tally = on_threads(&tried, own, seed, 1, count);
        all.lock().unwrap_or_else(PoisonError::into_inner).add(tally);
    });
    all.into_inner().unwrap_or_else(PoisonError::into_inner)
}

pub(crate) fn total_of_odd(fields: usize, trials: u64) -> u64 {
    let more = (fields / 20) as u64;
    (fields as u64 - more) * total(trials) + more * total(10 * trials)
}

/// Runs all trials of one scalar type in blocks. An idle thread takes the next block.
fn of_scalar<T: Float>(ready: &PreparedTrials<'_, T>, threads: usize, count: &WorkCount<'_>) -> Tally {
    const TRIALS_PER_BLOCK: usize = 64;
    let trials = usize::try_from(ready.count()).expect("no more trials than a machine makes");
    let all = Mutex::new(Tally::default());
    for_each(trials.div_ceil(TRIALS_PER_BLOCK), Some(threads), &|block| {
        if count.is_stopped() {
            return;
        }
        let (start, mut tally) = (block * TRIALS_PER_BLOCK, Tally::default());
        let end = (start + TRIALS_PER_BLOCK).min(trials);
        (start..end).for_each(|index| ready.run(index as u64, &mut tally));
        count.add((end - start) as u64);
        // Trials run without the lock. If one panics, the tally stays valid.
        all.lock().unwrap_or_else(PoisonError::into_inner).add(tally);
    });
    all.into_inner().unwrap_or_else(PoisonError::into_inner)
}
