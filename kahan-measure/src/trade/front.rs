//! The front: what no other setting beats in price and accuracy together.

use super::Measured;

/// Marks the settings on the front; they are given by price, the cheapest first.
pub(super) fn mark(settings: &mut [Measured]) {
    let mut least = f64::INFINITY;
    for setting in settings {
        let error = setting.error();
        setting.on_front = error < least;
        least = least.min(error);
    }
}
