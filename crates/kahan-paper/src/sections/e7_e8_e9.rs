//! Claims of section 6 about dE7 and dE8, and about E9: the orbits of its flow, and the fixed
//! points of flow and map.

mod e7;
mod e8;
mod e9;

use super::super::claim::Claim;

pub(super) fn claims() -> Vec<Claim> {
    [e7::claims(), e8::claims(), e9::claims()].concat()
}
