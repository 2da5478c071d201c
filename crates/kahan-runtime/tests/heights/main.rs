//! The Diophantine test: heights to 15 digits, growth classes, poles and bounds.

mod any_field;
mod catalog;
mod support;
