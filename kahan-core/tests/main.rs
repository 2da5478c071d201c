//! Tests kahan-core through its public interface, in one program that compiles shared code once.

mod any_map;
mod closed_solutions;
mod ensemble;
mod examples;
mod lattices;
mod lifts;
mod observe;
mod scene;
mod systems;
