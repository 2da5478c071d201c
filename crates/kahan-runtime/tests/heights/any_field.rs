//! Tests of heights for any field: comparison with rational arithmetic, growth, poles and bounds.

use std::cell::Cell;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::kahan::RationalMap;
use kahan_algebra::rational::Rational;
use kahan_runtime::heights::{DiophantineTest, Growth, Heights, HeightsOrbit, Stop};

use crate::support::{catalog, field, number, numbers, orbit};

fn lotka_volterra() -> HeightsOrbit {
    orbit(&catalog("lv"), "", "9/14", "1/2,5/3")
}

/// Computes log max(|p|, |q|) from decimal digits, independently of the library.
fn height(value: &Rational) -> f64 {
    let text = value.to_string();
    let parts = text.trim_start_matches('-').split('/');
    let logarithm = |digits: &str| {
        let lead: f64 = digits[..digits.len().min(17)].parse().expect("digits");
        lead.ln() + (digits.len() - digits.len().min(17)) as f64 * std::f64::consts::LN_10
    };
    parts.map(|digits| if digits == "0" { 0.0 } else { logarithm(digits) }).fold(0.0, f64::max)
}

fn digits(value: &Rational) -> u64 {
    value.to_string().trim_start_matches('-').split('/').map(|part| part.len() as u64).max().unwrap_or(0)
}

/// Compares an orbit with the interpreter, which computes with reduced fractions.
fn agrees_with_fractions(text: &str, parameters: &str, eps: &str, start: &str, steps: usize) {
    let system = field(text);
    let interpreter = Interpreter::new(&system);
    let mut heights = orbit(&system, parameters, eps, start);
    let mut point = Point { state: numbers(start), parameters: numbers(parameters), eps: number(eps) };
    for step in 0..=steps {
        let found: Heights = heights.next().unwrap_or_else(|| panic!("{text} stopped at {step}"));
        assert_eq!(heights.point(), point.state, "{text}, step {step}");
        assert_eq!(found.step, step);
        for (i, value) in point.state.iter().enumerate() {
            let (found, wanted) = (found.logarithms[i], height(value));
            assert!((found - wanted).abs() <= 4e-15 * wanted, "{text}: h({value}) = {found}, not {wanted}");
        }
        assert_eq!(found.digits, point.state.iter().map(digits).collect::<Vec<_>>(), "{text}, step {step}");
        if step < steps {
            point.state = interpreter.next(&Exact, &point).expect("no pole");
        }
    }
}

#[test]
fn orbits_are_those_of_rational_arithmetic() {
    agrees_with_fractions("xdot = x^2 + 1;", "", "1/3", "2/7", 8);
    agrees_with_fractions("xdot = a*x - x^2;", "0.75", "0.1", "-1.5", 8);
    agrees_with_fractions("xdot = y; ydot = 6*x^2 - a;", "0.5", "-1/3", "0,1", 7);
    agrees_with_fractions(
        "xdot = s*(y - x); ydot = r*x - y - x*z; zdot = x*y - b*z;",
        "10,28,8/3",
        "1e-2",
        "1,0,-1/2",
        5,
    );
    agrees_with_fractions("xdot = x*y/k + 1/3; ydot = -y^2 + 0.1;", "-7/2", "5/4", "1e3,-0.001", 6);
    agrees_with_fractions("xdot = -x*z; ydot = y*z; zdot = x^2 - y^2;", "", "-3/5", "7/3,11/13,23/47", 24);
    agrees_with_fractions(
        "xdot = -x^2; ydot = -2/3*x*y; zdot = 4/3*y^2 + x*z;",
        "",
        "1/2",
        "3/7,11/13,23/47",
        120,
    );
    // At ε = 0 all points are fixed.
    agrees_with_fractions("xdot = x^2; ydot = x*y;", "", "0", "2/3,5", 4);
}

#[test]
fn a_field_without_a_reduced_map_is_solved_exactly() {
    let equation = |i: usize| {
        let products: Vec<String> =
            (1..=6).map(|j| format!("{}*x{j}*x{}", (i * j) % 5 + 1, (i + 2 * j) % 6 + 1)).collect();
        format!("x{i}dot = {} - x{}/3 + {i};", products.join(" - "), i % 6 + 1)
    };
    let text: String = (1..=6).map(equation).collect();
    assert!(RationalMap::of(&field(&text).field).is_none(), "the field is meant to be beyond the budget");
    agrees_with_fractions(&text, "", "1/7", "1,1/2,-1/3,2,0,-5/4", 2);
}

#[test]
fn linear_fields_grow_linearly_and_what_repeats_is_bounded() {
    let growth = |text: &str, parameters: &str, eps: &str, start: &str, steps: u64| {
        let survey = DiophantineTest::of(&mut orbit(&field(text), parameters, eps, start), steps);
        assert_eq!(survey.heights.len() as u64, steps + 1, "{text}");
        survey.growth
    };
    assert_eq!(growth("xdot = a*x;", "1", "1/5", "3/7", 60), Growth::Linear);
    assert_eq!(growth("xdot = y; ydot = -x;", "", "1/5", "3/7,2", 60), Growth::Linear);
    assert_eq!(growth("xdot = y; ydot = -x + 1/2; zdot = x - z;", "", "1/5", "3/7,2,0", 60), Growth::Linear);
    // For a constant field, x grows like n, and the height of x like log n.
    assert_eq!(growth("xdot = 2/3;", "", "1/2", "0", 200), Growth::Logarithmic);
    assert_eq!(growth("xdot = x - x*y; ydot = -y + x*y;", "", "1/3", "1,1", 20), Growth::Bounded);
    // At ε = 1 the rotation is by a right angle, so orbits have period 4.
    assert_eq!(growth("xdot = y; ydot = -x;", "", "1", "3/7,2", 30), Growth::Bounded);
    assert_eq!(growth("xdot = x - x*y; ydot = -y + x*y;", "", "1/3", "1/2,5/3", 7), Growth::Exponential);
    assert_eq!(growth("xdot = x - x*y; ydot = -y + x*y;", "", "1/3", "1/2,5/3", 11), Growth::Exponential);
    assert_eq!(growth("xdot = x - x*y; ydot = -y + x*y;", "", "1/3", "1/2,5/3", 3), Growth::Undecided);
}

#[test]
fn sequences_are_classified_by_their_differences() {
    let of = |steps: i32, h: &dyn Fn(f64) -> f64| {
        Growth::of(&(1..=steps).map(|n| h(f64::from(n))).collect::<Vec<_>>())
    };
    for steps in [8, 11, 17, 30, 125, 1000] {
        assert_eq!(of(steps, &|n| 3.0 * n + 40.0), Growth::Linear, "{steps}");
        assert_eq!(of(steps, &|n| 2.0 * n * n + 5.0 * n + 9.0), Growth::Quadratic, "{steps}");
        let logarithmic = if steps < 16 { Growth::Undecided } else { Growth::Logarithmic };
        assert_eq!(of(steps, &|n| 2.0 * n.ln() + 1.0), logarithmic, "{steps}");
        assert_eq!(of(steps, &|_| 7.0), Growth::Bounded, "{steps}");
        assert_eq!(of(steps, &|n| n % 3.0), Growth::Bounded, "{steps}");
        assert_eq!(of(steps, &|n| n * n * n), Growth::Undecided, "{steps}");
    }
    for steps in [5, 8, 11, 17, 30] {
        assert_eq!(of(steps, &|n| 2.0_f64.powf(n)), Growth::Exponential, "{steps}");
        assert_eq!(of(steps, &|n| 5.0 * 3.0_f64.powf(n)), Growth::Exponential, "{steps}");
    }
    assert_eq!(Growth::of(&[]), Growth::Undecided);
    assert_eq!(Growth::of(&[0.0, 0.0, 0.0]), Growth::Undecided);
    assert_eq!(Growth::of(&[0.0; 4]), Growth::Bounded);
}

#[test]
fn an_orbit_ends_at_a_pole_and_says_so() {
    // With x̃ = x/(1 − 2εx), 1/x falls by two in each step, and 1/2 is a pole.
    let mut orbit = orbit(&field("xdot = x^2;"), "", "1", "1/6");
    let heights: Vec<Heights> = orbit.by_ref().take(9).collect();
    assert_eq!(heights.len(), 3);
    assert_eq!(orbit.point(), vec![Rational::new(1, 2)]);
    assert_eq!(orbit.stopped(), Some(Stop::Pole));
    assert_eq!(orbit.next(), None);
    // In the catalog's system E1, det A vanishes at 1 + εx = 0, but the reduced map is defined.
    let mut removable = self::orbit(&catalog("e1"), "", "1/2", "-2,1,1/3");
    assert!(removable.nth(1).is_some());
}

#[test]
fn bounds_end_an_orbit_and_keep_what_is_known() {
    let within_digits = |max_digits: u64| {
        let mut orbit = lotka_volterra().within_digits(max_digits);
        let survey = DiophantineTest::of(&mut orbit, u64::MAX);
        assert_eq!((survey.stopped, orbit.stopped()), (Some(Stop::Digits), Some(Stop::Digits)));
        survey
    };
    let by_digits = within_digits(5000);
    assert_eq!(by_digits.heights.len(), 11, "5077 digits come at n = 11");
    assert!(by_digits.heights.iter().all(|heights| heights.longest() <= 5000));
    assert_eq!(by_digits.growth, Growth::Exponential);
    assert_eq!(within_digits(1).heights.len(), 1);
}

/// Uses a clock that advances a second at each reading. The clock is read before and after each
/// step, so step n ends at 2n + 1 seconds.
#[test]
fn the_time_of_whoever_asks_ends_an_orbit_before_a_step_that_would_be_late() {
    let within = |seconds: f64| {
        let readings = Cell::new(0);
        let clock = || Some(Duration::from_secs(readings.replace(readings.get() + 1)));
        let mut orbit = lotka_volterra();
        let survey =
            DiophantineTest::within(&mut orbit, u64::MAX, seconds, &clock, |_| ControlFlow::Continue(()));
        assert_eq!((survey.stopped, orbit.stopped()), (Some(Stop::Seconds), None));
        survey.heights.len()
    };
    assert_eq!([0.0, 1.9, 2.0].map(within), [1, 1, 2]);
    assert_eq!([20.0, 22.0].map(within), [8, 9]);
}

#[test]
fn whoever_sees_the_heights_can_end_the_orbit() {
    let stop_at = |last: usize, steps: u64| {
        let each = |heights: &Heights| match heights.step == last {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let survey = DiophantineTest::within(&mut lotka_volterra(), steps, 0.0, &|| None, each);
        (survey.heights.len(), survey.stopped)
    };
    assert_eq!(stop_at(3, 9), (4, Some(Stop::Seconds)));
    assert_eq!(stop_at(9, 9), (10, None), "that was the last in any case");
}

#[test]
fn a_field_that_is_undefined_is_refused() {
    let system = field("xdot = x^2/k;");
    assert!(HeightsOrbit::new(&system, &[Rational::zero()], &Rational::one(), &[Rational::one()]).is_err());
}

/// If noise hides the growth, the class is `Undecided`.
#[test]
fn noisy_logarithms_are_never_called_linear() {
    let growth = |name: &str, eps: &str, start: &str, steps: u64| {
        DiophantineTest::of(&mut orbit(&catalog(name), "", eps, start), steps).growth
    };
    for steps in [20, 40, 80, 160, 400] {
        let found = growth("e1", "9/14", "35/12,-19/3,0", steps);
        assert!(matches!(found, Growth::Logarithmic | Growth::Undecided), "{steps}: {found}");
    }
    for (name, eps, start, steps) in
        [("e1", "-3/7", "13/24,47/43,4", 160), ("e2", "-1/3", "5/14,10/32,49/52", 60)]
    {
        let found = growth(name, eps, start, steps);
        assert!(matches!(found, Growth::Logarithmic | Growth::Undecided), "{name}: {found}");
    }
    let tall = "181717957208561472822061132748/3613401719033258215905741,-3";
    let survey = DiophantineTest::of(&mut orbit(&field("xdot = 1; ydot = -1;"), "", "4/5", tall), 500);
    assert_eq!(survey.growth, Growth::Logarithmic);
}
