//! What was found at the extremes, as a table.

use kahan_study::Judged;
use kahan_study::extremes::{Broken, Cell, Place};

use crate::printing::layout::{headed, labelled, table};

/// The columns of the labels below the table.
const LABELS: usize = 15;

pub(super) fn text(judged: &Judged) -> String {
    let headings =
        ["regime", "tier", "scalar", "trials", "largest error", "flagged", "without right", "silently wrong"];
    let mut lines = table(&headed(headings, judged.tally.cells.iter().map(row)), 3);
    lines.push(String::new());
    lines.extend(labelled("systems", &judged.systems.join(", "), LABELS));
    let removable = match judged.removable.as_slice() {
        [] => "none; their quarter went to the poles".to_owned(),
        systems => systems.join(", "),
    };
    lines.extend(labelled("removable poles", &removable, LABELS));
    lines.extend(judged.random_fields.iter().map(|(name, equations)| format!("{name}: {equations}")));
    if judged.odd_fields > 0 {
        lines.push(format!("besides {} random fields of odd tempers, all of them judged", judged.odd_fields));
    }
    for (name, Broken { text, silently_wrong, unjustified, first }) in &judged.tally.broken {
        lines.push(format!(
            "{name}, {silently_wrong} silently wrong, {unjustified} flagged without right: {text}"
        ));
        lines.push(format!("  {}", first.text));
    }
    lines.push(format!("seed {}, {:.1} seconds", judged.seed, judged.seconds.unwrap_or_default()));
    lines.join("\n") + "\n"
}

/// What the stable tier did against its promise.
pub(super) fn complaint(judged: &Judged) -> Option<String> {
    let [wrong, flags] = judged.against_the_promise();
    let examples: Vec<&str> = judged.tally.failures.iter().map(|failure| failure.text.as_str()).collect();
    (wrong + flags > 0).then(|| {
        format!(
            "the stable tier breaks its promise: {wrong} silently wrong, {flags} flagged without right. The first of each: {}",
            examples.join("; ")
        )
    })
}

fn row((place, cell): (&Place, &Cell)) -> Vec<String> {
    let (regime, tier, scalar) = place;
    let error = match cell.max_error_u {
        None => "-".to_owned(),
        Some(error) if error < 1000.0 => format!("{error:.2} u"),
        Some(error) => format!("{error:.1e} u"),
    };
    let rate = 100.0 * cell.flagged as f64 / cell.trials as f64;
    let without_right = if *tier == "stable" { cell.unjustified.to_string() } else { "-".to_owned() };
    vec![
        regime.name().to_owned(),
        (*tier).to_owned(),
        (*scalar).to_owned(),
        cell.trials.to_string(),
        error,
        format!("{rate:.2} %"),
        without_right,
        silently_wrong(cell),
    ]
}

/// The count; none among n trials bounds the rate by 3/n with a confidence of 95 %, as (1 − 3/n)ⁿ
/// is about 1/20.
fn silently_wrong(cell: &Cell) -> String {
    match cell.silently_wrong {
        0 => format!("0, < 3/{} at 95 %", cell.trials),
        wrong => format!("{wrong}, {:.2} %", 100.0 * wrong as f64 / cell.trials as f64),
    }
}
