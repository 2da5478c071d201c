//! Inserts the [named subexpressions](crate::subexpressions) of a field into plans. A plan computes
//! each subexpression once.

use kahan_syntax::rational::Rational;

use crate::plan::{Input, plan_of};
use crate::poly::{Polynomial, Variable};
use crate::subexpressions::{FieldWithConstants, FieldWithSubexpressions, Subexpressions, Value};
use crate::symbols::Symbol;

use super::{Node, Operation, Plan, PlanBuilder};

struct SubexpressionNodes<'a> {
    values: &'a Subexpressions,
    rename: &'a dyn Fn(Variable) -> Variable,
    known: Vec<Option<Node>>,
}

impl SubexpressionNodes<'_> {
    fn value(&mut self, builder: &mut PlanBuilder, place: usize) -> Node {
        if let Some(node) = self.known[place] {
            return node;
        }
        let Subexpressions { values, .. } = self.values;
        let plan = plan_of([values[place].polynomial()]);
        let outputs = builder.include_mapped(&plan, |builder, variable| match self.values.place(variable) {
            Some(place) => self.value(builder, place),
            None => builder.input((self.rename)(variable)),
        });
        let mut node = outputs[0];
        if let Value::Reciprocal(_) = values[place] {
            let one = builder.constant(&Rational::one());
            node = builder.divide(one, node);
        }
        self.known[place] = Some(node);
        node
    }
}

impl Subexpressions {
    /// Replaces names of subexpressions by their operations.
    pub(crate) fn put_into(&self, plan: Plan) -> Plan {
        let is_value = |operation: &Operation| match operation {
            Operation::Input(Input::Variable(variable)) => self.place(*variable).is_some(),
            _ => false,
        };
        if !plan.operations.iter().any(is_value) {
            return plan;
        }
        self.put_in(&plan, |variable| self.place(variable).ok_or(variable), &|variable| variable)
    }

    /// Replaces each variable v of a plan by `value(v)`: `Ok` is the index of a subexpression,
    /// `Err` is another variable. Variables inside subexpressions are replaced by `rename`.
    fn put_in(
        &self,
        plan: &Plan,
        value: impl Fn(Variable) -> Result<usize, Variable>,
        rename: &dyn Fn(Variable) -> Variable,
    ) -> Plan {
        let mut builder = PlanBuilder::default();
        let mut nodes = SubexpressionNodes { values: self, rename, known: vec![None; self.values.len()] };
        let outputs = builder.include_mapped(plan, |builder, variable| match value(variable) {
            Ok(place) => nodes.value(builder, place),
            Err(other) => builder.input(other),
        });
        builder.finish(&outputs)
    }

    pub(crate) fn plan<'a>(&self, polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Plan {
        self.put_into(plan_of(polynomials))
    }
}

impl FieldWithSubexpressions {
    pub(crate) fn plan(&self) -> Plan {
        self.values.plan(&self.components)
    }

    /// Returns the plan of all divisors. The field is undefined where a divisor is zero.
    pub(crate) fn divisors(&self) -> Plan {
        self.values.plan(self.values.values.iter().filter_map(|value| match value {
            Value::Reciprocal(divisor) => Some(divisor),
            Value::Sum(_) => None,
        }))
    }
}

impl FieldWithConstants {
    /// Inserts subexpressions into a plan for one site. For each variable, `constant` returns its
    /// subexpression or another variable. `rename` replaces variables in subexpressions.
    pub(crate) fn put_into_line(
        &self,
        plan: &Plan,
        constant: impl Fn(Variable) -> Result<usize, Variable>,
        rename: &dyn Fn(Variable) -> Variable,
    ) -> Plan {
        self.values.put_in(plan, |variable| constant(variable).map(|index| self.places[index]), rename)
    }

    pub(crate) fn put_into(&self, plan: &Plan) -> Plan {
        if self.is_plain() {
            return plan.clone();
        }
        let first = self.symbols.parameters.len();
        let constant = |variable| match self.field.symbols.symbol(variable) {
            Symbol::Parameter(k) if k >= first => Ok(k - first),
            symbol => Err(self.symbols.variable(symbol)),
        };
        self.put_into_line(plan, constant, &|variable| variable)
    }
}
