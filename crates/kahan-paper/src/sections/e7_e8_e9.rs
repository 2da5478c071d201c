//! Claims of section 6 about dE7, dE8, and the orbits of E9 with the time along them.

mod e7;
mod e8;
mod e9;

use super::super::claim::Claim;

pub(super) fn claims() -> Vec<Claim> {
    [e7::claims(), e8::claims(), e9::claims()].concat()
}
