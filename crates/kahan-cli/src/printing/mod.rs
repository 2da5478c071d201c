//! Output: answers and refusals, tables and text that fit the screen, and files.

mod interrupt;
pub(crate) mod layout;
mod npy;
mod output;
pub(crate) mod page;
mod prompt;
mod sink;
mod table;

pub(crate) use npy::Npy;
pub(crate) use output::{Answer, Refusal, csv, finish, joined, warn};
pub(crate) use prompt::Prompt;
pub(crate) use sink::{Broken, Sink, is_table};
pub(crate) use table::{Format, Table};
