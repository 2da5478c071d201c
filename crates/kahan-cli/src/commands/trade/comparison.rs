//! Settings compared on one scene: the choice, or why there is none.

use kahan_study::Study;
use kahan_study::trade::{Measured, Trade, Traded};

use crate::printing::{Prompt, Refusal};

/// What was measured, and on what.
pub(super) struct Comparison(pub(super) Traded);

impl Comparison {
    /// Measures.
    pub(super) fn of(study: &Study, asked: &Trade) -> Result<Self, Refusal> {
        Ok(Comparison(asked.ask(study, &Prompt::of("settings"))?))
    }

    /// The setting that comes nearest to the tolerance.
    fn most_accurate(&self) -> Option<&Measured> {
        self.0.settings.iter().min_by(|a, b| a.error().total_cmp(&b.error()))
    }

    pub(super) fn complaint(&self) -> Option<String> {
        if self.0.choice().is_some() {
            return None;
        }
        if self.0.settings.is_empty() {
            return Some(format!(
                "nothing was measured on {}, there was no time for it; try more --seconds, or a shorter --horizon",
                self.0.title()
            ));
        }
        let wanted =
            format!("no setting reaches the tolerance {:e} on {}", self.0.scene.tolerance(), self.0.title());
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
        let way_out = if self.0.skipped.is_empty() {
            "a larger --tolerance or a shorter --horizon"
        } else {
            "more --seconds, a larger --tolerance or a shorter --horizon"
        };
        Some(format!("{wanted}: {best}; try {way_out}"))
    }
}
