//! Tests the laws of Kahan's map exactly over the rationals, at seeded points of each system.

use num_traits::Zero;

use super::by_hand::{Coupled, E1, E3, E6, E7};
use super::rationals::{Q, Rationals, product, q, scaled};
use crate::field::linear::{determinant, solve};
use crate::{KahanMap, eps_from_dt};

fn points<const N: usize>(seed: u64) -> impl Iterator<Item = (nalgebra::SVector<Q, N>, Q)> {
    let mut rationals = Rationals::seeded(seed);
    core::iter::repeat_with(move || (rationals.vector(), rationals.next())).take(12)
}

/// Checks a law for all systems at all points with det A ≠ 0, of which at least one must exist.
macro_rules! on_every_system {
    ($law:ident) => {{
        macro_rules! on {
            ($map:expr, $n:literal, $seed:literal) => {{
                let mut tested = 0;
                for (x, eps) in points::<$n>($seed) {
                    let map = $map;
                    if !determinant(map.matrix(&x, eps.clone())).is_zero() {
                        $law(&map, &x, eps);
                        tested += 1;
                    }
                }
                assert!(tested >= 10, "only {tested} points tested");
            }};
        }
        on!(E1, 3, 1);
        on!(E3, 3, 2);
        on!(E6, 3, 7);
        on!(E7 { xi: q(19, 17) }, 3, 3);
        on!(E7 { xi: q(-2, 1) }, 3, 4);
        on!(Coupled, 4, 5);
    }};
}

type V<const N: usize> = nalgebra::SVector<Q, N>;

#[test]
fn the_defining_equation_has_residual_zero() {
    fn law<M: KahanMap<Q, N>, const N: usize>(map: &M, x: &V<N>, eps: Q) {
        let next = map.step(x, eps.clone());
        assert_eq!(&next - x, scaled(&(q(2, 1) * eps), &map.polarized(x, &next)));
    }
    on_every_system!(law);
}

#[test]
fn the_step_solves_the_linear_system() {
    fn law<M: KahanMap<Q, N>, const N: usize>(map: &M, x: &V<N>, eps: Q) {
        let next = map.step(x, eps.clone());
        assert_eq!(product(&map.matrix(x, eps.clone()), &next), map.rhs(x, eps));
    }
    on_every_system!(law);
}

#[test]
fn stepping_back_returns_the_start_exactly() {
    fn law<M: KahanMap<Q, N>, const N: usize>(map: &M, x: &V<N>, eps: Q) {
        let next = map.step(x, eps.clone());
        // If this determinant is 0, x̃ is a pole of the inverse.
        if map.det_matrix(&next, -eps.clone()).is_zero() {
            return;
        }
        assert_eq!(&map.step_back(&next, eps.clone()), x);
        assert_eq!(map.step(&next, -eps), *x);
    }
    on_every_system!(law);
}

#[test]
fn the_jacobian_is_the_matrix_quotient() {
    fn law<M: KahanMap<Q, N>, const N: usize>(map: &M, x: &V<N>, eps: Q) {
        let back = map.matrix(&map.step(x, eps.clone()), -eps.clone());
        let jacobian = map.jacobian(x, eps.clone());
        assert_eq!(product(&map.matrix(x, eps.clone()), &jacobian), back);
        assert_eq!(Some(jacobian), solve(map.matrix(x, eps), back));
    }
    on_every_system!(law);
}

#[test]
fn the_jacobian_determinant_is_the_quotient_of_the_determinants() {
    fn law<M: KahanMap<Q, N>, const N: usize>(map: &M, x: &V<N>, eps: Q) {
        let next = map.step(x, eps.clone());
        let quotient = map.det_matrix(&next, -eps.clone()) / map.det_matrix(x, eps.clone());
        assert_eq!(map.det_jacobian(x, eps), quotient);
    }
    on_every_system!(law);
}

#[test]
fn the_rational_map_is_the_step_times_the_determinant() {
    fn law<M: KahanMap<Q, N>, const N: usize>(map: &M, x: &V<N>, eps: Q) {
        let (numerators, denominator) = map.rational_map(x, eps.clone());
        assert_eq!(denominator, determinant(map.matrix(x, eps.clone())));
        assert_eq!(denominator, map.det_matrix(x, eps.clone()));
        assert_eq!(numerators, scaled(&denominator, &map.step(x, eps)));
    }
    on_every_system!(law);
}

#[test]
fn all_ways_to_step_agree() {
    fn law<M: KahanMap<Q, N> + Clone, const N: usize>(map: &M, x: &V<N>, eps: Q) {
        let next = map.step(x, eps.clone());
        let prepared = map.at(eps.clone());
        assert_eq!(map.try_step(x, eps.clone()), Ok(next.clone()));
        assert_eq!(prepared.step(x), next);
        assert_eq!(prepared.try_step(x), Ok(next.clone()));
        assert_eq!(prepared.jacobian(x), map.jacobian(x, eps.clone()));
        assert_eq!(prepared.orbit(x.clone()).nth(1), Some(next.clone()));
        assert_eq!(map.orbit(x.clone(), eps).nth(1), Some(next));
    }
    on_every_system!(law);
}

#[test]
fn the_forms_are_polarizations_of_the_field() {
    fn law<M: KahanMap<Q, N>, const N: usize>(map: &M, x: &V<N>, eps: Q) {
        let y = scaled(&q(3, 7), x).map(|entry| entry + eps.clone());
        let origin = x.map(|_| Q::zero());
        let constant = map.field(&origin);
        assert_eq!(map.polarized(x, x), map.field(x));
        // f(x+y) − f(x) − f(y) + f(0) = 2Q(x,y)
        let second_difference = map.field(&(x + &y)) - map.field(x) - map.field(&y) + constant;
        assert_eq!(second_difference, scaled(&q(2, 1), &map.bilinear(x, &y)));
        // f(x+y) = f(x) + f′(x)y + Q(y,y)
        let expansion = map.field(x) + product(&map.field_jacobian(x), &y) + map.bilinear(&y, &y);
        assert_eq!(map.field(&(x + &y)), expansion);
    }
    on_every_system!(law);
}

#[test]
fn a_system_reduced_for_all_parameters_agrees_with_one_reduced_for_its_own() {
    for (x, eps) in points::<3>(6) {
        let general = E7 { xi: q(1, 1) };
        if !determinant(general.matrix(&x, eps.clone())).is_zero() {
            assert_eq!(general.step(&x, eps.clone()), E1.step(&x, eps));
        }
    }
}

#[test]
fn eps_is_half_the_time_step() {
    assert_eq!(eps_from_dt(q(3, 7)), q(3, 14));
}
