//! From a number of variables that is known at run time to types, whose dimension is a constant.
//!
//! Two types serve all: what is generic over maps is compiled for 4 and for 8 variables, and
//! smaller systems are [padded](super::Interpreted::padded). A type for every number of variables
//! took four times as long to compile.

/// What is to be done in some dimension.
pub trait VisitDimension {
    /// What comes out.
    type Output;

    /// Does it in N variables, at least as many as were asked for.
    fn visit<const N: usize>(self) -> Self::Output;
}

/// The most variables that a system read at run time may have where types are needed.
pub const LARGEST_DIMENSION: usize = 8;

/// More variables than there are types for, or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnsupportedDimension(
    /// The variables.
    pub usize,
);

impl core::fmt::Display for UnsupportedDimension {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(
            f,
            "the field has {} variables, and this works for 1 to {LARGEST_DIMENSION}; a program of your own, with `kahan!`, has no \
             such limit",
            self.0
        )
    }
}

impl core::error::Error for UnsupportedDimension {}

/// Does it in the fewest variables that there is a type for and that hold `dimension`.
///
/// # Errors
/// [`UnsupportedDimension`] beyond [`LARGEST_DIMENSION`].
pub fn visit_dimension<V: VisitDimension>(
    dimension: usize,
    visitor: V,
) -> Result<V::Output, UnsupportedDimension> {
    match dimension {
        1..=4 => Ok(visitor.visit::<4>()),
        5..=LARGEST_DIMENSION => Ok(visitor.visit::<LARGEST_DIMENSION>()),
        other => Err(UnsupportedDimension(other)),
    }
}
