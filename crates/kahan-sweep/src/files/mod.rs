//! The files of a sweep: parts, journals and the merged result.
//!
//! A part holds the rows of a fixed range of indices as one Parquet row group. The metadata of a
//! part contain the plan, the program's version, the floating-point mode, and a checksum.

mod journal;
mod merge;
mod part;
mod status;
mod table;

pub(crate) use journal::Journal;
pub(crate) use merge::{RESULTS_FILE, merge};
pub(crate) use part::{Part, UnusablePart, folder_is_writable};
pub(crate) use status::{Status, ranges, status};
pub(crate) use table::{TableError, numbers, table};
