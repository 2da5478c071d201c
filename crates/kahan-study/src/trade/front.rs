//! The front: what no other setting beats in price and accuracy together.

use std::cmp::Ordering;

use super::Measured;

/// The cheaper first, and of two at one price the more accurate.
pub(super) fn better(a: &Measured, b: &Measured) -> Ordering {
    let price = a.nanoseconds_per_unit_time.total_cmp(&b.nanoseconds_per_unit_time);
    price.then(a.error().total_cmp(&b.error()))
}

/// Puts the better settings first, and marks those on the front.
pub(super) fn mark(settings: &mut [Measured]) {
    settings.sort_by(better);
    let mut least = f64::INFINITY;
    for setting in settings {
        let error = setting.error();
        setting.on_front = error < least;
        least = least.min(error);
    }
}
