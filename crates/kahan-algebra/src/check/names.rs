//! Resolves names to states, parameters, constants or claims. No name has two meanings.

mod declared;

pub(super) use declared::references;

use std::cell::Cell;

use rustc_hash::{FxHashMap, FxHashSet};

use kahan_syntax::diagnostics::{Diagnostics, Kind};
use kahan_syntax::rational::Rational;
use kahan_syntax::spelling::{fresh, is_keyword, nearest, number, without_dots};
use kahan_syntax::syntax::{Block, Expr, Name, Reference};
use kahan_syntax::table::sorted_by_key;
use kahan_syntax::token::Span;

use crate::poly::Variable;
use crate::symbols::{Symbol, Symbols};

#[derive(Clone, Debug)]
pub(super) enum NameMeaning {
    Variable(Variable),
    Constant(Rational),
}

#[derive(Default)]
pub(super) struct Scope {
    pub(super) symbols: Symbols,
    places: FxHashMap<String, Symbol>,
    pub(super) constants: FxHashMap<String, Option<Rational>>,
    pub(super) claims: Vec<String>,
    /// Names with mistakes that are already reported.
    poisoned: FxHashSet<String>,
    used: FxHashSet<String>,
    all_claims: FxHashSet<String>,
    misspelt_states: Vec<String>,
    /// The number of multiplications of terms in all expansions.
    pub(super) products: Cell<u64>,
}

pub(super) fn is_epsilon(name: &str) -> bool {
    matches!(name, "eps" | "ε")
}

impl Scope {
    fn is_state_name(&self, name: &str) -> bool {
        matches!(self.places.get(name), Some(Symbol::State(_)))
    }

    fn is_parameter_name(&self, name: &str) -> bool {
        matches!(self.places.get(name), Some(Symbol::Parameter(_)))
    }

    pub(super) fn is_poisoned(&self, name: &str) -> bool {
        self.poisoned.contains(name)
    }

    pub(super) fn poison(&mut self, name: &str) {
        self.poisoned.insert(name.to_owned());
    }

    pub(super) fn variable(&self, name: &str) -> Option<Variable> {
        if is_epsilon(name) {
            return Some(self.symbols.epsilon());
        }
        self.places.get(name).map(|symbol| self.symbols.variable(*symbol))
    }

    pub(super) fn mark_used(&mut self, name: &str) {
        self.used.insert(name.to_owned());
    }

    pub(super) fn meaning(&self, name: &str) -> Option<NameMeaning> {
        if let Some(value) = self.constants.get(name) {
            return value.clone().map(NameMeaning::Constant);
        }
        self.variable(name).map(NameMeaning::Variable)
    }

    /// Reports every unknown name. Returns whether all names are known.
    pub(super) fn resolve(&mut self, expr: &Expr, in_claim: bool, diagnostics: &mut Diagnostics) -> bool {
        let mut references = Vec::new();
        expr.visit_names(&mut |reference, span| references.push((reference, span)));
        let mut sound = true;
        for (reference, span) in references {
            let name = &*reference.key();
            if !self.used.contains(name) {
                self.mark_used(name);
            }
            let (Reference::Name(base) | Reference::Site { array: base, .. }) = reference;
            if self.is_poisoned(name) || self.is_poisoned(base) {
                sound = false;
            } else if self.meaning(name).is_none()
                && !(in_claim && self.claims.iter().any(|claim| claim == name))
            {
                sound = false;
                // A constant without a value is already reported.
                if !self.constants.contains_key(name) && !diagnostics.is_full() {
                    self.report_unknown(reference, span, in_claim, diagnostics);
                }
            }
        }
        sound
    }

    fn report_unknown(
        &mut self,
        reference: Reference<'_>,
        span: Span,
        in_claim: bool,
        diagnostics: &mut Diagnostics,
    ) {
        let name = &*reference.to_string();
        // A misspelt equation `dxdt = …` is reported instead of the unknown name `x`.
        if self.misspelt_states.iter().any(|left| left.contains(name)) {
            return;
        }
        if in_claim && self.all_claims.contains(name) {
            let message = format!("`{name}` is not known yet: a claim may use the claims above it");
            let help = format!("move the claim `{name}` above this one");
            diagnostics.report(Kind::UnknownName, span, message, help);
            self.poison(name);
            return;
        }
        if let Some((message, help)) = self.never_free(name).filter(|_| !in_claim) {
            diagnostics.report(Kind::UnknownName, span, message, help);
            self.poison(name);
            return;
        }
        let help = if name == "ϵ" {
            "for half the time step write `eps`".to_owned()
        } else if let Reference::Site { array, .. } = reference {
            format!(
                "give it an equation `{array}[i]dot = …;`, or declare it as a parameter: `struct Name {{ {array} }}`"
            )
        } else if let Some(help) = number(name) {
            help
        } else if let Some(nearest) = self.nearest(name, in_claim) {
            self.mark_used(&nearest);
            format!("did you mean `{nearest}`?")
        } else if is_keyword(name) {
            "it is a keyword of Rust: write a name".to_owned()
        } else if in_claim {
            format!("a claim may use {}, `eps` and earlier claims", self.list())
        } else {
            format!(
                "give it an equation `{name}dot = …;`, or declare it as a parameter: `struct Name {{ {name} }}`"
            )
        };
        let message = format!("`{name}` is neither a state nor a parameter");
        diagnostics.report(Kind::UnknownName, span, message, help);
        self.poison(name);
    }

    fn is_family(&self) -> bool {
        self.symbols.states.iter().any(|state| state.ends_with(']'))
    }

    fn is_array(&self, name: &str) -> bool {
        self.is_state_name(&Reference::Site { array: name, offset: 0 }.to_string())
    }

    fn never_free(&self, name: &str) -> Option<(String, String)> {
        let is_state = |base: &str| self.is_state_name(base) || self.is_array(base);
        if !is_never_free(name, is_state) {
            return None;
        }
        if name != TIME {
            let message = format!("`{name}` is a derivative, and a right-hand side has none");
            return Some((message, "put in what it is equal to".to_owned()));
        }
        let message = "`t` is the time, and a field has no time unless it is a state".to_owned();
        Some((
            message,
            if self.is_family() {
                "give each site its time: `t[i]dot = 1;`, and write `t[i]`".to_owned()
            } else {
                "write one more equation, `tdot = 1;`, and begin at the time of the start; for a parameter of this name \
             write a header, `struct Name { t }`"
                .to_owned()
            },
        ))
    }

    pub(super) fn new_variable(&self) -> String {
        let is_taken = |name: &str| {
            self.variable(name).is_some()
                || self.constants.contains_key(name)
                || self.all_claims.contains(name)
                || self.is_array(name)
        };
        let new = fresh(&["w", "u", "q", "s", "r"], is_taken);
        if self.is_family() { Reference::Site { array: &new, offset: 0 }.to_string() } else { new }
    }

    fn list(&self) -> String {
        let names = self.symbols.states.iter().chain(&self.symbols.parameters);
        names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
    }

    /// Returns the known name closest to `name`, if the difference may be a typing error.
    pub(super) fn nearest(&self, name: &str, in_claim: bool) -> Option<String> {
        let mut candidates: Vec<String> = self.symbols.states.clone();
        candidates.extend(self.symbols.parameters.iter().cloned());
        candidates.extend(sorted_by_key(self.constants.keys(), |name| *name).into_iter().cloned());
        if in_claim {
            candidates.extend(self.claims.iter().cloned());
            candidates.push("eps".to_owned());
        }
        nearest(name, &candidates).cloned()
    }

    /// Reports unused parameters of the header, unless initial values of a lift may use them.
    pub(super) fn report_unused(&self, block: &Block, diagnostics: &mut Diagnostics) {
        let unread = block.lift.is_some()
            || block.equations.iter().any(|equation| equation.value.is_none())
            || block.claims.iter().any(|claim| claim.body.is_none());
        let Some(header) = block.header.as_ref().filter(|_| !unread && !block.equations.is_empty()) else {
            return;
        };
        for name in &header.parameters {
            if self.is_parameter_name(&name.text) && !self.used.contains(&name.text) {
                let message = format!("nothing uses the parameter `{}`", name.text);
                let help = "remove it, or use it in an equation";
                diagnostics.report(Kind::UnusedParameter, name.span, message, help);
            }
        }
    }

    /// Returns whether `name` is neither declared nor reserved. Reports a mistake otherwise.
    pub(super) fn is_free(&self, name: &Name, what: &str, diagnostics: &mut Diagnostics) -> bool {
        let text = &name.text;
        let taken = if self.is_state_name(text) {
            "a state variable"
        } else if self.is_parameter_name(text) {
            "a parameter"
        } else if self.constants.contains_key(text) {
            if what == "constant" { "an earlier constant" } else { "a constant" }
        } else if self.claims.contains(text) {
            "an earlier claim"
        } else {
            return !report_reserved(name, diagnostics);
        };
        let message = format!("the {what} `{text}` has the name of {taken}");
        let help = format!("rename the {what}");
        diagnostics.report(Kind::Name, name.span, message, help);
        false
    }
}

fn report_reserved(name: &Name, diagnostics: &mut Diagnostics) -> bool {
    let (message, help) = if is_epsilon(&name.text) {
        (format!("`{}` is reserved: it is half the time step", name.text), "choose another name")
    } else if name.text.chars().all(|c| c == '_') {
        ("an underscore is no name".to_owned(), "choose a name with a letter")
    } else {
        return false;
    };
    diagnostics.report(Kind::Name, name.span, message, help);
    true
}

const TIME: &str = "t";

/// Returns the state name `x` for the derivatives `xdot` and `ẋ`.
fn base_of_derivative(name: &str) -> Option<String> {
    name.strip_suffix("dot").map(str::to_owned).or_else(|| Some(without_dots(name)?.0))
}

/// Returns whether an undeclared name is the time or the derivative of a state, and therefore never
/// becomes a parameter.
pub(super) fn is_never_free(name: &str, is_state: impl Fn(&str) -> bool) -> bool {
    name == TIME || base_of_derivative(name).is_some_and(|base| is_state(&base))
}
