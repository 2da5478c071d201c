//! The code of a field, compiled when it is first asked for and shared by everyone who steps it.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use kahan_algebra::Derived;
use kahan_algebra::plan::StepPlan;
use kahan_jit::{ComposedOrbit, InstructionSet, Lanes, Orbit, Refusal, Shape};

use super::step::StepKind;

/// Which of the two forms of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Form {
    /// The one that serves the orbit of one point at an ordinary ε.
    Own,
    /// The one that serves every scalar and every ε.
    AnyEps,
}

impl Form {
    /// The plan of this form.
    pub(crate) fn of(self, step: &StepPlan) -> &StepPlan {
        match self {
            Form::Own => step,
            Form::AnyEps => step.for_any_step(),
        }
    }
}

/// The code of an orbit.
#[derive(Debug)]
pub(crate) enum Stepping<T> {
    /// A step is one of the map.
    Single(Orbit<T>),
    /// A step is several of the map, one after another.
    Composed(ComposedOrbit<T>),
}

/// What code is asked for.
type Key = (StepKind, Form, bool);

/// Code that was asked for; `None` where there is none.
type Table<T> = Mutex<HashMap<Key, Option<Arc<Stepping<T>>>>>;

/// The code of a field.
#[derive(Debug, Default)]
pub(crate) struct Codes {
    single: Table<f32>,
    double: Table<f64>,
}

/// A float that has code.
pub(crate) trait Coded: kahan_jit::Float {
    /// Its table.
    fn table(codes: &Codes) -> &Table<Self>;
}

impl Coded for f32 {
    fn table(codes: &Codes) -> &Table<f32> {
        &codes.single
    }
}

impl Coded for f64 {
    fn table(codes: &Codes) -> &Table<f64> {
        &codes.double
    }
}

impl Codes {
    /// The code of an orbit, compiled if nobody has asked for it before; `None` where the step is no
    /// straight line, or there can be no code.
    pub(crate) fn stepping<T: Coded>(
        &self,
        derived: &Derived,
        kind: StepKind,
        form: Form,
        is_composed: bool,
    ) -> Option<Arc<Stepping<T>>> {
        let compile = || -> Option<Arc<Stepping<T>>> {
            let program = kind.program(form.of(derived.step()?), &derived.system.field.symbols);
            let instructions = if kind.fuses { InstructionSet::Avx2 } else { InstructionSet::Avx };
            let shape = Shape { instructions, lanes: Lanes::One, fuses: kind.fuses };
            let code: Result<_, Refusal> = if is_composed {
                ComposedOrbit::compile(&program, shape).map(Stepping::Composed)
            } else {
                Orbit::compile(&program, shape).map(Stepping::Single)
            };
            code.ok().map(Arc::new)
        };
        // Nothing panics under the lock but what would panic again.
        let mut table = T::table(self).lock().unwrap_or_else(PoisonError::into_inner);
        table.entry((kind, form, is_composed)).or_insert_with(compile).clone()
    }
}
