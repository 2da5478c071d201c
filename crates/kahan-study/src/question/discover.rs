//! Searches, from the equations of a field, for integrals, densities, brackets and drifts of its
//! map, and for Hamiltonians.

use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::syntax::{ClaimBody, ClaimKind, TensorEntry};
use kahan_algebra::system::{Claim, System};
use kahan_discover::claims::proved::Formula;
use kahan_discover::integrals::composition::CompositionIntegrals;
use kahan_discover::modular::monomials::Monomials;
use kahan_discover::orbits::basis::Basis;
use kahan_discover::orbits::hilbert::{MOST_MONOMIALS_AT_ALL, default_degree};
use kahan_discover::report::{HamiltonianReport, MOST_READABLE, ModifiedPlace};
use kahan_discover::{Options, Report, Unwatched, Watch, discover};
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Map, Value, json};

use crate::error::StudyError;
use crate::named::Names;
use crate::numbers::exact::{self, ExactJson};
use crate::rows::{Column, StoredColumn};
use crate::study::Study;

use super::over::{AtCell, CellEntry, column};
use super::seconds_since;

/// A request for the structures that the map of a field preserves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Discover {
    /// ε, half the time step, if fixed; otherwise ε is generic.
    #[serde(with = "exact")]
    pub eps: Option<Rational>,
    /// The largest degree of the sought polynomials that vanish on orbits. If `None`, the search
    /// chooses the degree.
    pub degree: Option<u32>,
    /// The time limit in seconds.
    pub seconds: f64,
}

impl Default for Discover {
    fn default() -> Self {
        Discover { eps: None, degree: None, seconds: 60.0 }
    }
}

/// The findings about a field.
#[derive(Clone, Debug)]
pub struct Discovered {
    /// The name of the system.
    pub system: String,
    /// The field as it was before the search: with its claims, without the findings.
    pub field: System,
    /// The fixed parameters; the others are generic.
    pub fixed: Names<Rational>,
    /// ε, if fixed.
    pub eps: Option<Rational>,
    /// All findings.
    pub report: Report,
    /// The duration of the search in seconds; `None` without a clock.
    pub seconds: Option<f64>,
}

impl Discover {
    /// Searches for integrals, densities, brackets and drifts of the map, and also for Hamiltonians
    /// of the field. Parameters without values are generic. Reports each proved result to `watch`.
    ///
    /// # Errors
    /// [`StudyError::Discover`], or [`StudyError::Degree`] if the degree is too large.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Discovered, StudyError> {
        let begun = watch.now();
        let options = options(study, &self.eps, self.degree, self.seconds)?;
        let report = discover(study.system(), &options, watch);
        let report = report.map_err(|why| StudyError::Discover { system: study.name().to_owned(), why })?;
        Ok(Discovered {
            system: study.name().to_owned(),
            field: study.system().clone(),
            fixed: options.parameters,
            eps: options.eps,
            report,
            seconds: seconds_since(begun, watch),
        })
    }
}

impl AtCell for Discover {
    fn place(&self) -> (Option<&Rational>, Option<&[Rational]>) {
        (self.eps.as_ref(), None)
    }

    fn columns(&self, _: &[String]) -> Vec<(Column, StoredColumn)> {
        vec![
            column(
                "independent_integrals",
                "number of independent algebraic integrals that were seen",
                StoredColumn::Integer,
            ),
            column("growth", "how the degrees of iterates grow", StoredColumn::Text),
            column("entropy", "algebraic entropy", StoredColumn::F64),
            column("integrals", "integrals in the language of kahan!, proved", StoredColumn::Text),
            column("densities", "invariant densities, proved", StoredColumn::Text),
        ]
    }

    fn entries(&self, eps: &Rational, at: &[Rational], study: &Study) -> Vec<CellEntry> {
        let degree = self.degree.or(Some(default_degree(at.len())));
        let asked = Discover { eps: Some(eps.clone()), degree, ..self.clone() };
        let (integrals, growth, entropy, formulas) = match asked.ask(study, &Unwatched) {
            Ok(found) => {
                let growth = &found.report.growth.growth;
                let formulas =
                    [ClaimKind::Integral, ClaimKind::Density].map(|kind| found.lines(kind).join("\n"));
                (
                    found.report.independent_integrals() as i64,
                    growth.word().to_owned(),
                    growth.entropy(),
                    formulas,
                )
            }
            Err(StudyError::Discover { why, .. }) => (-1, why.to_string(), f64::NAN, Default::default()),
            Err(why) => (-1, why.to_string(), f64::NAN, Default::default()),
        };
        let seen = [CellEntry::Integer(integrals), CellEntry::Text(growth), CellEntry::Float(entropy)];
        seen.into_iter().chain(formulas.map(CellEntry::Text)).collect()
    }
}

pub(super) fn options(
    study: &Study,
    eps: &Option<Rational>,
    degree: Option<u32>,
    seconds: f64,
) -> Result<Options, StudyError> {
    let (eps, parameters, degree) = (eps.clone(), study.fixed(), within_reach(degree, study)?);
    Ok(Options { eps, parameters, degree, seconds, ..Options::default() })
}

fn within_reach(degree: Option<u32>, study: &Study) -> Result<Option<u32>, StudyError> {
    let variables = study.variables().len();
    let is_within = |degree: u32| Monomials::count(variables, degree) <= MOST_MONOMIALS_AT_ALL;
    match degree.filter(|&asked| !is_within(asked)) {
        None => Ok(degree),
        Some(asked) => Err(StudyError::Degree {
            asked,
            variables,
            most: (1..asked).take_while(|&lower| is_within(lower)).last(),
        }),
    }
}

impl Discovered {
    /// Iterates over the proved claims with their texts: integrals, densities, brackets, drifts.
    pub fn claims(&self) -> impl Iterator<Item = (&str, &Claim)> {
        let Report { integrals, densities, brackets, drifts, .. } = &self.report;
        let formulas = integrals.iter().chain(densities).map(|formula| (&*formula.text, &formula.claim));
        let brackets = brackets.iter().map(|bracket| (&*bracket.text, &bracket.claim));
        formulas.chain(brackets).chain(drifts.iter().map(|drift| (&*drift.text, &drift.claim)))
    }

    fn lines(&self, kind: ClaimKind) -> Vec<&str> {
        self.claims().filter(|(_, claim)| claim.kind == kind).map(|(text, _)| text).collect()
    }

    /// Iterates over the claims of the [readable field](Self::readable).
    fn readable_parts(&self) -> impl Iterator<Item = (&str, &Claim)> {
        let replaced = self.report.replaced();
        // `replaced` holds indices of integrals, which are the first claims.
        let kept = self.claims().enumerate().filter(move |(index, _)| !replaced.contains(index));
        kept.map(|(_, claim)| claim).filter(|(text, _)| text.len() <= MOST_READABLE)
    }

    /// Returns the texts of the claims of the [readable field](Self::readable).
    #[must_use]
    pub fn readable_claims(&self) -> Vec<&str> {
        self.readable_parts().map(|(text, _)| text).collect()
    }

    /// Returns the field with the claims that are short enough to display, without the integrals
    /// for which the report gives a shorter modified Hamiltonian.
    #[must_use]
    pub fn readable(&self) -> System {
        let claims = self.readable_parts().map(|(_, claim)| claim.clone()).collect();
        System { claims, ..self.field.clone() }
    }

    /// Returns the field with all findings as its claims.
    #[must_use]
    pub fn claimed(&self) -> System {
        let claims = self.claims().map(|(_, claim)| claim.clone()).collect();
        System { claims, ..self.field.clone() }
    }

    /// Writes each claim, and the Hamiltonian if there is one, as a JSON object.
    fn parts(&self) -> Vec<Value> {
        let expression = |body: &ClaimBody| match body {
            ClaimBody::Function(value) => Text.expression(value),
            ClaimBody::Recurrence { function, next } => {
                format!("{} by {}", Text.expression(function), Text.expression(next))
            }
            ClaimBody::Tensor(entries) => {
                let entry = |entry: &TensorEntry| {
                    let (row, column) = (&entry.row.text, &entry.column.text);
                    format!("{{{row}, {column}}} = {};", Text.expression(&entry.value))
                };
                entries.iter().map(entry).collect::<Vec<_>>().join(" ")
            }
        };
        let part = |kind, name: &str, value: &str| json!({"kind": kind, "name": name, "expression": value});
        let claims = self
            .claims()
            .map(|(_, claim)| part(claim.kind.keyword(), &claim.name.text, &expression(&claim.body)));
        // The Hamiltonian of a matrix K1 is called H_K1, since H1, H2, … are names of integrals.
        let hamiltonians = self.report.structure.hamiltonians.iter().map(|found| {
            let name = found.number.map_or_else(|| "H".to_owned(), |number| format!("H_K{number}"));
            part("hamiltonian", &name, &found.hamiltonian)
        });
        claims.chain(hamiltonians).collect()
    }
}

/// Writes, as a JSON object, a relation Σ c(m)·m = 0 of monomials m that holds at all points of an
/// orbit. Quotients of the coefficients c(m) are integrals.
fn relation(basis: &Basis, variables: &[String]) -> Value {
    let monomials = basis.monomial_texts(variables);
    let unit = &monomials[basis.unit];
    let quotient = |&place: &usize| format!("c[{}]/c[{unit}]", monomials[place]);
    json!({
        "monomials": monomials,
        "integrals": basis.integrals.iter().map(quotient).collect::<Vec<_>>(),
        "terms": basis.term_texts(variables, &Text),
        "points": basis.points(),
        "outcome": if basis.proof.is_some() { "proved-mod-p" } else { "seen" },
    })
}

/// Writes, as a JSON object, the Hamiltonian H and the matrix K for which the field is K grad H,
/// and the modified Hamiltonian.
fn hamiltonian(found: &HamiltonianReport) -> Value {
    json!({
        "K": found.tensor,
        "H": found.hamiltonian,
        "modified_is_proved": found.modified_is_proved,
        "bracket_is_proved": found.bracket_is_proved,
        "is_compact": found.place != ModifiedPlace::Implied,
        "modified": found.modified(&Text),
    })
}

/// Writes the integrals, and quotients of integrals, that stay constant if ε varies between steps.
fn survivors(found: &CompositionIntegrals, integrals: &[Formula]) -> Value {
    let name = |index: usize| integrals[index].name();
    let kept = (0..found.formulas.len()).filter(|&index| found.formulas[index]);
    let quotient = |&(above, below): &(usize, usize)| format!("{}/{}", name(above), name(below));
    json!({
        "independent_integrals": found.hilbert.integrals,
        "hilbert": found.hilbert.values,
        "formulas": kept.map(name).collect::<Vec<_>>(),
        "quotients": found.quotients.iter().map(quotient).collect::<Vec<_>>(),
    })
}

impl Serialize for Discovered {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let report = &self.report;
        let structure = &report.structure;
        let hilbert = report.hilbert.as_ref();
        let fixed = self.fixed.iter().map(|(name, value)| (name.clone(), value.to_json()));
        let generic = report.parameters.iter().map(|name| (name.clone(), Value::Null));
        let ranks: Vec<usize> = report.brackets.iter().map(|bracket| bracket.rank).collect();
        let bases: Vec<Value> = report.bases.iter().map(|basis| relation(basis, &report.variables)).collect();
        let hamiltonians: Vec<Value> = structure.hamiltonians.iter().map(hamiltonian).collect();
        let survivors = report.survivors.as_ref().map(|found| survivors(found, &report.integrals));
        let mut object = serializer.serialize_map(None)?;
        object.serialize_entry("system", &self.system)?;
        object.serialize_entry("variables", &report.variables)?;
        object.serialize_entry("parameters", &fixed.chain(generic).collect::<Map<_, _>>())?;
        object.serialize_entry("eps", &self.eps.to_json())?;
        object.serialize_entry("hilbert", hilbert.map_or(&[][..], |hilbert| &hilbert.values))?;
        object.serialize_entry("monomials", hilbert.map_or(&[][..], |hilbert| &hilbert.full))?;
        object.serialize_entry("independent_integrals", &report.independent_integrals())?;
        object
            .serialize_entry("most_integrals", &report.ceiling.as_ref().map(|ceiling| ceiling.integrals))?;
        object.serialize_entry("bounded_by", report.bound.word())?;
        object.serialize_entry("degrees", &report.degrees)?;
        object.serialize_entry("growth", report.growth.growth.word())?;
        object.serialize_entry("growth_proved", &report.growth.proof.is_some())?;
        object.serialize_entry("entropy", &report.growth.growth.entropy())?;
        object.serialize_entry("linear_integrals", &structure.linear_integrals)?;
        object.serialize_entry("quadratic_integrals_of_the_flow", &structure.quadratic_integrals)?;
        object.serialize_entry("integrals", &self.lines(ClaimKind::Integral))?;
        object.serialize_entry("densities", &self.lines(ClaimKind::Density))?;
        object.serialize_entry("brackets", &self.lines(ClaimKind::Bracket))?;
        object.serialize_entry("bracket_ranks", &ranks)?;
        object.serialize_entry("drifts", &self.lines(ClaimKind::Drift))?;
        object.serialize_entry("found", &self.parts())?;
        object.serialize_entry("bases", &bases)?;
        object.serialize_entry("divergence", &structure.divergence)?;
        object.serialize_entry("is_even", &structure.is_even)?;
        object.serialize_entry("hamiltonian", &hamiltonians.first())?;
        object.serialize_entry("hamiltonians", &hamiltonians)?;
        object.serialize_entry("survivors", &survivors)?;
        object.serialize_entry("sentences", &report.sentences)?;
        object.serialize_entry("out_of_time", &report.out_of_time)?;
        object.serialize_entry("seconds", &self.seconds)?;
        object.end()
    }
}
