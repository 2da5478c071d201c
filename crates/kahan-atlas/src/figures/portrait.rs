//! The phase portrait: closed orbits of Kahan's Lotka–Volterra map beside the spirals of Euler's
//! explicit method.

use kahan_algebra::rational::Rational;
use kahan_core::prelude::*;
use kahan_study::{Method, Orbit, StoredColumn, Study, Subject, Systems, Unwatched};
use maud::{Markup, html};

use super::super::text::scientific;
use super::FigureEntry;
use kahan_draw::decimal;
use kahan_draw::{Canvas, Mark, NumberLine, Plot, Series};

/// Half the time step. An orbit closes after about twenty steps.
const EPS: f64 = 0.147;
const STEPS: usize = 360;
const SHOWN: f64 = 4.2;

type Point = SVector<f64, 2>;

/// The distances r of the initial points (1 − r, 1) from the fixed point (1, 1).
const RADII: [f64; 5] = [0.15, 0.3, 0.5, 0.65, 0.75];

/// Returns log(xy) − (x + y), which is an integral of the flow.
fn integral(point: &Point) -> f64 {
    libm::log(point[0] * point[1]) - (point[0] + point[1])
}

fn orbits(study: &Study, method: Method) -> Vec<Vec<Point>> {
    let steps = STEPS as u64 - 1;
    let orbit = |radius: &f64| {
        let at = vec![Rational::from_f64(1.0 - radius).expect("a number"), Rational::one()];
        let eps = Rational::from_f64(EPS).expect("a number");
        let orbit = Orbit { method, ..Orbit::new(eps, at, steps) }.ask(study, &Unwatched);
        let rows = orbit.expect("the map is defined").rows.values;
        let [StoredColumn::F64(x), StoredColumn::F64(y)] = &rows[2..4] else {
            unreachable!("an orbit in doubles")
        };
        x.iter().zip(y).map(|(x, y)| vector![*x, *y]).collect()
    };
    RADII.iter().map(orbit).collect()
}

/// Ends each orbit before its first point with a coordinate below 0.05 or above `SHOWN`.
fn inside(orbits: Vec<Vec<Point>>) -> Vec<Vec<Point>> {
    let is_inside = |point: &Point| point.iter().all(|value| (0.05..=SHOWN).contains(value));
    orbits.into_iter().map(|orbit| orbit.into_iter().take_while(is_inside).collect()).collect()
}

fn change(orbit: &[Point]) -> f64 {
    let first = orbit.first().map_or(0.0, integral);
    orbit.iter().map(|point| (integral(point) - first).abs()).fold(0.0, f64::max)
}

pub(super) fn figure_entry() -> FigureEntry {
    let study = Subject::named("lv").study(&Systems).expect("it is in the catalog");
    let (kahan, euler) = (orbits(&study, Method::Kahan), inside(orbits(&study, Method::Euler)));
    let (inner_kahan, inner_euler) = (change(&kahan[0]), change(&euler[0]));
    FigureEntry {
        id: "figure-portrait",
        title: "No spirals: Lotka–Volterra by Kahan and by Euler",
        drawings: vec![
            portrait("Kahan’s map", "Five closed orbits around the point (1, 1)", Mark::Dots, &kahan),
            portrait(
                "Euler’s explicit method",
                "The same five initial points: orbits that spiral outwards",
                Mark::Both,
                &euler[..2],
            ),
        ],
        data: html! {
            "x′ = x(1 − y), y′ = y(x − 1), time step 2ε = " (decimal(2.0 * EPS, 3)) ", from (1 − r, 1) with r = "
            (RADII.map(|radius| decimal(radius, 2)).join(", ")) "; " (STEPS) " steps in double precision; Euler’s method from the "
            "first two, until it leaves the picture or comes within 0.05 of an axis"
        },
        result: html! {
            "This system made Kahan’s method known. Its orbits look closed, though their heights speak against an algebraic "
            "integral; the map keeps the area d" i { "x" } " d" i { "y" } "/(" i { "xy" } "). Along the innermost orbit log(" i { "xy" }
            ") − (" i { "x" } " + " i { "y" } "), the integral of the flow, stays within " (scientific(inner_kahan))
            " of its first value in " (STEPS) " steps; by Euler’s method it is off by " (decimal(inner_euler, 2))
            " after " (inner_euler_steps(&euler[0])) " steps. This drawing is not in the paper."
        },
        claims: &["lv"],
    }
}

fn inner_euler_steps(orbit: &[Point]) -> usize {
    orbit.len().saturating_sub(1)
}

fn portrait(title: &str, seen: &str, mark: Mark, orbits: &[Vec<Point>]) -> Markup {
    let axis = |label: &str| NumberLine::new(label, 0.0, SHOWN);
    let series = orbits.iter().enumerate().map(|(index, orbit)| {
        let points = orbit.iter().map(|point| (point[0], point[1])).collect();
        Series::new("", index + 1, mark, points)
    });
    let plot = Plot {
        description: format!("{title}: {seen}"),
        sheet: Canvas::page(400, 400),
        x: axis("x"),
        y: axis("y"),
        series: series.collect(),
        note: String::new(),
    };
    html! { div.portrait { p.title { (title) } (plot.drawing().inline()) } }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kahans_orbits_stay_and_eulers_leave() {
        let study = Subject::named("lv").study(&Systems).expect("a system");
        let [kahan, euler] =
            [Method::Kahan, Method::Euler].map(|method| inside(orbits(&study, method)).remove(0));
        assert!(change(&kahan) < 0.01 && euler.len() < STEPS && change(&euler) > 1.0);
    }
}
