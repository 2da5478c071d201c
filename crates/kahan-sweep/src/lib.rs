//! Sweeps: Kahan's map from many starts, at many parameters and ε, on any number of machines.
//!
//! In: a plan in TOML. Out: one file of Parquet, whose bytes the plan alone decides. It must not
//! know how machines are found, shared or restarted: schedulers do that, and start this program
//! with the number of a shard.
//!
//! Data flows one way: a [`Plan`] is a question over axes, whose rows a study gives, a run makes
//! parts of rows, and parts are merged. A part is the rows of a fixed range of indices.

mod command;
mod estimate;
mod files;
mod launcher;
mod plan;
mod run;
mod scripts;

pub use command::run;
pub use plan::Plan;
