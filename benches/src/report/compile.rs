//! Reports the cost of compiling, compared with that of an earlier commit.

use anyhow::Result;

use super::Section;
use crate::compile::{BEFORE, Cost, from_text};
use crate::limit::Limit;
use crate::table::{Table, short};

pub(crate) fn compile(costs: &[Cost]) -> Result<(Vec<Section>, Vec<Limit>)> {
    let before = from_text(BEFORE)?;
    let mut table = Table::new(&["block", "expansion", "was", "debug build", "was", "release build", "was"]);
    for cost in costs {
        let earlier = before.iter().find(|earlier| earlier.block == cost.block);
        table.push(vec![
            cost.block.clone(),
            short(Some(cost.expansion)),
            short(earlier.map(|earlier| earlier.expansion)),
            short(Some(cost.debug)),
            short(earlier.map(|earlier| earlier.debug)),
            short(Some(cost.release)),
            short(earlier.map(|earlier| earlier.release)),
        ]);
    }
    let claims = costs.iter().filter(|cost| cost.block.contains("claims")).map(|cost| cost.expansion);
    let limit = Limit {
        figure: "expansion of a block with claims, three variables, worst".to_owned(),
        at_most: Some(25.0),
        measured: claims.reduce(f64::max),
        unit: " ms",
    };
    let origin: Vec<&str> = BEFORE.lines().filter_map(|line| line.strip_prefix("# ")).collect();
    let text = format!(
        "Milliseconds. The macro is built without optimisation, as Cargo builds macros; a build is the processor time for a\n\
         library with one block and one call of `step`, dependencies built before, less that for an empty library.\n{}",
        origin.join("\n"),
    );
    Ok((vec![Section { title: "Compiling".to_owned(), text, table }], vec![limit]))
}
