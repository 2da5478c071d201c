//! The closed solutions of the catalog's flows, in 256 bits, rounded to double-double.

use kahan_core::Dd;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;

use kahan_systems::special::{Precise, Real};
use kahan_systems::{e1, e2, e3, e4, e5, e6, e7, e8, e9, euler};

/// A solution as a function of time.
pub(super) type Solution = Box<dyn Fn(Dd) -> Vec<Dd>>;

/// The closed solution of the system with this command name that starts at this point, where there is one.
///
/// `None` for systems without one (Lotka–Volterra, fields of the user's), and where the point lies outside the domain of the
/// formula.
pub(super) fn closed_solution(
    command: &str,
    parameters: &[BigRational],
    start: &[BigRational],
) -> Option<Solution> {
    let precise = |values: &[BigRational]| values.iter().map(Precise::from_rational).collect::<Vec<_>>();
    let parameters = precise(parameters);
    let [x, y, z] = <[Precise; 3]>::try_from(precise(start)).ok()?;
    let point = SVector::from([x, y, z]);
    let xi = parameters.first();
    Some(match command {
        "euler" => {
            let coefficients = <[Precise; 3]>::try_from(parameters).ok()?;
            let solution = euler::FlowSolution::through(&coefficients, &point).ok()?;
            rounded(move |t| solution.at(t))
        }
        "e1" => e1::FlowSolution::through(&point).map(|solution| rounded(move |t| solution.at(t))).ok()?,
        "e2" => e2::FlowSolution::through(&point).map(|solution| rounded(move |t| solution.at(t))).ok()?,
        "e3" => e3::FlowSolution::through(&point).map(|solution| rounded(move |t| solution.at(t))).ok()?,
        "e4" => e4::FlowSolution::through(&point).map(|solution| rounded(move |t| solution.at(t))).ok()?,
        "e5" => e5::FlowSolution::through(&point).map(|solution| rounded(move |t| solution.at(t))).ok()?,
        "e6" => e6::FlowSolution::through(&point).map(|solution| rounded(move |t| solution.at(t))).ok()?,
        "e7" => {
            e7::FlowSolution::through(xi?, &point).map(|solution| rounded(move |t| solution.at(t))).ok()?
        }
        "e8" => e8::FlowSolution::through(&point).map(|solution| rounded(move |t| solution.at(t))).ok()?,
        "e9" => {
            e9::FlowSolution::through(xi?, &point).map(|solution| rounded(move |t| solution.at(t))).ok()?
        }
        _ => return None,
    })
}

fn rounded(solution: impl Fn(&Precise) -> SVector<Precise, 3> + 'static) -> Solution {
    Box::new(move |t| {
        let (high, low) = (Precise::from_f64(t.high()), Precise::from_f64(t.low()));
        solution(&(high + low)).iter().map(double_double).collect()
    })
}

/// The nearest double-double number.
fn double_double(value: &Precise) -> Dd {
    let high = value.to_f64();
    Dd::new(high, (value.clone() - Precise::from_f64(high)).to_f64())
}
