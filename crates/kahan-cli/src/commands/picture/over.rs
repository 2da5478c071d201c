//! Orbit diagrams: what orbits tend to, over the values of a parameter or of ε.

use kahan_algebra::rational::Rational;
use kahan_runtime::Field;
use kahan_study::{Axis, Spacing};

use super::axes::Coordinate;
use super::orbits::notes;
use super::starts::rounded;
use super::{Drawn, Subject};
use crate::printing::Refusal;
use crate::reading::over;
use kahan_draw::{Mark, NumberLine, Plot, Series};

impl Subject<'_> {
    pub(super) fn orbits_over(&self) -> Result<Drawn, Refusal> {
        let axis = self.asked.over.as_deref().expect("the kind of picture has --over");
        // So many steps were one value more.
        let axis = over(axis, |steps| Spacing::Count(steps + 1))?;
        self.check_range(&axis)?;
        let ordinate = match &self.asked.axes[..] {
            [] => Coordinate::Variable(0),
            [name] => self.coordinate(name.trim())?,
            _ => {
                return Err(Refusal::new(
                    "--axes: an orbit diagram has one variable upwards, as in --axes x",
                ));
            }
        };
        if ordinate == Coordinate::Time {
            return Err(Refusal::new("--axes: an orbit diagram shows a variable, and t is none"));
        }
        let name = self.axis_name(ordinate);
        self.check_windows(&[&axis.name, name])?;
        let starts: Vec<Vec<f64>> = self.starts()?.iter().map(|start| rounded(start)).collect();
        let orbits = starts.len() * axis.range.count();
        let points = self.points(orbits)?;
        let field = Field::of(&self.system);
        let pace = self.pace(points.saturating_add(self.asked.transient.saturating_mul(orbits as u64)));
        let mut shown: Vec<Vec<(f64, f64)>> = vec![Vec::new(); starts.len()];
        let (mut ended, mut last) = (0, 0);
        for (index, value) in axis.range.values().enumerate().take_while(|_| !pace.is_over()) {
            last = index;
            let (parameters, eps) = if axis.name == "eps" {
                (self.parameters(None)?, value.clone())
            } else {
                (self.parameters(Some((&axis.name, &value)))?, self.eps()?)
            };
            let Some(map) = self.map(&field, &parameters, &eps) else {
                ended += starts.len();
                continue;
            };
            let at = value.to_f64();
            for (start, shown) in starts.iter().zip(&mut shown) {
                let steps = (self.asked.transient, self.asked.steps);
                let made = pace.follow(&map, start, steps, |_, x| shown.push((at, ordinate.of(0.0, x))));
                ended += usize::from(made <= self.asked.steps);
            }
        }
        pace.finish();
        let is_cut = pace.is_over() && (last + 1 < axis.range.count() || ended > 0);
        let label = if axis.name == "eps" { "ε, half the time step, in units of time" } else { &axis.name };
        let ends = axis.range.ends();
        let [from, to] = &ends;
        let x = self.windowed(&axis.name, NumberLine::around(label, ends.iter().map(Rational::to_f64)))?;
        let y = self.axis(ordinate, shown.iter().flatten().map(|point| point.1))?;
        let mark = if points > 2000 { Mark::Fine } else { Mark::Points };
        let series = shown.into_iter().enumerate();
        let series = series.map(|(index, points)| Series::new("", index % 5 + 1, mark, points));
        let description = format!(
            "{name} of {} over {} from {from} to {to}, after {} steps",
            self.name, axis.name, self.asked.transient
        );
        let size = self.sheet.view_box();
        let plot = Plot { description, size, x, y, levels: Vec::new(), series: series.collect() };
        let points = plot.series.iter().map(|series| series.points.len()).sum();
        let notes = notes(orbits, ended, is_cut);
        Ok(Drawn { drawing: plot.drawing(), points, outside: plot.outside(), visits: Vec::new(), notes })
    }

    /// Refuses a range of what is no parameter, or has a value already.
    fn check_range(&self, axis: &Axis) -> Result<(), Refusal> {
        let known = &self.system.field.symbols.parameters;
        if axis.name == "eps" {
            return match self.asked.eps {
                Some(_) => Err(Refusal::new("--over goes through values of eps; leave --eps out")),
                None => Ok(()),
            };
        }
        if known.contains(&axis.name) {
            return Ok(());
        }
        let known: Vec<&str> = known.iter().map(String::as_str).chain(["eps"]).collect();
        Err(Refusal::new(format!(
            "--over: `{}` is no parameter of {}; there is {}",
            axis.name,
            self.name,
            known.join(", ")
        )))
    }
}
