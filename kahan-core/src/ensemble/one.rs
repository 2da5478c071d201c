//! Ensembles on processors without supported vector registers, one trajectory at a time.

use crate::PreparedStep;
use crate::composition::Staged;

use super::columns::Group;
use super::lanes::{InLanes, LaneSweep, NEGLIGIBLE_F32, NEGLIGIBLE_F64, OverLanes};
use super::level::{Instructions, Level};
use super::sweep::sweep;

macro_rules! one_at_a_time {
    ($float:ty, $negligible:ident) => {
        impl InLanes for $float {
            const NEGLIGIBLE: Self = $negligible;

            fn run<W: OverLanes<Self>>(work: W, _level: Level) -> W::Output {
                work.run::<Self>()
            }
        }

        impl LaneSweep for $float {
            fn advance_lanes<S, const N: usize>(
                map: &S,
                columns: [&mut [Group<Self>]; N],
                steps: u64,
                _on: Instructions,
            ) -> Option<()>
            where
                S: Staged<Self, N>,
            {
                let stages = map.stages(|at| at.prepared.widen(Self::clone));
                sweep::<Self, S, _, _, N>(&stages, columns, steps)
            }
        }
    };
}

one_at_a_time!(f32, NEGLIGIBLE_F32);
one_at_a_time!(f64, NEGLIGIBLE_F64);
