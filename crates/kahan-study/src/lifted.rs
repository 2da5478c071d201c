//! Fields that were lifted to quadratic ones: how points go in and come out, and what there is to
//! say of the lift.
//!
//! In: a text with functions, quotients or powers, and which lift is wanted. Out: the quadratic
//! system with the formulas that its map keeps as integrals, and the lift. Points are given in the
//! original variables; the new ones are functions of them.

use std::collections::HashSet;
use std::sync::OnceLock;

use kahan_algebra::diagnostics::Diagnostics;
use kahan_algebra::parse::parse_lifted;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::expression_text;
use kahan_algebra::syntax::{Claim, ClaimBody, Expr, TensorEntry};
use kahan_algebra::system::System;
use kahan_latex::Latex;
use kahan_lift::{Along, Embedding, Lift, Options, Which, lift, stated};
use kahan_runtime::{FieldText, Relations};
use serde::{Serialize, Serializer};

use crate::columns::{Others, Wanted};
use crate::error::StudyError;
use crate::relations::RelationErrors;
use crate::study::Study;

/// How a field is lifted.
#[derive(Clone, Debug, Default)]
pub struct Lifting {
    /// Which lift is wanted.
    pub which: Which,
    /// The first point of the orbit along which lifts are judged, in the original variables; by
    /// default the first point that the text gives.
    pub start: Option<Vec<Rational>>,
    /// The names of the coordinates of `start`; empty if they are in the order of the variables.
    pub names: Vec<String>,
    /// Values by which lifts are judged of parameters that have none.
    pub near: Vec<(String, Rational)>,
    /// The value of `t` at the start, where the equations depend on it.
    pub time: Rational,
    /// Whether answers show the new variables beside the original ones.
    pub shows_all: bool,
}

impl Lifting {
    /// Puts the coordinates of the start in the order of the variables. A start that lacks one is
    /// dropped.
    fn put_in_order(&mut self, states: &[String]) {
        let names = std::mem::take(&mut self.names);
        if !names.is_empty() {
            let places = Wanted::new(states, &[], Others::Ignored).places(&names);
            let start = self.start.take().zip(places.ok());
            let of = |start: &[Rational], place: &usize| start.get(*place).cloned();
            self.start =
                start.and_then(|(start, found)| found.states.iter().map(|place| of(&start, place)).collect());
        }
    }
}

/// A lift with what became of it.
#[derive(Clone, Debug)]
pub(crate) struct Lifted {
    pub(crate) lift: Lift,
    /// The text that was lifted.
    pub(crate) given: FieldText,
    lifting: Lifting,
    /// The original variables, without `t`.
    original: Vec<String>,
    /// The variables that answers show, and their places among all.
    shown: Vec<String>,
    places: Vec<usize>,
    /// The places of the lift's parameters among those of the field.
    parameters: Vec<Option<usize>>,
    /// The derivatives of the new variables by the original ones, once vectors are carried.
    slopes: OnceLock<Embedding>,
}

impl Lifted {
    /// Lifts the field of a text. `values` gives parameters that have one.
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
        // A quadratic text stays as it was written, with its claims.
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

    /// The lift with the new variables among those that answers show.
    pub(crate) fn showing_all(&self) -> Self {
        let names = self.lift.variables();
        let places = (0..self.original.len()).chain(self.lift.states.len()..names.len());
        let places: Vec<usize> = places.collect();
        let shown = places.iter().map(|&place| names[place].clone()).collect();
        Lifted { shown, places, ..self.clone() }
    }

    /// The values of the lift's parameters among those of the field's.
    fn own(&self, values: &[f64]) -> Vec<f64> {
        self.parameters.iter().map(|place| place.map_or(f64::NAN, |place| values[place])).collect()
    }

    /// All variables at a point of the original ones; not a number where one has no value.
    fn embed(&self, at: &[f64], values: &[f64], time: f64) -> Vec<f64> {
        let own = self.own(values);
        let time = self.lift.has_time.then_some(time);
        let states: Vec<f64> = at.iter().copied().chain(time).collect();
        let new = self.lift.embed(&states, &own);
        states.into_iter().chain(new).collect()
    }
}

/// Returns the constants of a text that are numbers and its claims, as written, one a line, and the
/// names that they give.
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
    // A claim may name a constant by way of another one.
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

/// Returns the text of a lift with these claims and their names besides its own, and the system
/// that it says.
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

/// A lifted `t` and the new variables stand for functions of the original ones.
impl Relations for Lifted {
    fn originals(&self) -> usize {
        self.original.len()
    }

    fn slopes(&self, x: &[f64], parameters: &[f64]) -> Vec<f64> {
        let slopes = self.slopes.get_or_init(|| self.lift.slopes());
        let of_time = vec![0.0; usize::from(self.lift.has_time) * self.original.len()];
        let of_new = slopes.values(&x[..self.lift.states.len()], &self.own(parameters));
        of_time.into_iter().chain(of_new).collect()
    }
}

impl Study {
    /// The lift, where the field was lifted.
    #[must_use]
    pub fn lift(&self) -> Option<&Lift> {
        self.lifted().map(|lifted| &lifted.lift)
    }

    /// The variables that points are given in: of a lifted field the original ones, without `t`.
    #[must_use]
    pub fn coordinates(&self) -> &[String] {
        self.lifted().map_or_else(|| self.variables(), |lifted| &lifted.original)
    }

    /// The variables that answers show: all; of a lifted field the original ones, and the new ones
    /// where these are asked for.
    #[must_use]
    pub fn shown(&self) -> &[String] {
        self.lifted().map_or_else(|| self.variables(), |lifted| &lifted.shown)
    }

    /// The relations by which tangent vectors are those of the original variables; none where all
    /// variables are original.
    pub(crate) fn relations(&self) -> Option<&dyn Relations> {
        let lifted = self.lifted().filter(|lifted| lifted.original.len() < self.variables().len());
        lifted.map(|lifted| lifted as &dyn Relations)
    }

    /// The time at the start of an orbit.
    #[must_use]
    pub fn time(&self) -> Rational {
        self.lifted().map_or_else(Rational::zero, |lifted| lifted.lifting.time.clone())
    }

    /// The place of `t` among the variables, where it was lifted.
    #[must_use]
    pub fn time_place(&self) -> Option<usize> {
        self.lift().filter(|lift| lift.has_time).map(|lift| lift.states.len() - 1)
    }

    /// The columns that an orbit shows, by their places among n, t, all variables and the
    /// integrals.
    pub(crate) fn columns_shown(&self, columns: usize) -> Vec<usize> {
        let Some(lifted) = self.lifted() else { return (0..columns).collect() };
        let time = self.time_place().map_or(1, |place| 2 + place);
        let variables = lifted.places.iter().map(|place| 2 + place);
        [0, time].into_iter().chain(variables).chain(2 + self.variables().len()..columns).collect()
    }

    /// The values of the variables that answers show, of all variables.
    #[must_use]
    pub fn project<T: Clone>(&self, point: &[T]) -> Vec<T> {
        match self.lifted() {
            Some(lifted) => lifted.places.iter().map(|&place| point[place].clone()).collect(),
            None => point.to_vec(),
        }
    }

    /// All variables at a point, with these values of the parameters. A point of all variables is
    /// left as it is; what has no value is not a number.
    #[must_use]
    pub fn embed(&self, at: &[f64], values: &[f64]) -> Vec<f64> {
        self.embed_at(at, values, self.time().to_f64())
    }

    /// All variables at a point and a time.
    #[must_use]
    pub fn embed_at(&self, at: &[f64], values: &[f64], time: f64) -> Vec<f64> {
        match self.lifted() {
            Some(lifted) if at.len() == lifted.original.len() => lifted.embed(at, values, time),
            _ => self.with_time(at, time),
        }
    }

    /// All variables at a point of those that answers show: the time is that of the start.
    fn with_time<T: Clone>(&self, at: &[T], time: T) -> Vec<T> {
        let mut all = at.to_vec();
        if let Some(place) =
            self.time_place().filter(|place| at.len() > *place && at.len() < self.variables().len())
        {
            all.insert(place, time);
        }
        all
    }

    /// All variables at a point of the original ones, exactly where these are exact.
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
        // A quotient by 0 may be a finite float.
        let (new, _) = undefined.or_else(|| lifted.lift.new.iter().zip(&new).next()).expect("a new variable");
        Err(StudyError::NotEmbedded {
            variable: new.name.clone(),
            expression: new.expression.clone().unwrap_or_default(),
        })
    }
}

/// The time over which relations are watched, and the step by which they are, where none is given.
const HORIZON: f64 = 100.0;
const USUAL_STEP: f64 = 0.01;
/// The parts of an orbit in an eighth of it, each of which has an error of its own.
const EIGHTH: usize = 50;
/// The growth of a relation from the first eighth of an orbit to the last that counts as a drift.
const DRIFT: f64 = 1.5;
/// A relation that small is rounding.
const ROUNDING: f64 = 1e-11;

impl RelationErrors {
    /// The ratio of a relation's error in the last eighth of the orbit to that in the first; `None`
    /// if the orbit ends early.
    pub(crate) fn drift(&self, place: usize) -> Option<f64> {
        let errors = &self.errors[place];
        let (first, last) = (errors.get(..EIGHTH)?, errors.get(7 * EIGHTH..8 * EIGHTH)?);
        let [first, last] = [first, last].map(|part| part.iter().copied().fold(ROUNDING, f64::max));
        Some(last / first)
    }
}

impl Study {
    /// The errors of the relations along an orbit over 100 units of time.
    pub(crate) fn watched(&self, at: &[Rational], eps: f64) -> Result<RelationErrors, StudyError> {
        let steps = (HORIZON / (2.0 * eps)).ceil().clamp(8.0, 1e7) as u64;
        self.relation_errors(at, &Rational::from_f64(eps).unwrap_or_default(), steps, 8 * EIGHTH)
    }

    /// The first point of the orbit along which the lift was chosen: the one that was given for it,
    /// or else the text's own.
    #[must_use]
    pub fn lift_start(&self) -> Option<Vec<Rational>> {
        self.lifted()?.lifting.start.clone().or_else(|| self.start())
    }

    /// Describes the lift; `None` where the field was not lifted. With a start the
    /// relations are watched along its orbit at `eps`, or at 0.01.
    ///
    /// # Errors
    /// Claims that do not hold, a start that does not fit.
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
                (new.collect(), Some(self.watched(start, eps)?))
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
                along: relation.along.map(|along| Fate::of(along, drift)),
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
            watched: start.zip(watched).map(|(start, errors)| Watched { start, eps, errors }),
        }))
    }
}

/// A lift, as it is shown.
#[derive(Clone, Debug, Serialize)]
pub struct LiftFound {
    /// The name of the system.
    pub system: String,
    /// The text that was lifted.
    #[serde(skip)]
    pub written: String,
    /// The original variables, then the new ones.
    pub variables: Vec<String>,
    /// The new variables.
    pub new: Vec<NewFound>,
    /// The quadratic field, with the formulas that its map keeps, in the language of `kahan!`.
    pub field: String,
    /// The number of new variables; `t` is not counted.
    pub order: usize,
    /// Whether the search for fewer new variables was complete and found none.
    pub optimal: bool,
    /// The reason for the choice of this lift.
    pub chosen: String,
    /// The relations between the variables.
    pub relations: Vec<RelationFound>,
    /// The energy that the map keeps.
    pub energy: Option<String>,
    /// What a user should know of.
    #[serde(skip)]
    pub notes: Vec<String>,
    /// The orbit along which the relations were watched.
    #[serde(skip)]
    pub watched: Option<Watched>,
}

/// An orbit over 100 units of time, along which the relations of a lift were watched.
#[derive(Clone, Debug)]
pub struct Watched {
    /// The first point, in the original variables.
    pub start: Vec<Rational>,
    /// ε, half the time step.
    pub eps: f64,
    /// The errors of the relations along it.
    pub errors: RelationErrors,
}

/// A new variable of a lift.
#[derive(Clone, Debug, Serialize)]
pub struct NewFound {
    /// Its name.
    pub name: String,
    /// The function of the original variables that it stands for; `None` for the work done since
    /// the start.
    pub expression: Option<String>,
    /// The expression in LaTeX.
    #[serde(skip)]
    pub latex: Option<String>,
    /// Its value at the start, where there is one.
    #[serde(skip)]
    pub value: Option<f64>,
}

/// A relation between the variables of a lift.
#[derive(Clone, Debug, Serialize)]
pub struct RelationFound {
    /// The function that is 0 where it holds.
    pub relation: String,
    /// Its fate along the orbit; `None` where no start was given and no rule keeps it.
    pub along: Option<Fate>,
    /// The function that the map keeps exactly.
    pub formula: Option<String>,
    /// The largest exponent of the linearised errors of all relations along the orbit.
    #[serde(serialize_with = "finite")]
    pub rate: Option<f64>,
    /// The place among the new variables of the one that the relation defines.
    #[serde(skip)]
    pub defines: Option<usize>,
}

/// JSON has no infinite numbers.
fn finite<S: Serializer>(rate: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    rate.filter(|rate| rate.is_finite()).serialize(serializer)
}

/// The fate of a relation along an orbit of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// The map keeps a formula exactly.
    Kept,
    /// Its error stays bounded.
    Bounded,
    /// Its error decays but for what each step adds.
    Decays,
    /// Its error grows linearly.
    Drifts,
    /// Its error grows exponentially.
    Grows,
}

impl Fate {
    /// What the linearised error says, and how much the error grew along an orbit.
    fn of(along: Along, drift: Option<f64>) -> Self {
        match along {
            Along::Kept => Fate::Kept,
            Along::Grows => Fate::Grows,
            Along::Decays => Fate::Decays,
            Along::Bounded if drift.is_some_and(|drift| drift > DRIFT) => Fate::Drifts,
            Along::Bounded => Fate::Bounded,
            Along::Drifts if drift.is_some_and(|drift| drift <= DRIFT) => Fate::Bounded,
            Along::Drifts => Fate::Drifts,
        }
    }
}
