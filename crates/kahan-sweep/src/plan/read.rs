//! A plan from its text.

use std::ops::Range as Span;
use std::path::Path;

use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::ClaimKind;
use kahan_study::number_file::Numbers;
use kahan_study::{
    Discover, Heights, Observable, Observe, Over, Question, Range, Source, Spacing, Study, StudyError,
    Subject, Systems, Table as Rows, Through, Unwatched, Varied,
};
use toml::de::{DeTable, DeValue};

use super::mistakes::{Collector, Mistakes};
use super::table::{Table, Value, each, number, text, whole};
use super::{Plan, sha256};
use crate::files::numbers;

/// Rows of a part where the plan does not say.
const ROWS: u64 = 100_000;
/// Numbers that a part may hold in memory.
const MOST_NUMBERS: u64 = 12_000_000;
/// Parts of a sweep: a file of Parquet numbers its row groups with 15 bits.
const MOST_PARTS: u64 = 32_767;

pub(super) fn plan(source: &str, origin: &str) -> Result<Plan, Mistakes> {
    let mut mistakes = Collector::new(source);
    let read = match DeTable::parse(source) {
        Ok(root) => {
            let root = Table::new("the plan", root.span(), root.get_ref());
            Reader { mistakes: &mut mistakes, origin, places: Vec::new() }.plan(root)
        }
        Err(error) => {
            mistakes.note(&error.span().unwrap_or_default(), error.message());
            None
        }
    };
    mistakes.finish(origin)?;
    Ok(read.expect("where nothing is missing nothing was noted"))
}

struct Reader<'m, 's> {
    mistakes: &'m mut Collector<'s>,
    /// The file of the plan.
    origin: &'m str,
    /// Where parameters and axes stand.
    places: Vec<(String, Span<usize>)>,
}

impl Reader<'_, '_> {
    fn plan(&mut self, mut root: Table<'_, '_>) -> Option<Plan> {
        let (seed, draws, file) = (root.take("seed"), root.take("draws"), root.take("starts"));
        let mut of_plan = |name| root.table(name, self.mistakes);
        let (system, axes, task, output) =
            (of_plan("system"), of_plan("axes"), of_plan("task"), of_plan("output"));
        root.finish(self.mistakes);
        let seed = match seed {
            Some(value) => whole(value, "seed", (0, i64::MAX as u64), self.mistakes),
            None => Some(1),
        };
        let system = self.system(system);
        let (task, scheme) = self.task(task);
        let ((study, fixed), seed) = (system?, seed?);
        let mut all = match axes {
            Some(axes) => self.axes(axes, &study),
            None => {
                self.note("the plan needs [axes]: what it goes through, with eps and each variable");
                Vec::new()
            }
        };
        let starts = file.map_or(Some(Vec::new()), |file| self.starts(file, &study, task.as_ref()));
        let mut question = task?;
        let claims_none = study.system().accessors(ClaimKind::Integral).next().is_none();
        if let Question::Observe(asked) = &mut question {
            asked.at = vec![Rational::zero(); study.variables().len()];
            if asked.of.contains(&Observable::Drift) && claims_none {
                self.note("observe: drift is that of integrals, and the field claims none");
            }
        } else if let Question::Heights(asked) = &mut question {
            asked.at = vec![Rational::zero(); study.variables().len()];
        }
        // What could not be read is not missing: its mistake is the one to correct.
        if !self.mistakes.is_empty() {
            return None;
        }
        let starts = starts?;
        self.missing(&all, &fixed, (&study, &question, !starts.is_empty()));
        let draws = self.draws(draws, &all)?;
        if !self.mistakes.is_empty() {
            return None;
        }
        all.extend(scheme);
        let line = match &starts[..] {
            [] => String::new(),
            starts => {
                let numbers: Vec<String> = starts.iter().flatten().map(ToString::to_string).collect();
                format!("starts = {} of SHA-256 {}\n", starts.len(), sha256(&numbers.join(", ")))
            }
        };
        let over = Over { question: Box::new(question), axes: all, starts, draws, seed };
        let points = over.cells(&study);
        let question = Question::Over(over);
        let mut empty = Rows::default();
        // No rows, and so their columns alone.
        let asked = study.rows(&question, 0..0, &mut empty, &Unwatched);
        let points = asked.and(points).map_err(|why| self.refuse(&why, &(0..0))).ok()?;
        let places = (0..empty.columns.len()).collect();
        let mut plan = Plan {
            study,
            fixed,
            starts: line,
            question,
            points,
            rows_per_part: ROWS,
            columns: None,
            places,
            empty,
        };
        if let Some(output) = output {
            self.output(output, &mut plan);
        }
        self.bounds(&plan);
        Some(plan)
    }

    /// Notes what concerns the plan as a whole.
    fn note(&mut self, message: impl Into<String>) {
        self.mistakes.note(&(0..0), message);
    }

    /// Notes why the field or the question is refused, where the name stands that is at fault, or
    /// else here.
    fn refuse(&mut self, why: &StudyError, span: &Span<usize>) {
        let place = match why {
            StudyError::UnknownParameter { name, .. } | StudyError::AxisValues { name, .. } => {
                self.places.iter().find(|(own, _)| own == name)
            }
            _ => None,
        };
        let place = place.map_or(span, |(_, span)| span);
        self.mistakes.note(place, why.to_string().trim_start_matches("error: ").trim_end());
    }

    /// The field, and the values that its parameters have in all of the plan.
    fn system(&mut self, table: Option<Table<'_, '_>>) -> Option<(Study, Vec<(String, Rational)>)> {
        let Some(mut table) = table else {
            self.note("the plan needs a [system], with name = \"e6\" or field = \"xdot = …;\"");
            return None;
        };
        let (name, field, sites) = (table.take("name"), table.take("field"), table.take("sites"));
        let params = table.table("params", self.mistakes);
        let span = table.span.clone();
        table.finish(self.mistakes);
        let (subject, span) = match (name, field) {
            (Some(value), None) => (Subject::named(text(value, "name", self.mistakes)?), value.span()),
            (None, Some(value)) => (Subject::text(text(value, "field", self.mistakes)?), value.span()),
            _ => {
                self.mistakes.note(&span, "[system] has either name = \"e6\" or field = \"xdot = …;\"");
                return None;
            }
        };
        let subject = match sites {
            Some(value) => subject.sites(whole(value, "sites", (1, 1 << 32), self.mistakes)? as usize),
            None => subject,
        };
        let mut fixed = Vec::new();
        for (name, span, value) in params.map_or_else(Vec::new, |mut params| params.rest()) {
            self.places.push((name.to_owned(), span));
            fixed.extend(number(value, name, self.mistakes).map(|value| (name.to_owned(), value)));
        }
        let given = fixed.iter().cloned();
        let subject = given.fold(subject, |subject, (name, value)| subject.with(name, value));
        let study = subject.study(&Systems).and_then(|study| study.proved().map(|_| study.clone()));
        Some((study.map_err(|why| self.refuse(&why, &span)).ok()?, fixed))
    }

    /// The first points of a file, which lies where the plan says, seen from its own folder.
    fn starts(
        &mut self,
        value: &Value<'_>,
        study: &Study,
        asked: Option<&Question>,
    ) -> Option<Vec<Vec<Rational>>> {
        if let Some(Question::Discover(_)) = asked {
            self.mistakes.note(&value.span(), "starts: \"discover\" has none; leave `starts` out");
            return None;
        }
        let name = text(value, "starts", self.mistakes)?;
        let path = Path::new(self.origin).with_file_name(name);
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
        let noted = |why| self.mistakes.note(&value.span(), format!("starts: {} {why}", path.display()));
        read.and_then(|numbers| numbers.points(variables)).map_err(noted).ok()
    }

    fn axes(&mut self, mut table: Table<'_, '_>, study: &Study) -> Vec<Varied> {
        let mut axes = Vec::new();
        for (name, span, value) in table.rest() {
            let known = || study.variables().iter().chain(study.parameters());
            if name != "eps" && !known().any(|known| known == name) {
                let hint = match name {
                    "order" | "scalar" => "; order and scalar are lists in [task]",
                    "start" | "starts" | "at" => {
                        "; a start is an axis for each variable (values, a range or a draw), or a row of starts = \"F.csv\" at the top of the plan"
                    }
                    _ => "",
                };
                let known: Vec<&str> = known().map(String::as_str).collect();
                self.mistakes
                    .note(&span, format!("`{name}` is no axis: there is {}, eps{hint}", known.join(", ")));
                continue;
            }
            self.places.push((name.to_owned(), value.span()));
            axes.extend(self.through(name, value).map(|through| Varied { name: name.to_owned(), through }));
        }
        axes
    }

    fn through(&mut self, name: &str, value: &Value<'_>) -> Option<Through> {
        let DeValue::Table(inner) = value.get_ref() else {
            let values = each(value).into_iter().map(|value| number(value, name, self.mistakes));
            return values.collect::<Option<_>>().map(Through::List);
        };
        let mut table = Table::new(name, value.span(), inner);
        let through = match table.take("draw") {
            Some(kind) => self.drawn(name, kind, &mut table),
            None => self.grid(name, &mut table),
        };
        table.finish(self.mistakes);
        through
    }

    fn drawn(&mut self, name: &str, kind: &Value<'_>, table: &mut Table<'_, '_>) -> Option<Through> {
        let (low, high) = (self.bound(name, "low", table), self.bound(name, "high", table));
        let source = match text(kind, "draw", self.mistakes)? {
            "sobol" => Source::Sobol,
            "uniform" => Source::Uniform,
            other => {
                let why = format!("there is no draw `{other}`; write \"sobol\" or \"uniform\"");
                self.mistakes.note(&kind.span(), why);
                return None;
            }
        };
        Some(Through::Drawn { source, low: low?, high: high? })
    }

    /// `{ from, to, points }` or `{ from, to, step }`.
    fn grid(&mut self, name: &str, table: &mut Table<'_, '_>) -> Option<Through> {
        let (from, to) = (self.bound(name, "from", table), self.bound(name, "to", table));
        let spacing = match (table.take("points"), table.take("step")) {
            (Some(points), None) => {
                Spacing::Count(whole(points, "points", (2, 1 << 40), self.mistakes)? as usize)
            }
            (None, Some(step)) => Spacing::Step(number(step, "step", self.mistakes)?),
            _ => {
                from.and(to)?;
                self.mistakes.note(
                    &table.span,
                    format!("{name}: a range is {{ from, to, points }} or {{ from, to, step }}, a draw {{ draw, low, high }}"),
                );
                return None;
            }
        };
        let range = Range::between(from?, to?, spacing);
        let noted = range.map_err(|why| self.mistakes.note(&table.span, format!("{name}: {why}")));
        noted.ok().map(Through::Range)
    }

    fn bound(&mut self, name: &str, bound: &'static str, table: &mut Table<'_, '_>) -> Option<Rational> {
        match table.take(bound) {
            Some(value) => number(value, bound, self.mistakes),
            None => {
                self.mistakes.note(&table.span, format!("{name} needs `{bound}`"));
                None
            }
        }
    }

    /// The question of the task, whose place the axes say, and the axes of order and scalar.
    fn task(&mut self, table: Option<Table<'_, '_>>) -> (Option<Question>, Vec<Varied>) {
        const KINDS: &str = "kind = \"orbit\", \"heights\" or \"discover\"";

        let Some(mut table) = table else {
            self.note(format!("the plan needs a [task], with {KINDS}"));
            return (None, Vec::new());
        };
        let mut scheme = Vec::new();
        let kind = table.take("kind");
        let question = match kind.and_then(|kind| text(kind, "kind", self.mistakes)) {
            Some("orbit") => self.orbit(&mut table, &mut scheme).map(Question::Observe),
            Some("heights") => self.heights(&mut table).map(Question::Heights),
            Some("discover") => {
                let degree = table.take("degree");
                let degree = degree.map(|value| whole(value, "degree", (1, 20), self.mistakes));
                let degree = degree.map(|degree| degree.map(|degree| degree as u32));
                // An axis is ε.
                let asked = |degree| Discover { degree, ..Discover::default() };
                degree.map_or(Some(None), |degree| degree.map(Some)).map(asked).map(Question::Discover)
            }
            other => {
                let (span, message) = match (other, kind) {
                    (Some(kind), Some(value)) => {
                        (value.span(), format!("[task] has no kind `{kind}`; write {KINDS}"))
                    }
                    _ => (table.span.clone(), format!("[task] needs {KINDS}")),
                };
                self.mistakes.note(&span, message);
                table.rest();
                None
            }
        };
        table.finish(self.mistakes);
        (question, scheme)
    }

    fn steps(&mut self, table: &mut Table<'_, '_>, most: u64) -> Option<u64> {
        match table.take("steps") {
            Some(value) => whole(value, "steps", (1, most), self.mistakes),
            None => {
                self.mistakes.note(&table.span, "[task] needs steps, the number of steps of each orbit");
                None
            }
        }
    }

    fn orbit(&mut self, table: &mut Table<'_, '_>, scheme: &mut Vec<Varied>) -> Option<Observe> {
        let steps = self.steps(table, 1 << 53);
        let (order, scalar) = (table.take("order"), table.take("scalar"));
        let (every, escape, observe) = (table.take("every"), table.take("escape"), table.take("observe"));
        if let Some(value) = order {
            self.places.push(("order".to_owned(), value.span()));
            let orders = each(value).into_iter().filter_map(|value| number(value, "order", self.mistakes));
            scheme.push(Varied { name: "order".to_owned(), through: Through::List(orders.collect()) });
        }
        if let Some(value) = scalar {
            let bits = each(value).into_iter().filter_map(|value| self.bits(value)).collect();
            scheme.push(Varied { name: "bits".to_owned(), through: Through::List(bits) });
        }
        let every = every.map_or(Some(10), |value| whole(value, "every", (1, 1 << 40), self.mistakes));
        let escape = escape.map_or(Some(1e6), |value| Some(number(value, "escape", self.mistakes)?.to_f64()));
        let of = observe.map_or_else(Vec::new, each).into_iter();
        let of = of.filter_map(|value| self.observable(value)).collect();
        let plain = Observe::new(Rational::zero(), Vec::new(), steps?);
        let asked = Observe { every: every?, escape: escape?, of, ..plain };
        Some(Observe { of: asked.observables(), ..asked })
    }

    fn bits(&mut self, value: &Value<'_>) -> Option<Rational> {
        match text(value, "scalar", self.mistakes)? {
            "f64" => Some(Rational::from(64)),
            "f32" => Some(Rational::from(32)),
            other => {
                let message = format!("there is no scalar `{other}` in a sweep; write \"f64\" or \"f32\"");
                self.mistakes.note(&value.span(), message);
                None
            }
        }
    }

    fn observable(&mut self, value: &Value<'_>) -> Option<Observable> {
        let name = text(value, "observe", self.mistakes)?;
        let found = Observable::ALL.iter().find(|known| known.name() == name).copied();
        if found.is_none() {
            let known: Vec<&str> = Observable::ALL.iter().map(|known| known.name()).collect();
            let message = format!("there is no observer `{name}`; there is {}", known.join(", "));
            self.mistakes.note(&value.span(), message);
        }
        found
    }

    fn heights(&mut self, table: &mut Table<'_, '_>) -> Option<Heights> {
        let (steps, digits) = (self.steps(table, 1 << 20), table.take("digits"));
        let digits =
            digits.map_or(Some(100_000), |value| whole(value, "digits", (1, 100_000_000), self.mistakes));
        Some(Heights { max_digits: digits?, ..Heights::new(Rational::zero(), Vec::new(), steps?) })
    }

    /// Notes what has no value, and what has two.
    fn missing(&mut self, axes: &[Varied], fixed: &[(String, Rational)], over: (&Study, &Question, bool)) {
        let (study, question, has_file) = over;
        let starts = if matches!(question, Question::Discover(_)) { &[] } else { study.variables() };
        for name in starts.iter().chain(study.parameters()).map(String::as_str).chain(["eps"]) {
            let is_fixed = fixed.iter().any(|(own, _)| own == name);
            let is_of_file = has_file && starts.iter().any(|own| own == name);
            let elsewhere = is_fixed.then_some("under [system.params]");
            let elsewhere = elsewhere.or(is_of_file.then_some("in the file of starts"));
            match (axes.iter().any(|axis| axis.name == name), elsewhere) {
                (false, None) => self.note(format!("`{name}` has no value; give it one under [axes], such as {name} = 1 or {name} = [0.1, 0.2]")),
                (true, Some(place)) => self.note(format!("`{name}` stands {place} and under [axes]; leave it out of one")),
                _ => {}
            }
        }
    }

    fn draws(&mut self, given: Option<&Value<'_>>, axes: &[Varied]) -> Option<u64> {
        let sources: Vec<Source> = axes
            .iter()
            .filter_map(|axis| match axis.through {
                Through::Drawn { source, .. } => Some(source),
                _ => None,
            })
            .collect();
        let most = if sources.contains(&Source::Sobol) { 1 << 32 } else { 1 << 53 };
        match given {
            Some(value) => {
                let draws = whole(value, "draws", (1, most), self.mistakes)?;
                if sources.is_empty() {
                    self.mistakes.note(&value.span(), "no axis is drawn; leave `draws` out, or write an axis as { draw = \"sobol\", low = 0, high = 1 }");
                }
                Some(draws)
            }
            None if sources.is_empty() => Some(1),
            None => {
                self.note("axes are drawn; say how many points by draws = 1000 at the top of the plan");
                None
            }
        }
    }

    fn output(&mut self, mut table: Table<'_, '_>, plan: &mut Plan) {
        if let Some(value) = table.take("rows_per_part")
            && let Some(rows) = whole(value, "rows_per_part", (1, MOST_NUMBERS), self.mistakes)
        {
            plan.rows_per_part = rows;
        }
        if let Some(value) = table.take("columns") {
            let known: Vec<&str> = plan.empty.columns.iter().map(|column| column.name.as_str()).collect();
            let mut places = Vec::new();
            for value in each(value) {
                let Some(name) = text(value, "columns", self.mistakes) else { continue };
                match known.iter().position(|known| *known == name) {
                    Some(place) => places.push(place),
                    None => self.mistakes.note(
                        &value.span(),
                        format!("there is no column `{name}`; there is {}", known.join(", ")),
                    ),
                }
            }
            plan.columns = Some(places.iter().map(|&place| known[place].to_owned()).collect());
            plan.empty = Rows {
                columns: places.iter().map(|&place| plan.empty.columns[place].clone()).collect(),
                values: places.iter().map(|&place| plan.empty.values[place].clone()).collect(),
            };
            plan.places = places;
        }
        table.finish(self.mistakes);
    }

    /// Notes what would not fit into memory, or into a file.
    fn bounds(&mut self, plan: &Plan) {
        let columns = plan.places.len() as u64;
        let most = MOST_NUMBERS / columns.max(1);
        if plan.rows_per_part.min(plan.points()) > most {
            self.note(format!("[output] rows_per_part is at most {most} with {columns} columns, so that a part fits into memory"));
        } else if plan.parts() > MOST_PARTS {
            let least = plan.points().div_ceil(MOST_PARTS);
            self.note(format!("{} parts are too many for one file, which has at most {MOST_PARTS}; write [output] rows_per_part = {least} or more", plan.parts()));
        }
    }
}
