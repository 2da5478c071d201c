//! Runs sweeps of ensembles, and `OverLanes` work such as elimination and chains, in the vector
//! registers of x86-64.
//!
//! SSE2 lanes are valid on every x86-64 processor. Outside tests, other lanes exist only inside
//! [`avx2`], [`avx512`], [`work_on_avx2`] and [`work_on_avx512`]. These functions are compiled for
//! their instructions, and run after a check of the processor. The lane types are private, so that
//! no other code can run these instructions on a processor that lacks them.
#![expect(unsafe_code, reason = "registers of vectors, entered after the processor was asked for them")]

mod estimated;
mod lanes;
#[cfg(test)]
mod tests;

use crate::PreparedStep;
use crate::composition::Staged;

use super::columns::Group;
use super::lanes::{InLanes, LaneSweep, Lanes, NEGLIGIBLE_F32, NEGLIGIBLE_F64, OverLanes};
use super::level::{Instructions, Level, Reciprocal};
use super::register_pair::RegisterPair;
use super::sweep::sweep;

use estimated::{F32x16Estimated, F64x8Estimated};
use lanes::{F32x4, F32x8, F32x16, F64x2, F64x4, F64x8};

macro_rules! dispatch_for_float {
    ($float:ty, $negligible:ident: $sse2:ty, $avx2:ty, $avx512:ty, $estimated:ty) => {
        impl InLanes for $float {
            const NEGLIGIBLE: Self = $negligible;

            fn run<W: OverLanes<Self>>(work: W, level: Level) -> W::Output {
                match level {
                    Level::Avx512 if level.is_available() => {
                        // SAFETY: `is_available` found AVX-512F in the condition above.
                        unsafe { work_on_avx512::<$avx512, _, W>(work) }
                    }
                    Level::Avx2 if level.is_available() => {
                        // SAFETY: `is_available` found AVX2 and FMA in the condition above.
                        unsafe { work_on_avx2::<$avx2, _, W>(work) }
                    }
                    _ if W::IS_SMALL => work.run::<RegisterPair<$sse2>>(),
                    _ => work.run::<$sse2>(),
                }
            }
        }

        impl LaneSweep for $float {
            fn advance_lanes<S, const N: usize>(
                map: &S,
                columns: [&mut [Group<Self>]; N],
                steps: u64,
                Instructions { level, reciprocal }: Instructions,
            ) -> Option<()>
            where
                S: Staged<Self, N>,
            {
                match (level, reciprocal) {
                    (Level::Avx512, Reciprocal::Estimated) if level.is_available() => {
                        // SAFETY: `is_available` found AVX-512F in the condition above.
                        unsafe { avx512::<$estimated, _, S, N>(map, columns, steps) }
                    }
                    (Level::Avx512, Reciprocal::Divided) if level.is_available() => {
                        // SAFETY: `is_available` found AVX-512F in the condition above.
                        unsafe { avx512::<$avx512, _, S, N>(map, columns, steps) }
                    }
                    (Level::Avx2, _) if level.is_available() => {
                        // SAFETY: `is_available` found AVX2 and FMA in the condition above.
                        unsafe { avx2::<$avx2, _, S, N>(map, columns, steps) }
                    }
                    _ => widen_and_sweep::<$sse2, _, S, N>(map, columns, steps),
                }
            }
        }
    };
}

dispatch_for_float!(f32, NEGLIGIBLE_F32: F32x4, F32x8, F32x16, F32x16Estimated);
dispatch_for_float!(f64, NEGLIGIBLE_F64: F64x2, F64x4, F64x8, F64x8Estimated);

macro_rules! over_registers {
    ($(#[$attribute:meta])* $name:ident: |$map:ident, $columns:ident, $steps:ident| $body:expr) => {
        $(#[$attribute])*
        fn $name<R, T, S, const N: usize>(
            $map: &S,
            $columns: [&mut [Group<T>]; N],
            $steps: u64,
        ) -> Option<()>
        where
            T: crate::Scalar,
            R: Lanes<T>,
            S: Staged<T, N>,
        {
            $body
        }
    };
}

over_registers! {
    #[target_feature(enable = "avx2,fma")]
    avx2: |map, columns, steps| widen_and_sweep::<R, T, S, N>(map, columns, steps)
}
over_registers! {
    #[target_feature(enable = "avx512f")]
    avx512: |map, columns, steps| widen_and_sweep::<R, T, S, N>(map, columns, steps)
}
over_registers! {
    /// The function must be inlined; only then the caller's target features apply.
    #[inline(always)]
    widen_and_sweep: |map, columns, steps| {
        sweep::<R, S, _, _, N>(&map.stages(|at| at.prepared.widen(R::spread)), columns, steps)
    }
}

#[target_feature(enable = "avx2,fma")]
fn work_on_avx2<L: Lanes<T>, T, W: OverLanes<T>>(work: W) -> W::Output
where
    RegisterPair<L>: Lanes<T>,
{
    if W::IS_SMALL { work.run::<RegisterPair<L>>() } else { work.run::<L>() }
}

/// An AVX-512 register has as many lanes as a [`RegisterPair`] of AVX2, so that no pairs are used.
#[target_feature(enable = "avx512f")]
fn work_on_avx512<L: Lanes<T>, T, W: OverLanes<T>>(work: W) -> W::Output {
    work.run::<L>()
}
