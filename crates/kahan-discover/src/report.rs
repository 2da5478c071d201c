//! The results of a search as plain data and as sentences.

use std::fmt;

use kahan_algebra::rational::Rational;
use kahan_algebra::render::Notation;
use kahan_algebra::symbols::Symbols;

use crate::claims::proved::Formula;
use crate::drift::Drift;
use crate::integrals::composition::CompositionIntegrals;
use crate::orbits::basis::Basis;
use crate::orbits::growth::GrowthVerdict;
use crate::orbits::hilbert::Hilbert;
use crate::orbits::integral_bound::IntegralBound;
use crate::poisson::brackets::Bracket;
use crate::poisson::hamiltonian::Hamiltonian;

/// The most characters of a printed claim. A [`Basis`], if one exists, replaces a longer integral.
pub const MOST_READABLE: usize = 4000;

/// The fixed values and the limits of a search.
#[derive(Clone, Debug)]
pub struct Options {
    /// The fixed value of ε, half the time step, or `None` for a generic ε.
    pub eps: Option<Rational>,
    /// The names and values of fixed parameters. All other parameters are generic.
    pub parameters: Vec<(String, Rational)>,
    /// The highest degree of relations. With `None`, the search begins with a default degree that
    /// depends on the number of variables. Higher degrees follow while integrals may be missing and
    /// time is left.
    pub degree: Option<u32>,
    /// The most iterates of the map whose degrees are computed.
    pub iterates: usize,
    /// The computation of degrees ends with the first iterate whose degree exceeds this. The limit
    /// may be higher for the first four iterates.
    pub iterate_degree: usize,
    /// The time limit in seconds on the watch's clock. Without a clock there is no limit.
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
    /// Whether the field depends on ε. Statements about its flow then hold for each fixed ε.
    pub depends_on_eps: bool,
    /// The divergence div f.
    pub divergence: String,
    /// Whether det(I − t f′(x)) is even in t, as observed at random points modulo a prime.
    pub is_even: bool,
    /// Linear integrals of the flow, all of which the map preserves.
    pub linear_integrals: Vec<String>,
    /// Independent quadratic integrals of the flow, which the map may change.
    pub quadratic_integrals: Vec<String>,
    /// The degree, at most 2, up to which the lists of integrals of the flow are complete.
    pub flow_degree: u32,
    /// The number of listed integrals of the flow that are also integrals of the map.
    pub kept: usize,
    /// The matrices K with f = K∇H that were found, ordered by the length of the modified
    /// Hamiltonian.
    pub hamiltonians: Vec<HamiltonianReport>,
}

/// The result of a search for densities 1/P in which no density was proved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DensitySearch {
    /// The degree of a polynomial P for which 1/P seems to be a density modulo a prime.
    pub seen: Option<u32>,
    /// The degree up to which there is no density 1/P, as observed at random points modulo a prime.
    pub none_up_to: Option<u32>,
}

/// A decomposition f = K∇H of the field f with a constant antisymmetric matrix K.
#[derive(Clone, Debug)]
pub struct HamiltonianReport {
    /// The number of this K, counted from 1, or `None` if there is only one K.
    pub number: Option<usize>,
    /// The matrix K, row by row.
    pub tensor: Vec<Vec<String>>,
    /// The function H.
    pub hamiltonian: String,
    /// Whether the modified Hamiltonian was written out and proved.
    pub modified_is_proved: bool,
    /// Whether (I − ε² f′²)K is proved to be an invariant Poisson bracket of the field f.
    pub bracket_is_proved: bool,
    /// Whether the report gives the modified Hamiltonian, and instead of which formula.
    pub place: ModifiedPlace,
    pub(crate) found: Hamiltonian,
    pub(crate) symbols: Symbols,
}

impl HamiltonianReport {
    /// Writes the modified Hamiltonian H + (x̃ − x)·∇H/3, where x̃ is the image of x.
    #[must_use]
    pub fn modified(&self, notation: &dyn Notation) -> String {
        self.found.compact(&self.symbols, notation)
    }

    /// Returns `letter` followed by the number of this K, or `letter` alone if there is only one K.
    #[must_use]
    pub fn label(&self, letter: &str) -> String {
        self.number.map_or_else(|| letter.to_owned(), |number| format!("{letter}{number}"))
    }
}

/// The form in which a modified Hamiltonian is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModifiedPlace {
    /// The modified Hamiltonian is omitted, because formulas and bases imply it.
    Implied,
    /// The compact form is given, and replaces no formula.
    Alone,
    /// The compact form is given in place of the much longer formula with this index.
    InsteadOf(usize),
}

/// The reason why the search for integrals ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// The number of integrals is the largest possible: with one more, every orbit is finite.
    Orbits,
    /// The number of integrals is the upper bound of the [`IntegralBound`].
    Ceiling,
    /// Exponential growth in the plane was proved, which excludes integrals.
    Growth,
    /// Linear growth in the plane, with a drift of infinite order, excludes integrals.
    Linear,
    /// The number of integrals is the upper bound that the drifts give.
    Drifts,
    /// The search reached the degree given in the options.
    Degree,
    /// The search reached the time limit.
    Time,
    /// The search reached the largest number of monomials, which memory limits.
    Size,
    /// No orbit was found that avoids poles.
    Poles,
}

impl Bound {
    /// Returns the reason for the end of the search in one word.
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

    /// Returns the reason why no more than `known` integrals can exist, if there is one. The drifts
    /// allow at most `by_drifts` integrals.
    pub(crate) fn complete(
        hilbert: &Hilbert,
        n: usize,
        known: usize,
        ceiling: Option<&IntegralBound>,
        growth: &GrowthVerdict,
        linear: Option<usize>,
        by_drifts: usize,
    ) -> Option<Self> {
        // If all orbits have a common period N, there are n independent integrals. At generic ε
        // this is impossible, because iterate N is x + 2Nε f(x) + O(ε²).
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

/// The results for a field.
#[derive(Clone, Debug)]
pub struct Report {
    /// The names of the state variables.
    pub variables: Vec<String>,
    /// The names of the generic parameters.
    pub parameters: Vec<String>,
    /// The degrees d₀ = 1, d₁, d₂, … of the iterates.
    pub degrees: Vec<usize>,
    /// The growth of the degrees of the iterates.
    pub growth: GrowthVerdict,
    /// The number of iterates of a planar map over which degrees grow linearly, if this growth and
    /// a drift exclude integrals.
    pub linear_iterates: Option<usize>,
    /// The Hilbert function of a generic orbit, or `None` if every orbit ended at a pole.
    pub hilbert: Option<Hilbert>,
    /// The number of independent algebraic integrals that orbits show or that are proved, with or
    /// without a formula.
    pub independent: usize,
    /// The upper bound on the number of integrals that follows from fixed points of the map.
    pub ceiling: Option<IntegralBound>,
    /// The bound or limit at which the search for integrals ended.
    pub bound: Bound,
    /// Proved, independent integrals of the map.
    pub integrals: Vec<Formula>,
    /// Hirota–Kimura bases for integrals without a formula, the shortest first.
    pub bases: Vec<Basis>,
    /// Proved invariant densities, of which the first has the least degree.
    pub densities: Vec<Formula>,
    /// Proved invariant Poisson brackets: brackets with polynomial entries by descending rank, then
    /// brackets from the density and integrals.
    pub brackets: Vec<Bracket>,
    /// The number of brackets with polynomial entries.
    pub polynomial_brackets: usize,
    /// Proved drifts, independent of each other and of the integrals.
    pub drifts: Vec<Drift>,
    /// The result of the search for densities 1/P.
    pub density_search: DensitySearch,
    /// The name of a density that the `kahan!` block of the system claims unconditionally.
    pub own_density: Option<String>,
    /// The structure of the field.
    pub structure: StructureReport,
    /// The integrals that compositions of the map preserve, or `None` if orbits show no integrals.
    pub survivors: Option<CompositionIntegrals>,
    /// Whether the time ran out before the search was complete.
    pub out_of_time: bool,
    /// All conclusions as sentences, which state exactly what was shown.
    pub sentences: Vec<String>,
}

impl Report {
    /// Returns the number of independent algebraic integrals that orbits show or that are proved.
    #[must_use]
    pub fn independent_integrals(&self) -> usize {
        self.independent
    }

    /// Returns the number of integrals that are given by bases.
    #[must_use]
    pub fn integrals_in_bases(&self) -> usize {
        self.bases.iter().map(|basis| basis.integrals.len()).sum()
    }

    /// Returns the modified Hamiltonians that are given in compact form.
    pub fn compact(&self) -> impl Iterator<Item = &HamiltonianReport> {
        self.structure.hamiltonians.iter().filter(|found| found.place != ModifiedPlace::Implied)
    }

    /// Returns the modified Hamiltonians in compact form that replace no formula.
    pub fn standalone(&self) -> impl Iterator<Item = &HamiltonianReport> {
        self.compact().filter(|found| found.place == ModifiedPlace::Alone)
    }

    /// Returns the indices of formulas that compact forms replace.
    #[must_use]
    pub fn replaced(&self) -> Vec<usize> {
        let replaced = |found: &HamiltonianReport| match found.place {
            ModifiedPlace::InsteadOf(index) => Some(index),
            _ => None,
        };
        self.compact().filter_map(replaced).collect()
    }

    /// Returns the number of independent integrals that have no formula, basis or compact form.
    #[must_use]
    pub fn not_reached(&self) -> usize {
        let given = self.integrals.len() + self.integrals_in_bases() + self.standalone().count();
        self.independent.saturating_sub(given)
    }
}

/// The reason why the search cannot study a field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DiscoverError {
    /// The options fix a name that is not a parameter of the field.
    UnknownParameter(String),
    /// The field divides by zero at the given parameters.
    UndefinedField,
    /// The options fix ε = 0, at which the map is the identity.
    ZeroStep,
    /// The matrix I − ε f′ is singular everywhere at the given values, so no map exists.
    NoMap,
    /// The matrix I + ε f′ is singular everywhere at the given values, so the image of the map has
    /// a lower dimension than the space.
    Collapse,
    /// The field has this number of variables, which is more than a search accepts.
    TooManyVariables(usize),
    /// The map in lowest terms is too long to list its poles.
    TooLong,
}

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
