//! The colours of drawings, for light and for dark surroundings.
//!
//! The six colours of curves stay apart for readers who lack one of the three kinds of cones, and
//! each stands out from the paper as text has to.

use std::fmt::Write as _;

use clap::ValueEnum;

/// A colour of the style sheet by the name of its variable, and what it is.
type Named = (&'static str, &'static str);

/// On light paper.
const LIGHT: [Named; 10] = [
    ("--paper", "#fdfcf9"),
    ("--ink", "#1d2126"),
    ("--soft", "#575e67"),
    ("--rule", "#d9d6cd"),
    ("--c1", "#1f76bf"),
    ("--c2", "#085a3f"),
    ("--c3", "#810000"),
    ("--c4", "#8a6500"),
    ("--c5", "#762a83"),
    ("--c6", "#6b7280"),
];

/// On dark paper.
const DARK: [Named; 10] = [
    ("--paper", "#14171b"),
    ("--ink", "#e4e6e8"),
    ("--soft", "#a3abb5"),
    ("--rule", "#353b43"),
    ("--c1", "#2d8cb5"),
    ("--c2", "#62d9a7"),
    ("--c3", "#f4806f"),
    ("--c4", "#edd15b"),
    ("--c5", "#dbb6fd"),
    ("--c6", "#9aa3af"),
];

/// The rules that all drawings share; colours are variables.
const RULES: &str = include_str!("drawing.css");

/// Which colours a drawing has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Theme {
    /// Light or dark, as the viewer has it.
    Viewer,
    /// Light everywhere.
    Light,
    /// Dark everywhere.
    Dark,
}

/// The style sheet of drawings; `root` is the element that the colours are declared at.
pub(crate) fn style(root: &str, theme: Theme) -> String {
    let declared = |colours: &[Named]| {
        colours.iter().fold(String::new(), |css, (name, value)| css + name + ":" + value + ";")
    };
    let fixed = |colours: &[Named]| {
        colours
            .iter()
            .fold(RULES.to_owned(), |css, (name, value)| css.replace(&format!("var({name})"), value))
    };
    match theme {
        Theme::Light => fixed(&LIGHT),
        Theme::Dark => fixed(&DARK),
        Theme::Viewer => {
            let mut css = format!("{root}{{{}}}\n", declared(&LIGHT));
            // Writing to a string cannot fail.
            let _ = writeln!(css, "@media (prefers-color-scheme:dark){{{root}{{{}}}}}", declared(&DARK));
            css + RULES
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::sight::{KINDS, contrast, distance, rgb, seen};
    use super::{DARK, LIGHT, RULES, Theme, style};

    #[test]
    fn curves_differ_for_every_kind_of_sight_and_stand_out_from_the_paper() {
        for colours in [LIGHT, DARK] {
            let colours = colours.map(|(_, hex)| rgb(hex));
            let (paper, curves) = (colours[0], &colours[4..]);
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
    fn fixed_colours_leave_no_variable_behind() {
        assert!(RULES.contains("var(--c1)"));
        for theme in [Theme::Light, Theme::Dark] {
            assert!(!style("svg", theme).contains("var("));
        }
    }
}
