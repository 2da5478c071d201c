//! Blocks in included files, which must equal blocks written in place.

use kahan_core::prelude::*;

use crate::blocks::surroundings::{assert_kahan, ratio};

include_kahan!("included.kahan");

mod folder {
    kahan_core::include_kahan!("../surroundings/ring.kahan");
}

#[test]
fn a_block_in_a_file_is_that_block() {
    kahan! {
        /// The field of the included file.
        struct Same { rate }
        xdot = rate*x*(1 - y);
        ydot = rate*y*(x - 1);
    }
    let (x, next) = assert_kahan(&Pond { rate: ratio(1, 2) });
    assert_eq!(next, Same { rate: ratio(1, 2) }.step(&x, ratio(2, 7)));
    assert_eq!(Pond { rate: 0.0 }, Pond::default());
    let k = ratio(3, 1);
    let spring = include_kahan!("spring.kahan");
    assert_eq!(spring.k, k);
    assert_kahan(&spring);
    let mut chain = LatticeMap::at(&folder::Ring, 0.05, 4).unwrap();
    let mut x = [1.0_f64, 2.0, 1.0, 1.0];
    chain.step(&mut x);
    assert!(x[0] > 1.0 && x.iter().all(|x| x.is_finite()));
}
