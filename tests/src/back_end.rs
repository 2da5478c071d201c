//! A trait for generated code and for the run-time interpreter, so that one test suite runs on
//! both. All numbers are exact. A method returns `None` where the map or a claim is undefined.

mod generated;
mod interpreter;

use crate::exact::{Matrix, Q, Vector};

pub use generated::Generated;
pub use interpreter::{Interpreted, Read};

/// The quantities of Kahan's method for a system, each evaluated at a point.
pub trait BackEnd {
    /// Returns the back end's name, for messages.
    fn label(&self) -> String;
    /// Returns the field f(x).
    fn field(&self, x: &[Q]) -> Vector;
    /// Returns the Jacobian matrix f′(x) of the field.
    fn field_jacobian(&self, x: &[Q]) -> Matrix;
    /// Returns Q(x,y), the symmetric bilinear form of the field's quadratic part.
    fn bilinear(&self, x: &[Q], y: &[Q]) -> Vector;
    /// Returns the polarised field, which is symmetric in x and y and equals f(x) for y = x.
    fn polarized(&self, x: &[Q], y: &[Q]) -> Vector;
    /// Returns the matrix A(x,ε) of the equation A(x,ε)x̃ = b(x,ε).
    fn matrix(&self, x: &[Q], eps: &Q) -> Matrix;
    /// Returns the right-hand side b(x,ε) of the equation A(x,ε)x̃ = b(x,ε).
    fn rhs(&self, x: &[Q], eps: &Q) -> Vector;
    /// Returns the next point x̃; `None` at a pole.
    fn step(&self, x: &[Q], eps: &Q) -> Option<Vector>;
    /// Returns the Jacobian matrix ∂x̃/∂x of the map; `None` at a pole.
    fn jacobian(&self, x: &[Q], eps: &Q) -> Option<Matrix>;
    /// Returns (∂x̃/∂x)·v for a tangent vector v, given x̃ as `next`; `None` at a pole.
    fn push_forward(&self, x: &[Q], next: &[Q], v: &[Q], eps: &Q) -> Option<Vector>;
    /// Returns the determinant of the matrix A(x,ε).
    fn det_matrix(&self, x: &[Q], eps: &Q) -> Q;
    /// Returns the determinant of ∂x̃/∂x; `None` at a pole.
    fn det_jacobian(&self, x: &[Q], eps: &Q) -> Option<Q>;
    /// Returns the numerators adj(A)·b and the denominator det A of the next point.
    fn rational_map(&self, x: &[Q], eps: &Q) -> (Vector, Q);
    /// Returns the points of an orbit before a pole, and whether a pole ended the orbit.
    fn orbit(&self, x: &[Q], eps: &Q, steps: usize) -> (Vec<Vector>, bool);
    /// Returns the integrals claimed without a condition, in order. `None` where one of them is
    /// undefined.
    fn integrals(&self, x: &[Q], eps: &Q) -> Option<Vector>;
    /// Returns the density claimed without a condition. `None` if it is undefined or not declared.
    fn density(&self, x: &[Q], eps: &Q) -> Option<Q>;
    /// Returns a bracket claimed without a condition. `None` if it is undefined or not declared.
    fn bracket(&self, name: &str, x: &[Q], eps: &Q) -> Option<Matrix>;
}
