//! A common trait of both back ends, generated code and the run-time interpreter, so that one test
//! suite runs on both. A system at given parameters, points and ε (half the time step) come in as
//! exact numbers. Every object of the method goes out as a plain vector, or as `None` where the map
//! or a claim has no value.

mod generated;
mod interpreter;

use crate::exact::{Matrix, Q, Vector};

pub use generated::Generated;
pub use interpreter::{Interpreted, Read};

/// The objects of a system at a point.
pub trait BackEnd {
    /// Returns the back end's name, for messages.
    fn label(&self) -> String;
    /// f(x)
    fn field(&self, x: &[Q]) -> Vector;
    /// f′(x)
    fn field_jacobian(&self, x: &[Q]) -> Matrix;
    /// Q(x,y)
    fn bilinear(&self, x: &[Q], y: &[Q]) -> Vector;
    /// Q(x,y) + ½B(x+y) + c
    fn polarized(&self, x: &[Q], y: &[Q]) -> Vector;
    /// A(x,ε)
    fn matrix(&self, x: &[Q], eps: &Q) -> Matrix;
    /// b(x,ε)
    fn rhs(&self, x: &[Q], eps: &Q) -> Vector;
    /// x̃; `None` at a pole.
    fn step(&self, x: &[Q], eps: &Q) -> Option<Vector>;
    /// ∂x̃/∂x; `None` at a pole.
    fn jacobian(&self, x: &[Q], eps: &Q) -> Option<Matrix>;
    /// (∂x̃/∂x)·v for a tangent vector v, given x̃ as `next`; `None` at a pole.
    fn push_forward(&self, x: &[Q], next: &[Q], v: &[Q], eps: &Q) -> Option<Vector>;
    /// det A(x,ε)
    fn det_matrix(&self, x: &[Q], eps: &Q) -> Q;
    /// det ∂x̃/∂x; `None` at a pole.
    fn det_jacobian(&self, x: &[Q], eps: &Q) -> Option<Q>;
    /// (N, D) = (adj A·b, det A)
    fn rational_map(&self, x: &[Q], eps: &Q) -> (Vector, Q);
    /// x₀, x₁, … x_steps, up to the last point before a pole, and whether a pole ended the orbit.
    fn orbit(&self, x: &[Q], eps: &Q, steps: usize) -> (Vec<Vector>, bool);
    /// The unconditional integrals in order; `None` where one has no value.
    fn integrals(&self, x: &[Q], eps: &Q) -> Option<Vector>;
    /// The unconditional density; `None` without a value or a declaration.
    fn density(&self, x: &[Q], eps: &Q) -> Option<Q>;
    /// An unconditional bracket; `None` without a value or a declaration.
    fn bracket(&self, name: &str, x: &[Q], eps: &Q) -> Option<Matrix>;
}
