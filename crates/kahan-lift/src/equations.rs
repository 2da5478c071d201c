//! The equations of a block that is to be lifted, checked and written as Laurent polynomials.

use kahan_algebra::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_algebra::parse::parse_lifted;
use kahan_algebra::syntax::{Block, Expr, ExprKind, FormulaSyntax, Header};
use kahan_algebra::token::{Span, Token};

use crate::laurent::{Laurent, Monomial};
use crate::read::Reader;
use crate::ring::Ring;
use crate::search::CoverProblem;

#[derive(Debug)]
pub(crate) struct Equations {
    pub header: Option<Header>,
    pub stated: EquationNames,
    pub ring: Ring,
}

/// The names in the equations of a block that is to be lifted.
#[derive(Clone, Debug)]
pub struct EquationNames {
    /// The names of the states in the order of their equations. The time `t` comes last.
    pub states: Vec<String>,
    /// The names of the parameters in the order of the header, or in the order in which they occur.
    pub parameters: Vec<String>,
    /// Whether the final state is the time.
    pub has_time: bool,
}

/// Reads the names in a block that is to be lifted. Values in
/// [`Options::orbit`](crate::Options::orbit) have the order of these names.
///
/// # Errors
/// Returns all mistakes, each with a place and a remedy.
pub fn stated(tokens: &[Token]) -> Result<EquationNames, Vec<Diagnostic>> {
    Ok(Equations::read(tokens)?.stated)
}

impl Equations {
    /// Reads and checks a block. The error holds all mistakes.
    pub(crate) fn read(tokens: &[Token]) -> Result<Self, Vec<Diagnostic>> {
        let mut diagnostics = Diagnostics::default();
        let block = parse_lifted(tokens, &mut diagnostics);
        let equations = check(block, &mut diagnostics);
        let diagnostics = diagnostics.finish();
        equations.filter(|_| diagnostics.is_empty()).ok_or(diagnostics)
    }

    /// Returns the search problem for monomials that make the equations quadratic.
    pub(crate) fn problem_in(&self, ring: &Ring) -> CoverProblem {
        let given: Vec<Monomial> =
            (0..self.stated.states.len()).map(|state| Monomial::power(state, 1)).collect();
        let required: Vec<Monomial> =
            ring.field.iter().flat_map(Laurent::terms).map(|(one, _)| one.clone()).collect();
        // Derivatives of coordinates may contain further negative powers, as in (log u)′ = u′/u.
        let slopes = ring.coordinates.iter().flat_map(|one| one.slope.terms()).map(|(one, _)| one);
        let negative = required
            .iter()
            .chain(slopes)
            .flat_map(|monomial| monomial.powers().filter(|&(_, exponent)| exponent < 0))
            .map(|(coordinate, _)| coordinate)
            .collect();
        CoverProblem { given, sums: Vec::new(), required, negative }
    }
}

fn names(expr: &Expr<FormulaSyntax>, visit: &mut dyn FnMut(&str)) {
    match &expr.kind {
        ExprKind::Number(_) => {}
        ExprKind::Name(name) => visit(name),
        ExprKind::Sum(terms) => terms.iter().for_each(|term| names(&term.expr, visit)),
        ExprKind::Product(factors) => factors.iter().for_each(|factor| names(&factor.expr, visit)),
        ExprKind::Negation(inner) | ExprKind::Power(inner, _) => names(inner, visit),
        ExprKind::Special(FormulaSyntax::Power(parts)) => parts.iter().for_each(|part| names(part, visit)),
        ExprKind::Special(FormulaSyntax::Call { arguments, .. }) => {
            arguments.iter().for_each(|argument| names(argument, visit));
        }
    }
}

fn check(block: Block<FormulaSyntax>, diagnostics: &mut Diagnostics) -> Option<Equations> {
    let states: Vec<String> = block.equations.iter().map(|equation| equation.state.text.clone()).collect();
    for (index, equation) in block.equations.iter().enumerate() {
        if states[..index].contains(&equation.state.text) {
            let name = &equation.state.text;
            let message = format!("`{name}` has two equations");
            diagnostics.report(Kind::Name, equation.state.span, message, "remove one of them");
        }
    }
    let sides: Vec<&Expr<FormulaSyntax>> =
        block.equations.iter().filter_map(|one| one.value.as_ref()).collect();
    if sides.is_empty() && diagnostics.is_empty() {
        let help = "write one equation a state, as in `xdot = v;`";
        diagnostics.report(Kind::Empty, Span::token(0), "the block holds no equation", help);
    }
    if sides.is_empty() || sides.len() < states.len() {
        return None;
    }
    let mut reader = Reader::default();
    reader.states = states;
    let known = block.header.as_ref().map(|header| &header.parameters);
    reader.parameters = known.iter().flat_map(|names| names.iter()).map(|name| name.text.clone()).collect();
    reader.is_declared = known.is_some();
    let mut has_time = false;
    for side in &sides {
        names(side, &mut |name| {
            let is_known = reader.states.iter().chain(&reader.parameters).any(|one| one == name)
                || block.constants.iter().any(|constant| constant.name.text == name);
            if is_known {
                return;
            }
            if name == "t" {
                has_time = true;
            } else if known.is_none() {
                reader.parameters.push(name.to_owned());
            }
        });
    }
    if has_time {
        reader.states.push("t".to_owned());
    }
    if let Err(mistake) = reader.field(&sides, &block.constants) {
        diagnostics.push(mistake);
        return None;
    }
    let Reader { states, parameters, ring, .. } = reader;
    Some(Equations { header: block.header, stated: EquationNames { states, parameters, has_time }, ring })
}
