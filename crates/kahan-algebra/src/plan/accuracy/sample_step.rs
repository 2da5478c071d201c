//! Draws sample points, and computes steps by elimination with partial pivoting.

use crate::field::Field;
use crate::kahan::field_jacobian;
use crate::plan::plan_of;
use crate::prime_field::SplitMix64;

use super::super::Plan;
use super::float_plan::{FloatPlan, SHORT_UNIT, short};

#[derive(Debug)]
pub(super) struct SampleStep {
    pub(super) inputs: Vec<f64>,
    /// The image x̃ by elimination in `f64`, from which errors are measured.
    pub(super) next: Vec<f64>,
    /// The error of elimination in 30 bits, as a multiple of the unit roundoff.
    pub(super) elimination: f64,
}

pub(super) struct Elimination<'a> {
    states: usize,
    parameters: usize,
    /// The numerators of f′ row by row, the numerators of f, and the denominators of f.
    values: FloatPlan<'a>,
}

impl SampleStep {
    /// Draws a point at which ‖εf′‖∞ is near `size`. States are drawn from a cube of random half
    /// width from 2⁻³ to 2¹⁰, and parameters have absolute values from 1/2 to 2. Returns `None` if
    /// f′ or det A vanishes.
    pub(super) fn draw(elimination: &Elimination<'_>, size: f64, random: &mut SplitMix64) -> Option<Self> {
        let Elimination { states, parameters, .. } = *elimination;
        let width = 2_f64.powi(random.below(14) as i32 - 3);
        let mut inputs = Vec::with_capacity(states + parameters + 1);
        for index in 0..states + parameters {
            let share = share(random);
            let drawn = if index < states { width * share } else { 0.5 + 1.5 * share };
            inputs.push(if random.below(2) == 0 { -drawn } else { drawn });
        }
        inputs.push(0.0);
        let exact = |value: f64| value;
        let rows = elimination.rows(exact, &inputs);
        let mut norm = 0.0_f64;
        for row in rows.chunks_exact(states + 1) {
            let (mut sum, mut j) = (0.0, 0);
            while j < states {
                sum += row[j].abs();
                j += 1;
            }
            norm = norm.max(sum);
        }
        // At ε‖f′‖∞ = 1, A may be singular. A random factor avoids this value.
        let eps = short(size * (0.75 + 0.5 * share(random)) / norm);
        if !eps.is_normal() {
            return None;
        }
        inputs[states + parameters] = eps;
        let exactly = next(exact, rows, &inputs, eps, states);
        let in_short = next(short, elimination.rows(short, &inputs), &inputs, eps, states);
        let mut trial = SampleStep { inputs, next: exactly, elimination: 0.0 };
        trial.elimination = trial.error_from(0, &in_short);
        trial.elimination.is_finite().then_some(trial)
    }

    /// Returns the largest error of the components from `first` on, divided by the largest of these
    /// components and by the unit roundoff.
    pub(super) fn error_from(&self, first: usize, next: &[f64]) -> f64 {
        let (mut size, mut off) = (0.0_f64, 0.0_f64);
        for (exact, computed) in self.next[first..].iter().zip(next) {
            let difference = (computed - exact).abs();
            size = size.max(exact.abs());
            off = if difference.is_finite() { off.max(difference) } else { f64::INFINITY };
        }
        off / (size * SHORT_UNIT)
    }
}

fn share(random: &mut SplitMix64) -> f64 {
    random.below(1 << 20) as f64 / f64::from(1 << 20)
}

impl<'a> Elimination<'a> {
    pub(super) fn plan(field: &Field) -> Plan {
        let jacobian = field_jacobian(field);
        plan_of(jacobian.iter().flatten().chain(field.numerators()).chain(field.denominators()))
    }

    pub(super) fn of(field: &Field, plan: &'a Plan) -> Self {
        let (states, parameters) = (field.dimension(), field.symbols.parameters.len());
        Elimination { states, parameters, values: FloatPlan::of(plan) }
    }

    fn rows(&self, round: impl Fn(f64) -> f64 + Copy, inputs: &[f64]) -> Vec<f64> {
        let (n, width) = (self.states, self.states + 1);
        let values: &[f64] = &self.values.run(round, inputs, &[]);
        let mut all = vec![0.0; n * width];
        let rows: &mut [f64] = &mut all;
        let (mut i, mut j) = (0, 0);
        while i < n {
            let value = if j < n { values[i * n + j] } else { values[n * n + i] };
            rows[i * width + j] = round(value / values[n * width + i]);
            j += 1;
            if j == width {
                (i, j) = (i + 1, 0);
            }
        }
        all
    }
}

/// Returns x̃ = x + 2ε A⁻¹f from the rows of f′ and f.
fn next(round: impl Fn(f64) -> f64 + Copy, mut rows: Vec<f64>, x: &[f64], eps: f64, n: usize) -> Vec<f64> {
    let matrix: &mut [f64] = &mut rows;
    let (mut i, mut j) = (0, 0);
    while i < n {
        let entry = &mut matrix[i * (n + 1) + j];
        *entry = -round(eps * *entry);
        if i == j {
            *entry = round(1.0 + *entry);
        }
        j += 1;
        if j == n {
            (i, j) = (i + 1, 0);
        }
    }
    let mut next = solve_rows(round, matrix, n);
    for (slope, x) in next.iter_mut().zip(x) {
        *slope = round(x + round(2.0 * eps * *slope));
    }
    next
}

fn solve_rows(round: impl Fn(f64) -> f64 + Copy, rows: &mut [f64], n: usize) -> Vec<f64> {
    let width = n + 1;
    for k in 0..n {
        exchange_pivot_row(rows, k, width);
        let (above, below) = rows.split_at_mut((k + 1) * width);
        let above = &above[k * width..];
        for row in below.chunks_exact_mut(width) {
            if row[k] == 0.0 {
                continue;
            }
            let factor = round(row[k] / above[k]);
            let mut j = k + 1;
            while j < width {
                row[j] = round(row[j] - round(factor * above[j]));
                j += 1;
            }
        }
    }
    let mut all = vec![0.0; n];
    let solution: &mut [f64] = &mut all;
    for k in (0..n).rev() {
        let row = &rows[k * width..];
        let mut rest = row[n];
        let mut j = k + 1;
        while j < n {
            rest = round(rest - round(row[j] * solution[j]));
            j += 1;
        }
        solution[k] = round(rest / row[k]);
    }
    all
}

/// Exchanges row k with the row whose entry in column k is largest.
fn exchange_pivot_row(rows: &mut [f64], k: usize, width: usize) {
    let (mut pivot, mut i) = (k, k + 1);
    while i * width < rows.len() {
        if rows[i * width + k].abs() > rows[pivot * width + k].abs() {
            pivot = i;
        }
        i += 1;
    }
    if pivot > k {
        let (above, below) = rows.split_at_mut(pivot * width);
        above[k * width..(k + 1) * width].swap_with_slice(&mut below[..width]);
    }
}
