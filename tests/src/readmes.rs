//! Runs the examples of the READMEs and of `docs/` as tests.

#[doc = include_str!("../../README.md")]
struct Repository;

#[doc = include_str!("../../docs/tutorial.md")]
struct Tutorial;

#[doc = include_str!("../../docs/how-to/rust.md")]
struct OwnField;

#[doc = include_str!("../../docs/how-to/ensembles.md")]
struct Trajectories;

#[doc = include_str!("../../docs/how-to/lattices.md")]
struct Lattices;

#[doc = include_str!("../../crates/kahan-program/README.md")]
struct Programs;

#[doc = include_str!("../../crates/kahan-syntax/README.md")]
struct Syntax;

#[doc = include_str!("../../crates/kahan-algebra/README.md")]
struct Algebra;

#[doc = include_str!("../../crates/kahan-factor/README.md")]
struct Factor;

#[doc = include_str!("../../crates/kahan-lift/README.md")]
struct Lift;

#[doc = include_str!("../../crates/kahan-latex/README.md")]
struct Latex;

#[doc = include_str!("../../crates/kahan-emit/README.md")]
struct Emit;

#[doc = include_str!("../../kahan-derive/README.md")]
struct Derive;

#[doc = include_str!("../../kahan-core/README.md")]
struct Core;

#[doc = include_str!("../../crates/kahan-dynamics/README.md")]
struct Dynamics;

#[doc = include_str!("../../crates/kahan-discover/README.md")]
struct Discover;

#[doc = include_str!("../../crates/kahan-runtime/README.md")]
struct Runtime;

#[doc = include_str!("../../systems/README.md")]
struct Systems;

#[doc = include_str!("../../crates/kahan-paper/README.md")]
struct Paper;

#[doc = include_str!("../../crates/kahan-study/README.md")]
struct Measure;

#[doc = include_str!("../../crates/kahan-judge/README.md")]
struct Judge;

#[doc = include_str!("../../crates/kahan-draw/README.md")]
struct Draw;

#[doc = include_str!("../../crates/kahan-atlas/README.md")]
struct Atlas;
