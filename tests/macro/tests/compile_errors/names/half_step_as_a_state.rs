//! `eps` is the half time step in every claim.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    epsdot = -eps;
}

fn main() {}
