//! The choices of `kahan trade` and of the library against every setting there is, on scenes of
//! their own, timed side by side.
//!
//! It measures times, so it is not part of `cargo test`: run it on a quiet machine, with
//! `cargo test --release -p kahan-cli --test trade_sweep -- --ignored --nocapture`.

mod scene;
mod unseen_fields;

use std::process::Command;

use kahan_algebra::rational::Rational;
use kahan_core::prelude::*;
use kahan_core::{Composition, Dd, Lift, Need, Precision, Scheme};
use kahan_measure::reference::{Limits, Reference, Trajectory};
use serde_json::Value;

use scene::{Scene, Setting, to};
use unseen_fields::{
    Chain, Epidemic, Galaxy, Gyrostat, Kinetics, Nahm, Oscillators, Relaxation, Rotor, Slave, Text,
    ThreeWaves, Tired,
};

/// What a choice costs over what the best setting does.
struct Ratios {
    scene: String,
    of_command: f64,
    /// `None` where the library refuses.
    of_library: Option<f64>,
}

/// The command's choice.
fn command<M: Text>(start: &[&str], horizon: f64, tolerance: f64) -> (Setting, f64) {
    let output = Command::new(env!("CARGO_BIN_EXE_kahan"))
        .args(["trade", "--json", "--field", M::TEXT, "--at", &start.join(",")])
        .args(["--horizon", &horizon.to_string(), "--tolerance", &tolerance.to_string()])
        .output()
        .expect("it runs");
    assert!(output.status.success(), "{}: {}", M::TEXT, String::from_utf8_lossy(&output.stderr));
    let object: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
    let choice = &object["choice"];
    let precision = Precision::ALL.into_iter().find(|known| choice["scalar"] == known.name());
    let precision = precision.expect("a scalar");
    let order = choice["order"].as_u64().expect("an order") as u32;
    let composition = Composition::of_order(order).expect("a composition");
    let compensated = choice["compensated"] == true;
    let setting = Setting {
        scheme: Scheme { precision, composition, compensated },
        // Reading JSON may miss the last bit.
        eps: precision.eps_near(choice["eps"].as_f64().expect("a float"), Need::Trajectory),
    };
    (setting, choice["nanoseconds_per_unit_time"].as_f64().expect("a price"))
}

/// The library's choice.
fn library<M, const N: usize>(
    map: &M,
    start: &SVector<BigRational, N>,
    horizon: f64,
    tolerance: f64,
) -> Option<Setting>
where
    M: Lift<BigRational, N>,
    M::Lifted<f64>: Lift<f64, N>,
{
    let start = SVector::from_fn(|i, _| to::<f64>(&start[i]));
    let chosen = kahan_core::Scene::trajectory(horizon, tolerance).choose(&map.lift::<f64>(to), &start);
    let chosen = chosen.inspect_err(|why| println!("    the library refuses: {why}")).ok()?;
    Some(Setting { scheme: chosen.scheme(), eps: chosen.eps() })
}

fn check<M, const N: usize>(map: M, start: [&str; N], horizon: f64, ratios: &mut Vec<Ratios>)
where
    M: Lift<BigRational, N> + Text + Clone + std::fmt::Debug,
    M::Lifted<f64>: Lift<f64, N>,
{
    let point = start.map(|x| Rational::parse(x).expect("a number").to_big());
    for tolerance in [1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-14] {
        let allowed = 1e-3 * tolerance;
        let asked = Trajectory { command: "", parameters: &[], start: &point, end: horizon, allowed };
        // So many steps of an ε that was rounded end near the horizon, not at it.
        let limits = Limits { margin: 1.0 / 256.0, deadline: None };
        let reference = Reference::of(&map.lift::<Dd>(to), &asked, &limits).expect("a reference");
        let scene = Scene { map: map.clone(), start: SVector::from(point.clone()), horizon, reference };
        let name = format!("{map:?}, {tolerance:e}");

        let (chosen, predicted) = command::<M>(&start, horizon, tolerance);
        let error = scene.error(&chosen, f64::INFINITY);
        // The command looks at some points of an orbit, more where it moves fast, this at all.
        assert!(error <= 1.02 * tolerance, "{name}: {chosen:?} errs {error:e}");
        let by_library = library(&scene.map, &scene.start, horizon, tolerance);
        if let Some(setting) = &by_library {
            let error = scene.error(setting, f64::INFINITY);
            assert!(error <= tolerance, "{name}: the library's {setting:?} errs {error:e}");
        }

        let mut settings = vec![chosen];
        settings.extend(by_library);
        let dearest = (0..10).map(|_| scene.price(&chosen)).fold(f64::INFINITY, f64::min);
        settings.extend(scene.sweep(tolerance, 1.2 * dearest));
        let mut prices = vec![f64::INFINITY; settings.len()];
        for _ in 0..60 {
            for (price, setting) in prices.iter_mut().zip(&settings) {
                *price = price.min(scene.price(setting));
            }
        }
        let best = (0..prices.len()).min_by(|&a, &b| prices[a].total_cmp(&prices[b])).expect("a setting");
        let of_library = by_library.map(|_| prices[1] / prices[best]);
        let of_command = prices[0] / prices[best];
        println!(
            "{name}: {chosen:?} at {:.0} ns ({predicted:.0} predicted), best of {} {:?} at {:.0} ns: {of_command:.3}; \
             the library {by_library:?}: {of_library:.3?}",
            prices[0],
            prices.len(),
            settings[best],
            prices[best],
        );
        ratios.push(Ratios { scene: name, of_command, of_library });
    }
}

#[test]
#[ignore = "times, on a quiet machine"]
fn the_choices_cost_at_most_1_3_and_3_times_the_best_of_all_settings() {
    let mut ratios = Vec::new();
    check(Oscillators, ["1/8", "1/4", "-1/4", "3/8"], 20.0, &mut ratios);
    check(Gyrostat, ["1", "1/2", "-3/8"], 20.0, &mut ratios);
    check(Tired, ["1/2", "5/8"], 20.0, &mut ratios);
    check(Rotor, ["1/2", "2", "-1/4"], 30.0, &mut ratios);
    check(ThreeWaves, ["1", "1/4", "1/2", "-1/2", "1/8", "3/4"], 10.0, &mut ratios);
    check(Chain, ["1/2", "1/4", "1/2", "3/8"], 12.0, &mut ratios);
    check(Galaxy, ["0", "1/8", "3/8", "1/8"], 25.0, &mut ratios);
    check(Nahm, ["-1/2", "1/4"], 0.625, &mut ratios);
    check(Epidemic, ["127/128", "1/128", "0"], 15.0, &mut ratios);
    check(Kinetics, ["1", "0", "0"], 1.0, &mut ratios);
    check(Slave, ["1", "1/2"], 2.0, &mut ratios);
    check(Relaxation, ["1", "2", "1"], 12.0, &mut ratios);
    let beyond = |limit: f64, ratio: fn(&Ratios) -> Option<f64>| -> Vec<&str> {
        let beyond = ratios.iter().filter(|ratios| ratio(ratios).is_some_and(|ratio| ratio > limit));
        beyond.map(|ratios| ratios.scene.as_str()).collect()
    };
    let (command, library) = (beyond(1.3, |r| Some(r.of_command)), beyond(3.0, |r| r.of_library));
    assert!(command.is_empty() && library.is_empty(), "the command: {command:?}; the library: {library:?}");
}
