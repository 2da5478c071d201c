//! kahan-core as its users write it. One program, so that what its modules share is compiled and
//! linked once.

mod any_map;
mod closed_solutions;
mod ensemble;
mod examples;
mod lattices;
mod lifts;
mod observe;
mod scene;
mod systems;
