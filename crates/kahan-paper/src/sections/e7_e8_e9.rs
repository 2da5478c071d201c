//! Section 6: dE7 and dE8 with gamma and digamma functions, and the quadrature of E9.

mod e7;
mod e8;
mod e9;

use super::super::claim::Claim;

pub(super) fn claims() -> Vec<Claim> {
    [e7::claims(), e8::claims(), e9::claims()].concat()
}
