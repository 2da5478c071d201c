//! What a generated system knows of its own text: names, and the integrals it was proved to have.
//!
//! In: a map. Out: names in the order of the vectors' entries, and the integrals' values. Generic
//! code goes through these traits; code that has the type at hand uses its constants and inherent
//! methods.

use nalgebra::SVector;

use crate::Scalar;

/// The names of a system's variables and parameters, as its author wrote them.
pub trait Named {
    /// The state variables, in the order of a state's entries.
    fn variables(&self) -> &'static [&'static str];

    /// The parameters, in the order they were declared; here, none.
    fn parameters(&self) -> &'static [&'static str] {
        &[]
    }
}

/// A map on Tᴺ with M declared integrals: functions of the state (and of ε) that a step leaves
/// unchanged.
pub trait Integrals<T: Scalar, const N: usize, const M: usize> {
    /// The integrals' names, in the order of the values.
    fn integral_names(&self) -> &'static [&'static str];

    /// The integrals at x, for the map whose ε, half the time step, is `eps`.
    ///
    /// Where an integral has a pole of its own, a float is not finite and an exact scalar panics.
    fn integrals(&self, x: &SVector<T, N>, eps: T) -> SVector<T, M>;
}
