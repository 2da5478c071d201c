//! Methods that a system lacks, with diagnostics that say which declaration is missing.
//!
//! The bounds of these methods never hold, so every call is a compile error. The methods take
//! `&mut self`, because rustc then prefers a system's own method, which takes `&self`.

use core::iter::Empty;

use nalgebra::{SMatrix, SVector};

use crate::SingularStep;

/// A type that implements none of the traits below, so that bounds on it never hold.
#[derive(Clone, Copy, Debug)]
pub struct Block;

/// A bound that never holds. Its message says that the `kahan!` block of S declares no integral.
#[diagnostic::on_unimplemented(
    message = "the block of `{S}` declares no integral",
    label = "declare one in the block: `integral H = …;`",
    note = "what is claimed `when` a relation holds is proved and listed, but cannot be called"
)]
pub trait DeclaresIntegral<S: ?Sized, T> {}

/// A bound that never holds. Its message says that the `kahan!` block of S declares no density.
#[diagnostic::on_unimplemented(
    message = "the block of `{S}` declares no density",
    label = "declare one in the block: `density rho = …;`",
    note = "what is claimed `when` a relation holds is proved and listed, but cannot be called"
)]
pub trait DeclaresDensity<S: ?Sized, T> {}

/// A bound that never holds. Its message says that the parameters of S are integers.
#[diagnostic::on_unimplemented(
    message = "the parameters of `{S}` are integers, and a Kahan map computes with fractions",
    label = "its parameters are integers: write `1.0`, not `1`",
    note = "`f32`, `f64` and `Dd` are scalars, with the feature `exact` also `BigRational`"
)]
pub trait HasScalars<S: ?Sized, T> {}

fn unanswered() -> ! {
    unreachable!("no type has what this asks for")
}

/// The methods that a block without integrals gets.
pub trait WithoutIntegrals {
    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn integrals<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> SVector<T, 1>
    where
        Block: DeclaresIntegral<Self, T>,
    {
        unanswered()
    }
}

/// The methods that a block without a density gets.
pub trait WithoutDensity {
    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn density<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> T
    where
        Block: DeclaresDensity<Self, T>,
    {
        unanswered()
    }
}

/// The methods that a system with integer parameters gets.
pub trait IntegerParameters {
    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn step<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> SVector<T, N>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn step_back<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> SVector<T, N>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    #[allow(clippy::missing_errors_doc, reason = "it returns nothing")]
    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn try_step<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> Result<SVector<T, N>, SingularStep>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn orbit<T, const N: usize>(&mut self, _: SVector<T, N>, _: T) -> Empty<SVector<T, N>>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn at<T>(&mut self, _: T)
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn field<T, const N: usize>(&mut self, _: &SVector<T, N>) -> SVector<T, N>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Cannot be called, because its bound never holds. A call makes rustc print an explanation.
    fn jacobian<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> SMatrix<T, N, N>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }
}
