//! The front: what no other setting beats in price and accuracy together.

use super::{Need, Setting};

/// Marks the settings on the front; they are given by price, the cheapest first.
pub(super) fn mark(settings: &mut [Setting], need: Need) {
    let mut least = f64::INFINITY;
    for setting in settings {
        let error = setting.error(need);
        setting.on_front = error < least;
        least = least.min(error);
    }
}
