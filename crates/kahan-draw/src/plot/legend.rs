//! The legend above the axes.

use maud::{Markup, html};

use super::label::{SMALL_FONT_SIZE, fit_to_width, text, width};
use super::palette::Paint;
use super::path::Place;
use super::{Canvas, Series};

const SAMPLE_WIDTH: f64 = 20.0;
const LINE_HEIGHT: f64 = 14.5;
const FREE: f64 = 8.0;

pub(super) struct Legend<'a> {
    sheet: Canvas,
    /// The position, text, font size and series of each entry. A note has no series.
    entries: Vec<(Place, (String, f64), Option<&'a Series>)>,
}

impl<'a> Legend<'a> {
    /// Makes the legend of all series with labels. The note comes last.
    pub(super) fn of(series: &'a [Series], note: &str, sheet: Canvas) -> Self {
        let series = series.iter().filter(|series| !series.label.is_empty());
        let named = series.map(|series| (series.label.as_str(), Some(series)));
        let notes = Some(note).filter(|note| !note.is_empty()).map(|note| (note, None));
        let (room, mut x, mut y) = (sheet.view_box.0 - 2.0 * FREE, 0.0, 0.0);
        let entry = |(words, series): (&str, Option<&'a Series>)| {
            let sample = if series.is_some() { SAMPLE_WIDTH + 5.0 } else { 0.0 };
            let (words, size) = fit_to_width(words, SMALL_FONT_SIZE, room - sample);
            let long = sample + width(&words, size);
            if x + long > room {
                (x, y) = (0.0, y + LINE_HEIGHT);
            }
            let place = (FREE + x + sample, FREE + 8.0 + y);
            x += long + 10.0;
            (place, (words, size), series)
        };
        Legend { sheet, entries: named.chain(notes).map(entry).collect() }
    }

    pub(super) fn height(&self) -> f64 {
        self.entries.last().map_or(0.0, |((_, y), ..)| y + 2.0)
    }

    pub(super) fn drawn(&self) -> Markup {
        let sample = |(x, y): Place, series: &Series| {
            let along = |part: f64| (x - 5.0 - SAMPLE_WIDTH * part, y - 4.0);
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
