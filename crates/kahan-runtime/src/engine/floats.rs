//! The float types of run-time maps, and the machine floats that represent them.

use core::cell::Cell;

use kahan_core::__private::{InLanes, Lanes, RegisterPair};
use kahan_core::{Dd, Dual, EnsembleScalar, FloatScalar};
use kahan_dynamics::Precision;

use crate::machine_code::{Codes, FloatCodes};

use super::couplings::{EliminationPattern, Factors};
use super::scratch::{ScratchCell, ScratchKey};
use super::{Engine, MapObject};

/// A float type of states: `f32`, `f64`, or [`Dd`].
pub trait RuntimeFloat: FloatScalar + EnsembleScalar + From<f32> + Default + Send + Sync {
    #[doc(hidden)]
    const PRECISION: Precision;

    /// The machine float of compiled code: `f64` for `Dd`, otherwise the type itself.
    #[doc(hidden)]
    type Word: MachineFloat;

    #[doc(hidden)]
    fn words(self) -> impl Iterator<Item = Self::Word>;

    #[doc(hidden)]
    fn from_words(words: &[Self::Word]) -> Self;

    /// Reinterprets the numbers as machine floats without a copy; `None` for `Dd`.
    #[doc(hidden)]
    fn as_words(numbers: &mut [Self]) -> Option<&mut [Self::Word]>;

    /// Evaluates a function derived from the field; returns `false` if it has no machine code.
    #[doc(hidden)]
    fn has_evaluated(
        _engine: &Engine,
        _object: MapObject,
        _constants: &[Self],
        _state: &[Self],
        _out: &mut [Self],
    ) -> bool {
        false
    }

    /// Factors A(x,ε) as [`EliminationPattern::factor`] does; `f32` and `f64` may use SIMD lanes.
    #[doc(hidden)]
    fn factor(tables: &EliminationPattern, slopes: &[Self], eps: &Self, factors: &mut Factors<Self>) -> bool {
        tables.factor(slopes, eps, factors)
    }

    /// Returns the scratch memory for steps of one state.
    #[doc(hidden)]
    fn single() -> ScratchKey<Self>;

    /// Returns the scratch memory for derivatives along one direction.
    #[doc(hidden)]
    fn duals() -> ScratchKey<Dual<Self, 1>>;
}

type EightLanes<T> = RegisterPair<RegisterPair<RegisterPair<T>>>;

/// A float of the machine: `f64` or `f32`.
pub trait MachineFloat: RuntimeFloat<Word = Self> + kahan_jit::Float + InLanes {
    /// A SIMD scalar with one orbit in each lane.
    #[doc(hidden)]
    type GroupCode: Lanes<Self>;

    /// Returns the machine code for numbers of this type.
    #[doc(hidden)]
    fn codes(codes: &Codes) -> &FloatCodes<Self>;

    /// Returns the scratch memory for steps of several states.
    #[doc(hidden)]
    fn lanes() -> ScratchKey<Self::GroupCode>;
}

macro_rules! scratch {
    ($name:ident, $scalar:ty) => {
        fn $name() -> ScratchKey<$scalar> {
            thread_local!(static SCRATCH: ScratchCell<$scalar> = const { Cell::new(None) });
            &SCRATCH
        }
    };
}

macro_rules! implement_for_float {
    ($float:ty, $precision:ident, $codes:ident) => {
        impl RuntimeFloat for $float {
            const PRECISION: Precision = Precision::$precision;

            type Word = $float;

            scratch!(single, $float);
            scratch!(duals, Dual<$float, 1>);

            fn words(self) -> impl Iterator<Item = Self> {
                core::iter::once(self)
            }

            fn from_words(words: &[Self]) -> Self {
                words[0]
            }

            fn as_words(numbers: &mut [Self]) -> Option<&mut [Self]> {
                Some(numbers)
            }

            fn has_evaluated(
                engine: &Engine,
                object: MapObject,
                constants: &[Self],
                state: &[Self],
                out: &mut [Self],
            ) -> bool {
                let code = engine.codes.function(engine, object);
                let code = code.filter(|code| code.results() <= out.len());
                code.map(|code| code.run(state, constants, out)).is_some()
            }

            fn factor(tables: &EliminationPattern, slopes: &[Self], eps: &Self, factors: &mut Factors<Self>) -> bool {
                tables.factor_in_lanes(slopes, eps, factors)
            }
        }

        impl MachineFloat for $float {
            type GroupCode = EightLanes<$float>;

            fn codes(codes: &Codes) -> &FloatCodes<Self> {
                &codes.$codes
            }

            scratch!(lanes, EightLanes<$float>);
        }
    };
}

implement_for_float!(f32, Single, single);
implement_for_float!(f64, Double, double);

impl RuntimeFloat for Dd {
    const PRECISION: Precision = Precision::DoubleDouble;

    type Word = f64;

    scratch!(single, Dd);
    scratch!(duals, Dual<Dd, 1>);

    fn words(self) -> impl Iterator<Item = f64> {
        [self.high(), self.low()].into_iter()
    }

    fn from_words(words: &[f64]) -> Self {
        Dd::new(words[0], words[1])
    }

    fn as_words(_numbers: &mut [Self]) -> Option<&mut [f64]> {
        None
    }
}
