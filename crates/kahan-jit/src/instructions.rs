//! Instruction sets and shapes of compiled code.

use crate::CompileError;
use crate::assembler::{Element, OperandForm, Width};

/// An extension: Intel's name, and a test whether processor and operating system support it.
type Extension = (&'static str, fn() -> bool);

/// An instruction set of a processor. Later sets of an architecture include earlier sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum InstructionSet {
    /// AVX, with sixteen registers, of which 128 bits are used.
    Avx,
    /// AVX2 and FMA, with sixteen registers of 256 bits and fused multiply-adds.
    Avx2,
    /// AVX-512F and AVX-512VL, with thirty-two registers of 512 bits or less.
    Avx512,
    /// A64 with Advanced SIMD, with 32 registers of 128 bits and fused multiply-adds.
    Neon,
}

impl InstructionSet {
    /// All instruction sets.
    pub const ALL: [Self; 4] = [Self::Avx, Self::Avx2, Self::Avx512, Self::Neon];

    /// Returns the smallest instruction set of this architecture that suffices for scalar code, and
    /// for fused multiply-adds if `fuses` is true.
    #[must_use]
    pub const fn least(fuses: bool) -> Self {
        match (cfg!(target_arch = "aarch64"), fuses) {
            (true, _) => Self::Neon,
            (false, true) => Self::Avx2,
            (false, false) => Self::Avx,
        }
    }

    /// Returns whether code of this instruction set can run here. Requires the feature `pages`.
    #[must_use]
    pub fn is_available(self) -> bool {
        let is_of_this = match self {
            Self::Avx | Self::Avx2 | Self::Avx512 => cfg!(target_arch = "x86_64"),
            Self::Neon => cfg!(target_arch = "aarch64") && self.may_run().is_ok(),
        };
        cfg!(feature = "pages")
            && is_of_this
            && self.extensions().iter().all(|(_, is_detected)| is_detected())
    }

    /// Checks that run-time code is supported. On 64-bit Arm, only Linux and Android support it.
    pub(crate) fn may_run(self) -> Result<(), CompileError> {
        let is_known = cfg!(all(any(target_os = "linux", target_os = "android"), target_endian = "little"));
        if self == Self::Neon && cfg!(target_arch = "aarch64") && !is_known {
            return Err(CompileError::System);
        }
        Ok(())
    }

    /// Returns the extensions that the code needs, including those of smaller sets, whose
    /// instructions it also uses.
    pub(crate) fn extensions(self) -> &'static [Extension] {
        #[cfg(target_arch = "x86_64")]
        macro_rules! extensions {
            ($($name:tt),*) => { &[$(($name, || std::arch::is_x86_feature_detected!($name))),*] };
        }
        #[cfg(not(target_arch = "x86_64"))]
        macro_rules! extensions {
            ($($name:tt),*) => {
                &[]
            };
        }
        match self {
            Self::Avx => extensions!["avx"],
            Self::Avx2 => extensions!["avx", "avx2", "fma"],
            // Registers 16 to 31 need AVX-512F. Instructions on less than 512 bits of them also
            // need AVX-512VL.
            Self::Avx512 => extensions!["avx", "avx2", "fma", "avx512f", "avx512vl"],
            Self::Neon => &[],
        }
    }

    /// Returns whether the instruction set has fused multiply-adds.
    #[must_use]
    pub fn has_fused(self) -> bool {
        self != Self::Avx
    }

    /// Returns the largest available instruction set.
    #[must_use]
    pub fn best() -> Option<Self> {
        Self::ALL.into_iter().rev().find(|set| set.is_available())
    }

    pub(crate) fn registers(self) -> u8 {
        match self {
            Self::Avx | Self::Avx2 => 16,
            Self::Avx512 => 32,
            // The assembler reserves two of the 32 registers as temporaries.
            Self::Neon => 30,
        }
    }
}

/// Whether an instruction works on one lane of a register or on all lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LaneCount {
    /// One lane of a register.
    One,
    /// All lanes of a register.
    All,
}

/// The form of compiled code: instruction set, lanes and fusing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shape {
    /// The instruction set of the code.
    pub instructions: InstructionSet,
    /// The lanes on which each instruction works.
    pub lanes: LaneCount,
    /// Whether the code fuses multiply-adds.
    pub fuses: bool,
}

impl Shape {
    /// Returns the number of lanes of type `T` on which an instruction works.
    #[must_use]
    pub fn width<T: Float>(self) -> usize {
        self.form::<T>().bytes() / size_of::<T>()
    }

    pub(crate) fn form<T: Float>(self) -> OperandForm {
        let width = match (self.lanes, self.instructions) {
            (LaneCount::One, _) => Width::Scalar,
            (LaneCount::All, InstructionSet::Avx | InstructionSet::Neon) => Width::Bits128,
            (LaneCount::All, InstructionSet::Avx2) => Width::Bits256,
            (LaneCount::All, InstructionSet::Avx512) => Width::Bits512,
        };
        let element = if T::IS_DOUBLE { Element::Double } else { Element::Single };
        OperandForm { element, width }
    }
}

mod sealed {
    pub trait Sealed {
        const IS_DOUBLE: bool;
    }
}

pub(crate) use sealed::Sealed;

/// A floating-point type of the processor, `f32` or `f64`.
pub trait Float: Copy + Send + Sync + Sealed + 'static {}

impl Sealed for f32 {
    const IS_DOUBLE: bool = false;
}

impl Sealed for f64 {
    const IS_DOUBLE: bool = true;
}

impl Float for f32 {}
impl Float for f64 {}

#[cfg(test)]
mod tests {
    use super::InstructionSet;

    #[cfg(all(target_arch = "x86_64", feature = "pages"))]
    #[test]
    fn a_set_is_available_where_all_of_its_extensions_are() {
        const OWN: [InstructionSet; 3] = [InstructionSet::Avx, InstructionSet::Avx2, InstructionSet::Avx512];

        let available = OWN.map(|set| {
            let all = set.extensions().iter().all(|(_, is_detected)| is_detected());
            assert_eq!(set.is_available(), all, "{set:?}");
            all
        });
        assert_eq!(available[0], std::arch::is_x86_feature_detected!("avx"));
        assert!(available.is_sorted_by(|smaller, larger| smaller >= larger), "{available:?}");
        let count = available.iter().filter(|&&is_available| is_available).count();
        assert_eq!(InstructionSet::best(), count.checked_sub(1).map(|last| OWN[last]));
    }

    #[cfg(all(target_arch = "aarch64", target_os = "linux", feature = "pages"))]
    #[test]
    fn every_arm_of_64_bits_has_its_set() {
        assert_eq!(InstructionSet::best(), Some(InstructionSet::Neon));
        assert_eq!(InstructionSet::ALL.map(InstructionSet::is_available), [false, false, false, true]);
    }

    #[test]
    fn all_but_the_smallest_set_fuse() {
        assert_eq!(InstructionSet::ALL.map(InstructionSet::has_fused), [false, true, true, true]);
    }
}
