//! The Diophantine test: heights to 15 digits, growth classes, poles, bounds, and the command `kahan heights`.

#[path = "heights/catalog.rs"]
mod catalog;
#[path = "heights/command.rs"]
mod command;
#[path = "heights/fields.rs"]
mod fields;
#[path = "heights/support.rs"]
mod support;
