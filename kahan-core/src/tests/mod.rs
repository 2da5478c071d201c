//! The laws of the method on some systems, one topic a file.
//!
//! Over rationals every law is tested with `==`; over floats only what floats promise.

mod by_hand;
mod constants;
mod dd;
mod duals;
mod floats;
mod hygiene;
mod linear;
mod modes;
mod orbits;
mod overflow;
#[cfg(feature = "std")]
mod projective;

#[cfg(feature = "exact")]
mod exact_laws;
#[cfg(feature = "exact")]
mod exact_linear;
#[cfg(feature = "exact")]
mod exact_poles;
#[cfg(feature = "exact")]
mod order_conditions;
#[cfg(feature = "exact")]
mod rationals;
