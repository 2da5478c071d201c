//! Sweeps: Kahan's maps for many initial states, parameters and ε, on any number of machines. Takes
//! a plan in TOML; writes one Parquet file, whose bytes depend on the plan only. A [`Plan`] is a
//! question over axes. Runs compute its rows in parts, fixed ranges of indices, which are merged.
//! Schedulers find, share and restart machines; they start this program with a shard's number.

mod command;
mod estimate;
mod files;
mod launcher;
mod plan;
mod run;
mod scripts;

pub use command::run;
pub use plan::Plan;
