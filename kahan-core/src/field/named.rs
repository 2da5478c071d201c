//! Names and proved integrals of a generated system, for generic code.
//!
//! In: a map. Out: names in the order of the vectors' entries, and the values of integrals.

use nalgebra::SVector;

use crate::Scalar;

/// The names of a system's variables and parameters, as written in the source.
pub trait Named {
    /// Returns the state variables, in the order of a state's entries.
    fn variables(&self) -> &'static [&'static str];

    /// Returns the parameters, in the order of declaration; none by default.
    fn parameters(&self) -> &'static [&'static str] {
        &[]
    }
}

/// A map on Tᴺ with M declared integrals: functions of state and ε that a step preserves.
pub trait Integrals<T: Scalar, const N: usize, const M: usize> {
    /// Returns the names of the integrals, in the order of the values.
    fn integral_names(&self) -> &'static [&'static str];

    /// Returns the integrals at x, for the map with half time step `eps`.
    ///
    /// At a pole of an integral, a float is not finite and an exact scalar panics.
    fn integrals(&self, x: &SVector<T, N>, eps: T) -> SVector<T, M>;
}
