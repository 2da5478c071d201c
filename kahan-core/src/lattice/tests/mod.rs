//! Families as the macro writes them, and the laws of their steps.

#[cfg(feature = "exact")]
mod exact;
mod families;
mod parts;
