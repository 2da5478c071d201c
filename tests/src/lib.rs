//! Modules that tests share: exact numbers, back ends, random fields, and rounding bounds.

pub mod back_end;
pub mod doubles;
pub mod exact;
pub mod expression;
pub mod maps;
pub mod oracle;
pub mod random_fields;
pub mod random_systems;
#[cfg(doctest)]
mod readmes;
pub mod rounding;
pub mod sources;
pub mod subject;
pub mod surface;
pub mod taylor;
