//! A generated program makes steps with code that the macro expanded. The tests judge its results.
//!
//! The tests and the program exchange arguments and results of `try_step` as bits.

use kahan_algebra::family::Family;
use kahan_algebra::system::System;
use kahan_core::Dd;
use kahan_runtime::interpreted::LARGEST_DIMENSION;

use super::residual::{ByResidual, Rows};
use crate::equation::Equation;
use crate::float::Float;
use crate::judge::{self, ExactMap};
use crate::points::Inputs;
use crate::survey::TrialTarget;
use crate::tally::Tally;
use crate::trial::{Trials, with_special_inputs};

/// A scalar type whose values are exchanged as words, one `u64` for each float of the value.
pub(super) trait Words: Float {
    const WORDS: usize;

    fn words(self) -> Vec<u64>;

    fn of_words(words: &[u64]) -> Self;
}

impl Words for f32 {
    const WORDS: usize = 1;

    fn words(self) -> Vec<u64> {
        vec![self.to_bits().into()]
    }

    fn of_words(words: &[u64]) -> Self {
        Self::from_bits(words[0] as u32)
    }
}

impl Words for f64 {
    const WORDS: usize = 1;

    fn words(self) -> Vec<u64> {
        vec![self.to_bits()]
    }

    fn of_words(words: &[u64]) -> Self {
        Self::from_bits(words[0])
    }
}

impl Words for Dd {
    const WORDS: usize = 2;

    fn words(self) -> Vec<u64> {
        vec![self.high().to_bits(), self.low().to_bits()]
    }

    fn of_words(words: &[u64]) -> Self {
        Self::new(f64::from_bits(words[0]), f64::from_bits(words[1]))
    }
}

pub(super) struct Compiled(TrialTarget);

/// Returns the exact map of a field of any number of variables.
pub(crate) fn judge_of(system: &System) -> Box<dyn ExactMap> {
    if system.field.dimension() <= LARGEST_DIMENSION {
        return judge::of(system);
    }
    Box::new(ByResidual(Equation::of(system), Rows::Widest))
}

impl Compiled {
    pub(super) fn new(name: &str, system: &System) -> Self {
        Self::of(name, system, judge_of(system))
    }

    /// Prepares a chain of `sites` sites. Parameters of the whole chain come first. Each other
    /// parameter has one value for each site.
    pub(super) fn of_chain(name: &str, family: &Family, sites: usize) -> Self {
        let system = family.at_sites(sites).expect("no site divides by zero");
        Self::of(name, &system, Box::new(ByResidual(Equation::of(&system), Rows::Own)))
    }

    fn of(name: &str, system: &System, judge: Box<dyn ExactMap>) -> Self {
        let parameters = vec![None; system.field.symbols.parameters.len()];
        Self(TrialTarget { name: name.to_owned(), parameters, is_odd: true, judge })
    }

    pub(super) fn count(trials: u64) -> u64 {
        with_special_inputs(trials)
    }

    pub(super) fn inputs<T: Words>(&self, trials: u64, seed: u64) -> Vec<u64> {
        let all = Trials::<T>::new(vec![&self.0], trials, seed);
        let words = |index| {
            let Inputs { parameters, x, eps, .. } = all.inputs(index).1;
            parameters.into_iter().chain(x).chain([eps]).flat_map(Words::words)
        };
        (0..Self::count(trials)).flat_map(words).collect()
    }

    /// Takes the results of `trials` trials from the front of `results`, and tests them. A result
    /// consists of the number 1 and the bits of x̃. After an error it is the number 0.
    pub(super) fn judge<T: Words>(&self, trials: u64, seed: u64, results: &mut &[u64], tally: &mut Tally) {
        let all = Trials::<T>::new(vec![&self.0], trials, seed);
        for index in 0..Self::count(trials) {
            let size = results[0] as usize * self.0.judge.equation().dimension() * T::WORDS;
            let (next, rest) = results[1..].split_at(size);
            let next = (results[0] == 1).then(|| next.chunks(T::WORDS).map(T::of_words).collect());
            all.draw(index).count_stable(next, tally);
            *results = rest;
        }
    }
}
