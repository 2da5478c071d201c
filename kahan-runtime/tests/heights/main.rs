//! The Diophantine test: heights to 15 digits, growth classes, poles, and bounds.

mod catalog;
mod fields;
mod support;
