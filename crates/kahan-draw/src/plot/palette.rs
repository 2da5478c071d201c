//! The colours of drawings, for light and for dark surroundings.
//!
//! The six colours of curves stay apart for readers who lack one of the three kinds of cones, and
//! each stands out from the paper as text has to.

use std::fmt::Write as _;

use maud::{Markup, html};

/// A colour on light paper and on dark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Colour {
    /// The name by which the style sheet of a page knows it.
    name: &'static str,
    light: &'static str,
    dark: &'static str,
}

impl Colour {
    const fn new(name: &'static str, light: &'static str, dark: &'static str) -> Self {
        Colour { name, light, dark }
    }
}

const PAPER: Colour = Colour::new("--paper", "#fdfcf9", "#14171b");
const INK: Colour = Colour::new("--ink", "#1d2126", "#e4e6e8");
const SOFT: Colour = Colour::new("--soft", "#575e67", "#a3abb5");
const RULE: Colour = Colour::new("--rule", "#d9d6cd", "#353b43");
const CURVES: [Colour; 6] = [
    Colour::new("--c1", "#1f76bf", "#2d8cb5"),
    Colour::new("--c2", "#085a3f", "#62d9a7"),
    Colour::new("--c3", "#810000", "#f4806f"),
    Colour::new("--c4", "#8a6500", "#edd15b"),
    Colour::new("--c5", "#762a83", "#dbb6fd"),
    Colour::new("--c6", "#6b7280", "#9aa3af"),
];

/// What the elements of one part of a drawing are painted with.
///
/// The light colours stand in the elements, where every program that reads SVG finds them; the dark
/// ones are rules of a style sheet for the class. Programs that know no such rules draw in light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paint {
    class: &'static str,
    fill: Option<Colour>,
    stroke: Option<Colour>,
}

impl Paint {
    const fn filled(class: &'static str, colour: Colour) -> Self {
        Paint { class, fill: Some(colour), stroke: None }
    }

    const fn drawn(class: &'static str, colour: Colour) -> Self {
        Paint { class, fill: None, stroke: Some(colour) }
    }

    pub(super) const PAPER: Paint = Paint::filled("paper", PAPER);
    pub(super) const GRID: Paint = Paint::drawn("grid", RULE);
    pub(super) const AXES: Paint = Paint::drawn("axes", SOFT);
    pub(super) const TICKS: Paint = Paint::filled("ticks", SOFT);
    pub(super) const NAMES: Paint = Paint::filled("names", INK);
    pub(super) const LEVEL: Paint = Paint::drawn("level", SOFT);
    pub(super) const LEVEL_NAME: Paint = Paint::filled("level-name", SOFT);
    /// Behind words that curves run through.
    pub(super) const HALO: Paint = Paint { class: "halo", fill: Some(PAPER), stroke: Some(PAPER) };
    const CURVES: [Paint; 6] = [
        Paint::drawn("c1", CURVES[0]),
        Paint::drawn("c2", CURVES[1]),
        Paint::drawn("c3", CURVES[2]),
        Paint::drawn("c4", CURVES[3]),
        Paint::drawn("c5", CURVES[4]),
        Paint::drawn("c6", CURVES[5]),
    ];
    const LABELS: [Paint; 6] = [
        Paint::filled("label1", CURVES[0]),
        Paint::filled("label2", CURVES[1]),
        Paint::filled("label3", CURVES[2]),
        Paint::filled("label4", CURVES[3]),
        Paint::filled("label5", CURVES[4]),
        Paint::filled("label6", CURVES[5]),
    ];

    /// The lines and dots of a colour, 1 to 6.
    pub(super) fn curve(colour: usize) -> Self {
        Paint::CURVES[colour - 1]
    }

    /// The words beside such a curve.
    pub(super) fn label(colour: usize) -> Self {
        Paint::LABELS[colour - 1]
    }

    pub(super) fn class(self) -> &'static str {
        self.class
    }

    /// What the attribute `fill` says.
    pub(super) fn fill(self) -> &'static str {
        self.fill.map_or("none", |colour| colour.light)
    }

    /// What the attribute `stroke` says.
    pub(super) fn stroke(self) -> &'static str {
        self.stroke.map_or("none", |colour| colour.light)
    }

    /// Elements that are painted with it.
    pub(super) fn group(self, elements: &Markup) -> Markup {
        html! { g.(self.class) fill=(self.fill()) stroke=(self.stroke()) { (elements) } }
    }

    fn all() -> impl Iterator<Item = Paint> {
        let parts = [
            Paint::PAPER,
            Paint::GRID,
            Paint::AXES,
            Paint::TICKS,
            Paint::NAMES,
            Paint::LEVEL,
            Paint::LEVEL_NAME,
            Paint::HALO,
        ];
        parts.into_iter().chain(Paint::CURVES).chain(Paint::LABELS)
    }

    /// The rule that makes it dark.
    fn rule(self) -> String {
        let property = |name: &str, colour: Option<Colour>| {
            colour.map_or_else(String::new, |colour| format!("{name}:{};", colour.dark))
        };
        format!(".{}{{{}{}}}\n", self.class, property("fill", self.fill), property("stroke", self.stroke))
    }
}

/// Which colours a drawing has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theme {
    /// Light or dark, as the viewer has it.
    Viewer,
    /// Light everywhere.
    Light,
    /// Dark everywhere.
    Dark,
}

impl Theme {
    /// All of them.
    pub const ALL: [Theme; 3] = [Theme::Viewer, Theme::Light, Theme::Dark];

    /// Its name in questions of how a drawing looks.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Theme::Viewer => "viewer",
            Theme::Light => "light",
            Theme::Dark => "dark",
        }
    }
}

/// Larger words on narrow windows, as on telephones.
const NARROW: &str =
    "@media (max-width:46rem){svg text{font-size:16px}.ticks text,.level-name text{font-size:14.5px}}\n";

/// The style sheet of drawings.
pub(crate) fn style(theme: Theme) -> String {
    let dark: String = Paint::all().map(Paint::rule).collect();
    let dark = match theme {
        Theme::Viewer => format!("@media (prefers-color-scheme:dark){{\n{dark}}}\n"),
        Theme::Light => String::new(),
        Theme::Dark => dark,
    };
    dark + NARROW
}

/// The colours of drawings as variables of a page, which are light or dark as the reader has it.
pub(crate) fn variables() -> String {
    let colours = || [PAPER, INK, SOFT, RULE].into_iter().chain(CURVES);
    let declared = |value: fn(Colour) -> &'static str| {
        colours().fold(String::new(), |mut css, colour| {
            // Writing to a string cannot fail.
            let _ = write!(css, "{}:{};", colour.name, value(colour));
            css
        })
    };
    format!(
        ":root{{{}}}\n@media (prefers-color-scheme:dark){{:root{{{}}}}}\n",
        declared(|colour| colour.light),
        declared(|colour| colour.dark)
    )
}

#[cfg(test)]
mod tests {
    use super::super::sight::{KINDS, contrast, distance, rgb, seen};
    use super::{CURVES, Colour, PAPER, Paint, Theme, style};

    #[test]
    fn curves_differ_for_every_kind_of_sight_and_stand_out_from_the_paper() {
        for value in [|colour: Colour| colour.light, |colour: Colour| colour.dark] {
            let (paper, curves) = (rgb(value(PAPER)), CURVES.map(|colour| rgb(value(colour))));
            for (i, &one) in curves.iter().enumerate() {
                // What guidelines for the web ask of text.
                assert!(contrast(one, paper) >= 4.5, "c{}", i + 1);
                for (j, &other) in curves.iter().enumerate().skip(i + 1) {
                    for kind in KINDS {
                        // About nine times the smallest difference that is noticed side by side.
                        let apart = distance(seen(one, kind), seen(other, kind));
                        assert!(apart >= 20.0, "c{} and c{} as {kind:?}: {apart}", i + 1, j + 1);
                    }
                }
            }
        }
    }

    #[test]
    fn every_part_is_told_from_the_others_and_made_dark_by_its_class() {
        let dark = style(Theme::Dark);
        assert!(
            style(Theme::Viewer)
                .contains(&format!("@media (prefers-color-scheme:dark){{\n{}", Paint::PAPER.rule()))
        );
        for paint in Paint::all() {
            assert_eq!(dark.matches(&format!(".{}{{", paint.class)).count(), 1, "{}", paint.class);
        }
        assert!(!style(Theme::Light).contains('#'));
    }
}
