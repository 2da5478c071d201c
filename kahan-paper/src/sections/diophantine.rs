//! Section 7: the Diophantine test. What is measured here is measured on exact orbits.

use super::super::claim::Claim;
use super::super::erratum::Erratum::{A, B};
use super::super::figures::{DE1, DE2, DE3, DE4, DE5, DE6, DE7, DE7_1_5, DE7_2_9, DE8, DE9, Figure, LV};
use super::super::section::Section;

/// A measured statement on an orbit.
fn on(figure: &'static Figure, id: &str, place: &str, statement: &str) -> Claim {
    Claim::new(
        Section::Diophantine,
        ["section7", figure.system, id],
        figure.system,
        format!("Section 7, {place}"),
        statement,
    )
    .on(figure)
}

/// The claims, in the order of the paper.
pub(super) fn claims() -> Vec<Claim> {
    [growth(), integrable_maps(), transcendental_maps(), chaotic_maps()].concat()
}

/// Theorem 4, and the tests of the other maps.
fn growth() -> Vec<Claim> {
    let class = |figure, statement| on(figure, "growth", "growth of the heights, Theorem 4", statement);
    let beyond_theorem_4 = |figure, statement| on(figure, "growth", "growth of the heights", statement);
    vec![
        class(&DE1, "growth(x) = logarithmic; growth(z) = logarithmic"),
        class(&DE2, "growth(x) = logarithmic; growth(z) = logarithmic"),
        class(&DE3, "growth(x) = linear"),
        class(&DE4, "growth(x) = quadratic"),
        class(&DE5, "growth(x) = linear"),
        class(&DE6, "growth(x) = quadratic"),
        class(&DE7, "growth(y) = linear; growth(z) = linear"),
        class(&DE8, "growth(y) = linear; growth(z) = linear"),
        beyond_theorem_4(&DE9, "growth(x) = exponential"),
        beyond_theorem_4(&LV, "growth(x) = exponential"),
    ]
}

fn integrable_maps() -> Vec<Claim> {
    vec![
        on(&DE1, "log_height_x", "dE1: h(x_n) = log n + O(1)", "logslope(x, 500, 1000) ~ 1.0"),
        on(&DE1, "log_height_z", "dE1: h(z_n) = 2 log n + O(1)", "logslope(z, 100, 1000) ~ 2.0").misprinted(
            B(2),
            "logslope(z, 100, 1000) ~ 1.0",
            "",
        ),
        on(&DE2, "log_height_z", "dE2: h(z_n) = 4 log n + O(1)", "logslope(z, 100, 1000) ~ 4.0").misprinted(
            B(2),
            "logslope(z, 100, 1000) ~ 1.0",
            "",
        ),
        on(&DE1, "log_height_y", "dE1: h(y_n) = log n + O(1)", "logslope(y, 500, 1000) ~ 1.0"),
        on(&DE2, "log_height_x", "dE2: h(x_n) = log n + O(1)", "logslope(x, 500, 1000) ~ 1.0"),
        on(&DE3, "height", "figure dE3", "h(x, 200) ~ 3814.6"),
        on(&DE3, "slope", "figure dE3: h(x_n)/n tends to log 68790267 + 2 delta", {
            "slope(x, 100, 200) ~ 19.098; log(68790267) + 2*atanh(1/2*sqrt(2*K)) ~ 19.098"
        })
        .spelling("K := 1/2*((3/7)^2 + (11/13)^2 + (23/47)^2)/(1 + 1/4*((3/7)^2 + (11/13)^2))"),
        on(&DE4, "digits", "figure dE4", "digits(x, 125) = 95282"),
        on(&DE4, "limit", "figure dE4: h(x_n)/n^2", "(h(x, 125) - 2*h(x, 75) + h(x, 25))/(2*50^2) ~ 14.05"),
        on(&DE6, "digits", "dE6, addition", "digits(x, 125) = 114682"),
        on(
            &DE6,
            "limit",
            "dE6: h(x_n)/n^2, addition",
            "(h(x, 125) - 2*h(x, 75) + h(x, 25))/(2*50^2) ~ 16.89",
        ),
    ]
}

fn transcendental_maps() -> Vec<Claim> {
    let constant = |system: &'static str, id: &str, place: &str, statement: &str| {
        Claim::new(
            Section::Diophantine,
            ["section7", system, id],
            system,
            format!("Section 7, {place}"),
            statement,
        )
    };
    vec![
        on(&DE7, "height_x", "figure of 400 iterates: h(x_n) grows like log n only", {
            "logslope(x, 500, 1000) ~ 1.0"
        })
        .explaining(B(5)),
        on(&DE7, "slope_y", "figure dE7, slope of h(y_n)", "slope(y, 1, 2000) ~ 4.955"),
        on(
            &DE7,
            "slope_z",
            "figure dE7, slope of h(z_n)",
            "slope(z, 1, 2000) ~ 13.470; log(slope(z, 1, 2000)) ~ 2.600",
        )
        .misprinted(B(1), "log(slope(z, 1, 2000)) ~ 2.64", ""),
        on(&DE7, "mean", "1.64 is the mean over 200 iterates, not a limit", "mean(y, 1, 200) ~ 1.6406")
            .explaining(B(1)),
        constant(
            "e7",
            "C1",
            "the limit C1 of h(y_n)/n",
            "C1_e7(19/17, 7/3) ~ 4.923275; log(C1_e7(19/17, 7/3)) ~ 1.5940",
        )
        .misprinted(B(1), "log(C1_e7(19/17, 7/3)) ~ 1.64", ""),
        constant(
            "e7",
            "C1.dependence",
            "the limit C1 from x0 = 1/5 and 2/9: it depends on the initial point",
            "C1_e7(19/17, 5) ~ 3.8767; C1_e7(19/17, 9/2) ~ 2.4098",
        )
        .misprinted(
            B(1),
            "C1_e7(19/17, 5) - C1_e7(19/17, 7/3) ~ 0.00; C1_e7(19/17, 9/2) - C1_e7(19/17, 7/3) ~ 0.00",
            "",
        ),
        on(
            &DE7_1_5,
            "dependence.1_5",
            "the slopes from x0 = 1/5: their ratio is not e",
            "slope(y, 1, 2000) ~ 3.87; slope(z, 1, 2000) ~ 9.62; slope(z, 1, 2000)/slope(y, 1, 2000) ~ 2.49",
        )
        .misprinted(B(1), "slope(z, 1, 2000)/slope(y, 1, 2000) ~ 2.718", ""),
        on(
            &DE7_2_9,
            "dependence.2_9",
            "the slopes from x0 = 2/9: their ratio is not e",
            "slope(y, 1, 2000) ~ 2.40; slope(z, 1, 2000) ~ 5.77; slope(z, 1, 2000)/slope(y, 1, 2000) ~ 2.40",
        )
        .misprinted(B(1), "slope(z, 1, 2000)/slope(y, 1, 2000) ~ 2.718", ""),
        on(&DE8, "slope_y", "dE8, slope of h(y_n), addition", "slope(y, 1, 2000) ~ 3.596"),
        on(&DE8, "slope_z", "dE8, slope of h(z_n), addition", "slope(z, 1, 2000) ~ 10.781"),
        on(&DE8, "ratio", "dE8: h(z_n) grows three times as fast as h(y_n), addition", {
            "slope(z, 1, 2000)/slope(y, 1, 2000) ~ 3.00"
        }),
        constant(
            "e8",
            "C1",
            "the limit C1 of h(y_n)/n for dE8, addition",
            "C1_e8(7/3) = 18/5; C1_e8(1/2) = 1",
        ),
    ]
}

fn chaotic_maps() -> Vec<Claim> {
    vec![
        on(&LV, "height", "figure of the Lotka-Volterra map", "h(x, 17) ~ 748359.97; digits(x, 17) = 325009")
            .misprinted(A(10), "log(h(x, 17))/log(10) ~ 325009", ""),
        on(
            &LV,
            "ratio",
            "the Lotka-Volterra map: h doubles, entropy log 2",
            "h(x, 16)/h(x, 15) ~ 2.000; h(x, 17)/h(x, 16) ~ 2.000; log(h(x, 17)/h(x, 16)) ~ 0.693",
        ),
        on(&DE9, "height", "figure of dE9", "h(x, 11) ~ 934584.8; digits(x, 11) = 405886"),
        on(
            &DE9,
            "ratio",
            "dE9: h is multiplied by 3, entropy log 3",
            "h(x, 10)/h(x, 9) ~ 3.00; h(x, 11)/h(x, 10) ~ 3.00; log(h(x, 11)/h(x, 10)) ~ 1.099",
        ),
    ]
}
