//! Inserts values for parameters into a system.

use std::sync::Arc;

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::ClaimKind;

use crate::field::Field;
use crate::plan::PlanBuilder;
use crate::poly::{Polynomial, Variable};
use crate::rational_function::RationalFunction;
use crate::relations::{Obstacle, Relations};
use crate::subexpressions::{FieldWithSubexpressions, Subexpressions};
use crate::symbols::{Symbol, Symbols};
use crate::system::{Claim, Condition, System};

impl System {
    /// Returns the system with these parameters as constants. Claims are dropped if their
    /// conditions contradict the values or cannot be solved. Returns `None` if the field divides by
    /// zero.
    #[must_use]
    pub fn specialise(&self, values: &[(usize, Rational)]) -> Option<System> {
        let old = &self.field.symbols;
        let mut relations = Relations::default();
        for (k, value) in values {
            let parameter = old.parameter(*k);
            let polynomial = &Polynomial::variable(parameter) - &Polynomial::constant(value.clone());
            relations.add(&polynomial, &[parameter]).ok()?;
        }
        let mut specialised = self.on(&relations)?;
        let specialisation =
            Specialisation { field: &self.field, new: &specialised.field.symbols, relations: &relations };
        let mut claims: Vec<Claim> = Vec::new();
        for claim in self.claims.iter().filter_map(|claim| specialisation.claim(claim)) {
            // A block has at most one unconditional density. Further ones are dropped: each is the
            // first one times an integral.
            let is_density = |claim: &Claim| claim.kind == ClaimKind::Density && claim.is_unconditional();
            if !is_density(&claim) || !claims.iter().any(is_density) {
                claims.push(claim);
            }
        }
        specialised.claims = claims;
        specialised
            .constants
            .extend(values.iter().map(|(k, value)| (old.parameters[*k].clone(), value.clone())));
        Some(specialised)
    }

    /// Returns the system with additional unused parameters.
    #[must_use]
    pub fn with_parameters(&self, names: &[String]) -> System {
        let old = &self.field.symbols;
        let symbols = Symbols { parameters: [&old.parameters[..], names].concat(), ..old.clone() };
        let relations = Relations::default();
        let renaming = Specialisation { field: &self.field, new: &symbols, relations: &relations };
        let components: Vec<_> =
            self.field.components.iter().filter_map(|one| renaming.specialised_component(one)).collect();
        let kept = renaming.specialised_subexpressions(&self.kept, &components);
        let claims = self.claims.iter().filter_map(|claim| renaming.claim(claim)).collect();
        let field = Field { symbols, components };
        let kept = kept.unwrap_or_else(|| FieldWithSubexpressions::of(&field)).into();
        System { kept, field: field.into(), claims, ..self.clone() }
    }

    /// Replaces ε in the coefficients by this value, and drops the claims. Returns `None` if the
    /// field then divides by zero, which never happens for ε = 0.
    #[must_use]
    pub fn at_eps(&self, eps: &Rational) -> Option<System> {
        let Field { symbols, components } = &*self.field;
        let put = |of: &Polynomial| of.substitute(symbols.epsilon(), eps);
        let components = components.iter().map(|component| component.map(put)).collect::<Option<Vec<_>>>()?;
        let field = Field { symbols: symbols.clone(), components };
        let kept = self.kept.at_eps(symbols, eps);
        let (field, kept, written) = (field.into(), kept.into(), Arc::default());
        Some(System { field, kept, written, claims: Vec::new(), ..self.clone() })
    }

    /// Restricts the system to values that satisfy these relations. The result has no claims and
    /// lacks the solved parameters. Returns `None` if the field divides by zero, or if limits on
    /// sizes are exceeded.
    #[must_use]
    pub fn on(&self, relations: &Relations) -> Option<System> {
        let old = &self.field.symbols;
        let is_kept = |k: usize| relations.value(old.parameter(k)).is_none();
        let names = old.parameters.iter().enumerate().filter(|(k, _)| is_kept(*k));
        let symbols =
            Symbols { states: old.states.clone(), parameters: names.map(|(_, name)| name.clone()).collect() };
        let specialisation = Specialisation { field: &self.field, new: &symbols, relations };
        let components =
            self.field.components.iter().map(|component| specialisation.specialised_component(component));
        let components = components.collect::<Option<Vec<_>>>()?;
        let kept = specialisation.specialised_subexpressions(&self.kept, &components);
        let field = Field { symbols, components };
        let kept = kept.unwrap_or_else(|| FieldWithSubexpressions::of(&field));
        let (header, constants) = (self.header.clone(), self.constants.clone());
        Some(System { header, constants, ..System::of(field, kept) })
    }
}

struct Specialisation<'a> {
    field: &'a Field,
    new: &'a Symbols,
    relations: &'a Relations,
}

impl Specialisation<'_> {
    fn renamed(&self, variable: Variable) -> Variable {
        let old = &self.field.symbols;
        let symbol = match old.symbol(variable) {
            Symbol::Parameter(k) => {
                let gone = (0..k).filter(|&other| self.relations.value(old.parameter(other)).is_some());
                Symbol::Parameter(k - gone.count())
            }
            symbol => symbol,
        };
        self.new.variable(symbol)
    }

    fn polynomial(&self, polynomial: &Polynomial) -> Polynomial {
        polynomial.map_variables(|variable| self.renamed(variable))
    }

    fn function(&self, function: &RationalFunction) -> Option<RationalFunction> {
        function.map(|of| self.polynomial(of))
    }

    fn specialised_component(&self, component: &RationalFunction) -> Option<RationalFunction> {
        let mut relations = self.relations.clone();
        let numerator = relations.put_into(component.numerator()).ok()??;
        let denominator = relations.put_into(component.denominator()).ok()??;
        self.function(&numerator.checked_div(&denominator)?)
    }

    /// Inserts values into the field as written. Returns `None` if a value is not a polynomial.
    /// Also returns `None` if the written formula has a divisor that the reduced component lacks.
    fn specialised_subexpressions(
        &self,
        kept: &FieldWithSubexpressions,
        components: &[RationalFunction],
    ) -> Option<FieldWithSubexpressions> {
        let mut values = Subexpressions::of(self.new);
        let put = |variable| match self.relations.value(variable) {
            Some(value) => Some(self.polynomial(value.as_polynomial()?)),
            None => Some(Polynomial::variable(self.renamed(variable))),
        };
        let old = self.field.symbols.parameters.len();
        (0..old).try_for_each(|k| put(self.field.symbols.parameter(k)).map(drop))?;
        let kept = kept.with(&mut values, |variable| put(variable).expect("every value is a polynomial"));
        let is_free = |(kept, component): (&Polynomial, &RationalFunction)| {
            values.divide_only_by(kept, component.denominator())
        };
        kept.iter()
            .zip(components)
            .all(is_free)
            .then(|| FieldWithSubexpressions::new(values.clone(), kept.clone()))
    }

    fn claim(&self, claim: &Claim) -> Option<Claim> {
        let conditions = self.conditions(&claim.conditions)?;
        let mut builder = PlanBuilder::default();
        let outputs = builder.include_mapped(&claim.plan, |builder, variable| {
            match self.relations.value(variable).and_then(RationalFunction::as_polynomial) {
                Some(value) => {
                    builder.constant(&value.as_constant().expect("a parameter is fixed at a number"))
                }
                None => builder.input(self.renamed(variable)),
            }
        });
        Some(Claim { plan: builder.finish(&outputs), conditions, ..claim.clone() })
    }

    /// Solves the conditions of a claim after values were inserted. Returns `None` if the
    /// conditions are false, or are possibly not equivalent to the original ones.
    fn conditions(&self, conditions: &[Condition]) -> Option<Vec<Condition>> {
        let mut relations = self.relations.clone();
        let mut solved = Vec::new();
        for condition in conditions {
            let value = &condition.value;
            let product = value.denominator() * &Polynomial::variable(condition.variable);
            let polynomial = &product - value.numerator();
            let before = relations.nonzero().len();
            let name = match relations.add(&polynomial, &[condition.variable]) {
                Ok(name) => Some(name),
                Err(Obstacle::Identity) => None,
                Err(_) => return None,
            };
            for nonzero in &condition.nonzero {
                if !relations.require(nonzero).ok()? {
                    return None;
                }
            }
            let added = before..relations.nonzero().len();
            solved.extend(name.map(|name| (condition.written.clone(), name, added)));
        }
        let eps = Polynomial::variable(self.field.symbols.epsilon());
        let divisors = self.field.denominators();
        for nonzero in divisors.chain([&eps]) {
            if relations.makes_vanish(nonzero).ok()? {
                return None;
            }
        }
        let renamed = |condition: Condition| {
            let nonzero = condition.nonzero.iter().map(|polynomial| {
                let mut relations = self.relations.clone();
                Some(self.polynomial(relations.put_into(polynomial).ok()??.numerator()))
            });
            Some(Condition {
                variable: self.renamed(condition.variable),
                value: self.function(&condition.value)?,
                nonzero: nonzero.collect::<Option<Vec<_>>>()?,
                written: condition.written,
            })
        };
        Condition::all(solved, &relations).into_iter().map(renamed).collect()
    }
}
