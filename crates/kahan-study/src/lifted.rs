//! Lifted fields: new variables turn other equations into quadratic fields.
//!
//! Callers give points in the original variables, which determine the new variables.

use std::collections::HashSet;
use std::sync::OnceLock;

use kahan_algebra::diagnostics::Diagnostics;
use kahan_algebra::parse::parse_lifted;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::expression_text;
use kahan_algebra::syntax::{Claim, ClaimBody, Expr, TensorEntry};
use kahan_algebra::system::System;
use kahan_latex::Latex;
use kahan_lift::{Embedding, Lift, LiftCriterion, Options, RelationBehaviour, lift, stated};
use kahan_runtime::{FieldText, Relations};
use serde::{Serialize, Serializer};

use crate::columns::{ExpectedColumns, OtherColumns};
use crate::error::StudyError;
use crate::relations::RelationErrors;
use crate::study::Study;

/// The options of a lift.
#[derive(Clone, Debug, Default)]
pub struct Lifting {
    /// The criterion by which the lift is chosen.
    pub which: LiftCriterion,
    /// The start of the orbit along which lifts are compared, by default that in the text.
    pub start: Option<Vec<Rational>>,
    /// The names of the coordinates of `start`. If empty, the coordinates are in the order of the
    /// variables.
    pub names: Vec<String>,
    /// Values at which lifts are compared, of parameters that neither the caller nor the text sets.
    pub near: Vec<(String, Rational)>,
    /// The value of `t` at the start, if the equations depend on t.
    pub time: Rational,
    /// Whether answers show the new variables beside the original variables.
    pub shows_all: bool,
}

impl Lifting {
    /// Sorts the coordinates of the start by variable; drops an incomplete start.
    fn put_in_order(&mut self, states: &[String]) {
        let names = std::mem::take(&mut self.names);
        if !names.is_empty() {
            let places = ExpectedColumns::new(states, &[], OtherColumns::Ignored).places(&names);
            let start = self.start.take().zip(places.ok());
            let of = |start: &[Rational], place: &usize| start.get(*place).cloned();
            self.start =
                start.and_then(|(start, found)| found.states.iter().map(|place| of(&start, place)).collect());
        }
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Lifted {
    pub(crate) lift: Lift,
    pub(crate) given: FieldText,
    lifting: Lifting,
    /// The original variables, without `t`.
    original: Vec<String>,
    /// The variables that answers show; `places` holds the index of each among all variables.
    shown: Vec<String>,
    places: Vec<usize>,
    /// For each parameter of `lift`, its index among the field's; `None` if the field lacks it.
    parameters: Vec<Option<usize>>,
    /// The derivatives of the new variables by the original variables, computed on first use.
    slopes: OnceLock<Embedding>,
}

impl Lifted {
    /// Lifts the field of a text; `values` are the given values of parameters.
    pub(crate) fn of(
        given: &FieldText,
        lifting: &Lifting,
        values: &[(String, Rational)],
    ) -> Result<(Self, FieldText, System), StudyError> {
        let named = |name: &String, known: &[(String, Rational)]| {
            known.iter().find(|(known, _)| known == name).map(|(_, value)| value.to_f64())
        };
        let mut lifting = lifting.clone();
        let read = given.read_by(|tokens| {
            let stated = stated(tokens)?;
            let states = &stated.states[..stated.states.len() - usize::from(stated.has_time)];
            lifting.put_in_order(states);
            let start: Option<Vec<f64>> = match &lifting.start {
                Some(start) if start.len() == states.len() => {
                    Some(start.iter().map(Rational::to_f64).collect())
                }
                Some(_) => None,
                None => states.iter().map(|state| named(state, given.start())).collect(),
            };
            let time = stated.has_time.then(|| lifting.time.to_f64());
            let start = start.map(|start| start.into_iter().chain(time).collect());
            let parameters = stated.parameters.iter();
            let parameters = parameters
                .map(|name| {
                    let known = [values, given.parameters(), &lifting.near];
                    known.into_iter().find_map(|known| named(name, known))
                })
                .collect::<Option<Vec<f64>>>();
            lift(tokens, &Options { which: lifting.which, orbit: start.zip(parameters), budget: 0 })
        });
        let lift = read.map_err(StudyError::Field)?;
        let states = lift.states.len() - usize::from(lift.has_time);
        let original = lift.states[..states].to_vec();
        // If the text is already quadratic, its claims are kept as written.
        let as_written =
            (lift.order() == 0 && !lift.has_time).then(|| given.unproved_system().ok()).flatten();
        let (text, system) = match as_written {
            Some(system) => (given.clone(), system),
            None => quadratic(&lift, claims(given)?)?,
        };
        let known = &system.field.symbols.parameters;
        let place = |name: &String| known.iter().position(|known| known == name);
        let parameters = lift.parameters.iter().map(place).collect();
        let (given, slopes) = (given.clone(), OnceLock::new());
        let (shown, places) = (original.clone(), (0..states).collect());
        let lifted = Lifted { lift, given, lifting, original, shown, places, parameters, slopes };
        let lifted = if lifted.lifting.shows_all { lifted.showing_all() } else { lifted };
        Ok((lifted, text, system))
    }

    pub(crate) fn showing_all(&self) -> Self {
        let names = self.lift.variables();
        let places = (0..self.original.len()).chain(self.lift.states.len()..names.len());
        let places: Vec<usize> = places.collect();
        let shown = places.iter().map(|&place| names[place].clone()).collect();
        Lifted { shown, places, ..self.clone() }
    }

    /// Selects the values of the lift's parameters from the values of all parameters of the field.
    fn lift_parameters(&self, values: &[f64]) -> Vec<f64> {
        self.parameters.iter().map(|place| place.map_or(f64::NAN, |place| values[place])).collect()
    }

    /// Extends a point of the original variables to all variables. Undefined values become NaN.
    fn embed(&self, at: &[f64], values: &[f64], time: f64) -> Vec<f64> {
        let own = self.lift_parameters(values);
        let time = self.lift.has_time.then_some(time);
        let states: Vec<f64> = at.iter().copied().chain(time).collect();
        let new = self.lift.embed(&states, &own);
        states.into_iter().chain(new).collect()
    }
}

/// Extracts the claims in `given`, and the rational constants that they use. Returns the text and
/// the names of both.
fn claims(given: &FieldText) -> Result<(String, Vec<String>), StudyError> {
    let block = given.read_by(|tokens| {
        let mut mistakes = Diagnostics::default();
        let block = parse_lifted(tokens, &mut mistakes);
        let mistakes = mistakes.finish();
        if mistakes.is_empty() { Ok(block) } else { Err(mistakes) }
    });
    let conditions = |claim: &Claim| {
        let conditions = claim.conditions.iter();
        let texts =
            conditions.map(|one| format!("{} = {}", expression_text(&one.left), expression_text(&one.right)));
        let texts = texts.collect::<Vec<_>>().join(", ");
        if texts.is_empty() { texts } else { format!(" when {texts}") }
    };
    let entry = |entry: &TensorEntry| {
        let (row, column) = (&entry.row.text, &entry.column.text);
        format!("{{{row}, {column}}} = {};", expression_text(&entry.value))
    };
    let claim = |claim: &Claim| {
        let (kind, name) = (claim.kind.keyword(), &claim.name.text);
        let when = conditions(claim);
        Some(match claim.body.as_ref()? {
            ClaimBody::Function(value) => format!("\n{kind} {name} = {}{when};", expression_text(value)),
            ClaimBody::Recurrence { function, next } => {
                let [function, next] = [function, next].map(expression_text);
                format!("\n{kind} {name} = {function} by {next}{when};")
            }
            ClaimBody::Tensor(entries) => {
                format!("\n{kind} {name} {{ {} }}{when};", entries.iter().map(entry).collect::<String>())
            }
        })
    };
    let block = block.map_err(StudyError::Field)?;
    let mut named = HashSet::new();
    for value in block.claims.iter().filter_map(|claim| claim.body.as_ref()).flat_map(ClaimBody::expressions)
    {
        value.visit_names(&mut |name, _| {
            named.insert(name.to_string());
        });
    }
    // A constant that a claim uses may itself use earlier constants.
    let constants: Vec<(&str, Expr)> = block
        .constants
        .iter()
        .filter_map(|constant| Some((constant.name.text.as_str(), constant.value.as_ref()?.rational()?)))
        .collect();
    for (name, value) in constants.iter().rev() {
        if named.contains(*name) {
            value.visit_names(&mut |name, _| {
                named.insert(name.to_string());
            });
        }
    }
    let constant = |(name, value): &(&str, Expr)| format!("\nconst {name} = {};", expression_text(value));
    let constants: Vec<_> = constants.iter().filter(|(name, _)| named.contains(*name)).collect();
    let claims: Vec<_> = block.claims.iter().filter_map(|one| Some((&*one.name.text, claim(one)?))).collect();
    let names = constants.iter().map(|(name, _)| *name).chain(claims.iter().map(|(name, _)| *name));
    let names = names.map(str::to_owned).collect();
    Ok((constants.into_iter().map(constant).chain(claims.into_iter().map(|(_, text)| text)).collect(), names))
}

/// Builds the text of a lift, with the `given` claims, and the system of this text.
fn quadratic(
    lift: &Lift,
    (given, names_given): (String, Vec<String>),
) -> Result<(FieldText, System), StudyError> {
    let symbols = &lift.field.symbols;
    let is_used = |k: &usize| {
        let variable = symbols.parameter(*k);
        let mut components = lift.field.components.iter();
        components.any(|one| one.contains(variable))
    };
    let (used, others): (Vec<usize>, Vec<usize>) = (0..lift.parameters.len()).partition(is_used);
    let names = |places: &[usize]| places.iter().map(|&k| lift.parameters[k].clone()).collect::<Vec<_>>();
    let head = match &lift.header {
        Some(header) if used.is_empty() => format!("struct {};\n", header.name.text),
        Some(header) => format!("struct {} {{ {} }}\n", header.name.text, names(&used).join(", ")),
        None => String::new(),
    };
    let mut taken: Vec<String> =
        lift.variables().iter().chain(&lift.parameters).cloned().chain(names_given).collect();
    let mut free = |name: String| {
        let name = crate::rows::free_name(&taken, &name);
        taken.push(name.clone());
        name
    };
    let energy = lift.energy.iter().map(|formula| ("energy".to_owned(), formula));
    let kept = lift.relations.iter().filter_map(|relation| relation.formula.as_ref());
    let kept = kept.enumerate().map(|(place, formula)| (format!("R{}", place + 1), formula));
    let claims = energy.chain(kept);
    let claims: String =
        claims.map(|(name, formula)| format!("\nintegral {} = {formula};", free(name))).collect();
    let text = FieldText::new(format!("{head}{}{given}{claims}", lift.text()), "lift".to_owned());
    let system = text.unproved_system().map_err(StudyError::Field)?.with_parameters(&names(&others));
    Ok((text, System { header: lift.header.clone(), ..system }))
}

/// The new variables, and `t` if it was lifted, are functions of the original variables.
impl Relations for Lifted {
    fn originals(&self) -> usize {
        self.original.len()
    }

    fn slopes(&self, x: &[f64], parameters: &[f64]) -> Vec<f64> {
        let slopes = self.slopes.get_or_init(|| self.lift.slopes());
        let of_time = vec![0.0; usize::from(self.lift.has_time) * self.original.len()];
        let of_new = slopes.values(&x[..self.lift.states.len()], &self.lift_parameters(parameters));
        of_time.into_iter().chain(of_new).collect()
    }
}

impl Study {
    /// Returns the lift, if the field was lifted.
    #[must_use]
    pub fn lift(&self) -> Option<&Lift> {
        self.lifted().map(|lifted| &lifted.lift)
    }

    /// Returns the variables of points: for a lifted field, the original variables without `t`.
    #[must_use]
    pub fn coordinates(&self) -> &[String] {
        self.lifted().map_or_else(|| self.variables(), |lifted| &lifted.original)
    }

    /// Returns the variables that answers show: for a lifted field the original variables, and on
    /// request the new variables.
    #[must_use]
    pub fn shown(&self) -> &[String] {
        self.lifted().map_or_else(|| self.variables(), |lifted| &lifted.shown)
    }

    /// Returns the relations that define a lift's new variables; `None` without new variables.
    pub(crate) fn relations(&self) -> Option<&dyn Relations> {
        let lifted = self.lifted().filter(|lifted| lifted.original.len() < self.variables().len());
        lifted.map(|lifted| lifted as &dyn Relations)
    }

    /// Returns the time at the start of an orbit.
    #[must_use]
    pub fn time(&self) -> Rational {
        self.lifted().map_or_else(Rational::zero, |lifted| lifted.lifting.time.clone())
    }

    /// Returns the index of `t` among the variables, if `t` was lifted.
    #[must_use]
    pub fn time_place(&self) -> Option<usize> {
        self.lift().filter(|lift| lift.has_time).map(|lift| lift.states.len() - 1)
    }

    /// Returns the columns in answers, by index among step, time, all variables and integrals.
    pub(crate) fn columns_shown(&self, columns: usize) -> Vec<usize> {
        let Some(lifted) = self.lifted() else { return (0..columns).collect() };
        let time = self.time_place().map_or(1, |place| 2 + place);
        let variables = lifted.places.iter().map(|place| 2 + place);
        [0, time].into_iter().chain(variables).chain(2 + self.variables().len()..columns).collect()
    }

    /// Selects, from the values of all variables, the values of the variables that answers show.
    #[must_use]
    pub fn project<T: Clone>(&self, point: &[T]) -> Vec<T> {
        match self.lifted() {
            Some(lifted) => lifted.places.iter().map(|&place| point[place].clone()).collect(),
            None => point.to_vec(),
        }
    }

    /// Extends a point to all variables at these parameters. An undefined new variable is NaN.
    #[must_use]
    pub fn embed(&self, at: &[f64], values: &[f64]) -> Vec<f64> {
        self.embed_at(at, values, self.time().to_f64())
    }

    /// Extends a point to all variables, at a given time.
    #[must_use]
    pub fn embed_at(&self, at: &[f64], values: &[f64], time: f64) -> Vec<f64> {
        match self.lifted() {
            Some(lifted) if at.len() == lifted.original.len() => lifted.embed(at, values, time),
            _ => self.with_time(at, time),
        }
    }

    /// Inserts the time into a point, if `t` was lifted.
    fn with_time<T: Clone>(&self, at: &[T], time: T) -> Vec<T> {
        let mut all = at.to_vec();
        if let Some(place) =
            self.time_place().filter(|place| at.len() > *place && at.len() < self.variables().len())
        {
            all.insert(place, time);
        }
        all
    }

    /// Extends an exact point to all variables; fails if a new variable has no exact value.
    pub(crate) fn embedded(&self, at: &[Rational]) -> Result<Vec<Rational>, StudyError> {
        let Some(lifted) = self.lifted().filter(|lifted| lifted.original.len() == at.len()) else {
            return Ok(self.with_time(at, self.time()));
        };
        let values = self.values()?;
        let own = |name: &String| Ok(values[self.parameter(name)?].clone());
        let own = lifted.lift.parameters.iter().map(own).collect::<Result<Vec<_>, StudyError>>()?;
        let time = lifted.lift.has_time.then(|| self.time());
        let states: Vec<Rational> = at.iter().cloned().chain(time).collect();
        if let Some(new) = lifted.lift.embed_exact(&states, &own) {
            return Ok(states.into_iter().chain(new).collect());
        }
        let floats = |values: &[Rational]| values.iter().map(Rational::to_f64).collect::<Vec<_>>();
        let new = lifted.lift.embed(&floats(&states), &floats(&own));
        let undefined = lifted.lift.new.iter().zip(&new).find(|(_, value)| !value.is_finite());
        // If all floats are finite, the cause is unknown, and the first new variable is named.
        let (new, _) = undefined.or_else(|| lifted.lift.new.iter().zip(&new).next()).expect("a new variable");
        Err(StudyError::NotEmbedded {
            variable: new.name.clone(),
            expression: new.expression.clone().unwrap_or_default(),
        })
    }
}

/// The length of the time interval over which errors of relations are measured.
const HORIZON: f64 = 100.0;
const USUAL_STEP: f64 = 0.01;
/// Each eighth of an orbit has this number of segments, for which the largest error is kept.
const SEGMENTS_PER_EIGHTH: usize = 50;
/// An error that grows by this factor from the first to the last eighth of an orbit drifts.
const DRIFT_GROWTH: f64 = 1.5;
/// Errors of relations up to this size are attributed to rounding.
const LARGEST_ROUNDING_ERROR: f64 = 1e-11;

impl RelationErrors {
    /// Returns the factor by which the error of relation `place` grew from the first to the last
    /// eighth of the orbit; `None` if the last eighth is incomplete.
    pub(crate) fn drift(&self, place: usize) -> Option<f64> {
        let errors = &self.errors[place];
        let (first, last) = (
            errors.get(..SEGMENTS_PER_EIGHTH)?,
            errors.get(7 * SEGMENTS_PER_EIGHTH..8 * SEGMENTS_PER_EIGHTH)?,
        );
        let [first, last] =
            [first, last].map(|part| part.iter().copied().fold(LARGEST_ROUNDING_ERROR, f64::max));
        Some(last / first)
    }
}

impl Study {
    /// Measures the errors of the relations along an orbit until t = 100.
    pub(crate) fn measure_relations(&self, at: &[Rational], eps: f64) -> Result<RelationErrors, StudyError> {
        let steps = (HORIZON / (2.0 * eps)).ceil().clamp(8.0, 1e7) as u64;
        self.relation_errors(at, &Rational::from_f64(eps).unwrap_or_default(), steps, 8 * SEGMENTS_PER_EIGHTH)
    }

    /// Returns the first point of the orbit along which the lift was chosen, if there is one.
    #[must_use]
    pub fn lift_start(&self) -> Option<Vec<Rational>> {
        self.lifted()?.lifting.start.clone().or_else(|| self.start())
    }

    /// Describes the lift, if the field was lifted. If a start is known, measures the errors of the
    /// relations along an orbit at `eps`, by default 0.01.
    ///
    /// # Errors
    /// Claims that do not hold, or a start of the wrong length.
    pub fn lift_found(&self, eps: Option<f64>) -> Result<Option<LiftFound>, StudyError> {
        self.proved()?;
        let Some(lifted) = self.lifted() else { return Ok(None) };
        let lift = &lifted.lift;
        let eps = eps.unwrap_or(USUAL_STEP).abs();
        let has_values = self.valued().iter().all(Option::is_some);
        let start = self.lift_start().filter(|_| has_values);
        let (values, watched) = match &start {
            Some(start) => {
                let point = self.point(start)?;
                let new = point[lift.states.len()..].iter().map(|value| Some(value.to_f64()));
                (new.collect(), Some(self.measure_relations(start, eps)?))
            }
            None => (vec![None; lift.new.len()], None),
        };
        let latex = lift.expressions(&Latex);
        let new = lift.new.iter().zip(values).zip(latex).map(|((new, value), latex)| NewFound {
            name: new.name.clone(),
            expression: new.expression.clone(),
            latex,
            value,
        });
        let relations = lift.relations.iter().enumerate().map(|(place, relation)| {
            let drift = watched.as_ref().and_then(|watched| watched.drift(place));
            RelationFound {
                relation: relation.text.clone(),
                along: relation.along.map(|along| RelationFate::of(along, drift)),
                formula: relation.formula.clone(),
                rate: relation.rate,
                defines: relation.defines,
            }
        });
        Ok(Some(LiftFound {
            system: self.name().to_owned(),
            written: lifted.given.text().to_owned(),
            variables: lift.variables().to_vec(),
            new: new.collect(),
            field: self.text().to_owned(),
            order: lift.order(),
            optimal: lift.is_optimal,
            chosen: lift.chosen.clone(),
            relations: relations.collect(),
            energy: lift.energy.clone(),
            notes: lift.notes.clone(),
            watched: start.zip(watched).map(|(start, errors)| WatchedOrbit { start, eps, errors }),
        }))
    }
}

/// A description of a lift.
#[derive(Clone, Debug, Serialize)]
pub struct LiftFound {
    /// The name of the system.
    pub system: String,
    /// The text before the lift.
    #[serde(skip)]
    pub written: String,
    /// The original variables, followed by the new variables.
    pub variables: Vec<String>,
    /// The new variables.
    pub new: Vec<NewFound>,
    /// The quadratic field with the formulas that its map preserves, in the language of `kahan!`.
    pub field: String,
    /// The number of new variables; `t` is not counted.
    pub order: usize,
    /// Whether a complete search found no lift with fewer new variables.
    pub optimal: bool,
    /// The reason for the choice of this lift.
    pub chosen: String,
    /// The relations between the variables.
    pub relations: Vec<RelationFound>,
    /// The energy that the map preserves.
    pub energy: Option<String>,
    /// Notes for the user.
    #[serde(skip)]
    pub notes: Vec<String>,
    /// The orbit along which the errors of the relations were measured.
    #[serde(skip)]
    pub watched: Option<WatchedOrbit>,
}

/// An orbit until t = 100, with the errors of the relations along it.
#[derive(Clone, Debug)]
pub struct WatchedOrbit {
    /// The first point, in the original variables.
    pub start: Vec<Rational>,
    /// ε, half the time step.
    pub eps: f64,
    /// The errors of the relations along the orbit.
    pub errors: RelationErrors,
}

/// A new variable of a lift.
#[derive(Clone, Debug, Serialize)]
pub struct NewFound {
    /// The name of the variable.
    pub name: String,
    /// The variable as a function of the original ones; `None` for an integral over time.
    pub expression: Option<String>,
    /// The expression in LaTeX.
    #[serde(skip)]
    pub latex: Option<String>,
    /// The value at the start, if known.
    #[serde(skip)]
    pub value: Option<f64>,
}

/// A relation between the variables of a lift.
#[derive(Clone, Debug, Serialize)]
pub struct RelationFound {
    /// A function that is 0 where the relation holds.
    pub relation: String,
    /// The behaviour of the error along the orbit, if known.
    pub along: Option<RelationFate>,
    /// The modified function that the map preserves exactly, if one is known.
    pub formula: Option<String>,
    /// The rate λ at which errors grow like exp(λt). All relations of a lift have the largest rate.
    #[serde(serialize_with = "finite")]
    pub rate: Option<f64>,
    /// The index, among the new variables, of the variable that the relation defines.
    #[serde(skip)]
    pub defines: Option<usize>,
}

/// Writes an infinite rate as `null`, because JSON has no infinity.
fn finite<S: Serializer>(rate: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    rate.filter(|rate| rate.is_finite()).serialize(serializer)
}

/// The behaviour of a relation's error along an orbit of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum RelationFate {
    /// The map exactly preserves a modified relation, [`RelationFound::formula`].
    Kept,
    /// The error stays bounded.
    Bounded,
    /// The error decays, except for the error added by each step.
    Decays,
    /// The error grows linearly.
    Drifts,
    /// The error grows exponentially.
    Grows,
}

impl RelationFate {
    /// Combines the computed behaviour of small errors with `drift`, their growth along an orbit.
    fn of(along: RelationBehaviour, drift: Option<f64>) -> Self {
        match along {
            RelationBehaviour::Kept => RelationFate::Kept,
            RelationBehaviour::Grows => RelationFate::Grows,
            RelationBehaviour::Decays => RelationFate::Decays,
            RelationBehaviour::Bounded if drift.is_some_and(|drift| drift > DRIFT_GROWTH) => {
                RelationFate::Drifts
            }
            RelationBehaviour::Bounded => RelationFate::Bounded,
            RelationBehaviour::Drifts if drift.is_some_and(|drift| drift <= DRIFT_GROWTH) => {
                RelationFate::Bounded
            }
            RelationBehaviour::Drifts => RelationFate::Drifts,
        }
    }
}
