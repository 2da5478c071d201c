//! What orbits show: relations along them and how many integrals these stand for, the growth of the
//! degrees of iterates, and Hirota–Kimura bases.

pub mod basis;
pub mod ceiling;
pub mod degrees;
pub mod growth;
pub mod hilbert;
pub mod plane;
pub mod relations;
