//! Settings compared on one scene: the choice, why there is none, and all of it as JSON.

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_measure::reference::Method;
use kahan_measure::trade::{Need, Setting, Trade};
use serde_json::{Value, json};

use super::paste::rust_of;
use crate::reading::Block;

/// What was measured, and on what.
pub(super) struct Comparison<'a> {
    pub(super) name: &'a str,
    pub(super) block: &'a Block,
    pub(super) system: &'a System,
    pub(super) parameters: &'a [Rational],
    pub(super) start: &'a [Rational],
    pub(super) horizon: f64,
    pub(super) need: Need,
    pub(super) tolerance: f64,
    pub(super) trade: Trade,
}

impl Comparison<'_> {
    pub(super) fn need_name(&self) -> &'static str {
        match self.need {
            Need::Trajectory => "trajectory",
            Need::Integrals => "integrals",
        }
    }

    pub(super) fn title(&self) -> String {
        let point: Vec<String> = self.start.iter().map(ToString::to_string).collect();
        format!("{} from ({}) over {} units of time", self.name, point.join(", "), self.horizon)
    }

    pub(super) fn choice(&self) -> Option<&Setting> {
        self.trade.choice.map(|choice| &self.trade.settings[choice])
    }

    /// The setting that comes nearest to the tolerance.
    fn most_accurate(&self) -> Option<&Setting> {
        self.trade.settings.iter().min_by(|a, b| a.error(self.need).total_cmp(&b.error(self.need)))
    }

    pub(super) fn complaint(&self) -> Option<String> {
        if self.choice().is_some() {
            return None;
        }
        if self.trade.settings.is_empty() {
            return Some(format!(
                "nothing was measured on {}, there was no time for it; try more --seconds, or a shorter --horizon",
                self.title()
            ));
        }
        let wanted = format!("no setting reaches the tolerance {:e} on {}", self.tolerance, self.title());
        let best = match self.most_accurate() {
            Some(best) if best.error(self.need).is_finite() => {
                format!("the best is {}, eps = {:?}, with {:.1e}", best.kind, best.eps, best.error(self.need))
            }
            _ => "none gives finite numbers".to_owned(),
        };
        let way_out = if self.trade.skipped.is_empty() {
            "a larger --tolerance or a shorter --horizon"
        } else {
            "more --seconds, a larger --tolerance or a shorter --horizon"
        };
        Some(format!("{wanted}: {best}; try {way_out}"))
    }

    pub(super) fn object(&self) -> Value {
        let exact = |values: &[Rational]| values.iter().map(ToString::to_string).collect::<Vec<_>>();
        let names = self.system.field.symbols.parameters.iter().cloned();
        let parameters = names.zip(exact(self.parameters).into_iter().map(Value::from));
        let choice = self.choice().map(|choice| {
            let mut object = setting_object(choice);
            object["rust"] = json!(rust_of(self, choice));
            object
        });
        let skipped = self.trade.skipped.iter().map(|(kind, eps)| {
            json!({
                "scalar": kind.scalar.name(), "order": kind.order, "compensated": kind.compensated, "eps": eps,
            })
        });
        json!({
            "system": self.name,
            "parameters": parameters.collect::<serde_json::Map<_, _>>(),
            "x": exact(self.start),
            "horizon": self.horizon,
            "need": self.need_name(),
            "tolerance": self.tolerance,
            "scale": self.trade.scale,
            "reference": self.trade.certificate.map(|certificate| json!({
                "second_method": match certificate.method {
                    Method::ClosedSolution => "closed solution",
                    Method::Composition { .. } => "composition",
                },
                "difference": certificate.difference,
            })),
            "timing": if self.trade.is_compiled { "measured" } else { "predicted" },
            "settings": self.trade.settings.iter().map(setting_object).collect::<Vec<_>>(),
            "choice": choice,
            "skipped": skipped.collect::<Vec<_>>(),
        })
    }
}

/// What is not finite is `null`.
fn setting_object(setting: &Setting) -> Value {
    json!({
        "scalar": setting.kind.scalar.name(),
        "order": setting.kind.order,
        "compensated": setting.kind.compensated,
        "eps": setting.eps,
        "steps": setting.steps,
        "nanoseconds_per_unit_time": setting.nanoseconds_per_unit_time,
        "trajectory_error": setting.trajectory_error,
        "integral_drift": setting.integral_drift,
        "flow_integral_drift": setting.flow_integral_drift,
        "return_error": setting.return_error,
        "on_front": setting.on_front,
    })
}
