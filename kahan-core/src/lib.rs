//! Kahan's method for quadratic differential equations: `kahan!` turns ẋ = f(x) into its birational
//! map x ↦ x̃.
//!
//! A field f(x) = Q(x) + Bx + c, with Q(x,y) the symmetric bilinear form of Q, has the map
//! (x̃ − x)/(2ε) = Q(x,x̃) + ½B(x + x̃) + c, which is linear in x̃ and is inverted by ε ↦ −ε.
//! **ε is half the time step** everywhere in this crate; [`eps_from_dt`] converts.
//!
//! In: the code that the macro makes of a block, a point, ε. Out: steps, orbits, many trajectories
//! at once. It must not know syntax, polynomials or claims: these are `kahan-algebra`'s, while
//! compiling. The crate `kahan-dynamics` finds the setting that reaches a tolerance, periodic
//! points and the solution of the equation itself.
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
//! let after_a_hundred = LotkaVolterra.orbit(start, eps).compensated().nth(1000);
//! ```
//!
//! # Every day
//!
//! `use kahan_core::prelude::*;` brings all of this.
//!
//! | what | where |
//! |---|---|
//! | write a field, and claim what its map keeps | [`kahan!`], explained in [`language`]; [`include_kahan!`] for one in a file |
//! | one step, forward or back; one with a promised error | [`KahanMap::step`], [`step_back`](KahanMap::step_back), [`try_step`](KahanMap::try_step) |
//! | many steps | [`KahanMap::orbit`], an iterator ([`Orbit`]); [`compensated`](Orbit::compensated) against rounding, [`composed`](Orbit::composed) for order 4, 6 or 8 ([`Composition`]) |
//! | states at given times, up to a time, where a function is first zero | [`Orbit::at_times`], [`until`](Orbit::until), [`first_crossing`](Orbit::first_crossing) |
//! | an orbit through its poles | [`Orbit::projective`], points of projective space |
//! | many trajectories | [`Ensemble`], [`Axis`] for grids of initial points |
//! | what an orbit does: exponents, sections, rotation numbers, drift, extrema | [`observe`]: [`Orbit::observe`], [`Ensemble::observe`] |
//! | derivatives, determinants | [`KahanMap::jacobian`], [`det_jacobian`](KahanMap::det_jacobian) |
//! | one state of a point | `x[E6::X]`, a constant of the type for each state |
//! | integrals, a density, brackets, drifts | methods of the type that the macro makes: `integrals` and each integral by its name, `density`, `bracket_NAME`, `drift_NAME` |
//! | a chain of any number of sites | a family `for i in … { … }` in [`kahan!`] makes a [`LatticeMap`], its [`at`](LatticeMap::at) a [`LatticeAt`] |
//! | another kind of number | `f32`, `f64`, [`Dd`] with twice the digits, `BigRational` with the feature `exact` |
//! | ε from a time step | [`eps_from_dt`] |
//!
//! # Advanced
//!
//! | what | where |
//! |---|---|
//! | a scalar of your own | [`Scalar`], [`Constant`]; [`Pivot`] for `try_step`, [`FloatScalar`] for modes of orbits, [`EnsembleScalar`] |
//! | a function over any map: compiled, composed, a chain, read at run time | `fn f<M: Step<Scalar = f64>>(map: M, start: M::State)` with [`Step`]; [`Orbit::new`] and [`observe::first_crossing`] take any |
//! | a map that is chosen at run time | `&dyn Step<Scalar = f64>`, which is itself a [`Step`] with `Vec`s as states; maps and chains of a text are those of `kahan-runtime` |
//! | generic code over systems | [`KahanMap`], [`QuadraticField`], [`Named`], [`Integrals`], [`ExtendScalars`] |
//! | a map written by hand | [`QuadraticField`] and [`KahanMap`] with [`Elimination`] or a [`PreparedStep`] |
//! | a map in a struct, a loop of your own | [`KahanAt<M, T, N>`](KahanAt), which [`KahanMap::at`] prepares; a chain is a [`LatticeAt<M, T>`](LatticeAt) |
//! | rounding that must not drift | [`nearest_short_eps`], [`Orbit::scaled`], [`ThroughF64`] |
//! | errors as one goes | [`Orbit::with_error_estimate`] |
//! | tangent vectors, an observer of one's own | [`Tangent`], [`observe::Observer`], [`observe::TangentMap`] |
//! | what is inside: modes as maps, costs, instruction sets | [`Composed`], [`Compensated`], [`StepCost`], [`Level`] |
//!
//! With the feature `serde` numbers, points, crossings and reports can be stored; `serde_json`
//! reads back every bit with its feature `float_roundtrip`. Without default features the crate is
//! `no_std`; float scalars never allocate in any configuration.

#![no_std]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[cfg(any(test, feature = "std"))]
extern crate std;

// From the bottom to the top: each of these imports from those above it only, which
// `tests/tests/layers.rs` sees to.
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

// The doors: what users and generated code come in by.
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
