//! Reads the page's questions, and answers them.
//!
//! Reading the enum `Question` instead of names would double the size of the WebAssembly module.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_core::observe::Lyapunov;
use kahan_draw::document::style_sheet;
use kahan_runtime::{Follow, Followed};
use kahan_study::{
    Answer, Discover, Heights, Lift, Orbit, Orbited, Poles, Show, ShowForm, StoredColumn, Study, StudyError,
    Subject, Systems, Watch, list,
};
use kahan_systems::registry;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

use crate::plane::{Plane, plane};
use crate::scene::scene;
use crate::shown::{self, formulas, part};

/// Answers questions, and caches the field of the last question.
#[derive(Default)]
pub struct Asker {
    last: Option<(Value, Study)>,
    /// The last ε, and the study with the integrals that are claimed at this ε.
    at_step: Option<(Rational, Study)>,
}

/// An answer for the page, as JSON and as numbers.
#[derive(Debug, Default)]
pub struct Answered {
    /// The answer, `{"answer": …, "html": …, "parameters": […], "values": {…}, "lifted": …}`, or
    /// the mistake, `{"mistake": …, "lifts": …}`.
    pub json: String,
    /// The columns of an orbit, or the errors of relations, one after the other.
    pub columns: Vec<f64>,
}

/// An answer before it is written as text.
#[derive(Default)]
struct Reply {
    answer: Value,
    html: Option<String>,
    parameters: Vec<String>,
    /// The known values of parameters.
    values: Map<String, Value>,
    /// For a lifted field, `{"html": …, "coordinates": […], "relations": […], "warning": …}`;
    /// otherwise null.
    lifted: Value,
    columns: Vec<f64>,
}

struct Mistake {
    said: String,
    /// Whether the equations are not quadratic, but a lift can read them.
    lifts: bool,
}

impl<E: ToString> From<E> for Mistake {
    fn from(error: E) -> Self {
        Mistake { said: error.to_string(), lifts: false }
    }
}

/// An orbit is cut into this many pieces, and the largest error in each piece is shown.
const PARTS: usize = 480;

impl Reply {
    /// Makes the reply for an answer, with the HTML that shows it.
    fn of(answer: Answer) -> Self {
        Reply { answer: json!(answer), html: Some(part(&answer)), ..Reply::default() }
    }
}

impl Asker {
    /// Answers a question in a text: `{"subject": …, "question": {"ask": …}}`.
    ///
    /// Besides questions of `kahan-study`, the page asks `list`, `style`, `scene`, `plane`,
    /// `relations` and `exponent`.
    pub fn ask(&mut self, text: &str, watch: &dyn Watch) -> Answered {
        match self.reply(text, watch) {
            Ok(Reply { answer, html, parameters, values, lifted, columns }) => {
                let json = json!({"answer": answer, "html": html, "parameters": parameters, "values": values, "lifted": lifted});
                Answered { json: json.to_string(), columns }
            }
            Err(Mistake { said, lifts }) => {
                Answered { json: json!({"mistake": said, "lifts": lifts}).to_string(), columns: Vec::new() }
            }
        }
    }

    fn reply(&mut self, text: &str, watch: &dyn Watch) -> Result<Reply, Mistake> {
        let mut asked: Map<String, Value> = read(text.parse()?)?;
        let mut question: Map<String, Value> = read(asked.remove("question").unwrap_or_default())?;
        let name = question.remove("ask").unwrap_or_default();
        let Some(subject) = asked.remove("subject") else {
            return match name.as_str() {
                Some("style") => Ok(Reply { answer: json!(style_sheet()), ..Reply::default() }),
                Some("list") => Ok(catalog()?),
                _ => Err(format!("{name} is asked of a subject").into()),
            };
        };
        let (study, question) = (self.study(subject)?, Value::Object(question));
        Ok(match name.as_str() {
            Some("show") => shown_formulas(study, &read(question)?, watch)?,
            Some("scene") => Reply { answer: scene(study)?, ..Reply::default() },
            Some("plane") => {
                let asked: Plane = read(question)?;
                let study = match &asked.orbit {
                    Some(orbit) => self.study_of_orbit(orbit)?,
                    None => study.clone(),
                };
                let (answer, columns) = plane(&study, &asked)?;
                Reply { answer, columns, ..Reply::default() }
            }
            Some("orbit") => {
                let asked = read(question)?;
                orbit(&self.study_of_orbit(&asked)?, &asked, watch)?
            }
            Some("relations") => relations(study, &read(question)?)?,
            Some("exponent") => exponent(study, &read(question)?)?,
            Some("discover") => {
                Reply::of(Answer::Discover(Box::new(read::<Discover>(question)?.ask(study, watch)?)))
            }
            Some("heights") => heights(study, &read(question)?, watch)?,
            Some("poles") => Reply::of(Answer::Poles(Box::new(read::<Poles>(question)?.ask(study, watch)?))),
            _ => return Err(format!("the page has no question {name}").into()),
        })
    }

    /// Returns the study of a subject. An unchanged subject gives the last study.
    fn study(&mut self, subject: Value) -> Result<&Study, Mistake> {
        if self.last.as_ref().is_none_or(|(last, _)| *last != subject) {
            let read: Subject = read(subject.clone())?;
            let study = read.study_to_show(&Systems);
            let study = study.map_err(|error| match error {
                // The page shows a button for lifts, so advice about lifts is left out.
                StudyError::Field(mistakes) if read.calls_for_a_lift() => {
                    Mistake { said: mistakes.without_help().to_string(), lifts: true }
                }
                error => Mistake::from(error),
            });
            self.last = Some((subject, study?));
            self.at_step = None;
        }
        Ok(&self.last.as_ref().expect("it was put there").1)
    }

    /// Returns the last study, with the integrals that the map preserves at the orbit's ε.
    fn study_of_orbit(&mut self, asked: &Orbit) -> Result<Study, StudyError> {
        let (_, study) = self.last.as_ref().expect("a subject was read");
        if !asked.is_of_the_map() {
            return asked.study(study);
        }
        if self.at_step.as_ref().is_none_or(|(eps, _)| *eps != asked.eps) {
            self.at_step = Some((asked.eps.clone(), asked.study(study)?));
        }
        Ok(self.at_step.as_ref().expect("it was put there").1.clone())
    }
}

fn read<T: DeserializeOwned>(value: Value) -> Result<T, serde_json::Error> {
    serde_json::from_value(value)
}

/// Returns a block without header and documentation, as users type it.
fn written(block: &str) -> String {
    let lines = block.lines().map(|line| line.strip_prefix("    ").unwrap_or(line));
    let lines = lines.filter(|line| !line.trim_start().starts_with("///"));
    let text = lines.collect::<Vec<_>>().join("\n");
    text.split_once([';', '}']).map_or("", |(_header, items)| items).trim().to_owned()
}

/// Returns the equations in a text, without the claims that follow the last equation.
fn equations(text: &str) -> &str {
    let ends = text.rfind("dot =").and_then(|last| Some(last + text[last..].find(';')? + 1));
    &text[..ends.unwrap_or(text.len())]
}

/// Returns the systems of the catalog, with parameter values that give typical pictures.
fn catalog() -> Result<Reply, StudyError> {
    let listed = list(&Systems)?;
    let systems = listed.systems.iter().zip(registry::all()).map(|(system, entry)| {
        let values = entry.parameters.iter().map(|&(above, below)| Rational::new(above, below).to_string());
        let params: Map<String, Value> =
            system.parameters.iter().cloned().zip(values.map(Value::String)).collect();
        json!({"name": system.name, "called": entry.name, "title": shown::readable(system.title), "params": params, "text": equations(&written(entry.text()))})
    });
    Ok(Reply { answer: systems.collect(), ..Reply::default() })
}

fn shown_formulas(study: &Study, asked: &Show, watch: &dyn Watch) -> Result<Reply, StudyError> {
    let shown = asked.ask(study, watch)?;
    let answer = json!(shown);
    // Formulas in other notations are only copied by the user, so they have no HTML.
    let html = (asked.form == ShowForm::Latex).then(|| formulas(shown, asked.jacobian));
    let parameters = study.parameters().to_vec();
    let values = parameters.iter().cloned().zip(study.valued());
    let values = values.filter_map(|(name, value)| Some((name, Value::String(value?.to_string()))));
    let values = values.collect();
    Ok(Reply { answer, html, parameters, values, lifted: lifted(study)?, ..Reply::default() })
}

/// Returns the lift of the field as JSON; null for a field that is quadratic as written.
fn lifted(study: &Study) -> Result<Value, StudyError> {
    let is_quadratic = study.lift().is_none_or(|lift| lift.order() == 0 && !lift.has_time);
    let Some(found) = study.lift_found(None)?.filter(|_| !is_quadratic) else { return Ok(Value::Null) };
    let relations = found.relations.iter().map(|relation| found.equation(relation));
    Ok(json!({
        "html": shown::lift(&found),
        "coordinates": study.coordinates(),
        "relations": relations.collect::<Vec<_>>(),
        "warning": study.lift().and_then(Lift::warning),
    }))
}

/// Returns the rows of an orbit in doubles, one column after the other.
fn orbit(study: &Study, asked: &Orbit, watch: &dyn Watch) -> Result<Reply, StudyError> {
    let Orbited { head, rows, ending } = asked.begin_in_doubles(study)?.in_memory(watch);
    let mut columns = Vec::with_capacity(rows.count() * rows.values.len());
    for kept in &rows.values {
        match kept {
            StoredColumn::F64(values) => columns.extend_from_slice(values),
            StoredColumn::Integer(values) => columns.extend(values.iter().map(|&value| value as f64)),
            _ => unreachable!("orbits in doubles have doubles and counts"),
        }
    }
    let stopped = ending.why.map(|_| json!({"step": ending.step}));
    let answer = json!({"head": head, "rows": rows.count(), "stopped": stopped, "note": ending.note});
    Ok(Reply { answer, columns, ..Reply::default() })
}

/// Returns the largest error of each relation in each of [`PARTS`] equal pieces of an orbit.
fn relations(study: &Study, asked: &Orbit) -> Result<Reply, StudyError> {
    let seen = study.relation_errors(&asked.at, &asked.eps, asked.steps, PARTS)?;
    let padded = |errors: &Vec<f64>| {
        let missing = PARTS - errors.len();
        errors.iter().copied().chain(std::iter::repeat_n(f64::NAN, missing)).collect::<Vec<_>>()
    };
    let columns = seen.errors.iter().flat_map(padded).collect();
    Ok(Reply { answer: json!({"rows": PARTS}), columns, ..Reply::default() })
}

/// Returns the largest Lyapunov exponent of an orbit, its error, and the steps that were made.
fn exponent(study: &Study, asked: &Orbit) -> Result<Reply, StudyError> {
    let map = study.map()?.at(asked.eps.to_f64());
    let mut x: Vec<f64> = study.point(&asked.at)?.iter().map(Rational::to_f64).collect();
    let followed = map.observe(&mut x, asked.steps, Lyapunov::new(&map), |_| ControlFlow::Continue(()));
    let Followed { report, end } = followed.expect("the point is of the field");
    let answer = json!({"value": report.value, "error": report.error, "steps": end.steps(asked.steps)});
    Ok(Reply { answer, ..Reply::default() })
}

fn heights(study: &Study, asked: &Heights, watch: &dyn Watch) -> Result<Reply, StudyError> {
    let found = asked.ask(study, watch)?;
    let html = shown::heights(&found, &asked.eps);
    Ok(Reply { answer: json!(found), html: Some(html), ..Reply::default() })
}
