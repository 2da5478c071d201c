//! Tests maps of more than eight variables, whose steps use elimination along the couplings.

mod exactly;
mod floats;
mod systems;
mod worst;
