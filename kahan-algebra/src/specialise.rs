//! A system with some of its parameters fixed: a smaller system, reduced after the values are put in.

use crate::field::{Component, Field};
use crate::plan::PlanBuilder;
use crate::poly::Variable;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::symbols::{Symbol, Symbols};
use crate::syntax::ClaimKind;
use crate::system::{Claim, System};

impl System {
    /// The system at these values of parameters, which become constants of it. Claims `when` one of them has another
    /// value are left out. `None` where the field then divides by zero.
    #[must_use]
    pub fn specialise(&self, values: &[(usize, Rational)]) -> Option<System> {
        let old = &self.field.symbols;
        let kept = |k: usize| values.iter().all(|(fixed, _)| *fixed != k);
        let names = old.parameters.iter().enumerate().filter(|(k, _)| kept(*k)).map(|(_, name)| name.clone());
        let symbols = Symbols { states: old.states.clone(), parameters: names.collect() };
        let specialisation = Specialisation { old, new: &symbols, values };
        let components = self.field.components.iter().map(|component| specialisation.component(component));
        let components = components.collect::<Option<Vec<_>>>()?;
        let mut claims: Vec<Claim> = Vec::new();
        for claim in self.claims.iter().filter_map(|claim| specialisation.claim(claim)) {
            // A block has one density without `when`; another that becomes so differs by an integral.
            let is_density = |claim: &Claim| claim.kind == ClaimKind::Density && claim.is_unconditional();
            if !is_density(&claim) || !claims.iter().any(is_density) {
                claims.push(claim);
            }
        }
        let mut constants = self.constants.clone();
        constants.extend(values.iter().map(|(k, value)| (old.parameters[*k].clone(), value.clone())));
        let field = Field { symbols: symbols.clone(), components };
        Some(System {
            header: self.header.clone(),
            constants,
            field,
            is_field_sound: self.is_field_sound,
            claims,
        })
    }
}

struct Specialisation<'a> {
    old: &'a Symbols,
    new: &'a Symbols,
    /// Indices of parameters, and their values.
    values: &'a [(usize, Rational)],
}

impl Specialisation<'_> {
    /// The value of a variable that is fixed.
    fn value(&self, variable: Variable) -> Option<&Rational> {
        let Symbol::Parameter(k) = self.old.symbol(variable) else { return None };
        self.values.iter().find(|(fixed, _)| *fixed == k).map(|(_, value)| value)
    }

    /// A variable that is not fixed, under its new number.
    fn renamed(&self, variable: Variable) -> Variable {
        let symbol = match self.old.symbol(variable) {
            Symbol::Parameter(k) => {
                Symbol::Parameter(k - self.values.iter().filter(|(fixed, _)| *fixed < k).count())
            }
            symbol => symbol,
        };
        self.new.variable(symbol)
    }

    fn component(&self, component: &Component) -> Option<Component> {
        let substituted = |polynomial: &crate::poly::Polynomial| {
            let fixed = self.values.iter().fold(polynomial.clone(), |polynomial, (k, value)| {
                polynomial.substitute(self.old.parameter(*k), value)
            });
            fixed.map_variables(|variable| self.renamed(variable))
        };
        let quotient =
            RationalFunction::new(substituted(&component.numerator), substituted(&component.denominator))?;
        Some(Component {
            numerator: quotient.numerator().clone(),
            denominator: quotient.denominator().clone(),
        })
    }

    fn claim(&self, claim: &Claim) -> Option<Claim> {
        let contradicts = |(variable, value): &(Variable, Rational)| {
            self.value(*variable).is_some_and(|fixed| fixed != value)
        };
        if claim.conditions.iter().any(contradicts) {
            return None;
        }
        let open = claim.conditions.iter().filter(|(variable, _)| self.value(*variable).is_none());
        let conditions = open.map(|(variable, value)| (self.renamed(*variable), value.clone())).collect();
        let mut builder = PlanBuilder::default();
        let outputs = builder.include_mapped(&claim.plan, |builder, variable| match self.value(variable) {
            Some(value) => builder.constant(value),
            None => builder.input(self.renamed(variable)),
        });
        Some(Claim { plan: builder.finish(&outputs), conditions, ..claim.clone() })
    }
}
