//! Computes the growth of errors of a lift's relations along an orbit.
//!
//! Let x′ = F(x,w), w′ = G(x,w) be a lifted field with states x and new variables w = g(x). Along
//! the orbit, small errors r = w − g(x) satisfy, to first order, r′ = Λ r with
//!
//!   Λ = ∂G/∂w − g′(x) · ∂F/∂w
//!
//! A lift is stable if, up to t = 100, errors grow at most 10-fold and at a mean rate up to 0.01.

use crate::embedding::Builder;
use crate::energy::slopes;
use crate::laurent::Laurent;
use crate::quadratic::Quadratic;
use crate::ring::Ring;

const HORIZON: f64 = 100.0;
pub(crate) const LARGEST_EXPONENT: f64 = 0.01;
pub(crate) const LARGEST_AMPLIFICATION: f64 = 10.0;
/// The computation ends when errors have grown by this factor.
const MAX_AMPLIFICATION: f64 = 1e8;
const MOST_POINTS: usize = 20_000;
/// For the exponential of a matrix, a step is divided into at most this many substeps.
const MOST_PARTS: f64 = 64.0;
/// The tolerance of a step, relative to the largest component of the state.
const TOLERANCE: f64 = 1e-6;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ErrorGrowth {
    /// The mean rate of exponential growth, per unit of time.
    pub(crate) exponent: f64,
    pub(crate) amplification: f64,
    half: f64,
}

impl ErrorGrowth {
    pub(crate) fn is_stable(&self) -> bool {
        self.exponent <= LARGEST_EXPONENT && self.amplification <= LARGEST_AMPLIFICATION
    }

    /// Returns whether errors grow at most in proportion to time, and not exponentially.
    pub(crate) fn is_polynomial(&self) -> bool {
        self.amplification <= 3.0 * self.half
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Orbit {
    /// The step sizes, each with the state in the middle of the step.
    points: Vec<(f64, Vec<f64>)>,
    parameters: Vec<f64>,
}

fn advanced(x: &[f64], slope: &[f64], time: f64) -> Vec<f64> {
    x.iter().zip(slope).map(|(x, slope)| x + time * slope).collect()
}

fn runge_kutta(field: impl Fn(&[f64]) -> Vec<f64>, x: &[f64], h: f64) -> Vec<f64> {
    let a = field(x);
    let b = field(&advanced(x, &a, h / 2.0));
    let c = field(&advanced(x, &b, h / 2.0));
    let d = field(&advanced(x, &c, h));
    (0..x.len()).map(|i| x[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i])).collect()
}

/// Multiplies square matrices, row by row. The left matrix is sparse.
fn multiply(left: &[f64], right: &[f64], product: &mut [f64], count: usize) {
    product.fill(0.0);
    for (place, &factor) in left.iter().enumerate().filter(|(_, factor)| **factor != 0.0) {
        let (row, of) = (place / count * count, place % count * count);
        for k in 0..count {
            product[row + k] += factor * right[of + k];
        }
    }
}

impl Orbit {
    /// Computes the orbit up to the time `HORIZON` while it is finite.
    pub(crate) fn new(ring: &Ring, start: &[f64], parameters: &[f64]) -> Self {
        let field = Builder::embedding(ring, &ring.field);
        let field = |x: &[f64]| field.values(x, parameters);
        let (mut x, mut time, mut h) = (start.to_vec(), 0.0, 0.01);
        let mut points = Vec::new();
        while time < HORIZON && points.len() < MOST_POINTS {
            let whole = runge_kutta(field, &x, h);
            let half = runge_kutta(field, &x, h / 2.0);
            let next = runge_kutta(field, &half, h / 2.0);
            let size = next.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
            let error = next.iter().zip(&whole).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            if !(error.is_finite() && size.is_finite()) || error > TOLERANCE * size {
                h /= 2.0;
                if h < 1e-9 {
                    break;
                }
                continue;
            }
            time += h;
            points.push((h, half));
            x = next;
            if error < TOLERANCE * size / 50.0 {
                h = (2.0 * h).min(0.05);
            }
        }
        Orbit { points, parameters: parameters.to_vec() }
    }

    /// Computes the growth of errors along the orbit. The list `field` has the equations of the
    /// states, then those of the new variables.
    pub(crate) fn growth(&self, ring: &Ring, new: &[Laurent], field: &[Quadratic]) -> ErrorGrowth {
        let (states, count) = (ring.field.len(), new.len());
        if count == 0 {
            return ErrorGrowth { exponent: 0.0, amplification: 1.0, half: 1.0 };
        }
        // First come the derivatives of `new` by the states, then those of the equations by `new`.
        let mut entries = slopes(ring, states, new.iter());
        for equation in &field[..states + count] {
            for k in 0..count {
                let mut entry = Laurent::zero();
                for (variable, factor) in equation.partial(states + k).terms() {
                    let new =
                        variable.powers().next().and_then(|(index, _)| new.get(index.checked_sub(states)?));
                    entry.add_scaled(new.unwrap_or(&Laurent::from(variable.clone())), factor);
                }
                entries.push(entry);
            }
        }
        let entries = Builder::embedding(ring, &entries);
        let functions = Builder::embedding(ring, new);
        let mut matrix: Vec<f64> =
            (0..count * count).map(|place| if place % (count + 1) == 0 { 1.0 } else { 0.0 }).collect();
        let [mut first, mut second] = [matrix.clone(), matrix.clone()];
        // Errors are divided by the largest values of the variables, so that scales do not matter.
        let mut sizes = vec![0.0_f64; count];
        for (_, x) in &self.points {
            let values = functions.values(x, &self.parameters);
            sizes.iter_mut().zip(values).for_each(|(size, value)| *size = size.max(value.abs()));
        }
        let scale =
            |i: usize, k: usize| if sizes[i] > 0.0 && sizes[k] > 0.0 { sizes[k] / sizes[i] } else { 1.0 };
        let largest = |matrix: &[f64]| {
            let entries = (0..count).flat_map(|i| (0..count).map(move |k| (i, k)));
            entries.fold(0.0, |norm: f64, (i, k)| norm.max(matrix[i * count + k].abs() * scale(i, k)))
        };
        let hopeless = libm::log(MAX_AMPLIFICATION);
        let (mut logarithm, mut last, mut most, mut half, mut time) = (0.0, 0.0, 0.0_f64, 0.0_f64, 0.0);
        for (h, x) in &self.points {
            let values = entries.values(x, &self.parameters);
            let (slopes, jacobian) = values.split_at(count * states);
            let (of_states, of_new) = jacobian.split_at(count * states);
            let mut lambda = of_new.to_vec();
            for (row, slopes) in lambda.chunks_exact_mut(count).zip(slopes.chunks_exact(states)) {
                for (slope, moved) in slopes.iter().zip(of_states.chunks_exact(count)) {
                    row.iter_mut().zip(moved).for_each(|(entry, moved)| *entry -= slope * moved);
                }
            }
            // With Λ = `lambda`, a step h is divided into substeps of size s, with s‖Λ‖ ≤ 1/2 if
            // not too many are needed. Then exp(hΛ) is about (1 + sΛ + (sΛ)²/2)^(h/s).
            let size = lambda.chunks_exact(count).map(|row| row.iter().map(|entry| entry.abs()).sum::<f64>());
            let parts = (2.0 * h * size.fold(0.0, f64::max)).ceil().clamp(1.0, MOST_PARTS);
            let part = h / parts;
            for _ in 0..parts as usize {
                multiply(&lambda, &matrix, &mut first, count);
                multiply(&lambda, &first, &mut second, count);
                for place in 0..matrix.len() {
                    matrix[place] += part * first[place] + part * part / 2.0 * second[place];
                }
            }
            let norm = largest(&matrix);
            if norm == 0.0 {
                break;
            }
            time += h;
            if !norm.is_finite() {
                return ErrorGrowth { exponent: f64::INFINITY, amplification: f64::INFINITY, half: 1.0 };
            }
            last = logarithm + libm::log(norm);
            most = most.max(last);
            if time <= HORIZON / 2.0 {
                half = most;
            }
            if most > hopeless && most / time > 10.0 * LARGEST_EXPONENT {
                return ErrorGrowth { exponent: most / time, amplification: libm::exp(most), half: 1.0 };
            }
            if !(1e-100..1e100).contains(&norm) && norm > 0.0 {
                logarithm += libm::log(norm);
                matrix.iter_mut().for_each(|entry| *entry /= norm);
            }
        }
        let exponent = if time > 0.0 { last / time } else { 0.0 };
        ErrorGrowth { exponent, amplification: libm::exp(most), half: libm::exp(half) }
    }
}
