//! Tests that Lyapunov exponents of lifted fields are those of the original equations.
//!
//! The reference integrates the original equations and their variational equations by the classical
//! Runge–Kutta method. The sum of exponents is the mean divergence of the original field.

use kahan_algebra::rational::Rational;
use kahan_study::{
    LiftCriterion, Observable, Observe, Observed, ObservedValue, Question, Range, Study, Subject, Systems,
    Unwatched,
};

/// Maps time t, state x and tangent vector v to f(t, x) and f′v, for the equation ẋ = f(t, x).
type Field = fn(f64, &[f64], &[f64]) -> (Vec<f64>, Vec<f64>);

struct Case {
    text: &'static str,
    field: Field,
    at: &'static [(i64, i64)],
}

const DRIVEN: Case = Case {
    text: "xdot = v; vdot = x - x^3 - 0.3*v + 0.5*cos(1.2*t);",
    field: |t, x, v| {
        let force = 0.5 * (1.2 * t).cos();
        (
            vec![x[1], x[0] - x[0].powi(3) - 0.3 * x[1] + force],
            vec![v[1], (1.0 - 3.0 * x[0] * x[0]) * v[0] - 0.3 * v[1]],
        )
    },
    at: &[(1, 1), (0, 1)],
};
const PENDULUM: Case = Case {
    text: "xdot = v; vdot = -sin(x);",
    field: |_, x, v| (vec![x[1], -x[0].sin()], vec![v[1], -x[0].cos() * v[0]]),
    at: &[(1, 1), (1, 2)],
};
const DAMPED: Case = Case {
    text: "xdot = v; vdot = -sin(x) - v/10;",
    field: |_, x, v| (vec![x[1], -x[0].sin() - 0.1 * x[1]], vec![v[1], -x[0].cos() * v[0] - 0.1 * v[1]]),
    at: &[(1, 1), (1, 2)],
};
/// The Hénon–Heiles potential plus x⁴/4.
const QUARTIC: Case = Case {
    text: "xdot = p; ydot = q; pdot = -x - 2*x*y - x^3; qdot = -y - x^2 + y^2;",
    field: |_, x, v| {
        (
            vec![x[2], x[3], -x[0] - 2.0 * x[0] * x[1] - x[0].powi(3), -x[1] - x[0] * x[0] + x[1] * x[1]],
            vec![
                v[2],
                v[3],
                -(1.0 + 2.0 * x[1] + 3.0 * x[0] * x[0]) * v[0] - 2.0 * x[0] * v[1],
                -2.0 * x[0] * v[0] - (1.0 - 2.0 * x[1]) * v[1],
            ],
        )
    },
    at: &[(0, 1), (-3, 20), (13, 25), (0, 1)],
};
/// A relaxation oscillation; one exponent is 0, the other is negative.
const FITZHUGH_NAGUMO: Case = Case {
    text: "vdot = v - v^3/3 - w + 1/2; wdot = (v + 0.7 - 0.8*w)*0.08;",
    field: |_, x, e| {
        (
            vec![x[0] - x[0].powi(3) / 3.0 - x[1] + 0.5, (x[0] + 0.7 - 0.8 * x[1]) * 0.08],
            vec![(1.0 - x[0] * x[0]) * e[0] - e[1], (e[0] - 0.8 * e[1]) * 0.08],
        )
    },
    at: &[(1, 1), (1, 2)],
};

/// Computes exponents by the classical Runge–Kutta method, in descending order.
fn reference(case: &Case, step: f64, steps: usize) -> Vec<f64> {
    let n = case.at.len();
    let mut all = vec![0.0; n * (n + 1)];
    for (i, (above, below)) in case.at.iter().enumerate() {
        all[i] = *above as f64 / *below as f64;
        all[n + i * n + i] = 1.0;
    }
    let slope = |t: f64, all: &[f64]| {
        let (x, vectors) = all.split_at(n);
        let (of_point, _) = (case.field)(t, x, &vectors[..n]);
        let of_vectors = vectors.chunks(n).flat_map(|v| (case.field)(t, x, v).1);
        of_point.into_iter().chain(of_vectors).collect::<Vec<f64>>()
    };
    let moved = |all: &[f64], slope: &[f64], by: f64| -> Vec<f64> {
        all.iter().zip(slope).map(|(x, slope)| x + by * slope).collect()
    };
    let mut logs = vec![0.0; n];
    for k in 0..steps {
        let t = k as f64 * step;
        let one = slope(t, &all);
        let two = slope(t + step / 2.0, &moved(&all, &one, step / 2.0));
        let three = slope(t + step / 2.0, &moved(&all, &two, step / 2.0));
        let four = slope(t + step, &moved(&all, &three, step));
        for (i, x) in all.iter_mut().enumerate() {
            *x += step / 6.0 * (one[i] + 2.0 * two[i] + 2.0 * three[i] + four[i]);
        }
        let mut vectors: Vec<Vec<f64>> = all[n..].chunks(n).map(<[f64]>::to_vec).collect();
        for (i, log) in logs.iter_mut().enumerate() {
            let (before, rest) = vectors.split_at_mut(i);
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            for axis in before {
                let part = dot(&rest[0], axis);
                rest[0].iter_mut().zip(axis).for_each(|(entry, axis)| *entry -= part * *axis);
            }
            let length = dot(&rest[0], &rest[0]).sqrt();
            *log += length.ln();
            rest[0].iter_mut().for_each(|entry| *entry /= length);
        }
        all.truncate(n);
        all.extend(vectors.concat());
    }
    let mut rates: Vec<f64> = logs.iter().map(|log| log / (steps as f64 * step)).collect();
    rates.sort_by(|one, other| other.total_cmp(one));
    rates
}

fn study(case: &Case, which: Option<LiftCriterion>) -> Study {
    let subject = Subject::text(case.text);
    let subject = which.map_or(subject.clone(), |which| subject.lifted(which));
    subject.study(&Systems).expect("a field")
}

fn observed(case: &Case, which: Option<LiftCriterion>, (above, below): (i64, i64), steps: u64) -> Observed {
    let at = case.at.iter().map(|(above, below)| Rational::new(*above, *below)).collect();
    let asked = Observe::new(Rational::new(above, below), at, steps);
    asked.ask(&study(case, which), &Unwatched).expect("an orbit")
}

fn spectrum(observed: &Observed) -> Vec<f64> {
    match observed.of(Observable::Spectrum) {
        Some(ObservedValue::Spectrum(all)) => all.iter().map(|one| one.value).collect(),
        other => panic!("{other:?}"),
    }
}

fn number(observed: &Observed, of: Observable) -> f64 {
    match observed.of(of) {
        Some(ObservedValue::Number(number)) => *number,
        Some(ObservedValue::Exponent(exponent)) => exponent.value,
        other => panic!("{other:?}"),
    }
}

/// Asserts that exponents differ by less than `near` from the reference, and sum to `divergence`.
fn are_those_of_the_equations(case: &Case, steps: u64, near: f64, divergence: f64) {
    let found = observed(case, Some(LiftCriterion::Automatic), (1, 20), steps);
    let (own, wanted) = (spectrum(&found), reference(case, 0.02, steps as usize * 5));
    assert_eq!(own.len(), wanted.len(), "{}", case.text);
    for (own, wanted) in own.iter().zip(&wanted) {
        assert!((own - wanted).abs() < near, "{}: {own} {wanted}", case.text);
    }
    let largest = number(&found, Observable::Lyapunov);
    assert!((largest - own[0]).abs() < near, "{}: {largest} {own:?}", case.text);
    let volumes = number(&found, Observable::LogDet);
    for sum in [own.iter().sum(), volumes, wanted.iter().sum()] {
        assert!((sum - divergence).abs() < 1e-3, "{}: {sum} {divergence}", case.text);
    }
}

#[test]
fn exponents_of_chaotic_motion() {
    // A chaotic orbit and the reference orbit separate, so their means differ slightly.
    are_those_of_the_equations(&DRIVEN, 20_000, 0.015, -0.3);
    are_those_of_the_equations(&QUARTIC, 20_000, 0.015, 0.0);
}

#[test]
fn exponents_of_motion_that_is_attracted() {
    are_those_of_the_equations(&DAMPED, 20_000, 1e-3, -0.1);
    let steps = 20_000;
    let found = observed(&FITZHUGH_NAGUMO, Some(LiftCriterion::Automatic), (1, 50), steps);
    let wanted = reference(&FITZHUGH_NAGUMO, 0.02, steps as usize * 2);
    for (own, wanted) in spectrum(&found).iter().zip(&wanted) {
        assert!((own - wanted).abs() < 4e-3 * (1.0 + wanted.abs()), "{own} {wanted}");
    }
}

#[test]
fn indicators_of_regular_motion_are_small() {
    let found = observed(&PENDULUM, Some(LiftCriterion::Automatic), (1, 40), 200_000);
    assert!(number(&found, Observable::Fli) < 9.0, "{}", number(&found, Observable::Fli));
    let megno = number(&found, Observable::Megno);
    assert!((megno - 2.0).abs() < 0.1, "{megno}");
    let spectrum = spectrum(&found);
    assert!(spectrum.len() == 2 && spectrum.iter().all(|one| one.abs() < 2e-3), "{spectrum:?}");
    assert_eq!(study(&PENDULUM, Some(LiftCriterion::Automatic)).variables().len(), 4);
}

#[test]
fn cells_have_the_exponents_of_single_orbits() {
    let single = observed(&DAMPED, Some(LiftCriterion::Automatic), (1, 20), 500);
    let at = DAMPED.at.iter().map(|(above, below)| Rational::new(*above, *below)).collect();
    let asked = Observe::new(Rational::new(1, 20), at, 500);
    let axis = kahan_study::AxisOver::from(kahan_study::Axis {
        name: "x".to_owned(),
        range: Range::read("1:2:9").expect("a range"),
    });
    let over = kahan_study::Over::new(Question::Observe(asked), vec![axis]);
    let found = over.ask(&study(&DAMPED, Some(LiftCriterion::Automatic)), &Unwatched).expect("cells");
    let cell = |name: &str| {
        let column = found.columns.iter().position(|column| column == name)?;
        Some(found.rows.values[column].values().cell(0).to_string())
    };
    let spectrum = spectrum(&single);
    assert_eq!(cell("spectrum_1"), Some(spectrum[0].to_string()));
    assert_eq!(cell("spectrum_2"), Some(spectrum[1].to_string()));
    assert_eq!(cell("spectrum_3"), None);
    assert_eq!(cell("fli"), Some(number(&single, Observable::Fli).to_string()));
}

#[test]
fn a_quadratic_field_is_observed_as_it_was() {
    const LOTKA_VOLTERRA: Case = Case {
        text: "xdot = x*(1 - y); ydot = y*(x - 1);",
        field: |_, _, _| unreachable!("no reference is asked for"),
        at: &[(3, 2), (1, 1)],
    };
    let [plain, lifted] =
        [None, Some(LiftCriterion::Automatic)].map(|which| observed(&LOTKA_VOLTERRA, which, (1, 20), 1000));
    assert_eq!(plain.seen, lifted.seen);
}
