//! One type for run-time systems of up to [`LARGEST_DIMENSION`] variables.
//!
//! Generic code is compiled for the largest dimension; smaller systems are padded with constant
//! variables ([`Map::as_padded_kahan_map`]). A type for each dimension would multiply compile time.

use kahan_core::Scalar;

use super::Interpreted;
use crate::Map;

/// The largest number of variables of a [`Padded`] system.
pub const LARGEST_DIMENSION: usize = 8;

/// A run-time system padded to [`LARGEST_DIMENSION`] variables; made by
/// [`Map::as_padded_kahan_map`].
pub type Padded<T> = Interpreted<T, LARGEST_DIMENSION>;

/// The error that a field has more variables than [`LARGEST_DIMENSION`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnsupportedDimension(
    /// The number of variables.
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
    /// Returns the map over any scalar, as a [`KahanMap`](kahan_core::KahanMap) padded to
    /// [`LARGEST_DIMENSION`] variables; the added variables stay constant.
    ///
    /// # Errors
    /// [`UnsupportedDimension`] if the field has more than [`LARGEST_DIMENSION`] variables.
    pub fn as_padded_kahan_map<T: Scalar>(&self) -> Result<Padded<T>, UnsupportedDimension> {
        self.as_kahan_map().map_err(|why| UnsupportedDimension(why.expected()))
    }
}
