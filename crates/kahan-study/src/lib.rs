//! Questions about a field and its Kahan map, and the answers, as values.
//!
//! A [`Study`] is a [`Subject`] that was read: a field with values of its parameters. Any thread
//! may ask a study a [`Question`]. The [`Answer`] serializes to JSON, as the command prints it
//! unless rows go to a file. Reference trajectories of the flow are in [`mod@reference`], and
//! comparisons of settings by error and cost in [`trade`].
//!
//! # Example
//!
//! ```
//! use kahan_study::{Answer, Question, Subject, Systems, Unwatched};
//!
//! let study = Subject::named("e1").study(&Systems).unwrap();
//! let question: Question = serde_json::from_str(r#"{"ask": "evaluate", "eps": "1/2", "at": [1, 2, "1/3"]}"#).unwrap();
//! let Answer::Evaluate(values) = study.ask(&question, &Unwatched).unwrap() else { unreachable!() };
//! assert_eq!(values.det_matrix.to_string(), "3/2"); // 1 + εx
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod axes;
#[cfg(feature = "catalog")]
mod catalog;
mod colour_column;
pub mod columns;
mod count;
mod draw;
mod error;
pub mod formula;
#[cfg(feature = "toml")]
mod from_toml;
mod lifted;
mod lifted_step;
mod list;
mod map;
mod misread;
mod named;
#[cfg(feature = "files")]
pub mod number_file;
pub mod numbers;
mod question;
mod range;
mod rates;
pub mod reference;
mod relations;
mod rows;
mod shown_orbit;
mod study;
mod subject;
mod sympy;
pub mod trade;

#[cfg(feature = "catalog")]
pub use catalog::Systems;
pub use colour_column::ColourColumn;
pub use count::WorkCount;
pub use error::{Spelling, StudyError};
#[cfg(feature = "toml")]
pub use from_toml::{TomlDocument, from_toml};
pub use kahan_core::observe::Direction;
pub use kahan_discover::{Finding, Progress, Unwatched, Watch};
pub use kahan_lift::{Lift, LiftCriterion};
pub use kahan_runtime::End;
pub use lifted::{LiftFound, Lifting, NewFound, RelationFate, RelationFound, WatchedOrbit};
pub use lifted_step::{LiftEnds, LiftedStep};
pub use list::{FamilyListed, Listed, SystemListed, list};
pub use misread::{Misread, read};
pub use named::Names;
pub use question::*;
pub use range::{Axis, NoRange, Range, Spacing};
pub use rates::Rates;
pub use relations::RelationErrors;
pub use rows::{
    Cell, Column, Ending, Exact, MOST_CELLS, Rows, StoredColumn, Table, Values, csv_line, free_name,
};
pub use shown_orbit::ShownOrbit;
pub use study::{MOST_VARIABLES, NoStep, Study};
pub use subject::{Catalog, Named, Subject};
pub use sympy::SymPy;
