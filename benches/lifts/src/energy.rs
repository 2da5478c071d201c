//! Measures drifts of the energy that a lifted map preserves, and of the equations' own energy.

use kahan_lift::{LiftCriterion, Reembedding};

use crate::systems::{Formula, System};

/// Systems whose lifted map preserves an energy for 10⁶ steps.
const KEPT: [&str; 9] = [
    "pendulum",
    "double well",
    "Morse",
    "Lennard-Jones",
    "Hénon–Heiles + x^4",
    "softened Kepler",
    "φ⁴ chain of 3",
    "sine-Gordon chain of 3",
    "Toda chain of 3",
];
const STEPS: u64 = 1_000_000;
const LOOKS: u64 = 10_000;
/// The number of initial states, whose coordinates differ by millionths.
const STARTS: u32 = 16;
const EPS: f64 = 0.01;
/// The largest error of a preserved energy, relative to the sum of its terms' sizes. Rounding
/// errors grow like the root of the number of steps: 10 · 1.1e-16 · √10⁶ ≈ 1e-12.
const ROUNDING: f64 = 1e-12;
/// The largest permitted growth of the error between 10⁴ and 10⁶ steps. A random walk grows by √100
/// = 10, and a drift by 100.
const WALK: f64 = 30.0;

pub(crate) fn energy() {
    println!(
        "| system | new variables | largest error over {STEPS:.0e} steps | growth from 10⁴ to 10⁶ steps |\n|---|---|---|---|"
    );
    for system in System::all().into_iter().filter(|one| KEPT.contains(&one.name)) {
        let lift = system.lift(LiftCriterion::Automatic);
        let at = system.map(&lift).at(EPS);
        let names: Vec<&str> = lift.variables().iter().map(String::as_str).collect();
        let parameters = system.parameters.iter().map(|(name, value)| (name.as_str(), *value));
        let known: Vec<_> = parameters.chain([("eps", EPS)]).collect();
        let text = lift.energy.as_ref().expect("a kept energy");
        let kept = Formula::read(&format!("E' = {text}"), &names, &known).remove(0);
        let (mut most, mut early, mut late) = (0.0_f64, 0.0, 0.0);
        for place in 0..STARTS {
            let start: Vec<f64> = system.start.iter().map(|x| x * (1.0 + 1e-6 * f64::from(place))).collect();
            let mut point = system.embedded(&lift, &start);
            let (first, size) = (kept.value(&point), kept.size(&point));
            for look in 1..=LOOKS {
                at.advance(&mut point, STEPS / LOOKS).expect("the dimension of the lift");
                let error = (kept.value(&point) - first).abs() / size;
                most = if error.is_finite() { most.max(error) } else { f64::INFINITY };
                if look == LOOKS / 100 {
                    early += error * error;
                }
                if look == LOOKS {
                    late += error * error;
                }
            }
        }
        let growth = (late / early).sqrt();
        println!("| {} | {} | {most:.1e} | {growth:.1} |", system.name, lift.order());
        assert!(most <= ROUNDING, "{}: {most:e}, at most {ROUNDING:e}", system.name);
        assert!(growth <= WALK, "{}: grows by {growth}, at most {WALK}", system.name);
    }
}

/// Systems with polynomial or trigonometric potentials, whose energy does not drift.
const SMOOTH: [&str; 8] = [
    "quartic oscillator",
    "Duffing",
    "double well",
    "Hénon–Heiles + x^4",
    "pendulum",
    "quintic",
    "φ⁴ chain of 3",
    "sine-Gordon chain of 3",
];
/// The largest permitted quotient of the errors in a run's last eighth and in its first eighth.
const TREND: f64 = 1.2;
const PROJECTION_EPS: f64 = 0.02;
const PROJECTION_TIME: f64 = 4000.0;

pub(crate) fn projection() {
    println!(
        "| system | as lifted: first, last eighth | ratio | projected: first, last eighth | ratio | steps of the map |\n|---|---|---|---|---|---|"
    );
    for system in System::all() {
        let Some(energy) = &system.energy else { continue };
        let lift = system.lift(LiftCriterion::Automatic);
        let at = system.map(&lift).at(PROJECTION_EPS);
        let steps = (PROJECTION_TIME / (2.0 * PROJECTION_EPS)) as usize;
        let first = energy.value(&system.start);
        let mut point = system.embedded(&lift, &system.start);
        let lifted: Vec<f64> = (0..steps)
            .map(|_| {
                at.advance(&mut point, 1).expect("the dimension of the lift");
                energy.value(&point) - first
            })
            .collect();
        let (values, mut reembedding, mut evaluations) = (system.values(), Reembedding::default(), 0);
        let mut states = system.start.clone();
        let projected: Vec<f64> = (0..steps)
            .map_while(|_| {
                let converged = reembedding.step(
                    &mut states,
                    |states| lift.embed(states, &values),
                    |point| {
                        evaluations += 1;
                        at.advance(point, 1).expect("the dimension of the lift");
                    },
                );
                converged.then(|| energy.value(&states) - first)
            })
            .collect();
        let ratio = |errors: &[f64]| {
            let most = |part: &[f64]| part.iter().fold(0.0_f64, |most, error| most.max(error.abs()));
            let (early, late) = (most(&errors[..steps / 8]), most(&errors[steps - steps / 8..]));
            (format!("{early:.1e}, {late:.1e} | {:.2}", late / early), late / early)
        };
        assert_eq!(projected.len(), steps, "{}: the projection converges", system.name);
        let [(lifted, as_is), (projected, held)] = [&lifted, &projected].map(|errors| ratio(errors));
        let each = f64::from(evaluations) / steps as f64;
        println!("| {} | {lifted} | {projected} | {each:.1} |", system.name);
        assert!(held <= TREND, "{}: {held}, at most {TREND}", system.name);
        let is_smooth = SMOOTH.contains(&system.name);
        assert!(!is_smooth || as_is <= TREND, "{}: {as_is}, at most {TREND}", system.name);
    }
}
