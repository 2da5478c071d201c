//! What orbits tend to, over the values of a parameter or of ε: an orbit diagram.

use kahan_algebra::rational::Rational;
use kahan_core::Step;
use kahan_core::observe::Visit;
use kahan_discover::Watch;
use kahan_runtime::{End, Follow};
use serde::{Deserialize, Serialize};

use crate::axes;
use crate::count::Count;
use crate::error::StudyError;
use crate::numbers::exact;
use crate::range::Axis;
use crate::study::Study;

/// Asks what one variable does after a transient, at each value of a parameter or of ε, in doubles.
/// Each orbit begins anew at the same point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Diagram {
    /// ε, half the time step; not looked at where `over` is of ε.
    #[serde(with = "exact", default)]
    pub eps: Option<Rational>,
    /// The first point of each orbit, a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The parameter that goes through values, or `eps`.
    #[serde(with = "axes")]
    pub over: Axis,
    /// The variable that is shown; the first where none is named.
    #[serde(default)]
    pub variable: Option<String>,
    /// The steps before what is shown.
    #[serde(default = "usual_transient")]
    pub transient: u64,
    /// The steps that are shown, after the point that the transient leads to.
    pub steps: u64,
    /// Whether each step of a lifted field is projected symmetrically onto the relations between
    /// its variables.
    #[serde(default)]
    pub reembed: bool,
}

fn usual_transient() -> u64 {
    1000
}

/// What orbits tend to.
#[derive(Clone, Debug, Serialize)]
pub struct DiagramFound {
    /// The name of the system.
    pub system: String,
    /// What goes through values.
    pub axis: String,
    /// What is shown.
    pub variable: String,
    /// The values that were gone through: all of them, unless the watch stopped the work.
    #[serde(with = "exact")]
    pub values: Vec<Rational>,
    /// At each of them the values of the variable: fewer than asked, or none, where the orbit ends
    /// at a pole or beyond the range of doubles, or the field is not defined.
    pub points: Vec<Vec<f64>>,
    /// At how many of them there are fewer than asked.
    pub ended: usize,
    /// Whether the watch stopped the work.
    pub stopped: bool,
}

impl Diagram {
    /// The first variable, after a thousand steps.
    #[must_use]
    pub fn new(eps: Option<Rational>, at: Vec<Rational>, over: Axis, steps: u64) -> Self {
        Diagram { eps, at, over, variable: None, transient: usual_transient(), steps, reembed: false }
    }

    /// Follows an orbit at each value. Costs so many orbits, and a number for each point shown.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing, an axis or a variable that
    /// the field does not have.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<DiagramFound, StudyError> {
        study.proved()?;
        study.can_reembed(self.reembed)?;
        let place = study.axis(&self.over)?;
        let shown = match &self.variable {
            None => 0,
            Some(name) => study.variable(name)?,
        };
        let mut parameters = study.values_but(|k| Some(k) == place)?;
        let fixed = if place.is_none() { Some(self.over.range.value(0)) } else { self.eps.clone() };
        let mut eps = fixed.ok_or(StudyError::MissingStep)?;
        study.has_coordinates(&self.at)?;
        let start: Vec<f64> = self.at.iter().map(Rational::to_f64).collect();
        let total = self.over.range.count() as u64 * (self.transient + self.steps);
        let count = Count::new("steps", total, watch);
        let tell = |steps| count.tell(steps);
        let mut found = DiagramFound {
            system: study.name().to_owned(),
            axis: self.over.name.clone(),
            variable: study.variables()[shown].clone(),
            values: Vec::new(),
            points: Vec::new(),
            ended: 0,
            stopped: false,
        };
        for value in self.over.range.values() {
            match place {
                Some(place) => parameters[place] = value.clone(),
                None => eps = value.clone(),
            }
            let at =
                study.map_at(&parameters).map(|map| map.at(eps.to_f64())).filter(|at| at.eps().is_finite());
            let mut points = Vec::new();
            if let Some(at) = at {
                let values: Vec<f64> = parameters.iter().map(Rational::to_f64).collect();
                let (mut x, mut take) = (study.embed(&start, &values), |_, x: &[f64]| points.push(x[shown]));
                let step = study.steps(&at, self.reembed);
                let at: &dyn Step<Scalar = f64> = step.as_ref().map_or(&at, |step| step);
                let mut end = at.follow(&mut x, self.transient, tell).expect("the start is of the field").end;
                if end == End::Complete && x.iter().all(|x| x.is_finite()) {
                    let followed = at.observe(&mut x, self.steps, Visit::by(&mut take), tell);
                    end = followed.expect("the point is of the field").end;
                }
                found.stopped = matches!(end, End::Stopped(_));
            }
            found.ended += usize::from(points.len() as u64 <= self.steps);
            found.values.push(value);
            found.points.push(points);
            if found.stopped {
                break;
            }
        }
        Ok(found)
    }
}
