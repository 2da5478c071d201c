//! The files of a sweep: parts, what is under way, and the merged result.
//!
//! A part holds the rows of a fixed range of indices as one row group of Parquet, and appears whole
//! or not at all. Nothing else decides its bytes but the plan, the version of this program and how
//! floats are computed; all three stand in it, with a checksum.

mod journal;
mod merge;
mod part;
mod status;
mod table;

pub(crate) use journal::Journal;
pub(crate) use merge::{RESULTS, merge};
pub(crate) use part::{Part, Unusable, folder_is_writable};
pub(crate) use status::{Status, ranges, status};
pub(crate) use table::{NoTable, numbers, table};
