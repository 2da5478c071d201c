//! Sweeps: runs of Kahan's maps for many initial states, parameters and ε, on any number of
//! machines.
//!
//! A plan in TOML ([`Plan`]) determines one Parquet file. The bytes of the file depend on the plan,
//! the version of the program and its floating-point mode. The rows are computed in parts, which
//! are fixed ranges of indices, and then merged.

mod command;
mod estimate;
mod files;
mod launcher;
mod plan;
mod run;
mod scripts;

pub use command::run;
pub use plan::Plan;
