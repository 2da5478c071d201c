//! The error for arguments with a wrong number of entries, or for a field with too many variables.

use core::fmt;

/// An argument with a wrong number of entries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DimensionError {
    argument: Argument,
    found: usize,
    expected: usize,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Argument {
    State,
    Out,
    Carry,
    Rows,
    Weights,
    Columns,
    Maps,
    Column(String),
    Eps,
    Parameters,
    Parameter(String),
    Type,
    /// The number of variables, if it is too large for the guaranteed error bound of `try_step`.
    Promise,
}

impl DimensionError {
    pub(crate) fn new(argument: Argument, found: usize, expected: usize) -> Self {
        DimensionError { argument, found, expected }
    }

    pub(crate) fn check(argument: Argument, found: usize, expected: usize) -> Result<(), Self> {
        if found == expected { Ok(()) } else { Err(Self::new(argument, found, expected)) }
    }

    /// Returns the number of entries found.
    #[must_use]
    pub fn found(&self) -> usize {
        self.found
    }

    /// Returns the needed number of entries. In a list of rows, each row needs this number.
    #[must_use]
    pub fn expected(&self) -> usize {
        self.expected
    }
}

impl fmt::Display for DimensionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DimensionError { argument, found, expected } = self;
        let entries = if *found == 1 { "entry" } else { "entries" };
        match argument {
            Argument::State => write!(f, "the state has {found} {entries}; give {expected}, one a variable"),
            Argument::Out => {
                write!(f, "there is room for {found} {entries} of the result; make it {expected}")
            }
            Argument::Carry => write!(f, "the carry has {found} {entries}; give {expected}, one a variable"),
            Argument::Rows => {
                write!(
                    f,
                    "the rows have {found} {entries}; give a multiple of {expected}, one a variable in each row"
                )
            }
            Argument::Weights => {
                write!(
                    f,
                    "the weights have {found} {entries}; give a multiple of {expected}, one a variable for each row"
                )
            }
            Argument::Columns => write!(f, "the columns are {found}; give {expected}, one a variable"),
            Argument::Maps => {
                write!(f, "the maps are {found}; give one, or {expected}, one an orbit")
            }
            Argument::Column(variable) => {
                write!(
                    f,
                    "the column of `{variable}` has {found} {entries}; give {expected}, as in the first"
                )
            }
            Argument::Eps => {
                write!(f, "eps has {found} {entries}; give none, one, or {expected}, one a trajectory")
            }
            Argument::Parameters => {
                write!(f, "the parameters are {found}; give none, or {expected} lists, one a parameter")
            }
            Argument::Parameter(name) => {
                write!(
                    f,
                    "the parameter `{name}` has {found} {entries}; give one, or {expected}, one a trajectory"
                )
            }
            Argument::Promise => {
                write!(
                    f,
                    "`try_step` is for up to {found} variables, and the field has {expected}; `step` gives what floats give"
                )
            }
            Argument::Type => {
                write!(f, "the type has {found} variables, and the field {expected}; take a larger one")
            }
        }
    }
}

impl core::error::Error for DimensionError {}
