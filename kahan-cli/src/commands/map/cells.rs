//! The orbits of a map's cells, on all processors.

use kahan_algebra::rational::Rational;
use kahan_core::observe::{Drift, Fli, Lyapunov, Megno, Observer, Sali};
use kahan_runtime::{Field, MapAt, TangentAt, threads};

use super::Colour;
use crate::printing::{Progress, Refusal};
use crate::reading::{Range, Request, number};

/// What the cells are made of.
pub(super) struct Cells<'a> {
    request: &'a Request,
    ranges: &'a [Range<'a>; 2],
    /// What each range goes through.
    targets: [Target; 2],
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

impl<'a> Cells<'a> {
    /// The cells of these ranges; refused where a range has no name of the system.
    pub(super) fn new(
        request: &'a Request,
        ranges: &'a [Range<'a>; 2],
        colour: Colour,
        steps: u64,
        escape: &str,
    ) -> Result<Self, Refusal> {
        let escape = number(escape, "--escape")?.to_f64();
        let field = Field::of(&request.system);
        if colour == Colour::Drift && field.integrals().is_empty() {
            return Err(Refusal::new(format!("--color drift: {} claims no integral", request.name)));
        }
        let targets = [target(request, &ranges[0])?, target(request, &ranges[1])?];
        if targets[0] == targets[1] {
            return Err(Refusal::new(format!(
                "--over: `{}` is gone through twice; name two",
                ranges[0].name
            )));
        }
        Ok(Cells { request, ranges, targets, field, colour, steps, escape })
    }

    /// What each cell shows, row by row from below; not a number where it is empty.
    pub(super) fn values(&self) -> Result<Vec<f64>, Refusal> {
        let [across, upwards] = self.ranges;
        // Where the map is the same for all cells, a mistake is told once.
        self.request.in_floats()?;
        let progress = Progress::new((across.steps * upwards.steps) as u64, "orbits");
        let rows = threads::map(upwards.steps, |row| {
            let values: Vec<f64> = (0..across.steps).map(|column| self.value(column, row)).collect();
            progress.advance(across.steps as u64);
            values
        });
        progress.finish();
        Ok(rows.into_iter().flatten().collect())
    }

    fn value(&self, column: usize, row: usize) -> f64 {
        let mut point = self.request.point.clone();
        for (target, value) in
            self.targets.iter().zip([self.ranges[0].middle(column), self.ranges[1].middle(row)])
        {
            match *target {
                Target::Variable(k) => point.state[k] = value,
                Target::Parameter(k) => point.parameters[k] = value,
                Target::Epsilon => point.eps = value,
            }
        }
        let values = self.field.parameters().iter().zip(&point.parameters);
        // Where the field divides by zero there is no map.
        let Ok(map) = self.field.with(values) else { return f64::NAN };
        let start: Vec<f64> = point.state.iter().map(Rational::to_f64).collect();
        let at = map.at(point.eps.to_f64());
        let tangent = || at.tangent();
        match self.colour {
            Colour::Sali => logarithm(self.follow(&at, start, Sali::new(tangent()))),
            Colour::Fli => self.follow(&at, start, Fli::new(tangent())),
            Colour::Megno => self.follow(&at, start, Mean(Megno::new(tangent()))),
            Colour::Lyapunov => self.follow(&at, start, Value(Lyapunov::new(tangent()))),
            Colour::Drift => logarithm(self.follow(&at, start, Worst::new(&at))),
            Colour::Escape => self.escape_of(&at, start),
        }
    }

    /// What an observer says of an orbit; not a number where the orbit does not stay one.
    fn follow(
        &self,
        at: &MapAt<f64>,
        mut x: Vec<f64>,
        mut observer: impl Observer<f64, Report = f64>,
    ) -> f64 {
        observer.observe(0, &x);
        for step in 1..=self.steps {
            // The state is as long as the field has variables.
            let _ = at.advance(&mut x, 1);
            if !x.iter().all(|x| x.is_finite()) {
                return f64::NAN;
            }
            observer.observe(step, &x);
        }
        observer.report()
    }

    /// The step after which a variable is too large, or no number.
    fn escape_of(&self, at: &MapAt<f64>, mut x: Vec<f64>) -> f64 {
        for step in 0..=self.steps {
            if !x.iter().all(|x| x.abs() <= self.escape) {
                return step as f64;
            }
            // As above.
            let _ = at.advance(&mut x, 1);
        }
        f64::NAN
    }
}

/// To base 10; what is smaller than a rounding of 1 counts as that.
fn logarithm(value: f64) -> f64 {
    if value < f64::EPSILON { f64::EPSILON.log10() } else { value.log10() }
}

fn target(request: &Request, range: &Range<'_>) -> Result<Target, Refusal> {
    let symbols = &request.system.field.symbols;
    let place = |names: &[String]| names.iter().position(|name| name == range.name);
    let found = place(&symbols.states).map(Target::Variable);
    let found = found.or_else(|| place(&symbols.parameters).map(Target::Parameter));
    found.or((range.name == "eps").then_some(Target::Epsilon)).ok_or_else(|| {
        let known = symbols.states.iter().chain(&symbols.parameters).map(String::as_str);
        let known: Vec<&str> = known.chain(["eps"]).collect();
        Refusal::new(format!(
            "--over: `{}` is neither a variable nor a parameter of {}; there is {}",
            range.name,
            request.name,
            known.join(", ")
        ))
    })
}

/// The mean of MEGNO alone.
struct Mean(Megno<TangentAt<f64>, f64>);

impl Observer<f64> for Mean {
    type Report = f64;

    fn observe(&mut self, step: u64, x: &[f64]) {
        self.0.observe(step, x);
    }

    fn report(self) -> f64 {
        self.0.report().mean
    }
}

/// The exponent without its error.
struct Value(Lyapunov<TangentAt<f64>, f64>);

impl Observer<f64> for Value {
    type Report = f64;

    fn observe(&mut self, step: u64, x: &[f64]) {
        self.0.observe(step, x);
    }

    fn report(self) -> f64 {
        self.0.report().value
    }
}

/// The greatest drift of any integral.
struct Worst<'a> {
    at: &'a MapAt<f64>,
    values: Vec<f64>,
    drifts: Vec<Drift<Own, f64, 1>>,
}

/// A number as it is.
type Own = fn(&[f64]) -> [f64; 1];

impl<'a> Worst<'a> {
    fn new(at: &'a MapAt<f64>) -> Self {
        let count = at.map().field().integrals().len();
        let own: Own = |value| [value[0]];
        Worst { at, values: vec![0.0; count], drifts: (0..count).map(|_| Drift::of(own)).collect() }
    }
}

impl Observer<f64> for Worst<'_> {
    type Report = f64;

    fn observe(&mut self, step: u64, x: &[f64]) {
        // The state is as long as the field has variables.
        let _ = self.at.integrals(x, &mut self.values);
        for (drift, value) in self.drifts.iter_mut().zip(&self.values) {
            drift.observe(step, std::slice::from_ref(value));
        }
    }

    fn report(self) -> f64 {
        self.drifts.into_iter().map(|drift| drift.report()[0].max).fold(0.0, f64::max)
    }
}
