//! Runs sweeps of ensembles, and `OverLanes` work such as elimination and chains, in the vector
//! registers of 64-bit Arm.
//!
//! Every 64-bit Arm target with Rust's standard library has NEON. Each float type has two lane
//! types, because `Level::Baseline` rounds multiply-adds twice, and `Level::Neon` once.
#![expect(unsafe_code, reason = "registers of vectors, which every 64-bit Arm has")]

mod lanes;
#[cfg(test)]
mod tests;

use crate::PreparedStep;
use crate::composition::Staged;

use super::columns::Group;
use super::lanes::{InLanes, LaneSweep, Lanes, NEGLIGIBLE_F32, NEGLIGIBLE_F64, OverLanes};
use super::level::{Instructions, Level};
use super::register_pair::RegisterPair;
use super::sweep::sweep;

use lanes::{F32x4, F32x4Fused, F64x2, F64x2Fused};

macro_rules! in_lanes {
    ($float:ty, $negligible:ident: $lanes:ty, $fused:ty) => {
        impl InLanes for $float {
            const NEGLIGIBLE: Self = $negligible;

            fn run<W: OverLanes<Self>>(work: W, level: Level) -> W::Output {
                match (level, W::IS_SMALL) {
                    (Level::Neon, true) => work.run::<RegisterPair<$fused>>(),
                    (Level::Neon, false) => work.run::<$fused>(),
                    (_, true) => work.run::<RegisterPair<$lanes>>(),
                    (_, false) => work.run::<$lanes>(),
                }
            }
        }

        impl LaneSweep for $float {
            fn advance_lanes<S, const N: usize>(
                map: &S,
                columns: [&mut [Group<Self>]; N],
                steps: u64,
                on: Instructions,
            ) -> Option<()>
            where
                S: Staged<Self, N>,
            {
                if on.level == Level::Neon {
                    let stages = map.stages(|at| at.prepared.widen(<$fused as Lanes<Self>>::spread));
                    sweep::<$fused, S, _, _, N>(&stages, columns, steps)
                } else {
                    let stages = map.stages(|at| at.prepared.widen(<$lanes as Lanes<Self>>::spread));
                    sweep::<$lanes, S, _, _, N>(&stages, columns, steps)
                }
            }
        }
    };
}

in_lanes!(f32, NEGLIGIBLE_F32: F32x4, F32x4Fused);
in_lanes!(f64, NEGLIGIBLE_F64: F64x2, F64x2Fused);
