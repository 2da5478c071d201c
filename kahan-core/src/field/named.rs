//! Names and proved integrals of a generated system, for code that is generic over systems.

use nalgebra::SVector;

use crate::Scalar;

/// The names of a system's variables and parameters, as written in the `kahan!` block.
pub trait Named {
    /// Returns the names of the state variables, in the order of the entries of a state.
    fn variables(&self) -> &'static [&'static str];

    /// Returns the names of the parameters, in the order of their declaration.
    fn parameters(&self) -> &'static [&'static str] {
        &[]
    }
}

/// A map on Tᴺ with M proved integrals, functions of the state and ε that a step conserves.
pub trait Integrals<T: Scalar, const N: usize, const M: usize> {
    /// Returns the names of the integrals, in the order of their values.
    fn integral_names(&self) -> &'static [&'static str];

    /// Returns the values of the integrals at x. `eps` is the half time step of the map.
    ///
    /// At a pole of an integral, a float is infinite or NaN. An exact scalar panics.
    fn integrals(&self, x: &SVector<T, N>, eps: T) -> SVector<T, M>;
}
