//! `kahan discover`: what a field's map preserves, found from its equations alone. What is found is `kahan-discover`'s; this
//! only prints it.

use std::time::Instant;

use clap::Args;
use kahan_algebra::rational::Rational;
use kahan_discover::claims::Formula;
use kahan_discover::report::HamiltonianReport;
use kahan_discover::{Options, Report, discover};
use serde_json::{Map, Value, json};

use super::input::number;
use super::layout::{labelled, matrix};
use super::output::{Answer, Refusal};
use super::progress::Progress;
use super::search::{Search, refused};

/// Finds what the map of a field preserves, from its equations alone: integrals, invariant densities, structure, growth.
///
/// What is given (--eps, --param) is fixed, the rest generic. Integrals and densities come as lines of the language of
/// `kahan!`, each of them proved; what stands behind `when` is fixed. The Hilbert function counts the monomials of degree at
/// most 1, 2, … that are independent on an orbit; where it stays below the number of all monomials, the map has integrals.
/// Where nothing is found, the sentence says up to which degree it was looked for. Claims that the field brings along are not
/// looked at.
#[derive(Args, Debug)]
#[command(after_long_help = EXAMPLES)]
pub(crate) struct Discover {
    #[command(flatten)]
    search: Search,
}

const EXAMPLES: &str = "\
The JSON object holds hilbert, independent_integrals, degrees, growth, entropy, linear_integrals, integrals, densities,
hamiltonian and more.

Examples:
  kahan discover --field 'xdot = y; ydot = 6*x^2 - a;'
  kahan discover e6
  kahan discover lv --eps 1
  kahan discover e9 --param xi=-1 --json
  kahan discover lagrange --seconds 120
  kahan discover lorenz --degree 12";

/// What was found, and of what.
struct Finding {
    name: String,
    fixed: Vec<(String, Rational)>,
    eps: Option<Rational>,
    report: Report,
    seconds: f64,
}

impl Discover {
    /// The report.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let search = &self.search;
        let block = search.source.required_block()?;
        let system = block.unproved_system()?;
        let name = block.name(&system);
        let fixed = search.source.fixed_parameters(&system, &name)?;
        let eps = search.eps.as_deref().map(|eps| number(eps, "--eps")).transpose()?;
        let options = Options {
            eps: eps.clone(),
            parameters: fixed.clone(),
            degree: search.degree_for(&system)?,
            seconds: search.seconds,
            ..Options::default()
        };
        let clock = Instant::now();
        let progress = Progress::stages();
        let report = discover(&system, &options, &mut |stage| progress.say(&stage.to_string()));
        progress.finish();
        let report = report.map_err(|error| refused(&name, &error))?;
        let finding = Finding { name, fixed, eps, report, seconds: clock.elapsed().as_secs_f64() };
        Ok(if search.json { Answer::json(&finding.object()) } else { Answer::text(finding.text()) })
    }
}

impl Finding {
    fn object(&self) -> Value {
        let report = &self.report;
        let fixed = self.fixed.iter().map(|(name, value)| (name.clone(), json!(value.to_string())));
        let generic = report.parameters.iter().map(|name| (name.clone(), Value::Null));
        let hilbert = report.hilbert.as_ref();
        let structure = &report.structure;
        let texts =
            |formulas: &[Formula]| formulas.iter().map(|formula| json!(formula.text)).collect::<Value>();
        json!({
            "system": self.name,
            "variables": report.variables,
            // null is generic.
            "parameters": fixed.chain(generic).collect::<Map<_, _>>(),
            "eps": self.eps.as_ref().map(ToString::to_string),
            "hilbert": hilbert.map_or_else(Vec::new, |hilbert| hilbert.values.clone()),
            "monomials": hilbert.map_or_else(Vec::new, |hilbert| hilbert.full.clone()),
            "independent_integrals": report.independent_integrals(),
            "degrees": report.degrees,
            "growth": report.growth.growth.word(),
            "entropy": report.growth.growth.entropy(),
            "linear_integrals": structure.linear_integrals,
            "quadratic_integrals_of_the_flow": structure.quadratic_integrals,
            "integrals": texts(&report.integrals),
            "densities": texts(&report.densities),
            "divergence": structure.divergence,
            "is_even": structure.is_even,
            "hamiltonian": structure.hamiltonian.as_ref().map(hamiltonian_object),
            "survivors": self.survivors(),
            "sentences": report.sentences,
            "out_of_time": report.out_of_time,
            "seconds": self.seconds,
        })
    }

    /// What composition leaves: how many independent integrals, which of the formulas, and which quotients of two.
    fn survivors(&self) -> Option<Value> {
        let survivors = self.report.survivors.as_ref()?;
        let name = |index: usize| self.report.integrals[index].name().unwrap_or_default().to_owned();
        let kept = (0..survivors.formulas.len()).filter(|&index| survivors.formulas[index]).map(name);
        let quotients =
            survivors.quotients.iter().map(|&(above, below)| format!("{}/{}", name(above), name(below)));
        Some(json!({
            "independent_integrals": survivors.hilbert.integrals,
            "hilbert": survivors.hilbert.values,
            "formulas": kept.collect::<Vec<_>>(),
            "quotients": quotients.collect::<Vec<_>>(),
        }))
    }

    fn text(&self) -> String {
        let report = &self.report;
        let head = self.head();
        let mut lines: Vec<String> =
            head.iter().flat_map(|row| labelled(&row[0], &row[1], KEY_WIDTH)).collect();
        if !report.integrals.is_empty() || !report.densities.is_empty() {
            lines.push(String::new());
            let claims = report.integrals.iter().chain(&report.densities);
            lines.extend(claims.map(|formula| formula.text.clone()));
        }
        lines.push(String::new());
        lines.extend(report.sentences.iter().cloned());
        if let Some(hamiltonian) = &report.structure.hamiltonian {
            lines.push(String::new());
            lines.push("K =".to_owned());
            lines.extend(matrix(&hamiltonian.tensor, '[', ']').iter().map(|row| format!("  {row}")));
        }
        lines.join("\n") + "\n"
    }

    /// The numbers, one kind a line.
    fn head(&self) -> Vec<Vec<String>> {
        let report = &self.report;
        let numbers =
            |values: &[usize]| values.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let listed = |texts: &[String]| if texts.is_empty() { "none".to_owned() } else { texts.join(", ") };
        let mut fixed: Vec<String> =
            self.fixed.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let mut generic = report.parameters.clone();
        match &self.eps {
            Some(eps) => fixed.push(format!("eps = {eps}")),
            None => generic.push("eps".to_owned()),
        }
        let mut rows = vec![
            ["system".to_owned(), self.name.clone()],
            ["variables".to_owned(), report.variables.join(", ")],
            ["generic".to_owned(), listed(&generic)],
        ];
        if !fixed.is_empty() {
            rows.push(["fixed".to_owned(), fixed.join(", ")]);
        }
        rows.push(["degrees".to_owned(), numbers(&report.degrees)]);
        rows.push(["growth".to_owned(), report.growth.growth.to_string()]);
        if let Some(hilbert) = &report.hilbert {
            rows.push(["hilbert".to_owned(), numbers(&hilbert.values)]);
            rows.push(["monomials".to_owned(), numbers(&hilbert.full)]);
        }
        rows.push(["integrals".to_owned(), report.independent_integrals().to_string()]);
        let structure = &report.structure;
        // Those of higher degree are not looked for, so that silence says nothing of them.
        let of_flow = [structure.linear_integrals.as_slice(), &structure.quadratic_integrals].concat();
        if !of_flow.is_empty() {
            rows.push(["of the flow".to_owned(), of_flow.join(", ")]);
        }
        rows.push(["seconds".to_owned(), format!("{:.2}", self.seconds)]);
        rows.into_iter().map(|row| row.to_vec()).collect()
    }
}

/// The width of the words before the numbers.
const KEY_WIDTH: usize = 11;

fn hamiltonian_object(found: &HamiltonianReport) -> Value {
    json!({ "K": found.tensor, "H": found.hamiltonian, "modified_is_proved": found.modified_is_proved })
}
