//! The library's choice of a setting.
//!
//! 1. `choices`: on scenes of five systems the chosen setting meets its tolerance against a
//!    double-double trajectory, and no setting of a third of its model cost does. The map's integrals are conserved
//!    to the tolerance.
//! 2. `answers`: refusals, printed settings, and running what was printed.
//! 3. `counted`: the cost of choosing.
//!
//! Costs are those of the model, not of a clock, so every run gives equal numbers.

mod answers;
mod choices;
mod counted;
mod trajectory;
