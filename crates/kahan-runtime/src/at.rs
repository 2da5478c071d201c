//! A map at one ε, over slices.

mod adjoint;
mod columns;
mod drift;
pub(crate) mod group;
mod objects;
mod observe;
mod passed_poles;
mod rotation;
mod tangent;
#[cfg(test)]
mod tests;

pub use adjoint::Gradient;
pub use drift::IntegralDrift;
pub use observe::WhileFinite;
pub use passed_poles::{Passed, PassedPoles};

use std::sync::{Arc, OnceLock};

use kahan_core::{Composition, Increments, Level, Step, Stopped, Workspace};
use kahan_dynamics::Precision;
use smallvec::SmallVec;

use crate::dimension::Argument;
use crate::engine::{CodedStages, Engine, Stage, integral_constants, split, stage_constants};
use crate::machine::{InstructionSet, StepKind};
use crate::{DimensionError, Map};

pub use crate::engine::{MachineFloat, RuntimeFloat};

/// A point; in up to eight variables it is no allocation.
pub type RuntimePoint<T> = SmallVec<[T; 8]>;

/// Kahan's map at one ε, half the time step; made by [`Map::at`].
///
/// States are slices, an entry a variable. Bits are those of the code that `kahan!` writes, for
/// single steps and for columns (where those are ensembles at [`Level::Baseline`]), unless [another
/// level](Self::at_level) is asked for. It runs as machine code where that can be had, and else
/// interpreted, by the same calls and with the same bits. Code leaves some steps to the
/// interpreter: in [`Dd`](kahan_core::Dd) those from huge and tiny numbers, and where it eliminates
/// those that need other pivots. Nothing panics, whatever the numbers are: a pole shows as numbers
/// that are not finite. After the first call on a thread no step allocates. A map can be used from
/// any number of threads at once. What is compiled or planned at its first use is made by one
/// thread, for which the others wait; steps wait for nobody.
#[derive(Clone, Debug)]
pub struct MapAt<T: RuntimeFloat> {
    map: Map,
    /// The parameters, and ε behind them.
    constants: Arc<[T]>,
    /// The same for integrals, which of a composition are those of the flow: ε is 0 there.
    of_integrals: Arc<[T]>,
    composition: Composition,
    kind: StepKind,
    /// On what columns run; `None` for the widest that there are.
    set: Option<InstructionSet>,
    /// The distinct stages, prepared for the interpreter when it makes its first step.
    stages: Arc<OnceLock<Vec<Stage<T>>>>,
    /// The same as machine code, where there is some.
    coded: Option<CodedStages<T>>,
    /// The map of the variational field, which carries tangent vectors, once one is carried.
    variational: Arc<OnceLock<MapAt<T>>>,
    /// Where its stages have poles, once steps over them are counted.
    poles: Arc<OnceLock<Vec<passed_poles::StagePoles<T>>>>,
}

impl<T: RuntimeFloat> MapAt<T> {
    /// The map with the parameters, and ε behind them, on states in this precision.
    pub(crate) fn new(map: Map, constants: Arc<[T]>, precision: Precision) -> Self {
        let composition = Composition::KAHAN;
        MapAt {
            map,
            of_integrals: Arc::clone(&constants),
            constants,
            composition,
            // With the bits of this build.
            kind: StepKind::of(precision, cfg!(target_feature = "fma")),
            set: None,
            stages: Arc::default(),
            coded: None,
            variational: Arc::default(),
            poles: Arc::default(),
        }
        .composed(composition)
    }

    /// The same map with each step replaced by a composition of steps, which has a higher order; a
    /// step still takes the time 2ε. [`Composition`] says what survives and what does not.
    ///
    /// It changes [`step`](Self::step) and what advances, and the [`integrals`](Self::integrals). A
    /// composition of maps at several ε keeps the integrals of none of them, but nearly those of
    /// the flow, so the claims are evaluated at ε = 0. Everything else, the Jacobian too, is of the
    /// map itself at ε.
    #[must_use]
    pub fn composed(&self, composition: Composition) -> Self {
        let own = stage_constants(self.kind, &self.constants, composition);
        let coded = self.engine().coded_stages(self.kind, &own);
        let of_integrals = integral_constants(&self.constants, composition).into();
        let (stages, variational, poles) = Default::default();
        MapAt { of_integrals, composition, stages, coded, variational, poles, ..self.clone() }
    }

    /// The same map with the bits of a level of ensembles, whose larger ones fuse multiply-adds,
    /// and its columns on the instructions of that level; `None` if this processor lacks them, or
    /// there is no machine code for the step.
    ///
    /// [`Level::Baseline`] is what a map is without being asked: the bits of this build, computed
    /// in registers as wide as there are.
    #[must_use]
    pub fn at_level(&self, level: Level) -> Option<Self> {
        let (set, fuses) = match level {
            Level::Avx512 => (Some(InstructionSet::Avx512), true),
            Level::Avx2 => (Some(InstructionSet::Avx2), true),
            Level::Neon => (Some(InstructionSet::Neon), true),
            _ => (None, cfg!(target_feature = "fma")),
        };
        let at = MapAt { kind: StepKind { fuses, ..self.kind }, set, ..self.clone() };
        let at = at.composed(self.composition);
        (level == Level::Baseline || level.is_available() && at.coded.is_some()).then_some(at)
    }

    /// Whether long runs are machine code, or compiled loops over the coefficients of a dense
    /// field, and not interpreted. The code of an elimination is compiled after some hundred steps.
    #[must_use]
    pub fn is_code(&self) -> bool {
        self.coded.is_some()
    }

    /// The map.
    #[must_use]
    pub fn map(&self) -> &Map {
        &self.map
    }

    /// ε, half the time step.
    #[must_use]
    pub fn eps(&self) -> T {
        self.own().1
    }

    /// The parameters, and ε.
    pub(crate) fn own(&self) -> (&[T], T) {
        split(&self.constants)
    }

    /// Replaces `x` by the state so many steps later.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` has not an entry a variable.
    pub fn advance(&self, x: &mut [T], steps: u64) -> Result<(), DimensionError> {
        self.check_state(x)?;
        self.advance_checked([x, &mut []], steps);
        Ok(())
    }

    /// Advances a state that fits, and its `carry` unless that is empty. Machine code makes the
    /// steps; the interpreter makes them where there is no code or where its guard refuses them.
    pub(crate) fn advance_checked(&self, numbers: [&mut [T]; 2], steps: u64) {
        let interpret = |numbers: [&mut [T]; 2], steps| {
            self.engine().advance(self.kind, self.stages(), numbers, steps);
        };
        let carries = !numbers[1].is_empty();
        let coded = |stages| Some((stages, CodedStages::code(stages, self.engine(), carries, steps)?));
        match self.coded.as_ref().and_then(coded) {
            Some((stages, code)) => stages.advance(code, numbers, steps, interpret),
            None => interpret(numbers, steps),
        }
    }

    /// The same with the rounding error of each addition carried into the next one: the orbit is at
    /// `x` + `carry`. Begin with zeros, and hand the same carry over again to go on.
    ///
    /// See [`Orbit::compensated`](kahan_core::Orbit::compensated) for what that cures.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` or `carry` has not an entry a variable.
    pub fn advance_with_carry(&self, x: &mut [T], carry: &mut [T], steps: u64) -> Result<(), DimensionError> {
        self.check_state(x)?;
        DimensionError::check(Argument::Carry, carry.len(), self.dimension())?;
        self.advance_checked([x, carry], steps);
        Ok(())
    }

    /// Whether the step from `x`, or a stage of it, divides by a number that is exactly 0.
    ///
    /// Cost: that of an interpreted step.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` has not an entry a variable.
    pub fn divides_by_zero(&self, x: &[T]) -> Result<bool, DimensionError> {
        self.check_state(x)?;
        Ok(self.engine().divides_by_zero(self.stages(), &mut x.to_vec()))
    }

    /// The same, of the map of this field at other parameters, and at another ε.
    fn at_constants(&self, map: Map, parameters: impl Iterator<Item = T>, eps: T) -> Self {
        let constants = parameters.chain([eps]).collect();
        MapAt { map, constants, ..self.clone() }.composed(self.composition)
    }

    /// The distinct stages, prepared for the interpreter.
    fn stages(&self) -> &[Stage<T>] {
        let own = || stage_constants(self.kind, &self.constants, self.composition);
        self.stages.get_or_init(|| self.engine().stages(&own()))
    }

    fn engine(&self) -> &Engine {
        &self.map.field().engine
    }

    fn dimension(&self) -> usize {
        self.engine().dimension()
    }

    fn check_state(&self, x: &[T]) -> Result<(), DimensionError> {
        DimensionError::check(Argument::State, x.len(), self.dimension())
    }

    fn check_out(&self, out: &[T], expected: usize) -> Result<(), DimensionError> {
        DimensionError::check(Argument::Out, out.len(), expected)
    }
}

impl<T: MachineFloat> MapAt<T> {
    /// x̃, the state one time step of 2ε later.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` or `next` has not an entry a variable.
    pub fn step(&self, x: &[T], next: &mut [T]) -> Result<(), DimensionError> {
        self.check_out(next, self.dimension())?;
        self.check_state(x)?;
        if !self.coded.as_ref().is_some_and(|stages| stages.has_stepped(x, next)) {
            next.copy_from_slice(x);
            self.advance_checked([next, &mut []], 1);
        }
        Ok(())
    }
}

/// Bits are those of [`advance`](MapAt::advance). A state of another length panics here, as
/// dimensions of nalgebra do.
impl<T: RuntimeFloat> Step for MapAt<T> {
    type Scalar = T;
    type State = Vec<T>;

    fn dimension(&self) -> usize {
        MapAt::dimension(self)
    }

    fn eps(&self) -> &T {
        self.constants.last().unwrap_or_else(|| unreachable!("eps is one of them"))
    }

    #[track_caller]
    fn advance(&self, x: &mut [T], steps: u64, _room: &mut Workspace) -> Result<(), Stopped> {
        fitting(MapAt::advance(self, x, steps));
        Ok(())
    }

    #[track_caller]
    fn part(&self, eps: &T, x: &mut [T], workspace: &mut Workspace) -> Result<(), Stopped> {
        fitting(self.check_state(x));
        let constants = (self.own().0, *eps);
        let by_code =
            |stages: &CodedStages<T>| stages.has_stepped_at(self.engine(), constants, self.composition, x);
        if self.coded.as_ref().is_some_and(by_code) {
            return Ok(());
        }
        let part = self.at_constants(self.map.clone(), self.own().0.iter().copied(), *eps);
        Step::advance(&part, x, 1, workspace)
    }
}

/// Bits are those of [`advance_with_carry`](MapAt::advance_with_carry).
impl<T: RuntimeFloat> Increments for MapAt<T> {
    type Carried = Vec<T>;

    #[track_caller]
    fn next_with_carry(&self, x: &Vec<T>, workspace: &mut Workspace) -> Option<Vec<T>> {
        let mut next = x.clone();
        Increments::advance_with_carry(self, &mut next, 1, workspace).ok()?;
        Some(next)
    }

    #[track_caller]
    fn advance_with_carry(&self, x: &mut [T], steps: u64, _room: &mut Workspace) -> Result<(), Stopped> {
        let (point, carry) = x.split_at_mut(x.len().min(self.dimension()));
        fitting(MapAt::advance_with_carry(self, point, carry, steps));
        Ok(())
    }
}

/// What a call without errors of its own makes of a state of another length.
#[track_caller]
pub(crate) fn fitting(checked: Result<(), DimensionError>) {
    if let Err(error) = checked {
        panic!("{error}")
    }
}
