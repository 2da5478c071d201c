//! SIMD lanes: several numbers in one register, used as one scalar.
//!
//! A computation that is generic over the lane type is compiled for each instruction set. For a
//! scalar without vector registers, a register has a single lane.

use super::EnsembleScalar;
use super::columns::Group;
use super::level::{Instructions, Level};
use crate::Scalar;
use crate::composition::Staged;

/// A register of consecutive numbers, with comparison and selection in each lane.
pub trait Lanes<T>: Scalar + Copy {
    /// The number of lanes, a divisor of [`GROUP`](super::columns::GROUP).
    const WIDTH: usize;

    /// The lanes in which a comparison holds.
    type Mask: Copy;

    /// Loads the `WIDTH` entries from the index `place` on.
    fn load(entries: &[T], place: usize) -> Self;

    /// Stores the lanes into the entries from `place` on.
    fn store(self, entries: &mut [T], place: usize);

    /// Returns a register with the number in every lane.
    fn spread(value: &T) -> Self;

    /// Compares |self| > |other| in each lane, which is false for NaN.
    fn exceeds(self, other: Self) -> Self::Mask;

    /// Returns whether the mask contains any lane.
    fn any(mask: Self::Mask) -> bool;

    /// Selects `yes` in the lanes of the mask, and `no` in the other lanes.
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Transposes a 4 × 4 matrix of numbers.
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

/// A computation that is generic over the lane type for the scalar T.
pub trait OverLanes<T> {
    /// The type of the result.
    type Output;
    /// Whether the work needs few registers, and therefore runs on pairs of registers.
    const IS_SMALL: bool;

    /// Does the work. The function must be inlined; only then the caller's target features apply.
    fn run<L: Lanes<T>>(self) -> Self::Output;
}

/// A floating-point type with SIMD lanes.
pub trait InLanes: EnsembleScalar {
    /// The number of numbers in a 512-bit register, the widest register.
    const MOST: usize = 64 / size_of::<Self>();
    /// The number of numbers in a 256-bit register. Dense columns have a multiple of this height.
    const ROWS: usize = Self::MOST / 2;

    /// A matrix entry is negligible if it is below this fraction of the largest entry, both in its
    /// row and in its column. The square of this fraction does not underflow.
    const NEGLIGIBLE: Self;

    /// Runs work with the instruction set `level`, or with the baseline if the processor lacks it.
    fn run<W: OverLanes<Self>>(work: W, level: Level) -> W::Output;
}

pub(super) trait LaneSweep: InLanes {
    /// Advances columns of equal length by `steps` steps of `map`, computed in lanes. `on` names
    /// the instruction set; if the processor lacks it, the baseline is used.
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

/// Returns c − a·b, rounded once in programs compiled for FMA, and otherwise twice.
#[inline(always)]
pub(crate) fn minus_product<V: Scalar + Copy>(c: V, a: V, b: V) -> V {
    if cfg!(target_feature = "fma") { c.subtract_product(a, b) } else { c - a * b }
}
