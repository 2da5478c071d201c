//! The prepared step of an interpreted system.

use core::array::from_fn;
use kahan_core::nalgebra::SVector;
use kahan_core::{Elimination, PreparedStep, Quotients, Scalar, WideStep};
use std::sync::Arc;

use super::Interpreted;
use super::code::StepCode;
use super::program::{Inputs, Registers};

/// The step of an [`Interpreted`] system at one ε: its constants, and the kernel they belong to.
///
/// Its `COST` is that of elimination, since a type cannot know what was read at run time:
/// [`Interpreted::cost`] knows.
#[derive(Clone, Debug)]
pub struct InterpretedStep<T, const N: usize> {
    map: Interpreted<T, N>,
    eps: T,
    /// What the kernel's registers hold whatever the state.
    kept: Arc<[T]>,
}

impl<T: Scalar, const N: usize> InterpretedStep<T, N> {
    /// Runs what depends on ε and the parameters alone.
    ///
    /// # Panics
    /// Where the parameters make the field divide by zero, for exact scalars.
    pub(super) fn new(map: Interpreted<T, N>, eps: T) -> Self {
        let keep = |step: &StepCode| {
            let StepCode { constants, kernel, .. } = step.at(&eps);
            let inputs = Inputs { parameters: &map.parameters, eps: Some(&eps), ..Inputs::default() };
            let mut registers = Registers::new();
            let prepared: Vec<T> = constants.values(&inputs, &mut registers).iter().collect();
            kernel.keep(&Inputs { prepared: &prepared, ..Inputs::default() })
        };
        let kept = map.code.step.as_ref().map_or_else(|| Arc::new([]) as Arc<[T]>, keep);
        InterpretedStep { map, eps, kept }
    }
}

impl<T: Scalar, const N: usize> PreparedStep<T, N> for InterpretedStep<T, N> {
    #[inline]
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>> {
        let Some(step) = &self.map.code.step else {
            return Elimination::new(self.map.clone(), self.eps.clone()).quotients(x);
        };
        let StepCode { kernel, reciprocals, .. } = step.at(&self.eps);
        let mut registers = Registers::new();
        let inputs = Inputs { kept: &self.kept, state: x.as_slice(), ..Inputs::default() };
        let results = kernel.run(&inputs, &mut registers)?;
        let own = reciprocals.len();
        let reciprocal = |i: usize| Some(results.get(own + (*reciprocals.get(i)?)?));
        // A step read at run time can have several reciprocals.
        Some(Quotients::over_several(
            from_fn(|i| if i < own { results.get(i) } else { T::zero() }),
            from_fn(reciprocal),
        ))
    }
}

impl<T: Scalar, const N: usize> WideStep<T, N> for InterpretedStep<T, N> {
    /// Ensembles step an interpreted system one trajectory at a time.
    const HAS_LANES: bool = false;

    type Wide<L: Scalar> = InterpretedStep<L, N>;

    fn widen<L: Scalar>(&self, spread: impl Fn(&T) -> L) -> InterpretedStep<L, N> {
        InterpretedStep {
            map: self.map.over(&spread),
            eps: spread(&self.eps),
            kept: self.kept.iter().map(&spread).collect(),
        }
    }
}
