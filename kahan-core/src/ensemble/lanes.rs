//! SIMD lanes: several numbers in one register, used as one scalar.
//!
//! In: work written once, generic over the lane type. Out: the work, compiled for the instructions
//! of a level and run there. A scalar without vector registers is a register of width 1.

use super::EnsembleScalar;
use super::columns::Group;
use super::level::{Instructions, Level};
use crate::Scalar;
use crate::composition::Staged;

/// A register of consecutive numbers with lane-wise comparison and selection.
pub trait Lanes<T>: Scalar + Copy {
    /// The number of lanes; a divisor of [`GROUP`](super::columns::GROUP).
    const WIDTH: usize;

    /// The lanes in which a comparison holds.
    type Mask: Copy;

    /// Loads `WIDTH` entries from index `place` on.
    fn load(entries: &[T], place: usize) -> Self;

    /// Stores the lanes into the entries from index `place` on.
    fn store(self, entries: &mut [T], place: usize);

    /// Puts the number into every lane.
    fn spread(value: &T) -> Self;

    /// Compares |self| > |other| per lane; false if either is NaN.
    fn exceeds(self, other: Self) -> Self::Mask;

    /// Returns whether the mask is set in any lane.
    fn any(mask: Self::Mask) -> bool;

    /// Selects `yes` where the mask is set, `no` elsewhere.
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Transposes a 4 × 4 matrix.
    fn transposed(rows: Square<T>) -> Square<T>;
}

pub(crate) type Square<T> = [[T; 4]; 4];

impl<T: Scalar + Copy> Lanes<T> for T {
    const WIDTH: usize = 1;

    type Mask = bool;

    #[inline(always)]
    fn load(entries: &[T], place: usize) -> Self {
        entries[place]
    }

    #[inline(always)]
    fn store(self, entries: &mut [T], place: usize) {
        entries[place] = self;
    }

    #[inline(always)]
    fn spread(value: &T) -> Self {
        *value
    }

    #[inline(always)]
    fn exceeds(self, other: Self) -> bool {
        self.is_better_pivot(&other)
    }

    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn choose(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn transposed(rows: Square<T>) -> Square<T> {
        core::array::from_fn(|k| core::array::from_fn(|r| rows[r][k]))
    }
}

/// Work that is generic over the lane type of T.
pub trait OverLanes<T> {
    /// The result.
    type Output;
    /// Whether the work needs few registers. It then runs on pairs of registers to hide latency.
    const IS_SMALL: bool;

    /// Does the work. Must be inlined, so that the caller's target features apply.
    fn run<L: Lanes<T>>(self) -> Self::Output;
}

/// A float with SIMD lanes.
pub trait InLanes: EnsembleScalar {
    /// Numbers in a 512-bit register, the widest.
    const MOST: usize = 64 / size_of::<Self>();
    /// Numbers in a 256-bit register.
    const ROWS: usize = Self::MOST / 2;

    /// An entry below this fraction of the largest entries of its row and of its column cannot
    /// change the solution. The square of the fraction is still a normal number.
    const NEGLIGIBLE: Self;

    /// Runs work over the lanes of `level`, or of the baseline if the processor lacks the level.
    fn run<W: OverLanes<Self>>(work: W, level: Level) -> W::Output;
}

pub(super) trait LaneSweep: InLanes {
    /// Advances columns of equal length by a step that has lanes, on the level of `on`, or on the
    /// baseline if the processor lacks it.
    fn advance_lanes<S, const N: usize>(
        map: &S,
        columns: [&mut [Group<Self>]; N],
        steps: u64,
        on: Instructions,
    ) -> Option<()>
    where
        S: Staged<Self, N>;
}

pub(super) const NEGLIGIBLE_F32: f32 = 1.0 / (1_u64 << 60) as f32;
pub(super) const NEGLIGIBLE_F64: f64 = f64::from_bits((1023 - 500) << 52);

/// c − a·b, fused if the program is compiled for FMA; AVX2 lanes always fuse.
#[inline(always)]
pub(crate) fn minus_product<V: Scalar + Copy>(c: V, a: V, b: V) -> V {
    if cfg!(target_feature = "fma") { c.subtract_product(a, b) } else { c - a * b }
}
