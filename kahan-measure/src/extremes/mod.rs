//! Steps at the extremes, judged by exact arithmetic.
//!
//! In: systems, a number of trials, a seed. Out: for every regime, tier and scalar how large the
//! errors are, how many trials are flagged, and how many are silently wrong. The judge knows the
//! reduced map as polynomials and takes the floats as they are given, so no tolerance is between a
//! step and its verdict. What a trial draws depends on the seed and its index only: the result is
//! the same for every number of threads.

mod dyadic;
mod float;
mod judge;
mod points;
mod polynomial;
mod regime;
mod roots;
mod steps;
mod tally;
mod trial;

use std::sync::{Mutex, PoisonError};

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::Dd;
use kahan_core::num_rational::BigRational;
use kahan_runtime::threads::for_each;

use kahan_systems::entry::Entry;
use kahan_systems::registry::SYSTEMS;
use kahan_systems::volterra;

use crate::map::{Map, read};

use judge::Judge;
use trial::Ready;

pub use crate::map::CannotRun;
pub use regime::Regime;
pub use tally::{Cell, Failure, Place, Tally};

/// A system whose steps are judged.
#[derive(Debug)]
pub struct Subject {
    name: String,
    /// The values of parameters that are given; the others are drawn.
    parameters: Vec<Option<Rational>>,
    judge: Judge,
    map: Map,
}

/// What is judged where no system is named: the paper's systems, and the lattice of three sites,
/// whose det A cancels in long steps.
pub fn standard() -> impl Iterator<Item = &'static Entry> {
    SYSTEMS.iter().chain([&volterra::ENTRY])
}

/// Why the steps of a system cannot be judged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unjudged {
    /// It cannot be run.
    CannotRun(CannotRun),
    /// Its closed form is beyond the budget of terms, so no exact map to compare with.
    BeyondBudget,
}

impl Subject {
    /// A system under a name, with a value or none for each parameter.
    ///
    /// # Errors
    /// Where the map is too large to be reduced or to be run, or divides by zero at the given
    /// parameters.
    pub fn new(name: &str, system: &System, parameters: Vec<Option<Rational>>) -> Result<Self, Unjudged> {
        let judge = Judge::of(system).ok_or(Unjudged::BeyondBudget)?;
        let values: Vec<BigRational> = (1..).zip(&parameters).map(value_or_any).collect();
        let (_, map) = read(system, &values).map_err(Unjudged::CannotRun)?;
        Ok(Self { name: name.to_owned(), parameters, judge, map })
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether det A vanishes somewhere that the reduced map has a value.
    #[must_use]
    pub fn has_removable_poles(&self) -> bool {
        !self.judge.removable_poles.is_empty()
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
/// is judged besides, over all subjects in turn. Where none of them has a removable pole, that
/// quarter goes to the poles.
///
/// `threads` is the number of threads, by default as many as the machine runs at once; `progress`
/// is told how many trials were made since it was last called, from any of them.
///
/// # Panics
/// Without a subject.
#[must_use]
pub fn survey(
    subjects: &[Subject],
    trials: u64,
    seed: u64,
    threads: Option<usize>,
    progress: &(dyn Fn(u64) + Sync),
) -> Tally {
    assert!(!subjects.is_empty(), "a survey has at least one subject");
    let mut tally = Tally::default();
    tally.add(of_scalar(&Ready::<f32>::new(subjects, trials, seed), threads, progress));
    tally.add(of_scalar(&Ready::<f64>::new(subjects, trials, seed), threads, progress));
    tally.add(of_scalar(&Ready::<Dd>::new(subjects, trials, seed), threads, progress));
    tally
}

/// The number of trials that [`survey`] makes in all.
#[must_use]
pub fn total(trials: u64) -> u64 {
    3 * trial::with_special_inputs(trials)
}

/// All trials of one scalar, in blocks that threads take as they come free.
fn of_scalar<T: float::Float>(
    ready: &Ready<'_, T>,
    threads: Option<usize>,
    progress: &(dyn Fn(u64) + Sync),
) -> Tally {
    const BLOCK: usize = 64;
    let trials = usize::try_from(ready.trials()).unwrap_or(usize::MAX);
    let all = Mutex::new(Tally::default());
    for_each(trials.div_ceil(BLOCK), threads, &|block| {
        let (start, mut tally) = (block * BLOCK, Tally::default());
        let end = (start + BLOCK).min(trials);
        (start..end).for_each(|index| ready.run(index as u64, &mut tally));
        progress((end - start) as u64);
        // A thread that panics does so outside of the lock; what is in it is whole.
        all.lock().unwrap_or_else(PoisonError::into_inner).add(tally);
    });
    all.into_inner().unwrap_or_else(PoisonError::into_inner)
}
