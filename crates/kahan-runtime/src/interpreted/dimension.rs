//! A number of variables that is known at run time, as a type.
//!
//! One type serves all: what is generic over maps is compiled for the most variables, and smaller
//! systems are [padded](Interpreted::padded). A type for every number of variables would take eight
//! times as long to compile, and a step is interpreted line by line, so it is no slower among
//! variables that stand still.

use kahan_core::Scalar;

use super::Interpreted;
use crate::Map;

/// The most variables that a system read at run time may have where a type is needed.
pub const LARGEST_DIMENSION: usize = 8;

/// A system read at run time among [`LARGEST_DIMENSION`] variables; made by
/// [`Map::as_padded_kahan_map`].
pub type Padded<T> = Interpreted<T, LARGEST_DIMENSION>;

/// More variables than there is a type for.
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

impl Map {
    /// The map as a [`KahanMap`](kahan_core::KahanMap) over any scalar, in a type that holds
    /// whatever number of variables is supported: those beyond its own stand still.
    ///
    /// # Errors
    /// [`UnsupportedDimension`] beyond [`LARGEST_DIMENSION`].
    pub fn as_padded_kahan_map<T: Scalar>(&self) -> Result<Padded<T>, UnsupportedDimension> {
        self.as_kahan_map().map_err(|why| UnsupportedDimension(why.expected()))
    }
}
