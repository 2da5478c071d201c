//! The figure of an orbit of dE4 in space, on the level curve of its two integrals.

use kahan_core::prelude::*;
use maud::{Markup, html};

use super::super::text::scientific;
use super::FigureEntry;
use kahan_draw::decimal;
use kahan_draw::{Canvas, Mark, NumberLine, Plot, Series, SpacePlot, SpaceSeries};
use kahan_paper::figures::{DE4, level_curve};
use kahan_systems::{E4, e4};

const POINTS: usize = 1000;

type Point = SVector<f64, 3>;

/// Draws the orbit of Kahan's map of E4. Returns `None` if no elliptic solution passes through its
/// initial state.
pub(super) fn figure_entry() -> Option<FigureEntry> {
    let number = |&(p, q): &(i64, i64)| p as f64 / q as f64;
    let [x, y, z] = DE4.start else { return None };
    let start = Point::new(number(x), number(y), number(z));
    let eps = number(&DE4.eps);
    let solution = e4::Solution::through(&start, &eps).ok()?;
    let orbit: Vec<Point> = E4.orbit(start, eps).take(POINTS).collect();
    let curve = level_curve(&start, eps, 720);
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
    Some(FigureEntry {
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
        sheet: Canvas::page(360, 300),
        x: axis(a, i),
        y: axis(b, j),
        series: vec![
            Series::new("", 6, Mark::Line, flat(curve)),
            Series::new("", 3, Mark::Points, flat(orbit)),
        ],
        note: String::new(),
    }
    .drawing()
    .inline()
}

/// Draws the orbit and the level curve in a box. Points near the viewer are larger.
fn in_space(orbit: &[Point], curve: &[Point]) -> Markup {
    let axis = |label: &str, k: usize| NumberLine::around(label, curve.iter().map(|point| point[k]));
    let cloud = |colour, mark, points: &[Point]| {
        let points = points.iter().map(|point| [point[0], point[1], point[2]]).collect();
        SpaceSeries { colour, mark, points }
    };
    SpacePlot {
        description: "The orbit of dE4 in space: a thousand points on one closed curve that is bent like a saddle's edge"
            .to_owned(),
        sheet: Canvas::page(480, 400),
        axes: [axis("x", 0), axis("y", 1), axis("z", 2)],
        clouds: vec![cloud(6, Mark::Line, curve), cloud(3, Mark::Dots, orbit)],
    }
    .drawing()
    .inline()
}
