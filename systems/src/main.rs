//! The kahan command.
fn main() {}
