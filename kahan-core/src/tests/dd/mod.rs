//! Compares double-double numbers with exact numbers: bounds, special values, text.

#[cfg(feature = "exact")]
mod bounds;
#[cfg(feature = "exact")]
mod dyadic;
#[cfg(feature = "exact")]
mod elementary;
#[cfg(feature = "exact")]
mod operands;
mod specials;
mod text;
#[cfg(feature = "exact")]
mod text_exact;
