//! Tests the defining equation over ℚ, also where elimination meets vanishing minors.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::prelude::*;
use num_traits::{One, Zero};

use super::systems::{Arrow, Cascade, Ring, Web};

fn q(p: i64, q: i64) -> BigRational {
    BigRational::new(p.into(), q.into())
}

fn has_every_law<M, const N: usize>(map: &M, x: &SVector<BigRational, N>, eps: &BigRational)
where
    M: KahanMap<BigRational, N>,
{
    let next = map.step(x, eps.clone());
    let moved = map.polarized(x, &next) * (eps.clone() + eps.clone());
    assert_eq!(next.clone() - x.clone(), moved, "{x:?}");
    assert_eq!(&map.step_back(&next, eps.clone()), x);
    assert_eq!(map.try_step(x, eps.clone()).as_ref(), Ok(&next));
    let jacobian = map.jacobian(x, eps.clone());
    assert_eq!(map.matrix(x, eps.clone()) * jacobian, map.matrix(&next, -eps.clone()));
}

/// Tests points with small integer coordinates, at which pivots sometimes vanish.
fn at_small_points<M, const N: usize>(map: &M, seed: u64)
where
    M: KahanMap<BigRational, N>,
{
    let mut random = SplitMix64::new(seed);
    let mut below = |n: u64| i64::try_from(random.next_u64() % n).expect("small");
    let mut steps = 0;
    while steps < 8 {
        let x = SVector::from_fn(|_, _| q(below(7) - 3, 1));
        let eps = q(below(3) + 1, 2);
        if map.det_matrix(&x, eps.clone()).is_zero() {
            assert!(map.try_step(&x, eps.clone()).is_err());
            continue;
        }
        if map.det_matrix(&map.step(&x, eps.clone()), -eps.clone()).is_zero() {
            continue;
        }
        has_every_law(map, &x, &eps);
        steps += 1;
    }
}

#[test]
fn the_defining_equation_holds_for_every_kind_of_coupling() {
    at_small_points::<_, 12>(&Ring, 1);
    at_small_points::<_, 11>(&Arrow { a: q(2, 3) }, 2);
    at_small_points::<_, 10>(&Cascade, 3);
    at_small_points::<_, 18>(&Web, 4);
}

/// The diagonal entry 1 − ε(xᵢ₊₁ − xᵢ₋₁) vanishes for a variable xᵢ that is eliminated early.
#[test]
fn pivots_that_vanish_are_exchanged() {
    let start = SVector::<_, 12>::from_fn(|i, _| q(i64::try_from(i * i * i).expect("small") - 400, 77));
    let eps = q(1, 2);
    for pairs in [&[(1, 11)][..], &[(5, 3)], &[(3, 1), (9, 7)], &[(2, 0), (7, 5), (4, 2)]] {
        let mut x = start.clone();
        for &(above, below) in pairs {
            x[above] = x[below].clone() + q(2, 1);
        }
        let matrix = Ring.matrix(&x, eps.clone());
        assert!((0..12).filter(|&i| matrix[(i, i)].is_zero()).count() >= pairs.len(), "{matrix}");
        has_every_law(&Ring, &x, &eps);
    }
}

#[test]
fn closed_forms_without_a_division_agree_with_the_step() {
    let x = SVector::<_, 10>::from_fn(|i, _| q(i64::try_from(i).expect("small") - 4, 3));
    let (numerators, denominator) = Cascade.rational_map(&x, q(1, 5));
    assert_eq!(denominator, Cascade.det_matrix(&x, q(1, 5)));
    assert_eq!(Cascade.step(&x, q(1, 5)) * denominator, numerators);
    let volume = Cascade.det_jacobian(&x, q(1, 5));
    let next = Cascade.step(&x, q(1, 5));
    assert_eq!(volume * Cascade.det_matrix(&x, q(1, 5)), Cascade.det_matrix(&next, q(-1, 5)));
    assert!(!Cascade.det_matrix(&x, BigRational::zero()).is_zero() && BigRational::one().is_one());
}
