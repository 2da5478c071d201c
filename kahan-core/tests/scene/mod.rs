//! The library's choice of a stepper.
//!
//! 1. `choices`: on scenes of five systems the chosen setting meets its tolerance, against a
//!    trajectory in double-double, and no setting whose model cost is a third of its own does; the
//!    map's own integrals are kept as well as was asked for.
//! 2. `answers`: what it says where there is no choice, what it prints, and that it runs what it
//!    prints.
//!
//! 3. `counted`: what it costs.
//!
//! No clock: costs are the model's, and every run gives the same numbers.

mod answers;
mod choices;
mod counted;
mod trajectory;
