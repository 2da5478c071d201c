//! The Pareto front of price and error.

use super::Measured;

/// Sorts settings by price, then error, and marks those that no other setting beats in both.
pub(super) fn mark_pareto_front(settings: &mut [Measured]) {
    let price = |measured: &Measured| measured.nanoseconds_per_unit_time;
    settings.sort_by(|a, b| price(a).total_cmp(&price(b)).then(a.error().total_cmp(&b.error())));
    let mut least = f64::INFINITY;
    for setting in settings {
        let error = setting.error();
        setting.on_front = error < least;
        least = least.min(error);
    }
}
