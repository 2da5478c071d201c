//! Exact orbits over big rationals, whose growing digits show whether the map has integrals.
//!
//! If integrals confine an orbit to a curve, the number of digits grows at most like the square of
//! the number of steps. Otherwise it usually grows exponentially, here by a factor of about 2 in
//! each step.

use kahan_core::prelude::*;

kahan! {
    struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
}

kahan! {
    struct LotkaVolterra;
    xdot = x*(1 - y);
    ydot = y*(x - 1);
}

/// Returns the number of digits in the denominator of x after each step. Also asserts that equally
/// many inverse steps return to the start.
fn digits<const N: usize>(map: &impl KahanMap<BigRational, N>, x: [(i64, i64); N]) -> Vec<usize> {
    let start = SVector::from(x.map(|(p, q)| BigRational::new(p.into(), q.into())));
    let eps = BigRational::new(1.into(), 3.into());
    let points: Vec<_> = map.orbit(start.clone(), eps.clone()).take(13).collect();
    let last = points[points.len() - 1].clone();
    assert_eq!((1..points.len()).fold(last, |x, _| map.step_back(&x, eps.clone())), start);
    points[1..].iter().map(|x| x[0].denom().to_string().len()).collect()
}

/// Prints and returns the numbers of digits for one orbit of each system.
pub(crate) fn run() -> [Vec<usize>; 2] {
    let grown = [digits(&E6, [(3, 7), (11, 13), (23, 47)]), digits(&LotkaVolterra, [(1, 2), (5, 3)])];
    println!("E6             {:?}\nLotka–Volterra {:?}", grown[0], grown[1]);
    grown
}

fn main() {
    run();
}
