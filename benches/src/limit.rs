//! What must hold, and what was measured.

use crate::table::Table;

/// A figure with the most that it may be.
pub(crate) struct Limit {
    pub(crate) figure: String,
    pub(crate) at_most: f64,
    /// `None` where it could not be measured here.
    pub(crate) measured: Option<f64>,
    /// `×` for a ratio, `ms` for a time.
    pub(crate) unit: &'static str,
}

impl Limit {
    pub(crate) fn ratio(figure: impl Into<String>, at_most: f64, measured: Option<f64>) -> Self {
        Self { figure: figure.into(), at_most, measured, unit: "" }
    }

    fn verdict(&self) -> &'static str {
        match self.measured {
            None => "not measured",
            Some(measured) if measured <= self.at_most => "holds",
            Some(_) => "**does not hold**",
        }
    }
}

/// All limits as a table.
pub(crate) fn table(limits: &[Limit]) -> Table {
    let mut table = Table::new(&["figure", "at most", "measured", "verdict"]);
    for limit in limits {
        let number = |value: f64| format!("{value:.3}{}", limit.unit);
        let measured = limit.measured.map_or("–".to_owned(), number);
        table.push(vec![limit.figure.clone(), number(limit.at_most), measured, limit.verdict().to_owned()]);
    }
    table
}
