//! The colours of drawings, for light and for dark surroundings.
//!
//! The six colours of curves stay apart for readers who lack one of the three kinds of cones and in
//! grey print, and each stands out from the paper as text has to.

use std::fmt::Write as _;

use maud::{Markup, html};

/// A colour on light ground, on dark, and in print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Colour {
    /// The name by which the style sheet of a page knows it.
    name: &'static str,
    light: &'static str,
    dark: &'static str,
    print: &'static str,
}

impl Colour {
    const fn new(name: &'static str, light: &'static str, dark: &'static str, print: &'static str) -> Self {
        Colour { name, light, dark, print }
    }

    /// The colours of curves are dark enough for print as they are in light.
    const fn curve(name: &'static str, light: &'static str, dark: &'static str) -> Self {
        Colour::new(name, light, dark, light)
    }

    fn on(self, theme: Theme) -> &'static str {
        match theme {
            Theme::Viewer | Theme::Light => self.light,
            Theme::Dark => self.dark,
            Theme::Paper => self.print,
        }
    }
}

const PAPER: Colour = Colour::new("--paper", "#fdfcf9", "#14171b", "#ffffff");
const INK: Colour = Colour::new("--ink", "#1d2126", "#e4e6e8", "#000000");
const SOFT: Colour = Colour::new("--soft", "#575e67", "#a3abb5", "#000000");
const RULE: Colour = Colour::new("--rule", "#d9d6cd", "#353b43", "#dddddd");
const BAND: Colour = Colour::new("--band", "#cbc8bf", "#4a515a", "#cccccc");
const CURVES: [Colour; 6] = [
    Colour::curve("--c1", "#435bc6", "#2d8bb9"),
    Colour::curve("--c2", "#065440", "#59dfa7"),
    Colour::curve("--c3", "#68000b", "#e86d6c"),
    Colour::curve("--c4", "#784e03", "#f3db6b"),
    Colour::curve("--c5", "#5d1488", "#daa3ff"),
    Colour::curve("--c6", "#6b7280", "#9aa3af"),
];

/// What the elements of one part of a drawing are painted with.
///
/// The colours of a theme stand in the elements, where every program that reads SVG finds them. Of
/// a drawing that is light or dark as its viewer is, these are the light ones, and the dark ones are
/// rules of a style sheet for the class.
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
    pub(super) const BAND: Paint = Paint::drawn("band", BAND);
    const CURVES: [Paint; 6] = [
        Paint::drawn("c1", CURVES[0]),
        Paint::drawn("c2", CURVES[1]),
        Paint::drawn("c3", CURVES[2]),
        Paint::drawn("c4", CURVES[3]),
        Paint::drawn("c5", CURVES[4]),
        Paint::drawn("c6", CURVES[5]),
    ];
    /// The lines and dots of a colour, 1 to 6.
    pub(super) fn curve(colour: usize) -> Self {
        Paint::CURVES[colour - 1]
    }

    pub(super) fn class(self) -> &'static str {
        self.class
    }

    /// What the attribute `fill` says.
    pub(super) fn fill(self, theme: Theme) -> &'static str {
        self.fill.map_or("none", |colour| colour.on(theme))
    }

    /// What the attribute `stroke` says.
    fn stroke(self, theme: Theme) -> &'static str {
        self.stroke.map_or("none", |colour| colour.on(theme))
    }

    /// Elements that are painted with it.
    pub(super) fn group(self, theme: Theme, elements: &Markup) -> Markup {
        html! { g.(self.class) fill=(self.fill(theme)) stroke=(self.stroke(theme)) { (elements) } }
    }

    fn all() -> impl Iterator<Item = Paint> {
        let parts = [Paint::PAPER, Paint::GRID, Paint::AXES, Paint::TICKS, Paint::NAMES, Paint::BAND];
        parts.into_iter().chain(Paint::CURVES)
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Light or dark, as the viewer has it.
    #[default]
    Viewer,
    /// Light everywhere.
    Light,
    /// Dark everywhere.
    Dark,
    /// For print: black on white, in thin lines; a unit of the view box is a hundredth of an inch.
    Paper,
}

impl Theme {
    /// The width of a line that has this one on a screen.
    pub(super) fn line(self, width: f64) -> f64 {
        /// Lines are so much thinner in print.
        const THIN: f64 = 0.6;
        if self == Theme::Paper { THIN * width } else { width }
    }
}

/// The style sheet of drawings.
pub(crate) fn style(theme: Theme) -> String {
    match theme {
        Theme::Viewer => {
            let dark: String = Paint::all().map(Paint::rule).collect();
            format!("@media (prefers-color-scheme:dark){{\n{dark}}}\n")
        }
        Theme::Light | Theme::Dark | Theme::Paper => String::new(),
    }
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
    use super::super::sight::{KINDS, contrast, distance, lab, rgb, seen};
    use super::{CURVES, PAPER, Paint, Theme, style};

    #[test]
    fn curves_differ_for_every_kind_of_sight_and_stand_out_from_the_paper() {
        for theme in [Theme::Light, Theme::Dark, Theme::Paper] {
            let (paper, curves) = (rgb(PAPER.on(theme)), CURVES.map(|colour| rgb(colour.on(theme))));
            for (i, &one) in curves.iter().enumerate() {
                // What guidelines for the web ask of text.
                assert!(contrast(one, paper) >= 4.5, "c{}", i + 1);
                for (j, &other) in curves.iter().enumerate().skip(i + 1) {
                    for kind in KINDS {
                        // About nine times the smallest difference that is noticed side by side.
                        let apart = distance(seen(one, kind), seen(other, kind));
                        assert!(apart >= 20.0, "c{} and c{} as {kind:?}: {apart}", i + 1, j + 1);
                    }
                    // In grey print.
                    let grey = (lab(one)[0] - lab(other)[0]).abs();
                    assert!(grey >= 5.0, "c{} and c{} in grey: {grey}", i + 1, j + 1);
                }
            }
        }
    }

    #[test]
    fn every_part_is_told_from_the_others_and_made_dark_by_its_class() {
        let viewer = style(Theme::Viewer);
        for paint in Paint::all() {
            assert_eq!(viewer.matches(&format!(".{}{{", paint.class)).count(), 1, "{}", paint.class);
        }
        assert!([Theme::Light, Theme::Dark, Theme::Paper].iter().all(|theme| !style(*theme).contains('#')));
    }
}
