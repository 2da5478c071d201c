//! Orbits observed side by side have the points and reports of single orbits.

mod drifts;
mod observed;
mod orbits;
mod support;
