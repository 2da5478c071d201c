//! Tests the laws of the method on examples: exactly over rationals, with bounds over floats.

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
