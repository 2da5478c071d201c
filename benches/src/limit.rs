//! Measured figures, and the limits that they may not exceed.

use serde_json::{Value, json};

use crate::table::Table;

/// A measured figure, with its limit if there is one.
pub(crate) struct Limit {
    pub(crate) figure: String,
    pub(crate) at_most: Option<f64>,
    /// The measured figure. `None` if it cannot be measured here.
    pub(crate) measured: Option<f64>,
    /// The unit of the figure: `×` for a ratio, `ms` for a time.
    pub(crate) unit: &'static str,
}

impl Limit {
    pub(crate) fn ratio(figure: impl Into<String>, at_most: f64, measured: Option<f64>) -> Self {
        Self { figure: figure.into(), at_most: Some(at_most), measured, unit: "" }
    }

    pub(crate) fn comparison(figure: impl Into<String>, measured: Option<f64>) -> Self {
        Self { figure: figure.into(), at_most: None, measured, unit: "" }
    }

    /// Returns whether the figure was measured and exceeds its limit.
    pub(crate) fn is_missed(&self) -> bool {
        matches!((self.measured, self.at_most), (Some(measured), Some(at_most)) if measured > at_most)
    }

    pub(crate) fn to_json(&self) -> Value {
        json!({ "figure": self.figure, "at_most": self.at_most, "measured": self.measured })
    }

    fn verdict(&self) -> &'static str {
        match (self.measured, self.at_most) {
            (None, _) => "not measured",
            (Some(_), None) => "for comparison",
            _ if self.is_missed() => "**does not hold**",
            _ => "holds",
        }
    }
}

pub(crate) fn table(limits: &[Limit]) -> Table {
    let mut table = Table::new(&["figure", "at most", "measured", "verdict"]);
    for limit in limits {
        let number = |value: f64| format!("{value:.3}{}", limit.unit);
        let cell = |value: Option<f64>| value.map_or("–".to_owned(), number);
        let (at_most, measured) = (cell(limit.at_most), cell(limit.measured));
        table.push(vec![limit.figure.clone(), at_most, measured, limit.verdict().to_owned()]);
    }
    table
}
