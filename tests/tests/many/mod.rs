//! More than eight variables: steps by elimination along the couplings.

mod exactly;
mod floats;
mod systems;
mod worst;
