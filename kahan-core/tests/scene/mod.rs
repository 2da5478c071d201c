//! Tests how the library chooses a setting: composition, precision and number of steps.
//!
//! Costs are counted by a model and not by a clock, so that every run gives equal numbers.

mod answers;
mod choices;
mod counted;
mod trajectory;
