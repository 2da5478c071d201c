//! Compares lifted fields with the Dormand–Prince method of order 8, at equal error.
//!
//! The table gives the time of the cheapest run with an error of at most 1e-3, 1e-6 and 1e-9. For
//! mechanical systems, Störmer–Verlet composed to order 8 is a further contender.

use std::hint::black_box;
use std::time::Instant;

use kahan_algebra::lenient;
use kahan_core::Composition;
use kahan_lift::{Lift, LiftCriterion, Options, lift};
use kahan_runtime::Map;
use ode_solvers::{Dop853, OutputType, SVector};

use crate::systems::distance;

const TIME: f64 = 100.0;
const TOLERANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];
const REPEATS: usize = 5;

type Slope = fn(&[f64], &mut [f64]);

struct Field(Slope);

impl<const N: usize> ode_solvers::System<f64, SVector<f64, N>> for Field {
    fn system(&self, _time: f64, x: &SVector<f64, N>, slope: &mut SVector<f64, N>) {
        self.0(x.as_slice(), slope.as_mut_slice());
    }
}

struct System {
    name: &'static str,
    text: &'static str,
    start: &'static [f64],
    slope: Slope,
    /// Whether the states are positions followed by as many momenta, with unit masses.
    is_mechanical: bool,
}

const SYSTEMS: [System; 6] = [
    System {
        name: "quartic oscillator",
        text: "x' = p; p' = -x^3",
        start: &[1.0, 0.0],
        slope: |x, f| {
            f[0] = x[1];
            f[1] = -x[0] * x[0] * x[0];
        },
        is_mechanical: true,
    },
    System {
        name: "pendulum",
        text: "x' = p; p' = -sin(x)",
        start: &[1.0, 0.0],
        slope: |x, f| {
            f[0] = x[1];
            f[1] = -x[0].sin();
        },
        is_mechanical: true,
    },
    System {
        name: "Toda chain of 3",
        text: "x' = p; y' = q; z' = s; p' = exp(z - x) - exp(x - y); q' = exp(x - y) - exp(y - z); s' = exp(y - z) - exp(z - x)",
        start: &[0.5, 0.0, -0.3, 0.2, -0.4, 0.2],
        slope: |x, f| {
            let [a, b, c] = [(x[0] - x[1]).exp(), (x[1] - x[2]).exp(), (x[2] - x[0]).exp()];
            f[..3].copy_from_slice(&x[3..]);
            f[3] = c - a;
            f[4] = a - b;
            f[5] = b - c;
        },
        is_mechanical: true,
    },
    System {
        name: "Kepler",
        text: "x' = p; y' = q; p' = -x/(x^2 + y^2)^(3/2); q' = -y/(x^2 + y^2)^(3/2)",
        start: &[1.0, 0.0, 0.0, 1.1],
        slope: |x, f| {
            let square = x[0] * x[0] + x[1] * x[1];
            let cube = square * square.sqrt();
            f[0] = x[2];
            f[1] = x[3];
            f[2] = -x[0] / cube;
            f[3] = -x[1] / cube;
        },
        is_mechanical: true,
    },
    System {
        name: "FitzHugh–Nagumo",
        text: "v' = v - v^3/3 - w + 1/2; w' = 2/25*(v + 7/10 - 4/5*w)",
        start: &[0.1, 0.0],
        slope: |x, f| {
            f[0] = x[0] - x[0] * x[0] * x[0] / 3.0 - x[1] + 0.5;
            f[1] = 0.08 * (x[0] + 0.7 - 0.8 * x[1]);
        },
        is_mechanical: false,
    },
    System {
        name: "Brusselator",
        text: "x' = 1 + x^2*y - 4*x; y' = 3*x - x^2*y",
        start: &[1.0, 1.0],
        slope: |x, f| {
            let product = x[0] * x[0] * x[1];
            f[0] = 1.0 + product - 4.0 * x[0];
            f[1] = 3.0 * x[0] - product;
        },
        is_mechanical: false,
    },
];

impl System {
    fn lifted(&self, which: LiftCriterion) -> (Lift, Map) {
        let orbit = Some((self.start.to_vec(), Vec::new()));
        let tokens = lenient::read(self.text).lexed.tokens;
        let lift = lift(&tokens, &Options { which, orbit, ..Options::default() }).expect("a lift");
        let field = kahan_runtime::Field::parse(&lift.text()).expect("a quadratic field");
        let map = field.with([("", 0.0); 0]).expect("no parameters");
        (lift, map)
    }

    /// Returns the final state. Both the absolute and the relative tolerance are `tolerance`.
    fn dormand_prince(&self, tolerance: f64) -> Vec<f64> {
        match self.start.len() {
            2 => self.dormand_prince_of::<2>(tolerance),
            4 => self.dormand_prince_of::<4>(tolerance),
            _ => self.dormand_prince_of::<6>(tolerance),
        }
    }

    fn dormand_prince_of<const N: usize>(&self, tolerance: f64) -> Vec<f64> {
        let start = SVector::<f64, N>::from_column_slice(self.start);
        let mut solver = Dop853::new(Field(self.slope), 0.0, TIME, TIME, start, tolerance, tolerance);
        solver.set_output(OutputType::Sparse);
        solver.integrate().expect("a tame orbit");
        solver.y_out().last().expect("the end is put out").as_slice().to_vec()
    }

    /// Returns the final state after `steps` Störmer–Verlet steps, composed with these weights.
    fn verlet(&self, steps: u64, weights: &[f64]) -> Vec<f64> {
        let n = self.start.len() / 2;
        let mut x = self.start.to_vec();
        let mut f = vec![0.0; 2 * n];
        (self.slope)(&x, &mut f);
        let h = TIME / steps as f64;
        for _ in 0..steps {
            for weight in weights {
                let step = weight * h;
                for i in 0..n {
                    x[n + i] += step / 2.0 * f[n + i];
                }
                for i in 0..n {
                    x[i] += step * x[n + i];
                }
                (self.slope)(&x, &mut f);
                for i in 0..n {
                    x[n + i] += step / 2.0 * f[n + i];
                }
            }
        }
        x
    }
}

fn timed(run: impl Fn() -> Vec<f64>) -> (f64, Vec<f64>) {
    let mut least = f64::INFINITY;
    let mut result = Vec::new();
    for _ in 0..REPEATS {
        let begun = Instant::now();
        result = black_box(run());
        least = least.min(begun.elapsed().as_secs_f64());
    }
    (least, result)
}

/// Returns, for each of `TOLERANCES`, the least time among the runs whose error is at most the
/// tolerance. The iterator `runs` yields times and final states, with ever finer settings.
fn cheapest(reference: &[f64], runs: impl Iterator<Item = (f64, Vec<f64>)>) -> [f64; 3] {
    let mut least = [f64::INFINITY; 3];
    for (seconds, end) in runs {
        let error = distance(&end[..reference.len()], reference);
        for (least, tolerance) in least.iter_mut().zip(TOLERANCES) {
            if error <= tolerance {
                *least = least.min(seconds);
            }
        }
        if least[2].is_finite() {
            break;
        }
    }
    least
}

pub(crate) fn race() {
    println!("| system | method | 1e-3 | 1e-6 | 1e-9 |\n|---|---|---|---|---|");
    for system in SYSTEMS {
        let reference = system.dormand_prince(1e-13);
        let runs = (0..40).map(|k| timed(|| system.dormand_prince(1e-2 * 0.5_f64.powi(k))));
        let peer = cheapest(&reference, runs);
        let row = |method: &str, least: [f64; 3]| {
            let cell = |(time, peer): (f64, f64)| {
                if time.is_finite() { format!("{:.2}", time / peer) } else { "–".to_owned() }
            };
            let cells: Vec<String> = least.into_iter().zip(peer).map(cell).collect();
            println!("| {} | {method} | {} |", system.name, cells.join(" | "));
        };
        let steps = |k: i32| (100.0 * 1.25_f64.powi(k)).ceil() as u64;
        let lifted = |which: LiftCriterion, composition: Composition| {
            let (lift, map) = system.lifted(which);
            let start = [system.start.to_vec(), lift.embed(system.start, &[])].concat();
            let runs = (0..60).map_while(|k| {
                let steps = steps(k);
                let at = map.at(TIME / steps as f64 / 2.0).composed(composition);
                (steps < 2_000_000).then(|| {
                    timed(|| {
                        let mut point = start.clone();
                        at.advance(&mut point, steps).expect("the dimension of the lift");
                        point
                    })
                })
            });
            (lift.order(), cheapest(&reference, runs))
        };
        for (name, composition) in [
            ("order 2", Composition::KAHAN),
            ("order 4", Composition::SUZUKI_4),
            ("order 8", Composition::KAHAN_LI_8),
        ] {
            row(&format!("lifted, {name}"), lifted(LiftCriterion::Automatic, composition).1);
        }
        let (order, least) = lifted(LiftCriterion::Smallest, Composition::KAHAN_LI_8);
        if order < system.lifted(LiftCriterion::Automatic).0.order() {
            row("`--lift=smallest`, order 8", least);
        }
        if system.is_mechanical {
            for (name, composition) in [("order 2", Composition::KAHAN), ("order 8", Composition::KAHAN_LI_8)]
            {
                let weights: Vec<f64> =
                    composition.coefficients().map(kahan_core::Constant::to_f64).collect();
                let runs = (0..60).map_while(|k| {
                    let steps = steps(k);
                    (steps < 2_000_000).then(|| timed(|| system.verlet(steps, &weights)))
                });
                row(&format!("Störmer–Verlet, {name}"), cheapest(&reference, runs));
            }
        }
    }
}
