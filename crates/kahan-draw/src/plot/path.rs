//! SVG elements whose positions are rounded to tenths.

use std::collections::HashSet;
use std::fmt::Write as _;

use maud::{Markup, html};

pub(super) type Place = (f64, f64);

pub(super) fn line(from: Place, to: Place) -> Markup {
    html! { line x1=(tenths(from.0)) y1=(tenths(from.1)) x2=(tenths(to.0)) y2=(tenths(to.1)) {} }
}

/// Draws a path that [`polyline`], [`dots`] or [`rings`] returned.
pub(super) fn stroked(class: &str, shape: &str, width: f64, dashes: Option<&str>) -> Markup {
    html! {
        path.(class) d=(shape) stroke-width=((100.0 * width).round() / 100.0) stroke-dasharray=[dashes]
            stroke-linejoin="round" stroke-linecap="round" {}
    }
}

pub(super) fn rings(places: &[Place], radius: f64) -> String {
    let half = |by: f64| format!("a{radius} {radius} 0 1 0 {} 0", tenths(by));
    let ring = |&(x, y): &Place| {
        format!("M{} {}{}{}Z", tenths(x - radius), tenths(y), half(2.0 * radius), half(-2.0 * radius))
    };
    places.iter().map(ring).collect()
}

/// The path of a dot. Its length is not 0, because some programs omit paths of length 0.
const DOT_PATH: &str = "h.01";

/// Returns the path of a line. Equal neighbours are merged, and a single position becomes a dot.
pub(super) fn polyline(places: &[Place]) -> String {
    let mut path = String::new();
    let mut before = None;
    for &(x, y) in places {
        let here = (tenths(x), tenths(y));
        if before.as_ref() != Some(&here) {
            let command = if before.is_none() { 'M' } else { 'L' };
            let _ = write!(path, "{command}{} {}", here.0, here.1);
            before = Some(here);
        }
    }
    if before.is_some() && !path.contains('L') {
        path += DOT_PATH;
    }
    path
}

/// The number of dots beyond which close dots are merged, to keep the SVG below a megabyte.
const MOST_DOTS: usize = 100_000;

/// Returns the path of a dot at each position. A dot is a short line with round ends, because
/// circles take three times the bytes. Coinciding dots are merged. Among very many dots, close dots
/// are merged too.
pub(super) fn dots(places: &[Place]) -> String {
    let distinct = |units: f64| {
        let mut seen = HashSet::new();
        let cell = |&(x, y): &Place| ((x / units).round() as i64, (y / units).round() as i64);
        places.iter().map(cell).filter(|cell| seen.insert(*cell)).collect::<Vec<_>>()
    };
    let mut units = 0.1;
    let mut cells = distinct(units);
    for coarser in [0.5, 1.0] {
        if cells.len() > MOST_DOTS {
            (units, cells) = (coarser, distinct(coarser));
        }
    }
    let dot = if cells.len() == 1 { DOT_PATH } else { "h0" };
    cells.into_iter().fold(String::new(), |mut path, (x, y)| {
        let _ = write!(path, "M{} {}{dot}", tenths(x as f64 * units), tenths(y as f64 * units));
        path
    })
}

pub(super) fn tenths(value: f64) -> String {
    let text = format!("{value:.1}");
    text.strip_suffix(".0").map_or_else(|| text.clone(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::{MOST_DOTS, dots, polyline};

    #[test]
    fn places_that_fall_together_are_one() {
        assert_eq!(polyline(&[(1.0, 2.0), (1.01, 2.04), (3.25, 4.0)]), "M1 2L3.2 4");
        assert_eq!(polyline(&[(1.0, 2.0), (1.01, 2.04)]), "M1 2h.01");
        assert_eq!(dots(&[(1.0, 2.0), (3.0, 4.0), (1.04, 1.96)]), "M1 2h0M3 4h0");
        assert_eq!(dots(&[(1.0, 2.0), (1.04, 1.96)]), "M1 2h.01");
    }

    #[test]
    fn very_many_dots_stay_a_small_file() {
        let cloud: Vec<(f64, f64)> =
            (0..4 * MOST_DOTS).map(|i| (400.0 * (i as f64 * 0.618_034).fract(), i as f64 * 6e-4)).collect();
        let path = dots(&cloud);
        assert!((500_000..1_500_000).contains(&path.len()), "{} bytes", path.len());
    }
}
