//! Orbits that are observed side by side have the points and the reports that each has alone.

mod drifts;
mod observed;
mod orbits;
mod support;
