//! Tests maps of more than eight variables, whose steps use sparse elimination.

mod exactly;
mod floats;
mod systems;
mod worst;
