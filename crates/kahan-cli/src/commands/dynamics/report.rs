//! What was observed as tables.

use kahan_study::Observed;

use crate::printing::layout::{Rows, table};

/// What was observed as text.
pub(super) fn text(observed: &Observed) -> String {
    let escaped = observed.escaped.map_or("no".to_owned(), |step| format!("at step {step}"));
    let last =
        vec![vec!["steps".to_owned(), observed.steps.to_string()], vec!["escaped".to_owned(), escaped]];
    let tables = tables(observed).into_iter().chain([last]);
    let tables: Vec<String> = tables.map(|rows| table(&rows, 1).join("\n") + "\n").collect();
    tables.join("\n")
}

/// The same as tables, each with its headings first.
pub(in super::super) fn tables(observed: &Observed) -> Vec<Rows> {
    let row = |cells: &[&str]| cells.iter().map(|cell| (*cell).to_owned()).collect::<Vec<_>>();
    let mut tables = Vec::new();
    let mut rows = vec![row(&["Lyapunov exponent", "value", "converged to"])];
    for (k, exponent) in observed.lyapunov.iter().enumerate() {
        rows.push(vec![(k + 1).to_string(), number(exponent.value), short(exponent.error)]);
    }
    let sum: f64 = observed.lyapunov.iter().map(|exponent| exponent.value).sum();
    rows.push(vec!["sum".to_owned(), number(sum), String::new()]);
    rows.push(vec!["mean log |det J|".to_owned(), number(observed.mean_log_det), String::new()]);
    tables.push(rows);
    tables.push(vec![
        row(&["indicator", "value"]),
        vec!["FLI".to_owned(), number(observed.fli)],
        vec!["MEGNO".to_owned(), number(observed.megno)],
        vec!["SALI".to_owned(), number(observed.sali)],
    ]);
    let mut rows = vec![row(&["variable", "least", "greatest", "turns a step", "error"])];
    let variables = observed.variables.iter().zip(&observed.extrema).zip(&observed.rotation);
    for ((name, extremes), turns) in variables {
        let [least, greatest] =
            extremes.map_or([String::new(), String::new()], |of| [number(of.least), number(of.greatest)]);
        rows.push(vec![name.clone(), least, greatest, number(turns.value), short(turns.error)]);
    }
    tables.push(rows);
    if !observed.drift.is_empty() {
        let mut rows = vec![row(&["integral", "greatest drift", "final drift"])];
        for (name, drifted) in observed.integrals.iter().zip(&observed.drift) {
            rows.push(vec![name.clone(), short(drifted.max), short(drifted.last)]);
        }
        tables.push(rows);
    }
    tables
}

/// Why there are fewer steps than asked.
pub(in super::super) fn complaint(observed: &Observed) -> Option<String> {
    observed.left_range.then(|| {
        format!(
            "the orbit of {} leaves the range of f64 at step {}: a pole (det A = 0) or too large numbers; what is said is of the steps \
             before",
            observed.system,
            observed.steps + 1
        )
    })
}

/// Eight digits; nothing for what is not a number.
fn number(value: f64) -> String {
    if value.is_nan() {
        return "-".to_owned();
    }
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e6).contains(&size) => {
            let before = size.log10().floor().max(0.0) as usize;
            format!("{value:.0$}", 8 - before.min(7))
        }
        _ => format!("{value:.7e}"),
    }
}

/// Two digits.
fn short(value: f64) -> String {
    if value.is_nan() { "-".to_owned() } else { format!("{value:.1e}") }
}
