//! Collects the names of a block. States come from equations. Parameters come from the header or,
//! in a block without header, from their use.

use rustc_hash::FxHashSet;

use kahan_syntax::diagnostics::{Diagnostics, Kind};
use kahan_syntax::spelling::is_keyword;
use kahan_syntax::syntax::{Block, ClaimBody, Name, Reference};
use kahan_syntax::token::Span;

use crate::symbols::{Symbol, Symbols};

use super::{Scope, is_epsilon, is_never_free, report_reserved};

impl Scope {
    pub(in crate::check) fn with(self, symbols: Symbols) -> Self {
        let states = symbols.states.iter().cloned().zip((0..).map(Symbol::State));
        let parameters = symbols.parameters.iter().cloned().zip((0..).map(Symbol::Parameter));
        Scope { places: states.chain(parameters).collect(), symbols, ..self }
    }

    fn add_state(&mut self, name: &str) {
        self.places.insert(name.to_owned(), Symbol::State(self.symbols.states.len()));
        self.symbols.states.push(name.to_owned());
    }

    fn add_parameter(&mut self, name: &str) {
        self.places.insert(name.to_owned(), Symbol::Parameter(self.symbols.parameters.len()));
        self.symbols.parameters.push(name.to_owned());
    }

    /// Builds the scope of a block without constants and claims. In a family, states are arrays.
    pub(in crate::check) fn new(block: &Block, diagnostics: &mut Diagnostics) -> Self {
        let mut scope = Scope {
            all_claims: block.claims.iter().map(|claim| claim.name.text.clone()).collect(),
            misspelt_states: block.misspelt_states.iter().map(|name| name.text.clone()).collect(),
            ..Scope::default()
        };
        scope.collect_states(block, diagnostics);
        if let Some(header) = &block.header
            && is_keyword(&header.name.text)
        {
            let name = &header.name;
            let message = format!("the system's name `{}` is a keyword of Rust", name.text);
            let help = "choose another name";
            diagnostics.report(Kind::Header, name.span, message, help);
        }
        match &block.header {
            Some(header) => scope.collect_parameters(&header.parameters, block, diagnostics),
            None => scope.collect_free_names(block, diagnostics),
        }
        scope
    }

    fn collect_states(&mut self, block: &Block, diagnostics: &mut Diagnostics) {
        let written = written_in(block);
        for equation in &block.equations {
            let state = &equation.state;
            if self.is_state_name(&state.text) && self.misspelt_states.contains(&state.text) {
                continue;
            }
            if self.is_state_name(&state.text) {
                let message = format!("`{}dot` is given twice", written(&state.text));
                let help = "remove one of the equations, or rename its state";
                diagnostics.report(Kind::Name, state.span, message, help);
            } else {
                if report_reserved(state, diagnostics) {
                    self.poison(&state.text);
                }
                self.add_state(&state.text);
            }
        }
    }

    fn collect_parameters(&mut self, parameters: &[Name], block: &Block, diagnostics: &mut Diagnostics) {
        let constants: FxHashSet<&str> =
            block.constants.iter().map(|constant| constant.name.text.as_str()).collect();
        let (written, what) =
            (written_in(block), if block.family.is_some() { "an array" } else { "a state variable" });
        for name in parameters {
            let text = &name.text;
            let (message, help) = if self.is_parameter_name(text) {
                (format!("the parameter `{text}` is declared twice"), "remove one".to_owned())
            } else if self.is_state_name(text) {
                let given = format!(
                    "`{text}` is {what} (`{}dot` is given), so it cannot be a parameter",
                    written(text)
                );
                (given, "rename one of them".to_owned())
            } else if is_keyword(text) {
                self.poison(text);
                let help = format!("rename it, for example to `{text}_`");
                (format!("the parameter `{text}` is a keyword of Rust"), help)
            } else if report_reserved(name, diagnostics) {
                self.poison(text);
                continue;
            } else if constants.contains(text.as_str()) {
                let help = format!("remove the parameter: `const {text}` fixes its value");
                (format!("`{text}` is a parameter and a constant"), help)
            } else {
                self.add_parameter(text);
                continue;
            };
            diagnostics.report(Kind::Name, name.span, message, help);
        }
    }

    /// Declares the unknown names in the equations of a block without a header as parameters.
    fn collect_free_names(&mut self, block: &Block, diagnostics: &mut Diagnostics) {
        let constants: FxHashSet<&str> =
            block.constants.iter().map(|constant| constant.name.text.as_str()).collect();
        for (reference, span) in references(block) {
            let (Reference::Name(text) | Reference::Site { array: text, .. }) = reference;
            let known = self.is_state_name(text)
                || self.is_parameter_name(text)
                || self.poisoned.contains(text)
                || constants.contains(text)
                || is_epsilon(text)
                || text == "ϵ";
            if known {
                continue;
            }
            if is_never_free(text, |name| self.is_state_name(name)) {
                continue;
            }
            if is_keyword(text) {
                let message = format!("`{text}` is a keyword of Rust and names no value");
                let help = "bind the value first: `let mu = …;`, then write `mu`";
                diagnostics.report(Kind::Name, span, message, help);
                self.poison(text);
            } else {
                self.add_parameter(text);
            }
        }
    }
}

fn written_in(block: &Block) -> impl Fn(&str) -> String {
    let index = if block.family.is_some() { "[i]" } else { "" };
    move |state| format!("{state}{index}")
}

pub(in crate::check) fn references(block: &Block) -> Vec<(Reference<'_>, Span)> {
    let mut references = Vec::new();
    let equations = block.equations.iter().filter_map(|equation| equation.value.as_ref());
    let claims = block.claims.iter().chain(&block.hamiltonians).filter(|_| block.family.is_some());
    let claims = claims.filter_map(|claim| match &claim.body {
        Some(ClaimBody::Function(expr)) => Some(expr),
        _ => None,
    });
    for expr in equations.chain(claims) {
        expr.visit_names(&mut |reference, span| references.push((reference, span)));
    }
    references
}
