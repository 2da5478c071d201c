//! Straight-line plans: lists of operations in which every common subexpression occurs once.
//!
//! A plan is a [`Program`](kahan_program::Program) with exact constants. The emitter turns it into
//! Rust, and [`evaluate`](kahan_program::Program::evaluate) runs it in any
//! [`Arithmetic`](kahan_program::Arithmetic). Most plans nest polynomials by `horner`. A step is
//! computed billions of times, so five modules optimise its plan.
//!
//! # Modules
//!
//! Each module uses only earlier modules of the list.
//!
//! 1. `step` separates prepared constants from the kernel, and rewrites the kernel.
//! 2. `writing` turns a polynomial into operations: it nests sums, distributes ε and reuses values.
//! 3. `accuracy` measures the loss of digits in long steps, and refuses inaccurate forms.
//! 4. `forms` writes different ways to solve A·x̃ = b.
//! 5. `choice` chooses a form for one orbit, and a form for many orbits in SIMD lanes.
//!
//! Three further modules serve all plans: `subexpressions` inserts named sums and divisors, `dense`
//! writes dense fields, and `descriptions` names operations.
//!
//! # Benefit of each optimisation
//!
//! Each optimisation was disabled separately for 85 fields: the catalog, random fields of two to
//! six variables, and four fields of up to eight. The column *steps* counts the steps that change.
//! The other columns give the ratio of a step's time without the optimisation to its time with it.
//! An entry is the mean and the maximum of this ratio over these steps. *One orbit* and *columns*
//! (many orbits in SIMD lanes) are machine code of the runtime. *Compiled* is one orbit by the
//! macro, for the catalog and 20 random fields. The last column is for processors with AVX-512.
//!
//! | disabled | steps | one orbit | columns | compiled | compiled, AVX-512 |
//! |---|--:|--:|--:|--:|--:|
//! | determinants of A (`forms::minors`) | 26 | 1.12; 2.0 | 1.22; 2.3 | | |
//! | several ways to scale by ε (`writing::scaling`) | 50 | 1.04; 1.45 | 1.05; 1.35 | | |
//! | all forms for one orbit ([`StepPlan::general`]) | 31 | 1.06; 1.28 | 1.00; 1.01 | | |
//! | division by the time step (`forms::inverse`) | 28 | 1.06; 1.25 | 1.00; 1.02 | | |
//! | a second division (`forms::candidates`) | 2 | 1.05; 1.08 | 1.00; 1.00 | 1.04; 1.12 | 1.27; 1.47 |
//! | reuse of sums (`writing::writer::reuse`) | 44 | 1.00; 1.43 | 1.00; 1.35 | | |
//! | signs of constants (`step::signs`) | 27 | 1.00; 1.01 | 1.00; 1.02 | 1.05; 1.43 | 1.01; 1.12 |
//! | signs of reciprocals (`step::reciprocals`) | 30 | 1.01; 1.05 | 0.99; 1.02 | 1.02; 1.56 | 1.01; 1.15 |
//!
//! Two more optimisations were dropped. Writing (2ε)x as εx + εx changed 27 steps with means near
//! 1.00. A division for each component in place of a shared reciprocal changed 6 steps, and doubled
//! the time of ensembles, because divisions are the bottleneck in SIMD lanes. Fields of one
//! variable still use it (`PlanBuilder::increment`).

mod operation;

mod builder;

mod horner;

mod subexpressions;

mod dense;

mod step;

mod descriptions;

mod writing;

mod accuracy;

mod forms;

mod choice;

pub use builder::{PlanBuilder, plan_of};
pub(crate) use dense::DenseField;
pub(crate) use descriptions::{descriptions, kind};
pub(crate) use forms::structure::blocks as triangular_blocks;
pub(crate) use forms::tangent::tangent_plan;
pub use operation::{Cost, Input, Node, Operation, Plan, variables};
pub use step::kernel::Kernel;
pub(crate) use step::split::split_with_quotients;
pub use step::{LARGEST_SIZE, StepCost, StepPlan};
