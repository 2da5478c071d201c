//! Drifts of integrals in a group of orbits.

use kahan_core::observe::Observer;
use kahan_runtime::{Field, IntegralDrift, MapAt};

use super::support::{STEPS, columns};

#[test]
fn integrals_drift_side_by_side_as_they_do_alone() {
    let e6 = "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);
              integral H = (x*z + y^2)/(1 - 3*eps^2*x*z); integral K = 1/2*(x^2 + y^2 + z^2)/(1 - 3*eps^2*x*z);";
    let circle = "xdot = w*y; ydot = -w*x; integral R = w*(x^2 + y^2);";
    let ring = "vdot = v*(w - z); wdot = w*(x - v); xdot = x*(y - w); ydot = y*(z - x); zdot = z*(v - y);
                integral S = v + w + x + y + z;";
    for text in [e6, circle, ring] {
        let field = Field::parse(text).expect("a field with true claims");
        let parameters = |orbit: usize| field.parameters().iter().map(move |name| (name, 1.0 + orbit as f64));
        let eps = |orbit: usize| 0.01 * (orbit % 5 + 1) as f64;
        let map = |orbit: usize| field.with(parameters(orbit)).expect("its parameters").at(eps(orbit));
        let maps: Vec<MapAt<f64>> = (0..19).map(map).collect();
        let start = columns::<f64>(field.variables().len(), 19);
        let mut ours = start.clone();
        let mut slices: Vec<&mut [f64]> = ours.iter_mut().map(Vec::as_mut_slice).collect();
        let of = |orbit: usize| IntegralDrift::of(&maps[orbit]);
        let reports = MapAt::observe_columns(&maps.iter().collect::<Vec<_>>(), &mut slices, STEPS, of);
        for (orbit, report) in reports.expect("columns that fit").iter().enumerate() {
            let mut x: Vec<f64> = start.iter().map(|column| column[orbit]).collect();
            let mut alone = IntegralDrift::of(&maps[orbit]);
            alone.observe(0, &x);
            for step in 1..=STEPS {
                maps[orbit].advance(&mut x, 1).expect("a number a variable");
                alone.observe(step, &x);
            }
            assert_eq!(format!("{report:?}"), format!("{:?}", alone.report()), "{text}: orbit {orbit}");
            assert_eq!(report.len(), field.integrals().len());
        }
    }
}
