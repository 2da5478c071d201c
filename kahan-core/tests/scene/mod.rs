//! Tests the library's choice of a setting.
//!
//! # Modules
//! 1. `choices`: on scenes of five systems the chosen setting meets its tolerance, compared with a
//!    double-double trajectory. No setting of a third of its cost does. The map's integrals are
//!    conserved to the tolerance.
//! 2. `answers`: tests refusals, printed settings, and runs of the printed settings.
//! 3. `counted`: counts the cost of choosing.
//!
//! Costs are counted by a model and not by a clock; therefore every run gives equal numbers.

mod answers;
mod choices;
mod counted;
mod trajectory;
