//! Reports how an integral drifts on long orbits.

use super::Section;
use crate::drift::{EPS, lines};
use crate::limit::Limit;
use crate::progress::Progress;
use crate::race::Effort;
use crate::table::Table;

/// Computes the orbits. A quick run ends at 10⁷ steps.
pub(crate) fn drift(effort: Effort) -> (Vec<Section>, Vec<Limit>) {
    let progress = Progress::new(1);
    progress.begin("E6: a long orbit");
    let mut table = Table::new(&["steps", "plain", "compensated"]);
    for line in lines(if effort.is_quick() { 7 } else { 9 }) {
        let cell = |change: f64| format!("{change:.1e}");
        table.push(vec![format!("{:e}", line.steps as f64), cell(line.plain), cell(line.compensated)]);
    }
    progress.advance();
    let text = format!(
        "E6 at ε = {EPS}, one orbit: the relative change of the map's own integral, evaluated in double-double. It is exact for the\n\
         map; what changes it is rounding, a random walk. The law over 16 orbits is tested: `cargo test --release -p kahan-tests\n\
         compensated -- --ignored --nocapture`."
    );
    (vec![Section { title: "A long orbit".to_owned(), text, table }], Vec::new())
}
