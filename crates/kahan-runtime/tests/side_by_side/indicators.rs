//! Drifts of integrals, and indicators by their names.

use kahan_core::observe::{Escape, Fli, Lyapunov, Megno, Observer, Sali};
use kahan_runtime::{Field, Indicator, IntegralDrift, MapAt};

use super::support::{STEPS, columns, maps};

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

#[test]
fn indicators_are_what_observers_report() {
    let (_, map) = maps().nth(3).expect("four variables");
    let at = map.at(0.1);
    let start = columns::<f64>(4, 21);
    let observed = |indicator: Indicator| {
        let mut columns = start.clone();
        let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        indicator.of(&[&at], &mut slices, STEPS).expect("columns that fit")
    };
    let mut columns = start.clone();
    let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    let observers = |_| {
        let beyond = Escape::when(|x: &[f64]| x.iter().any(|x| x.abs() > 2.0));
        ((Sali::new(&at), Fli::new(&at)), (Megno::new(&at), Lyapunov::new(&at)), beyond)
    };
    let reports = MapAt::observe_columns(&[&at], &mut slices, STEPS, observers).expect("columns that fit");
    let all =
        [Indicator::Sali, Indicator::Fli, Indicator::Megno, Indicator::Lyapunov, Indicator::Escape(2.0)];
    let [sali, fli, megno, lyapunov, escape] = all.map(observed);
    let mut escaped = 0;
    for (orbit, ((own_sali, own_fli), (own_megno, own_exponent), own_step)) in reports.into_iter().enumerate()
    {
        assert_eq!((sali[orbit], fli[orbit]), (own_sali, own_fli));
        assert_eq!((megno[orbit], lyapunov[orbit]), (own_megno.mean, own_exponent.value));
        assert_eq!(Some(escape[orbit]).filter(|step| !step.is_nan()), own_step.map(|step| step as f64));
        escaped += usize::from(own_step.is_some());
    }
    assert!(escaped > 0 && escaped < 21, "{escaped}");
    assert!(observed(Indicator::Drift).iter().all(|drift| *drift == 0.0), "no integral is claimed");
}

/// An exponent of a linear field is that of its map everywhere; a point too large has none.
#[test]
fn what_leaves_the_numbers_has_no_indicator() {
    let map = Field::parse("xdot = x; ydot = -y;").expect("a field").map().expect("no parameters").at(0.25);
    let mut columns = [vec![1.0, 1e308], vec![1.0; 2]];
    let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    let exponents = Indicator::Lyapunov.of(&[&map], &mut slices, 100).expect("columns that fit");
    assert!(exponents[0] > 0.9 && exponents[1].is_nan(), "{exponents:?}");
}
