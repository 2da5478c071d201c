//! Methods that a system lacks, with diagnostics that say which declaration is missing.
//!
//! The bounds of these methods are never satisfied, and therefore every call is a compile error.
//! The methods take `&mut self`: rustc prefers declared methods of equal name with `&self`.

use core::iter::Empty;

use nalgebra::{SMatrix, SVector};

use crate::SingularStep;

/// A type for bounds that must never hold. It implements none of the traits below.
#[derive(Clone, Copy, Debug)]
pub struct Block;

/// A bound that never holds: rustc prints this message if the block of S declares no integral.
#[diagnostic::on_unimplemented(
    message = "the block of `{S}` declares no integral",
    label = "declare one in the block: `integral H = …;`",
    note = "what is claimed `when` a relation holds is proved and listed, but cannot be called"
)]
pub trait DeclaresIntegral<S: ?Sized, T> {}

/// A bound that never holds: rustc prints this message if the block of S declares no density.
#[diagnostic::on_unimplemented(
    message = "the block of `{S}` declares no density",
    label = "declare one in the block: `density rho = …;`",
    note = "what is claimed `when` a relation holds is proved and listed, but cannot be called"
)]
pub trait DeclaresDensity<S: ?Sized, T> {}

/// A bound that never holds: rustc prints this message if the parameters of S are integers.
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
    /// Never compiles, because its bound never holds. A call makes rustc print an explanation.
    fn step<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> SVector<T, N>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Never compiles, because its bound never holds. A call makes rustc print an explanation.
    fn step_back<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> SVector<T, N>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    #[allow(clippy::missing_errors_doc, reason = "it returns nothing")]
    /// Never compiles, because its bound never holds. A call makes rustc print an explanation.
    fn try_step<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> Result<SVector<T, N>, SingularStep>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Never compiles, because its bound never holds. A call makes rustc print an explanation.
    fn orbit<T, const N: usize>(&mut self, _: SVector<T, N>, _: T) -> Empty<SVector<T, N>>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Never compiles, because its bound never holds. A call makes rustc print an explanation.
    fn at<T>(&mut self, _: T)
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Never compiles, because its bound never holds. A call makes rustc print an explanation.
    fn field<T, const N: usize>(&mut self, _: &SVector<T, N>) -> SVector<T, N>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }

    /// Never compiles, because its bound never holds. A call makes rustc print an explanation.
    fn jacobian<T, const N: usize>(&mut self, _: &SVector<T, N>, _: T) -> SMatrix<T, N, N>
    where
        Block: HasScalars<Self, T>,
    {
        unanswered()
    }
}
