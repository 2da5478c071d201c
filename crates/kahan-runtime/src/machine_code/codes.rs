//! The machine code of a field, compiled at first use and shared by all maps of the field.
//!
//! In: an engine, and a kind of step or a derived function. Out: code, or `None` if there is no
//! compiler, no program, or if compilation fails.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use kahan_jit::{ComposedOrbit, Constants, Function, InstructionSet, LaneCount, Orbit, Shape, Sweep};

use crate::engine::{Engine, MachineFloat, MapObject, advance_dense};

use super::{GroupKind, StepKind, programs};

/// Whether machine code can run; without the feature `jit`, the binary contains no compiler.
const CAN_RUN: bool = cfg!(feature = "jit");

/// The number of steps after which the code of an elimination is compiled. Compiling saves time
/// after some 300 steps for 9 dense variables, and after 7000 for 50 sparse ones.
const STEPS_BEFORE_CODE: u64 = 256;
/// Compilation waits one more step for each such number of operations in an elimination.
const OPERATIONS_A_STEP: u64 = 8;

/// A table of compiled code; keys are kinds of steps, a value is `None` if compilation failed.
#[derive(Debug)]
struct CodeTable<K, C>(Mutex<HashMap<K, Option<Arc<C>>>>);

impl<K, C> Default for CodeTable<K, C> {
    fn default() -> Self {
        CodeTable(Mutex::default())
    }
}

impl<K: Eq + Hash, C> CodeTable<K, C> {
    fn get(&self, key: K, compile: impl FnOnce() -> Option<C>) -> Option<Arc<C>> {
        if !CAN_RUN {
            return None;
        }
        // Only `compile` can panic under the lock, and then the table is unchanged, so it remains
        // usable.
        let mut table = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        table.entry(key).or_insert_with(|| compile().map(Arc::new)).clone()
    }
}

/// The compiled code of a field over one float type.
#[derive(Debug, Default)]
pub struct FloatCodes<T> {
    orbits: CodeTable<(StepKind, bool), OrbitCode<T>>,
    functions: OnceLock<Vec<OnceLock<Option<Function<T>>>>>,
    columns: CodeTable<(StepKind, Shape), ColumnsCode<T>>,
    abreast: CodeTable<(GroupKind, InstructionSet), Sweep<T>>,
}

/// The compiled code of a field over all float types.
#[derive(Debug, Default)]
pub struct Codes {
    pub(crate) single: FloatCodes<f32>,
    pub(crate) double: FloatCodes<f64>,
    /// The number of steps requested while the code of an elimination was not compiled.
    steps: AtomicU64,
    operations: OnceLock<Option<u32>>,
}

#[derive(Debug)]
pub(crate) struct OrbitCode<T> {
    step: StepCode<T>,
    is_guarded: bool,
}

#[derive(Debug)]
enum StepCode<T> {
    Single(Orbit<T>),
    Composed(ComposedOrbit<T>),
    /// Loops, written in Rust, over the coefficients of a dense field.
    Loops(StepKind),
}

#[derive(Debug)]
pub(crate) struct ColumnsCode<T> {
    /// The code that computes the constants of a step for one SIMD register of trajectories.
    constants: Function<T>,
    shared: Sweep<T>,
    own: Sweep<T>,
    is_guarded: bool,
}

impl Codes {
    /// Returns the number of operations of a step by elimination; `None` for other steps.
    pub(super) fn operations(&self, engine: &Engine) -> Option<u32> {
        *self
            .operations
            .get_or_init(|| Some(engine.derived.couplings()?.cost(engine.derived.field()).operations))
    }

    /// Counts steps, and returns whether compiling pays. For a step without elimination it always
    /// pays.
    pub(crate) fn is_worth_compiling(&self, steps: u64, engine: &Engine) -> bool {
        let Some(operations) = self.operations(engine) else { return true };
        let needed = STEPS_BEFORE_CODE + u64::from(operations) / OPERATIONS_A_STEP;
        let before = self.steps.load(Ordering::Relaxed);
        let after = before.saturating_add(steps);
        if before < needed {
            self.steps.store(after, Ordering::Relaxed);
        }
        after >= needed
    }

    pub(crate) fn orbit<T: MachineFloat>(
        &self,
        engine: &Engine,
        kind: StepKind,
        is_composed: bool,
    ) -> Option<Arc<OrbitCode<T>>> {
        T::codes(self).orbits.get((kind, is_composed), || {
            let (program, is_guarded) = kind.guarded_program::<T>(engine)?;
            let instructions = InstructionSet::least(kind.fuses);
            let shape = Shape { instructions, lanes: LaneCount::One, fuses: kind.fuses };
            let step = if is_composed {
                StepCode::Composed(ComposedOrbit::compile(&program, shape).ok()?)
            } else {
                StepCode::Single(Orbit::compile(&program, shape).ok()?)
            };
            Some(OrbitCode { step, is_guarded })
        })
    }

    /// Returns code for a group of points, one in each SIMD lane with its own constants; `None` if
    /// compilation fails.
    pub(crate) fn group_code<T: MachineFloat>(
        &self,
        engine: &Engine,
        work: GroupKind,
        instructions: InstructionSet,
    ) -> Option<Arc<Sweep<T>>> {
        T::codes(self).abreast.get((work, instructions), || {
            let (program, fuses) = match work {
                GroupKind::Steps(kind) => (kind.program::<T>(engine)?, kind.fuses),
                GroupKind::Carrying(carrying) => (carrying.program::<T>(engine)?, carrying.kind.fuses),
                GroupKind::Integrals => (programs::integrals_behind_the_state::<T>(engine)?, false),
            };
            let shape = Shape { instructions, lanes: LaneCount::All, fuses };
            Sweep::compile(&program, shape, Constants::Own).ok()
        })
    }

    /// Returns the code of an object, without fused multiply-adds; `None` if compilation fails.
    pub(crate) fn function<T: MachineFloat>(
        &self,
        engine: &Engine,
        object: MapObject,
    ) -> Option<&Function<T>> {
        if !CAN_RUN {
            return None;
        }
        let compile = || {
            let program = programs::object::<T>(object, engine)?;
            let instructions = InstructionSet::least(false);
            let shape = Shape { instructions, lanes: LaneCount::One, fuses: false };
            Function::compile(&program, shape).ok()
        };
        let none_yet = || (0..engine.objects()).map(|_| OnceLock::new()).collect();
        let functions = T::codes(self).functions.get_or_init(none_yet);
        functions.get(object.entry(&engine.derived).0)?.get_or_init(compile).as_ref()
    }

    pub(crate) fn columns<T: MachineFloat>(
        &self,
        engine: &Engine,
        kind: StepKind,
        instructions: InstructionSet,
    ) -> Option<Arc<ColumnsCode<T>>> {
        let shape = Shape { instructions, lanes: LaneCount::All, fuses: kind.fuses };
        T::codes(self).columns.get((kind, shape), || ColumnsCode::compile(engine, kind, shape))
    }
}

impl<T: MachineFloat> OrbitCode<T> {
    pub(crate) fn loops(kind: StepKind) -> Self {
        OrbitCode { step: StepCode::Loops(kind), is_guarded: true }
    }

    pub(crate) fn has_loops(&self) -> bool {
        matches!(self.step, StepCode::Loops(_))
    }

    /// Returns whether a number, the guard, follows the numbers of a state. Steps must be repeated
    /// if the guard exceeds [`LARGEST_FACTOR`](kahan_core::__private::LARGEST_FACTOR).
    pub(crate) fn is_guarded(&self) -> bool {
        self.is_guarded
    }

    /// Writes the state one step later into `next`.
    pub(crate) fn step(&self, numbers: &[T], stages: &[Vec<T>], next: &mut [T]) {
        match &self.step {
            StepCode::Single(orbit) => orbit.step(numbers, &stages[0], next),
            StepCode::Composed(_) | StepCode::Loops(_) => {
                next.copy_from_slice(numbers);
                self.advance(next, stages, 1);
            }
        }
    }

    /// Advances the numbers of a state by `steps` steps. Each entry of `stages` holds the constants
    /// of a stage of a palindromic composition, up to the middle stage.
    pub(crate) fn advance(&self, numbers: &mut [T], stages: &[Vec<T>], steps: u64) {
        match &self.step {
            StepCode::Single(orbit) => orbit.run(numbers, &stages[0], steps),
            StepCode::Composed(orbit) => {
                let (middle, before) =
                    stages.split_last().unwrap_or_else(|| unreachable!("there is a stage"));
                let order = before.iter().chain([middle]).chain(before.iter().rev());
                orbit.run(numbers, order.map(Vec::as_slice), steps);
            }
            StepCode::Loops(kind) => advance_dense(*kind, numbers, stages, steps),
        }
    }
}

impl<T: MachineFloat> ColumnsCode<T> {
    fn compile(engine: &Engine, kind: StepKind, shape: Shape) -> Option<Self> {
        let prepared = programs::prepared::<T>(engine, kind.is_general)?;
        let (program, is_guarded) = kind.guarded_program::<T>(engine)?;
        Some(ColumnsCode {
            // Constants are computed by separate products and sums, without fused multiply-adds.
            constants: Function::compile(&prepared, Shape { fuses: false, ..shape }).ok()?,
            shared: Sweep::compile(&program, shape, Constants::Shared).ok()?,
            own: Sweep::compile(&program, shape, Constants::Own).ok()?,
            is_guarded,
        })
    }

    pub(crate) fn is_guarded(&self) -> bool {
        self.is_guarded
    }

    pub(crate) fn width(&self) -> usize {
        self.shared.width()
    }

    pub(crate) fn prepare(&self, given: &[T], constants: &mut Vec<T>) {
        let start = constants.len();
        constants.resize(start + self.constants.results(), T::default());
        self.constants.run(&[], given, &mut constants[start..]);
    }

    pub(crate) fn advance_columns(
        &self,
        columns: &mut [&mut [T]],
        constants: &[T],
        are_shared: bool,
        steps: u64,
    ) {
        let sweep = if are_shared { &self.shared } else { &self.own };
        sweep.run(columns, constants, steps);
    }
}
