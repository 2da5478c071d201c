//! Measures how much the integrals of the map, and those of the flow, change along orbits.

use kahan_core::Dd;

use super::runner::Runner;

/// The claimed integrals of a map, and the integrals of the flow that follow from them.
///
/// A claimed integral depends on ε. Its coefficient of ε⁰ is an integral of the flow. If this is
/// constant, the coefficient of ε² is used.
#[derive(Debug)]
pub(super) struct Integrals {
    /// For each claim, k = 0 or 1: the coefficient of ε²ᵏ is used as integral of the flow. `None`
    /// if both coefficients are constant.
    coefficients: Vec<Option<usize>>,
}

pub(super) struct Drift<'a> {
    subject: &'a Runner<'a>,
    integrals: &'a Integrals,
    eps: f64,
    /// The initial values: for each claim, the map's integral and the flow's.
    begin: Option<Vec<[Dd; 2]>>,
    /// The largest relative changes of the map's integrals and of the flow's integrals.
    pub(super) most: [f64; 2],
}

impl Integrals {
    /// Finds which coefficients depend on the state, from their values at points near the start.
    pub(super) fn of(subject: &Runner<'_>, start: &[Dd]) -> Self {
        let size = start.iter().fold(Dd::from(0.0), |size, x| if x.abs() > size { x.abs() } else { size });
        // For a start at the origin, points are taken at distances near 1.
        let size = if size > Dd::from(0.0) { size } else { Dd::from(1.0) };
        let near = |k: usize| -> Vec<Dd> {
            let moved = start.iter().enumerate();
            let shift = |i: usize| Dd::from(((3 * k + 5 * i) % 7) as f64) / Dd::from(11.0);
            moved.map(|(i, x)| *x + (size + x.abs()) * shift(i)).collect()
        };
        let begin = subject.integrals_at_zero(start);
        let others: Vec<Vec<[Dd; 2]>> = (1..4).map(|k| subject.integrals_at_zero(&near(k))).collect();
        let varies = |claim: usize, power: usize| {
            let value = begin[claim][power];
            let differs = |other: &Vec<[Dd; 2]>| {
                let other = other[claim][power];
                (other - value).abs() > Dd::from(1e-24) * (other.abs() + value.abs())
            };
            value.is_finite() && others.iter().any(differs)
        };
        let coefficients = (0..begin.len()).map(|claim| (0..2).find(|&power| varies(claim, power)));
        Integrals { coefficients: coefficients.collect() }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.coefficients.iter().all(Option::is_none)
    }
}

impl<'a> Drift<'a> {
    pub(super) fn new(subject: &'a Runner<'a>, integrals: &'a Integrals, eps: f64) -> Self {
        Drift { subject, integrals, eps, begin: None, most: [0.0; 2] }
    }

    /// Records the integrals at a point; the first point sets the initial values.
    pub(super) fn visit(&mut self, x: &[Dd]) {
        let values = self.subject.integrals(x, self.eps).into_iter().zip(self.subject.integrals_at_zero(x));
        let now =
            self.integrals.coefficients.iter().zip(values).filter_map(|(power, (value, coefficients))| {
                let power = (*power)?;
                let constant = if power == 0 { Dd::from(0.0) } else { coefficients[0] };
                Some([value - constant, coefficients[power]])
            });
        match &self.begin {
            None => self.begin = Some(now.collect()),
            Some(begin) => {
                for (begin, now) in begin.iter().zip(now) {
                    self.most = [0, 1].map(|k| self.most[k].max(change(begin[k], now[k])));
                }
            }
        }
    }
}

/// Returns the relative change from `begin` to `now`, or the absolute change if `begin` is 0. NaN
/// becomes ∞.
fn change(begin: Dd, now: Dd) -> f64 {
    let (size, change) = (f64::from(begin.abs()), f64::from((now - begin).abs()));
    let change = if size > 0.0 { change / size } else { change };
    if change.is_nan() { f64::INFINITY } else { change }
}
