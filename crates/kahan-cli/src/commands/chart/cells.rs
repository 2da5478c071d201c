//! The orbits of a chart's cells, on all processors.

use std::ops::Range;

use kahan_algebra::interpret::Point;
use kahan_algebra::rational::Rational;
use kahan_runtime::{Field, Indicator, MapAt, threads};
use kahan_study::Axis;

use super::Colour;
use crate::printing::{Prompt, Refusal};
use crate::reading::{Request, number};

/// Cells whose orbits a thread follows together.
const STRETCH: usize = 256;

/// What the cells are made of.
pub(super) struct Cells<'a> {
    request: &'a Request,
    /// What each range goes through, one or two.
    targets: Vec<Target>,
    /// The values that it goes through.
    along: Vec<Vec<Rational>>,
    field: Field,
    colour: Colour,
    steps: u64,
    escape: f64,
}

/// What a range goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Target {
    Variable(usize),
    Parameter(usize),
    Epsilon,
}

impl Target {
    /// Whether each of its values has a map of its own.
    fn is_of_the_map(self) -> bool {
        !matches!(self, Target::Variable(_))
    }
}

impl<'a> Cells<'a> {
    /// The cells of these ranges; refused where a range has no name of the system.
    pub(super) fn new(
        request: &'a Request,
        axes: &[Axis],
        colour: Colour,
        steps: u64,
        escape: &str,
    ) -> Result<Self, Refusal> {
        let escape = number(escape, "--escape")?.to_f64();
        let field = Field::of(&request.system);
        if colour == Colour::Drift && field.integrals().is_empty() {
            return Err(Refusal::new(format!("--color drift: {} claims no integral", request.name)));
        }
        let targets: Vec<Target> = axes.iter().map(|axis| target(request, axis)).collect::<Result<_, _>>()?;
        if let [across, upwards] = targets[..]
            && across == upwards
        {
            return Err(Refusal::new(format!("--over: `{}` is gone through twice; name two", axes[0].name)));
        }
        let along = axes.iter().map(|axis| axis.range.values().collect()).collect();
        Ok(Cells { request, targets, along, field, colour, steps, escape })
    }

    /// What each cell shows, row by row from below; not a number where it is empty.
    pub(super) fn values(&self) -> Result<Vec<f64>, Refusal> {
        // Where the map is the same for all cells, a mistake is told once.
        self.request.in_floats()?;
        let cells = self.along.iter().map(Vec::len).product::<usize>();
        let progress = Prompt::new(cells as u64, "orbits");
        let stretches = threads::map(cells.div_ceil(STRETCH), None, |stretch| {
            let cells = stretch * STRETCH..cells.min((stretch + 1) * STRETCH);
            let values = Stretch::of(self, cells.clone()).values(self);
            progress.advance(cells.len() as u64);
            values
        });
        progress.finish();
        Ok(stretches.concat())
    }

    /// What is asked of each orbit, and how a cell shows it.
    fn asked(&self) -> (Indicator, fn(f64) -> f64) {
        let itself: fn(f64) -> f64 = |value| value;
        match self.colour {
            Colour::Sali => (Indicator::Sali, logarithm),
            Colour::Fli => (Indicator::Fli, itself),
            Colour::Megno => (Indicator::Megno, itself),
            Colour::Lyapunov => (Indicator::Lyapunov, itself),
            Colour::Drift => (Indicator::Drift, logarithm),
            Colour::Escape => (Indicator::Escape(self.escape), itself),
        }
    }

    /// The point of a cell: state, parameters and ε.
    fn point(&self, places: [usize; 2]) -> Point<Rational> {
        let mut point = self.request.point.clone();
        for ((target, values), place) in self.targets.iter().zip(&self.along).zip(places) {
            let own = match *target {
                Target::Variable(k) => &mut point.state[k],
                Target::Parameter(k) => &mut point.parameters[k],
                Target::Epsilon => &mut point.eps,
            };
            own.clone_from(&values[place]);
        }
        point
    }
}

/// The orbits of consecutive cells.
struct Stretch {
    /// Where they are in the stretch; cells where the field divides by zero have none.
    cells: Vec<usize>,
    /// How many cells there are.
    len: usize,
    /// The maps, each once for neighbours that have it in common.
    maps: Vec<MapAt<f64>>,
    /// Which of them each orbit has.
    map_of: Vec<usize>,
    /// The first points, a column a variable.
    columns: Vec<Vec<f64>>,
}

impl Stretch {
    fn of(all: &Cells<'_>, cells: Range<usize>) -> Self {
        let columns = vec![Vec::new(); all.request.point.state.len()];
        let (maps, map_of) = (Vec::new(), Vec::new());
        let mut stretch = Stretch { cells: Vec::new(), len: cells.len(), maps, map_of, columns };
        let (mut last, mut is_defined) = (None, false);
        for (cell, index) in cells.enumerate() {
            let places = [index % all.along[0].len(), index / all.along[0].len()];
            let point = all.point(places);
            let is_of_map = |k: usize| all.targets.get(k).is_some_and(|target| target.is_of_the_map());
            let of_map = [0, 1].map(|k| Some(places[k]).filter(|_| is_of_map(k)));
            if last != Some(of_map) {
                last = Some(of_map);
                let values = all.field.parameters().iter().zip(&point.parameters);
                let map = all.field.with(values).map(|map| map.at(point.eps.to_f64()));
                is_defined = map.is_ok();
                stretch.maps.extend(map);
            }
            if is_defined {
                stretch.cells.push(cell);
                stretch.map_of.push(stretch.maps.len() - 1);
                for (column, value) in stretch.columns.iter_mut().zip(&point.state) {
                    column.push(value.to_f64());
                }
            }
        }
        stretch
    }

    /// What each cell shows.
    fn values(mut self, all: &Cells<'_>) -> Vec<f64> {
        let maps: Vec<&MapAt<f64>> = self.map_of.iter().map(|map| &self.maps[*map]).collect();
        let mut columns: Vec<&mut [f64]> = self.columns.iter_mut().map(Vec::as_mut_slice).collect();
        let (indicator, shown) = all.asked();
        let found = indicator.of(&maps, &mut columns, all.steps);
        let found = found.expect("a map an orbit, of as many variables as there are columns");
        let mut values = vec![f64::NAN; self.len];
        self.cells.iter().zip(found).for_each(|(cell, value)| values[*cell] = shown(value));
        values
    }
}

/// To base 10; what is smaller than a rounding of 1 counts as that.
pub(super) fn logarithm(value: f64) -> f64 {
    if value < f64::EPSILON { f64::EPSILON.log10() } else { value.log10() }
}

fn target(request: &Request, axis: &Axis) -> Result<Target, Refusal> {
    let symbols = &request.system.field.symbols;
    let place = |names: &[String]| names.iter().position(|name| *name == axis.name);
    let found = place(&symbols.states).map(Target::Variable);
    let found = found.or_else(|| place(&symbols.parameters).map(Target::Parameter));
    found.or((axis.name == "eps").then_some(Target::Epsilon)).ok_or_else(|| {
        let known = symbols.states.iter().chain(&symbols.parameters).map(String::as_str);
        let known: Vec<&str> = known.chain(["eps"]).collect();
        Refusal::new(format!(
            "--over: `{}` is neither a variable nor a parameter of {}; there is {}",
            axis.name,
            request.name,
            known.join(", ")
        ))
    })
}
