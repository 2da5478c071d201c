//! What was found, as plain data, and in words.

use std::fmt;

use kahan_algebra::rational::Rational;
use kahan_algebra::render::Notation;
use kahan_algebra::symbols::Symbols;

use crate::claims::proved::Formula;
use crate::drift::Drift;
use crate::integrals::composition::Survivors;
use crate::orbits::basis::Basis;
use crate::orbits::ceiling::Ceiling;
use crate::orbits::growth::GrowthVerdict;
use crate::orbits::hilbert::Hilbert;
use crate::poisson::brackets::Bracket;
use crate::poisson::hamiltonian::Hamiltonian;

/// The most characters of a claim that is printed for people to read. A longer integral is left to
/// a basis, where there is one; other longer claims stand in blocks and JSON only.
pub const MOST_READABLE: usize = 4000;

/// What is fixed, and how far to look.
#[derive(Clone, Debug)]
pub struct Options {
    /// ε, half the time step, where it is fixed; generic otherwise.
    pub eps: Option<Rational>,
    /// The parameters that are fixed, by name; the others are generic.
    pub parameters: Vec<(String, Rational)>,
    /// The degree up to which relations are looked for. Otherwise the number of variables chooses
    /// one, and the search goes on to higher degrees while something may be missing and there is
    /// time: what is found then depends on the machine's speed, all else does not.
    pub degree: Option<u32>,
    /// The number of iterates whose degrees are taken, at most.
    pub iterates: usize,
    /// The degree beyond which no further iterate is taken; up to four times as much for the first
    /// five.
    pub iterate_degree: usize,
    /// The time to spend, in seconds by the clock of whoever watches; what is not finished then is
    /// left out, and the report says so. Without a clock it does not count.
    pub seconds: f64,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            eps: None,
            parameters: Vec::new(),
            degree: None,
            iterates: 24,
            iterate_degree: 1200,
            seconds: 60.0,
        }
    }
}

/// The structure of the field.
#[derive(Clone, Debug, Default)]
pub struct StructureReport {
    /// Whether coefficients of the field depend on ε. If so, statements on the flow hold for the
    /// field at any fixed ε.
    pub depends_on_eps: bool,
    /// div f.
    pub divergence: String,
    /// Whether det(I − t f′(x)) is even in t.
    pub is_even: bool,
    /// Linear integrals of the flow, which the map keeps.
    pub linear_integrals: Vec<String>,
    /// Quadratic integrals of the flow, independent of these and of each other; the map need not
    /// keep them.
    pub quadratic_integrals: Vec<String>,
    /// The degree up to which these are all: 2, or less where the time ran out or a formula was out
    /// of reach.
    pub flow_degree: u32,
    /// How many of these the map keeps as they stand.
    pub kept: usize,
    /// The K found with f = K∇H, each with its H. They form a reduced basis, sorted by the length
    /// of the modified Hamiltonian.
    pub hamiltonians: Vec<HamiltonianReport>,
}

/// How a search for densities 1/P ended where it came to none that is proved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DensitySearch {
    /// The degree of a P that was seen modulo a prime.
    pub seen: Option<u32>,
    /// The degree up to which there is no P, as shown at random points modulo a prime.
    pub none_up_to: Option<u32>,
}

/// f = K∇H.
#[derive(Clone, Debug)]
pub struct HamiltonianReport {
    /// The number of this K, counted from 1; `None` if there is only one.
    pub number: Option<usize>,
    /// K, row by row.
    pub tensor: Vec<Vec<String>>,
    /// H
    pub hamiltonian: String,
    /// Whether the modified Hamiltonian was written out and proved as a claim.
    pub modified_is_proved: bool,
    /// Whether (I − ε² f′²)K, with the Jacobian f′ of the field, is proved to be an invariant
    /// Poisson bracket. The bracket may be too long to be written.
    pub bracket_is_proved: bool,
    /// How it is to be given, beside or instead of formulas.
    pub place: ModifiedPlace,
    /// K and H, to be written in any notation.
    pub(crate) found: Hamiltonian,
    pub(crate) symbols: Symbols,
}

impl HamiltonianReport {
    /// The modified Hamiltonian H + (x̃ − x)·∇H/3 in a notation, x̃ being the image of x.
    #[must_use]
    pub fn modified(&self, notation: &dyn Notation) -> String {
        self.found.compact(&self.symbols, notation)
    }

    /// A letter with the number of this K, if there are several K.
    #[must_use]
    pub fn label(&self, letter: &str) -> String {
        self.number.map_or_else(|| letter.to_owned(), |number| format!("{letter}{number}"))
    }
}

/// How the modified Hamiltonian is to be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModifiedPlace {
    /// Not at all: formulas and bases say what it says.
    Implied,
    /// In its compact form, and none of the formulas says it.
    Alone,
    /// In its compact form in place of one of the formulas, which is longer by far; with it, the
    /// others are as many independent integrals.
    InsteadOf(usize),
}

/// What ended the search for integrals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// No more integrals are possible: with one more every orbit would be finite, or each already
    /// is.
    Orbits,
    /// No more are possible by the [`Ceiling`].
    Ceiling,
    /// The map is one of the plane and growth is proved exponential, so no integral exists.
    Growth,
    /// The map is one of the plane, growth is observed to be linear, and a drift has infinite
    /// order. If growth is linear, then no integral exists.
    Linear,
    /// No more are possible by the drifts.
    Drifts,
    /// The degree that was asked for.
    Degree,
    /// The time.
    Time,
    /// The number of monomials, which the memory bounds.
    Size,
    /// No orbit was found that does not end at a pole.
    Poles,
}

impl Bound {
    /// In one word.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Bound::Orbits | Bound::Ceiling | Bound::Growth | Bound::Drifts => "complete",
            Bound::Linear => "growth",
            Bound::Degree => "degree",
            Bound::Time => "time",
            Bound::Size => "size",
            Bound::Poles => "poles",
        }
    }

    /// The reason why there are no more than the `known` integrals; `None` if more may exist. The
    /// drifts admit at most `by_drifts` integrals.
    pub(crate) fn complete(
        hilbert: &Hilbert,
        n: usize,
        known: usize,
        ceiling: Option<&Ceiling>,
        growth: &GrowthVerdict,
        linear: Option<usize>,
        by_drifts: usize,
    ) -> Option<Self> {
        // With n independent integrals every orbit is finite, and the map has a finite order N. At
        // generic ε this is impossible, as the N-th iterate is x + 2Nε f(x) + O(ε²).
        let most = if hilbert.period.is_some() { n } else { n - 1 };
        if known >= most {
            return Some(Bound::Orbits);
        }
        if known == 0 && growth.proof.is_some() {
            return Some(Bound::Growth);
        }
        if known >= by_drifts {
            return Some(Bound::Drifts);
        }
        if known == 0 && linear.is_some() {
            return Some(Bound::Linear);
        }
        ceiling.filter(|ceiling| known >= ceiling.integrals).map(|_| Bound::Ceiling)
    }
}

/// What was found of a field.
#[derive(Clone, Debug)]
pub struct Report {
    /// The state variables.
    pub variables: Vec<String>,
    /// The parameters that are generic.
    pub parameters: Vec<String>,
    /// d₀ = 1, d₁, d₂, …: the degrees of the iterates.
    pub degrees: Vec<usize>,
    /// Their growth.
    pub growth: GrowthVerdict,
    /// The number of iterates over which growth in the plane is linear, if linear growth excludes
    /// integrals: the map permutes the curves of a drift with infinite order.
    pub linear_iterates: Option<usize>,
    /// The Hilbert function of a generic orbit; absent where every orbit ended at a pole.
    pub hilbert: Option<Hilbert>,
    /// The number of independent algebraic integrals that orbits show or that are proved: the
    /// formulas, those in bases, the modified Hamiltonian, and those that have no formula here.
    pub independent: usize,
    /// How many there can be at most, as far as the fixed points of the map tell.
    pub ceiling: Option<Ceiling>,
    /// What ended the search for integrals.
    pub bound: Bound,
    /// The integrals of the map, independent and proved.
    pub integrals: Vec<Formula>,
    /// Hirota–Kimura bases for the integrals that have no formula here, the shortest first.
    pub bases: Vec<Basis>,
    /// Invariant densities, proved; the first of least degree.
    pub densities: Vec<Formula>,
    /// Invariant Poisson brackets, proved: with polynomial entries, the highest rank first, then
    /// from the density and the integrals.
    pub brackets: Vec<Bracket>,
    /// How many of them, the first, have polynomial entries.
    pub polynomial_brackets: usize,
    /// Proved functions whose next value follows from their value. They are functionally
    /// independent of each other and of the integrals.
    pub drifts: Vec<Drift>,
    /// How the search for densities ended.
    pub density_search: DensitySearch,
    /// The name of an unconditional density that the field brings along; a block takes one.
    pub own_density: Option<String>,
    /// The structure of the field.
    pub structure: StructureReport,
    /// What composition leaves; absent where there is nothing to leave.
    pub survivors: Option<Survivors>,
    /// Whether the time ran out before all was done.
    pub out_of_time: bool,
    /// Every verdict in words, worded as what was shown.
    pub sentences: Vec<String>,
}

impl Report {
    /// The number of independent algebraic integrals that orbits show or that are proved (a
    /// modified Hamiltonian may have a higher degree than the relations looked at).
    #[must_use]
    pub fn independent_integrals(&self) -> usize {
        self.independent
    }

    /// How many of them bases give.
    #[must_use]
    pub fn integrals_in_bases(&self) -> usize {
        self.bases.iter().map(|basis| basis.integrals.len()).sum()
    }

    /// The modified Hamiltonians that are given in compact form.
    pub fn compact(&self) -> impl Iterator<Item = &HamiltonianReport> {
        self.structure.hamiltonians.iter().filter(|found| found.place != ModifiedPlace::Implied)
    }

    /// The modified Hamiltonians that are given in compact form and stand for no formula.
    pub fn alone(&self) -> impl Iterator<Item = &HamiltonianReport> {
        self.compact().filter(|found| found.place == ModifiedPlace::Alone)
    }

    /// The indices of the formulas that the compact form of a modified Hamiltonian replaces.
    #[must_use]
    pub fn replaced(&self) -> Vec<usize> {
        let replaced = |found: &HamiltonianReport| match found.place {
            ModifiedPlace::InsteadOf(index) => Some(index),
            _ => None,
        };
        self.compact().filter_map(replaced).collect()
    }

    /// How many of the independent integrals have no formula, and no basis gives them.
    #[must_use]
    pub fn not_reached(&self) -> usize {
        let given = self.integrals.len() + self.integrals_in_bases() + self.alone().count();
        self.independent.saturating_sub(given)
    }
}

/// Why there is nothing to report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DiscoverError {
    /// A value was given for a name that is no parameter of the field.
    UnknownParameter(String),
    /// At the parameters given the field divides by zero.
    UndefinedField,
    /// ε = 0, where the map is the identity.
    ZeroStep,
    /// det A vanishes identically at the values given, so there is no map.
    NoMap,
    /// det A(x,−ε) vanishes identically at the values given: the map collapses the space.
    Collapse,
    /// The field has more variables than a search looks at.
    TooManyVariables(usize),
    /// The map in lowest terms is beyond the budget of terms, so its poles cannot be listed.
    TooLong,
}

/// The most variables of a field that a search looks at: its first elimination takes seconds there,
/// and its cost grows with their cube.
pub(crate) const MOST_VARIABLES: usize = 500;

impl fmt::Display for DiscoverError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DiscoverError::UnknownParameter(name) => {
                write!(f, "`{name}` is no parameter of the field: give values to its parameters only")
            }
            DiscoverError::UndefinedField => {
                f.write_str("the field divides by zero at these parameters: choose other values")
            }
            DiscoverError::ZeroStep => {
                f.write_str("at eps = 0 the map is the identity, which keeps everything: choose another eps")
            }
            DiscoverError::NoMap => f.write_str(
                "det A vanishes identically at these values, so there is no map to look at: choose another eps or other parameters",
            ),
            DiscoverError::Collapse => f.write_str(
                "the determinant of the Jacobian of the map vanishes identically at these values, so the map cannot be inverted and its orbits say nothing of integrals: choose another eps or other parameters",
            ),
            DiscoverError::TooManyVariables(found) => write!(
                f,
                "the field has {found} variables, and a search looks at {MOST_VARIABLES} at most: take a shorter chain, or fewer equations"
            ),
            DiscoverError::TooLong => f.write_str(
                "the map in lowest terms is beyond the budget of terms, so its poles cannot be listed: fix parameters or eps",
            ),
        }
    }
}

impl std::error::Error for DiscoverError {}
