//! The command `kahan`: its output and exit status, with a module for each subcommand and topic.

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
