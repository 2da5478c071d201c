//! Trials whose steps are made elsewhere, by code that the macro wrote.
//!
//! In: a system of any number of variables, or a chain. Out: the bits of what `try_step` is to be
//! given, and a verdict on the bits that it returned. A program that makes the steps needs neither
//! the judge nor exact numbers.

use kahan_algebra::family::Family;
use kahan_algebra::system::System;
use kahan_core::Dd;

use super::Target;
use super::float::Float;
use super::judge::Judge;
use super::points::Inputs;
use super::tally::Tally;
use super::trial::{Trials, with_special_inputs};

/// A system whose steps are made elsewhere; all of its parameters are drawn.
#[derive(Debug)]
pub struct Compiled(Target);

/// The numbers that steps are made in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// `f32`, a word of 32 bits.
    F32,
    /// `f64`, a word.
    F64,
    /// The double-double, two words, the high part first.
    Dd,
}

impl Compiled {
    /// A system of any number of variables.
    #[must_use]
    pub fn new(name: &str, system: &System) -> Self {
        Self::of(name, system, Judge::of(system))
    }

    /// A chain of so many sites. Its parameters are those of the chain, and then those of sites,
    /// name by name.
    #[must_use]
    pub fn of_chain(name: &str, family: &Family, sites: usize) -> Self {
        let system = family.at_sites(sites);
        Self::of(name, &system, Judge::of_chain(&system))
    }

    fn of(name: &str, system: &System, judge: Judge) -> Self {
        let target = Target::new(name, vec![None; system.field.symbols.parameters.len()], judge);
        Self(Target { is_odd: true, ..target })
    }

    /// The number of trials, those with special inputs included.
    #[must_use]
    pub fn count(trials: u64) -> u64 {
        with_special_inputs(trials)
    }

    /// The words of one trial: parameters, states, ε.
    #[must_use]
    pub fn inputs(&self, number: Number, trials: u64, seed: u64, index: u64) -> Vec<u64> {
        match number {
            Number::F32 => self.inputs_of::<f32>(trials, seed, index),
            Number::F64 => self.inputs_of::<f64>(trials, seed, index),
            Number::Dd => self.inputs_of::<Dd>(trials, seed, index),
        }
    }

    fn inputs_of<T: Float>(&self, trials: u64, seed: u64, index: u64) -> Vec<u64> {
        let (_, inputs) = Trials::<T>::new(vec![&self.0], trials, seed).inputs(index);
        let Inputs { parameters, x, eps, .. } = inputs;
        parameters.into_iter().chain(x).chain([eps]).flat_map(Float::bits).collect()
    }

    /// Judges the words of x̃ of one trial, or that `try_step` returned an error.
    pub fn judge(
        &self,
        number: Number,
        trials: u64,
        seed: u64,
        index: u64,
        next: Option<&[u64]>,
        tally: &mut Tally,
    ) {
        match number {
            Number::F32 => self.judge_of::<f32>(trials, seed, index, next, tally),
            Number::F64 => self.judge_of::<f64>(trials, seed, index, next, tally),
            Number::Dd => self.judge_of::<Dd>(trials, seed, index, next, tally),
        }
    }

    fn judge_of<T: Float>(
        &self,
        trials: u64,
        seed: u64,
        index: u64,
        next: Option<&[u64]>,
        tally: &mut Tally,
    ) {
        let next = next.map(|words| words.chunks(T::WORDS).map(T::of_bits).collect());
        Trials::<T>::new(vec![&self.0], trials, seed).draw(index).count_stable(next, tally);
    }
}
