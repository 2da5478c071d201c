//! What Kahan's method costs and how accurate it is, measured.
//!
//! In: a system, a point, a horizon. Out: a trajectory of the flow that two independent methods
//! agree on ([`mod@reference`]), the price and the error of every setting of the integrator
//! ([`trade`]), and verdicts on single steps near poles and with extreme numbers ([`extremes`]). It
//! must not know the command: nothing here reads arguments or prints.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod extremes;
mod map;
pub mod random_fields;
#[expect(clippy::disallowed_methods, reason = "a trajectory still ends by the machine's clock")]
pub mod reference;
#[expect(clippy::disallowed_methods, reason = "a study still ends by the machine's clock")]
pub mod trade;
