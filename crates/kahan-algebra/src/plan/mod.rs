//! Straight lines: which operations are computed in which order, every common subexpression once.
//!
//! A plan is data, a [`Program`] with exact constants. The emitter turns it into Rust, and
//! [`Program::evaluate`] runs its operations in their order in any [`Arithmetic`]:
//! rationals, a prime field, dual numbers, degree bounds, rational functions, floats.
//!
//! [`Program`]: kahan_program::Program
//! [`Program::evaluate`]: kahan_program::Program::evaluate
//! [`Arithmetic`]: kahan_program::Arithmetic
//!
//! For most plans `horner` nests polynomials, and that is all. A step is computed billions of
//! times, so five modules take more care of its plan, each of which needs those before it only:
//!
//! 1. `step` decides what is prepared and what is computed for each state, and rewrites that.
//! 2. `writing` decides how a polynomial becomes operations: how it is nested, where ε goes, what
//!    is reused.
//! 3. `accuracy` measures what a long step loses, and refuses forms that lose too much.
//! 4. `forms` decides what is computed: which ways there are to solve A·x̃ = b, and the cheapest.
//! 5. `choice` chooses the form for one orbit, and that for lanes.
//!
//! `values` puts in what a field keeps as it was written, `dense` writes the sums of fields with
//! very many products, `words` says what operations are called.
//!
//! # What each optimisation buys
//!
//! Each was left out alone for 85 fields: the catalog, random fields of two to six variables, and
//! four of up to eight. The table says how many steps change, and the time without over the time
//! with it: the geometric mean over the steps that change, and the largest. *Machine code* is what
//! the runtime compiles, for one orbit and for columns; *compiled* is what the macro writes for the
//! catalog and 20 of the random fields, one orbit, for any x86-64 processor and for one with
//! AVX-512.
//!
//! | left out | steps | one orbit | columns | compiled | compiled, AVX-512 |
//! |---|--:|--:|--:|--:|--:|
//! | determinants of A (`forms::minors`) | 26 | 1.12; 2.0 | 1.22; 2.3 | | |
//! | several ways to scale by ε (`writing::scaling`) | 50 | 1.04; 1.45 | 1.05; 1.35 | | |
//! | all forms of one orbit ([`StepPlan::general`]) | 31 | 1.06; 1.28 | 1.00; 1.01 | | |
//! | division by the time step (`forms::inverse`) | 28 | 1.06; 1.25 | 1.00; 1.02 | | |
//! | a second division (`forms::candidates`) | 2 | 1.05; 1.08 | 1.00; 1.00 | 1.04; 1.12 | 1.27; 1.47 |
//! | reuse of sums (`writing::writer::reuse`) | 44 | 1.00; 1.43 | 1.00; 1.35 | | |
//! | signs of constants (`step::signs`) | 27 | 1.00; 1.01 | 1.00; 1.02 | 1.05; 1.43 | 1.01; 1.12 |
//! | signs of reciprocals (`step::reciprocals`) | 30 | 1.01; 1.05 | 0.99; 1.02 | 1.02; 1.56 | 1.01; 1.15 |
//!
//! Two more were measured with them. (2ε)x as εx + εx went (27 steps: 1.00, 0.99, 1.00 and 1.00 in
//! the mean). A division a component in place of a shared reciprocal is left to fields of one
//! variable (`PlanBuilder::increment`); it changed 6 steps (1.00; 1.03, 1.00; 1.01, 0.97; 1.06 and
//! 0.84; 0.93). For Lotka and Volterra's step, compiled for any x86-64 processor, it saved a fifth
//! of the instructions and 6 % of the time. Ensembles that report how they ended took twice the
//! time with it: they take the form of single orbits, and two divisions bound the lanes.

mod operation;

mod builder;

mod horner;

mod values;

mod dense;

mod step;

mod words;

mod writing;

mod accuracy;

mod forms;

mod choice;

pub use builder::{PlanBuilder, plan_of};
pub(crate) use dense::DenseField;
pub(crate) use forms::structure::blocks as triangular_blocks;
pub(crate) use forms::tangent::tangent_plan;
pub use operation::{Cost, Input, Node, Operation, Plan, variables};
pub use step::kernel::Kernel;
pub(crate) use step::split::separated;
pub use step::{LARGEST_SIZE, StepCost, StepPlan};
pub(crate) use words::{descriptions, kind};
