//! What one asks of a system that cannot answer: rustc then says what to declare, or what to write.
//!
//! A block without an integral, without a density, or with integers for parameters has these
//! methods in place of the real ones. Their trait is implemented without arguments, `S = ()`, and
//! each method asks that [`Block`] implement it for the block S, which it never does: a call never
//! gets past the compiler, rustc shows the trait's message, and nothing is compiled. The methods
//! take `&mut self`: rustc tries methods with `&self` first, so that integrals written by hand go
//! before them, and so does the map of a system whose scalar is not inferred yet.

use core::iter::Empty;

use nalgebra::{SMatrix, SVector};

use crate::SingularStep;

/// Implements none of the traits below.
#[derive(Clone, Copy, Debug)]
pub struct Block;

fn unanswered() -> ! {
    unreachable!("no type has what this asks for")
}

/// Methods of a block without integrals.
#[diagnostic::on_unimplemented(
    message = "the block of `{S}` declares no integral",
    label = "declare one in the block: `integral H = …;`",
    note = "what is claimed `when` a relation holds is proved and listed, but cannot be called"
)]
pub trait WithoutIntegrals<S: ?Sized = (), T = ()> {
    /// Not to be called.
    fn integrals<U, const N: usize>(&mut self, _: &SVector<U, N>, _: U) -> SVector<U, 1>
    where
        Block: WithoutIntegrals<Self, U>,
    {
        unanswered()
    }
}

/// Methods of a block without a density.
#[diagnostic::on_unimplemented(
    message = "the block of `{S}` declares no density",
    label = "declare one in the block: `density rho = …;`",
    note = "what is claimed `when` a relation holds is proved and listed, but cannot be called"
)]
pub trait WithoutDensity<S: ?Sized = (), T = ()> {
    /// Not to be called.
    fn density<U, const N: usize>(&mut self, _: &SVector<U, N>, _: U) -> U
    where
        Block: WithoutDensity<Self, U>,
    {
        unanswered()
    }
}

/// Methods of a system whose parameters are integers.
#[diagnostic::on_unimplemented(
    message = "the parameters of `{S}` are integers, and a Kahan map computes with fractions",
    label = "its parameters are integers: write `1.0`, not `1`",
    note = "`f32`, `f64` and `Dd` are scalars, with the feature `exact` also `BigRational`"
)]
pub trait IntegerParameters<S: ?Sized = (), T = ()> {
    /// Not to be called.
    fn step<U, const N: usize>(&mut self, _: &SVector<U, N>, _: U) -> SVector<U, N>
    where
        Block: IntegerParameters<Self, U>,
    {
        unanswered()
    }

    /// Not to be called.
    fn step_back<U, const N: usize>(&mut self, _: &SVector<U, N>, _: U) -> SVector<U, N>
    where
        Block: IntegerParameters<Self, U>,
    {
        unanswered()
    }

    #[allow(clippy::missing_errors_doc, reason = "it returns nothing")]
    /// Not to be called.
    fn try_step<U, const N: usize>(&mut self, _: &SVector<U, N>, _: U) -> Result<SVector<U, N>, SingularStep>
    where
        Block: IntegerParameters<Self, U>,
    {
        unanswered()
    }

    /// Not to be called.
    fn orbit<U, const N: usize>(&mut self, _: SVector<U, N>, _: U) -> Empty<SVector<U, N>>
    where
        Block: IntegerParameters<Self, U>,
    {
        unanswered()
    }

    /// Not to be called.
    fn at<U>(&mut self, _: U)
    where
        Block: IntegerParameters<Self, U>,
    {
        unanswered()
    }

    /// Not to be called.
    fn field<U, const N: usize>(&mut self, _: &SVector<U, N>) -> SVector<U, N>
    where
        Block: IntegerParameters<Self, U>,
    {
        unanswered()
    }

    /// Not to be called.
    fn jacobian<U, const N: usize>(&mut self, _: &SVector<U, N>, _: U) -> SMatrix<U, N, N>
    where
        Block: IntegerParameters<Self, U>,
    {
        unanswered()
    }
}
