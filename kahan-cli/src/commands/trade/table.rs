//! What `kahan trade` says in words.

use kahan_measure::reference::Method;
use kahan_measure::trade::{Need, ScalarKind, Setting};

use super::comparison::Comparison;
use super::paste::rust_of;
use crate::printing::layout::table;

/// Steps beyond which a badly rounded ε shows as a linear drift.
const LONG_RUN: u64 = 100_000;

/// A size with four decimals, or digits where it is very large or small.
fn size(value: f64) -> String {
    if (1e-2..1e6).contains(&value) { format!("{value:.4}") } else { format!("{value:.3e}") }
}

impl Comparison<'_> {
    pub(super) fn text(&self) -> String {
        let mut lines = vec![
            format!("{}: need {}, tolerance {:e}", self.title(), self.need_name(), self.tolerance),
            String::new(),
        ];
        lines.extend(self.front());
        lines.push(String::new());
        if let Some(choice) = self.choice() {
            lines.push(format!(
                "choice     {}, eps = {:?}: {} ns per unit of time, {} {:.1e}",
                choice.kind,
                choice.eps,
                price(choice),
                self.error_name(),
                choice.error(self.need)
            ));
            let rust = rust_of(self, choice);
            lines.extend(rust.lines().map(|line| format!("           {line}")));
        }
        lines.extend(self.out_of_reach());
        lines.extend(self.notes());
        lines.join("\n") + "\n"
    }

    fn error_name(&self) -> &'static str {
        match self.need {
            Need::Trajectory => "trajectory error",
            Need::Integrals => "drift of integrals",
        }
    }

    /// A row for each setting on the front, the cheapest first.
    fn front(&self) -> Vec<String> {
        let header = [
            "scalar",
            "order",
            "compensated",
            "eps",
            "ns per unit time",
            "trajectory",
            "integrals",
            "return",
        ];
        let mut rows = vec![header.map(str::to_owned).to_vec()];
        rows.extend(self.trade.settings.iter().filter(|setting| setting.on_front).map(|setting| {
            vec![
                setting.kind.scalar.name().to_owned(),
                setting.kind.order.to_string(),
                if setting.kind.compensated { "yes" } else { "no" }.to_owned(),
                format!("{:?}", setting.eps),
                price(setting),
                error(setting.trajectory_error),
                error(setting.integral_drift),
                error(setting.return_error),
            ]
        }));
        table(&rows, 3)
    }

    /// The kinds that cannot reach the tolerance, with the best they reached.
    fn out_of_reach(&self) -> Vec<String> {
        let mut lines = Vec::new();
        for &kind in &self.trade.stalled {
            let settings = self.trade.settings.iter().filter(|setting| setting.kind == kind);
            let best = settings.min_by(|a, b| a.error(self.need).total_cmp(&b.error(self.need)));
            let Some(best) = best.filter(|best| best.error(self.need) > self.tolerance) else { continue };
            let reached = match best.error(self.need) {
                error if error.is_finite() => format!("{error:.1e} at eps = {:?}", best.eps),
                _ => "no finite numbers".to_owned(),
            };
            let heading = if lines.is_empty() { "too coarse" } else { "" };
            lines.push(format!("{heading:<10} {kind}: at best {reached}"));
        }
        lines
    }

    fn notes(&self) -> Vec<String> {
        let mut lines = Vec::new();
        let mut note = |text: String| lines.push(format!("note       {text}"));
        if let Some(certificate) = self.trade.certificate {
            let second = match certificate.method {
                Method::ClosedSolution => "the closed solution".to_owned(),
                Method::Composition { steps } => format!("{steps} steps of order 8 in dd"),
            };
            note(format!(
                "errors are against a Taylor series that differs from {second} by {:.1e}; relative to {}",
                certificate.difference,
                size(self.trade.scale.unwrap_or(1.0))
            ));
        }
        if !self.trade.is_compiled {
            note("prices are predicted: the field is interpreted here; compiled E6 was timed, and scaled by the plans' costs".into());
        }
        if let Some(choice) = self.choice() {
            if self.need == Need::Integrals && choice.kind.order == 2 {
                let flow = choice.flow_integral_drift.unwrap_or(0.0);
                note(format!(
                    "the map's own integrals are kept at any eps; at this one the flow's vary by {flow:.1e}, and the orbit need not \
                     follow the flow"
                ));
            }
            let is_long = choice.steps >= LONG_RUN && choice.kind.scalar != ScalarKind::Dd;
            if self.need == Need::Integrals && choice.kind.order == 2 && is_long {
                note(format!(
                    "keep eps = {:?} to the last digit: where the step has powers of eps, one with more bits would have them rounded, and \
                     over {} steps what the map conserves would drift linearly, compensated or not",
                    choice.eps, choice.steps
                ));
            }
        }
        for (kind, eps) in &self.trade.skipped {
            note(format!("no time for {kind} from eps = {eps:?} on; --seconds gives more"));
        }
        lines
    }
}

fn price(setting: &Setting) -> String {
    let price = setting.nanoseconds_per_unit_time;
    if price < 0.1 {
        return format!("{price:.1e}");
    }
    let decimals = if price < 10.0 {
        2
    } else if price < 100.0 {
        1
    } else {
        0
    };
    format!("{price:.decimals$}")
}

fn error(value: Option<f64>) -> String {
    match value {
        Some(value) if value.is_finite() => format!("{value:.1e}"),
        Some(_) => "not finite".to_owned(),
        None => "-".to_owned(),
    }
}
