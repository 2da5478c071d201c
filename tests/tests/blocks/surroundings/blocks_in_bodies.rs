//! Blocks inside functions, as items and as values that capture variables of the function.

use kahan_core::prelude::*;

use crate::blocks::surroundings::{assert_kahan, ratio};

#[test]
fn a_function_body_may_define_a_system() {
    kahan! {
        struct Local { k }
        xdot = -k*x^2 + y;
        ydot = x;
    }
    assert_kahan(&Local { k: ratio(5, 3) });
}

#[test]
fn a_value_captures_any_scalar() {
    let mu = ratio(1, 3);
    let exact = kahan! { xdot = mu*x*y; ydot = x - y/(1 + mu); };
    let (x, next) = assert_kahan(&exact);
    assert_eq!(mu, ratio(1, 3), "the parameter is cloned, not moved");

    let mu = 1.0_f64 / 3.0;
    let double = kahan! { xdot = mu*x*y; ydot = x - y/(1 + mu); };
    let mu = 1.0_f32 / 3.0;
    let single = kahan! { xdot = mu*x*y; ydot = x - y/(1 + mu); };
    let there = double.step(&vector![0.4, 1.0], 2.0 / 7.0);
    let near = single.step(&vector![0.4, 1.0], 2.0 / 7.0);
    assert_eq!(x, vector![ratio(2, 5), ratio(1, 1)]);
    for (i, image) in next.iter().enumerate() {
        let (p, q) = (image.numer().to_string(), image.denom().to_string());
        let image = p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap();
        assert!((there[i] - image).abs() < 1e-14 && (f64::from(near[i]) - image).abs() < 1e-5);
    }
}

#[test]
fn a_value_captures_what_its_scope_means_by_a_name() {
    let k = 2.0_f64;
    let steps: Vec<f64> =
        [k, 3.0, 5.0].into_iter().map(|k| kahan! { xdot = k*x; }.step(&vector![1.0], 0.125)[0]).collect();
    // The exact step is x̃ = (1 + εk)/(1 − εk) x.
    for (step, k) in steps.iter().zip([2.0, 3.0, 5.0]) {
        assert!((step - (1.0 + 0.125 * k) / (1.0 - 0.125 * k)).abs() < 1e-15);
    }
}

#[test]
fn two_values_of_one_scope_are_two_systems() {
    let (field, other, x) = (2.0_f64, 3.0_f64, vector![1.0, 1.0]);
    let first = kahan! { xdot = field*y; ydot = -x; };
    let second = kahan! { xdot = other*y; ydot = -x; };
    assert_ne!(first.step(&x, 0.1), second.step(&x, 0.1));
    assert_eq!(first.parameters(), ["field"]);
    assert_eq!(second.parameters(), ["other"]);
}
