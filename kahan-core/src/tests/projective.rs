//! Tests orbits through poles, for fields with known results.

use std::string::{String, ToString};
use std::vec::Vec;

use crate::prelude::*;
use crate::{Projective, ProjectivePoint, ThroughPoles};

kahan! {
    /// Solutions from x > 0 reach +∞ in finite time. Orbits of the map then return from −∞.
    struct Riccati;
    xdot = x^2;
}

kahan! {
    /// A top with equal coefficients. At ε = 1/2 the plane x + y + z = 2 is mapped to (2, 2, 2).
    struct Top;
    xdot = y*z;
    ydot = z*x;
    zdot = x*y;
}

kahan! {
    /// Predator and prey. The map takes points at infinity to points at infinity.
    struct Prey;
    xdot = x*(1 - y);
    ydot = y*(x - 1);
}

fn affine<T: Scalar, const N: usize>(
    points: impl Iterator<Item = ProjectivePoint<T, N>>,
) -> Vec<Option<SVector<T, N>>> {
    points.map(ProjectivePoint::affine).collect()
}

fn check_riccati<T: ThroughPoles + PartialEq>(number: fn(i32, i32) -> T) {
    let orbit = Riccati.orbit(vector![number(1, 1)], number(1, 4)).projective();
    let at = |p, q| Some(vector![number(p, q)]);
    assert_eq!(affine(orbit.take(5)), [at(1, 1), at(2, 1), None, at(-2, 1), at(-1, 1)]);
}

#[test]
fn a_line_closes_at_infinity_in_every_scalar() {
    check_riccati(|p, q| p as f32 / q as f32);
    check_riccati(|p, q| f64::from(p) / f64::from(q));
    check_riccati(|p, q| Dd::from(f64::from(p)) / Dd::from(f64::from(q)));
    #[cfg(feature = "exact")]
    check_riccati(|p, q| BigRational::new(p.into(), q.into()));
}

/// Checks that orbits pass through the common image of a plane, and that inverse orbits return.
fn check_top<T: ThroughPoles>(number: fn(f64) -> T, near: impl Fn(&SVector<T, 3>, &SVector<T, 3>) -> bool) {
    let point = |x: [f64; 3]| vector![number(x[0]), number(x[1]), number(x[2])];
    for start in [[1.5, 1.0, -0.5], [0.75, 1.5, -0.25], [3.0, -2.0, 1.0]] {
        let mut orbit = Top.orbit(point(start), number(0.5)).projective();
        let points = affine(orbit.by_ref().take(4));
        assert_eq!(points[1], Some(point([2.0; 3])), "{start:?}");
        assert_eq!(points[2], Some(point([-2.0; 3])), "{start:?}");
        let last = points[3].clone().expect("not at infinity");
        let back = affine(Top.orbit(last, number(-0.5)).projective().take(4));
        assert_eq!(back[2], Some(point([2.0; 3])), "{start:?}");
        assert!(near(back[3].as_ref().expect("not at infinity"), &point(start)), "{start:?}: {back:?}");
    }
}

#[test]
fn what_was_brought_to_one_point_comes_apart_again() {
    // The inverse orbit of a rounded point may lose ten bits; 65536 = 2¹⁶ leaves a reserve.
    check_top(|x| x, |a, b| (a - b).amax() <= 65536.0 * f64::EPSILON);
    check_top(|x| x as f32, |a, b| (a - b).amax() <= 65536.0 * f32::EPSILON);
    #[cfg(feature = "exact")]
    check_top(|x| BigRational::from_float(x).expect("finite"), |a, b| a == b);
}

fn end<M, T: ThroughPoles, const N: usize>(orbit: &mut Projective<M, T, N>) -> (usize, String)
where
    M: crate::ExtendScalars<T, N>,
{
    let points = orbit.by_ref().take(40).count();
    assert_eq!(orbit.next().is_none(), orbit.stopped().is_some());
    (points, orbit.stopped().map(ToString::to_string).unwrap_or_default())
}

#[test]
fn an_orbit_ends_where_lines_lead_to_different_points() {
    let (points, why) = end(&mut Top.orbit(vector![2.0, 2.0, 2.0], 0.5).projective());
    assert_eq!(points, 2);
    assert!(why.contains("lines through it lead to different points"), "{why}");
    #[cfg(feature = "exact")]
    {
        let two = || BigRational::from_integer(2.into());
        let start = vector![two(), two(), two()];
        assert_eq!(end(&mut Top.orbit(start, two().recip()).projective()), (points, why));
    }
}

#[test]
fn what_stays_at_infinity_is_followed_until_digits_end() {
    let mut orbit = Prey.orbit(vector![6.0, 1.0], 0.5).projective();
    let infinite = orbit.by_ref().skip(1).take_while(ProjectivePoint::is_infinite).count();
    assert!(infinite >= 2, "{infinite}");
    let why = orbit.stopped().expect("it ends").to_string();
    assert!(why.contains("before they come apart"), "{why}");
}

#[test]
fn away_from_poles_points_have_the_bits_of_the_orbit() {
    let start = vector![1.5, 1.0];
    let plain: Vec<_> = Prey.orbit(start, 0.05).take(500).map(Some).collect();
    assert_eq!(affine(Prey.orbit(start, 0.05).projective().take(500)), plain);
    let mut orbit = Prey.orbit(start, 0.05);
    orbit.nth(9);
    assert_eq!(affine(orbit.projective().take(490)), plain[10..]);
}

#[test]
fn near_a_pole_ten_bits_are_lost_and_very_near_none() {
    // The exact map is 1/x̃ = 1/x − 2ε. The product 2εx is exact only for ε = 0.25.
    for (eps, pole) in [(0.25, 2.0), (0.3, 5.0 / 3.0)] {
        for exponent in [3, 6, 9, 12, 15, 30, 45] {
            let d = 2_f64.powi(-exponent);
            let bound = if exponent > 10 { 4.0 } else { 4096.0 } * f64::EPSILON;
            let x = pole + d;
            let points = affine(Riccati.orbit(vector![x], eps).projective().take(3));
            let x = Dd::from(x);
            for (n, point) in points.into_iter().enumerate() {
                let steps = Dd::from(2.0 * eps) * Dd::from(n as f64);
                let exact = f64::from(x / (Dd::from(1.0) - x * steps));
                let found = point.expect("not at infinity")[0];
                assert!((found - exact).abs() <= bound * exact.abs(), "{eps}, 2^-{exponent}, {n}: {found}");
            }
        }
    }
}

#[test]
fn a_point_that_is_no_number_ends_the_orbit() {
    let (points, why) = end(&mut Prey.orbit(vector![f64::NAN, 1.0], 0.5).projective());
    assert_eq!(points, 1);
    assert!(why.contains("not a finite number"), "{why}");
}
