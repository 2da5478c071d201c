//! What must hold, and what was measured.

use crate::table::Table;

/// A figure with the most that it may be, if it has to hold and does not only stand beside one that
/// has to.
pub(crate) struct Limit {
    pub(crate) figure: String,
    pub(crate) at_most: Option<f64>,
    /// `None` where it could not be measured here.
    pub(crate) measured: Option<f64>,
    /// `×` for a ratio, `ms` for a time.
    pub(crate) unit: &'static str,
}

impl Limit {
    pub(crate) fn ratio(figure: impl Into<String>, at_most: f64, measured: Option<f64>) -> Self {
        Self { figure: figure.into(), at_most: Some(at_most), measured, unit: "" }
    }

    pub(crate) fn comparison(figure: impl Into<String>, measured: Option<f64>) -> Self {
        Self { figure: figure.into(), at_most: None, measured, unit: "" }
    }

    fn verdict(&self) -> &'static str {
        match (self.measured, self.at_most) {
            (None, _) => "not measured",
            (Some(_), None) => "for comparison",
            (Some(measured), Some(at_most)) if measured <= at_most => "holds",
            (Some(_), Some(_)) => "**does not hold**",
        }
    }
}

/// All limits as a table.
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
