//! Lanes: several numbers side by side in one register, as a scalar.
//!
//! In: work that is written once, over any lanes. Out: the same work, compiled for the instructions
//! of a level and run there. One number is the register of scalars that have no other.

use super::EnsembleScalar;
use super::columns::Group;
use super::level::{Instructions, Level};
use crate::Scalar;
use crate::composition::Staged;

/// A register of consecutive numbers, compared and chosen from lane by lane.
pub trait Lanes<T>: Scalar + Copy {
    /// The number of lanes; a divisor of [`GROUP`](super::columns::GROUP).
    const WIDTH: usize;

    /// Which lanes a comparison holds in.
    type Mask: Copy;

    /// Loads the entries from `place` on.
    fn load(entries: &[T], place: usize) -> Self;

    /// Writes the entries from `place` on.
    fn store(self, entries: &mut [T], place: usize);

    /// Puts the number into every lane.
    fn spread(value: &T) -> Self;

    /// Where |self| > |other|; not where either is not a number.
    fn exceeds(self, other: Self) -> Self::Mask;

    /// Whether the mask is set in some lane.
    fn any(mask: Self::Mask) -> bool;

    /// `yes` where the mask is set, `no` elsewhere.
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Exchanges rows and columns.
    fn transposed(rows: Square<T>) -> Square<T>;
}

/// Four rows of four numbers.
pub(crate) type Square<T> = [[T; 4]; 4];

/// A scalar is a register of one.
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

/// Work over lanes of T.
pub trait OverLanes<T> {
    /// The result.
    type Output;
    /// Whether so little is alive at once that registers hold it twice, and the work is done by
    /// pairs of them.
    const IS_SMALL: bool;

    /// Does the work; to be inlined into its caller, whose instructions it then is compiled with.
    fn run<L: Lanes<T>>(self) -> Self::Output;
}

/// A float that fills lanes.
pub trait InLanes: EnsembleScalar {
    /// Numbers in a register of 512 bits, the widest there is.
    const MOST: usize = 64 / size_of::<Self>();
    /// Numbers in a register of 256 bits.
    const ROWS: usize = Self::MOST / 2;

    /// An entry that is smaller by this factor than the largest ones of its row and of its column
    /// adds nothing to the solution. The square of the factor is still a normal number.
    const NEGLIGIBLE: Self;

    /// Runs work over the lanes of a level or, should the processor lack it, of the baseline.
    fn run<W: OverLanes<Self>>(work: W, level: Level) -> W::Output;
}

/// A float whose columns are advanced in lanes.
pub(super) trait LaneSweep: InLanes {
    /// Advances columns of equal length by a step that has lanes, on the level asked for or, should
    /// the processor lack it, the baseline.
    fn advance_lanes<S, const N: usize>(
        map: &S,
        columns: [&mut [Group<Self>]; N],
        steps: u64,
        on: Instructions,
    ) -> Option<()>
    where
        S: Staged<Self, N>;
}

/// 2⁻⁶⁰
pub(super) const NEGLIGIBLE_F32: f32 = 1.0 / (1_u64 << 60) as f32;
/// 2⁻⁵⁰⁰
pub(super) const NEGLIGIBLE_F64: f64 = f64::from_bits((1023 - 500) << 52);

/// c − a·b, fused as the scalars of this build do it: those of AVX2 always fuse.
#[inline(always)]
pub(crate) fn minus_product<V: Scalar + Copy>(c: V, a: V, b: V) -> V {
    if cfg!(target_feature = "fma") { c.subtract_product(a, b) } else { c - a * b }
}
