//! The instruction sets that an ensemble can run on.
//!
//! In: the processor's features, detected at run time. Out: one level for a whole ensemble, which
//! also fixes the bits of its results. Outside x86-64 and 64-bit Arm, `Baseline` is the only level.

/// An instruction set for the steps of an [`Ensemble`](crate::Ensemble), in increasing order.
///
/// The level decides the number of trajectories per register and whether multiply-adds are fused,
/// and so the last bits of a result. Within one level the bits are equal on every run and machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Level {
    /// The instructions that the program was compiled for: two `f64` or four `f32` at a time on
    /// x86-64 and 64-bit Arm, otherwise one. The bits are those of
    /// [`KahanAt::step`](crate::KahanAt::step), with one exception: if that step divides more than
    /// once (one or two variables) or by the time step, lanes use the form with a single division,
    /// because the divider limits throughput. The last digit may then differ.
    Baseline,
    /// AVX2 with fused multiply-adds: four `f64` or eight `f32` at a time.
    Avx2,
    /// AVX-512F: eight `f64` or sixteen `f32` at a time, with the bits of [`Avx2`](Self::Avx2). Its
    /// divider is no faster, so it helps mainly where multiplications limit the speed.
    Avx512,
    /// NEON on 64-bit Arm: two `f64` or four `f32` at a time; bits of [`Avx2`](Self::Avx2).
    Neon,
}

impl Level {
    /// Returns whether this processor supports the level.
    pub fn is_available(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => {
                std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
            }
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => std::arch::is_x86_feature_detected!("avx512f"),
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx2 | Self::Avx512 => false,
            Self::Neon => cfg!(target_arch = "aarch64"),
        }
    }

    /// Returns the highest level of this processor, the default of ensembles.
    pub fn best() -> Self {
        [Self::Neon, Self::Avx512, Self::Avx2]
            .into_iter()
            .find(|level| level.is_available())
            .unwrap_or(Self::Baseline)
    }
}

/// The method for the reciprocals of a step's denominators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Reciprocal {
    /// By the division instruction: correctly rounded.
    #[default]
    Divided,
    /// On [`Level::Avx512`], the processor's 14-bit estimate refined by Newton's iteration, twice
    /// for `f64` and once for `f32`. On other levels and for other scalars like
    /// [`Divided`](Self::Divided).
    ///
    /// Up to a third faster where a step does little but divide (Lotka–Volterra), and no faster
    /// where multiplications limit the speed. Over operands of all exponents, including subnormal
    /// ones, a reciprocal differs from the correctly rounded one in one case of 900 for `f64` and
    /// of 340 for `f32`, by one unit in the last place. If the reciprocal is infinite (at 0 or by
    /// overflow) or the operand is infinite, the result is NaN. Poles and overflowing denominators
    /// therefore stay visible, whereas a division by infinity would silently leave the point
    /// unchanged.
    Estimated,
}

/// The choices that fix an ensemble's bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instructions {
    pub(crate) level: Level,
    pub(crate) reciprocal: Reciprocal,
}
