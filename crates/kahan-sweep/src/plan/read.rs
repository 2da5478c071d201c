//! A plan from its text.

use std::path::Path;
use std::sync::OnceLock;

use kahan_algebra::rational::Rational;
use kahan_study::columns::{Others, Wanted};
use kahan_study::number_file::Numbers;
use kahan_study::{
    Discover, Heights, Observable, Observe, Over, Question, Range, Spacing, Study, StudyError, Subject,
    Systems, Table as Rows, Through, Unwatched, Varied,
};
use toml::de::DeTable;

use super::mistakes::Collector;
use super::table::{Given, Table};
use super::{Plan, SOURCES, choose};
use crate::files::numbers;

/// Rows of a part where the plan does not say.
const ROWS: u64 = 100_000;
/// Numbers that a part may hold in memory.
const MOST_NUMBERS: u64 = 12_000_000;
/// Parts of a sweep: a file of Parquet numbers its row groups with 15 bits.
const MOST_PARTS: u64 = 32_767;
/// The most of what has no bound of its own.
const MANY: u64 = 1 << 40;

pub(super) fn plan(source: &str, origin: &str) -> Result<Plan, String> {
    let mistakes = Collector::new(source);
    let root = DeTable::parse(source);
    let read = match &root {
        Ok(root) => read(Table::new("the plan", root.span(), root.get_ref(), &mistakes), &mistakes, origin),
        Err(error) => {
            mistakes.note(&error.span().unwrap_or_default(), error.message());
            None
        }
    };
    mistakes.finish(origin, read)
}

fn read(mut root: Table<'_>, mistakes: &Collector<'_>, origin: &str) -> Option<Plan> {
    let seed = root.whole("seed", 0..=i64::MAX as u64).unwrap_or(1);
    let (draws, file) = (root.take("draws"), root.take("starts"));
    let system = root.needs("system", "a [system], with name = \"e6\" or field = \"xdot = …;\"");
    let axes = root.needs("axes", "[axes]: what it goes through, with eps and each variable");
    let task = root.needs("task", &format!("a [task], with {KINDS}"));
    let [system, axes, task, output] =
        [system, axes, task, root.take("output")].map(|given| given.and_then(Given::section));
    root.finish();
    let field = system.and_then(field);
    let task = task.and_then(|table| asked(table, field.as_ref().map(|(study, _)| study)));
    let (study, mut fixed) = field?;
    let mut axes = axes.map_or_else(Vec::new, |table| self::axes(table, &study));
    // Values that the text of the field gives, where the plan gives none.
    for (name, value) in study.parameters().iter().zip(study.valued()) {
        let is_given =
            fixed.iter().any(|(own, _)| own == name) || axes.iter().any(|(_, axis)| axis.name == *name);
        fixed.extend(value.filter(|_| !is_given).map(|value| (name.clone(), value)));
    }
    let starts = match file {
        Some(file) => starts(file, origin, &study, task.as_ref().map(|(question, _)| question)),
        None => Some(Vec::new()),
    };
    // What could not be read is not missing: its mistake is the one to correct.
    let (question, scheme, starts) = match (task, starts) {
        (Some((question, scheme)), Some(starts)) if mistakes.is_empty() => (question, scheme, starts),
        _ => return None,
    };
    missing(&root, &axes, &fixed, (&study, &question, !starts.is_empty()));
    let draws = self::draws(&root, draws, &axes)?;
    if !mistakes.is_empty() {
        return None;
    }
    axes.extend(scheme);
    let (places, axes): (Vec<Given<'_>>, Vec<Varied>) = axes.into_iter().unzip();
    let over = Over { question: Box::new(question), axes, starts, draws, seed };
    let points = over.cells(&study);
    let question = Question::Over(over);
    let mut empty = Rows::default();
    // No rows, and so their columns alone.
    let asked = study.rows(&question, 0..0, &mut empty, &Unwatched);
    let points = asked.and(points).map_err(|why| refuse(&why, &places, |said| root.note(said))).ok()?;
    let (rows_per_part, places) = output.map_or((ROWS, None), |table| self::output(table, &empty));
    let empty = choose(empty, places.as_deref());
    let canonical = OnceLock::new();
    let plan = Plan { study, fixed, question, points, rows_per_part, places, empty, canonical };
    bounds(&root, &plan);
    Some(plan)
}

/// Notes why the field or the question is refused, where the value stands that is at fault, or else
/// otherwise.
fn refuse(why: &StudyError, places: &[Given<'_>], otherwise: impl Fn(&str)) {
    let said = why.to_string();
    let said = said.trim_start_matches("error: ").trim_end();
    let at_fault = match why {
        StudyError::UnknownParameter { name, .. } | StudyError::AxisValues { name, .. } => {
            places.iter().find(|given| given.name() == name)
        }
        _ => None,
    };
    at_fault.map_or_else(|| otherwise(said), |given| given.note(said));
}

/// The field, and the values that its parameters have in all of the plan.
fn field(mut table: Table<'_>) -> Option<(Study, Vec<(String, Rational)>)> {
    let (name, field, sites) = (table.take("name"), table.take("field"), table.take("sites"));
    let params = table.take("params").and_then(Given::section);
    table.finish();
    let (subject, given) = match (name, field) {
        (Some(name), None) => (Subject::named(name.text()?), name),
        (None, Some(field)) => (Subject::text(field.text()?), field),
        _ => {
            table.note("[system] has either name = \"e6\" or field = \"xdot = …;\"");
            return None;
        }
    };
    let subject = match sites {
        Some(sites) => subject.sites(sites.whole(1..=1 << 32)? as usize),
        None => subject,
    };
    let params = params.map_or_else(Vec::new, |mut params| params.rest());
    let fixed = params.iter().filter_map(|given| Some((given.name().to_owned(), given.number()?)));
    let fixed: Vec<(String, Rational)> = fixed.collect();
    let values = fixed.iter().cloned();
    let subject = values.fold(subject, |subject, (name, value)| subject.with(name, value));
    let study = subject.study(&Systems).and_then(|study| study.proved().map(|_| study.clone()));
    Some((study.map_err(|why| refuse(&why, &params, |said| given.note(said))).ok()?, fixed))
}

/// The first points of a file, which lies where the plan says, seen from its own folder.
fn starts(
    given: Given<'_>,
    origin: &str,
    study: &Study,
    asked: Option<&Question>,
) -> Option<Vec<Vec<Rational>>> {
    if let Some(Question::Discover(_)) = asked {
        given.note("starts: \"discover\" has none; leave `starts` out");
        return None;
    }
    let name = given.text()?;
    let path = Path::new(origin).with_file_name(name);
    let variables = study.variables();
    let read = match path.extension().and_then(|ending| ending.to_str()) {
        Some("parquet") => numbers(&path, variables),
        Some("csv" | "npy") => {
            let bytes = std::fs::read(&path).map_err(|error| error.to_string());
            let read = bytes.and_then(|bytes| Numbers::of(name, &bytes));
            read.map_err(|why| format!("cannot be read: {why}"))
        }
        _ => Err("is none of F.parquet, F.csv and F.npy".to_owned()),
    };
    // Parameters and ε have their values in the plan, whatever columns the results of another have.
    let wanted = Wanted::new(variables, study.parameters(), Others::Ignored);
    let points = read.and_then(|numbers| numbers.points(&wanted));
    points.map_err(|why| given.note(format!("starts: {} {why}", path.display()))).ok()
}

/// What goes through values, and where it stands.
type Axes<'t> = Vec<(Given<'t>, Varied)>;

fn axes<'t>(mut table: Table<'t>, study: &Study) -> Axes<'t> {
    let known = || study.variables().iter().chain(study.parameters()).map(String::as_str).chain(["eps"]);
    let mut axes = Vec::new();
    for given in table.rest() {
        let name = given.name();
        if known().any(|known| known == name) {
            axes.extend(through(&given).map(|through| axis(given, name, through)));
            continue;
        }
        let hint = match name {
            "order" | "scalar" => "; order and scalar are lists in [task]",
            "start" | "starts" | "at" => {
                "; a start is an axis for each variable (values, a range or a draw), or a row of starts = \"F.csv\" at the top of the plan"
            }
            _ => "",
        };
        let known = known().collect::<Vec<_>>().join(", ");
        given.note(format!("`{name}` is no axis: there is {known}{hint}"));
    }
    axes
}

fn axis<'t>(given: Given<'t>, name: &str, through: Through) -> (Given<'t>, Varied) {
    (given, Varied { name: name.to_owned(), through })
}

/// A number, a list, `{ from, to, points }`, `{ from, to, step }`, or `{ draw, low, high }`.
fn through(given: &Given<'_>) -> Option<Through> {
    let name = given.name();
    let Some(mut table) = given.table(name) else {
        return given.each().iter().map(Given::number).collect::<Option<_>>().map(Through::List);
    };
    let through = match table.take("draw") {
        Some(draw) => drawn(&draw, &mut table),
        None => range(name, &mut table),
    };
    table.finish();
    through
}

fn drawn(draw: &Given<'_>, table: &mut Table<'_>) -> Option<Through> {
    let (low, high) = (bound("low", table), bound("high", table));
    let source = draw.one_of("there is no draw", &SOURCES)?;
    Some(Through::Drawn { source, low: low?, high: high? })
}

fn range(name: &str, table: &mut Table<'_>) -> Option<Through> {
    let (from, to) = (bound("from", table), bound("to", table));
    let spacing = match (table.take("points"), table.take("step")) {
        (Some(points), None) => points.whole(2..=MANY).map(|points| Spacing::Count(points as usize)),
        (None, Some(step)) => step.number().map(Spacing::Step),
        _ => {
            from.and(to)?;
            table.note(format!("{name}: a range is {{ from, to, points }} or {{ from, to, step }}, a draw {{ draw, low, high }}"));
            return None;
        }
    };
    let range = Range::between(from?, to?, spacing?);
    range.map_err(|why| table.note(format!("{name}: {why}"))).ok().map(Through::Range)
}

fn bound(end: &'static str, table: &mut Table<'_>) -> Option<Rational> {
    table.needs(end, &format!("`{end}`"))?.number()
}

/// What is asked, whose place the axes say, with the axes of order and scalar.
type Asked<'t> = (Question, Axes<'t>);

/// Reads what a kind of task has, for a field if that could be read.
type Kind = for<'t> fn(&mut Table<'t>, Option<&Study>) -> Option<Asked<'t>>;

const KINDS: &str = "kind = \"orbit\", \"heights\" or \"discover\"";

fn asked<'t>(mut table: Table<'t>, study: Option<&Study>) -> Option<Asked<'t>> {
    let kinds: [(&str, Kind); 3] = [("orbit", orbit), ("heights", heights), ("discover", discover)];
    let kind = table.needs("kind", KINDS)?.one_of("[task] has no kind", &kinds)?;
    let asked = kind(&mut table, study);
    table.finish();
    asked
}

fn orbit<'t>(table: &mut Table<'t>, study: Option<&Study>) -> Option<Asked<'t>> {
    let steps = steps(table, 1 << 53);
    let mut scheme = Vec::new();
    if let Some(given) = table.take("order") {
        let orders = given.each().iter().filter_map(Given::number).collect();
        scheme.push(axis(given, "order", Through::List(orders)));
    }
    if let Some(given) = table.take("scalar") {
        let bits = |one: &Given<'_>| one.one_of("a sweep has no scalar", &[("f64", 64), ("f32", 32)]);
        let bits = given.each().iter().filter_map(bits).map(Rational::from).collect();
        scheme.push(axis(given, "bits", Through::List(bits)));
    }
    let every = table.whole("every", 1..=MANY).unwrap_or(10);
    let escape = table.take("escape").map_or(Some(None), |given| Some(Some(given.number()?.to_f64())));
    let known: Vec<_> = Observable::ALL.iter().map(|one| (one.name(), *one)).collect();
    let claims_none = study.is_some_and(|study| study.field().integrals().is_empty());
    let mut of = Vec::new();
    for one in table.take("observe").into_iter().flat_map(Given::each) {
        match one.one_of("there is no observer", &known) {
            Some(Observable::Drift) if claims_none => {
                one.note("observe: drift is that of integrals, and the field claims none");
            }
            found => of.extend(found),
        }
    }
    let asked =
        Observe { every, escape: escape?, of, ..Observe::new(Rational::zero(), nowhere(study), steps?) };
    Some((Question::Observe(Observe { of: asked.observables(), ..asked }), scheme))
}

fn heights<'t>(table: &mut Table<'t>, study: Option<&Study>) -> Option<Asked<'t>> {
    let steps = steps(table, 1 << 20);
    let max_digits = table.whole("digits", 1..=100_000_000).unwrap_or(100_000);
    let asked = Heights { max_digits, ..Heights::new(Rational::zero(), nowhere(study), steps?) };
    Some((Question::Heights(asked), Vec::new()))
}

fn discover<'t>(table: &mut Table<'t>, _: Option<&Study>) -> Option<Asked<'t>> {
    let degree = table.whole("degree", 1..=20).map(|degree| degree as u32);
    // An axis is ε.
    Some((Question::Discover(Discover { degree, ..Discover::default() }), Vec::new()))
}

fn steps(table: &mut Table<'_>, most: u64) -> Option<u64> {
    table.needs("steps", "steps, the number of steps of each orbit")?.whole(1..=most)
}

/// A point, for axes and files to put others in its place.
fn nowhere(study: Option<&Study>) -> Vec<Rational> {
    vec![Rational::zero(); study.map_or(0, |study| study.variables().len())]
}

/// Notes what has no value, and what has two.
fn missing(root: &Table<'_>, axes: &Axes<'_>, fixed: &[(String, Rational)], over: (&Study, &Question, bool)) {
    let (study, question, has_file) = over;
    let starts = if matches!(question, Question::Discover(_)) { &[] } else { study.variables() };
    for name in starts.iter().chain(study.parameters()).map(String::as_str).chain(["eps"]) {
        let is_fixed = fixed.iter().any(|(own, _)| own == name);
        let is_of_file = has_file && starts.iter().any(|own| own == name);
        let elsewhere = is_fixed.then_some("under [system.params]");
        let elsewhere = elsewhere.or(is_of_file.then_some("in the file of starts"));
        match (axes.iter().any(|(_, axis)| axis.name == name), elsewhere) {
            (false, None) => root.note(format!(
                "`{name}` has no value; give it one under [axes], such as {name} = 1 or {name} = [0.1, 0.2]"
            )),
            (true, Some(place)) => {
                root.note(format!("`{name}` stands {place} and under [axes]; leave it out of one"));
            }
            _ => {}
        }
    }
}

/// How many points the drawn axes have.
fn draws(root: &Table<'_>, given: Option<Given<'_>>, axes: &Axes<'_>) -> Option<u64> {
    let is_drawn = axes.iter().any(|(_, axis)| matches!(axis.through, Through::Drawn { .. }));
    let draws = given.map_or(Some(1), |given| given.whole(1..=1 << 53));
    match (given, is_drawn) {
        (Some(given), false) => given.note("no axis is drawn; leave `draws` out, or write an axis as { draw = \"sobol\", low = 0, high = 1 }"),
        (None, true) => root.note("axes are drawn; say how many points by draws = 1000 at the top of the plan"),
        _ => {}
    }
    draws
}

/// The rows of a part, and the places of the columns that are written.
fn output(mut table: Table<'_>, empty: &Rows) -> (u64, Option<Vec<usize>>) {
    let rows = table.whole("rows_per_part", 1..=MOST_NUMBERS).unwrap_or(ROWS);
    let known = empty.columns.iter().enumerate().map(|(place, column)| (&*column.name, place));
    let known: Vec<(&str, usize)> = known.collect();
    let places = |given: Given<'_>| {
        let columns = given.each();
        if columns.is_empty() {
            given.note("columns: there are none; name at least one, or leave `columns` out for all");
        }
        columns.iter().filter_map(|one| one.one_of("there is no column", &known)).collect()
    };
    let places = table.take("columns").map(places);
    table.finish();
    (rows, places)
}

/// Notes what would not fit into memory, or into a file.
fn bounds(root: &Table<'_>, plan: &Plan) {
    let columns = plan.empty.columns.len() as u64;
    let most = MOST_NUMBERS / columns.max(1);
    if plan.rows_per_part.min(plan.points()) > most {
        root.note(format!(
            "[output] rows_per_part is at most {most} with {columns} columns, so that a part fits into memory"
        ));
    } else if plan.parts() > MOST_PARTS {
        let least = plan.points().div_ceil(MOST_PARTS);
        root.note(format!("{} parts are too many for one file, which has at most {MOST_PARTS}; write [output] rows_per_part = {least} or more", plan.parts()));
    }
}
