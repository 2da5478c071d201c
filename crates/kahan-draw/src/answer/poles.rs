//! A table of singularity patterns. A pattern consists of a curve, which the map contracts or sends
//! to infinity, and of the images of the curve.

use kahan_study::PolesFound;

use crate::document::Table;

/// The greatest number of characters of a polynomial that is shown in full.
const MAX_POLYNOMIAL_LENGTH: usize = 1000;

/// Returns a table with one row for each pattern.
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
            Some(true) if !pattern.is_blown_down() => "nothing is lost".to_owned(),
            Some(true) => format!("confined after {} steps", pattern.steps),
            Some(false) => format!("none within {} steps", found.bound),
            None => "undecided".to_owned(),
        };
        let place = match &pattern.curve {
            Some(curve) => match pattern.name(&found.symbols) {
                text if text.len() <= MAX_POLYNOMIAL_LENGTH => text,
                _ => format!(
                    "a polynomial of degree {} with {} terms",
                    found.symbols.degree(curve),
                    curve.terms().count()
                ),
            },
            None => "the points at infinity".to_owned(),
        };
        vec![place, verdict, images.collect::<Vec<_>>().join(" ")]
    });
    let caption = "What the map sends to infinity or blows down, and whether what is lost there comes back";
    Table::new(caption, ["where this is 0", "what is lost comes back", "dimensions"], rows)
}
