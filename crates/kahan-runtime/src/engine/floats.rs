//! The floats that maps read at run time are stepped in, and how machine code takes them.

use core::cell::Cell;

use kahan_core::{Dd, Dual, EnsembleScalar, FloatScalar, Precision};

use crate::machine::{Coded, OrbitCode};

use super::lanes::EightLanes;
use super::scratch::{Local, Scratch, with_scratch};
use super::{Engine, Object};

/// A float of states: `f32`, `f64`, or [`Dd`].
pub trait RuntimeFloat: FloatScalar + EnsembleScalar + From<f32> + Default + Send + Sync {
    /// The precision of states that hold all of its digits.
    #[doc(hidden)]
    const PRECISION: Precision;

    /// The float that machine code computes it with.
    #[doc(hidden)]
    type Word: Coded;

    /// The words of the number.
    #[doc(hidden)]
    fn words(self) -> impl Iterator<Item = Self::Word>;

    /// Replaces numbers by those so many steps later, with the constants of the stages; `false`
    /// where the code cannot tell, and the numbers are as before.
    #[doc(hidden)]
    fn has_run(
        code: &OrbitCode<Self::Word>,
        stages: &[Vec<Self::Word>],
        numbers: &mut [Self],
        steps: u64,
    ) -> bool;

    /// Writes the results of an object; `false` where it has no code.
    #[doc(hidden)]
    fn has_evaluated(
        _engine: &Engine,
        _object: Object,
        _constants: &[Self],
        _state: &[Self],
        _out: &mut [Self],
    ) -> bool {
        false
    }

    /// The scratch for one state.
    #[doc(hidden)]
    fn single() -> Local<Self>;

    /// The scratch for derivatives along one direction.
    #[doc(hidden)]
    fn duals() -> Local<Dual<Self, 1>>;
}

/// A float of the machine: `f64` or `f32`.
pub trait MachineFloat: RuntimeFloat<Word = Self> + Coded {
    /// The scratch for several states side by side.
    #[doc(hidden)]
    fn lanes() -> Local<EightLanes<Self>>;
}

/// A function that lends the scratch of this thread over a scalar.
macro_rules! scratch {
    ($name:ident, $scalar:ty) => {
        fn $name() -> Local<$scalar> {
            thread_local!(static SCRATCH: Cell<Scratch<$scalar>> = Cell::default());
            &SCRATCH
        }
    };
}

macro_rules! implement_for_float {
    ($float:ty, $precision:ident) => {
        impl RuntimeFloat for $float {
            const PRECISION: Precision = Precision::$precision;

            type Word = $float;

            scratch!(single, $float);
            scratch!(duals, Dual<$float, 1>);

            fn words(self) -> impl Iterator<Item = Self> {
                core::iter::once(self)
            }

            fn has_run(
                code: &OrbitCode<Self>,
                stages: &[Vec<Self>],
                numbers: &mut [Self],
                steps: u64,
            ) -> bool {
                code.advance(numbers, stages, steps);
                true
            }

            fn has_evaluated(
                engine: &Engine,
                object: Object,
                constants: &[Self],
                state: &[Self],
                out: &mut [Self],
            ) -> bool {
                let code = engine.codes.function(engine, object);
                let code = code.filter(|code| code.results() <= out.len());
                code.map(|code| code.run(state, constants, out)).is_some()
            }
        }

        impl MachineFloat for $float {
            scratch!(lanes, EightLanes<$float>);
        }
    };
}

implement_for_float!(f32, Single);
implement_for_float!(f64, Double);

/// Steps of double-double between two looks at the guard of the code.
const GUARDED: u64 = 256;

impl RuntimeFloat for Dd {
    const PRECISION: Precision = Precision::DoubleDouble;

    type Word = f64;

    scratch!(single, Dd);
    scratch!(duals, Dual<Dd, 1>);

    fn words(self) -> impl Iterator<Item = f64> {
        [self.high(), self.low()].into_iter()
    }

    fn has_run(code: &OrbitCode<f64>, stages: &[Vec<f64>], numbers: &mut [Self], steps: u64) -> bool {
        with_scratch(f64::single(), |Scratch { state: words, .. }| {
            words.clear();
            words.extend(numbers.iter().flat_map(|x| x.words()));
            words.push(0.0);
            for first in (0..steps).step_by(GUARDED as usize) {
                code.advance(words, stages, GUARDED.min(steps - first));
                // Not a number is no zero.
                if words.last() != Some(&0.0) {
                    return false;
                }
            }
            let pairs = words.chunks_exact(2);
            numbers.iter_mut().zip(pairs).for_each(|(x, pair)| *x = Dd::new(pair[0], pair[1]));
            true
        })
    }
}
