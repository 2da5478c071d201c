//! Orbits from many first points, in the plane or in space: all their points, or those of a
//! section.

use std::collections::HashSet;

use kahan_core::observe::{Crossing, Direction, Observer, Section as Crossings};
use kahan_runtime::Field;
use kahan_study::Plane;

use super::axes::Coordinate;
use super::orbits::notes;
use super::starts::rounded;
use super::{Drawn, Subject, Visits};
use crate::printing::Refusal;
use kahan_draw::{Cloud, Mark, NumberLine, Plot, Series, Space};

/// Colours that orbits have in turn; the sixth is grey, for what they are compared with.
const COLOURS: usize = 5;

/// The points of an orbit, as the axes show them.
type Orbit<const N: usize> = Vec<[f64; N]>;

/// An orbit with the mark of its points.
struct Marked<const N: usize> {
    points: Orbit<N>,
    mark: Mark,
    visits: Visits,
}

fn visits<const N: usize>(orbits: &[Marked<N>]) -> Vec<Visits> {
    orbits.iter().map(|orbit| orbit.visits).collect()
}

/// How often an orbit is seen, and at how many places that can be told apart in a picture.
fn places<const N: usize>(axes: &[NumberLine; N], orbit: &Orbit<N>) -> Visits {
    /// Parts of an axis, about as wide as a small dot.
    const PARTS: f64 = 200.0;

    let is_shown = |point: &&[f64; N]| axes.iter().zip(*point).all(|(axis, value)| axis.shows(*value));
    let cell = |point: &[f64; N]| {
        std::array::from_fn::<_, N, _>(|i| (axes[i].place(point[i], 0.0, PARTS)).round() as i64)
    };
    let cells: HashSet<[i64; N]> = orbit.iter().filter(is_shown).map(cell).collect();
    Visits { points: orbit.len(), places: cells.len() }
}

impl Subject<'_> {
    pub(super) fn portrait(&self) -> Result<Drawn, Refusal> {
        let plane = self.plane()?;
        let coordinates = self.coordinates(plane.as_ref())?;
        let names: Vec<&str> = coordinates.iter().map(|coordinate| self.axis_name(*coordinate)).collect();
        self.check_windows(&names)?;
        let description = self.shown(&names);
        Ok(match coordinates[..] {
            [x, y] => {
                let (orbits, notes) = self.orbits([x, y], plane.as_ref())?;
                let axes = self.portrait_axes([x, y], &orbits)?;
                let orbits = self.marked(&axes, orbits);
                let visits = visits(&orbits);
                let series = orbits.into_iter().enumerate().map(|(index, orbit)| {
                    let points = orbit.points.into_iter().map(|[x, y]| (x, y)).collect();
                    Series::new("", index % COLOURS + 1, orbit.mark, points)
                });
                let [x, y] = axes;
                let (size, levels) = (self.sheet.view_box(), Vec::new());
                let plot = Plot { description, size, x, y, levels, series: series.collect() };
                let points = plot.series.iter().map(|series| series.points.len()).sum();
                Drawn { drawing: plot.drawing(), points, outside: plot.outside(), visits, notes }
            }
            [x, y, z] => {
                let (orbits, notes) = self.orbits([x, y, z], plane.as_ref())?;
                let axes = self.portrait_axes([x, y, z], &orbits)?;
                let orbits = self.marked(&axes, orbits);
                let visits = visits(&orbits);
                let clouds = orbits.into_iter().enumerate().map(|(index, Marked { points, mark, .. })| {
                    Cloud { colour: index % COLOURS + 1, mark, points }
                });
                let space =
                    Space { description, size: self.sheet.view_box(), axes, clouds: clouds.collect() };
                let points = space.clouds.iter().map(|cloud| cloud.points.len()).sum();
                Drawn { drawing: space.drawing(), points, outside: space.outside(), visits, notes }
            }
            _ => return Err(Refusal::new("--axes: a portrait has two axes or three")),
        })
    }

    /// Marks by how many points there are, without those of orbits that always come back to the
    /// same few places: these are drawn by dots that can be seen.
    fn marked<const N: usize>(&self, axes: &[NumberLine; N], orbits: Vec<Orbit<N>>) -> Vec<Marked<N>> {
        const FEW: usize = 24;

        let visits: Vec<Visits> = orbits.iter().map(|orbit| places(axes, orbit)).collect();
        let others = || visits.iter().filter(|visits| visits.places > FEW);
        let points: usize = others().map(|visits| visits.points).sum();
        let mark = |visits: &Visits| self.mark(if visits.places <= FEW { 0 } else { points as u64 });
        let marks: Vec<Mark> = visits.iter().map(mark).collect();
        let marked = orbits.into_iter().zip(marks).zip(visits);
        marked.map(|((points, mark), visits)| Marked { points, mark, visits }).collect()
    }

    /// What is seen, in words.
    fn shown(&self, names: &[&str]) -> String {
        let eps = self.asked.eps.as_deref().unwrap_or_default();
        let seen = self
            .asked
            .plane
            .as_ref()
            .map_or("Orbits".to_owned(), |plane| format!("The section {plane} = 0 of orbits"));
        format!("{seen} of {} at eps = {eps}, {} against each other", self.name, names.join(" and "))
    }

    /// What vanishes on a section, where there is one.
    fn plane(&self) -> Result<Option<Plane>, Refusal> {
        let Some(text) = &self.asked.plane else { return Ok(None) };
        Ok(Some(Plane::of(&self.system, &self.parameters(None)?, &self.eps()?, text)?))
    }

    /// The points of all orbits, as far as these go; and what to say of those that end early.
    fn orbits<const N: usize>(
        &self,
        coordinates: [Coordinate; N],
        plane: Option<&Plane>,
    ) -> Result<(Vec<Orbit<N>>, Vec<String>), Refusal> {
        let (starts, eps) = (self.starts()?, self.eps()?);
        let total = self.points(starts.len())?;
        let field = Field::of(&self.system);
        let map = self.map(&field, &self.parameters(None)?, &eps).ok_or_else(|| self.no_map())?;
        let time_step = 2.0 * eps.to_f64();
        let pace = self.pace(total);
        let mut ended = 0;
        let mut orbits = Vec::new();
        for start in starts.iter().take_while(|_| !pace.is_over()) {
            let mut orbit = Vec::new();
            let mut show = |n: f64, x: &[f64]| {
                orbit.push(coordinates.map(|coordinate| coordinate.of(n * time_step, x)));
            };
            let (start, steps) = (rounded(start), (0, self.asked.steps));
            let made = match plane {
                None => pace.follow(&map, &start, steps, |n, x| show(n as f64, x)),
                Some(plane) => {
                    let show = |at: Crossing<Vec<f64>, f64>| show(at.step as f64 + at.part, &at.point);
                    let mut crossings = Crossings::new(&map, plane.height(&map), Direction::Rising, show);
                    pace.follow(&map, &start, steps, |n, x| crossings.observe(n, x))
                }
            };
            ended += usize::from(made <= self.asked.steps);
            orbits.push(orbit);
        }
        pace.finish();
        let is_cut = pace.is_over() && (orbits.len() < starts.len() || ended > 0);
        Ok((orbits, notes(starts.len(), ended, is_cut)))
    }

    fn portrait_axes<const N: usize>(
        &self,
        coordinates: [Coordinate; N],
        orbits: &[Orbit<N>],
    ) -> Result<[NumberLine; N], Refusal> {
        let axes: Result<Vec<NumberLine>, Refusal> = (0..N)
            .map(|i| self.axis(coordinates[i], orbits.iter().flatten().map(|point| point[i])))
            .collect();
        axes?.try_into().map_err(|_| Refusal::new("--axes: a portrait has two axes or three"))
    }
}
