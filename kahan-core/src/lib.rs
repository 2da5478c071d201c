//! Kahan's method for quadratic differential equations: [`kahan!`] turns ẋ = f(x) into a birational
//! map x ↦ x̃.
//!
//! A field f(x) = Q(x,x) + Bx + c, with a symmetric bilinear form Q, has the map (x̃ − x)/(2ε) =
//! Q(x,x̃) + ½B(x + x̃) + c. This equation is linear in x̃. The inverse map has −ε in place of ε.
//! **ε is half the time step** everywhere in this crate; [`eps_from_dt`] converts.
//!
//! `kahan-algebra` handles polynomials and claims. `kahan-dynamics` finds periodic points, settings
//! for a tolerance, and accurate solutions of ẋ = f(x).
//!
//! ```
//! use kahan_core::prelude::*;
//!
//! kahan! {
//!     pub struct LotkaVolterra;
//!     xdot = x*(1 - y);
//!     ydot = y*(x - 1);
//! }
//!
//! let (start, eps) = (vector![0.5, 1.7], 0.05);
//! let next = LotkaVolterra.step(&start, eps);
//! assert!((LotkaVolterra.step_back(&next, eps) - start).norm() < 1e-15);
//! let after_a_thousand = LotkaVolterra.orbit(start, eps).compensated().nth(1000);
//! ```
//!
//! # Every day
//!
//! `use kahan_core::prelude::*;` imports what this part needs, except the observers in [`observe`].
//!
//! | task | item |
//! |---|---|
//! | write a field, claim what its map conserves | [`kahan!`] ([`language`]), [`include_kahan!`] |
//! | one step, forward or back; one with a promised error | [`KahanMap::step`], [`step_back`](KahanMap::step_back), [`try_step`](KahanMap::try_step) |
//! | many steps | [`KahanMap::orbit`], an iterator ([`Orbit`]) |
//! | many steps with smaller rounding errors | [`Orbit::compensated`] |
//! | many steps of order 4, 6 or 8 | [`Orbit::composed`] ([`Composition`]) |
//! | states at given times, up to a time, the first zero of a function | [`Orbit::at_times`], [`until`](Orbit::until), [`first_crossing`](Orbit::first_crossing) |
//! | an orbit through its poles | [`Orbit::projective`], points of projective space |
//! | many trajectories | [`Ensemble`], [`Axis`] for grids of initial points |
//! | observation of orbits: exponents, sections, rotation numbers, drift, extrema | [`observe`]: [`Orbit::observe`], [`Ensemble::observe`] |
//! | derivatives, determinants | [`KahanMap::jacobian`], [`det_jacobian`](KahanMap::det_jacobian) |
//! | one variable of a point | `x[E6::X]`; the type has a constant for each variable |
//! | integrals, a density, brackets, drifts | methods of the type that the macro makes: `integrals` and each integral by its name, `density`, `bracket_NAME`, `drift_NAME` |
//! | a chain of any number of sites | a family `for i in … { … }` in [`kahan!`] makes a [`LatticeMap`], its [`at`](LatticeMap::at) a [`LatticeAt`] |
//! | another kind of number | `f32`, `f64`, [`Dd`] with twice the digits, `BigRational` with the feature `exact` |
//! | ε from a time step | [`eps_from_dt`] |
//!
//! # Advanced
//!
//! | task | item |
//! |---|---|
//! | your own scalar | [`Scalar`], [`Constant`], [`Pivot`], [`FloatScalar`], [`EnsembleScalar`] |
//! | a function over any map: compiled, composed, a chain, read at run time | `fn f<M: Step<Scalar = f64>>(map: M, start: M::State)` with [`Step`]; [`Orbit::new`] and [`observe::first_crossing`] take any |
//! | a map chosen at run time | `&dyn Step<Scalar = f64>`, itself a [`Step`] with `Vec`s as states; `kahan-runtime` makes maps and chains from text |
//! | generic code over systems | [`KahanMap`], [`QuadraticField`], [`Named`], [`Integrals`], [`ExtendScalars`] |
//! | a map written by hand | [`QuadraticField`] and [`KahanMap`] with [`Elimination`] or a [`PreparedStep`] |
//! | a map in a struct, a loop of your own | [`KahanAt<M, T, N>`](KahanAt), made by [`KahanMap::at`]; a chain is a [`LatticeAt<M, T>`](LatticeAt) |
//! | rounding without drift | [`nearest_short_eps`], [`Orbit::scaled`], [`ThroughF64`] |
//! | error estimates along an orbit | [`Orbit::with_error_estimate`] |
//! | tangent vectors, an observer of your own | [`Tangent`], [`observe::Observer`], [`observe::TangentMap`] |
//! | orbits as maps, costs, instruction sets | [`Composed`], [`Compensated`], [`StepCost`], [`Level`] |
//!
//! With the feature `serde` double-doubles, compositions, points, crossings and reports are
//! serialisable. `serde_json` needs its feature `float_roundtrip` to read back every bit. Without
//! default features the crate is `no_std`. Operations of float scalars allocate nothing.

#![no_std]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[cfg(any(test, feature = "std"))]
extern crate std;

// The modules, from the lowest layer to the highest. The test `tests/tests/layers.rs` checks their
// imports.
mod scalar;

mod field;

mod step;

mod map;

mod composition;

#[cfg(feature = "std")]
mod ensemble;

#[cfg(feature = "std")]
mod dense;
#[cfg(feature = "std")]
mod supernodes;

pub mod observe;

#[cfg(feature = "std")]
mod lattice;

mod macros;
#[cfg(feature = "serde")]
mod stored;
mod undeclared;
#[cfg(not(feature = "exact"))]
mod without_exact;

pub mod prelude;

#[doc = include_str!("../docs/language.md")]
pub mod language {}

#[doc(hidden)]
pub mod __private;

#[cfg(test)]
mod tests;

pub use composition::{Composed, Composition};
#[cfg(feature = "std")]
pub use ensemble::{Advances, Axis, Ensemble, EnsembleScalar, Level, Reciprocal};
pub use field::{Integrals, Named, QuadraticField};
#[cfg(feature = "std")]
pub use lattice::{LatticeAt, LatticeError, LatticeMap, LatticeScalar};
pub use map::{
    Compensated, Elimination, ErrorEstimates, Estimated, ExtendScalars, Increments, KahanAt, KahanMap, Orbit,
    Pivot, Scaled, ThroughF64, eps_from_dt,
};
#[cfg(feature = "std")]
pub use map::{Projective, ProjectivePoint, StepThroughF64, ThroughPoles};
pub use observe::Tangent;
pub use scalar::{Constant, Dd, Dual, EmbedScalar, FloatScalar, Scalar, nearest_short_eps};
pub use step::{
    NoLanes, PointOf, PreparedStep, Quotients, Reason, SingularStep, StateVector, Step, StepCost, Stopped,
    Workspace,
};

pub use nalgebra;
#[cfg(feature = "exact")]
pub use num_rational;
pub use num_traits;
