//! Lanes that choose: what work in registers needs where its numbers decide.
//!
//! In: work that is written once, over any lanes. Out: the same work, compiled for the instructions
//! of a level and run there. One float is the register of processors that have no other.

use super::level::Level;
pub use super::sweep::Register;
use crate::Scalar;

/// A register whose lanes are compared and chosen from, each for itself.
pub trait Lanes<T>: Register<T> {
    /// Which lanes a comparison holds in.
    type Mask: Copy;

    /// Where |self| > |other|; not where either is not a number.
    fn exceeds(self, other: Self) -> Self::Mask;

    /// Whether the mask is set in some lane.
    fn any(mask: Self::Mask) -> bool;

    /// `yes` where the mask is set, `no` elsewhere.
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Rows for columns.
    fn transposed(rows: Square<T>) -> Square<T>;
}

/// Four rows of four numbers.
pub(crate) type Square<T> = [[T; 4]; 4];

/// Work over lanes of T.
pub trait OverLanes<T> {
    /// What comes of it.
    type Output;
    /// Whether so little is alive at once that registers hold it twice, and the work is done by
    /// pairs of them.
    const IS_SMALL: bool;

    /// Does it; to be inlined into its caller, whose instructions it then is compiled with.
    fn run<L: Lanes<T>>(self) -> Self::Output;
}

/// A float that fills lanes.
pub trait InLanes: Sized {
    /// Numbers in a register of 512 bits, the widest there is.
    const MOST: usize = 64 / size_of::<Self>();

    /// Runs work over the lanes of a level or, should the processor lack it, of the baseline.
    fn run<W: OverLanes<Self>>(work: W, level: Level) -> W::Output;
}

/// c − a·b, fused as the scalars of this build do it: those of AVX2 always fuse.
#[inline(always)]
pub(crate) fn minus_product<V: Scalar + Copy>(c: V, a: V, b: V) -> V {
    if cfg!(target_feature = "fma") { c.subtract_product(a, b) } else { c - a * b }
}

macro_rules! implement_for_float {
    ($float:ty) => {
        impl Lanes<$float> for $float {
            type Mask = bool;

            #[inline(always)]
            fn exceeds(self, other: Self) -> bool {
                self.abs() > other.abs()
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
            fn transposed(rows: Square<$float>) -> Square<$float> {
                core::array::from_fn(|k| core::array::from_fn(|r| rows[r][k]))
            }
        }

        #[cfg(not(target_arch = "x86_64"))]
        impl InLanes for $float {
            fn run<W: OverLanes<Self>>(work: W, _level: Level) -> W::Output {
                work.run::<Self>()
            }
        }
    };
}

implement_for_float!(f32);
implement_for_float!(f64);
