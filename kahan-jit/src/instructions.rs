//! The sets of instructions that code is made of, and the floats it is made for.

use crate::assembler::{Element, Form, Width};

/// A set of instructions; a later one is larger.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum InstructionSet {
    /// AVX: sixteen registers, used with 128 bits.
    Avx,
    /// AVX2 and FMA: sixteen registers of 256 bits, fused multiply-adds.
    Avx2,
    /// AVX-512F: thirty-two registers of 512 bits.
    Avx512,
}

impl InstructionSet {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Avx, Self::Avx2, Self::Avx512];

    /// Whether this processor can run it, and its system keeps the registers.
    #[must_use]
    pub fn is_available(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        return match self {
            Self::Avx => std::arch::is_x86_feature_detected!("avx"),
            Self::Avx2 => {
                std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
            }
            Self::Avx512 => std::arch::is_x86_feature_detected!("avx512f"),
        };
        #[cfg(not(target_arch = "x86_64"))]
        false
    }

    /// Whether it has multiply-adds that are rounded once.
    #[must_use]
    pub fn has_fused(self) -> bool {
        self > Self::Avx
    }

    /// The largest that this processor can run; `None` where it can run none.
    #[must_use]
    pub fn best() -> Option<Self> {
        Self::ALL.into_iter().rev().find(|set| set.is_available())
    }

    pub(crate) fn registers(self) -> u8 {
        if self == Self::Avx512 { 32 } else { 16 }
    }
}

/// How many numbers an instruction works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lanes {
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
    pub lanes: Lanes,
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
            (Lanes::One, _) => Width::Scalar,
            (Lanes::All, InstructionSet::Avx) => Width::Bits128,
            (Lanes::All, InstructionSet::Avx2) => Width::Bits256,
            (Lanes::All, InstructionSet::Avx512) => Width::Bits512,
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
