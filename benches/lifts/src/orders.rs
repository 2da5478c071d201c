//! Orders of convergence.
pub(crate) fn orders() {}
