//! Sweeps: Kahan's maps for many initial states, parameters and ε, on any number of machines.
//!
//! In: a plan in TOML ([`Plan`], a question over axes). Out: one Parquet file, whose bytes depend
//! only on the plan. Its rows are computed in parts, fixed ranges of indices, which are then
//! merged. Finding, sharing and restarting machines is left to schedulers, which start this program
//! with a shard's number.

mod command;
mod estimate;
mod files;
mod launcher;
mod plan;
mod run;
mod scripts;

pub use command::run;
pub use plan::Plan;
