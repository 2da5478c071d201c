//! Fields ẋ = c + Bx + Q(x, x) given by their coefficients: as arrays c, B and Q, or one by one. A
//! coefficient given singly may have a parameter as factor.

use std::fmt;

use kahan_algebra::coefficients::Coefficient;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::System;
use kahan_core::nalgebra::storage::RawStorage;
use kahan_core::nalgebra::{Dim, Matrix};

use crate::{Diagnostics, Field, FieldText};

/// A field given by its coefficients. Each float stands for its exact value.
///
/// ```
/// use kahan_runtime::Coefficients;
///
/// let mut logistic = Coefficients::new(["x"], ["r"]).unwrap();
/// logistic.add(0, [Some(0), None], Some(0), 1.0).unwrap();
/// logistic.add(0, [Some(0), Some(0)], Some(0), -1.0).unwrap();
/// assert_eq!(logistic.text().given(), "xdot = r*x - r*x^2;");
/// ```
#[derive(Clone, Debug)]
pub struct Coefficients {
    symbols: Symbols,
    /// The coefficients of each component, with their monomials.
    components: Vec<Vec<(TermKey, f64)>>,
}

/// A monomial packed into an integer: two states in increasing order, then a parameter, with
/// [`INDEX_BITS`] bits each. Keys are ordered like the terms of a polynomial.
type TermKey = u64;

/// The number of bits of an index in a packed monomial; actual indices have at most 16 bits.
const INDEX_BITS: u32 = 20;
/// The index that stands for an absent state or parameter.
const ABSENT_INDEX: TermKey = (1 << INDEX_BITS) - 1;

fn term_key(states: [Option<usize>; 2], parameter: Option<usize>) -> TermKey {
    let [first, second, parameter] =
        [states[0], states[1], parameter].map(|index| index.map_or(ABSENT_INDEX, |index| index as TermKey));
    let (first, second) = match (first.min(second), first.max(second)) {
        (state, ABSENT_INDEX) => (ABSENT_INDEX, state),
        both => both,
    };
    (first << INDEX_BITS | second) << INDEX_BITS | parameter
}

/// The reason why coefficients do not define a field.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CoefficientError {
    /// An index is too large: the field has no component, state or parameter with this index.
    OutOfRange {
        /// The kind of the index: `"component"`, `"state"` or `"parameter"`.
        what: &'static str,
        /// The index, counted from 0.
        index: usize,
        /// The number of components, states or parameters.
        count: usize,
    },
    /// A coefficient is not finite.
    NotFinite {
        /// The index of the component.
        component: usize,
    },
    /// An array has a wrong length.
    Length {
        /// The array's name.
        array: &'static str,
        /// The array's length.
        found: usize,
        /// The lengths that the array may have.
        wanted: Vec<usize>,
    },
}

impl fmt::Display for CoefficientError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CoefficientError::OutOfRange { what, index, count } => {
                write!(f, "there is no {what} {index}: the field has {count}, numbered from 0 on")
            }
            CoefficientError::NotFinite { component } => {
                write!(f, "a coefficient of component {component} is not finite")
            }
            CoefficientError::Length { array, found, wanted } => {
                let wanted: Vec<String> = wanted.iter().map(ToString::to_string).collect();
                write!(f, "{array} has {found} numbers; it needs {}", wanted.join(" or "))
            }
        }
    }
}

impl std::error::Error for CoefficientError {}

impl Coefficients {
    /// Returns the field ẋ = 0 with these states and parameters.
    ///
    /// # Errors
    /// [`Diagnostics`] for a name that is not allowed, or that occurs twice.
    pub fn new<N: Into<String>>(
        states: impl IntoIterator<Item = N>,
        parameters: impl IntoIterator<Item = N>,
    ) -> Result<Self, Diagnostics> {
        let own = |names: Vec<N>| -> Vec<String> { names.into_iter().map(Into::into).collect() };
        let symbols = Symbols {
            states: own(states.into_iter().collect()),
            parameters: own(parameters.into_iter().collect()),
        };
        // The names are checked by parsing a small field that contains them.
        let sum = if symbols.parameters.is_empty() { "0".to_owned() } else { symbols.parameters.join(" + ") };
        let equations: String = symbols.states.iter().map(|state| format!("{state}dot = {sum};\n")).collect();
        FieldText::new(equations, "names".to_owned()).unproved_system()?;
        Ok(Coefficients::of(symbols))
    }

    fn of(symbols: Symbols) -> Self {
        let components = vec![Vec::new(); symbols.dimension()];
        Coefficients { symbols, components }
    }

    /// Adds a coefficient of ẋ = c + Bx + Q(x,x): to c if no state is given, to B for one state, to
    /// Q for two states.
    ///
    /// # Errors
    /// [`CoefficientError`] if the value is not finite, or an index is out of range.
    pub fn add(
        &mut self,
        component: usize,
        states: [Option<usize>; 2],
        parameter: Option<usize>,
        value: f64,
    ) -> Result<(), CoefficientError> {
        let (n, parameters) = (self.symbols.dimension(), self.symbols.parameters.len());
        let indices = [("component", Some(component), n), ("parameter", parameter, parameters)];
        for (what, index, count) in indices.into_iter().chain(states.map(|state| ("state", state, n))) {
            if let Some(index) = index.filter(|index| *index >= count) {
                return Err(CoefficientError::OutOfRange { what, index, count });
            }
        }
        if !value.is_finite() {
            return Err(CoefficientError::NotFinite { component });
        }
        if value != 0.0 {
            self.components[component].push((term_key(states, parameter), value));
        }
        Ok(())
    }

    /// Returns the field together with its equations as text.
    #[must_use]
    pub fn text(self) -> FieldText {
        FieldText::of_system(self.system(), "field".to_owned())
    }

    /// Returns the field as a [`System`].
    #[must_use]
    pub fn system(self) -> System {
        let terms = self.components.into_iter().enumerate().flat_map(|(component, mut terms)| {
            terms.sort_by_key(|(place, _)| *place);
            // A symmetric Q has equal entries for xⱼxₖ and xₖxⱼ. Their sum becomes one coefficient.
            terms.dedup_by(|(place, value), (kept, half)| {
                let is_half = place == kept && value == half && (*half + *half).is_finite();
                *half += if is_half { *half } else { 0.0 };
                is_half
            });
            terms.into_iter().map(move |(place, value)| {
                let [first, second, parameter] = [2 * INDEX_BITS, INDEX_BITS, 0].map(|shift| {
                    let index = place >> shift & ABSENT_INDEX;
                    (index != ABSENT_INDEX).then_some(index as usize)
                });
                let value = Rational::from_f64(value).expect("only finite numbers were added");
                Coefficient { component, states: [first, second], parameter, value }
            })
        });
        System::of_coefficients(self.symbols, terms)
    }
}

/// The numbers of an array, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ArrayRows(Vec<f64>);

impl From<&[f64]> for ArrayRows {
    fn from(rows: &[f64]) -> Self {
        ArrayRows(rows.to_vec())
    }
}

impl<const N: usize> From<&[f64; N]> for ArrayRows {
    fn from(rows: &[f64; N]) -> Self {
        ArrayRows(rows.to_vec())
    }
}

impl From<&Vec<f64>> for ArrayRows {
    fn from(rows: &Vec<f64>) -> Self {
        ArrayRows(rows.clone())
    }
}

impl<R: Dim, C: Dim, S: RawStorage<f64, R, C>> From<&Matrix<f64, R, C, S>> for ArrayRows {
    fn from(matrix: &Matrix<f64, R, C, S>) -> Self {
        ArrayRows(matrix.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect())
    }
}

impl Field {
    /// Builds the field ẋᵢ = cᵢ + Σⱼ Bᵢⱼxⱼ + Σⱼₖ Qᵢⱼₖxⱼxₖ in x1, …, xn.
    ///
    /// Arrays are slices, row by row, or matrices of nalgebra; each float stands for its exact
    /// value. An empty array stands for 0, but at least one array must have numbers. Q has n³
    /// numbers, or only the n²(n + 1)/2 numbers with k ≤ j, as in operator inference.
    ///
    /// # Errors
    /// [`CoefficientError`] for an array of another length, and for a number that is not finite.
    ///
    /// ```
    /// use kahan_runtime::Field;
    ///
    /// // x1' = x2, x2' = 1 - x1²
    /// let (c, b) = ([0.0, 1.0], [0.0, 1.0, 0.0, 0.0]);
    /// let field = Field::from_coefficients(&c, &b, &[0.0, 0.0, 0.0, -1.0, 0.0, 0.0]);
    /// let text = Field::parse("x1dot = x2; x2dot = 1 - x1^2;").unwrap();
    /// assert_eq!(field.unwrap().system().field, text.system().field);
    /// ```
    pub fn from_coefficients(
        c: impl Into<ArrayRows>,
        b: impl Into<ArrayRows>,
        q: impl Into<ArrayRows>,
    ) -> Result<Self, CoefficientError> {
        let [ArrayRows(c), ArrayRows(b), ArrayRows(q)] = [c.into(), b.into(), q.into()];
        let fits_q =
            |n: &usize| [n * n * n, n * n * (n + 1) / 2].contains(&q.len()) || n * n * n > 2 * q.len();
        let n = match (c.len(), b.len().isqrt()) {
            (0, 0) => (0..).find(fits_q).unwrap_or_default(),
            (0, n) | (n, _) => n,
        };
        let half = n * (n + 1) / 2;
        let fits = |array, numbers: &[f64], wanted: &[usize]| {
            let found = numbers.len();
            if numbers.is_empty() || wanted.contains(&found) {
                return Ok(());
            }
            Err(CoefficientError::Length { array, found, wanted: wanted.to_vec() })
        };
        fits("c", &c, &[n])?;
        fits("B", &b, &[n * n])?;
        fits("Q", &q, &[n * n * n, n * half])?;
        let names = (1..=n).map(|i| format!("x{i}"));
        let mut field = Coefficients::of(Symbols { states: names.collect(), parameters: Vec::new() });
        let columns = if q.len() == n * half { half } else { n * n };
        let triangle: Vec<[usize; 2]> = (0..n).flat_map(|j| (0..=j).map(move |k| [j, k])).collect();
        for (i, value) in c.into_iter().enumerate() {
            field.add(i, [None, None], None, value)?;
        }
        for (at, value) in b.into_iter().enumerate() {
            field.add(at / n, [Some(at % n), None], None, value)?;
        }
        for (at, value) in q.into_iter().enumerate() {
            let (i, at) = (at / columns, at % columns);
            let [j, k] = if columns == half { triangle[at] } else { [at / n, at % n] };
            field.add(i, [Some(j), Some(k)], None, value)?;
        }
        Ok(Field::of(&field.system()))
    }
}
