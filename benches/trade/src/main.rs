//! Checks the choices of `kahan trade` and of the library against all settings.
//! `cargo run --release -p kahan-bench-trade` in `benches/` fails in three cases:
//!
//! - The error of a choice exceeds its tolerance.
//! - A choice costs more than a permitted multiple of the best setting.
//! - A price of the command differs too much from the price that is measured here.

mod command;
mod price;
mod scene;
mod unseen_fields;

use std::fmt::Debug;
use std::process::ExitCode;

use anyhow::{Result, ensure};
use kahan_algebra::rational::Rational;
use kahan_core::prelude::*;
use kahan_core::{Dd, ExtendScalars};
use kahan_study::reference::{Reference, Trajectory, TrajectoryLimits};

use scene::{Scene, Setting, to};
use unseen_fields::{
    Chain, Epidemic, Galaxy, Gyrostat, Kinetics, Nahm, Oscillators, Relaxation, Rotor, Slave, Text,
    ThreeWaves, Tired,
};

/// The largest permitted cost of the command's choice and of the library's choice, each relative to
/// the cheapest setting.
const DEAREST: [f64; 2] = [1.3, 3.0];
/// The factor by which the error of a choice may exceed the tolerance. The command checks fewer
/// points than this program, so it may miss the largest error.
const UNSEEN: f64 = 1.02;
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-14];

fn main() -> ExitCode {
    let mut check = Check::default();
    match check.all() {
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
        Ok(()) => {
            println!(
                "{} of {} choices within their tolerance; {} prices are {:.2} to {:.2} times what the command says",
                check.within, check.choices, check.prices, check.factors[0], check.factors[1]
            );
            check.failures.iter().for_each(|failure| eprintln!("error: {failure}"));
            if check.failures.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
    }
}

struct Check {
    choices: usize,
    within: usize,
    prices: usize,
    /// The least and largest ratio of the price that this program measures for a setting to the
    /// price that `kahan trade` reports for it.
    factors: [f64; 2],
    failures: Vec<String>,
}

impl Default for Check {
    fn default() -> Self {
        Check { choices: 0, within: 0, prices: 0, factors: [f64::INFINITY, 0.0], failures: Vec::new() }
    }
}

impl Check {
    fn all(&mut self) -> Result<()> {
        self.scenes(Oscillators, ["1/8", "1/4", "-1/4", "3/8"], 20.0)?;
        self.scenes(Gyrostat, ["1", "1/2", "-3/8"], 20.0)?;
        self.scenes(Tired, ["1/2", "5/8"], 20.0)?;
        self.scenes(Rotor, ["1/2", "2", "-1/4"], 30.0)?;
        self.scenes(ThreeWaves, ["1", "1/4", "1/2", "-1/2", "1/8", "3/4"], 10.0)?;
        self.scenes(Chain, ["1/2", "1/4", "1/2", "3/8"], 12.0)?;
        self.scenes(Galaxy, ["0", "1/8", "3/8", "1/8"], 25.0)?;
        self.scenes(Nahm, ["-1/2", "1/4"], 0.625)?;
        self.scenes(Epidemic, ["127/128", "1/128", "0"], 15.0)?;
        self.scenes(Kinetics, ["1", "0", "0"], 1.0)?;
        self.scenes(Slave, ["1", "1/2"], 2.0)?;
        self.scenes(Relaxation, ["1", "2", "1"], 12.0)
    }

    fn scenes<M, const N: usize>(&mut self, map: M, start: [&str; N], horizon: f64) -> Result<()>
    where
        M: ExtendScalars<BigRational, N> + Text + Clone + Debug,
        M::Extended<f64>: ExtendScalars<f64, N>,
    {
        let point = start.map(|x| Rational::parse(x).expect("a number").to_big());
        for tolerance in TOLERANCES {
            let asked = Trajectory {
                command: "",
                parameters: &[],
                start: &point,
                end: horizon,
                allowed: 1e-3 * tolerance,
            };
            // The margin allows for an orbit that ends a little beyond the horizon.
            let limits = TrajectoryLimits { margin: 1.0 / 256.0, is_over: None, variables: None };
            let reference = Reference::of(&map.extend_scalars::<Dd>(to), &asked, &limits)?;
            let scene = Scene { map: map.clone(), start: SVector::from(point.clone()), horizon, reference };
            let name = format!("{map:?}, {tolerance:e}");
            self.scene::<M, N>(&name, &scene, &start, tolerance)?;
        }
        Ok(())
    }

    fn scene<M, const N: usize>(
        &mut self,
        name: &str,
        scene: &Scene<M, N>,
        start: &[&str; N],
        tolerance: f64,
    ) -> Result<()>
    where
        M: ExtendScalars<BigRational, N> + Text + Clone,
        M::Extended<f64>: ExtendScalars<f64, N>,
    {
        let told = command::choice(M::TEXT, start, scene.horizon, tolerance)?;
        let by_library = library(&scene.map, &scene.start, scene.horizon, tolerance);
        self.errors(name, scene, &told.choice, by_library.as_ref(), tolerance);

        let mut settings = vec![told.choice];
        settings.extend(by_library);
        let dearest = (0..10).map(|_| scene.price(&told.choice)).fold(f64::INFINITY, f64::min);
        settings.extend(scene.sweep(tolerance, 1.2 * dearest));
        let swept = settings.len();
        settings.extend(told.prices.iter().map(|(setting, _)| *setting));
        let (prices, pace) = price::side_by_side(scene, &settings);

        let best_of = |may_be_known: &dyn Fn(&Setting) -> bool| {
            let known = (0..swept).filter(|&k| may_be_known(&settings[k]));
            known.min_by(|&a, &b| prices[a].total_cmp(&prices[b])).expect("a setting")
        };
        let is_single = |setting: &Setting| setting.scheme.precision.is_single();
        let best = best_of(&|_| true);
        let best_known = best_of(&|setting| is_single(&settings[0]) || !is_single(setting));
        let of_command = prices[0] / prices[best];
        let of_library = by_library.map(|_| prices[1] / prices[best]);
        println!(
            "{name}: {} at {:.0} ns, best of {swept} {} at {:.0} ns: {of_command:.3}; the library {}: {of_library:.3?}",
            settings[0],
            prices[0],
            settings[best],
            prices[best],
            by_library.map_or_else(|| "refuses".to_owned(), |setting| setting.to_string()),
        );
        let of_known = prices[0] / prices[best_known];
        for (who, ratio, dearest) in
            [("command", Some(of_known), DEAREST[0]), ("library", of_library, DEAREST[1])]
        {
            if let Some(ratio) = ratio.filter(|ratio| *ratio > dearest) {
                self.failures
                    .push(format!("{name}: the {who}'s choice costs {ratio:.2} times what the best does"));
            }
        }
        let measured = prices[swept..].iter().map(|price| price / pace);
        for ((setting, predicted), measured) in told.prices.iter().zip(measured) {
            let factor = measured / (predicted / told.pace);
            ensure!(factor.is_finite(), "{name}: {setting} has no price");
            self.prices += 1;
            self.factors = [self.factors[0].min(factor), self.factors[1].max(factor)];
            println!("    {factor:.2} {setting}");
            if !(1.0 / price::NEAR..=price::NEAR).contains(&factor) {
                self.failures.push(format!(
                    "{name}: {setting} costs {factor:.2} times what the command says, {predicted:.0} ns"
                ));
            }
        }
        Ok(())
    }

    fn errors<M: ExtendScalars<BigRational, N>, const N: usize>(
        &mut self,
        name: &str,
        scene: &Scene<M, N>,
        by_command: &Setting,
        by_library: Option<&Setting>,
        tolerance: f64,
    ) {
        for (setting, allowed) in [(Some(by_command), UNSEEN * tolerance), (by_library, tolerance)] {
            let Some(setting) = setting else { continue };
            let error = scene.error(setting, f64::INFINITY);
            self.choices += 1;
            if error <= allowed {
                self.within += 1;
            } else {
                self.failures.push(format!("{name}: {setting} errs by {error:e}"));
            }
        }
    }
}

/// Returns the scheme and the ε that the library chooses, or `None` if it refuses to choose.
fn library<M, const N: usize>(
    map: &M,
    start: &SVector<BigRational, N>,
    horizon: f64,
    tolerance: f64,
) -> Option<Setting>
where
    M: ExtendScalars<BigRational, N>,
    M::Extended<f64>: ExtendScalars<f64, N>,
{
    let start = SVector::from_fn(|i, _| to::<f64>(&start[i]));
    let chosen =
        kahan_dynamics::Scene::trajectory(horizon, tolerance).choose(&map.extend_scalars::<f64>(to), &start);
    let chosen = chosen.inspect_err(|why| println!("    the library refuses: {why}")).ok()?;
    Some(Setting { scheme: chosen.scheme(), eps: chosen.eps() })
}
