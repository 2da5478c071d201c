//! The `kahan` command from outside: what it prints, and with which exit status. A module for each
//! subcommand, and for what is common to all.

mod arrays;
mod atlas_folders;
#[cfg(unix)]
mod beginning;
mod completions;
mod conditions;
mod discovering;
mod double_double;
mod dynamics;
mod evaluating;
mod heights;
mod interrupting;
mod judging;
mod latex;
mod lifting;
mod limits;
mod numbers;
mod orbit;
mod page;
mod painting;
mod parameters;
mod periodic;
mod picture;
mod plan;
mod poles;
mod refusing;
mod regressions;
mod running;
mod rust_files;
mod showing;
#[cfg(unix)]
mod sweeping;
mod terminals;
mod texts;
mod trade;
mod units;
mod verifying;
