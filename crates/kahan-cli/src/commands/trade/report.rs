//! What `kahan trade` says in words.

use kahan_core::{Composition, Need, Precision};
use kahan_draw::answer::{choice, front};
use kahan_study::reference::Method;
use kahan_study::trade::{Traded, need_name};

use super::super::line::Line;
use crate::printing::layout::table;

/// Steps beyond which a badly rounded ε shows as a linear drift.
const LONG_RUN: u64 = 100_000;

/// A size with four decimals, or digits where it is very large or small.
fn size(value: f64) -> String {
    if (1e-2..1e6).contains(&value) { format!("{value:.4}") } else { format!("{value:.3e}") }
}

/// `call` makes the orbit of the choice.
pub(super) fn text(traded: &Traded, call: Option<&Line>) -> String {
    let mut lines = vec![
        format!(
            "{}: need {}, tolerance {:e}",
            traded.title(),
            need_name(traded.scene.need()),
            traded.scene.tolerance()
        ),
        String::new(),
    ];
    lines.extend(table(&front(traded).rows, 4));
    lines.push(String::new());
    if let Some([chosen, rust]) = choice(traded) {
        lines.push(format!("choice     {chosen}"));
        let call = call.map(|call| format!("           {call}"));
        lines.extend(call.into_iter().chain(rust.lines().map(|line| format!("           {line}"))));
    }
    lines.extend(out_of_reach(traded));
    lines.extend(notes(traded));
    lines.join("\n") + "\n"
}

/// The schemes that cannot reach the tolerance, with the best they reached.
fn out_of_reach(traded: &Traded) -> Vec<String> {
    let mut lines = Vec::new();
    for &scheme in &traded.stalled {
        let settings = traded.settings.iter().filter(|measured| measured.setting.scheme() == scheme);
        let best = settings.min_by(|a, b| a.error().total_cmp(&b.error()));
        let Some(best) = best.filter(|best| best.error() > traded.scene.tolerance()) else { continue };
        let reached = match best.error() {
            error if error.is_finite() => format!("{error:.1e} at eps = {:?}", best.setting.eps()),
            _ => "no finite numbers".to_owned(),
        };
        let heading = if lines.is_empty() { "too coarse" } else { "" };
        lines.push(format!("{heading:<10} {scheme}: at best {reached}"));
    }
    lines
}

fn notes(traded: &Traded) -> Vec<String> {
    let mut lines = Vec::new();
    let mut note = |text: String| lines.push(format!("note       {text}"));
    if let Some(certificate) = traded.certificate {
        let second = match certificate.method {
            Method::ClosedSolution => "the closed solution".to_owned(),
            Method::Composition { steps } => format!("{steps} steps of order 8 in dd"),
        };
        note(format!(
            "errors are against a Taylor series that differs from {second} by {:.1e}; relative to {}",
            certificate.difference,
            size(traded.scale.expect("a reference has a scale"))
        ));
    }
    if !traded.is_code {
        note("prices are predicted: the field has no machine code here; E6 was timed, and scaled by the plans' costs".into());
    }
    if let Some(choice) = traded.choice() {
        let (scheme, eps, steps) = (choice.setting.scheme(), choice.setting.eps(), choice.setting.steps());
        let keeps = traded.scene.need() == Need::Integrals && scheme.composition == Composition::KAHAN;
        if keeps {
            let flow = choice.flow_integral_drift.expect("the need is to keep integrals");
            note(format!(
                "the map's own integrals are kept at any eps; at this one the flow's vary by {flow:.1e}, and the orbit need not \
                 follow the flow"
            ));
        }
        if keeps && steps >= LONG_RUN && scheme.precision != Precision::DoubleDouble {
            note(format!(
                "keep eps = {eps:?} to the last digit: where the step has powers of eps, one with more bits would have them rounded, and \
                 over {steps} steps what the map conserves would drift linearly, compensated or not"
            ));
        }
    }
    for (scheme, eps) in &traded.skipped {
        note(format!("no time for {scheme} from eps = {eps:?} on; --seconds gives more"));
    }
    lines
}

/// Why there is no choice.
pub(super) fn complaint(traded: &Traded) -> Option<String> {
    if traded.choice().is_some() {
        return None;
    }
    if traded.settings.is_empty() {
        return Some(format!(
            "nothing was measured on {}, there was no time for it; try more --seconds, or a shorter --horizon",
            traded.title()
        ));
    }
    let wanted =
        format!("no setting reaches the tolerance {:e} on {}", traded.scene.tolerance(), traded.title());
    let best = match traded.settings.iter().min_by(|a, b| a.error().total_cmp(&b.error())) {
        Some(best) if best.error().is_finite() => {
            format!(
                "the best is {}, eps = {:?}, with {:.1e}",
                best.setting.scheme(),
                best.setting.eps(),
                best.error()
            )
        }
        _ => "none gives finite numbers".to_owned(),
    };
    let way_out = if traded.skipped.is_empty() {
        "a larger --tolerance or a shorter --horizon"
    } else {
        "more --seconds, a larger --tolerance or a shorter --horizon"
    };
    Some(format!("{wanted}: {best}; try {way_out}"))
}
