//! Tests of maps of fields that are read at run time; states are slices.

mod catalog;
mod coefficients;
mod columns;
mod couplings;
mod derivatives;
mod errors;
mod follow;
mod gradient;
mod large;
mod passed_poles;
mod random;
mod support;
mod threads;
