//! Over rationals: Kahan's defining equation, with ==.

use std::vec::Vec;

use num_rational::BigRational;

use crate::{Constant, LatticeMap, Scalar};

use super::families::{Kdv, Toda, Volterra};

type Q = BigRational;

fn q(p: i64, d: i64) -> Q {
    Q::constant(&Constant::ratio(p, d))
}

/// A state of small rationals, no two neighbours alike.
fn state(len: usize) -> Vec<Q> {
    (0..len as i64).map(|i| q(3 + (7 * i * i + 5 * i) % 11, 2 + (3 * i) % 5)).collect()
}

/// The step of a chain: (x̃ − x)/(2ε) = 2f(½(x + x̃)) − ½f(x) − ½f(x̃), and back again.
fn satisfies_kahans_equation<M: LatticeMap<Q>>(fewest: usize, map: impl Fn(usize) -> M) {
    for sites in fewest..=12 {
        let eps = q(2, 17);
        let mut at = map(sites).at(eps.clone(), sites).expect("sites");
        let x = state(sites * M::BLOCK);
        let mut next = x.clone();
        at.step(&mut next);
        assert_ne!(next, x);
        let middle: Vec<Q> = x.iter().zip(&next).map(|(x, y)| (x + y) * q(1, 2)).collect();
        let fields = [at.field(&middle), at.field(&x), at.field(&next)];
        for k in 0..x.len() {
            let polarised = &fields[0][k] * q(2, 1) - (&fields[1][k] + &fields[2][k]) * q(1, 2);
            assert_eq!((&next[k] - &x[k]) / (&eps + &eps), polarised, "{sites} sites, entry {k}");
        }
        assert_eq!(at.residual(&x, &next), q(0, 1));
        let mut other = next.clone();
        other[0] += q(1, 1000);
        assert_ne!(at.residual(&x, &other), q(0, 1));
        at.step_back(&mut next);
        assert_eq!(next, x, "{sites} sites");
    }
}

#[test]
fn steps_satisfy_kahans_equation_at_every_length() {
    satisfies_kahans_equation(1, |_| Toda);
    // On one or two sites rings of these stand still.
    satisfies_kahans_equation(3, |_| Volterra);
    satisfies_kahans_equation(3, |sites| Kdv {
        inverse: q(3, 2),
        dispersion: (0..sites).map(|i| q(1 + i as i64, 3)).collect(),
    });
}

#[test]
fn a_ring_of_one_or_two_volterra_sites_stands_still() {
    for sites in 1..=2 {
        let mut x = state(sites);
        Volterra.at(q(1, 3), sites).expect("sites").step(&mut x);
        assert_eq!(x, state(sites));
    }
}
