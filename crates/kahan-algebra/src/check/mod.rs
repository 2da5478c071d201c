//! Checks a syntax tree and returns a system or a family.
//!
//! Names are checked first, then constants, equations and claims. Each mistake is reported once,
//! because later stages see a harmless replacement. A block with a mistake is [`Broken`]: it has
//! the mistakes, and a [`StandIn`] that declares its type.

mod claims;
mod conditions;
mod constants;
mod equations;
mod expand;
mod family;
mod lower;
mod names;
mod stand_in;

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_syntax::parse;
use kahan_syntax::syntax::{Block, Header};
use kahan_syntax::token::{Span, Token};

use crate::family::Family;
use crate::field::Field;
use crate::subexpressions::FieldWithSubexpressions;
use crate::system::{Claim, System};

use names::Scope;

pub(crate) use family::check_family;
pub use kahan_syntax::spelling::{nearest, number};
pub use stand_in::{Broken, StandIn};

const MOST_EQUATIONS: usize = 10_000;
/// The most states, parameters, constants and claims in a block. An array counts once for each site
/// of the stencil.
const MOST_NAMES: usize = 10_000;
const MOST_CLAIMS: usize = 500;

/// Returns the diagnostic for a family that was given without a number of sites, where a system is
/// needed.
#[must_use]
pub fn number_of_sites_wanted(span: Span) -> Diagnostic {
    let message = "a family of equations stands here, and the number of its sites is not known";
    let help = "say how many there are: `--sites 8` in the command, `sites=8` in Python; programs step chains of any length, by `kahan_runtime::Lattice` or `kahan.Lattice`";
    Diagnostic::new(Kind::Empty, span, message, help)
}

/// A block after the check.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "there is one, and it is handed on once")]
pub enum Checked {
    /// A system of plain equations without mistakes.
    System(System),
    /// A family without mistakes.
    Family(Family),
    /// A block with mistakes.
    Broken(Broken),
}

impl Checked {
    /// Returns the header of the block.
    #[must_use]
    pub fn header(&self) -> Option<&Header> {
        match self {
            Checked::System(system) => system.header.as_ref(),
            Checked::Family(family) => family.header.as_ref(),
            Checked::Broken(broken) => broken.stand_in.header.as_ref(),
        }
    }

    /// Returns the mistakes, ordered by place.
    #[must_use]
    pub fn diagnostics(&self) -> &[Diagnostic] {
        match self {
            Checked::System(_) | Checked::Family(_) => &[],
            Checked::Broken(broken) => &broken.diagnostics,
        }
    }

    /// Returns the system of a block with plain equations.
    ///
    /// # Errors
    /// Returns the mistakes. If the block is a family, this is a mistake, too.
    pub fn system(self) -> Result<System, Vec<Diagnostic>> {
        match self {
            Checked::System(system) => Ok(system),
            Checked::Family(family) => Err(vec![number_of_sites_wanted(family.span)]),
            Checked::Broken(broken) => Err(broken.diagnostics),
        }
    }

    /// Returns the family. Returns `None` for plain equations.
    ///
    /// # Errors
    /// Returns the mistakes.
    pub fn family(self) -> Result<Option<Family>, Vec<Diagnostic>> {
        match self {
            Checked::System(_) => Ok(None),
            Checked::Family(family) => Ok(Some(family)),
            Checked::Broken(broken) => Err(broken.diagnostics),
        }
    }
}

fn report_size(block: &Block, diagnostics: &mut Diagnostics) -> bool {
    if let Some(equation) = block.equations.get(MOST_EQUATIONS) {
        let message = format!("the block has more than {MOST_EQUATIONS} equations");
        let help = "write the equations of many sites once, as in `for i in periodic { x[i]dot = x[i+1]; }`";
        diagnostics.report(Kind::TooLarge, equation.state.span, message, help);
        return true;
    }
    if let Some(claim) = block.claims.iter().chain(&block.hamiltonians).nth(MOST_CLAIMS) {
        let message = format!("the block has more than {MOST_CLAIMS} claims");
        let help = "leave those out that follow from others";
        diagnostics.report(Kind::TooLarge, claim.name.span, message, help);
        return true;
    }
    let parameters = block.header.as_ref().map_or(0, |header| header.parameters.len());
    report_names(block.equations.len() + parameters + block.constants.len(), block, diagnostics)
}

fn report_names(count: usize, block: &Block, diagnostics: &mut Diagnostics) -> bool {
    if count <= MOST_NAMES {
        return false;
    }
    let span = block.equations.first().map_or(Span::token(0), |equation| equation.state.span);
    diagnostics.report(
        Kind::TooLarge,
        span,
        format!("the block has {count} names, and at most {MOST_NAMES} are read"),
        "write numbers for parameters that do not change, and the equations of many sites once, as in \
         `for i in periodic { x[i]dot = c[i]*x[i+1]; }`",
    );
    true
}

/// Compiles further claims about a system without proving them. A claim may use earlier claims of
/// `tokens`, but no claims of the system.
///
/// # Errors
/// Returns the mistakes.
pub fn claims_of(system: &System, tokens: &[Token]) -> Result<Vec<Claim>, Vec<Diagnostic>> {
    let mut diagnostics = Diagnostics::default();
    let block = parse::parse(tokens, &mut diagnostics);
    let field = &system.field;
    let mut scope = Scope::default().with(field.symbols.clone());
    let mut stand_in = StandIn::of_type(None);
    let claims = claims::compile_all(&block, &field.components, &mut scope, &mut stand_in, &mut diagnostics);
    let mistakes = diagnostics.finish();
    if mistakes.is_empty() { Ok(claims) } else { Err(mistakes) }
}

pub(crate) fn check_system(block: Block, diagnostics: &mut Diagnostics) -> (StandIn, Option<System>) {
    if report_size(&block, diagnostics) {
        return (StandIn::of_type(block.header), None);
    }
    if block.equations.is_empty() && diagnostics.is_empty() {
        let message = "the block holds no equation";
        let help = "write one equation a state, as in `xdot = y*z;`";
        diagnostics.report(Kind::Empty, Span::token(0), message, help);
    }
    let before = diagnostics.len();
    let mut scope = Scope::new(&block, diagnostics);
    let names = scope.symbols.states.len() + scope.symbols.parameters.len() + block.constants.len();
    if report_names(names, &block, diagnostics) {
        return (StandIn::of_type(block.header), None);
    }
    let constants = constants::evaluate(&block, &mut scope, diagnostics);
    let (components, kept) = equations::expand_all(&block, &mut scope, diagnostics);
    let is_sound = diagnostics.len() == before
        && block.misspelt_states.is_empty()
        && !block.equations.is_empty()
        && block.equations.iter().all(|equation| equation.value.is_some());
    let field = Field { symbols: scope.symbols.clone(), components };
    // Odd powers of ε in the field as written cancel in the expanded field, which then replaces it.
    let kept = if kept.has_odd_powers_of_eps() { FieldWithSubexpressions::of(&field) } else { kept };
    let mut stand_in = StandIn::of_type(block.header.clone());
    stand_in.symbols = scope.symbols.clone();
    let claims = if block.equations.is_empty() {
        Vec::new()
    } else {
        claims::compile_all(&block, &field.components, &mut scope, &mut stand_in, diagnostics)
    };
    scope.report_unused(&block, diagnostics);
    let written = block.equations.into_iter().filter_map(|equation| equation.value).collect();
    let (field, kept) = (field.into(), kept.into());
    let system = System { header: block.header, constants, field, kept, written, claims };
    (stand_in, is_sound.then_some(system))
}
