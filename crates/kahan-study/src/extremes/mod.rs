//! Steps at the extremes, judged by exact arithmetic.
//!
//! In: systems, a number of trials, a seed. Out: for every regime, tier and scalar how large the
//! errors are, how many trials are flagged, and how many are silently wrong. The judge knows the
//! reduced map as polynomials and takes the floats as they are given, so no tolerance is between a
//! step and its verdict. What a trial draws depends on the seed and its index only: the result is
//! the same for every number of threads.

mod ball;
mod compiled;
mod dyadic;
mod elimination;
mod equation;
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
use kahan_runtime::interpreted::{LARGEST_DIMENSION, UnsupportedDimension};
use kahan_runtime::threads::for_each;
use kahan_runtime::{Field, Map};

use kahan_systems::entry::Entry;
use kahan_systems::registry::SYSTEMS;
use kahan_systems::volterra;

use judge::Judge;
use trial::Ready;

pub use crate::map::CannotRun;
pub use compiled::{Compiled, Number};
pub use regime::Regime;
pub use tally::{Broken, Cell, Failure, Place, Tally};

/// A system whose steps are judged.
#[derive(Debug)]
pub struct Subject {
    target: Target,
    map: Map,
}

/// A system as points are drawn for it and results are judged.
#[derive(Debug)]
struct Target {
    name: String,
    /// The values of parameters that are given; the others are drawn.
    parameters: Vec<Option<Rational>>,
    /// Whether they are drawn from the whole range.
    is_odd: bool,
    judge: Judge,
}

/// What is judged where no system is named: the paper's systems, and the lattice of three sites,
/// whose det A cancels in long steps.
pub fn standard() -> impl Iterator<Item = &'static Entry> {
    SYSTEMS.iter().chain([&volterra::ENTRY])
}

impl Subject {
    /// A system under a name, with a value or none for each parameter.
    ///
    /// # Errors
    /// Where the map has too many variables to be run, or divides by zero at the given parameters.
    pub fn new(name: &str, system: &System, parameters: Vec<Option<Rational>>) -> Result<Self, CannotRun> {
        let variables = system.field.dimension();
        if variables > LARGEST_DIMENSION {
            return Err(CannotRun::Dimension(UnsupportedDimension(variables)));
        }
        let names = &system.field.symbols.parameters;
        let values = (1..).zip(&parameters).map(value_or_any);
        let map = Field::of(system).with(names.iter().zip(values)).map_err(CannotRun::Parameters)?;
        Ok(Self { target: Target::new(name, parameters, Judge::of(system)), map })
    }

    /// The same, its parameters drawn from the whole range, and its ε, for many points, so that
    /// ‖εf′‖∞ is of ordinary size.
    #[must_use]
    pub fn of_odd_temper(mut self) -> Self {
        self.target.is_odd = true;
        self
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.target.name
    }

    /// Whether det A vanishes somewhere that the reduced map has a value.
    #[must_use]
    pub fn has_removable_poles(&self) -> bool {
        self.target.judge.has_removable_poles()
    }
}

impl Target {
    fn new(name: &str, parameters: Vec<Option<Rational>>, judge: Judge) -> Self {
        Self { name: name.to_owned(), parameters, is_odd: false, judge }
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

/// So many trials of `f32`, `f64` and `Dd` of each of `count` subjects alone, with ten times as
/// many of every twentieth; the k-th is made when it is its turn.
///
/// `threads` and `progress` as for [`survey`].
pub fn survey_each(
    count: usize,
    subject: &(dyn Fn(usize) -> Subject + Sync),
    trials: u64,
    seed: u64,
    threads: Option<usize>,
    progress: &(dyn Fn(u64) + Sync),
) -> Tally {
    let all = Mutex::new(Tally::default());
    for_each(count, threads, &|k| {
        let subject = [subject(k)];
        let own = if k % 20 == 19 { 10 * trials } else { trials };
        // Streams of fields have nothing in common.
        let seed = seed.wrapping_add((k as u64 + 1) << 32);
        let tally = survey(&subject, own, seed, Some(1), progress);
        all.lock().unwrap_or_else(PoisonError::into_inner).add(tally);
    });
    all.into_inner().unwrap_or_else(PoisonError::into_inner)
}

/// The number of trials that [`survey_each`] makes in all.
#[must_use]
pub fn total_of_each(count: usize, trials: u64) -> u64 {
    let more = (count / 20) as u64;
    (count as u64 - more) * total(trials) + more * total(10 * trials)
}

/// All trials of one scalar, in blocks that threads take as they come free.
fn of_scalar<T: float::Float>(
    ready: &Ready<'_, T>,
    threads: Option<usize>,
    progress: &(dyn Fn(u64) + Sync),
) -> Tally {
    const BLOCK: usize = 64;
    let trials = usize::try_from(ready.count()).expect("no more trials than a machine makes");
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
