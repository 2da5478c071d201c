//! Assigns the columns of a table to states, parameters and ε by name.

use std::fmt;

use kahan_algebra::check::nearest;

/// The names that columns may have.
#[derive(Clone, Copy, Debug)]
pub struct ExpectedColumns<'a> {
    /// The states, of which the first [`least`](Self::least) need a column.
    pub states: &'a [String],
    /// The number of states that need a column; the other states are new variables of a lift.
    pub least: usize,
    /// The parameters of the field.
    pub parameters: &'a [String],
    /// The treatment of columns that are not states.
    pub others: OtherColumns,
}

/// The treatment of columns that are not states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OtherColumns {
    /// Parameters and `eps` have a value in each row; other columns are refused.
    Used,
    /// Parameters and `eps` have one value each, given elsewhere; all other columns are refused.
    Refused,
    /// Other columns are ignored; parameters and `eps` have values from elsewhere.
    Ignored,
}

/// The indices of the matched columns.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ColumnIndices {
    /// The column of each state.
    pub states: Vec<usize>,
    /// The parameters, and `eps`, that have a column, each with the column's index.
    pub others: Vec<(String, usize)>,
}

/// A mistake in the columns of a table. Its text is a predicate, to be put after the table's name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ColumnError {
    /// A state has no column.
    Missing {
        /// The name of the state.
        state: String,
        /// The columns of the table.
        found: Vec<String>,
        /// The column that is probably a misspelling of the state.
        nearest: Option<String>,
    },
    /// Two columns have one name.
    Twice(String),
    /// A parameter or `eps` has a column, but a single value is expected.
    Single(String),
    /// Some columns have names that the field does not know.
    Unusable {
        /// The names of the unknown columns.
        names: Vec<String>,
        /// The names that columns may have.
        known: Vec<String>,
    },
}

impl<'a> ExpectedColumns<'a> {
    /// Requires a column for each of `states`.
    #[must_use]
    pub fn new(states: &'a [String], parameters: &'a [String], others: OtherColumns) -> Self {
        ExpectedColumns { states, least: states.len(), parameters, others }
    }

    /// Finds the columns of states, parameters and ε in a table whose columns have these `names`.
    ///
    /// # Errors
    /// A state without a column, two columns of one name, or a column that cannot be used.
    pub fn places(&self, names: &[String]) -> Result<ColumnIndices, ColumnError> {
        let (first, new) = self.states.split_at(self.least);
        let states = if new.iter().any(|state| names.contains(state)) { self.states } else { first };
        let once = |name: &String| {
            let mut places = (0..names.len()).filter(|place| names[*place] == *name);
            match (places.next(), places.next()) {
                (Some(_), Some(_)) => Err(ColumnError::Twice(name.clone())),
                (place, _) => Ok(place),
            }
        };
        let state = |state: &String| once(state)?.ok_or_else(|| self.missing(state, names));
        let places = states.iter().map(state).collect::<Result<Vec<_>, _>>()?;
        let mut found = ColumnIndices { states: places, others: Vec::new() };
        if self.others == OtherColumns::Ignored {
            return Ok(found);
        }
        let (others, unusable): (Vec<_>, Vec<_>) = names
            .iter()
            .filter(|name| !states.contains(name))
            .partition(|name| *name == "eps" || self.parameters.contains(name));
        if !unusable.is_empty() {
            let names = unusable.into_iter().cloned().collect();
            return Err(ColumnError::Unusable { names, known: self.known(states) });
        }
        for name in others {
            if self.others == OtherColumns::Refused {
                return Err(ColumnError::Single(name.clone()));
            }
            found.others.extend(once(name)?.map(|place| (name.clone(), place)));
        }
        Ok(found)
    }

    fn missing(&self, state: &str, names: &[String]) -> ColumnError {
        let is_free = |name: &&String| !self.states.contains(name) && !self.parameters.contains(name);
        let free: Vec<&String> = names.iter().filter(is_free).collect();
        let nearest = nearest(state, &free).map(|name| (*name).clone());
        ColumnError::Missing { state: state.to_owned(), found: names.to_vec(), nearest }
    }

    fn known(&self, states: &[String]) -> Vec<String> {
        let is_used = self.others == OtherColumns::Used;
        let others = self.parameters.iter().cloned().chain(["eps".to_owned()]);
        states.iter().cloned().chain(others.filter(|_| is_used)).collect()
    }
}

impl fmt::Display for ColumnError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { state, found, nearest } => {
                write!(f, "has no column `{state}`; it has {}", found.join(", "))?;
                nearest.iter().try_for_each(|name| write!(f, "; rename `{name}` if that is `{state}`"))
            }
            Self::Twice(name) => write!(f, "has two columns `{name}`; leave one of them out"),
            Self::Single(name) => {
                let (what, how) = match &**name {
                    "eps" => ("the step", "--eps V, or in Python eps=V".to_owned()),
                    _ => ("a parameter", format!("--param {name}=V, or in Python s({name}=V)")),
                };
                write!(
                    f,
                    "has a column `{name}`, and {what} has one value here: leave the column out and give {how}; ensembles in Python \
                     and sweeps take a value for each start"
                )
            }
            Self::Unusable { names, known } => {
                let named = |name: &String| match (&**name, nearest(name, known)) {
                    ("", _) => "one without a name (pandas writes none with index=False)".to_owned(),
                    (name, None) => format!("`{name}`"),
                    (name, Some(known)) => format!("`{name}` (is `{known}` meant?)"),
                };
                let shown: Vec<String> = names.iter().map(named).collect();
                let plural = if names.len() == 1 { "a column" } else { "columns" };
                write!(
                    f,
                    "has {plural} that cannot be used, {}: leave out all but {}",
                    shown.join(", "),
                    known.join(", ")
                )
            }
        }
    }
}

impl std::error::Error for ColumnError {}

#[cfg(test)]
mod tests {
    use super::{ExpectedColumns, OtherColumns};

    fn names(text: &str) -> Vec<String> {
        text.split(',').map(str::to_owned).collect()
    }

    /// Matches columns with the states x and y, the new variable u, and the parameters k and m.
    fn found(others: OtherColumns, columns: &str) -> Result<String, String> {
        let (states, parameters) = (names("x,y,u"), names("k,m"));
        let wanted = ExpectedColumns { least: 2, ..ExpectedColumns::new(&states, &parameters, others) };
        let places = wanted.places(&names(columns)).map_err(|error| error.to_string())?;
        Ok(format!("{:?} {:?}", places.states, places.others))
    }

    #[test]
    fn names_decide_in_every_order() {
        for (columns, wanted) in [
            ("x,y", "[0, 1] []"),
            ("y,x", "[1, 0] []"),
            ("y,u,x", "[2, 0, 1] []"),
            ("eps,y,k,x", "[3, 1] [(\"eps\", 0), (\"k\", 2)]"),
            ("m,x,y,k", "[1, 2] [(\"m\", 0), (\"k\", 3)]"),
        ] {
            assert_eq!(found(OtherColumns::Used, columns), Ok(wanted.to_owned()), "{columns}");
        }
        assert_eq!(found(OtherColumns::Ignored, "t,y,k,k,x"), Ok("[4, 1] []".to_owned()));
    }

    #[test]
    fn a_table_that_is_not_understood_is_told() {
        let told = |others, columns, part: &str| {
            let said = found(others, columns).expect_err(columns);
            assert!(said.contains(part), "{columns}: {said}");
        };
        for others in [OtherColumns::Used, OtherColumns::Refused, OtherColumns::Ignored] {
            told(others, "x", "has no column `y`; it has x");
            told(others, "Y,x", "has no column `y`; it has Y, x");
            told(others, "x,y,x", "has two columns `x`");
            told(others, "u,x", "has no column `y`");
        }
        told(OtherColumns::Used, "k,k,x,y", "has two columns `k`");
        told(
            OtherColumns::Used,
            "x,note,y,t",
            "cannot be used, `note`, `t`: leave out all but x, y, k, m, eps",
        );
        told(OtherColumns::Refused, "x,note,y", "cannot be used, `note`: leave out all but x, y");
        told(OtherColumns::Refused, ",x,y", "one without a name");
        told(OtherColumns::Refused, "k,x,y", "has a column `k`, and a parameter has one value here");
        told(OtherColumns::Refused, "eps,x,y", "leave the column out and give --eps V, or in Python eps=V");
    }

    #[test]
    fn a_slip_is_guessed() {
        let (states, others) = (names("theta,v"), OtherColumns::Refused);
        let wanted = ExpectedColumns::new(&states, &[], others);
        let said = wanted.places(&names("v,Theta")).expect_err("a slip").to_string();
        assert!(said.ends_with("it has v, Theta; rename `Theta` if that is `theta`"), "{said}");
    }
}
