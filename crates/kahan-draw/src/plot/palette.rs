//! Colours of drawings. The six colours of curves can be distinguished in grey print, and by
//! readers who lack one kind of cones. Each colour has enough contrast for text.

use std::fmt::Write as _;

use maud::{Markup, html};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Colour {
    /// The name of the CSS variable.
    name: &'static str,
    light: &'static str,
    dark: &'static str,
    print: &'static str,
}

impl Colour {
    const fn new(name: &'static str, light: &'static str, dark: &'static str, print: &'static str) -> Self {
        Colour { name, light, dark, print }
    }

    /// Makes a colour of curves. The light variant is also the colour in print.
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

/// The fill and stroke of one kind of element. Colours are attributes of elements, because all
/// programs that show SVG read attributes. For [`Theme::Viewer`], a style sheet replaces them by
/// dark colours on dark screens.
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
    pub(super) fn curve(colour: usize) -> Self {
        Paint::CURVES[colour - 1]
    }

    pub(super) fn class(self) -> &'static str {
        self.class
    }

    pub(super) fn fill(self, theme: Theme) -> &'static str {
        self.fill.map_or("none", |colour| colour.on(theme))
    }

    fn stroke(self, theme: Theme) -> &'static str {
        self.stroke.map_or("none", |colour| colour.on(theme))
    }

    pub(super) fn group(self, theme: Theme, elements: &Markup) -> Markup {
        html! { g.(self.class) fill=(self.fill(theme)) stroke=(self.stroke(theme)) { (elements) } }
    }

    fn all() -> impl Iterator<Item = Paint> {
        let parts = [Paint::PAPER, Paint::GRID, Paint::AXES, Paint::TICKS, Paint::NAMES, Paint::BAND];
        parts.into_iter().chain(Paint::CURVES)
    }

    fn rule(self) -> String {
        let property = |name: &str, colour: Option<Colour>| {
            colour.map_or_else(String::new, |colour| format!("{name}:{};", colour.dark))
        };
        format!(".{}{{{}{}}}\n", self.class, property("fill", self.fill), property("stroke", self.stroke))
    }
}

/// The colours of a drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Light or dark, as the viewer prefers.
    #[default]
    Viewer,
    /// Always light.
    Light,
    /// Always dark.
    Dark,
    /// Black on white with thin lines, for print. A unit of the view box is 0.01 inch.
    Paper,
}

impl Theme {
    pub(super) fn line(self, width: f64) -> f64 {
        const THIN: f64 = 0.6;
        if self == Theme::Paper { THIN * width } else { width }
    }
}

/// Returns the style sheet with the dark colours of [`Theme::Viewer`].
pub(crate) fn style(theme: Theme) -> String {
    match theme {
        Theme::Viewer => {
            let dark: String = Paint::all().map(Paint::rule).collect();
            format!("@media (prefers-color-scheme:dark){{\n{dark}}}\n")
        }
        Theme::Light | Theme::Dark | Theme::Paper => String::new(),
    }
}

/// Declares the light and dark colours of a page as CSS variables.
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
    use super::super::colour_vision::{KINDS, contrast, distance, lab, rgb, simulated};
    use super::{CURVES, PAPER, Paint, Theme, style};

    #[test]
    fn curves_differ_for_every_kind_of_sight_and_stand_out_from_the_paper() {
        for theme in [Theme::Light, Theme::Dark, Theme::Paper] {
            let (paper, curves) = (rgb(PAPER.on(theme)), CURVES.map(|colour| rgb(colour.on(theme))));
            for (i, &one) in curves.iter().enumerate() {
                // The web guidelines (WCAG) require this contrast of text.
                assert!(contrast(one, paper) >= 4.5, "c{}", i + 1);
                for (j, &other) in curves.iter().enumerate().skip(i + 1) {
                    for kind in KINDS {
                        // People can distinguish colours at a distance of about 2 in L*a*b*.
                        let apart = distance(simulated(one, kind), simulated(other, kind));
                        assert!(apart >= 20.0, "c{} and c{} as {kind:?}: {apart}", i + 1, j + 1);
                    }
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
