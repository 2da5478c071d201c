//! Measures how rounding changes an integral of the map over long orbits. Long runs are ignored by
//! default. `cargo test --release -p kahan-tests compensated -- --ignored --nocapture` takes
//! minutes and prints the figures.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::prelude::*;
use kahan_core::{Dd, nearest_short_eps};
use kahan_systems::{E6, EulerTop};

const ORBITS: u64 = 16;

fn starts() -> impl Iterator<Item = SVector<f64, 3>> {
    (0..ORBITS).map(|seed| {
        let mut draws = SplitMix64::new(900 + seed);
        SVector::from_fn(|_, _| draws.below((1 << 24) + 1) as f64 / f64::from(1 << 23) - 1.0)
    })
}

/// The root mean square and the mean, over all orbits, of an integral's change after `steps` steps.
#[derive(Debug)]
struct Drift {
    steps: u64,
    rms: f64,
    mean: f64,
}

/// Measures changes of the integral relative to its initial value, or to 1/4 if that is larger.
fn drift(
    milestones: &[u64],
    integral: impl Fn(&SVector<f64, 3>) -> Dd,
    orbit: impl Fn(SVector<f64, 3>) -> Box<dyn Iterator<Item = SVector<f64, 3>>>,
) -> Vec<Drift> {
    let mut rows: Vec<Drift> = milestones.iter().map(|&steps| Drift { steps, rms: 0.0, mean: 0.0 }).collect();
    for start in starts() {
        let mut orbit = orbit(start);
        let first = integral(&orbit.next().expect("x0"));
        let scale = f64::from(first).abs().max(0.25);
        let mut done = 0;
        for row in &mut rows {
            let x = orbit.nth((row.steps - done - 1) as usize).expect("a float orbit goes on");
            done = row.steps;
            let error = f64::from(integral(&x) - first) / scale;
            assert!(error.is_finite());
            row.rms += error * error / ORBITS as f64;
            row.mean += error / ORBITS as f64;
        }
    }
    for row in &mut rows {
        row.rms = row.rms.sqrt();
    }
    rows
}

fn print(name: &str, rows: &[Drift]) {
    for Drift { steps, rms, mean } in rows {
        println!("{name:<24} {steps:>10e} steps  rms {rms:.2e}  mean {mean:+.2e}");
    }
}

fn slope(rows: &[Drift]) -> f64 {
    let points: Vec<_> = rows.iter().map(|row| ((row.steps as f64).ln(), row.rms.ln())).collect();
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let rise: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    rise / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

fn e6_integral(eps: f64) -> impl Fn(&SVector<f64, 3>) -> Dd {
    move |x| E6.integrals(&x.map(Dd::from), Dd::from(eps))[0]
}

const E6_EPS: f64 = 1.0 / 1024.0;

/// On a plain orbit, the rounding errors of the coordinates add up like a random walk. On a
/// compensated orbit only the final rounding remains, and the change is at most 10·2⁻⁵³.
#[test]
fn a_compensated_orbit_keeps_its_integral_to_the_rounding_of_its_last_point() {
    let milestones = [100_000];
    let plain = drift(&milestones, e6_integral(E6_EPS), |x| Box::new(E6.orbit(x, E6_EPS)));
    let compensated =
        drift(&milestones, e6_integral(E6_EPS), |x| Box::new(E6.orbit(x, E6_EPS).compensated()));
    print("plain", &plain);
    print("compensated", &compensated);
    assert!(compensated[0].rms <= 10.0 * f64::EPSILON / 2.0, "{compensated:?}");
    assert!(plain[0].rms >= 20.0 * compensated[0].rms, "{plain:?} {compensated:?}");
}

const LONG: [u64; 4] = [100_000, 1_000_000, 10_000_000, 100_000_000];

#[test]
#[ignore = "3·10⁹ steps: minutes, in a release build"]
fn the_integral_of_e6_wanders_and_does_not_drift() {
    let plain = drift(&LONG, e6_integral(E6_EPS), |x| Box::new(E6.orbit(x, E6_EPS)));
    let compensated = drift(&LONG, e6_integral(E6_EPS), |x| Box::new(E6.orbit(x, E6_EPS).compensated()));
    print("E6 2^-10, plain", &plain);
    print("E6 2^-10, compensated", &compensated);
    println!("slope of log rms: plain {:.3}", slope(&plain));
    assert!(plain[3].rms <= 2e-12 && compensated[3].rms <= 5e-15);
    assert!((0.35..=0.65).contains(&slope(&plain)));
    assert!(plain.iter().all(|row| row.mean.abs() < 0.8 * row.rms), "{plain:?}");
}

const TOP: [f64; 3] = [1.0, -2.0, 1.5];

fn top<T: Scalar>(convert: impl Fn(f64) -> T) -> EulerTop<T> {
    let [a1, a2, a3] = TOP.map(convert);
    EulerTop { a1, a2, a3 }
}

/// Returns the Euler top's integral (α₃y² − α₂z²)/(1 − ε²α₁α₂z²) with the parameters αᵢ.
fn top_integral(eps: f64) -> impl Fn(&SVector<f64, 3>) -> Dd {
    move |x| {
        let EulerTop { a1, a2, a3 } = top(Dd::from);
        let [y, z] = [1, 2].map(|i| Dd::from(x[i]));
        let eps = Dd::from(eps);
        (a3 * y * y - a2 * z * z) / (Dd::from(1.0) - eps * eps * a1 * a2 * z * z)
    }
}

#[test]
#[ignore = "5·10⁹ steps: minutes, in a release build"]
fn the_remedies_for_a_badly_rounded_eps_give_the_same_law() {
    let (bad, short) = (0.05, nearest_short_eps(0.05));
    let as_it_is = drift(&LONG, top_integral(bad), |x| Box::new(top(f64::from).orbit(x, bad).compensated()));
    let shortened =
        drift(&LONG, top_integral(short), |x| Box::new(top(f64::from).orbit(x, short).compensated()));
    let shortened_plain = drift(&LONG, top_integral(short), |x| Box::new(top(f64::from).orbit(x, short)));
    // If x is an orbit with ε = `bad`, then εx is an orbit with ε = 1. The integral of εx is ε²
    // times as large, so it is divided by ε².
    let of_scaled = |x: &SVector<f64, 3>| top_integral(1.0)(x) / (Dd::from(bad) * Dd::from(bad));
    let scaled = drift(&LONG, of_scaled, |x| {
        let scaled = top(f64::from).orbit(x, bad).scaled().expect("a homogeneous field");
        Box::new(scaled.compensated().into_inner())
    });
    print("Euler 0.05, compensated", &as_it_is);
    print("Euler short, compensated", &shortened);
    print("Euler short, plain", &shortened_plain);
    print("Euler 0.05, scaled", &scaled);
    let slopes = [&as_it_is, &shortened, &shortened_plain, &scaled].map(|rows| slope(rows));
    println!("slopes of log rms, in this order: {slopes:.3?}");
    assert!(slope(&as_it_is) > 0.8, "the case that needs a remedy");
    assert!(shortened_plain[3].rms <= 2e-12);
    for rows in [&shortened_plain, &shortened, &scaled] {
        assert!((0.35..=0.65).contains(&slope(rows)), "{rows:?}");
        assert!(rows.iter().all(|row| row.mean.abs() < 0.8 * row.rms), "{rows:?}");
        assert!(10.0 * rows[3].rms < as_it_is[3].rms, "{rows:?}");
    }
}
