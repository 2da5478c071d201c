//! A stand-in for a block with mistakes. The stand-in has no equations, so rustc can check the rest
//! of the program. It has the header and, unless the block is too large, the names.

use kahan_syntax::diagnostics::Diagnostic;
use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{ClaimBody, ClaimKind, Expr, ExprKind, Header, Name};

use crate::field::Field;
use crate::plan::PlanBuilder;
use crate::rational_function::RationalFunction;
use crate::subexpressions::FieldWithSubexpressions;
use crate::symbols::Symbols;
use crate::system::{Claim, Condition, System};

/// A block with mistakes.
#[derive(Clone, Debug)]
pub struct Broken {
    /// The mistakes, ordered by place. The list is not empty.
    pub diagnostics: Vec<Diagnostic>,
    /// The names of the block, with which code can be generated in spite of the mistakes.
    pub stand_in: StandIn,
}

/// The header and the names of a block with mistakes.
#[derive(Clone, Debug)]
pub struct StandIn {
    /// The header of the block.
    pub header: Option<Header>,
    /// The names of states and parameters. Parameters of sites are listed separately.
    pub symbols: Symbols,
    /// The parameters of each site of a family.
    pub site_parameters: Vec<String>,
    /// The kind and the name of each claim, and whether it is unconditional.
    claims: Vec<(ClaimKind, Name, bool)>,
}

impl StandIn {
    /// Returns a stand-in for a block of which only the header is known.
    #[must_use]
    pub fn of_type(header: Option<Header>) -> Self {
        StandIn { header, symbols: Symbols::default(), site_parameters: Vec::new(), claims: Vec::new() }
    }

    /// Returns a stand-in with the names of a system, for use if its claims are not proved.
    #[must_use]
    pub fn of_system(system: &System) -> Self {
        let claims =
            system.claims.iter().map(|claim| (claim.kind, claim.name.clone(), claim.is_unconditional()));
        let symbols = system.field.symbols.clone();
        StandIn { symbols, claims: claims.collect(), ..StandIn::of_type(system.header.clone()) }
    }

    pub(super) fn push_claim(&mut self, kind: ClaimKind, name: &Name, is_unconditional: bool) {
        self.claims.push((kind, name.clone(), is_unconditional));
    }

    /// Returns a system with these names. Its field and its claims are zero.
    #[must_use]
    pub fn system(&self) -> System {
        let symbols = self.symbols.clone();
        let field = Field { components: vec![RationalFunction::zero(); symbols.dimension()], symbols };
        let (header, kept) = (self.header.clone(), FieldWithSubexpressions::of(&field));
        let claims = self.claims.iter().map(|claim| self.claim(claim)).collect();
        System { header, claims, ..System::of(field, kept) }
    }

    fn claim(&self, (kind, name, is_unconditional): &(ClaimKind, Name, bool)) -> Claim {
        let n = self.symbols.dimension();
        let results = match kind {
            ClaimKind::Bracket => n * (n.max(1) - 1) / 2,
            ClaimKind::Drift => 2,
            ClaimKind::Integral | ClaimKind::Density => 1,
        };
        let mut builder = PlanBuilder::default();
        let zero = builder.constant(&Rational::zero());
        let expr = || Expr { kind: ExprKind::Number(Rational::zero()), span: name.span };
        // Generated methods depend only on whether a claim has a condition, so ε = 1 will do.
        let condition = || Condition::fixed(&self.symbols, self.symbols.epsilon(), &Rational::one());
        Claim {
            kind: *kind,
            name: name.clone(),
            body: ClaimBody::Function(expr()),
            plan: builder.finish(&vec![zero; results]),
            conditions: if *is_unconditional { Vec::new() } else { vec![condition()] },
        }
    }
}
