//! A formula of the paper: where it stands, what it says, and how it can be checked.

use kahan_algebra::rational::Rational;

use super::erratum::Erratum;
use super::figures::Figure;
use super::formula::with_definitions;
use super::id::Id;
use super::section::Section;

/// One formula of the paper (an equation, a cell of a table, a statement with a number in it).
#[derive(Clone, Debug)]
pub struct Claim {
    /// Its stable name: `table3.e4.P23`.
    pub id: Id,
    /// The part of the paper in which it stands.
    pub section: Section,
    /// The command name of the system it is about, or `general`.
    pub system: &'static str,
    /// Where in the paper, in words: `Table 3, i = 4, P23`.
    pub place: String,
    /// The erratum that it corrects or explains.
    pub erratum: Option<Erratum>,
    /// What it says: a statement of the language of [`formula`](super::formula), or a claim of
    /// `kahan!`.
    pub statement: String,
    pub(super) basis: Basis,
}

/// What a claim rests on.
#[derive(Clone, Debug)]
pub(super) enum Basis {
    /// A claim of the system's own `kahan!` block: invariance, proved by the macro's prover.
    Block {
        /// Which claim of the block it is.
        index: usize,
    },
    /// Relations between formulas.
    Formula {
        /// Definitions that the statement uses: what other claims establish.
        given: String,
        /// Intervals for a numerical test.
        domain: Vec<(String, Rational, Rational)>,
        /// The orbit on which it is measured.
        orbit: Option<&'static Figure>,
        /// What the paper prints instead, where that is wrong.
        misprint: Option<Misprint>,
    },
}

/// A formula as printed, and an exact point that refutes it.
#[derive(Clone, Debug)]
pub(super) struct Misprint {
    /// The printed relation, in the language of formulas.
    pub(super) printed: String,
    /// Definitions of all names (the point), and the values of both sides there; empty where a
    /// measured value refutes.
    pub(super) counterexample: String,
}

/// How a claim came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Both sides agree expanded over ℚ (and modulo primes).
    Proved,
    /// Both sides agree at random points modulo primes, error below 2⁻¹⁰⁰.
    ProvedModP,
    /// Both sides agree at so many exact points.
    Exact(u32),
    /// Both sides agree to 10⁻ᵏ.
    Numerical(u32),
    /// The printed form is refuted, the corrected form established.
    Misprint,
    /// It does not hold.
    Failed,
}

/// The outcome of one claim, with what was found.
#[derive(Clone, Debug)]
pub struct Established {
    /// How it came out.
    pub outcome: Outcome,
    /// What that rests on, or what is wrong.
    pub detail: String,
}

impl Outcome {
    /// The keys in `kahan verify --json`, from the strongest outcome to the worst.
    const KEYS: [&str; Outcome::KINDS] =
        ["proved", "proved-mod-p", "exact", "numerical", "misprint", "failed"];
    /// How many kinds of outcomes there are.
    pub const KINDS: usize = 6;

    /// Its place among the kinds of outcomes, from the strongest to the worst.
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

    /// How many there are of each kind.
    #[must_use]
    pub fn counts(outcomes: impl IntoIterator<Item = Self>) -> [usize; Outcome::KINDS] {
        let mut counts = [0; Outcome::KINDS];
        outcomes.into_iter().for_each(|outcome| counts[outcome.place()] += 1);
        counts
    }

    /// The key in `kahan verify --json`.
    #[must_use]
    pub fn key(self) -> &'static str {
        Self::KEYS[self.place()]
    }

    /// The outcome in words.
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
    /// Whether it is measured on an exact orbit.
    #[must_use]
    pub fn is_measured(&self) -> bool {
        matches!(self.basis, Basis::Formula { orbit: Some(_), .. })
    }

    /// A claim about formulas.
    pub(super) fn new<const N: usize>(
        section: Section,
        id: [&str; N],
        system: &'static str,
        place: impl Into<String>,
        statement: impl Into<String>,
    ) -> Self {
        let basis = Basis::Formula { given: String::new(), domain: Vec::new(), orbit: None, misprint: None };
        let (place, statement) = (place.into(), statement.into());
        Claim { id: Id::of(id), section, system, place, erratum: None, statement, basis }
    }

    /// Sets definitions that the statement uses.
    pub(super) fn given(mut self, definitions: &str) -> Self {
        if let Basis::Formula { given, .. } = &mut self.basis {
            definitions.clone_into(given);
        }
        self
    }

    /// Puts those of the definitions that the statement uses before it: they are shown, checked and
    /// mutated with it.
    pub(super) fn spelling(mut self, definitions: &str) -> Self {
        self.statement = with_definitions(definitions, &self.statement);
        self
    }

    /// Draws a name from (low, high) in numerical tests.
    pub(super) fn within(mut self, name: &str, low: Rational, high: Rational) -> Self {
        if let Basis::Formula { domain, .. } = &mut self.basis {
            domain.push((name.to_owned(), low, high));
        }
        self
    }

    /// Measures on the orbit of a figure.
    pub(super) fn on(mut self, figure: &'static Figure) -> Self {
        if let Basis::Formula { orbit, .. } = &mut self.basis {
            *orbit = Some(figure);
        }
        self
    }

    /// Says which erratum the claim explains.
    pub(super) fn explaining(self, erratum: Erratum) -> Self {
        Claim { erratum: Some(erratum), ..self }
    }

    /// Adds the erratum that the claim corrects, and what is printed.
    pub(super) fn misprinted(mut self, erratum: Erratum, printed: &str) -> Self {
        if let Basis::Formula { misprint, .. } = &mut self.basis {
            *misprint = Some(Misprint { printed: printed.to_owned(), counterexample: String::new() });
        }
        self.explaining(erratum)
    }

    /// Adds what refutes the misprint.
    pub(super) fn refuted(mut self, point: &str) -> Self {
        if let Basis::Formula { misprint: Some(misprint), .. } = &mut self.basis {
            point.clone_into(&mut misprint.counterexample);
        }
        self
    }

    /// What is printed instead, where the claim corrects a misprint.
    #[must_use]
    pub fn printed(&self) -> Option<&str> {
        match &self.basis {
            Basis::Formula { misprint: Some(misprint), .. } => Some(&misprint.printed),
            _ => None,
        }
    }

    /// Its place in the paper, with its erratum.
    #[must_use]
    pub fn source(&self) -> String {
        let place = &self.place;
        self.erratum.map_or_else(|| place.clone(), |erratum| format!("{place} (erratum {erratum})"))
    }
}
