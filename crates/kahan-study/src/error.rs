//! Why a question has no answer.
//!
//! The variants hold what a front needs to say it in its own words, such as the options of a
//! command; [`Display`](fmt::Display) says it in those of the library.

use std::fmt;

use kahan_algebra::check::nearest;
use kahan_algebra::rational::Rational;
use kahan_discover::DiscoverError;
use kahan_discover::orbits::hilbert::MOST_MONOMIALS_AT_ALL;
use kahan_dynamics::periodic::NoPeriodicPoint;
use kahan_runtime::Diagnostics;

use crate::formula::NoFormula;
use crate::numbers::ScalarKind;
use crate::question::NoOrbit;
use crate::rows::MOST_CELLS;
use crate::study::{MOST_VARIABLES, assigned};
use crate::subject::Catalog;
use crate::trade::CannotTrade;

/// Why a subject cannot be studied, or a question not be answered.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum StudyError {
    /// The catalog has no such system.
    UnknownSystem {
        /// The value that was given.
        name: String,
        /// The name that is probably meant.
        nearest: Option<&'static str>,
        /// All names.
        known: Vec<&'static str>,
    },
    /// The text has mistakes, or claims that do not hold.
    Field(Diagnostics),
    /// Sites are for families, and the field has its equations written out.
    NoFamily,
    /// So many sites have more than [`MOST_VARIABLES`] variables.
    ManySites {
        /// The value that was given.
        sites: usize,
    },
    /// The field has no such parameter.
    UnknownParameter {
        /// The field.
        system: String,
        /// What was given.
        name: String,
        /// Its parameters.
        known: Vec<String>,
    },
    /// A parameter has two values.
    ParameterTwice {
        /// Which one.
        name: String,
    },
    /// Parameters have no values.
    MissingParameters {
        /// The field.
        system: String,
        /// Which ones.
        names: Vec<String>,
    },
    /// A point has not one coordinate for each variable.
    Coordinates {
        /// Which point, by its name in the question.
        what: &'static str,
        /// The variables.
        variables: Vec<String>,
        /// How many coordinates were given.
        given: usize,
    },
    /// Variables of a question over axes have no first values.
    MissingCoordinates {
        /// Which ones.
        names: Vec<String>,
    },
    /// A new variable of a lifted field has no value at a point.
    NotEmbedded {
        /// The new variable.
        variable: String,
        /// The function that it stands for.
        expression: String,
    },
    /// The field divides by zero at the values of its parameters.
    UndefinedField {
        /// The field.
        system: String,
        /// The values.
        parameters: Vec<(String, Rational)>,
    },
    /// Coefficients are wanted as numbers, and they depend on ε.
    CoefficientsOfEps {
        /// The field.
        system: String,
    },
    /// A number that is to be above 0, and within the range of doubles, is not.
    NotPositive {
        /// What it is, by its name in the question.
        what: &'static str,
        /// What was given.
        value: Rational,
    },
    /// There is no map to look at.
    Discover {
        /// The field.
        system: String,
        /// Why.
        why: DiscoverError,
    },
    /// Relations of this degree are out of reach.
    Degree {
        /// The value that was given.
        asked: u32,
        /// How many variables there are.
        variables: usize,
        /// The highest degree within reach, if there is one.
        most: Option<u32>,
    },
    /// What goes through values is nothing that could.
    UnknownAxis {
        /// What it would have to be: `no parameter`.
        what: &'static str,
        /// The field.
        system: String,
        /// What was given.
        name: String,
        /// What there is.
        known: Vec<String>,
    },
    /// Something goes through values twice.
    AxisTwice {
        /// Which one.
        name: String,
    },
    /// Something cannot go through these values.
    AxisValues {
        /// What.
        name: String,
        /// Why not.
        why: String,
    },
    /// A text is no formula.
    Formula {
        /// What it is, by its name in the question.
        what: &'static str,
        /// Why.
        why: NoFormula,
    },
    /// The formula of a section is one number everywhere.
    ConstantPlane {
        /// The formula.
        text: String,
    },
    /// ε has no value.
    MissingStep,
    /// Neither steps nor crossings are counted.
    MissingSteps,
    /// A cycle has more numbers than this.
    LongCycle {
        /// Its numbers.
        unknowns: usize,
        /// The most.
        most: usize,
    },
    /// There is no cycle near the point.
    NoCycle {
        /// The field.
        system: String,
        /// Why.
        why: NoPeriodicPoint,
    },
    /// A cycle of the flow is asked for, and the field depends on t.
    CycleOfTime {
        /// The field.
        system: String,
    },
    /// ε is found, and is to go through values, too.
    FreeStepAlong,
    /// Nothing goes through values.
    NoAxis,
    /// A grid has more points than this.
    ManyPoints {
        /// The most.
        most: usize,
    },
    /// A number is beyond the range of doubles.
    OutOfRange {
        /// Which one, by its name in the question.
        what: &'static str,
        /// Of a point the variable.
        variable: Option<String>,
    },
    /// A number is beyond the range of the scalar.
    BeyondRange {
        /// What it is of: `at`, `param` or `eps`.
        what: &'static str,
        /// Its name.
        name: String,
        /// The scalar.
        scalar: ScalarKind,
    },
    /// There is no composition of this order.
    Order(u32),
    /// A drift is asked for, and no integral is claimed.
    NoIntegral {
        /// The field.
        system: String,
    },
    /// No observable has such a column.
    UnknownColumn {
        /// The value that was given.
        name: String,
        /// The columns of all observables.
        known: Vec<String>,
    },
    /// An orbit cannot be all that it is asked to be.
    Orbit(NoOrbit),
    /// A question whose answer is no table, by its name, is asked for rows.
    NoRows(&'static str),
    /// An answer has more cells than [`MOST_CELLS`].
    TooLong {
        /// How many it has.
        cells: u64,
    },
    /// A grid has more cells than [`MOST_CELLS`].
    ManyCells {
        /// How many it has.
        cells: u64,
    },
    /// The matrices of a field are too large to be written out.
    LargeMatrices {
        /// How many variables it has.
        variables: usize,
        /// The most.
        most: usize,
    },
    /// The question measures times, and the watch has no clock.
    NoClock,
    /// There is nothing to measure.
    Trade {
        /// The field.
        system: String,
        /// Why.
        why: CannotTrade,
    },
}

impl StudyError {
    /// That a catalog has no such system, with the name that is probably meant.
    #[must_use]
    pub fn unknown_system(name: &str, catalog: &dyn Catalog) -> Self {
        let names = catalog.names();
        let near = nearest(name, names.as_flattened());
        let near = names.iter().find(|names| near.is_some_and(|near| names.contains(near)));
        StudyError::UnknownSystem {
            name: name.to_owned(),
            nearest: near.map(|[name, _]| *name),
            known: names.iter().map(|[name, _]| *name).collect(),
        }
    }
}

/// Spells a part of a question, by its name and its value, in messages of a front. The value is
/// empty where the message is about the part with any value.
pub type Spelling = fn(name: &str, value: &str) -> String;

/// The [`Spelling`] of JSON, TOML and Python: the name, then the value.
pub(crate) fn by_name(name: &str, value: &str) -> String {
    match name {
        "need" => format!("the need `{value}`"),
        "seconds" => format!("`{name}`"),
        _ => format!("{name} {value}").trim_end().to_owned(),
    }
}

impl fmt::Display for StudyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.tell(f, by_name)
    }
}

impl StudyError {
    /// Returns the message in which a front spells the parts of a question.
    #[must_use]
    pub fn spelled(&self, spelling: Spelling) -> String {
        fmt::from_fn(|f| self.tell(f, spelling)).to_string()
    }

    fn tell(&self, f: &mut fmt::Formatter<'_>, spelling: Spelling) -> fmt::Result {
        let named = |name| spelling(name, "");
        match self {
            Self::UnknownSystem { name, nearest, known } => {
                write!(f, "there is no system `{name}`.")?;
                if let Some(nearest) = nearest {
                    write!(f, " Did you mean `{nearest}`?")?;
                }
                write!(f, " The catalog has {}.", known.join(", "))
            }
            Self::Field(mistakes) => fmt::Display::fmt(mistakes, f),
            Self::NoFamily => f.write_str(
                "sites are for a family, `for i in periodic { x[i]dot = …; }`, and this field has its equations written out",
            ),
            Self::ManySites { sites } => write!(
                f,
                "{sites} sites are too many: a chain is written out up to {MOST_VARIABLES} variables"
            ),
            Self::UnknownParameter { system, name, known } if known.is_empty() => {
                write!(f, "`{name}` is no parameter of {system}: it has none")
            }
            Self::UnknownParameter { system, name, known } => {
                write!(f, "`{name}` is no parameter of {system}: it has {}", known.join(", "))?;
                nearest(name, known).map_or(Ok(()), |near| write!(f, "; did you mean `{near}`?"))
            }
            Self::ParameterTwice { name } => write!(f, "the parameter `{name}` is given twice"),
            Self::MissingParameters { system, names } => {
                write!(f, "{system} needs a value for each of its parameters: {} is missing", names.join(", "))
            }
            Self::Coordinates { what, variables, given } => {
                let (expected, plural) = (variables.len(), if variables.len() == 1 { "" } else { "s" });
                let what = named(what);
                write!(f, "{what}: {expected} coordinate{plural} {} expected, {given} given", variables.join(","))
            }
            Self::MissingCoordinates { names } => {
                let (names, first) = (names.join("`, `"), &names[0]);
                write!(f, "`{names}` has no first value; give it one in `over`, as {first} = 1 or {first} = \"0:1:11\"")
            }
            Self::NotEmbedded { variable, expression } => write!(
                f,
                "at: the new variable {variable} = {expression} has no value there; choose another point"
            ),
            Self::NotPositive { what, value } => {
                write!(f, "{}: `{value}` is not a number above 0 within the range of f64", named(what))
            }
            Self::Discover { system, why } => write!(f, "{system}: {why}"),
            Self::Degree { asked, variables, most } => {
                let degree = named("degree");
                let instead = most.map_or_else(|| format!("leave {degree} out"), |most| format!("ask for at most {most}"));
                write!(
                    f,
                    "{degree}: {variables} variables have more than {MOST_MONOMIALS_AT_ALL} monomials of degree {asked} or less; \
                     {instead}"
                )
            }
            Self::UnknownAxis { what, system, name, known } => {
                write!(f, "`{name}` is {what} of {system}; there is {}", known.join(", "))
            }
            Self::AxisTwice { name } => write!(f, "`{name}` is gone through twice; name two"),
            Self::AxisValues { name, why } => write!(f, "{name}: {why}"),
            Self::Formula { what, why } => f.write_str(&why.report(&named(what))),
            Self::ConstantPlane { text } => write!(
                f,
                "{text}: the formula is one number everywhere; a section is where a formula of the variables vanishes, as x - 1/2"
            ),
            Self::MissingSteps => {
                f.write_str("how far? give steps, or crossings, or both: an orbit ends where it has either")
            }
            Self::MissingStep => f.write_str("half the time step is missing"),
            Self::LongCycle { unknowns, most } => write!(
                f,
                "a cycle of {unknowns} numbers is beyond the {most} that Newton's method is given"
            ),
            Self::NoCycle { system, why } => write!(f, "{system}: no cycle was found: {why}"),
            Self::CycleOfTime { system } => write!(
                f,
                "{system} depends on t, so that its cycles have multiples of the period of that: ask for K steps at the \
                 fixed eps = T/(2K)"
            ),
            Self::FreeStepAlong => f.write_str("eps is found with the cycle, so that it cannot go through values"),
            Self::NoAxis => f.write_str("which values? give an axis to a parameter or to eps"),
            Self::ManyPoints { most } => {
                write!(f, "the grid has more than {most} points; take larger steps")
            }
            Self::OutOfRange { what, variable: Some(variable) } => {
                write!(f, "{}: the coordinate {variable} is beyond the range of f64", named(what))
            }
            Self::OutOfRange { what, variable: None } => write!(f, "{} is beyond the range of f64", named(what)),
            Self::BeyondRange { what, name, scalar } => {
                let (what, exact) = (named(what), spelling("scalar", "exact"));
                write!(f, "{what}: {name} is beyond the range of {}; use {exact}", scalar.name())
            }
            Self::Order(order) => write!(f, "there is no method of order {order}; there are 2, 4, 6 and 8"),
            Self::NoIntegral { .. } => f.write_str("drift is that of integrals, and the field claims none"),
            Self::UnknownColumn { name, known } => {
                write!(f, "{}: there is no column `{name}`; ", named("color"))?;
                match nearest(name, known) {
                    Some(near) => write!(f, "did you mean `{near}`?"),
                    None => write!(f, "there is {}", known.join(", ")),
                }
            }
            Self::Orbit(why) => why.tell(f, spelling),
            Self::NoRows(asked) => write!(f, "`{asked}` has no rows; ask for its answer"),
            Self::TooLong { cells } => write!(
                f,
                "the answer has {cells} cells, and at most {MOST_CELLS} are kept in memory; take its rows, or a larger `every`"
            ),
            Self::ManyCells { cells } => write!(
                f,
                "the grid has {cells} cells, and at most {MOST_CELLS} are kept in memory; give its axes fewer values"
            ),
            Self::LargeMatrices { variables, most } => write!(
                f,
                "the matrices of {variables} variables are not written out, which goes up to {most}; ask for the block alone, \
                 or show a family of the same equations at fewer sites"
            ),
            Self::NoClock => f.write_str("the question measures times, which takes a clock"),
            Self::Trade { system, why } => {
                write!(f, "{system}: ")?;
                why.tell(f, spelling)
            }
            Self::CoefficientsOfEps { system } => write!(
                f,
                "the coefficients of {system} depend on eps, and arrays hold numbers; write the field as text"
            ),
            Self::UndefinedField { system, parameters } => write!(
                f,
                "the field of {system} divides by zero at {}; choose other values",
                assigned(parameters.iter().map(|(name, value)| (name, value))).collect::<Vec<_>>().join(", ")
            ),
        }
    }
}

impl std::error::Error for StudyError {}
