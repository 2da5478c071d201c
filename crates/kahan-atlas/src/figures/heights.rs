//! Plots the heights of exact orbits, and heights divided by a power of the step number.

use maud::{Markup, html};

use super::super::found::Orbits;
use super::super::text::grouped;
use super::FigureEntry;
use super::orbit::{Heights, Orbit, h};
use kahan_draw::decimal;
use kahan_draw::{Mark, Plot, Series};
use kahan_paper::figures::{DE1, DE3, DE4, DE7, DE9, LV};

fn drawing(description: &str, axes: [&str; 2], series: Vec<Series>) -> Markup {
    Plot::around(description, axes, series).drawing().inline()
}

/// Plots log h against log n for heights h after n steps. Growth like nᵏ gives the slope k.
fn log_log(description: &str, of: &str, series: Vec<Series>) -> Markup {
    drawing(description, ["log n", &format!("log h({of})")], series)
}

fn growth(description: &str, colour: usize, mark: Mark, x: &Heights) -> Markup {
    log_log(description, "xₙ", vec![Series::new("", colour, mark, x.log_log())])
}

/// Plots log(hₙ/nᵏ) for the heights hₙ in `x`, and a line at log `value` with the label `shown`.
fn limit(description: &str, k: i32, colour: usize, x: &Heights, (value, shown): (f64, String)) -> Markup {
    let label = if k == 1 { "log(h(xₙ)/n)" } else { "log(h(xₙ)/n²)" };
    let series = Series::new("", colour, Mark::Line, x.correction(k, x.last().0));
    let level = level(&format!("log {shown}"), 6, libm::log(value), &series);
    drawing(description, ["n", label], vec![series, level])
}

fn level(label: &str, colour: usize, height: f64, series: &Series) -> Series {
    let ends = [series.points.first(), series.points.last()];
    Series::new(label, colour, Mark::Level, ends.into_iter().flatten().map(|(n, _)| (*n, height)).collect())
}

pub(super) fn overview(orbits: &Orbits<'_>) -> Option<FigureEntry> {
    let chosen = [
        (&DE1, "dE1", "z", 6),
        (&DE3, "dE3", "x", 2),
        (&DE4, "dE4", "x", 3),
        (&DE7, "dE7", "z", 4),
        (&DE9, "dE9", "x", 5),
        (&LV, "LV", "x", 1),
    ];
    let mut series = Vec::new();
    for (figure, name, variable, colour) in chosen {
        let heights = Orbit::of(orbits, figure)?.heights(variable)?;
        let mark = if heights.0.len() < 30 { Mark::Both } else { Mark::Line };
        series.push(Series::new(name, colour, mark, heights.log_log()));
    }
    Some(FigureEntry {
        id: "figure-overview",
        title: "Integrable or not: six orbits at a glance",
        drawings: vec![log_log(
            "Logarithms of heights against log n for six maps: three bend upwards or rise steeply, the others are straight",
            "n-th iterate",
            series,
        )],
        data: html! { "The orbits of the following figures and one of dE1 with the data of dE3." },
        result: html! {
            "A straight line is a power of " i { "n" } ": slope 1 for dE3 and dE7, slope 2 for dE4. dE1, whose solution is "
            "rational in " i { "n" } ", stays almost flat: its heights grow like log " i { "n" } ". The Lotka–Volterra map "
            "and dE9 curve upwards and leave every power behind. This drawing is not in the paper."
        },
        claims: &[],
    })
}

pub(super) fn lotka_volterra(orbits: &Orbits<'_>) -> Option<FigureEntry> {
    let orbit = Orbit::of(orbits, &LV)?;
    let x = orbit.heights("x")?;
    let (n, last) = x.last();
    Some(FigureEntry {
        id: "figure-lv",
        title: "Lotka–Volterra: heights double",
        drawings: vec![growth(
            "log h of x_n against log n for the Lotka–Volterra map: a curve that bends upwards",
            1,
            Mark::Both,
            &x,
        )],
        data: orbit.data(),
        result: html! {
            "The curve bends upwards: growth is " (orbit.measured.survey.growth) ". " (h("x", n)) " = " (decimal(last, 2))
            ", a fraction of " (grouped(orbit.digits("x"))) " digits; the last step multiplied " i { "h" } "(" i { "x" }
            ") by " (decimal(x.last_ratio(), 4)) ". This speaks against an algebraic integral behind the closed orbits of this map."
        },
        claims: &["section7", "lv"],
    })
}

pub(super) fn de3(orbits: &Orbits<'_>) -> Option<FigureEntry> {
    let orbit = Orbit::of(orbits, &DE3)?;
    let x = orbit.heights("x")?;
    let (n, last) = x.last();
    let slope = x.slope();
    Some(FigureEntry {
        id: "figure-de3",
        title: "dE3: linear growth",
        drawings: vec![
            growth("log h of x_n against log n for dE3: a straight line of slope 1", 2, Mark::Line, &x),
            limit(
                "log of h over n against n for dE3: it settles on a constant",
                1,
                2,
                &x,
                (slope, decimal(slope, 3)),
            ),
        ],
        data: orbit.data(),
        result: html! {
            "Growth is " (orbit.measured.survey.growth) ": " (h("x", n)) " = " (decimal(last, 1)) ", and the least squares "
            "slope of " i { "h" } "(" i { "x" } sub { i { "n" } } ") is " (decimal(slope, 3)) " (dashed: its logarithm). "
            "dE3 is solved by hyperbolic functions, so that 1/" i { "x" } sub { i { "n" } } " obeys a linear recurrence."
        },
        claims: &["section7", "e3"],
    })
}

pub(super) fn de4(orbits: &Orbits<'_>) -> Option<FigureEntry> {
    let orbit = Orbit::of(orbits, &DE4)?;
    let x = orbit.heights("x")?;
    let (n, last) = x.last();
    let coefficient = x.half_second_difference();
    Some(FigureEntry {
        id: "figure-de4",
        title: "dE4: quadratic growth",
        drawings: vec![
            growth("log h of x_n against log n for dE4: a straight line of slope 2", 3, Mark::Line, &x),
            limit(
                "log of h over n squared against n for dE4: it settles on a constant",
                2,
                3,
                &x,
                (coefficient, decimal(coefficient, 2)),
            ),
        ],
        data: orbit.data(),
        result: html! {
            "Growth is " (orbit.measured.survey.growth) ", slope 2: " (h("x", n)) " = " (decimal(last, 1)) ", "
            (grouped(orbit.digits("x"))) " digits. " i { "h" } "(" i { "x" } sub { i { "n" } } ")/" i { "n" } sup { "2" }
            " tends to " (decimal(coefficient, 2)) ", half the second difference over the last half of the orbit (dashed). "
            "The orbit lies on an elliptic curve, where heights grow like the square of the multiple of a point."
        },
        claims: &["section7", "e4"],
    })
}

pub(super) fn de7(orbits: &Orbits<'_>) -> Option<FigureEntry> {
    let orbit = Orbit::of(orbits, &DE7)?;
    let (y, z) = (orbit.heights("y")?, orbit.heights("z")?);
    let (slope_y, slope_z) = (y.slope(), z.slope());
    let shown = orbit.steps().min(400);
    let mean = |end: usize| {
        let logs: Vec<f64> = y.correction(1, end).into_iter().map(|point| point.1).collect();
        logs.iter().sum::<f64>() / logs.len() as f64
    };
    let first = orbit.steps().min(200);
    let around_slopes = [("yₙ", 1, &y, slope_y), ("zₙ", 4, &z, slope_z)].map(|(name, colour, of, slope)| {
        let series = Series::new("", colour, Mark::Line, of.correction(1, shown));
        let level = level(&format!("{name}: log {}", decimal(slope, 3)), colour, libm::log(slope), &series);
        [series, level]
    });
    Some(FigureEntry {
        id: "figure-de7",
        title: "dE7: linear growth with arithmetic noise",
        drawings: vec![
            log_log(
                "log h of y_n and of z_n against log n for dE7: two straight lines of slope 1",
                "yₙ), log h(zₙ",
                vec![
                    Series::new("yₙ", 1, Mark::Line, y.log_log()),
                    Series::new("zₙ", 4, Mark::Line, z.log_log()),
                ],
            ),
            drawing(
                "log of h over n against n for the first iterates of dE7: both curves fluctuate around constants",
                ["n", "log(h/n)"],
                around_slopes.concat(),
            ),
        ],
        data: html! { (orbit.data()) "; right: the first " (shown) },
        result: html! {
            "Least squares slopes over " (orbit.steps()) " iterates: " (decimal(slope_y, 3)) " for " i { "y" } " (log "
            (decimal(libm::log(slope_y), 3)) ") and " (decimal(slope_z, 3)) " for " i { "z" } " (log " (decimal(libm::log(slope_z), 3))
            "), ratio " (decimal(slope_z / slope_y, 3)) ". The mean of log(" i { "h" } "/" i { "n" } ") over the first "
            (first) " iterates of " i { "y" } " is " (decimal(mean(first), 4)) ". The fluctuations are those of prime "
            "numbers: the solution is a ratio of Γ functions, products over an arithmetic progression."
        },
        claims: &["section7", "e7"],
    })
}

pub(super) fn de9(orbits: &Orbits<'_>) -> Option<FigureEntry> {
    let orbit = Orbit::of(orbits, &DE9)?;
    let x = orbit.heights("x")?;
    let (n, last) = x.last();
    Some(FigureEntry {
        id: "figure-de9",
        title: "dE9: heights treble",
        drawings: vec![growth(
            "log h of x_n against log n for dE9: a curve that bends upwards",
            5,
            Mark::Both,
            &x,
        )],
        data: orbit.data(),
        result: html! {
            "Growth is " (orbit.measured.survey.growth) ": " (h("x", n)) " = " (decimal(last, 1)) ", "
            (grouped(orbit.digits("x"))) " digits; the last step multiplied " i { "h" } "(" i { "x" } ") by "
            (decimal(x.last_ratio(), 4)) ". The flow has two integrals at every ξ; these "
            "heights speak against such a pair for its map at this one."
        },
        claims: &["section7", "e9"],
    })
}
