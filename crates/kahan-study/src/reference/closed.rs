//! Closed-form flows of catalog systems, computed in 256 bits and rounded to double-double.

use kahan_core::Dd;
use kahan_core::num_rational::BigRational;

use kahan_systems::registry::find;
use kahan_systems::special::Float256;

pub(super) type Solution = Box<dyn Fn(Dd) -> Vec<Dd>>;

/// Returns the closed-form solution through `start` of a catalog system; `None` if the solution is
/// unknown, or if `start` lies outside its domain.
pub(super) fn closed_solution(
    command: &str,
    parameters: &[BigRational],
    start: &[BigRational],
) -> Option<Solution> {
    let precise = |values: &[BigRational]| values.iter().map(Float256::from_rational).collect::<Vec<_>>();
    let trajectory = find(command)?.flow?(&precise(parameters), &precise(start))?;
    Some(Box::new(move |t| {
        let (high, low) = (Float256::from(t.high()), Float256::from(t.low()));
        trajectory(&(high + low)).iter().map(double_double).collect()
    }))
}

fn double_double(value: &Float256) -> Dd {
    let high = value.to_f64();
    Dd::new(high, (*value - Float256::from(high)).to_f64())
}
