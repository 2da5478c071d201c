//! Kahan's map modulo a prime, with residues as parameters and ε.
//!
//! A step solves a linear system with the matrix A(x,ε) = I − ε f′(x). Points with singular A count
//! as poles, even if the reduced map is defined there. At random ε, a random point is almost never
//! a pole.

use crate::integrals::parity::sign_changes;
use crate::maps::modular_step::ModularStep;
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;

/// A term c·xⱼxₖ, c·xⱼ or c in one component of the field f.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    pub(crate) component: usize,
    pub(crate) coefficient: u64,
    pub(crate) first: Option<usize>,
    pub(crate) second: Option<usize>,
}

/// The result of a step.
#[derive(Clone, Debug)]
pub struct Step {
    /// The next point x̃.
    pub next: Vec<u64>,
    /// The Jacobian determinant det ∂x̃/∂x = det A(x̃,−ε) / det A(x,ε), with A(x,ε) = I − ε f′(x).
    pub jacobian: u64,
}

/// The map of one field at one ε.
#[derive(Clone, Debug)]
pub struct ModularMap {
    modulus: Modulus,
    dimension: usize,
    eps: u64,
    terms: Vec<Term>,
}

impl ModularStep for ModularMap {
    fn modulus(&self) -> &Modulus {
        &self.modulus
    }

    fn dimension(&self) -> usize {
        self.dimension
    }

    fn sign_changes(&self) -> Vec<u64> {
        let bit = |state: Option<usize>| state.map_or(0, |state| 1u64.checked_shl(state as u32).unwrap_or(0));
        let signs = |term: &Term| bit(Some(term.component)) ^ bit(term.first) ^ bit(term.second);
        sign_changes(self.dimension, &self.terms.iter().map(signs).collect::<Vec<_>>())
    }

    fn next(&self, point: &[u64]) -> Option<Vec<u64>> {
        self.solve(point, self.eps).map(|(next, _)| next)
    }
}

impl ModularMap {
    pub(crate) fn new(modulus: Modulus, dimension: usize, eps: u64, terms: Vec<Term>) -> Self {
        ModularMap { modulus, dimension, eps, terms }
    }

    /// Returns ε, half the time step.
    #[must_use]
    pub fn eps(&self) -> u64 {
        self.eps
    }

    /// Returns the map with another ε and unchanged coefficients. The map at −ε is the inverse.
    #[must_use]
    pub fn with_eps(&self, eps: u64) -> Self {
        ModularMap { eps, ..self.clone() }
    }

    /// Returns x̃ and the Jacobian determinant. Returns `None` at a pole, where I − ε f′(x) is
    /// singular.
    #[must_use]
    pub fn step(&self, point: &[u64]) -> Option<Step> {
        let (next, determinant) = self.solve(point, self.eps)?;
        let back = match self.solve(&next, self.modulus.opposite(self.eps)) {
            Some((_, back)) => back,
            None => 0,
        };
        let jacobian = self.modulus.times(back, self.modulus.inverse(determinant)?);
        Some(Step { next, jacobian })
    }

    /// Returns ∂x̃/∂x = A(x,ε)⁻¹ A(x̃,−ε) row by row, with A(x,ε) = I − ε f′(x). Returns `None`
    /// where A(x,ε) is singular.
    #[must_use]
    pub fn jacobian(&self, point: &[u64], next: &[u64]) -> Option<Vec<Vec<u64>>> {
        let n = self.dimension;
        let here = self.extended_matrix(point, self.eps);
        let there = self.extended_matrix(next, self.modulus.opposite(self.eps));
        let rows = here.chunks(n + 1).zip(there.chunks(n + 1));
        let rows = rows.map(|(left, right)| [&left[..n], &right[..n]].concat()).collect();
        let echelon = Echelon::of(&self.modulus, rows, 2 * n);
        if echelon.rank_of_first(n) < n {
            return None;
        }
        Some(echelon.rows.iter().map(|row| row[n..].to_vec()).collect())
    }

    /// Returns det(I − ε f′(x)) for any ε.
    #[must_use]
    pub fn determinant(&self, point: &[u64], eps: u64) -> u64 {
        self.solve(point, eps).map_or(0, |(_, determinant)| determinant)
    }

    /// Returns the field f(x), and the Jacobian matrix f′(x) row by row.
    #[must_use]
    pub fn field(&self, point: &[u64]) -> (Vec<u64>, Vec<Vec<u64>>) {
        let n = self.dimension;
        // At ε = −1 the matrix I − ε f′ is I + f′. Subtraction of I gives f′.
        let matrix = self.extended_matrix(point, self.modulus.opposite(self.modulus.one()));
        let mut values = Vec::with_capacity(n);
        let mut slopes = Vec::with_capacity(n);
        for (i, row) in matrix.chunks(n + 1).enumerate() {
            let mut slope = row[..n].to_vec();
            slope[i] = self.modulus.minus(slope[i], self.modulus.one());
            slopes.push(slope);
            values.push(row[n]);
        }
        (values, slopes)
    }

    pub(crate) fn terms(&self) -> &[Term] {
        &self.terms
    }

    pub(crate) fn components(&self) -> Vec<Vec<Term>> {
        let mut components = vec![Vec::new(); self.dimension];
        for term in &self.terms {
            components[term.component].push(*term);
        }
        components
    }

    fn extended_matrix(&self, point: &[u64], eps: u64) -> Vec<u64> {
        let (modulus, n) = (&self.modulus, self.dimension);
        let width = n + 1;
        let minus_eps = modulus.opposite(eps);
        let mut matrix = vec![0; n * width];
        for i in 0..n {
            matrix[i * width + i] = modulus.one();
        }
        for term in &self.terms {
            let row = &mut matrix[term.component * width..][..width];
            let slope = modulus.times(minus_eps, term.coefficient);
            let value = match (term.first, term.second) {
                (Some(j), Some(k)) => {
                    row[j] = modulus.plus(row[j], modulus.times(slope, point[k]));
                    row[k] = modulus.plus(row[k], modulus.times(slope, point[j]));
                    modulus.times(term.coefficient, modulus.times(point[j], point[k]))
                }
                (Some(j), None) => {
                    row[j] = modulus.plus(row[j], slope);
                    modulus.times(term.coefficient, point[j])
                }
                _ => term.coefficient,
            };
            row[n] = modulus.plus(row[n], value);
        }
        matrix
    }

    /// Returns x̃ = x + 2ε A⁻¹f and det A for A = I − ε f′(x). The elimination needs one inversion.
    fn solve(&self, point: &[u64], eps: u64) -> Option<(Vec<u64>, u64)> {
        let (modulus, n) = (&self.modulus, self.dimension);
        let width = n + 1;
        let mut matrix = self.extended_matrix(point, eps);
        let mut is_negative = false;
        let mut multiplied = vec![0u32; n];
        for k in 0..n {
            let found = (k..n).find(|&row| matrix[row * width + k] != 0)?;
            if found != k {
                let (above, below) = matrix.split_at_mut(found * width);
                above[k * width..][..width].swap_with_slice(&mut below[..width]);
                is_negative = !is_negative;
            }
            let (above, below) = matrix.split_at_mut((k + 1) * width);
            let pivot_row = &above[k * width..];
            for row in below.chunks_mut(width) {
                let factor = row[k];
                if factor == 0 {
                    continue;
                }
                multiplied[k] += 1;
                for (entry, pivot) in row[k..].iter_mut().zip(&pivot_row[k..]) {
                    *entry =
                        modulus.minus(modulus.times(*entry, pivot_row[k]), modulus.times(factor, *pivot));
                }
            }
        }
        let mut inverses: Vec<u64> = (0..n).map(|k| matrix[k * width + k]).collect();
        if !modulus.invert_all(&mut inverses) {
            return None;
        }
        let mut determinant = modulus.one();
        for k in 0..n {
            determinant = modulus.times(determinant, matrix[k * width + k]);
            determinant = modulus.times(determinant, modulus.power(inverses[k], multiplied[k]));
        }
        let mut slopes = vec![0; n];
        for k in (0..n).rev() {
            let row = &matrix[k * width..][..width];
            let mut sum = row[n];
            for (entry, slope) in row[k + 1..n].iter().zip(&slopes[k + 1..]) {
                sum = modulus.minus(sum, modulus.times(*entry, *slope));
            }
            slopes[k] = modulus.times(sum, inverses[k]);
        }
        let two_eps = modulus.plus(eps, eps);
        let moved = point.iter().zip(&slopes).map(|(x, v)| modulus.plus(*x, modulus.times(two_eps, *v)));
        let signed = if is_negative { modulus.opposite(determinant) } else { determinant };
        Some((moved.collect(), signed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::maps::parametric_field::ParametricField;
    use kahan_algebra::interpret::{Interpreter, Point};
    use kahan_algebra::prime_field::SplitMix64;
    use kahan_algebra::{lexer, read};

    #[test]
    fn steps_and_jacobians_are_those_of_the_interpreter() {
        let fields = [
            "xdot = a*y*z + x; ydot = z*x/b - 2; zdot = x*y + b*x^2;",
            "xdot = y; ydot = 0; zdot = w*x; wdot = 1/2*x*y + z;",
        ];
        for text in fields {
            let system = read(&lexer::lex(text).tokens).system().expect("a system");
            let mut random = SplitMix64::new(3);
            let modulus = Modulus::random(&mut random);
            let parameters: Vec<u64> =
                system.field.symbols.parameters.iter().map(|_| modulus.sample(&mut random)).collect();
            let eps = modulus.sample(&mut random);
            let map = ParametricField::of(&system.field).at(modulus, &parameters, eps).unwrap();
            let state = map.point(&mut random);
            let step = map.step(&state).unwrap();
            let there =
                Interpreter::new(&system).evaluate(&modulus, &Point { state, parameters, eps }).unwrap();
            assert_eq!(Some(step.next), there.next);
            assert_eq!(Some(step.jacobian), there.det_jacobian);
        }
    }
}
