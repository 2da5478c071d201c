//! Energies.
pub(crate) fn energy() {}
pub(crate) fn projection() {}
