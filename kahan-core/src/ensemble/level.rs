//! The instruction sets on which an ensemble can run, detected at run time.

/// An instruction set for an [`Ensemble`](crate::Ensemble). In `Ord`, later variants are greater.
///
/// The instruction set determines how many trajectories a register holds and whether multiply-adds
/// are fused, and therefore the last bits of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Level {
    /// The instructions for which the program was compiled. On x86-64 and 64-bit Arm they advance
    /// two `f64` or four `f32` at a time, elsewhere one number. Lanes prefer a formula with a
    /// single division, because divisions limit the throughput. If
    /// [`KahanAt::step`](crate::KahanAt::step) uses the same formula, its results have the same
    /// bits.
    Baseline,
    /// AVX2 with fused multiply-adds, four `f64` or eight `f32` at a time.
    Avx2,
    /// AVX-512F, eight `f64` or sixteen `f32` at a time. Results equal those of
    /// [`Avx2`](Self::Avx2) in all bits. AVX-512F helps mainly multiplications, because its divider
    /// is no faster than AVX2's.
    Avx512,
    /// NEON on 64-bit Arm, two `f64` or four `f32` at a time. Results equal those of
    /// [`Avx2`](Self::Avx2) in all bits.
    Neon,
}

impl Level {
    /// Returns whether this processor supports the instruction set.
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

    /// Returns the highest instruction set of this processor, the default of ensembles.
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
    /// The division instruction, which rounds correctly.
    #[default]
    Divided,
    /// On [`Level::Avx512`], the processor's 14-bit estimate refined by Newton's iteration, twice
    /// for `f64` and once for `f32`. On other instruction sets and for other scalars, this equals
    /// [`Divided`](Self::Divided).
    ///
    /// The estimate is up to a third faster in a step that does little but divide (Lotka–Volterra).
    /// The estimate is no faster if multiplications limit the speed. The result differs from the
    /// correctly rounded reciprocal by at most one unit in the last place. For random operands the
    /// difference occurs in one case of 900 for `f64`, and in one of 340 for `f32`. If the operand
    /// or the reciprocal is infinite, the result is NaN. Poles and overflowing denominators
    /// therefore stay visible.
    Estimated,
}

/// The choices that determine the bits of an ensemble's results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instructions {
    pub(crate) level: Level,
    pub(crate) reciprocal: Reciprocal,
}
