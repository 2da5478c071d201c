//! Compares Kahan's map of KdV and the implicit midpoint rule, both with the same banded solver.
//! Newton's method for the midpoint rule solves linear systems with the matrix of Kahan's map. The
//! preparation of the solver is not timed.

use std::time::{Duration, Instant};

use kahan_core::__private::{Boundary, Sizes, Stencil};
use kahan_core::{LatticeMap, Scalar};

use crate::families::Kdv;

/// The linear system of a Newton step for the KdV equation. It has Kahan's matrix and the
/// right-hand side `right`.
#[derive(Clone, Debug)]
struct Newton {
    kdv: Kdv<f64>,
    right: Vec<f64>,
}

impl LatticeMap<f64> for Newton {
    const ARRAYS: &'static [&'static str] = &["u"];
    const REACH: usize = 2;
    const SITE_PARAMETERS: &'static [&'static str] = &["right"];

    type Kernels = Stencil<1, 2, 1, 6, 2, 2, 5, 5>;

    fn sizes(&self) -> Sizes {
        Self::Kernels::SIZES
    }

    fn boundary(&self) -> Boundary {
        Boundary::Periodic
    }

    fn constants<L: Scalar>(&self, eps: L, convert: impl Fn(&f64) -> L) -> Option<Vec<L>> {
        self.kdv.constants(eps, convert)
    }

    fn site_parameter(&self, _index: usize) -> &[f64] {
        &self.right
    }

    #[inline(always)]
    fn rows<L: Scalar>(&self, constants: &[L], x: &[L], c: &[L], _: &mut [L], f: &mut [L], a: &mut [L]) {
        self.kdv.rows(constants, x, &[], &mut [], f, a);
        f[0] = c[2].clone();
    }
}

/// Prints the error after a time of 1, and the processor time, for several step sizes.
pub(crate) fn table() {
    let (sites, h, time) = (512, 0.2, 1.0);
    let start: Vec<f64> = (0..sites)
        .map(|i| {
            let soliton =
                |speed: f64, at: f64| 0.5 * speed / (0.5 * speed.sqrt() * (h * i as f64 - at)).cosh().powi(2);
            soliton(4.0, 30.0) + soliton(1.0, 50.0)
        })
        .collect();
    let reference = runge_kutta(&Kdv { h }, &start, time, 20_000);
    println!(
        "| steps | Kahan: error | time, ms | midpoint: error | Newton's iterations a step | time, ms | time at equal error, midpoint/Kahan |"
    );
    println!("|---:|---:|---:|---:|---:|---:|---:|");
    for steps in [100, 200, 400, 800, 1600] {
        let eps = 0.5 * time / f64::from(steps);
        let (kahan, kahan_time) = kahan(&Kdv { h }, &start, eps, steps);
        let (midpoint, midpoint_time, iterations) = midpoint(h, &start, eps, steps);
        let errors = [error(&kahan, &reference), error(&midpoint, &reference)];
        let times = [kahan_time, midpoint_time].map(|time| time.as_secs_f64() * 1e3);
        // Both orders are 2, so the time for a given error is proportional to time · √error.
        let ratio = times[1] * errors[1].sqrt() / (times[0] * errors[0].sqrt());
        println!(
            "| {steps} | {:.1e} | {:.2} | {:.1e} | {:.2} | {:.2} | {ratio:.2} |",
            errors[0],
            times[0],
            errors[1],
            f64::from(iterations) / f64::from(steps),
            times[1]
        );
    }
}

fn error(x: &[f64], reference: &[f64]) -> f64 {
    x.iter().zip(reference).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn kahan(map: &Kdv<f64>, start: &[f64], eps: f64, steps: u32) -> (Vec<f64>, Duration) {
    let at = map.at(eps, start.len()).expect("a chain");
    let mut least = Duration::MAX;
    let mut end = Vec::new();
    for _ in 0..5 {
        let mut state = start.to_vec();
        let begun = Instant::now();
        at.advance(&mut state, steps.into());
        least = least.min(begun.elapsed());
        end = state;
    }
    (end, least)
}

fn midpoint(h: f64, start: &[f64], eps: f64, steps: u32) -> (Vec<f64>, Duration, u32) {
    let sites = start.len();
    let (mut x, mut velocity) = (start.to_vec(), field(start, h));
    let (mut time, mut iterations) = (Duration::ZERO, 0);
    for _ in 0..steps {
        let mut m: Vec<f64> = x.iter().zip(&velocity).map(|(x, v)| x + eps * v).collect();
        for _ in 0..20 {
            let begun = Instant::now();
            let f = field(&m, h);
            let right = m.iter().zip(&x).zip(&f).map(|((m, x), f)| -(m - x - eps * f)).collect();
            let evaluated = begun.elapsed();
            let mut at = Newton { kdv: Kdv { h }, right }.at(eps, sites).expect("a chain");
            let mut next = m.clone();
            at.step(&mut next);
            next.clone_from(&m);
            let begun = Instant::now();
            at.step(&mut next);
            time += begun.elapsed() + evaluated;
            iterations += 1;
            // The step adds 2ε times `change`, the solution of Newton's linear system.
            let change: Vec<f64> = next.iter().zip(&m).map(|(next, m)| (next - m) / (2.0 * eps)).collect();
            m.iter_mut().zip(&change).for_each(|(m, change)| *m += change);
            if change.iter().all(|change| change.abs() < 1e-12) {
                break;
            }
        }
        for ((x, m), v) in x.iter_mut().zip(&m).zip(&mut velocity) {
            let next = 2.0 * m - *x;
            *v = (next - *x) / (2.0 * eps);
            *x = next;
        }
    }
    (x, time, iterations)
}

fn field(u: &[f64], h: f64) -> Vec<f64> {
    let n = u.len();
    let (advection, dispersion) = (1.5 / h, 0.5 / (h * h * h));
    let at = |i: usize| {
        let [a, b, c, d] = [u[(i + n - 2) % n], u[(i + n - 1) % n], u[(i + 1) % n], u[(i + 2) % n]];
        -advection * (c * c - b * b) - dispersion * (d - 2.0 * c + 2.0 * b - a)
    };
    let mut f = vec![0.0; n];
    for (i, f) in f.iter_mut().enumerate().take(n - 2).skip(2) {
        let [a, b, c, d] = [u[i - 2], u[i - 1], u[i + 1], u[i + 2]];
        *f = -advection * (c * c - b * b) - dispersion * (d - 2.0 * c + 2.0 * b - a);
    }
    for i in [0, 1, n - 2, n - 1] {
        f[i] = at(i);
    }
    f
}

fn runge_kutta(map: &Kdv<f64>, start: &[f64], time: f64, steps: u32) -> Vec<f64> {
    let at = map.at(1.0, start.len()).expect("a chain");
    let dt = time / f64::from(steps);
    let moved =
        |x: &[f64], by: f64, v: &[f64]| -> Vec<f64> { x.iter().zip(v).map(|(x, v)| x + by * v).collect() };
    let mut x = start.to_vec();
    for _ in 0..steps {
        let a = at.field(&x);
        let b = at.field(&moved(&x, 0.5 * dt, &a));
        let c = at.field(&moved(&x, 0.5 * dt, &b));
        let d = at.field(&moved(&x, dt, &c));
        for (k, x) in x.iter_mut().enumerate() {
            *x += dt / 6.0 * (a[k] + 2.0 * (b[k] + c[k]) + d[k]);
        }
    }
    x
}
