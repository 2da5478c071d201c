//! What `kahan trade` says in words.

use kahan_core::{Composition, Need, Precision};
use kahan_draw::answer::{choice, front};
use kahan_study::reference::Method;
use kahan_study::trade::need_name;

use super::comparison::Comparison;
use crate::printing::layout::table;

/// Steps beyond which a badly rounded ε shows as a linear drift.
const LONG_RUN: u64 = 100_000;

/// A size with four decimals, or digits where it is very large or small.
fn size(value: f64) -> String {
    if (1e-2..1e6).contains(&value) { format!("{value:.4}") } else { format!("{value:.3e}") }
}

impl Comparison {
    pub(super) fn text(&self) -> String {
        let mut lines = vec![
            format!(
                "{}: need {}, tolerance {:e}",
                self.0.title(),
                need_name(self.0.scene.need()),
                self.0.scene.tolerance()
            ),
            String::new(),
        ];
        lines.extend(table(&front(&self.0).rows, 3));
        lines.push(String::new());
        if let Some([chosen, rust]) = choice(&self.0) {
            lines.push(format!("choice     {chosen}"));
            lines.extend(rust.lines().map(|line| format!("           {line}")));
        }
        lines.extend(self.out_of_reach());
        lines.extend(self.notes());
        lines.join("\n") + "\n"
    }

    /// The schemes that cannot reach the tolerance, with the best they reached.
    fn out_of_reach(&self) -> Vec<String> {
        let mut lines = Vec::new();
        for &scheme in &self.0.stalled {
            let settings = self.0.settings.iter().filter(|measured| measured.setting.scheme() == scheme);
            let best = settings.min_by(|a, b| a.error().total_cmp(&b.error()));
            let Some(best) = best.filter(|best| best.error() > self.0.scene.tolerance()) else { continue };
            let reached = match best.error() {
                error if error.is_finite() => format!("{error:.1e} at eps = {:?}", best.setting.eps()),
                _ => "no finite numbers".to_owned(),
            };
            let heading = if lines.is_empty() { "too coarse" } else { "" };
            lines.push(format!("{heading:<10} {scheme}: at best {reached}"));
        }
        lines
    }

    fn notes(&self) -> Vec<String> {
        let mut lines = Vec::new();
        let mut note = |text: String| lines.push(format!("note       {text}"));
        if let Some(certificate) = self.0.certificate {
            let second = match certificate.method {
                Method::ClosedSolution => "the closed solution".to_owned(),
                Method::Composition { steps } => format!("{steps} steps of order 8 in dd"),
            };
            note(format!(
                "errors are against a Taylor series that differs from {second} by {:.1e}; relative to {}",
                certificate.difference,
                size(self.0.scale.expect("a reference has a scale"))
            ));
        }
        if !self.0.is_code {
            note("prices are predicted: the field has no machine code here; E6 was timed, and scaled by the plans' costs".into());
        }
        if let Some(choice) = self.0.choice() {
            let (scheme, eps, steps) =
                (choice.setting.scheme(), choice.setting.eps(), choice.setting.steps());
            let keeps = self.0.scene.need() == Need::Integrals && scheme.composition == Composition::KAHAN;
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
        for (scheme, eps) in &self.0.skipped {
            note(format!("no time for {scheme} from eps = {eps:?} on; --seconds gives more"));
        }
        lines
    }
}
