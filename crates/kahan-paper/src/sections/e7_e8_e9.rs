//! Claims of section 6 about dE7 and dE8, and about the orbits of the flow E9 as functions of time.

mod e7;
mod e8;
mod e9;

use super::super::claim::Claim;

pub(super) fn claims() -> Vec<Claim> {
    [e7::claims(), e8::claims(), e9::claims()].concat()
}
