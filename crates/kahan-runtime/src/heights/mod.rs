//! The Diophantine test: exact orbits and the growth of their heights (section 7 of the paper).
//!
//! The logarithmic height of p/q in lowest terms is h(p/q) = log max(|p|, |q|). Along an orbit over
//! ℚ, the height grows at most polynomially if the map is integrable, and otherwise in general
//! exponentially. [`HeightsOrbit`] yields the heights of any quadratic field's Kahan map from
//! rational initial data; [`Growth`] classifies them; [`DiophantineTest`] is the whole test in one
//! call.
//!
//! # Example
//!
//! ```
//! use kahan_algebra::rational::Rational;
//! use kahan_runtime::heights::{Growth, HeightsOrbit, DiophantineTest};
//!
//! let text = kahan_systems::registry::find("lv").unwrap().text();
//! let system = kahan_algebra::read(&kahan_algebra::lexer::lex(text).tokens).system().expect("a system");
//! let start = [Rational::new(1, 2), Rational::new(5, 3)];
//! let mut orbit = HeightsOrbit::new(&system, &[], &Rational::new(9, 14), &start).unwrap();
//! let survey = DiophantineTest::of(&mut orbit, 12);
//! assert_eq!(survey.growth, Growth::Exponential);
//! assert!((survey.entropy - 2.0_f64.ln()).abs() < 0.01);
//! ```

mod content;
mod diophantine_test;
mod elimination;
mod growth;
mod integers;
mod logarithm;
mod map;
mod orbit;
mod reduction;
mod report;
mod split;

pub use diophantine_test::DiophantineTest;
pub use growth::Growth;
pub(crate) use integers::{denominator, numerator, rational};
pub use map::{ProjectiveMap, UndefinedField};
pub use orbit::HeightsOrbit;
pub use report::{Heights, Stop};
