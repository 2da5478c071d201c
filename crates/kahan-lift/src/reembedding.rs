//! Symmetric projection onto the relations of a lift (E. Hairer, "Symmetric projection methods for
//! differential equations on manifolds", BIT 40, 2000).

use crate::embedding::{CalledFunction, Embedding, Operation};
use crate::ring::Function;

const MOST_EVALUATIONS: usize = 40;
/// Relative errors of at most this number times 2⁻⁵² count as rounding errors.
const ROUNDING_UNITS: f64 = 8.0;

/// Steps of a lifted map with symmetric projection onto relations w = g(x).
///
/// The map advances states x and new variables w. A step begins at (x, g(x) + μ). The shift μ is
/// chosen such that the image (x̃, w̃) of this point satisfies w̃ + μ = g(x̃). Reversible maps stay
/// reversible, and composed maps keep their order of accuracy.
#[derive(Clone, Debug, Default)]
pub struct Reembedding {
    /// The shift μ of the previous step, used as initial guess.
    shift: Vec<f64>,
    image: Vec<f64>,
}

impl Reembedding {
    /// Advances `states` by one step. Returns whether the iteration converged. Without convergence,
    /// the states do not change.
    ///
    /// The closure `step` replaces all variables by their images under the lifted map, and `embed`
    /// returns the new variables at given states. The iteration usually calls `step` 2 to 16 times.
    pub fn step(
        &mut self,
        states: &mut [f64],
        mut embed: impl FnMut(&[f64]) -> Vec<f64>,
        mut step: impl FnMut(&mut [f64]),
    ) -> bool {
        let new = embed(states);
        self.shift.resize(new.len(), 0.0);
        let mut before = f64::INFINITY;
        for _ in 0..MOST_EVALUATIONS {
            self.image.clear();
            self.image.extend_from_slice(states);
            self.image.extend(new.iter().zip(&self.shift).map(|(value, shift)| value + shift));
            step(&mut self.image);
            let (reached, lifted) = self.image.split_at(states.len());
            let wanted = embed(reached);
            // The largest relative error of a relation.
            let mut error = 0.0_f64;
            for (((new, wanted), value), shift) in new.iter().zip(&wanted).zip(lifted).zip(&mut self.shift) {
                let difference = wanted - value - *shift;
                let size = new.abs() + wanted.abs() + value.abs() + shift.abs();
                error = error.max(if size > 0.0 { difference.abs() / size } else { 0.0 });
                *shift += difference / 2.0;
            }
            if !error.is_finite() || !reached.iter().all(|value| value.is_finite()) {
                break;
            }
            // Stops if the error is at rounding level, or if it is near this level and no longer
            // decreases.
            let is_rounding = error <= ROUNDING_UNITS * f64::EPSILON;
            if is_rounding || (error >= before && before <= 1e3 * f64::EPSILON) {
                states.copy_from_slice(reached);
                return true;
            }
            before = error;
        }
        self.shift.fill(0.0);
        false
    }
}

impl Embedding {
    /// Returns the indices of new variables that are positive by definition. Examples are square
    /// roots, exponentials, and products of positive variables.
    #[must_use]
    pub fn positive(&self) -> Vec<usize> {
        let operations = &self.program.operations;
        let mut positive: Vec<bool> = Vec::with_capacity(operations.len());
        for operation in operations {
            positive.push(match operation {
                Operation::Call(function, a, exponent) => match function {
                    CalledFunction::SquareRoot
                    | CalledFunction::Elementary(Function::Exp | Function::Cosh) => true,
                    // Real powers are positive, except with exponents 1/n for odd n.
                    CalledFunction::RealPower => !matches!(
                        &operations[exponent.0],
                        Operation::Constant(value) if value.to_f64().recip().round() % 2.0 != 0.0
                    ),
                    CalledFunction::Power(_) => positive[a.0],
                    CalledFunction::CubeRoot | CalledFunction::Elementary(_) => false,
                },
                Operation::Constant(value) => value.to_f64() > 0.0,
                Operation::Add(a, b) | Operation::Multiply(a, b) | Operation::Divide(a, b) => {
                    positive[a.0] && positive[b.0]
                }
                _ => false,
            });
        }
        let places = self.program.outputs.iter().enumerate();
        places.filter(|(_, value)| positive[value.0]).map(|(place, _)| place).collect()
    }
}
