//! The lines that only interpreted systems run, made once and shared by copies over all scalars.

use kahan_algebra::derived::Derived;
use kahan_algebra::plan::Plan;

use crate::line::Line;

/// The objects of a system that are no function of one state over slices.
#[derive(Debug)]
pub(crate) struct Code {
    pub(super) bilinear: Line,
    pub(super) polarized: Line,
    /// det A, within the budget of terms.
    pub(super) det_matrix: Option<Line>,
    /// The numerators, then the denominator, within the budget.
    pub(super) rational_map: Option<Line>,
    /// The same, where a factor that depends on states is divided out.
    pub(super) reduced_map: Option<Line>,
    /// The integrals that were claimed without a condition, each by itself.
    pub(super) integrals: Vec<Line>,
}

impl Code {
    pub(crate) fn of(derived: &Derived) -> Self {
        let symbols = &derived.system.field.symbols;
        let line = |plan: &Plan| Line::of(plan, symbols);
        let perhaps = |plan: &Option<Plan>| plan.as_ref().map(line);
        let integral = |index| Line::with_poles(&derived.integrals.result(index), symbols);
        Code {
            bilinear: line(&derived.bilinear),
            polarized: line(&derived.polarized),
            det_matrix: perhaps(&derived.det_matrix),
            rational_map: perhaps(&derived.rational_map),
            reduced_map: perhaps(&derived.reduced_map),
            integrals: (0..derived.integral_names.len()).map(integral).collect(),
        }
    }
}
