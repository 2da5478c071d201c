//! Claims of section 6, on dE7 and dE8, and on the quadrature of E9.

mod e7;
mod e8;
mod e9;

use super::super::claim::Claim;

pub(super) fn claims() -> Vec<Claim> {
    [e7::claims(), e8::claims(), e9::claims()].concat()
}
