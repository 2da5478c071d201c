//! `kahan scan`: which values of parameters, and of ε, are special. What is seen is
//! `kahan-discover`'s; this only prints it.

use clap::Args;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_discover::scan::{GridPoint, Proposal, Sight};
use kahan_discover::{Options, Scan as Grid, Scanned, scan};
use serde_json::{Map, Value, json};

use super::search::{Search, refused};
use crate::printing::layout::table;
use crate::printing::{Answer, Prompt, Refusal};
use crate::reading::{Range, Spacing, number};

/// Finds special values of parameters and of eps, on a grid.
///
/// At every point of the grid it takes the degrees of some iterates and the Hilbert function of an
/// orbit, and counts the algebraic integrals that the orbit shows. Special are the points where
/// something else is seen than at generic values; they are printed. A range is FROM:TO:COUNT, so
/// many values with both ends; FROM:TO:+STEP, steps from FROM as long as TO is not passed; or
/// FROM:TO:/CELLS, the middles of so many cells. What has a single value is fixed, and what is not
/// given is generic.
///
/// With two ranges or more it looks for relations as well, as c = -a - b or a1*a2 = a5*a6: all
/// points of the grid on them are special. In the time that is left formulas are looked for there,
/// and printed as claims `when` the relation holds, each proved; where none is, the relation is
/// only seen.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Scan {
    #[command(flatten)]
    search: Search,
}

const EXAMPLES: &str = "\
The JSON object holds every point: system, names, generic, points, special, relations, out_of_time, seconds.

Examples:
  kahan scan e9 --param xi=-2:2:+1/12
  kahan scan lv --eps -2:2:+1/4
  kahan scan e7 --param xi=-2:2:+1/4 --eps 1/4:2:+1/4 --json
  kahan scan --field 'xdot = y; ydot = c*y + 6*x^2 - a;' --param c=-1:1:+1/5 --param a=1";

/// The most points of a grid.
const MOST_POINTS: usize = 1_000_000;

impl Scan {
    /// The special points, or all in JSON.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let search = &self.search;
        let (source, ranges) = search.source.without_ranges();
        let block = source.required_block()?;
        let system = block.unproved_system()?;
        let name = block.name(&system);
        let mut options = Options {
            parameters: source.fixed_parameters(&system, &name)?,
            degree: search.degree_for(&system)?,
            seconds: search.seconds,
            ..Options::default()
        };
        let mut axes = parameter_axes(&ranges, &system, &name, &options.parameters)?;
        match search.eps.as_deref() {
            Some(range) if range.contains(':') => axes.push(axis("eps", range, "--eps")?),
            Some(value) => options.eps = Some(number(value, "--eps")?),
            None => {}
        }
        let total = axes.iter().try_fold(1usize, |count, axis| count.checked_mul(axis.values.len()));
        let total = total.filter(|total| *total <= MOST_POINTS).ok_or_else(|| {
            Refusal::new(format!("the grid has more than {MOST_POINTS} points; take larger steps"))
        })?;
        if axes.is_empty() {
            return Err(Refusal::new(
                "which values? give a range to a parameter or to eps, FROM:TO:+STEP, as in --param xi=-2:2:+1/12 or --eps 1/4:2:+1/4",
            ));
        }
        let prompt = Prompt::new(total as u64, "points");
        let found = scan(&system, &axes, &options, &prompt);
        prompt.finish();
        let found = found.map_err(|error| refused(&name, &error))?;
        let seconds = prompt.seconds();
        Ok(if search.json {
            Answer::json(&object(&name, &found, seconds))
        } else {
            Answer::text(text(&name, &found, total, seconds))
        })
    }
}

/// The axes of parameters, each a parameter of the system and none given twice.
fn parameter_axes(
    ranges: &[(&str, &str)],
    system: &System,
    name: &str,
    fixed: &[(String, Rational)],
) -> Result<Vec<Scanned>, Refusal> {
    let mut axes: Vec<Scanned> = Vec::new();
    for &(parameter, range) in ranges {
        let parameter = parameter.trim();
        let known = &system.field.symbols.parameters;
        if !known.iter().any(|one| one == parameter) {
            let known = if known.is_empty() {
                "it has none".to_owned()
            } else {
                format!("it has {}", known.join(", "))
            };
            return Err(Refusal::new(format!("--param: `{parameter}` is no parameter of {name}: {known}")));
        }
        let is_given = axes.iter().map(|axis| &axis.name).chain(fixed.iter().map(|(name, _)| name));
        if is_given.into_iter().any(|given| given == parameter) {
            return Err(Refusal::new(format!("--param: `{parameter}` is given twice")));
        }
        axes.push(axis(parameter, range, &format!("--param {parameter}"))?);
    }
    Ok(axes)
}

/// The values of a range behind an option.
fn axis(name: &str, range: &str, option: &str) -> Result<Scanned, Refusal> {
    // The third part was a step.
    let range = Range::read(name, range, option, |step| Spacing::Step(Rational::from(step as i64)))?;
    Ok(Scanned { name: name.to_owned(), values: range.values().collect() })
}

fn object(name: &str, found: &Grid, seconds: f64) -> Value {
    let special: Vec<Value> = found.special().map(|point| values(found, point)).collect();
    let points: Vec<Value> = found
        .points
        .iter()
        .map(|point| json!({ "values": values(found, point), "sight": point.sight.as_ref().map(sight) }))
        .collect();
    json!({
        "system": name,
        "names": found.names,
        "generic": sight(&found.generic),
        "points": points,
        "special": special,
        "relations": found.relations.iter().map(relation).collect::<Vec<_>>(),
        "out_of_time": found.out_of_time,
        "seconds": seconds,
    })
}

fn values(found: &Grid, point: &GridPoint) -> Value {
    let pairs = found.names.iter().zip(&point.values);
    pairs.map(|(name, value)| (name.clone(), json!(value.to_string()))).collect::<Map<_, _>>().into()
}

fn relation(found: &Proposal) -> Value {
    json!({
        "relation": found.relation,
        "points": found.points,
        "sight": sight(&found.sight),
        "claims": found.claims,
        "proved": !found.claims.is_empty(),
    })
}

/// What a relation has for it, in words, and the claims that are proved there.
fn relation_lines(found: &Proposal) -> Vec<String> {
    let Proposal { relation, points, claims, .. } = found;
    let integrals = match found.sight.integrals {
        0 => "no integral".to_owned(),
        1 => "1 integral".to_owned(),
        count => format!("{count} integrals"),
    };
    let seen =
        format!("when {relation}: all {points} points of the grid there are special, with {integrals}");
    let verdict = if claims.is_empty() { "only seen, nothing is proved" } else { "proved" };
    let mut lines =
        vec![String::new(), format!("{seen}; {verdict}{}", if claims.is_empty() { "" } else { ":" })];
    lines.extend(claims.iter().cloned());
    lines
}

fn sight(sight: &Sight) -> Value {
    json!({ "independent_integrals": sight.integrals, "hilbert": sight.hilbert, "degrees": sight.degrees })
}

fn text(name: &str, found: &Grid, total: usize, seconds: f64) -> String {
    let numbers = |values: &[usize]| values.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    let seen = |sight: &Option<Sight>| match sight {
        Some(sight) => vec![sight.integrals.to_string(), numbers(&sight.hilbert), numbers(&sight.degrees)],
        None => vec!["-".to_owned(), "no map that can be inverted, or every orbit ends at a pole".to_owned()],
    };
    let headings = ["integrals", "Hilbert function", "degrees"].map(str::to_owned);
    let mut rows = vec![[found.names.clone(), headings.to_vec()].concat()];
    let generic = vec!["generic".to_owned(); found.names.len()];
    rows.push([generic, seen(&Some(found.generic.clone()))].concat());
    rows.extend(found.special().map(|point| {
        let values: Vec<String> = point.values.iter().map(ToString::to_string).collect();
        [values, seen(&point.sight)].concat()
    }));
    let special = rows.len() - 2;
    let mut lines = table(&rows, found.names.len());
    lines.push(String::new());
    let looked = found.points.len();
    lines.push(format!(
        "{name}: {} special of {looked} points; seen are the degrees of {} iterates and relations of degree {} at most; {seconds:.2} s",
        if special == 0 { "none is".to_owned() } else { format!("{special} {}", if special == 1 { "is" } else { "are" }) },
        found.generic.degrees.len().saturating_sub(1),
        found.generic.hilbert.len(),
    ));
    if found.out_of_time {
        lines.push(format!(
            "note: time ran out before {} of {total} points; a larger --seconds goes further",
            total - looked
        ));
    }
    lines.extend(found.relations.iter().flat_map(relation_lines));
    lines.join("\n") + "\n"
}
