//! The choice of `kahan trade` against every setting there is, on scenes of its own, timed side by side.
//!
//! It measures times, so it is not part of `cargo test`: run it on a quiet machine, with
//! `cargo test --release -p kahan-systems --test trade_sweep -- --ignored --nocapture`.

use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use kahan_algebra::rational::Rational;
use kahan_core::prelude::*;
use kahan_core::{Composition, Dd, FloatScalar, Lift, ThroughF64, nearest_short_eps};
use kahan_systems::interpreted::constant;
use kahan_systems::reference::{Reference, Trajectory};
use serde_json::Value;

kahan! {
    /// Two oscillators, coupled.
    struct Henon;
    qdot = p;
    pdot = -q - 2*q*r;
    rdot = s;
    sdot = -r - q^2 + r^2;
}
const HENON: &str = "qdot = p; pdot = -q - 2*q*r; rdot = s; sdot = -r - q^2 + r^2;";

kahan! {
    /// A gyrostat: a top with a wheel inside.
    struct Gyrostat;
    xdot = y*z - z/3;
    ydot = -2*z*x + z/5;
    zdot = x*y + x/3 - y/5;
}
const GYROSTAT: &str = "xdot = y*z - z/3; ydot = -2*z*x + z/5; zdot = x*y + x/3 - y/5;";

kahan! {
    /// Predators that get tired.
    struct Tired;
    xdot = x*(1 - y) - x^2/10;
    ydot = y*(x - 1/2);
}
const TIRED: &str = "xdot = x*(1 - y) - x^2/10; ydot = y*(x - 1/2);";

#[derive(Clone, Copy, Debug)]
struct Setting {
    scalar: &'static str,
    order: u32,
    compensated: bool,
    eps: f64,
}

fn to<T: Scalar>(value: &BigRational) -> T {
    T::constant(&constant(&value.clone().into()))
}

/// One scene, compiled.
struct Scene<M, const N: usize> {
    map: M,
    start: SVector<BigRational, N>,
    horizon: f64,
    reference: Reference,
}

macro_rules! with_orbit {
    ($map:expr, $start:expr, $eps:expr, $setting:expr, |$orbit:ident| $body:expr) => {
        match (Composition::of_order($setting.order).filter(|_| $setting.order > 2), $setting.compensated) {
            (None, false) => {
                let mut $orbit = $map.orbit($start, $eps);
                $body
            }
            (None, true) => {
                let mut $orbit = $map.orbit($start, $eps).compensated();
                $body
            }
            (Some(composition), false) => {
                let mut $orbit = $map.orbit($start, $eps).composed(composition);
                $body
            }
            (Some(composition), true) => {
                let mut $orbit = $map.orbit($start, $eps).composed(composition).compensated();
                $body
            }
        }
    };
}

impl<M: Lift<BigRational, N>, const N: usize> Scene<M, N> {
    fn parts<T: FloatScalar>(&self, eps: f64) -> (M::Lifted<T>, SVector<T, N>, T) {
        let eps = BigRational::from_float(eps).expect("finite");
        (self.map.lift(to), SVector::from_fn(|i, _| to(&self.start[i])), to(&eps))
    }

    fn steps(&self, setting: &Setting) -> usize {
        (self.horizon / (2.0 * setting.eps)).round() as usize
    }

    fn error(&self, setting: &Setting) -> f64 {
        let (steps, dt) = (self.steps(setting), Dd::from(2.0 * setting.eps));
        let far =
            |(n, x): (usize, SVector<Dd, N>)| self.reference.distance(dt * Dd::from(n as f64), x.as_slice());
        macro_rules! worst {
            ($map:expr, $start:expr, $eps:expr) => {
                with_orbit!($map, $start, $eps, setting, |orbit| orbit
                    .by_ref()
                    .take(steps + 1)
                    .map(|x| x.map(Dd::from))
                    .enumerate()
                    .map(far)
                    .fold(0.0, f64::max))
            };
        }
        match setting.scalar {
            "f32" => {
                let (map, start, eps) = self.parts::<f32>(setting.eps);
                worst!(map, start, eps)
            }
            "f32-through-f64" => {
                let (map, start, eps) = self.parts::<f32>(setting.eps);
                worst!(ThroughF64(map), start, eps)
            }
            "f64" => {
                let (map, start, eps) = self.parts::<f64>(setting.eps);
                worst!(map, start, eps)
            }
            _ => {
                let (map, start, eps) = self.parts::<Dd>(setting.eps);
                worst!(map, start, eps)
            }
        }
    }

    /// Nanoseconds a unit of time, once.
    fn price(&self, setting: &Setting) -> f64 {
        const STEPS: usize = 400;
        macro_rules! time {
            ($map:expr, $start:expr, $eps:expr) => {
                with_orbit!($map, $start, $eps, setting, |orbit| {
                    orbit.next();
                    let clock = Instant::now();
                    black_box(orbit.nth(black_box(STEPS - 1)));
                    clock.elapsed().as_secs_f64()
                })
            };
        }
        let seconds = match setting.scalar {
            "f32" => {
                let (map, start, eps) = self.parts::<f32>(setting.eps);
                time!(map, black_box(start), black_box(eps))
            }
            "f32-through-f64" => {
                let (map, start, eps) = self.parts::<f32>(setting.eps);
                time!(ThroughF64(map), black_box(start), black_box(eps))
            }
            "f64" => {
                let (map, start, eps) = self.parts::<f64>(setting.eps);
                time!(map, black_box(start), black_box(eps))
            }
            _ => {
                let (map, start, eps) = self.parts::<Dd>(setting.eps);
                time!(map, black_box(start), black_box(eps))
            }
        };
        1e9 * seconds / (STEPS as f64 * 2.0 * setting.eps)
    }

    /// The coarsest eps of each kind that does, on a grid of a tenth; at most so many steps.
    fn sweep(&self, tolerance: f64) -> Vec<Setting> {
        const MOST: f64 = 3e5;
        let mut found = Vec::new();
        for scalar in ["f32", "f32-through-f64", "f64", "dd"] {
            for (order, compensated) in [2, 4, 6, 8].into_iter().flat_map(|p| [(p, false), (p, true)]) {
                let mut steps = (self.horizon * self.reference.slope() / 8.0).ceil().max(1.0);
                while steps < MOST {
                    let eps = self.horizon / (2.0 * steps);
                    let eps = if scalar.starts_with("f32") {
                        f64::from(nearest_short_eps(eps as f32))
                    } else {
                        nearest_short_eps(eps)
                    };
                    let setting = Setting { scalar, order, compensated, eps };
                    if self.error(&setting) <= tolerance {
                        found.push(setting);
                        break;
                    }
                    steps = (1.1 * steps).ceil();
                }
            }
        }
        found
    }
}

fn check<M, const N: usize>(
    name: &str,
    map: M,
    text: &str,
    start: [&str; N],
    horizon: f64,
    tolerance: f64,
) -> f64
where
    M: Lift<BigRational, N>,
{
    let point: Vec<BigRational> =
        start.iter().map(|x| Rational::parse(x).expect("a number").to_big()).collect();
    let allowed = 1e-3 * tolerance;
    let asked = Trajectory { command: "", parameters: &[], start: &point, end: 1.005 * horizon, allowed };
    let reference = Reference::of(&map.lift::<Dd>(to), &asked).expect("a reference");
    let scene = Scene { map, start: SVector::from_fn(|i, _| point[i].clone()), horizon, reference };

    let arguments = [
        "trade",
        "--json",
        "--field",
        text,
        "--at",
        &start.join(","),
        "--horizon",
        &horizon.to_string(),
        "--tolerance",
        &tolerance.to_string(),
    ];
    let output = Command::new(env!("CARGO_BIN_EXE_kahan")).args(arguments).output().expect("it runs");
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    let object: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
    let choice = &object["choice"];
    let scalar = ["f32", "f32-through-f64", "f64", "dd"].into_iter().find(|name| choice["scalar"] == **name);
    let chosen = Setting {
        scalar: scalar.expect("a scalar"),
        order: choice["order"].as_u64().expect("an order") as u32,
        compensated: choice["compensated"] == true,
        eps: nearest_short_eps(choice["eps"].as_f64().expect("a float")),
    };
    assert!(scene.error(&chosen) <= 1.02 * tolerance, "{chosen:?}");

    let mut settings = scene.sweep(tolerance);
    settings.push(chosen);
    let mut prices = vec![f64::INFINITY; settings.len()];
    for _ in 0..60 {
        for (price, setting) in prices.iter_mut().zip(&settings) {
            *price = price.min(scene.price(setting));
        }
    }
    let of_choice = prices.pop().expect("the choice");
    let best = (0..prices.len()).min_by(|&a, &b| prices[a].total_cmp(&prices[b])).expect("a setting");
    let ratio = of_choice / prices[best];
    println!(
        "{name}, {tolerance:e}: {chosen:?} at {of_choice:.0} ns ({:.0} predicted), best of {} {:?} at {:.0} ns: {ratio:.3}",
        choice["nanoseconds_per_unit_time"].as_f64().expect("a price"),
        prices.len(),
        settings[best],
        prices[best],
    );
    ratio
}

#[test]
#[ignore = "times, on a quiet machine"]
fn the_choice_costs_at_most_1_3_times_the_best_of_all_settings() {
    let mut ratios = Vec::new();
    for tolerance in [1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-14] {
        let henon = check("henon", Henon, HENON, ["1/10", "1/5", "-1/4", "1/3"], 20.0, tolerance);
        let gyrostat = check("gyrostat", Gyrostat, GYROSTAT, ["1", "1/2", "-1/3"], 20.0, tolerance);
        let tired = check("tired", Tired, TIRED, ["1/2", "2/3"], 20.0, tolerance);
        ratios.extend([henon, gyrostat, tired]);
    }
    assert!(ratios.iter().all(|ratio| *ratio <= 1.3), "{ratios:?}");
}
