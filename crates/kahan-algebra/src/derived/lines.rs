//! Derives the plans that a chain repeats at each site.

use kahan_syntax::rational::Rational;
use kahan_syntax::table::distinct;

use crate::field::Field;
use crate::plan::{Input, Node, Operation, Plan, PlanBuilder, split_with_quotients};
use crate::poly::{Polynomial, Variable, gcd};
use crate::rational_function::RationalFunction;
use crate::subexpressions::FieldWithConstants;
use crate::symbols::{Symbol, Symbols};

use crate::family::{Family, Role, SiteSum};

use super::names::constant_names;

/// The position of an entry of A(x,ε) in the rows of one site.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EntryPosition {
    /// The row, which is an index among the arrays of a site.
    pub row: usize,
    /// The column, which is an index among the states of the stencil. States are ordered by site,
    /// then by array.
    pub column: usize,
}

/// The plans of a family.
#[derive(Clone, Debug)]
pub struct Lines {
    /// The inputs of `constants`.
    pub given: Symbols,
    /// The inputs of `rows` and `sums`. Values at the sites of the stencil, of arrays and of site
    /// parameters, count as states. Prepared constants count as parameters.
    pub symbols: Symbols,
    /// The plan that computes the prepared constants from ε and the parameters of the chain.
    pub constants: Plan,
    /// The plan of the field and of entries of A at one site. The outputs are the components of the
    /// field by array, then the [`entries`](Self::entries).
    pub rows: Plan,
    /// The plan of the summands of claims at one site. The integrals come first, then the
    /// Hamiltonian.
    pub sums: Plan,
    /// The positions of the entries of A that are not identically zero.
    pub entries: Vec<EntryPosition>,
    /// The lower bandwidth of A as a number of states, not of sites.
    pub lower: usize,
    /// The upper bandwidth of A as a number of states, not of sites.
    pub upper: usize,
}

impl Family {
    /// Derives the plans of a site. The cost depends on the equations, not on the number of sites.
    #[must_use]
    pub fn lines(&self) -> Lines {
        let given = self.line_symbols();
        let is_of_site = |variable| !matches!(self.role(variable), Role::Parameter(_) | Role::Epsilon);
        let field = Field { symbols: self.symbols.clone(), components: self.components.clone() };
        let with_constants = self.kept.with_values_free_of(&field, is_of_site);
        let components = &with_constants.field.components;
        let own = self.symbols.parameters.len();
        let mut symbols = given.clone();
        symbols.parameters.extend_from_slice(&with_constants.field.symbols.parameters[own..]);
        let mut writer = LineWriter {
            family: self,
            with_constants: &with_constants,
            symbols: &symbols,
            builder: PlanBuilder::default(),
        };
        let field: Vec<Node> = components.iter().map(|component| writer.quotient(component)).collect();
        let center = self.place(0, 0);
        let mut entries = Vec::new();
        let mut nodes = Vec::new();
        let (mut lower, mut upper) = (0, 0);
        for (row, component) in components.iter().enumerate() {
            for column in self.with_diagonal(row) {
                let slope = component.numerator().derivative(self.symbols.state(column));
                nodes.push(writer.entry(&slope, component.denominator(), column == center + row));
                entries.push(EntryPosition { row, column });
                lower = lower.max((center + row).saturating_sub(column));
                upper = upper.max(column.saturating_sub(center + row));
            }
        }
        let sums: Vec<Node> = self.sums().map(|sum| writer.quotient(&sum.density)).collect();
        let rows = field.len() + nodes.len();
        let outputs: Vec<Node> = field.iter().chain(&nodes).chain(&sums).copied().collect();
        let (constants, all) =
            split_with_quotients(&writer.builder.finish(&outputs), |variable| symbols.is_state(variable));
        let part = |range: std::ops::Range<usize>| Plan {
            outputs: all.outputs[range].to_vec(),
            operations: all.operations.clone(),
        };
        let constant = |variable| match symbols.symbol(variable) {
            Symbol::Parameter(k) if k >= self.parameters.len() => Ok(k - self.parameters.len()),
            symbol => Err(given.variable(symbol)),
        };
        let constants =
            with_constants.put_into_line(&constants, constant, &|variable| match self.role(variable) {
                Role::Parameter(k) => given.parameter(k),
                _ => unreachable!("such values are made of parameters of the chain"),
            });
        let names = constant_names(&constants, &given);
        let symbols = Symbols { states: given.states.clone(), parameters: names };
        let read = |operation: &Operation| match operation {
            Operation::Input(Input::Prepared(place)) => {
                Operation::Input(Input::Variable(symbols.parameter(*place)))
            }
            other => other.clone(),
        };
        let needed = |plan: Plan| {
            let operations = plan.operations.iter().map(read).collect();
            Plan::together([&Plan { operations, ..plan }])
        };
        Lines {
            constants,
            rows: needed(part(0..rows)).fused(),
            sums: needed(part(rows..all.outputs.len())).fused(),
            entries,
            lower,
            upper,
            given,
            symbols,
        }
    }

    /// Returns the sums in claims, with the Hamiltonian last.
    pub fn sums(&self) -> impl Iterator<Item = &SiteSum> {
        self.integrals.iter().chain(&self.hamiltonian)
    }

    fn with_diagonal(&self, array: usize) -> Vec<usize> {
        let mut places = self.couplings(array);
        let own = self.place(0, array);
        if let Err(at) = places.binary_search(&own) {
            places.insert(at, own);
        }
        places
    }

    /// Returns symbols for the values of the stencil. Site parameters are among the states.
    fn line_symbols(&self) -> Symbols {
        let reach = self.reach as i64;
        let identifier = |array: &String, offset: i64| match offset {
            0 => array.clone(),
            1.. => format!("{array}_after_{offset}"),
            _ => format!("{array}_before_{}", -offset),
        };
        let states = (-reach..=reach)
            .flat_map(|offset| self.arrays.iter().map(move |array| identifier(array, offset)));
        let at_sites = |name| (-reach..=reach).map(move |offset| identifier(name, offset));
        let of_sites = self.site_parameters.iter().flat_map(at_sites);
        let names: Vec<String> = states.chain(of_sites).collect();
        let is_clear =
            distinct(names.iter().chain(&self.parameters)).len() == names.len() + self.parameters.len();
        let numbered = || (0..names.len()).map(|k| format!("value_{k}")).collect();
        let states = if is_clear { names } else { numbered() };
        Symbols { states, parameters: self.parameters.clone() }
    }
}

struct LineWriter<'a> {
    family: &'a Family,
    with_constants: &'a FieldWithConstants,
    symbols: &'a Symbols,
    builder: PlanBuilder,
}

impl LineWriter<'_> {
    fn renamed(&self, variable: Variable) -> Variable {
        let family = self.family;
        let symbol = self.with_constants.field.symbols.symbol(variable);
        if let Symbol::Parameter(k) = symbol
            && let Some(value) = k.checked_sub(family.symbols.parameters.len())
        {
            return self.symbols.parameter(family.parameters.len() + value);
        }
        match family.role(family.symbols.variable(symbol)) {
            Role::State { offset, array } => self.symbols.state(family.place(offset, array)),
            Role::Parameter(k) => self.symbols.parameter(k),
            Role::SiteParameter { offset, index } => {
                let place = (offset + family.reach as i64) as usize;
                let first = family.symbols.states.len() + index * family.stencil();
                self.symbols.state(first + place)
            }
            Role::Epsilon => self.symbols.epsilon(),
        }
    }

    fn polynomial(&mut self, polynomial: &Polynomial) -> Node {
        let renamed = polynomial.map_variables(|variable| self.renamed(variable));
        self.builder.polynomial(&renamed)
    }

    fn quotient(&mut self, component: &RationalFunction) -> Node {
        self.multiple(None, component.numerator(), component.denominator())
    }

    /// Writes p/q or ε·p/q for p = `above` and q = `below`. The numerator p is written as Σ cₖ·pₖ
    /// with integer polynomials pₖ and prepared constants cₖ. If q contains no values of sites,
    /// each cₖ is divided by q.
    fn multiple(&mut self, eps: Option<Node>, above: &Polynomial, below: &Polynomial) -> Node {
        let is_prepared = !below.variables().iter().any(|variable| self.is_of_site(*variable));
        let one = Polynomial::one();
        let (inside, outside) = if is_prepared { (below, &one) } else { (&one, below) };
        let mut sum = self.builder.constant(&Rational::ZERO);
        for (coefficient, values) in self.split_by_coefficient(above) {
            let common = gcd(&coefficient, inside);
            let [coefficient, inside] =
                [&coefficient, inside].map(|of| of.checked_div(&common).expect("a common divisor divides"));
            let mut factor = self.polynomial(&coefficient.scale(&values.content()));
            if let Some(eps) = eps {
                factor = self.builder.multiply(factor, eps);
            }
            let inside = self.polynomial(&inside);
            let factor = self.builder.divide(factor, inside);
            let values = self.polynomial(&values.primitive_part());
            let term = self.builder.multiply(factor, values);
            sum = self.builder.add(sum, term);
        }
        let [one, outside] = [&one, outside].map(|of| self.polynomial(of));
        let reciprocal = self.builder.divide(one, outside);
        self.builder.multiply(sum, reciprocal)
    }

    fn is_of_site(&self, variable: Variable) -> bool {
        self.symbols.is_state(self.renamed(variable))
    }

    /// Splits a polynomial into terms cₖ·pₖ. The coefficients cₖ contain only parameters and are
    /// not proportional to each other.
    fn split_by_coefficient(&self, polynomial: &Polynomial) -> Vec<(Polynomial, Polynomial)> {
        let mut terms: Vec<(Polynomial, Polynomial)> = Vec::new();
        for (monomial, coefficient) in polynomial.group(|variable| self.is_of_site(variable)).iter() {
            let primitive = coefficient.primitive_part();
            let term = Polynomial::constant(coefficient.content()).mul_monomial(monomial);
            match terms.iter_mut().find(|(known, _)| *known == primitive) {
                Some((_, values)) => *values = &*values + &term,
                None => terms.push((primitive, term)),
            }
        }
        terms
    }

    /// Writes the entry δᵢⱼ − ε ∂fᵢ/∂xⱼ of A. The derivative is `slope` / `below`.
    fn entry(&mut self, slope: &Polynomial, below: &Polynomial, is_diagonal: bool) -> Node {
        let eps = self.builder.input(self.symbols.epsilon());
        // The product ε·(−p) is cheaper than −ε·p.
        let scaled = self.multiple(Some(eps), &-slope, below);
        if !is_diagonal {
            return scaled;
        }
        let one = self.polynomial(&Polynomial::one());
        self.builder.add(one, scaled)
    }
}
