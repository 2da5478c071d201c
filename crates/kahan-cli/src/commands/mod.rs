//! The commands, one file each: arguments in, an [`Answer`](crate::printing::Answer) or a
//! [`Refusal`](crate::printing::Refusal) out.

pub(crate) mod atlas;
pub(crate) mod chart;
pub(crate) mod completions;
pub(crate) mod discover;
pub(crate) mod dynamics;
pub(crate) mod eval;
pub(crate) mod extremes;
pub(crate) mod heights;
mod line;
pub(crate) mod list;
mod look;
pub(crate) mod orbit;
pub(crate) mod page;
pub(crate) mod periodic;
pub(crate) mod picture;
pub(crate) mod poles;
pub(crate) mod scan;
mod search;
pub(crate) mod section;
pub(crate) mod show;
pub(crate) mod sweep;
pub(crate) mod trade;
pub(crate) mod verify;
