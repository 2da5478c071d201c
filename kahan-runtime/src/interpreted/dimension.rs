//! From a number of variables that is known at run time to the types, whose dimension is a constant.

/// What is to be done in some dimension.
pub trait VisitDimension {
    /// What comes out.
    type Output;

    /// Does it in N variables.
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

/// Does it in `dimension` variables.
///
/// # Errors
/// [`UnsupportedDimension`] beyond [`LARGEST_DIMENSION`].
pub fn visit_dimension<V: VisitDimension>(
    dimension: usize,
    visitor: V,
) -> Result<V::Output, UnsupportedDimension> {
    Ok(match dimension {
        1 => visitor.visit::<1>(),
        2 => visitor.visit::<2>(),
        3 => visitor.visit::<3>(),
        4 => visitor.visit::<4>(),
        5 => visitor.visit::<5>(),
        6 => visitor.visit::<6>(),
        7 => visitor.visit::<7>(),
        8 => visitor.visit::<8>(),
        other => return Err(UnsupportedDimension(other)),
    })
}
