//! Measures and describes errors of a lift's relations, such as sin_x = sin(x), along an orbit.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_core::observe::Visit;
use kahan_lift::Lift;
use kahan_runtime::Follow;

use crate::error::StudyError;
use crate::formula::formula_of;
use crate::lifted::{LiftFound, RelationFate, RelationFound};
use crate::study::Study;
use crate::subject::{Catalog, Subject};

/// The errors of the relations of a lift along an orbit of the map.
#[derive(Clone, Debug)]
pub struct RelationErrors {
    /// The largest error of each relation in each of the equal segments of the orbit; infinite if a
    /// function is undefined.
    pub errors: Vec<Vec<f64>>,
    /// The requested steps, or fewer if the orbit ended early.
    pub steps: u64,
}

type PointFunction = Box<dyn Fn(&[f64]) -> f64>;

enum Error {
    /// The relative difference between a new variable and its defining function.
    Defined(usize),
    /// A function of all variables that vanishes where the relation holds.
    Function(PointFunction),
}

impl Error {
    fn at(&self, point: &[f64], states: usize, functions: &[f64]) -> f64 {
        let size = match self {
            Error::Defined(place) => {
                (functions[*place] - point[states + place]).abs() / functions[*place].abs().max(1.0)
            }
            Error::Function(function) => function(point).abs(),
        };
        if size.is_nan() { f64::INFINITY } else { size }
    }
}

impl Study {
    /// Measures the errors of the relations of a lift along an orbit of Kahan's map, in `parts`
    /// equal segments. The list is empty without a lift.
    ///
    /// # Errors
    /// Missing values, or a start of the wrong length.
    ///
    /// # Panics
    /// If `parts` is 0.
    pub fn relation_errors(
        &self,
        at: &[Rational],
        eps: &Rational,
        steps: u64,
        parts: usize,
    ) -> Result<RelationErrors, StudyError> {
        let Some(lift) = self.lift() else { return Ok(RelationErrors { errors: Vec::new(), steps }) };
        let (map, mut x) = self.in_floats(at, eps)?;
        let values: Vec<f64> = self.values()?.iter().map(Rational::to_f64).collect();
        let known: Vec<(String, f64)> = self.parameters().iter().cloned().zip(values).collect();
        let own = |name: &String| known.iter().find(|(known, _)| known == name).map_or(f64::NAN, |own| own.1);
        let own: Vec<f64> = lift.parameters.iter().map(own).collect();
        let sizes = errors_of(lift, &known);
        let states = lift.states.len();
        let mut errors = vec![Vec::with_capacity(parts); sizes.len()];
        let look = Visit::by(|step: u64, x: &[f64]| {
            let part = (u128::from(step) * parts as u128 / (u128::from(steps) + 1)) as usize;
            let functions = lift.embed(&x[..states], &own);
            for (errors, size) in errors.iter_mut().zip(&sizes) {
                let error = size.at(x, states, &functions);
                errors.resize(part + 1, errors.last().copied().unwrap_or(error).min(error));
                errors[part] = error.max(errors[part]);
            }
        });
        let followed = map.observe(&mut x, steps, look, |_| ControlFlow::Continue(()));
        let end = followed.expect("the start is of the field").end;
        Ok(RelationErrors { errors, steps: end.steps(steps) })
    }
}

fn errors_of(lift: &Lift, known: &[(String, f64)]) -> Vec<Error> {
    let names: Vec<&str> = lift.variables().iter().map(String::as_str).collect();
    let error = |relation: &kahan_lift::Relation| match relation.defines {
        Some(place) => Error::Defined(place),
        None => {
            let formula = formula_of(&names, &relation.text, known);
            let formula = formula.expect("a relation is a formula of the variables");
            Error::Function(Box::new(formula.function()))
        }
    };
    lift.relations.iter().map(error).collect()
}

impl Subject {
    /// Reads the field like [`study`](Subject::study). If no first point is given, lifts are
    /// compared along [`Study::shown_orbit`]. For this, all parameters must have values.
    ///
    /// # Errors
    /// The errors of [`study`](Subject::study).
    pub fn study_to_show(&self, catalog: &dyn Catalog) -> Result<Study, StudyError> {
        let study = self.study(catalog)?;
        let Some(lifting) = self.lifting.as_ref().filter(|_| study.lift_start().is_none()) else {
            return Ok(study);
        };
        let Ok(shown) = study.shown_orbit(None, None) else { return Ok(study) };
        let lifting = crate::Lifting { start: Some(shown.start), ..lifting.clone() };
        self.clone().lifting(lifting).study(catalog)
    }

    /// Returns whether the equations are not quadratic, but of a kind that can be lifted.
    #[must_use]
    pub fn calls_for_a_lift(&self) -> bool {
        match &self.field {
            crate::subject::SubjectSource::Text(text) if self.lifting.is_none() => {
                text.unproved_system().is_err() && text.read_by(kahan_lift::stated).is_ok()
            }
            _ => false,
        }
    }
}

impl LiftFound {
    /// Writes a relation as an equation: `sin_x = sin(x)`.
    #[must_use]
    pub fn equation(&self, relation: &RelationFound) -> String {
        let defined = relation.defines.map(|place| &self.new[place]);
        let sides = defined.and_then(|new| Some((&new.name, new.expression.as_ref()?)));
        sides
            .map_or_else(|| format!("{} = 0", relation.relation), |(name, value)| format!("{name} = {value}"))
    }

    /// Describes whether a complete search has excluded lifts with fewer new variables.
    #[must_use]
    pub fn optimality(&self) -> &'static str {
        if self.optimal {
            "the search for fewer new variables was complete and found none"
        } else {
            "a lift with fewer new variables may exist"
        }
    }
}

impl RelationFound {
    /// Describes the behaviour along the orbit, such as `bounded` or `kept exactly: …`.
    #[must_use]
    pub fn verdict(&self) -> String {
        self.verdict_asking("give a first point")
    }

    /// Describes the error along the orbit. Without an orbit, repeats the advice `for_point`.
    #[must_use]
    pub fn verdict_asking(&self, for_point: &str) -> String {
        let rate = self.rate.map_or_else(String::new, |rate| format!(" at the rate {rate:.3}"));
        match (self.along, &self.formula) {
            (_, Some(formula)) => format!("kept exactly: {formula}"),
            (Some(RelationFate::Kept), None) => "kept exactly".to_owned(),
            (Some(RelationFate::Bounded), _) => "bounded".to_owned(),
            (Some(RelationFate::Decays), _) => format!("decays{rate}"),
            (Some(RelationFate::Drifts), _) => "drifts".to_owned(),
            (Some(RelationFate::Grows), _) => format!("grows{rate}"),
            (None, _) => format!("not followed: {for_point}, and a value to each parameter"),
        }
    }
}
