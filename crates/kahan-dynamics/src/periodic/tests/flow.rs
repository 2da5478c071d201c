//! Tests periods and bifurcations of flows against references computed without Kahan's method.

use std::ops::ControlFlow;

use kahan_core::prelude::*;
use kahan_core::{Dual, Workspace};

use super::super::*;

kahan! {
    struct Lorenz;
    xdot = 10*(y - x);
    ydot = 28*x - x*z - y;
    zdot = x*y - 8/3*z;
}

kahan! {
    struct Rossler { c }
    xdot = -y - z;
    ydot = x + 1/5*y;
    zdot = 1/5 + x*z - c*z;
}

fn refined<M: Parametric>(map: impl Fn(f64) -> M, first: FlowCycle) -> ([FlowCycle; 3], Extrapolated) {
    let second = first.doubled(&map).expect("the cycle at 2N");
    let cycles = [first, second.clone(), second.doubled(&map).expect("the cycle at 4N")];
    let periods = cycles.each_ref().map(FlowCycle::period);
    (cycles, Extrapolated::of(&periods, Extrapolated::EVEN))
}

fn orbit(map: &impl Step<Scalar = f64>, start: &[f64], transient: u64, steps: usize) -> Vec<Vec<f64>> {
    let (mut x, mut workspace) = (start.to_vec(), Workspace::new());
    map.advance(&mut x, transient, &mut workspace).expect("no pole");
    let next = |_| {
        map.advance(&mut x, 1, &mut workspace).expect("no pole");
        x.clone()
    };
    (0..steps).map(next).collect()
}

#[test]
fn the_shortest_cycles_of_the_lorenz_system_are_found_from_close_returns() {
    const STEPS: usize = 200;

    // Periods are from Viswanath, "The fractal property of the Lorenz attractor", Physica D 190
    // (2004). Multipliers come from shooting with SciPy's DOP853 at tolerance 1e-13.
    for (period, multiplier) in
        [(1.558652210716, 4.71294727), (2.305907263940, 9.16549182), (3.023583703434, 16.1136589)]
    {
        let map = |eps| Lorenz.at(Dual::coordinate(eps, 0));
        let eps = 1.002 * period / (2 * STEPS) as f64;
        let orbit = orbit(&Lorenz.at(eps), &[1.0, 2.0, 20.0], 1000, 20_000);
        let returns = close_returns(&orbit, [STEPS * 9 / 10, STEPS * 11 / 10]);
        let found = returns.iter().find_map(|one| {
            let cycle = flow_cycle(map, &orbit[one.at], eps, STEPS).ok()?;
            ((cycle.period() / period - 1.0).abs() < 0.05).then_some(cycle)
        });
        let (cycles, found) = refined(map, found.expect("a cycle of about this period"));
        assert!((found.value - period).abs() < 1e-9, "{period}: {found:?}");
        assert!((found.value - period).abs() < found.error + 1e-11, "{period}: {found:?}");
        let errors = cycles.each_ref().map(|cycle| cycle.period() - period);
        for ratio in [errors[0] / errors[1], errors[1] / errors[2]] {
            assert!((3.9..4.1).contains(&ratio), "{period}: the error is of order 2: {errors:?}");
        }
        let of_cycle = &cycles[2].cycle;
        assert_eq!((of_cycle.multipliers.len(), of_cycle.stability()), (2, Stability::Saddle));
        let multipliers = cycles.each_ref().map(|cycle| cycle.cycle.multipliers[0].re);
        let found = Extrapolated::of(&multipliers, Extrapolated::EVEN);
        assert!((found.value / multiplier - 1.0).abs() < 1e-7, "{found:?}");
    }
}

#[test]
fn loops_of_the_roessler_system_are_found_from_the_attractor() {
    // Periods and multipliers come from shooting with SciPy's DOP853 at tolerance 1e-13.
    for (c, steps, period, multiplier) in [
        (2.5, 200, 5.748991183278, -0.769696936),
        (3.5, 300, 11.545218287763, -0.418735420),
        (4.0, 600, 23.177001055976, -0.104919248),
    ] {
        let map = |eps| Rossler { c: Dual::from_value(c) }.at(Dual::coordinate(eps, 0));
        let eps = 0.02;
        let orbit = orbit(&Rossler { c }.at(eps), &[1.0, 2.0, 0.0], 10_000, 4000);
        let first = &close_returns(&orbit, [1, 1000])[0];
        let near = eps * first.steps as f64 / steps as f64;
        let found = flow_cycle(map, &orbit[first.at], near, steps).expect("a cycle");
        let (cycles, found) = refined(map, found);
        assert!((found.value - period).abs() < 2e-6, "{c}: {found:?}");
        let errors = cycles.each_ref().map(|cycle| cycle.period() - period);
        assert!((3.7..4.3).contains(&(errors[1] / errors[2])), "{c}: {errors:?}");
        let multipliers = cycles.each_ref().map(|cycle| {
            let multipliers = cycle.cycle.multipliers.iter();
            multipliers.map(|one| one.re).fold(0.0, f64::min)
        });
        let found = Extrapolated::of(&multipliers, Extrapolated::EVEN);
        assert!((found.value - multiplier).abs() < 1e-4, "{c}: {found:?}");
        assert_eq!(cycles[0].cycle.stability(), Stability::Attracting);
    }
}

#[test]
fn the_first_doubling_of_the_roessler_system_is_known_to_six_digits() {
    let by_eps = |c: f64, eps| Rossler { c: Dual::from_value(c) }.at(Dual::coordinate(eps, 0));
    let map = |c, eps| [by_eps(c, eps), Rossler { c: Dual::coordinate(c, 0) }.at(Dual::from_value(eps))];
    let at = |eps| by_eps(2.75, eps);
    let first = flow_cycle(at, &[-3.5, 1.0, 0.03], 0.03, 100).expect("a cycle");
    let turns = refined(at, first).0.map(|cycle| {
        let branch = flow_branch(map, &cycle, [2.75, 2.9], 2, |_| ControlFlow::Continue(()));
        assert_eq!((branch.turns.len(), branch.turns[0].change), (1, BranchChange::ThroughMinusOne));
        branch.turns[0].parameter
    });
    // The reference value was computed by shooting with DOP853 and Brent's method.
    let (reference, found) = (2.832_445_027_862, Extrapolated::of(&turns, Extrapolated::EVEN));
    assert!((found.value - reference).abs() < 3e-8, "{found:?}");
    assert!((found.value - reference).abs() < found.error, "{found:?}");
}

kahan! {
    /// In polar coordinates, r' = (z − b) r and z' = 3/5 + z − z² − r² + u/10. Cycles have z = b
    /// and the period 2π/3. The cycles with u = √p and u = −√p meet at p = 0. At b = 1/2 a complex
    /// pair of multipliers is on the unit circle.
    struct Torus { b, p }
    xdot = x*z - b*x - 3*y;
    ydot = 3*x + y*z - b*y;
    zdot = 3/5 + z - z^2 - x^2 - y^2 + u/10;
    udot = p - u^2;
}

#[test]
fn folds_and_pairs_on_the_circle_are_where_formulas_say() {
    let value = Dual::from_value;
    let torus = |b, p, eps| Torus { b, p }.at(eps);
    let start = |u: f64, b: f64| {
        let radius = (0.6 + b - b * b + u / 10.0).sqrt();
        [radius, 0.0, b, u]
    };
    let at = |eps| torus(value(0.6), value(0.25), Dual::coordinate(eps, 0));
    let first = flow_cycle(at, &start(0.5, 0.6), 0.01, 105).expect("a cycle");
    let (cycles, period) = refined(at, first);
    assert!((period.value - 2.0 * std::f64::consts::PI / 3.0).abs() < 1e-9, "{period:?}");
    let pairs = cycles.clone().map(|cycle| {
        let map = |b, eps| {
            let by_eps = torus(value(b), value(0.25), Dual::coordinate(eps, 0));
            [by_eps, torus(Dual::coordinate(b, 0), value(0.25), value(eps))]
        };
        let branch = flow_branch(map, &cycle, [0.6, 0.4], 4, |_| ControlFlow::Continue(()));
        assert_eq!((branch.turns.len(), branch.turns[0].change), (1, BranchChange::ThroughCircle));
        branch.turns[0].parameter
    });
    let found = Extrapolated::of(&pairs, Extrapolated::EVEN);
    assert!((found.value - 0.5).abs() < 1e-7, "{found:?}");
    let map = |p, eps| {
        let by_eps = torus(value(0.6), value(p), Dual::coordinate(eps, 0));
        [by_eps, torus(value(0.6), Dual::coordinate(p, 0), value(eps))]
    };
    let branch = flow_branch(map, &cycles[0], [0.25, -0.25], 20, |_| ControlFlow::Continue(()));
    assert_eq!((branch.turns.len(), branch.turns[0].change), (1, BranchChange::Fold), "{:?}", branch.turns);
    assert!(branch.turns[0].parameter.abs() < 1e-7, "{:?}", branch.turns);
    let last = branch.points.last().expect("points");
    assert!(last.parameter > 0.0 && last.cycle.points[0][3] < 0.0 && !branch.is_cut, "{last:?}");
}

kahan! {
    /// A conservative oscillator: x'² + x² − (2/3)x³ is constant.
    struct Swing;
    xdot = y;
    ydot = x^2 - x;
}

#[test]
fn families_and_steady_states_are_told() {
    let map = |eps| Swing.at(Dual::coordinate(eps, 0));
    assert_eq!(flow_cycle(map, &[0.3, 0.0], 0.032, 100), Err(NoPeriodicPoint::Family));
    let map = |eps| Rossler { c: Dual::from_value(2.5) }.at(Dual::coordinate(eps, 0));
    assert_eq!(flow_cycle(map, &[0.016, -0.08, 0.081], 0.03, 100), Err(NoPeriodicPoint::Still));
    assert_eq!(flow_cycle(map, &[1.0, 1.0, 1.0], 0.0, 100), Err(NoPeriodicPoint::Unfit));
}
