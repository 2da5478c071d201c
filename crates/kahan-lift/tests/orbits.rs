//! Tests accuracy, relations and energies of orbits of lifted fields.

use kahan_algebra::lenient;
use kahan_lift::{Lift, Options, Reembedding, lift};
use kahan_runtime::{Field, Map};

struct System {
    text: &'static str,
    start: &'static [f64],
    parameters: &'static [f64],
    field: fn(&[f64]) -> Vec<f64>,
}

impl System {
    fn lift(&self) -> Lift {
        let read = lenient::read(self.text);
        let orbit = Some((self.start.to_vec(), self.parameters.to_vec()));
        lift(&read.lexed.tokens, &Options { orbit, ..Options::default() })
            .unwrap_or_else(|mistakes| panic!("{}: {}", self.text, mistakes[0]))
    }

    fn map(&self, lift: &Lift) -> Map {
        let field = Field::parse(&lift.text()).expect("a quadratic field");
        let used = |name: &&String| field.parameters().contains(name);
        let values = lift.parameters.iter().zip(self.parameters).filter(|(name, _)| used(name));
        field.with(values.map(|(name, value)| (name.as_str(), *value))).expect("all parameters")
    }

    fn embedded(&self, lift: &Lift) -> Vec<f64> {
        [self.start.to_vec(), lift.embed(self.start, self.parameters)].concat()
    }

    fn states(&self, lift: &Lift, eps: f64, steps: u64) -> Vec<f64> {
        let mut point = self.embedded(lift);
        self.map(lift).at(eps).advance(&mut point, steps).expect("the dimension of the lift");
        point.truncate(self.start.len());
        point
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    // An infinite distance stands for NaN, which `f64::max` would ignore.
    let far = |a: f64, b: f64| if a.is_finite() && b.is_finite() { (a - b).abs() } else { f64::INFINITY };
    a.iter().zip(b).fold(0.0_f64, |most, (&a, &b)| most.max(far(a, b))) / size
}

fn solution(system: &System, time: f64, steps: u32) -> Vec<f64> {
    let h = time / f64::from(steps);
    let field = system.field;
    let moved = |x: &[f64], by: f64, slope: &[f64]| -> Vec<f64> {
        x.iter().zip(slope).map(|(x, slope)| x + by * slope).collect()
    };
    let mut x = system.start.to_vec();
    for _ in 0..steps {
        let a = field(&x);
        let b = field(&moved(&x, h / 2.0, &a));
        let c = field(&moved(&x, h / 2.0, &b));
        let d = field(&moved(&x, h, &c));
        let slope = |i: usize| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0;
        x = (0..x.len()).map(|i| x[i] + h * slope(i)).collect();
    }
    x
}

const FITZHUGH_NAGUMO: System = System {
    text: "v' = v - v^3/3 - w + 1/2; w' = 2/25*(v + 7/10 - 4/5*w)",
    start: &[0.1, 0.0],
    parameters: &[],
    field: |x| vec![x[0] - x[0].powi(3) / 3.0 - x[1] + 0.5, 0.08 * (x[0] + 0.7 - 0.8 * x[1])],
};
const VAN_DER_POL: System = System {
    text: "x' = y; y' = mu*(1 - x^2)*y - x",
    start: &[1.0, 0.5],
    parameters: &[1.5],
    field: |x| vec![x[1], 1.5 * (1.0 - x[0] * x[0]) * x[1] - x[0]],
};
const BRUSSELATOR: System = System {
    text: "x' = a + x^2*y - b*x - x; y' = b*x - x^2*y",
    start: &[1.0, 1.0],
    parameters: &[1.0, 3.0],
    field: |x| vec![1.0 + x[0] * x[0] * x[1] - 4.0 * x[0], 3.0 * x[0] - x[0] * x[0] * x[1]],
};
const ROSENZWEIG_MACARTHUR: System = System {
    text: "x' = r*x*(1 - x/K) - a*x*y/(1 + h*x); y' = e*a*x*y/(1 + h*x) - m*y",
    start: &[1.0, 1.0],
    parameters: &[1.0, 4.0, 1.0, 0.5, 0.5, 0.3],
    field: |x| {
        let eaten = x[0] * x[1] / (1.0 + 0.5 * x[0]);
        vec![x[0] * (1.0 - x[0] / 4.0) - eaten, 0.5 * eaten - 0.3 * x[1]]
    },
};
const REPRESSILATOR: System = System {
    text: "x' = a/(1 + z^2) - x; y' = a/(1 + x^2) - y; z' = a/(1 + y^2) - z",
    start: &[1.0, 2.0, 3.0],
    parameters: &[10.0],
    field: |x| (0..3).map(|i| 10.0 / (1.0 + x[(i + 2) % 3].powi(2)) - x[i]).collect(),
};
const PENDULUM: System = System {
    text: "x' = v; v' = -g*sin(x)",
    start: &[1.0, 0.0],
    parameters: &[1.0],
    field: |x| vec![x[1], -x[0].sin()],
};
const KEPLER: System = System {
    text: "x' = p; y' = q; p' = -x/(x^2 + y^2)^(3/2); q' = -y/(x^2 + y^2)^(3/2)",
    start: &[1.0, 0.0, 0.0, 1.1],
    parameters: &[],
    field: |x| {
        let cube = x[0].hypot(x[1]).powi(3);
        vec![x[2], x[3], -x[0] / cube, -x[1] / cube]
    },
};
const QUARTIC: System = System {
    text: "x' = p; p' = -x^3",
    start: &[1.0, 0.0],
    parameters: &[],
    field: |x| vec![x[1], -x[0].powi(3)],
};
/// The new variables x² and x³ come near 0, where their relative rounding errors are large.
const DUFFING: System = System {
    text: "x' = p; p' = -x - x^3/2",
    start: &[1.0, 0.2],
    parameters: &[],
    field: |x| vec![x[1], -x[0] - x[0].powi(3) / 2.0],
};
const DISSIPATIVE: [System; 5] =
    [FITZHUGH_NAGUMO, VAN_DER_POL, BRUSSELATOR, ROSENZWEIG_MACARTHUR, REPRESSILATOR];

#[test]
fn default_lifts_solve_the_original_equations_to_order_two() {
    for system in DISSIPATIVE.into_iter().chain([PENDULUM, KEPLER, QUARTIC]) {
        let lift = system.lift();
        // The reference solution has an error below 1e-9, as step halving shows.
        let reference = solution(&system, 20.0, 40_000);
        let error = |eps: f64, steps| distance(&system.states(&lift, eps, steps), &reference);
        let [coarse, middle, fine] = [error(0.01, 1000), error(0.005, 2000), error(0.0025, 4000)];
        for ratio in [coarse / middle, middle / fine] {
            assert!((ratio - 4.0).abs() < 0.2, "{}: {coarse:e}, {middle:e}, {fine:e}", system.text);
        }
    }
}

#[test]
fn relations_of_default_lifts_hold_to_order_two_for_a_long_time() {
    for system in DISSIPATIVE {
        let lift = system.lift();
        let error = |eps: f64, steps| {
            let mut point = system.embedded(&lift);
            system.map(&lift).at(eps).advance(&mut point, steps).expect("the dimension of the lift");
            let (states, new) = point.split_at(system.start.len());
            distance(new, &lift.embed(states, system.parameters))
        };
        let [coarse, fine] = [error(0.01, 50_000), error(0.0025, 200_000)];
        assert!(coarse < 2e-2 && fine < 2e-3, "{}: {coarse:e}, {fine:e}", system.text);
    }
}

type Energy = fn(&[f64]) -> f64;

fn energies() -> [(System, Energy); 4] {
    [
        (PENDULUM, |x| x[1] * x[1] / 2.0 - x[0].cos()),
        (QUARTIC, |x| x[1] * x[1] / 2.0 + x[0].powi(4) / 4.0),
        (DUFFING, |x| x[1] * x[1] / 2.0 + x[0] * x[0] / 2.0 + x[0].powi(4) / 8.0),
        (KEPLER, |x| (x[2] * x[2] + x[3] * x[3]) / 2.0 - 1.0 / x[0].hypot(x[1])),
    ]
}

#[test]
fn symmetric_projection_lets_no_energy_drift() {
    for (system, energy) in energies() {
        let lift = system.lift();
        let map = system.map(&lift).at(0.02);
        let mut reembedding = Reembedding::default();
        let mut states = system.start.to_vec();
        let first = energy(&states);
        let mut errors = Vec::new();
        for _ in 0..20_000 {
            let converged = reembedding.step(
                &mut states,
                |states| lift.embed(states, system.parameters),
                |point| map.advance(point, 1).expect("the dimension of the lift"),
            );
            assert!(converged, "{}", system.text);
            errors.push((energy(&states) - first).abs());
        }
        let most = |part: &[f64]| part.iter().fold(0.0_f64, |most, error| most.max(*error));
        let (early, late) = (most(&errors[..2500]), most(&errors[17_500..]));
        assert!(late <= 1.2 * early, "{}: {early:e}, then {late:e}", system.text);
    }
}
