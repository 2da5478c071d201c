//! What becomes of what a map loses, as a table.

use kahan_study::PolesFound;

use crate::document::{Table, shorten};

/// A longer formula of a curve is cut.
const WIDEST: usize = 48;

/// A row a pattern.
#[must_use]
pub fn poles(found: &PolesFound) -> Table {
    let found = &found.found;
    let rows = found.patterns.iter().map(|pattern| {
        let images = pattern.images.iter().take(pattern.steps);
        let images = images.map(|image| {
            let dimension = image.dimension.to_string();
            if image.is_infinite { dimension + "'" } else { dimension }
        });
        let verdict = match pattern.confined {
            Some(true) if !pattern.is_blown_down() => "not blown down".to_owned(),
            Some(true) => format!("confined after {} steps", pattern.steps),
            Some(false) => format!("none within {} steps", found.bound),
            None => "undecided".to_owned(),
        };
        let curve = shorten(&pattern.name(&found.symbols), WIDEST);
        vec![curve, verdict, images.collect::<Vec<_>>().join(" ")]
    });
    let caption = "Curves that the map sends to infinity or blows down, and whether what is lost comes back";
    Table::new(caption, ["curve = 0", "what is lost comes back", "dimensions"], rows)
}
