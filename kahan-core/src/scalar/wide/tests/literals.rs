//! Compares literals with their exact ratios.

use std::boxed::Box;
use std::vec::Vec;

use num_bigint::BigInt;
use num_traits::Zero;

use super::{Dyadic, Random, Wide};
use crate::{Constant, Scalar};

/// Returns whether |w − p/q| ≤ r ≤ 2^unit·|p/q| for the constant p/q, where r is the radius of w.
fn is_close(wide: Wide, constant: &Constant<'_>, unit: i64) -> bool {
    let ratio = constant.to_ratio();
    let integer = |n: &BigInt| Dyadic { integer: n.clone(), exponent: 0 };
    let (p, q) = (integer(ratio.numer()), integer(ratio.denom()));
    let denominator = integer(&wide.denominator.into());
    let error = Dyadic::numerator(&wide).times(&q).minus(&p.times(&denominator));
    let radius = Dyadic::size(wide.radius()).times(&denominator).times(&q);
    assert!(error.is_within(&radius.scaled_up()), "{wide:?}");
    radius.is_within(&p.times(&denominator).scaled(unit))
}

#[test]
fn integers_and_short_ratios_are_exact() {
    for n in [0, 1, -1, 7, i64::MAX, i64::MIN] {
        let constant = Constant::integer(n);
        let difference =
            Dyadic::of(Wide::constant(&constant)).minus(&Dyadic { integer: BigInt::from(n), exponent: 0 });
        assert!(difference.integer.is_zero());
    }
    for (p, q) in [(1, 3), (-22, 7), (1, 1 << 24), (0, 5), (-(1 << 24), 3)] {
        let constant = Constant::ratio(p, q);
        let wide = Wide::constant(&constant);
        assert!(is_close(wide, &constant, Wide::UNIT_EXPONENT) && wide.radius().is_zero(), "{p}/{q}");
    }
}

#[test]
fn long_ratios_are_within_a_few_units() {
    let mut random = Random(21);
    for _ in 0..1_000 {
        let mut row = || {
            let length = 1 + random.bits() % 20;
            let mut limbs: Vec<u64> = (0..length).map(|_| random.bits() >> (random.bits() % 64)).collect();
            if random.bits() & 3 == 0 {
                limbs[0] = 0;
                limbs.push(0);
            }
            if limbs.iter().all(|&limb| limb == 0) {
                limbs[0] = 1;
            }
            &*Box::leak(limbs.into_boxed_slice())
        };
        let constant = Constant::exact(row().len() & 1 == 1, row(), row(), 0.0, 0.0, 0.0);
        assert!(is_close(Wide::constant(&constant), &constant, Wide::UNIT_EXPONENT + 3));
    }
}
