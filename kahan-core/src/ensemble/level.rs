//! Which instructions an ensemble runs on.
//!
//! In: what this processor has, found at run time. Out: one choice for a whole ensemble, and with
//! it the bits of its results. Other architectures than x86-64 and 64-bit Arm have one level only.

/// A set of instructions that the steps of an [`Ensemble`](crate::Ensemble) run on; a later one is
/// larger.
///
/// A level decides how many trajectories a register holds and whether multiply-adds are fused, so
/// it decides the last bits of a result; within one level they are the same on every run and every
/// machine that has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Level {
    /// Instructions that the program was compiled for: two `f64` or four `f32` at a time on x86-64 and 64-bit
    /// Arm, one at a time elsewhere. The arithmetic, fused or not, is that of
    /// [`KahanAt::step`](crate::KahanAt::step), bit for bit, unless that divides more than once, as
    /// in one or two variables, or divides by the time step: many trajectories wait for the divider
    /// rather than for each other, and take the form with one division and no other, so that a last
    /// digit may differ.
    Baseline,
    /// AVX2 with fused multiply-adds: four `f64` or eight `f32` at a time.
    Avx2,
    /// AVX-512F: eight `f64` or sixteen `f32` at a time, with the same bits as
    /// [`Avx2`](Self::Avx2). Its divider is no faster: it gains where multiplications are the
    /// bound, and little elsewhere.
    Avx512,
    /// NEON with fused multiply-adds, on 64-bit Arm: two `f64` or four `f32` at a time, with the
    /// same bits as [`Avx2`](Self::Avx2).
    Neon,
}

impl Level {
    /// Whether this processor can run it.
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

    /// The largest level that this processor can run: what ensembles use unless told otherwise.
    pub fn best() -> Self {
        [Self::Neon, Self::Avx512, Self::Avx2]
            .into_iter()
            .find(|level| level.is_available())
            .unwrap_or(Self::Baseline)
    }
}

/// How an ensemble computes the reciprocals of its denominators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Reciprocal {
    /// By the division instruction: correctly rounded.
    #[default]
    Divided,
    /// On [`Level::Avx512`] by the processor's estimate of 14 bits and Newton's iteration, twice
    /// for `f64`, once for `f32`; on other levels, and for other scalars, as
    /// [`Divided`](Self::Divided).
    ///
    /// It takes up to a third less time where a step does little but divide (Lotka and Volterra's),
    /// and none where multiplications are the bound. Over operands of all exponents, subnormal ones
    /// included, a reciprocal is off the correctly rounded one in one case of 900 for `f64` and of
    /// 340 for `f32`, and then by one unit in the last place. Where it is not finite (at 0, and
    /// where it overflows), and for infinite operands, it is not a number: a pole still shows, and
    /// so does a denominator that overflows, where a division would silently leave the point in its
    /// place.
    Estimated,
}

/// The choices that decide an ensemble's bits, made once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instructions {
    pub(crate) level: Level,
    pub(crate) reciprocal: Reciprocal,
}
