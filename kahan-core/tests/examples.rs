//! Runs the example programs, and checks the statements in their module heads.

// The tests call `run`, which returns the printed numbers. Only cargo calls `main`.
#![allow(dead_code)]

#[path = "../examples/any_map.rs"]
mod any_map;
#[path = "../examples/ensemble.rs"]
mod ensemble;
#[path = "../examples/exact.rs"]
mod exact;
#[path = "../examples/near_pole.rs"]
mod near_pole;
#[path = "../examples/orbit.rs"]
mod orbit;
#[path = "../examples/own_scalar/main.rs"]
mod own_scalar;
#[path = "../../crates/kahan-dynamics/examples/trade.rs"]
mod trade;

#[test]
fn an_orbit_keeps_its_integrals_to_roundings() {
    // Each of ten thousand steps rounds an integral near 1 a few times.
    let change = orbit::run();
    assert!(change < 1e-12, "{change:e}");
}

#[test]
fn digits_grow_like_a_square_where_integrals_are_kept_and_double_elsewhere() {
    let [confined, free] = exact::run();
    // From step 6 to 12, digits grow by (12/6)² = 4 (E6) or, by doubling, 2⁶ (Lotka–Volterra).
    let growth = |digits: &[usize]| digits[11] as f64 / digits[5] as f64;
    assert!((3.0..5.0).contains(&growth(&confined)), "{confined:?}");
    assert!((50.0..80.0).contains(&growth(&free)), "{free:?}");
}

#[test]
fn springs_lose_their_common_phase_and_keep_their_energies() {
    let (mean, change) = ensemble::run();
    // The mean velocity starts at 0.3, and has fallen below a fifth of this.
    assert!(mean.abs() < 0.06, "{mean}");
    assert!(change < 1e-12, "{change:e}");
}

#[test]
fn a_checked_step_beside_a_pole_is_right_where_the_fast_one_is_infinite() {
    let answers = near_pole::run();
    let [.., beside, behind, pole] = answers.as_slice() else { panic!("six cases") };
    assert!(beside.0.is_infinite());
    // The float 0.1 exceeds one tenth, so the denominator 1 − 2ε·5 is −2⁻⁵⁴ and not 0.
    let exact = -5.0 * 2.0_f64.powi(54);
    let is_near = |a: f64, b: f64| (a - b).abs() <= 64.0 * f64::EPSILON * b.abs();
    assert!(beside.1.as_ref().is_ok_and(|next| is_near(*next, exact)));
    assert!(behind.1.as_ref().is_ok_and(|next| is_near(behind.0, *next)));
    assert!(pole.1.is_err());
}

#[test]
fn an_orbit_through_complex_time_comes_out_behind_the_pole() {
    let [end, expected] = own_scalar::run();
    assert!((end - expected).norm_sqr() < 1e-8, "{end}");
}

#[test]
fn a_smaller_tolerance_is_kept_by_a_higher_order() {
    let choices = trade::run();
    assert!(choices.is_sorted_by_key(|(_, order, _)| *order));
    assert_eq!(choices.last().map(|(_, order, _)| *order), Some(8));
    for (tolerance, _, change) in choices {
        assert!(change < tolerance, "{change:e} at {tolerance:e}");
    }
}

#[test]
fn one_function_tells_when_any_map_crosses_zero() {
    let [by_type, plain, of_order_eight, of_chain] = any_map::run();
    let quarter = std::f64::consts::FRAC_PI_2;
    // A plain step turns by 2 arctan ε instead of 2ε, a relative error of ε²/3. Here ε² is 10⁻⁴.
    assert!(by_type == plain && (plain / quarter - 1.0).abs() < 1e-4);
    assert!((of_order_eight / quarter - 1.0).abs() < 1e-13);
    assert!((of_chain - plain).abs() < 1e-13);
}
