//! The orbit of dE4 in space, on the curve where its two integrals keep their values.

use std::f64::consts::TAU;

use kahan_core::prelude::*;
use maud::{Markup, html};

use super::super::words::scientific;
use super::Plate;
use crate::numbers::decimal;
use crate::plot::{Mark, NumberLine, Plot, Series, dots, line, polyline, text};
use kahan_paper::figures::DE4;
use kahan_systems::{E4, e4};

const POINTS: usize = 1000;
const CURVE: usize = 720;

type Point = SVector<f64, 3>;

/// A component of the level curve of H(ε) and K(ε) through a point with xy > 0 and |εz| < 1, from
/// the integrals alone: with s = x + y, d = x − y, h = 2ε²H, g = 2ε²K it is (1−h)s² − (1+h)d² = 4H,
/// (1−g)(s² + d²) + 2z² = 4K. Eliminating s leaves an ellipse in d and z.
fn level_curve(point: &Point, eps: f64) -> Vec<Point> {
    let integrals = E4.integrals(point, eps);
    let (big_h, big_k) = (integrals[0], integrals[1]);
    let (h, g) = (2.0 * eps * eps * big_h, 2.0 * eps * eps * big_k);
    // 2z² = a − b d²
    let a = 4.0 * big_k - (1.0 - g) * 4.0 * big_h / (1.0 - h);
    let b = (1.0 - g) * (1.0 + (1.0 + h) / (1.0 - h));
    let sign = point[0].signum();
    let at = |phase: f64| {
        let d = (a / b).sqrt() * phase.cos();
        let s = sign * ((4.0 * big_h + (1.0 + h) * d * d) / (1.0 - h)).sqrt();
        Point::new((s + d) / 2.0, (s - d) / 2.0, (a / 2.0).sqrt() * phase.sin())
    };
    (0..=CURVE).map(|i| at(TAU * i as f64 / CURVE as f64)).collect()
}

/// The figure; `None` if the data are outside of the domain of the elliptic solution.
pub(super) fn plate() -> Option<Plate> {
    let number = |&(p, q): &(i64, i64)| p as f64 / q as f64;
    let [x, y, z] = DE4.start else { return None };
    let start = Point::new(number(x), number(y), number(z));
    let eps = number(&DE4.eps);
    let solution = e4::Solution::through(&start, &eps).ok()?;
    let orbit: Vec<Point> = E4.orbit(start, eps).take(POINTS).collect();
    let curve = level_curve(&start, eps);
    let farthest =
        (0_i64..).zip(&orbit).map(|(n, point)| (solution.at(n) - point).norm()).fold(0.0, f64::max);
    let integrals = E4.integrals(&start, eps);
    let drift = |i: usize| {
        let change = |point: &Point| (E4.integrals(point, eps)[i] / integrals[i] - 1.0).abs();
        orbit.iter().map(change).fold(0.0, f64::max)
    };
    let rotation = 2.0 * solution.delta / (4.0 * solution.modulus.quarter_period());
    let fractions: Vec<String> = DE4.start.iter().map(|(p, q)| format!("{p}/{q}")).collect();
    let (p, q) = DE4.eps;
    Some(Plate {
        id: "figure-curve",
        title: "dE4: a thousand points on one curve",
        drawings: vec![
            in_space(&orbit, &curve),
            projection("x", 0, "y", 1, &orbit, &curve),
            projection("x", 0, "z", 2, &orbit, &curve),
            projection("y", 1, "z", 2, &orbit, &curve),
        ],
        data: html! {
            "dE4, (x, y, z)" sub { "0" } " = (" (fractions.join(", ")) "), " (orbit.len()) " points in double precision; the "
            "paper does not state ε, here ε = " (p) "/" (q)
        },
        result: html! {
            "Dots: the map. Line: the curve on which H(ε) = " (decimal(integrals[0], 4)) " and K(ε) = "
            (decimal(integrals[1], 4)) ", drawn from these two integrals alone. Along the orbit they keep their values to "
            (scientific(drift(0))) " and " (scientific(drift(1))) " (relative). The elliptic solution of Theorem 3 through "
            "the first point has modulus " i { "k" } " = " (decimal(solution.modulus.k, 5)) " and δ = "
            (decimal(solution.delta, 5)) "; a step goes " (decimal(rotation, 5)) " of the way around the curve, and each of the "
            (orbit.len()) " points is within " (scientific(farthest)) " of the value of the solution at its " i { "n" } "."
        },
        claims: &["theorem3", "e4"],
    })
}

fn projection(a: &str, i: usize, b: &str, j: usize, orbit: &[Point], curve: &[Point]) -> Markup {
    let flat = |points: &[Point]| points.iter().map(|point| (point[i], point[j])).collect::<Vec<_>>();
    let axis = |label: &str, k: usize| NumberLine::around(label, curve.iter().map(|point| point[k]));
    Plot {
        description: format!("The orbit of dE4 projected to {a} and {b}: points on a closed curve"),
        size: (360.0, 300.0),
        x: axis(a, i),
        y: axis(b, j),
        levels: Vec::new(),
        series: vec![
            Series::new("", 6, Mark::Line, flat(curve)),
            Series::new("", 3, Mark::Points, flat(orbit)),
        ],
    }
    .svg()
}

/// Parallel projection from the front, a little from the right and from above, that fills the
/// drawing with a box.
struct View {
    middle: Point,
    scale: f64,
}

/// Width and height of the view box of the spatial drawing, and the room that is left around the
/// box.
const SPACE: (f64, f64) = (480.0, 400.0);
const ROOM: f64 = 34.0;
const TURN: f64 = 0.62;
const TILT: f64 = 0.36;

/// To the right, upwards, and towards the eye.
fn turned(p: &Point) -> (f64, f64, f64) {
    let (right, back) = (p[0] * TURN.cos() - p[1] * TURN.sin(), p[0] * TURN.sin() + p[1] * TURN.cos());
    (right, p[2] * TILT.cos() + back * TILT.sin(), p[2] * TILT.sin() - back * TILT.cos())
}

impl View {
    /// The view of the box with these opposite corners.
    fn of(low: &Point, high: &Point) -> Self {
        let half = (high - low) / 2.0;
        let corners = (0..8_usize)
            .map(|bits| Point::from_fn(|i, _| if bits >> i & 1 == 1 { half[i] } else { -half[i] }));
        let (right, up) = corners
            .map(|corner| turned(&corner))
            .fold((0.0_f64, 0.0_f64), |(a, b), (right, up, _)| (a.max(right.abs()), b.max(up.abs())));
        let scale = ((SPACE.0 / 2.0 - ROOM) / right).min((SPACE.1 / 2.0 - ROOM) / up);
        View { middle: (low + high) / 2.0, scale }
    }

    fn place(&self, point: &Point) -> (f64, f64) {
        let (right, up, _) = turned(&(point - self.middle));
        (SPACE.0 / 2.0 + self.scale * right, SPACE.1 / 2.0 - self.scale * up)
    }
}

/// The curve in its box, near points larger than far ones.
fn in_space(orbit: &[Point], curve: &[Point]) -> Markup {
    let bound = |pick: fn(f64, f64) -> f64| {
        curve.iter().copied().reduce(|a, b| a.zip_map(&b, pick)).unwrap_or_default()
    };
    let (low, high) = (bound(f64::min), bound(f64::max));
    let view = View::of(&low, &high);
    let corner = |bits: usize| Point::from_fn(|i, _| if bits >> i & 1 == 1 { high[i] } else { low[i] });
    let edges =
        (0..8_usize).flat_map(|from| [1, 2, 4].map(|bit| (from, from | bit))).filter(|(from, to)| from != to);
    let depths: Vec<f64> = orbit.iter().map(|point| turned(point).2).collect();
    let (far, near) =
        depths.iter().fold((f64::MAX, f64::MIN), |(a, b), depth| (a.min(*depth), b.max(*depth)));
    let layer = |index: usize| {
        let cut = |i: usize| far + (near - far) * i as f64 / 3.0;
        let inside = |depth: f64| depth >= cut(index) && (depth < cut(index + 1) || index == 2);
        let places = orbit.iter().zip(&depths).filter(|(_, depth)| inside(**depth));
        dots(&places.map(|(point, _)| view.place(point)).collect::<Vec<_>>())
    };
    let places: Vec<(f64, f64)> = curve.iter().map(|point| view.place(point)).collect();
    // Beside the edges of the outline: two below, one on the left.
    let names = [
        ("x", 0b000, 0b001, (12.0, 20.0)),
        ("y", 0b000, 0b010, (-12.0, 20.0)),
        ("z", 0b010, 0b110, (-14.0, 5.0)),
    ];
    let names = names.map(|(name, from, to, (right, down))| {
        let (x, y) = view.place(&((corner(from) + corner(to)) / 2.0));
        (name, (x + right, y + down))
    });
    html! {
        svg viewBox=(format!("0 0 {} {}", SPACE.0, SPACE.1)) role="img"
            aria-label="The orbit of dE4 in space: a thousand points on one closed curve that is bent like a saddle's edge" {
            g.grid { @for (from, to) in edges { (line(view.place(&corner(from)), view.place(&corner(to)))) } }
            g.names { @for (name, place) in names { (text(place, "middle", name)) } }
            g.c6 { path.line d=(polyline(&places)) {} }
            g.c3 { @for index in 0..3 { path.dots.(["far", "between", "near"][index]) d=(layer(index)) {} } }
        }
    }
}
