//! The sets of instructions that code is made of, and the floats it is made for.

use crate::Refusal;
use crate::assembler::{Element, Form, Width};

/// An extension by Intel's name, and whether this processor has it and its system keeps its
/// registers.
type Extension = (&'static str, fn() -> bool);

/// A set of instructions; of one processor, a later one is larger.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum InstructionSet {
    /// AVX: sixteen registers, used with 128 bits.
    Avx,
    /// AVX2 and FMA: sixteen registers of 256 bits, fused multiply-adds.
    Avx2,
    /// AVX-512F and AVX-512VL: thirty-two registers of 512 bits, also used with fewer.
    Avx512,
    /// A64 with Advanced SIMD, which every 64-bit Arm has: thirty-two registers of 128 bits, fused
    /// multiply-adds.
    Neon,
}

impl InstructionSet {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Avx, Self::Avx2, Self::Avx512, Self::Neon];

    /// The smallest for this processor that has what one number at a time takes.
    #[must_use]
    pub const fn least(fuses: bool) -> Self {
        match (cfg!(target_arch = "aarch64"), fuses) {
            (true, _) => Self::Neon,
            (false, true) => Self::Avx2,
            (false, false) => Self::Avx,
        }
    }

    /// Whether this processor can run it, its system keeps the registers, and there is memory for
    /// code.
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

    /// Whether the rules of this system are known by which code is made and called. On 64-bit Arm
    /// they are those of Linux: elsewhere pages want other calls before code may run in them
    /// (`MAP_JIT` on macOS), or nobody has tried.
    ///
    /// # Errors
    /// [`Refusal::System`].
    pub(crate) fn may_run(self) -> Result<(), Refusal> {
        let is_known = cfg!(all(any(target_os = "linux", target_os = "android"), target_endian = "little"));
        if self == Self::Neon && cfg!(target_arch = "aarch64") && !is_known {
            return Err(Refusal::System);
        }
        Ok(())
    }

    /// The extensions whose instructions code is made of. Code of a larger set also has
    /// instructions of the smaller ones, wherever these are shorter.
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
            // A register beyond the first sixteen takes the form of AVX-512 for any width, and
            // forms of less than 512 bits are those of AVX-512VL.
            Self::Avx512 => extensions!["avx", "avx2", "fma", "avx512f", "avx512vl"],
            Self::Neon => &[],
        }
    }

    /// Whether it has multiply-adds that are rounded once.
    #[must_use]
    pub fn has_fused(self) -> bool {
        self != Self::Avx
    }

    /// The largest that this processor can run; `None` where it can run none.
    #[must_use]
    pub fn best() -> Option<Self> {
        Self::ALL.into_iter().rev().find(|set| set.is_available())
    }

    pub(crate) fn registers(self) -> u8 {
        match self {
            Self::Avx | Self::Avx2 => 16,
            Self::Avx512 => 32,
            // Two hold what an instruction needs on the way.
            Self::Neon => 30,
        }
    }
}

/// How many numbers an instruction works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LaneCount {
    /// One.
    One,
    /// As many as a register holds.
    All,
}

/// What code is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shape {
    /// Its instructions.
    pub instructions: InstructionSet,
    /// How many numbers each of them works on.
    pub lanes: LaneCount,
    /// Whether multiply-adds are rounded once.
    pub fuses: bool,
}

impl Shape {
    /// How many numbers of the type `T` an instruction works on.
    #[must_use]
    pub fn width<T: Float>(self) -> usize {
        self.form::<T>().bytes() / size_of::<T>()
    }

    pub(crate) fn form<T: Float>(self) -> Form {
        let width = match (self.lanes, self.instructions) {
            (LaneCount::One, _) => Width::Scalar,
            (LaneCount::All, InstructionSet::Avx | InstructionSet::Neon) => Width::Bits128,
            (LaneCount::All, InstructionSet::Avx2) => Width::Bits256,
            (LaneCount::All, InstructionSet::Avx512) => Width::Bits512,
        };
        let element = if T::IS_DOUBLE { Element::Double } else { Element::Single };
        Form { element, width }
    }
}

mod sealed {
    pub trait Sealed {
        const IS_DOUBLE: bool;
    }
}

pub(crate) use sealed::Sealed;

/// The machine's floats: `f32` and `f64`.
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

    /// Tests of code pass over sets that a processor lacks, so that what is said of it is pinned
    /// here, with the processor's own words.
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
        // A larger set has all that a smaller one has.
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
