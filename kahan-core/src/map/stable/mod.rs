//! The step that promises: an error of at most 64 u of the largest component, or an error value.
//!
//! In: a map, a point and ε as given. Out: x̃ with ‖x̃ − exact‖∞ ≤ 64 u ‖exact‖∞, established for
//! this very call, or why not. There is one way to establish it and one formula for the step: the
//! kernel of the fast step runs over bounded values, first in the scalar's own precision, and where
//! that is too little in wider ones. Nothing is estimated from thresholds.
//!
//! | rung | values | what it settles |
//! |---|---|---|
//! | 1 | the scalar itself | ordinary points, at less than twice the operations of a step |
//! | 2 | `f64` for `f32`, [`Dd`](crate::Dd) for `f64` | cancellation: near poles, large ε |
//! | 3 | 17 digits of 64 bits, wherever these lie | overflow, underflow, extreme cancellation, by the increment form |
//! | 4 | the same | the form N/D, where increments cancel against the state |
//! | 5 | 256 digits, with `std` | elimination on A(x,ε), where terms of the other forms are too far apart |

mod attempt;
mod rungs;
mod scalars;
#[cfg(all(test, feature = "exact"))]
mod tests;

pub(super) use rungs::{beyond, higher, in_next_wider, in_own_precision, in_wide};
pub(crate) use scalars::Promised;
pub(super) use scalars::Widened;
