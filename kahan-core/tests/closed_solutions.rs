//! Compares the flow with closed solutions, up to the limits of their domain.

use kahan_core::prelude::*;
use kahan_core::{FloatScalar, QuadraticField};
use kahan_dynamics::{Flow, NoFlow};

use super::systems::Burst;

kahan! {
    struct Logistic;
    xdot = x*(1 - x);
}

kahan! {
    /// A thrown body. Its solutions are polynomials of degree 2 in t.
    struct Thrown;
    xdot = v;
    vdot = -2;
}

kahan! {
    /// A case of the Euler top, in which x² + y² and x² + z² are constant.
    struct Top;
    xdot = y*z;
    ydot = -x*z;
    zdot = -x*y;
}

fn through<F, T, const N: usize>(field: &F, start: [f64; N], end: f64) -> Result<Flow<T>, NoFlow>
where
    F: QuadraticField<T, N>,
    T: FloatScalar + From<f64> + From<Dd> + Into<Dd>,
{
    Flow::through(field, SVector::from(start).map(T::from), end, 0.0, &mut |_| true)
}

/// The flow is stored as about forty polynomials in t, each with an error below one rounding unit.
/// The equation amplifies an error by at most 1/(4x₀(1 − x₀)), where x₀ = 0.1.
#[test]
fn the_logistic_solution_is_met_to_some_units_of_the_scalar() {
    let f64s = through::<_, f64, 1>(&Logistic, [0.1], 10.0).expect("it exists");
    let dds = through::<_, Dd, 1>(&Logistic, [0.1], 10.0).expect("it exists");
    for k in 0..=1000 {
        let t = f64::from(k) / 100.0;
        let (narrow, wide) = (f64s.at(t.into())[0], dds.at(t.into())[0]);
        // In the next line, `exp` and the four operations round by at most 3 units together.
        let exact = 0.1 / (0.1 + 0.9 * (-t).exp());
        assert!((f64::from(wide) - exact).abs() <= 3.0 * f64::EPSILON, "t = {t}");
        let apart = f64::from((Dd::from(narrow) - wide).abs());
        assert!(apart <= 40.0 / (4.0 * 0.1 * 0.9) * f64::EPSILON / 2.0, "t = {t}: {apart:e}");
    }
}

#[test]
fn the_integrals_of_the_top_are_kept_in_double_double() {
    let flow = through::<_, Dd, 3>(&Top, [0.5, 1.0, 0.75], 40.0).expect("it exists");
    let integrals = |x: &[Dd]| [x[0] * x[0] + x[1] * x[1], x[0] * x[0] + x[2] * x[2]];
    let begin = integrals(&flow.at(Dd::from(0.0)));
    let pieces = flow.breaks().len() as f64;
    let bound = 4.0 * pieces * f64::EPSILON * f64::EPSILON;
    for k in 1..=400 {
        let now = integrals(&flow.at(Dd::from(f64::from(k) / 10.0)));
        for (now, begin) in now.into_iter().zip(begin) {
            let drift = f64::from((now - begin).abs());
            assert!(drift <= bound, "t = {k}/10: {drift:e} beyond {bound:e}");
        }
    }
}

#[test]
fn pieces_follow_the_motion() {
    // The solution is slow until t = 23. Then it changes completely within a few units of time.
    let flow = through::<_, f64, 1>(&Logistic, [1e-10], 60.0).expect("it exists");
    assert_eq!(flow.breaks().next(), Some(0.0));
    let within = |low: f64, high: f64| flow.breaks().filter(|t| (low..high).contains(t)).count();
    assert!(within(20.0, 26.0) >= 6, "{:?}", flow.breaks().collect::<Vec<_>>());
    assert!((flow.scale() - 1.0).abs() < 1e-12);
    assert!((flow.slope() - 1.0).abs() < 1e-6, "|1 - 2x| is 1 at both ends");
}

kahan! {
    /// Robertson's kinetics. The field and the Jacobian at (1, 0, 0) show no fast time scale.
    struct Kinetics;
    xdot = -x/25 + 10000*y*z;
    ydot = x/25 - 10000*y*z - 30000000*y^2;
    zdot = 30000000*y^2;
}

kahan! {
    /// From n = 0, s falls by a factor of more than 10¹³ while n < 1, and then grows.
    struct Laser;
    ndot = 2 - n - n*s;
    sdot = 100*s*(n - 1);
}

/// The sum x + y + z is always 1.
#[test]
fn a_stiff_beginning_is_seen() {
    let flow = through::<_, Dd, 3>(&Kinetics, [1.0, 0.0, 0.0], 1.0).expect("it exists");
    assert!(flow.breaks().nth(1) < Some(1e-4), "{:?}", flow.breaks().take(3).collect::<Vec<_>>());
    for k in 1..=100 {
        let x = flow.at(Dd::from(f64::from(k) / 100.0));
        assert!(f64::from((x[0] + x[1] + x[2] - Dd::from(1.0)).abs()) < 1e-25);
        assert!((3.0e-5..4.0e-5).contains(&f64::from(x[1])), "{:?}", x[1]);
    }
}

/// While s is small, ṅ = 2 − n and n = 2 − 2e^{−t}. Then s = s₀ exp(100(t − 2 + 2e^{−t})).
#[test]
fn a_component_that_is_small_keeps_its_digits() {
    let flow = through::<_, f64, 2>(&Laser, [0.0, 1e-9], 1.5).expect("it exists");
    for k in 1..=15 {
        let t = f64::from(k) / 10.0;
        let exact = 1e-9 * (100.0 * (t - 2.0 + 2.0 * (-t).exp())).exp();
        let s = flow.at(t.into())[1];
        // The neglected ∫ns dt < 1e-12 changes n. The exponent of s changes by 100 times as much.
        assert!((s / exact - 1.0).abs() < 1e-10, "t = {t}: {s:e} for {exact:e}");
    }
}

#[test]
fn an_escape_is_told_with_its_time() {
    let escape = through::<_, f64, 1>(&Burst, [0.5], 3.0).expect_err("1/(2 - t) has no value at t = 2");
    let NoFlow::Escapes { time } = escape else { panic!("{escape}") };
    assert!((time - 2.0).abs() < 1e-6, "{time}");
    assert!(through::<_, f64, 1>(&Burst, [0.5], 1.999).is_ok());
}

#[test]
fn a_caller_may_stop_it() {
    let mut asked = 0;
    let stopped = Flow::<f64>::through(&Logistic, vector![0.1], 1e9, 0.0, &mut |pieces| {
        asked += 1;
        assert_eq!(pieces + 1, asked);
        pieces < 5
    });
    let Err(NoFlow::Stopped { reached }) = stopped else { panic!("five pieces do not reach 1e9") };
    assert!(reached > 0.1 && reached < 100.0, "{reached}");
}

#[test]
fn polynomials_and_rest_are_exact() {
    let thrown = through::<_, f64, 2>(&Thrown, [0.0, 4.0], 3.0).expect("it exists");
    assert_eq!(thrown.at(Dd::from(2.5)), [3.75, -1.0]);
    let rest = through::<_, f64, 1>(&Logistic, [1.0], 1e6).expect("it exists");
    assert_eq!(rest.at(Dd::from(12_345.0)), [1.0]);
    assert_eq!(rest.distance(Dd::from(5.0), &[Dd::from(1.5)]), 0.5);
    assert_eq!(rest.distance(Dd::from(5.0), &[Dd::from(f64::NAN)]), f64::INFINITY);
}
