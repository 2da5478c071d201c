//! The claims of the paper, section by section, and then those of further systems.

mod appendix;
mod diophantine;
mod e7_e8_e9;
mod flows;
mod general;
mod lotka_volterra;
mod maps;
mod solutions;
mod structures;
mod tables;
mod text;

use super::claim::{Claim, ProofMethod};
use super::evaluate::Models;
use super::id::Id;
use super::section::Section;
use super::verdict::OpenQuestion;

use kahan_algebra::render::claim_text;
use kahan_algebra::syntax::ClaimKind;

use kahan_systems::entry::Entry;
use kahan_systems::registry::{FURTHER, SYSTEMS};

pub use structures::{StructureRow, structure};

/// Definitions that every statement about a system with states x, y, z may use.
pub(super) const DEFINITIONS: &str = "
    dot(F) := f1*d(F, x) + f2*d(F, y) + f3*d(F, z);
    divergence(F) := d(F*f1, x) + d(F*f2, y) + d(F*f3, z);
    bracket(a, b, c, F, G) := a*(d(F, x)*d(G, y) - d(F, y)*d(G, x)) + b*(d(F, y)*d(G, z) - d(F, z)*d(G, y))
        + c*(d(F, z)*d(G, x) - d(F, x)*d(G, z));
    jacobi(a, b, c) := b*(d(a, y) - d(c, z)) + c*(d(b, z) - d(a, x)) + a*(d(c, x) - d(b, y));
";

/// A field in three dimensions with generic coefficients.
pub(super) const GENERAL_FIELD: &str = "
    xdot = a1*x^2 + a2*x*y + a3*x*z + a4*y^2 + a5*y*z + a6*z^2 + a7*x + a8*y + a9*z + a0;
    ydot = b1*x^2 + b2*x*y + b3*x*z + b4*y^2 + b5*y*z + b6*z^2 + b7*x + b8*y + b9*z + b0;
    zdot = c1*x^2 + c2*x*y + c3*x*z + c4*y^2 + c5*y*z + c6*z^2 + c7*x + c8*y + c9*z + c0;
";

/// A homogeneous quadratic field in three dimensions with generic coefficients.
pub(super) const HOMOGENEOUS_FIELD: &str = "
    xdot = a1*x^2 + a2*x*y + a3*x*z + a4*y^2 + a5*y*z + a6*z^2;
    ydot = b1*x^2 + b2*x*y + b3*x*z + b4*y^2 + b5*y*z + b6*z^2;
    zdot = c1*x^2 + c2*x*y + c3*x*z + c4*y^2 + c5*y*z + c6*z^2;
";

/// Questions that the paper leaves open.
pub const OPEN: &[OpenQuestion] = &[
    OpenQuestion {
        statement: "Lax pairs",
        detail: "none is known for the maps dE1 to dE6, though they are integrable",
    },
    OpenQuestion {
        statement: "The three other flows",
        detail: "Kahan's map of the three remaining pairs of compatible Lie-Poisson brackets of the classification, whose flows \
                 have transcendental solutions, is not treated",
    },
    OpenQuestion {
        statement: "Mickens' scheme",
        detail: "his discretisation of the Lotka-Volterra flow keeps the same symplectic form and closed level sets; why it and \
                 Kahan's do so for every step is not explained by an integral",
    },
    OpenQuestion {
        statement: "The growth constant C2 of dE7",
        detail: "13.4395 by p-adic bookkeeping that matches the orbit; not proved",
    },
];

pub(super) fn claims(models: &Models) -> Vec<Claim> {
    [
        general::claims(),
        lotka_volterra::claims(),
        maps::claims(),
        tables::claims(),
        block_claims(models, SYSTEMS, in_the_paper),
        flows::claims(),
        solutions::claims(),
        e7_e8_e9::claims(),
        diophantine::claims(),
        appendix::claims(),
        block_claims(models, FURTHER, |_, _| Section::Beyond),
    ]
    .concat()
}

const TREATED_AS_A_WHOLE: [(&str, Section); 5] = [
    ("lv", Section::Method),
    ("euler", Section::Brackets),
    ("e7", Section::Transcendental),
    ("e8", Section::Transcendental),
    ("e9", Section::Transcendental),
];

/// Returns the section in which the paper makes claims of this kind about a system.
fn in_the_paper(system: &str, kind: ClaimKind) -> Section {
    let whole = TREATED_AS_A_WHOLE.iter().find(|(treated, _)| *treated == system);
    whole.map_or_else(
        || if kind == ClaimKind::Bracket { Section::MapPairs } else { Section::Maps },
        |(_, section)| *section,
    )
}

fn block_claims(
    models: &Models,
    systems: &[Entry],
    section: impl Fn(&str, ClaimKind) -> Section,
) -> Vec<Claim> {
    let mut claims = Vec::new();
    for entry in systems {
        let system = models[entry.command].system();
        claims.extend(system.claims.iter().enumerate().map(|(index, claim)| Claim {
            id: Id::of([entry.command, &claim.name.text]),
            section: section(entry.command, claim.kind),
            system: entry.command,
            place: entry.source(&claim.name.text).unwrap_or_default().to_owned(),
            erratum: None,
            statement: claim_text(system, claim),
            basis: ProofMethod::Block { index },
        }));
    }
    claims
}
