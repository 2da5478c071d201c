//! The errors of a study. The messages are composed here; a user interface supplies the spelling of
//! the options in them.

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

/// The reason why a field cannot be studied, or a request has no answer.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum StudyError {
    /// The catalog has no system of this name.
    UnknownSystem {
        /// The given name.
        name: String,
        /// The name that is probably meant.
        nearest: Option<&'static str>,
        /// All names of the catalog.
        known: Vec<&'static str>,
    },
    /// The text has mistakes, or claims that do not hold.
    Field(Diagnostics),
    /// A number of sites is given, but the equations are not those of a general site i.
    NoFamily,
    /// The field has no steps that fuse multiply-adds: [`Field::has_fused_steps`].
    ///
    /// [`Field::has_fused_steps`]: kahan_runtime::Field::has_fused_steps
    NoFusedSteps {
        /// The name of the field.
        system: String,
    },
    /// A chain of this length has more than [`MOST_VARIABLES`] variables.
    ManySites {
        /// The given number of sites.
        sites: usize,
    },
    /// The field has no parameter of this name.
    UnknownParameter {
        /// The name of the field.
        system: String,
        /// The given name.
        name: String,
        /// The parameters of the field.
        known: Vec<String>,
    },
    /// A parameter has two values.
    ParameterTwice {
        /// The name of the parameter.
        name: String,
    },
    /// Some parameters have no values.
    MissingParameters {
        /// The name of the field.
        system: String,
        /// The missing parameters.
        names: Vec<String>,
    },
    /// The number of coordinates of a point differs from the number of variables.
    Coordinates {
        /// The entry of the question that holds the point: `at`.
        what: &'static str,
        /// The variables.
        variables: Vec<String>,
        /// The number of given coordinates.
        given: usize,
    },
    /// Some variables have no initial value: neither the first points nor an axis give them one.
    MissingCoordinates {
        /// The variables.
        names: Vec<String>,
    },
    /// A new variable of a lifted field has no value at a point.
    NotEmbedded {
        /// The new variable.
        variable: String,
        /// The function of the states that defines the new variable.
        expression: String,
    },
    /// The field divides by zero at the values of its parameters.
    UndefinedField {
        /// The name of the field.
        system: String,
        /// The values of the parameters.
        parameters: Vec<(String, Rational)>,
    },
    /// Coefficients are wanted as numbers, but depend on ε.
    CoefficientsOfEps {
        /// The name of the field.
        system: String,
    },
    /// A number is not positive, or beyond the range of doubles.
    NotPositive {
        /// The name of the number in the question.
        what: &'static str,
        /// The given number.
        value: Rational,
    },
    /// The search for preserved structures does not support this field.
    Discover {
        /// The name of the field.
        system: String,
        /// The reason.
        why: DiscoverError,
    },
    /// The search space for relations of this degree is too large.
    Degree {
        /// The given degree.
        asked: u32,
        /// The number of variables.
        variables: usize,
        /// The highest degree that is feasible, if any is.
        most: Option<u32>,
    },
    /// The question does not allow an axis of this name.
    UnknownAxis {
        /// The predicate of the message, such as `no parameter` in "`b` is no parameter".
        what: &'static str,
        /// The name of the field.
        system: String,
        /// The given name.
        name: String,
        /// The allowed names.
        known: Vec<String>,
    },
    /// Two axes have one name.
    AxisTwice {
        /// The name.
        name: String,
    },
    /// An axis cannot take these values.
    AxisValues {
        /// The name of the axis.
        name: String,
        /// The reason.
        why: String,
    },
    /// A text is not a formula.
    Formula {
        /// The name of the text in the question.
        what: &'static str,
        /// The reason.
        why: NoFormula,
    },
    /// The formula whose zeros define a Poincaré section is constant.
    ConstantPlane {
        /// The formula.
        text: String,
    },
    /// ε has no value.
    MissingStep,
    /// Neither a number of steps nor a number of crossings is given.
    MissingSteps,
    /// A cycle has too many unknowns for Newton's method.
    LongCycle {
        /// The number of unknowns.
        unknowns: usize,
        /// The most unknowns allowed.
        most: usize,
    },
    /// No cycle was found near the point.
    NoCycle {
        /// The name of the field.
        system: String,
        /// The reason.
        why: NoPeriodicPoint,
    },
    /// A cycle of the flow is asked for, but the field depends on t.
    CycleOfTime {
        /// The name of the field.
        system: String,
    },
    /// ε is an unknown of the cycle, so that it cannot be an axis.
    FreeStepAlong,
    /// No axis is given.
    NoAxis,
    /// A grid has too many points.
    ManyPoints {
        /// The most points allowed.
        most: usize,
    },
    /// A number is beyond the range of doubles.
    OutOfRange {
        /// The name of the number in the question.
        what: &'static str,
        /// The variable, if the number is a coordinate of a point.
        variable: Option<String>,
    },
    /// A number is beyond the range of the scalar type of the computation.
    BeyondRange {
        /// The entry of the question that holds the number: `at`, `param` or `eps`.
        what: &'static str,
        /// The name of the number.
        name: String,
        /// The scalar type of the computation.
        scalar: ScalarKind,
    },
    /// No composition has this order.
    Order(u32),
    /// A drift is asked for, but the field claims no integral.
    NoIntegral {
        /// The name of the field.
        system: String,
    },
    /// No observable has a column of this name.
    UnknownColumn {
        /// The given name.
        name: String,
        /// The columns of all observables.
        known: Vec<String>,
    },
    /// The options of an orbit contradict each other or the field.
    Orbit(NoOrbit),
    /// Rows are requested from the question of this name, whose answer is not a table.
    NoRows(&'static str),
    /// An answer has more cells than [`MOST_CELLS`].
    TooLong {
        /// The number of cells of the answer.
        cells: u64,
    },
    /// A grid has more cells than [`MOST_CELLS`].
    ManyCells {
        /// The number of cells of the grid.
        cells: u64,
    },
    /// The matrices of a field are too large to be written out.
    LargeMatrices {
        /// The number of variables.
        variables: usize,
        /// The most variables allowed.
        most: usize,
    },
    /// The question measures times, but the caller's `Watch` provides no clock.
    NoClock,
    /// Scalars, orders and step sizes cannot be compared, because errors cannot be measured.
    Trade {
        /// The name of the field.
        system: String,
        /// The reason why nothing can be measured.
        why: CannotTrade,
    },
}

impl StudyError {
    /// Returns the error for an unknown name, with the name of the catalog that is probably meant.
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

/// A function that writes the name of an option and its value in the syntax of a user interface,
/// such as `--eps 1/2`. If `value` is empty, only the name is written.
pub type Spelling = fn(name: &str, value: &str) -> String;

/// Spells a named value in the style of JSON, TOML and Python: the name, then the value.
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
    /// Returns the message, with names and values spelled by `spelling`.
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
            Self::NoFusedSteps { system } => write!(
                f,
                "{system} has no fused steps: they need a processor with fused multiply-adds, and a step without elimination; \
                 leave {} out",
                named("fused")
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
                f.write_str("how far? give steps, or crossings, or both: an orbit ends at the first of them")
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
