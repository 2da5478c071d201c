//! Claims: formulas of the paper and of further systems. Each has a statement, the method that
//! establishes it, and a place in the paper if known.

use kahan_algebra::rational::Rational;

use super::erratum::Erratum;
use super::figures::Figure;
use super::formula::with_definitions;
use super::id::Id;
use super::section::Section;

/// A formula of the paper: an equation, a cell of a table, or a sentence with a number.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The stable identifier, for example `table3.e4.P23`.
    pub id: Id,
    /// The section of the paper.
    pub section: Section,
    /// The name of the system in commands, or `general`.
    pub system: &'static str,
    /// The place in the paper, in words, for example `Table 3, i = 4, P23`.
    pub place: String,
    /// The erratum that the claim corrects or explains.
    pub erratum: Option<Erratum>,
    /// The statement, in the language of [`formula`](super::formula) or as a claim of `kahan!`.
    pub statement: String,
    pub(super) basis: ProofMethod,
}

/// The method by which a claim is established.
#[derive(Clone, Debug)]
pub(super) enum ProofMethod {
    /// A claim of the system's own `kahan!` block.
    Block {
        /// The claim's index in the block.
        index: usize,
    },
    Formula {
        /// Definitions that the statement uses. Other claims prove them.
        given: String,
        /// Intervals from which numerical tests draw values of names, as (name, low, high).
        domain: Vec<(String, Rational, Rational)>,
        /// The orbit on which quantities are measured, if the claim is about an orbit.
        orbit: Option<&'static Figure>,
        misprint: Option<Misprint>,
    },
}

/// A misprinted formula, and an exact point at which it is false.
#[derive(Clone, Debug)]
pub(super) struct Misprint {
    pub(super) printed: String,
    /// Definitions of a point's coordinates, and the values of both sides at this point. Empty if a
    /// measurement refutes the formula.
    pub(super) counterexample: String,
}

/// The outcome of checking a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Both sides have equal expansions over ℚ, and agree modulo primes.
    Proved,
    /// Both sides agree at random points modulo primes, with an error probability below 2⁻¹⁰⁰.
    ProvedModP,
    /// Both sides agree at this number of exact points.
    Exact(u32),
    /// Both sides agree to this number of decimals.
    Numerical(u32),
    /// The printed form is refuted, and the corrected form established.
    Misprint,
    /// The claim fails.
    Failed,
}

/// An outcome with its evidence.
#[derive(Clone, Debug)]
pub struct Established {
    /// The outcome.
    pub outcome: Outcome,
    /// The evidence, or the reason of the failure.
    pub detail: String,
}

impl Outcome {
    /// The keys of outcomes in `kahan verify --json`, from the strongest outcome to the weakest.
    const KEYS: [&str; Outcome::KINDS] =
        ["proved", "proved-mod-p", "exact", "numerical", "misprint", "failed"];
    /// The number of kinds of outcomes.
    pub const KINDS: usize = 6;

    /// Returns the index of the outcome's kind, from the strongest to the weakest.
    #[must_use]
    pub fn place(self) -> usize {
        match self {
            Outcome::Proved => 0,
            Outcome::ProvedModP => 1,
            Outcome::Exact(_) => 2,
            Outcome::Numerical(_) => 3,
            Outcome::Misprint => 4,
            Outcome::Failed => 5,
        }
    }

    /// Counts how many outcomes are of each kind.
    #[must_use]
    pub fn counts(outcomes: impl IntoIterator<Item = Self>) -> [usize; Outcome::KINDS] {
        let mut counts = [0; Outcome::KINDS];
        outcomes.into_iter().for_each(|outcome| counts[outcome.place()] += 1);
        counts
    }

    /// Returns the key of the outcome in `kahan verify --json`.
    #[must_use]
    pub fn key(self) -> &'static str {
        Self::KEYS[self.place()]
    }

    /// Returns the outcome in words.
    #[must_use]
    pub fn words(self) -> String {
        match self {
            Outcome::Proved => "proved".to_owned(),
            Outcome::ProvedModP => "proved mod p".to_owned(),
            Outcome::Exact(points) => format!("exact at {points} points"),
            Outcome::Numerical(decimals) => format!("numerical to 1e-{decimals}"),
            Outcome::Misprint => "misprint: corrected form established".to_owned(),
            Outcome::Failed => "FAILED".to_owned(),
        }
    }
}

impl Claim {
    /// Returns whether the claim is about measurements on an exact orbit.
    #[must_use]
    pub fn is_measured(&self) -> bool {
        matches!(self.basis, ProofMethod::Formula { orbit: Some(_), .. })
    }

    pub(super) fn new<const N: usize>(
        section: Section,
        id: [&str; N],
        system: &'static str,
        place: impl Into<String>,
        statement: impl Into<String>,
    ) -> Self {
        let basis =
            ProofMethod::Formula { given: String::new(), domain: Vec::new(), orbit: None, misprint: None };
        let (place, statement) = (place.into(), statement.into());
        Claim { id: Id::of(id), section, system, place, erratum: None, statement, basis }
    }

    pub(super) fn given_definitions(mut self, definitions: &str) -> Self {
        if let ProofMethod::Formula { given, .. } = &mut self.basis {
            definitions.clone_into(given);
        }
        self
    }

    /// Puts the definitions that the statement uses in front of the statement.
    pub(super) fn with_used_definitions(mut self, definitions: &str) -> Self {
        self.statement = with_definitions(definitions, &self.statement);
        self
    }

    pub(super) fn within(mut self, name: &str, low: Rational, high: Rational) -> Self {
        if let ProofMethod::Formula { domain, .. } = &mut self.basis {
            domain.push((name.to_owned(), low, high));
        }
        self
    }

    pub(super) fn on(mut self, figure: &'static Figure) -> Self {
        if let ProofMethod::Formula { orbit, .. } = &mut self.basis {
            *orbit = Some(figure);
        }
        self
    }

    pub(super) fn explaining(self, erratum: Erratum) -> Self {
        Claim { erratum: Some(erratum), ..self }
    }

    pub(super) fn misprinted(mut self, erratum: Erratum, printed: &str) -> Self {
        if let ProofMethod::Formula { misprint, .. } = &mut self.basis {
            *misprint = Some(Misprint { printed: printed.to_owned(), counterexample: String::new() });
        }
        self.explaining(erratum)
    }

    pub(super) fn refuted(mut self, point: &str) -> Self {
        if let ProofMethod::Formula { misprint: Some(misprint), .. } = &mut self.basis {
            point.clone_into(&mut misprint.counterexample);
        }
        self
    }

    /// Returns the misprinted formula, if the claim corrects one.
    #[must_use]
    pub fn printed(&self) -> Option<&str> {
        match &self.basis {
            ProofMethod::Formula { misprint: Some(misprint), .. } => Some(&misprint.printed),
            _ => None,
        }
    }

    /// Returns the place in the paper, followed by the erratum if there is one.
    #[must_use]
    pub fn source(&self) -> String {
        let place = &self.place;
        self.erratum.map_or_else(|| place.clone(), |erratum| format!("{place} (erratum {erratum})"))
    }
}
