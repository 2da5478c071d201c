//! A plan from its text.

use std::ops::Range;

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_runtime::{Field, FieldText};
use kahan_systems::entry::Entry;
use kahan_systems::registry;
use toml::de::{DeTable, DeValue};

use super::Plan;
use super::axis::{Axis, Target, Values};
use super::mistakes::{Collector, Mistakes};
use super::table::{Table, Value, each, number, text, whole};
use crate::draw::{DIMENSIONS, Draw, Sobol, Uniform};
use crate::task::{Exactly, Heights, Orbit, Search, Task, WATCHES, Watch};

/// The most points of a plan: beyond, an index has no place in a column.
const MOST_POINTS: u128 = 1 << 62;
/// Rows of a part where the plan does not say.
const ROWS: u64 = 100_000;
/// Numbers that a part may hold in memory.
const MOST_NUMBERS: u64 = 12_000_000;
/// Parts of a sweep: a file of Parquet numbers its row groups with 15 bits.
const MOST_PARTS: u64 = 32_767;
/// The most variables of a chain that is written out.
const MOST_VARIABLES: usize = 200;

pub(super) fn plan(source: &str, origin: &str) -> Result<Plan, Mistakes> {
    let mut mistakes = Collector::new(source);
    let root = match DeTable::parse(source) {
        Ok(root) => root,
        Err(error) => {
            mistakes.note(&error.span().unwrap_or_default(), error.message());
            mistakes.finish(origin)?;
            return Err(Mistakes { origin: origin.to_owned(), mistakes: Vec::new() });
        }
    };
    let root = Table::new("the plan", root.span(), root.get_ref());
    let read = Reader { mistakes: &mut mistakes }.plan(root);
    mistakes.finish(origin)?;
    // Where nothing was noted, nothing is missing.
    read.ok_or_else(|| Mistakes { origin: origin.to_owned(), mistakes: Vec::new() })
}

struct Reader<'m, 's> {
    mistakes: &'m mut Collector<'s>,
}

impl Reader<'_, '_> {
    fn plan(&mut self, mut root: Table<'_, '_>) -> Option<Plan> {
        let (seed, draws) = (root.take("seed"), root.take("draws"));
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
        let ((system, fixed), seed) = (system?, seed?);
        let mut all = fixed;
        match axes {
            Some(axes) => all.extend(self.axes(axes, &system, seed)),
            None => self.note("the plan needs [axes]: what it goes through, with eps and each variable"),
        }
        all.extend(scheme);
        let field = Field::of(&system);
        let task = task?;
        if task.needs_integrals() && field.integrals().is_empty() {
            self.note("observe: drift is that of integrals, and the field claims none");
        }
        // What could not be read is not missing: its mistake is the one to correct.
        if !self.mistakes.is_empty() {
            return None;
        }
        self.missing(&all, &system, &task);
        let draws = self.draws(draws, &all)?;
        let points = all
            .iter()
            .filter_map(Axis::count)
            .fold(u128::from(draws), |points, count| points.saturating_mul(u128::from(count)));
        if points > MOST_POINTS {
            self.note(format!("the plan has {points} points; the most is 2^62"));
            return None;
        }
        let mut plan = Plan { field, axes: all, draws, task, rows_per_part: ROWS, columns: None, seed };
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

    /// The system, and the axes of one value that its parameters are.
    fn system(&mut self, table: Option<Table<'_, '_>>) -> Option<(System, Vec<Axis>)> {
        let Some(mut table) = table else {
            self.note("the plan needs a [system], with name = \"e6\" or field = \"xdot = …;\"");
            return None;
        };
        let (name, field) = (table.take("name"), table.take("field"));
        let sites = table.take("sites");
        let sites = match sites {
            Some(value) => Some(whole(value, "sites", (1, MOST_VARIABLES as u64), self.mistakes)? as usize),
            None => None,
        };
        let params = table.table("params", self.mistakes);
        let span = table.span.clone();
        table.finish(self.mistakes);
        let (source, span) = match (name, field) {
            (Some(value), None) => {
                let name = text(value, "name", self.mistakes)?;
                let entry = registry::find(name).map(Entry::text);
                let family = kahan_systems::lattices::find(name).map(|family| family.text);
                match entry.or(family) {
                    Some(source) => (source.to_owned(), value.span()),
                    None => {
                        let known: Vec<&str> = registry::all().map(|entry| entry.command).collect();
                        self.mistakes.note(
                            &value.span(),
                            format!("there is no system `{name}`; the catalog has {}", known.join(", ")),
                        );
                        return None;
                    }
                }
            }
            (None, Some(value)) => (text(value, "field", self.mistakes)?.to_owned(), value.span()),
            _ => {
                self.mistakes.note(&span, "[system] has either name = \"e6\" or field = \"xdot = …;\"");
                return None;
            }
        };
        let system = self.field(source, sites, &span)?;
        let fixed = params.map_or_else(Vec::new, |params| self.parameters(params, &system));
        Some((system, fixed))
    }

    fn field(&mut self, source: String, sites: Option<usize>, span: &Range<usize>) -> Option<System> {
        let source = FieldText::new(source, "field".to_owned());
        let read = match sites {
            None => source.system(),
            Some(sites) => match source.family() {
                Err(wrong) => Err(wrong),
                Ok(Some(family)) if sites * family.block() <= MOST_VARIABLES => Ok(family.at_sites(sites)),
                Ok(Some(_)) => {
                    self.mistakes.note(
                        span,
                        format!("sites: a chain is written out, up to {MOST_VARIABLES} variables"),
                    );
                    return None;
                }
                Ok(None) => {
                    self.mistakes.note(span, "sites are for a family, `for i in periodic { x[i]dot = …; }`");
                    return None;
                }
            },
        };
        match read {
            Ok(system) => Some(system),
            Err(wrong) => {
                let wrong = wrong.to_string();
                self.mistakes.note(span, wrong.trim_start_matches("error: ").trim_end());
                None
            }
        }
    }

    /// `[system.params]`: parameters with one value.
    fn parameters(&mut self, mut params: Table<'_, '_>, system: &System) -> Vec<Axis> {
        let mut axes = Vec::new();
        for (name, span, value) in params.rest() {
            let Some(k) = system.field.symbols.parameters.iter().position(|known| known == name) else {
                let known = system.field.symbols.parameters.join(", ");
                self.mistakes
                    .note(&span, format!("the field has no parameter `{name}`; it has {}", or_none(&known)));
                continue;
            };
            if let Some(value) = number(value, name, self.mistakes) {
                axes.push(Axis {
                    name: name.to_owned(),
                    target: Target::Parameter(k),
                    values: Values::List(vec![value]),
                });
            }
        }
        axes
    }

    fn axes(&mut self, mut table: Table<'_, '_>, system: &System, seed: u64) -> Vec<Axis> {
        let symbols = &system.field.symbols;
        let mut axes: Vec<Axis> = Vec::new();
        let mut sobol = 0;
        for (name, span, value) in table.rest() {
            let place = |names: &[String]| names.iter().position(|known| known == name);
            let target = place(&symbols.states).map(Target::Variable);
            let target = target.or_else(|| place(&symbols.parameters).map(Target::Parameter));
            let Some(target) = target.or((name == "eps").then_some(Target::Epsilon)) else {
                let known: Vec<&str> =
                    symbols.states.iter().chain(&symbols.parameters).map(String::as_str).collect();
                let hint = if matches!(name, "order" | "scalar") {
                    "; order and scalar are lists in [task]"
                } else if matches!(name, "start" | "at") {
                    "; a start is an axis for each variable: values, a range or a draw"
                } else {
                    ""
                };
                self.mistakes
                    .note(&span, format!("`{name}` is no axis: there is {}, eps{hint}", known.join(", ")));
                continue;
            };
            let index = axes.len();
            if let Some(values) = self.values(name, value, seed, index, &mut sobol) {
                axes.push(Axis { name: name.to_owned(), target, values });
            }
        }
        axes
    }

    fn values(
        &mut self,
        name: &str,
        value: &Value<'_>,
        seed: u64,
        index: usize,
        sobol: &mut usize,
    ) -> Option<Values> {
        let DeValue::Table(inner) = value.get_ref() else {
            let values: Option<Vec<Rational>> =
                each(value).into_iter().map(|value| number(value, name, self.mistakes)).collect();
            let values = values?;
            if values.is_empty() {
                self.mistakes.note(&value.span(), format!("{name} has no values; write at least one"));
                return None;
            }
            return Some(Values::List(values));
        };
        let mut table = Table::new(name, value.span(), inner);
        let values = match table.take("draw") {
            Some(kind) => self.drawn(name, kind, &mut table, seed, index, sobol),
            None => self.grid(name, &mut table),
        };
        table.finish(self.mistakes);
        values
    }

    fn drawn(
        &mut self,
        name: &str,
        kind: &Value<'_>,
        table: &mut Table<'_, '_>,
        seed: u64,
        index: usize,
        sobol: &mut usize,
    ) -> Option<Values> {
        let (low, high) = (self.bound(name, "low", table), self.bound(name, "high", table));
        let (kind, source) = match text(kind, "draw", self.mistakes)? {
            "sobol" => {
                let dimension = *sobol;
                *sobol += 1;
                match Sobol::dimension(dimension) {
                    Some(dimension) => ("sobol", Draw::Sobol(dimension)),
                    None => {
                        self.mistakes.note(&table.span, format!("Sobol points have at most {DIMENSIONS} dimensions; draw {name} with \"uniform\""));
                        return None;
                    }
                }
            }
            "uniform" => ("uniform", Draw::Uniform(Uniform::new(seed, index))),
            other => {
                self.mistakes.note(
                    &kind.span(),
                    format!("there is no draw `{other}`; write \"sobol\" or \"uniform\""),
                );
                return None;
            }
        };
        let (low, high) = (low?, high?);
        if low >= high || !(low.to_f64().is_finite() && high.to_f64().is_finite()) {
            self.mistakes
                .note(&table.span, format!("{name}: low is below high, both within the range of doubles"));
            return None;
        }
        Some(Values::Drawn { source: Box::new(source), kind, low, high })
    }

    /// `{ from, to, points }` or `{ from, to, step }`.
    fn grid(&mut self, name: &str, table: &mut Table<'_, '_>) -> Option<Values> {
        let (from, to) = (self.bound(name, "from", table), self.bound(name, "to", table));
        let (points, step) = (table.take("points"), table.take("step"));
        let (from, to) = (from?, to?);
        match (points, step) {
            (Some(points), None) => {
                let count = whole(points, "points", (2, 1 << 40), self.mistakes)?;
                let parts = Rational::from(count as i64 - 1);
                let step = (&to - &from).checked_div(&parts)?;
                Some(Values::Grid { from, step, count })
            }
            (None, Some(step)) => {
                let size = number(step, "step", self.mistakes)?;
                let steps = (&to - &from).checked_div(&size).map(|steps| steps.to_f64().floor());
                let Some(steps) = steps.filter(|steps| (0.0..1e12).contains(steps)) else {
                    self.mistakes.note(
                        &step.span(),
                        format!("{name}: step leads from `from` to `to`, in at most 10^12 steps"),
                    );
                    return None;
                };
                Some(Values::Grid { from, step: size, count: steps as u64 + 1 })
            }
            _ => {
                self.mistakes.note(
                    &table.span,
                    format!("{name}: a range is {{ from, to, points }} or {{ from, to, step }}, a draw {{ draw, low, high }}"),
                );
                None
            }
        }
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

    /// The task, and the axes of order and scalar.
    fn task(&mut self, table: Option<Table<'_, '_>>) -> (Option<Task>, Vec<Axis>) {
        const KINDS: &str = "kind = \"orbit\", \"heights\" or \"discover\"";

        let Some(mut table) = table else {
            self.note(format!("the plan needs a [task], with {KINDS}"));
            return (None, Vec::new());
        };
        let mut scheme = Vec::new();
        let kind = table.take("kind");
        let task = match kind.and_then(|kind| text(kind, "kind", self.mistakes)) {
            Some("orbit") => self.orbit(&mut table, &mut scheme).map(Task::Orbit),
            Some("heights") => {
                self.heights(&mut table).map(|heights| Task::Exactly(Exactly::Heights(heights)))
            }
            Some("discover") => {
                self.discover(&mut table).map(|search| Task::Exactly(Exactly::Search(search)))
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
        (task, scheme)
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

    fn orbit(&mut self, table: &mut Table<'_, '_>, scheme: &mut Vec<Axis>) -> Option<Orbit> {
        let steps = self.steps(table, 1 << 53);
        let (order, scalar) = (table.take("order"), table.take("scalar"));
        let (every, escape, observe) = (table.take("every"), table.take("escape"), table.take("observe"));
        if let Some(value) = order {
            let orders = each(value).into_iter().filter_map(|value| self.order(value)).collect();
            scheme.push(Axis {
                name: "order".to_owned(),
                target: Target::Order,
                values: Values::List(orders),
            });
        }
        if let Some(value) = scalar {
            let bits = each(value).into_iter().filter_map(|value| self.bits(value)).collect();
            scheme.push(Axis { name: "bits".to_owned(), target: Target::Bits, values: Values::List(bits) });
        }
        let every = every.map_or(Some(10), |value| whole(value, "every", (1, 1 << 40), self.mistakes));
        let escape = escape.map_or(Some(1e6), |value| Some(number(value, "escape", self.mistakes)?.to_f64()));
        let observe = observe.map_or_else(Vec::new, each).into_iter().filter_map(|value| self.watch(value));
        let mut distinct = Vec::new();
        for watch in observe {
            if !distinct.contains(&watch) {
                distinct.push(watch);
            }
        }
        Some(Orbit { steps: steps?, every: every?, escape: escape?, observe: distinct })
    }

    fn order(&mut self, value: &Value<'_>) -> Option<Rational> {
        let order = whole(value, "order", (2, 8), self.mistakes)?;
        if order % 2 == 1 {
            self.mistakes.note(&value.span(), "order is 2, 4, 6 or 8");
        }
        Some(Rational::from(order as i64))
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

    fn watch(&mut self, value: &Value<'_>) -> Option<Watch> {
        let name = text(value, "observe", self.mistakes)?;
        let found = WATCHES.iter().find(|(known, _)| *known == name).map(|(_, watch)| *watch);
        if found.is_none() {
            let known: Vec<&str> = WATCHES.iter().map(|(name, _)| *name).collect();
            let message = format!("there is no observer `{name}`; there is {}", known.join(", "));
            self.mistakes.note(&value.span(), message);
        }
        found
    }

    fn heights(&mut self, table: &mut Table<'_, '_>) -> Option<Heights> {
        let (steps, digits) = (self.steps(table, 1 << 20), table.take("digits"));
        let digits =
            digits.map_or(Some(100_000), |value| whole(value, "digits", (1, 100_000_000), self.mistakes));
        Some(Heights { steps: steps?, digits: digits? })
    }

    fn discover(&mut self, table: &mut Table<'_, '_>) -> Option<Search> {
        match table.take("degree") {
            Some(value) => {
                let degree = whole(value, "degree", (1, 20), self.mistakes)?;
                Some(Search { degree: Some(degree as u32) })
            }
            None => Some(Search { degree: None }),
        }
    }

    /// Notes what has no value, and what has two.
    fn missing(&mut self, axes: &[Axis], system: &System, task: &Task) {
        let symbols = &system.field.symbols;
        let starts = if task.has_starts() { &symbols.states[..] } else { &[] };
        for name in starts.iter().chain(&symbols.parameters).map(String::as_str).chain(["eps"]) {
            match axes.iter().filter(|axis| axis.name == name).count() {
                0 => self.note(format!("`{name}` has no value; give it one under [axes], such as {name} = 1 or {name} = [0.1, 0.2]")),
                1 => {}
                _ => self.note(format!("`{name}` stands under [system.params] and under [axes]; leave it out of one")),
            }
        }
        if !task.has_starts()
            && let Some(axis) = axes.iter().find(|axis| matches!(axis.target, Target::Variable(_)))
        {
            self.mistakes
                .note(&(0..0), format!("`{}` is a start, and a search has none; leave it out", axis.name));
        }
    }

    fn draws(&mut self, given: Option<&Value<'_>>, axes: &[Axis]) -> Option<u64> {
        let is_drawn = axes.iter().any(|axis| axis.count().is_none());
        let most = if axes.iter().any(|axis| matches!(&axis.values, Values::Drawn { kind: "sobol", .. })) {
            1 << 32
        } else {
            1 << 53
        };
        match given {
            Some(value) => {
                let draws = whole(value, "draws", (1, most), self.mistakes)?;
                if !is_drawn {
                    self.mistakes.note(&value.span(), "no axis is drawn; leave `draws` out, or write an axis as { draw = \"sobol\", low = 0, high = 1 }");
                }
                Some(draws)
            }
            None if is_drawn => {
                self.mistakes.note(
                    &(0..0),
                    "axes are drawn; say how many points by draws = 1000 at the top of the plan",
                );
                None
            }
            None => Some(1),
        }
    }

    fn output(&mut self, mut table: Table<'_, '_>, plan: &mut Plan) {
        if let Some(value) = table.take("rows_per_part")
            && let Some(rows) = whole(value, "rows_per_part", (1, MOST_NUMBERS), self.mistakes)
        {
            plan.rows_per_part = rows;
        }
        if let Some(value) = table.take("columns") {
            let known: Vec<String> =
                crate::columns::all(plan).into_iter().map(|column| column.name).collect();
            let mut columns = Vec::new();
            for value in each(value) {
                let Some(name) = text(value, "columns", self.mistakes) else { continue };
                if known.iter().any(|known| known == name) {
                    columns.push(name.to_owned());
                } else {
                    self.mistakes.note(
                        &value.span(),
                        format!("there is no column `{name}`; there is {}", known.join(", ")),
                    );
                }
            }
            plan.columns = Some(columns);
        }
        table.finish(self.mistakes);
    }

    /// Notes what would not fit into memory, or into a file.
    fn bounds(&mut self, plan: &Plan) {
        let columns = crate::columns::written(plan).len() as u64;
        let most = MOST_NUMBERS / columns.max(1);
        if plan.rows_per_part.min(plan.points()) > most {
            self.note(format!("[output] rows_per_part is at most {most} with {columns} columns, so that a part fits into memory"));
        } else if plan.parts() > MOST_PARTS {
            let least = plan.points().div_ceil(MOST_PARTS);
            self.mistakes.note(
                &(0..0),
                format!("{} parts are too many for one file, which has at most {MOST_PARTS}; write [output] rows_per_part = {least} or more", plan.parts()),
            );
        }
    }
}

fn or_none(text: &str) -> &str {
    if text.is_empty() { "none" } else { text }
}
