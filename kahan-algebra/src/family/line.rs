//! The straight lines of one site: its field, its rows of A(x,ε), what its claims sum.

use crate::derived::constant_names;
use crate::field::Component;
use crate::plan::{Node, Operation, Plan, PlanBuilder};
use crate::poly::{Polynomial, Variable};
use crate::symbols::Symbols;
use crate::table::distinct;

use super::{Family, Role, SiteSum};

/// Where an entry of A stands: the row of an array, and the column among the values that a site
/// sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The array whose row it is.
    pub row: usize,
    /// The column: site by site from −reach on, arrays interleaved.
    pub column: usize,
}

/// The lines of a family.
#[derive(Clone, Debug)]
pub struct Lines {
    /// The names of what the prepared constants are made of: the parameters of the chain.
    pub given: Symbols,
    /// The names of what the lines read: as states the values that a site sees, first those of the
    /// arrays, then those of the parameters of sites, each from −reach on; as parameters the
    /// prepared constants.
    pub symbols: Symbols,
    /// From ε and the parameters of the chain to the prepared constants.
    pub constants: Plan,
    /// The field, an array a result, then the entries of A at [`entries`](Self::entries).
    pub rows: Plan,
    /// The field alone.
    pub field: Plan,
    /// What each claimed sum adds up, integrals first, then the Hamiltonian.
    pub sums: Plan,
    /// The entries of A that are not zero for every state.
    pub entries: Vec<Place>,
    /// The largest distance, in unknowns, of such an entry to the left of the diagonal.
    pub lower: usize,
    /// The same to the right.
    pub upper: usize,
}

impl Family {
    /// The lines of a site. Cost: about as many operations as the equations have.
    #[must_use]
    pub fn lines(&self) -> Lines {
        let symbols = self.line_symbols();
        let mut writer = Writer { family: self, symbols: &symbols, builder: PlanBuilder::default() };
        let field: Vec<Node> = self.components.iter().map(|component| writer.quotient(component)).collect();
        let center = self.place(0, 0);
        let mut entries = Vec::new();
        let mut nodes = Vec::new();
        let (mut lower, mut upper) = (0, 0);
        for (row, component) in self.components.iter().enumerate() {
            let scale = writer.scale_of_row(component);
            for column in self.with_diagonal(row) {
                let slope = component.numerator.derivative(self.symbols.state(column));
                nodes.push(writer.entry(&slope, scale, column == center + row));
                entries.push(Place { row, column });
                lower = lower.max((center + row).saturating_sub(column));
                upper = upper.max(column.saturating_sub(center + row));
            }
        }
        let sums: Vec<Node> = self.sums().map(|sum| writer.quotient(&sum.density)).collect();
        let rows = field.len() + nodes.len();
        let outputs: Vec<Node> = field.iter().chain(&nodes).chain(&sums).copied().collect();
        let (constants, all) =
            writer.builder.finish(&outputs).separated(|variable| symbols.is_state(variable));
        let part = |range: std::ops::Range<usize>| Plan {
            outputs: all.outputs[range].to_vec(),
            operations: all.operations.clone(),
        };
        let names = constant_names(&constants, &symbols);
        let given = Symbols { states: symbols.states.clone(), parameters: symbols.parameters };
        let symbols = Symbols { states: symbols.states, parameters: names };
        let read = |operation: &Operation| match operation {
            Operation::Prepared(place) => Operation::Input(symbols.parameter(*place)),
            other => other.clone(),
        };
        let needed = |plan: Plan| {
            let operations = plan.operations.iter().map(read).collect();
            Plan::together([&Plan { operations, ..plan }])
        };
        Lines {
            constants,
            rows: needed(part(0..rows)).fused(),
            field: needed(part(0..field.len())).fused(),
            sums: needed(part(rows..all.outputs.len())).fused(),
            entries,
            lower,
            upper,
            given,
            symbols,
        }
    }

    /// The sums that are claimed: integrals, then the Hamiltonian.
    pub fn sums(&self) -> impl Iterator<Item = &SiteSum> {
        self.integrals.iter().chain(&self.hamiltonian)
    }

    /// The couplings of an array, its own value among them.
    fn with_diagonal(&self, array: usize) -> Vec<usize> {
        let mut places = self.couplings(array);
        let own = self.place(0, array);
        if let Err(at) = places.binary_search(&own) {
            places.insert(at, own);
        }
        places
    }

    /// The values that a site sees, parameters of sites among them, as states whose names are
    /// identifiers.
    fn line_symbols(&self) -> Symbols {
        let of_sites = self.symbols.parameters[self.parameters.len()..].iter();
        let identifier = |name: &String| match name.split_once("[i") {
            Some((base, "]")) => base.to_owned(),
            Some((base, offset)) => {
                let side = if offset.starts_with('-') { "before" } else { "after" };
                format!("{base}_{side}_{}", offset.trim_matches(|c: char| !c.is_ascii_digit()))
            }
            None => name.clone(),
        };
        let names: Vec<String> = self.symbols.states.iter().chain(of_sites).map(identifier).collect();
        let is_clear =
            distinct(names.iter().chain(&self.parameters)).len() == names.len() + self.parameters.len();
        let numbered = || (0..names.len()).map(|k| format!("value_{k}")).collect();
        let states = if is_clear { names } else { numbered() };
        Symbols { states, parameters: self.parameters.clone() }
    }
}

struct Writer<'a> {
    family: &'a Family,
    symbols: &'a Symbols,
    builder: PlanBuilder,
}

impl Writer<'_> {
    /// A variable of the family in the line.
    fn renamed(&self, variable: Variable) -> Variable {
        let family = self.family;
        match family.role(variable) {
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

    /// 1 over what a component divides by, which is prepared unless it differs from site to site;
    /// `None` where it is 1.
    fn reciprocal(&mut self, component: &Component) -> Option<Node> {
        if component.denominator.is_one() {
            return None;
        }
        let below = self.polynomial(&component.denominator);
        let one = self.polynomial(&Polynomial::one());
        Some(self.builder.divide(one, below))
    }

    fn quotient(&mut self, component: &Component) -> Node {
        let above = self.polynomial(&component.numerator);
        match self.reciprocal(component) {
            Some(reciprocal) => self.builder.multiply(above, reciprocal),
            None => above,
        }
    }

    /// ε over what a component divides by.
    fn scale_of_row(&mut self, component: &Component) -> Node {
        let eps = self.builder.input(self.symbols.epsilon());
        match self.reciprocal(component) {
            Some(reciprocal) => self.builder.multiply(eps, reciprocal),
            None => eps,
        }
    }

    /// δ − ε ∂f/∂x
    fn entry(&mut self, slope: &Polynomial, scale: Node, is_diagonal: bool) -> Node {
        // −ε times a sum is ε times the sum of the other sign, which costs nothing.
        let slope = self.polynomial(&-slope);
        let scaled = self.builder.multiply(scale, slope);
        if !is_diagonal {
            return scaled;
        }
        let one = self.polynomial(&Polynomial::one());
        self.builder.add(one, scaled)
    }
}
