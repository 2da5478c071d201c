//! Settings compared on one scene: the choice, why there is none, and all of it as JSON.

use kahan_algebra::rational::Rational;
use kahan_core::{Need, Scene};
use kahan_study::reference::Method;
use kahan_study::trade::{Measured, Subject, Trade};
use serde_json::{Value, json};

use super::paste::rust_of;
use crate::reading::Block;

/// What was measured, and on what.
pub(in super::super) struct Comparison<'a> {
    pub(super) name: &'a str,
    pub(super) block: &'a Block,
    pub(super) subject: Subject<'a>,
    pub(super) scene: Scene,
    pub(super) trade: Trade,
}

impl Comparison<'_> {
    pub(super) fn need_name(&self) -> &'static str {
        match self.scene.need() {
            Need::Trajectory => "trajectory",
            Need::Integrals => "integrals",
        }
    }

    pub(in super::super) fn title(&self) -> String {
        let point: Vec<String> = self.subject.start.iter().map(ToString::to_string).collect();
        format!("{} from ({}) over {} units of time", self.name, point.join(", "), self.scene.horizon())
    }

    pub(super) fn choice(&self) -> Option<&Measured> {
        self.trade.choice.map(|choice| &self.trade.settings[choice])
    }

    /// The setting that comes nearest to the tolerance.
    fn most_accurate(&self) -> Option<&Measured> {
        self.trade.settings.iter().min_by(|a, b| a.error().total_cmp(&b.error()))
    }

    pub(in super::super) fn complaint(&self) -> Option<String> {
        if self.choice().is_some() {
            return None;
        }
        if self.trade.settings.is_empty() {
            return Some(format!(
                "nothing was measured on {}, there was no time for it; try more --seconds, or a shorter --horizon",
                self.title()
            ));
        }
        let wanted =
            format!("no setting reaches the tolerance {:e} on {}", self.scene.tolerance(), self.title());
        let best = match self.most_accurate() {
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
        let way_out = if self.trade.skipped.is_empty() {
            "a larger --tolerance or a shorter --horizon"
        } else {
            "more --seconds, a larger --tolerance or a shorter --horizon"
        };
        Some(format!("{wanted}: {best}; try {way_out}"))
    }

    pub(super) fn object(&self) -> Value {
        let exact = |values: &[Rational]| values.iter().map(ToString::to_string).collect::<Vec<_>>();
        let names = self.subject.system.field.symbols.parameters.iter().cloned();
        let parameters = names.zip(exact(self.subject.parameters).into_iter().map(Value::from));
        let choice = self.choice().map(|choice| {
            let mut object = setting_object(choice);
            object["rust"] = json!(rust_of(self, &choice.setting));
            object
        });
        let skipped = self.trade.skipped.iter().map(|(scheme, eps)| {
            json!({
                "scalar": scheme.precision.name(),
                "order": scheme.order(),
                "compensated": scheme.compensated,
                "eps": eps,
            })
        });
        json!({
            "system": self.name,
            "parameters": parameters.collect::<serde_json::Map<_, _>>(),
            "x": exact(self.subject.start),
            "horizon": self.scene.horizon(),
            "need": self.need_name(),
            "tolerance": self.scene.tolerance(),
            "scale": self.trade.scale,
            "reference": self.trade.certificate.map(|certificate| json!({
                "second_method": match certificate.method {
                    Method::ClosedSolution => "closed solution",
                    Method::Composition { .. } => "composition",
                },
                "difference": certificate.difference,
            })),
            "timing": if self.trade.is_code { "measured" } else { "predicted" },
            "settings": self.trade.settings.iter().map(setting_object).collect::<Vec<_>>(),
            "choice": choice,
            "skipped": skipped.collect::<Vec<_>>(),
        })
    }
}

/// What is not finite is `null`.
fn setting_object(measured: &Measured) -> Value {
    let scheme = measured.setting.scheme();
    json!({
        "scalar": scheme.precision.name(),
        "order": scheme.order(),
        "compensated": scheme.compensated,
        "eps": measured.setting.eps(),
        "steps": measured.setting.steps(),
        "nanoseconds_per_unit_time": measured.nanoseconds_per_unit_time,
        "trajectory_error": measured.trajectory_error,
        "integral_drift": measured.integral_drift,
        "flow_integral_drift": measured.flow_integral_drift,
        "return_error": measured.return_error,
        "on_front": measured.on_front,
    })
}
