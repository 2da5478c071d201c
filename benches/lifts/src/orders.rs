//! Measures orders of convergence of lifted fields.
//!
//! Thirty lifted systems run with repeatedly halved steps, by Kahan's map and by a composition of
//! order 4. The program prints the least and the largest ratio of the errors at two successive step
//! sizes. Errors below 1e-9 or above 1e-3 are left out.

use kahan_core::Composition;
use kahan_lift::LiftCriterion;

use crate::systems::{System, distance};

const LOOKS: u32 = 8;
const LARGEST: f64 = 1e-3;
const LEAST: f64 = 1e-9;
const MOST_STEPS: u64 = 1 << 24;

pub(crate) fn orders() {
    println!(
        "| system | new variables | order 2: ratios | steps | order 4: ratios | steps |\n|---|---|---|---|---|---|"
    );
    let mut missed = Vec::new();
    for system in System::all().into_iter().filter(|one| !one.is("extra")) {
        let lift = system.lift(LiftCriterion::Automatic);
        let map = system.map(&lift);
        let reference = system.solution(system.time, LOOKS, 1e-13);
        let states = lift.states.len() - usize::from(lift.has_time);
        let mut cells = Vec::new();
        for (composition, wanted, allowed) in
            [(Composition::KAHAN, 4.0, 0.2), (Composition::SUZUKI_4, 16.0, 2.0)]
        {
            let mut errors = Vec::new();
            let mut steps = u64::from(LOOKS);
            while steps < MOST_STEPS && errors.last().is_none_or(|&last| last > LEAST) {
                let at = map.at(system.time / steps as f64 / 2.0).composed(composition);
                let mut point = system.embedded(&lift, &system.start);
                errors.push(reference.iter().fold(0.0_f64, |most, expected| {
                    at.advance(&mut point, steps / u64::from(LOOKS)).expect("the dimension of the lift");
                    most.max(distance(&point, &expected[..states]))
                }));
                steps *= 2;
            }
            let within = |error: &&f64| (LEAST..=LARGEST).contains(*error);
            let errors: Vec<f64> = errors.iter().filter(within).copied().collect();
            let ratios: Vec<f64> = errors.windows(2).map(|pair| pair[0] / pair[1]).collect();
            let [low, high] = [f64::min, f64::max].map(|pick| ratios.iter().copied().reduce(pick));
            let (Some(low), Some(high)) = (low, high) else {
                cells.push("none | 0".to_owned());
                missed.push(format!("{}: no ratio", system.name));
                continue;
            };
            if low < wanted - allowed || high > wanted + allowed {
                let ratios: Vec<String> = ratios.iter().map(|ratio| format!("{ratio:.2}")).collect();
                missed.push(format!("{}: {} from {:.1e}", system.name, ratios.join(", "), errors[0]));
            }
            cells.push(format!("{low:.2} to {high:.2} | {}", ratios.len()));
        }
        println!("| {} | {} | {} |", system.name, lift.order(), cells.join(" | "));
    }
    println!("\nBeyond 4 ± 0.2 and 16 ± 2:");
    missed.iter().for_each(|line| println!("{line}"));
}
