//! An orbit of the paper with its heights, and measurements of how the heights grow.

use maud::{Markup, html};

use super::super::found::Orbits;
use kahan_draw::document::readable;
use kahan_paper::figures::{Figure, Measurement, slope};
use kahan_paper::structure;
use kahan_study::{Study, Subject, Systems};
use kahan_systems::registry::find;

/// A measured orbit, with the figure that defines its system and initial state.
pub(super) struct Orbit<'a> {
    pub(super) figure: &'static Figure,
    pub(super) measured: &'a Measurement,
}

/// The logarithmic heights log max(|p|, |q|) of the values p/q of one variable along an orbit.
pub(super) struct Heights(pub(super) Vec<f64>);

impl Heights {
    pub(super) fn pairs(&self) -> impl Iterator<Item = (f64, f64)> {
        self.0.iter().enumerate().skip(1).map(|(n, h)| (n as f64, *h))
    }

    pub(super) fn log_log(&self) -> Vec<(f64, f64)> {
        self.pairs().map(|(n, h)| (libm::log(n), libm::log(h))).collect()
    }

    /// Returns (n, log(hₙ/nᵖ)) for n ≤ `end`, with logarithmic heights hₙ and p = `power`.
    pub(super) fn correction(&self, power: i32, end: usize) -> Vec<(f64, f64)> {
        self.pairs().take(end).map(|(n, h)| (n, libm::log(h / n.powi(power)))).collect()
    }

    pub(super) fn last(&self) -> (usize, f64) {
        (self.0.len().saturating_sub(1), self.0.last().copied().unwrap_or(f64::NAN))
    }

    pub(super) fn last_ratio(&self) -> f64 {
        match self.0.as_slice() {
            [.., before, last] => last / before,
            _ => f64::NAN,
        }
    }

    pub(super) fn slope(&self) -> f64 {
        slope(self.pairs())
    }

    /// Returns the coefficient of n² in a parabola. It passes through the first, middle and last
    /// height of the orbit's second half.
    pub(super) fn half_second_difference(&self) -> f64 {
        let step = self.last().0 / 4;
        let (end, middle, start) = (self.last().0, self.last().0 - step, self.last().0 - 2 * step);
        (self.0[end] - 2.0 * self.0[middle] + self.0[start]) / (2.0 * (step * step) as f64)
    }
}

impl<'a> Orbit<'a> {
    pub(super) fn of(orbits: &Orbits<'a>, figure: &'static Figure) -> Option<Self> {
        Some(Orbit { figure, measured: orbits.get(figure.name)? })
    }

    pub(super) fn heights(&self, variable: &str) -> Option<Heights> {
        self.measured.log_heights(variable).map(Heights)
    }

    pub(super) fn steps(&self) -> usize {
        self.measured.survey.heights.len().saturating_sub(1)
    }

    pub(super) fn largest(&self) -> &str {
        &self.measured.variables[self.measured.survey.largest()]
    }

    pub(super) fn digits(&self, variable: &str) -> u64 {
        let index = self.measured.variables.iter().position(|known| known == variable);
        let last = self.measured.survey.heights.last();
        last.zip(index).map_or(0, |(heights, index)| heights.digits[index])
    }

    pub(super) fn data(&self) -> Markup {
        let figure = self.figure;
        let fraction = |(p, q): &(i64, i64)| {
            if *q == 1 { p.to_string() } else { format!("{p}/{q}").replace('-', "−") }
        };
        let list = |values: &[(i64, i64)]| values.iter().map(fraction).collect::<Vec<_>>().join(", ");
        let study = Subject::named(figure.system).study(&Systems).ok();
        html! {
            (map_name(figure))
            @for (name, value) in study.iter().flat_map(Study::parameters).zip(figure.parameters) {
                ", " (readable(name)) " = " (fraction(value))
            }
            ", ε = " (fraction(&figure.eps)) ", "
            "(" (self.measured.variables.join(", ")) ")" sub { "0" } " = (" (list(figure.start)) "), "
            (self.steps()) " iterates"
        }
    }
}

/// Returns the paper's name of the map, for example `dE3` or `Lotka–Volterra map`.
fn map_name(figure: &Figure) -> String {
    let name = find(figure.system).map_or(figure.system, |entry| entry.name);
    if structure(figure.system).is_some() { format!("d{name}") } else { format!("{name} map") }
}

pub(super) fn h(variable: &str, n: usize) -> Markup {
    html! { i { "h" } "(" i { (variable) } sub { (n) } ")" }
}
