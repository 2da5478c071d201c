//! Above the axes: what stands for what, with as many lines as that takes.

use maud::{Markup, html};

use super::label::{SMALL, fitted, text, width};
use super::palette::Paint;
use super::path::Place;
use super::{Series, Sheet};

/// The width of what is drawn before the words.
const SAMPLE: f64 = 20.0;
/// The height of a line of words.
const LINE: f64 = 14.5;
/// What is left free on the left and on the right.
const FREE: f64 = 8.0;

/// The legend of a drawing.
pub(super) struct Legend<'a> {
    sheet: Sheet,
    /// Where words begin, what they are in which size, and the series before them; a note has none.
    entries: Vec<(Place, (String, f64), Option<&'a Series>)>,
}

impl<'a> Legend<'a> {
    /// Of the series that have a label, with a note behind them that may be empty.
    pub(super) fn of(series: &'a [Series], note: &str, sheet: Sheet) -> Self {
        let series = series.iter().filter(|series| !series.label.is_empty());
        let named = series.map(|series| (series.label.as_str(), Some(series)));
        let notes = Some(note).filter(|note| !note.is_empty()).map(|note| (note, None));
        let (room, mut x, mut y) = (sheet.view_box.0 - 2.0 * FREE, 0.0, 0.0);
        let entry = |(words, series): (&str, Option<&'a Series>)| {
            let sample = if series.is_some() { SAMPLE + 5.0 } else { 0.0 };
            let (words, size) = fitted(words, SMALL, room - sample);
            let long = sample + width(&words, size);
            if x + long > room {
                (x, y) = (0.0, y + LINE);
            }
            let place = (FREE + x + sample, FREE + 8.0 + y);
            x += long + 10.0;
            (place, (words, size), series)
        };
        Legend { sheet, entries: named.chain(notes).map(entry).collect() }
    }

    /// How much room it takes, from above.
    pub(super) fn height(&self) -> f64 {
        self.entries.last().map_or(0.0, |((_, y), ..)| y + 2.0)
    }

    pub(super) fn drawn(&self) -> Markup {
        let sample = |(x, y): Place, series: &Series| {
            let along = |part: f64| (x - 5.0 - SAMPLE * part, y - 4.0);
            series.shape(self.sheet.theme, &[vec![along(1.0), along(0.0)]], &[along(0.5)])
        };
        html! {
            @if !self.entries.is_empty() {
                @for (place, _, series) in &self.entries {
                    @if let Some(series) = series { (sample(*place, series)) }
                }
                (Paint::NAMES.group(self.sheet.theme, &html! {
                    @for (place, (words, size), _) in &self.entries { (text(*place, 0, "start", *size, words)) }
                }))
            }
        }
    }
}
