//! How the heights of an exact orbit grow.

use kahan_discover::{Progress, Watch};
use kahan_runtime::heights::{Growth, HeightsOrbit, Stop, Survey};

use super::{Drawn, Subject};
use crate::printing::{Prompt, Refusal};
use kahan_draw::{Mark, Plot, Series};

/// The most digits of a numerator or denominator.
const MOST_DIGITS: u64 = 1_000_000;

impl Subject<'_> {
    pub(super) fn heights(&self) -> Result<Drawn, Refusal> {
        self.check_windows(&[])?;
        let [at] = &self.asked.at[..] else {
            return Err(Refusal::new("--kind heights follows one orbit; give one --at"));
        };
        if self.asked.starts.is_some() || !self.asked.axes.is_empty() {
            return Err(Refusal::new(
                "--kind heights shows all variables of one orbit; leave --starts and --axes out",
            ));
        }
        let (parameters, eps, start) = (self.parameters(None)?, self.eps()?, self.point(at)?);
        let steps = self.asked.steps;
        let prompt = Prompt::new(steps, "steps");
        let orbit = HeightsOrbit::new(&self.system, &parameters, &eps, &start).map_err(|_| self.no_map())?;
        let mut orbit = orbit.within_digits(MOST_DIGITS);
        let survey = Survey::within(&mut orbit, steps, self.asked.seconds, &|| prompt.now(), |heights| {
            prompt.look(&Progress { what: "steps", done: heights.step as u64, of: Some(steps) })
        });
        prompt.finish();
        let is_exponential = survey.growth == Growth::Exponential;
        let mark = if survey.heights.len() < 30 { Mark::Both } else { Mark::Line };
        let series = |index: usize| {
            let heights = survey.component(index).into_iter().enumerate().skip(1);
            let across = |n: usize| if is_exponential { n as f64 } else { (n as f64).ln() };
            let points = heights.map(|(n, h)| (across(n), h.ln()));
            // A height of 0 has no logarithm.
            let points = points.filter(|point| point.1.is_finite()).collect();
            Series::new(&self.variables()[index], index % 5 + 1, mark, points)
        };
        let series: Vec<Series> = (0..self.variables().len()).map(series).collect();
        let description =
            format!("Logarithms of the heights of {} at eps = {eps}: growth is {}", self.name, survey.growth);
        let across = if is_exponential { "n" } else { "log n" };
        let plot = Plot::around(&description, [across, "log of the height h"], series);
        let plot = Plot { size: self.sheet.view_box(), ..plot };
        let points = plot.series.iter().map(|series| series.points.len()).sum();
        let mut notes = vec![format!("growth is {}", survey.growth)];
        notes.extend(survey.stopped.map(|stop| {
            let made = survey.heights.len().saturating_sub(1);
            let why = match stop {
                Stop::Pole => "the map has a pole there",
                Stop::Digits => "the next point would have more than a million digits",
                Stop::Seconds => "time ran out",
            };
            format!("the orbit ends after {made} of {steps} steps: {why}")
        }));
        Ok(Drawn { drawing: plot.drawing(), points, outside: 0, visits: Vec::new(), notes })
    }
}
