//! Output: answers and refusals, tables and text that fit on the screen, and files.

mod interrupt;
pub(crate) mod layout;
mod npy;
mod output;
mod output_stream;
pub(crate) mod page;
mod progress_display;
mod table;

pub(crate) use npy::Npy;
pub(crate) use output::{Answer, UsageError, csv, finish, joined, warn};
pub(crate) use output_stream::{OutputStream, WriteError, is_table};
pub(crate) use progress_display::ProgressDisplay;
pub(crate) use table::{Format, Table};
