//! Trials of many systems: who is tried, how often, and on how many threads.

use std::sync::{Mutex, PoisonError};

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::Dd;
use kahan_core::num_rational::BigRational;
use kahan_runtime::interpreted::{LARGEST_DIMENSION, UnsupportedDimension};
use kahan_runtime::threads::for_each;
use kahan_runtime::{Field, FieldText, Map};
use kahan_study::Count;
use kahan_study::trade::CannotRun;

use super::float::Float;
use super::judge::{self, Judge};
use super::random_fields::odd::odd;
use super::tally::Tally;
use super::trial::{Ready, with_special_inputs};

/// A system whose steps are judged.
#[derive(Debug)]
pub(crate) struct Tried {
    pub(crate) target: Target,
    pub(crate) map: Map,
}

/// A system as points are drawn for it and results are judged.
#[derive(Debug)]
pub(crate) struct Target {
    pub(crate) name: String,
    /// The values of parameters that are given; the others are drawn.
    pub(crate) parameters: Vec<Option<Rational>>,
    /// Whether they are drawn from the whole range.
    pub(crate) is_odd: bool,
    pub(crate) judge: Box<dyn Judge>,
}

impl Tried {
    /// A system under a name, with a value or none for each parameter.
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
        Ok(Self { target: Target { name: name.to_owned(), parameters, is_odd: false, judge }, map })
    }

    /// A field that was drawn, all of its parameters to be drawn for each trial.
    pub(crate) fn drawn(name: &str, block: String) -> Self {
        let system = FieldText::new(block, name.to_owned()).unproved_system();
        let system = system.expect("the generator writes fields that can be read");
        let parameters = vec![None; system.field.symbols.parameters.len()];
        Self::new(name, &system, parameters).expect("the generator writes fields that can be run")
    }

    /// The same, its parameters drawn from the whole range, and its ε, for many points, so that
    /// ‖εf′‖∞ is of ordinary size.
    pub(crate) fn of_odd_temper(mut self) -> Self {
        self.target.is_odd = true;
        self
    }
}

/// The value that is given, or for the k-th parameter a number that no field is likely to divide by
/// its difference from.
fn value_or_any((k, given): (i64, &Option<Rational>)) -> BigRational {
    match given {
        Some(value) => value.to_big(),
        None => BigRational::new((7 + 5 * k * k).into(), (3 + k).into()),
    }
}

/// `trials` trials of `f32`, `f64` and `Dd` each, a quarter each near poles, near removable poles,
/// of mixed magnitudes and ordinary, and a thirty-second part (at least eight) with subnormal
/// inputs, as many with inputs that are not finite, and as many large steps, for which elimination
/// is judged besides, over all systems in turn, of which there is at least one. Where none of them
/// has a removable pole, that quarter goes to the poles.
pub(crate) fn survey(tried: &[Tried], trials: u64, seed: u64, count: &Count<'_>) -> Tally {
    on_threads(tried, trials, seed, count.threads(), count)
}

fn on_threads(tried: &[Tried], trials: u64, seed: u64, threads: usize, count: &Count<'_>) -> Tally {
    let mut tally = Tally::default();
    tally.add(of_scalar(&Ready::<f32>::new(tried, trials, seed), threads, count));
    tally.add(of_scalar(&Ready::<f64>::new(tried, trials, seed), threads, count));
    tally.add(of_scalar(&Ready::<Dd>::new(tried, trials, seed), threads, count));
    tally
}

/// The number of trials that [`survey`] makes in all.
pub(crate) fn total(trials: u64) -> u64 {
    3 * with_special_inputs(trials)
}

/// So many trials of `f32`, `f64` and `Dd` of each of `fields` fields of odd tempers alone, with
/// ten times as many of every twentieth; each is drawn when it is its turn.
pub(crate) fn survey_odd(fields: usize, trials: u64, seed: u64, count: &Count<'_>) -> Tally {
    let all = Mutex::new(Tally::default());
    for_each(fields, Some(count.threads()), &|k| {
        if count.is_stopped() {
            return;
        }
        let field = odd(seed, k);
        let tried = [Tried::drawn(&field.name, field.block()).of_odd_temper()];
        let own = if k % 20 == 19 { 10 * trials } else { trials };
        // Streams of fields have nothing in common.
        let seed = seed.wrapping_add((k as u64 + 1) << 32);
        let tally = on_threads(&tried, own, seed, 1, count);
        all.lock().unwrap_or_else(PoisonError::into_inner).add(tally);
    });
    all.into_inner().unwrap_or_else(PoisonError::into_inner)
}

/// The number of trials that [`survey_odd`] makes in all.
pub(crate) fn total_of_odd(fields: usize, trials: u64) -> u64 {
    let more = (fields / 20) as u64;
    (fields as u64 - more) * total(trials) + more * total(10 * trials)
}

/// All trials of one scalar, in blocks that threads take as they come free.
fn of_scalar<T: Float>(ready: &Ready<'_, T>, threads: usize, count: &Count<'_>) -> Tally {
    const BLOCK: usize = 64;
    let trials = usize::try_from(ready.count()).expect("no more trials than a machine makes");
    let all = Mutex::new(Tally::default());
    for_each(trials.div_ceil(BLOCK), Some(threads), &|block| {
        if count.is_stopped() {
            return;
        }
        let (start, mut tally) = (block * BLOCK, Tally::default());
        let end = (start + BLOCK).min(trials);
        (start..end).for_each(|index| ready.run(index as u64, &mut tally));
        count.add((end - start) as u64);
        // A thread that panics does so outside of the lock; what is in it is whole.
        all.lock().unwrap_or_else(PoisonError::into_inner).add(tally);
    });
    all.into_inner().unwrap_or_else(PoisonError::into_inner)
}
