//! The prepared step of an interpreted system.

use core::array::from_fn;
use kahan_core::nalgebra::SVector;
use kahan_core::{Elimination, ExtendScalars, PreparedStep, Quotients, Scalar};
use std::sync::Arc;

use crate::line::has_value;

use super::{Interpreted, Registers, sized};

/// The step of an [`Interpreted`] system at one ε, with the constants of the step.
///
/// `COST` cannot depend on the field, since it is an associated constant. It is the cost of
/// elimination; the actual cost is [`Interpreted::cost`].
#[derive(Clone, Debug)]
pub struct InterpretedStep<T, const N: usize> {
    map: Interpreted<T, N>,
    eps: T,
    is_general: bool,
    /// The registers of the step's program that do not depend on the state.
    kept: Arc<[T]>,
}

impl<T: Scalar, const N: usize> InterpretedStep<T, N> {
    /// Computes the constants from ε and the parameters.
    ///
    /// # Panics
    /// For exact scalars, if the field divides by zero at the parameters.
    pub(super) fn new(map: Interpreted<T, N>, eps: T) -> Self {
        let is_general = map.engine.steps().are_general(&eps);
        let kept = match map.engine.steps().form(is_general).lines() {
            Some([constants, kernel]) => {
                let (mut registers, mut kept) = (Registers::new(), Registers::new());
                let registers = sized(&mut registers, constants.registers());
                let prepared = has_value(constants.results(map.constants(&eps), registers, &[]));
                let kept = sized(&mut kept, kernel.given());
                kernel.give(prepared.iter(), kept);
                Arc::from(&*kept)
            }
            None => Arc::new([]) as Arc<[T]>,
        };
        InterpretedStep { map, eps, is_general, kept }
    }
}

impl<T: Scalar, const N: usize> PreparedStep<T, N> for InterpretedStep<T, N> {
    /// Never used, because `HAS_LANES` is false for this step.
    type Wide<L: Scalar> = InterpretedStep<L, N>;

    #[inline]
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>> {
        let step = self.map.engine.steps().form(self.is_general);
        let Some([_, kernel]) = step.lines() else {
            if let Some(increments) = self.map.along_couplings(x.as_slice(), &self.eps) {
                let mut increments = increments.into_iter();
                return Some(Quotients::whole(from_fn(|_| increments.next().unwrap_or_else(T::zero))));
            }
            return Elimination::new(self.map.clone(), self.eps.clone()).quotients(x);
        };
        let mut registers = Registers::new();
        let registers = sized(&mut registers, kernel.registers());
        registers[..self.kept.len()].clone_from_slice(&self.kept);
        let results = kernel.run(registers, x.as_slice())?;
        let quotient = |i: usize| step.quotients.get(i).copied();
        // The components may have different denominators, with one reciprocal for each.
        Some(Quotients::over_several(
            from_fn(|i| quotient(i).map_or_else(T::zero, |(numerator, _)| results.get(numerator))),
            from_fn(|i| Some(results.get(quotient(i)?.1?))),
        ))
    }

    fn widen<L: Scalar>(&self, spread: impl Fn(&T) -> L) -> InterpretedStep<L, N> {
        InterpretedStep {
            map: self.map.extend_scalars(&spread),
            eps: spread(&self.eps),
            is_general: self.is_general,
            kept: self.kept.iter().map(&spread).collect(),
        }
    }
}
