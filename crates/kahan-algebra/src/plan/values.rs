//! Plans in which values stand for what they are.
//!
//! A field [kept](crate::kept) as it was written is made of values; plans run on states and
//! parameters alone. Here each value becomes the operations that compute it, once a plan.

use kahan_syntax::rational::Rational;

use crate::kept::{Kept, Value, Values, WithConstants};
use crate::plan::{Input, plan_of};
use crate::poly::{Polynomial, Variable};
use crate::symbols::Symbol;

use super::{Node, Operation, Plan, PlanBuilder};

/// Values in a plan under construction, each written once.
struct Nodes<'a> {
    values: &'a Values,
    /// What the other variables are called in the plan.
    rename: &'a dyn Fn(Variable) -> Variable,
    known: Vec<Option<Node>>,
}

impl Nodes<'_> {
    fn value(&mut self, builder: &mut PlanBuilder, place: usize) -> Node {
        if let Some(node) = self.known[place] {
            return node;
        }
        let Values { values, .. } = self.values;
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

impl Values {
    /// The same plan with each input that is a value replaced by what it is.
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

    /// Replaces variables of a plan by values. `value` returns the place of the value that replaces a
    /// variable, or the variable's name in the new plan. `rename` returns the name there of a
    /// variable that occurs in a value.
    fn put_in(
        &self,
        plan: &Plan,
        value: impl Fn(Variable) -> Result<usize, Variable>,
        rename: &dyn Fn(Variable) -> Variable,
    ) -> Plan {
        let mut builder = PlanBuilder::default();
        let mut nodes = Nodes { values: self, rename, known: vec![None; self.values.len()] };
        let outputs = builder.include_mapped(plan, |builder, variable| match value(variable) {
            Ok(place) => nodes.value(builder, place),
            Err(other) => builder.input(other),
        });
        builder.finish(&outputs)
    }

    /// The plan of polynomials over the values, one result each.
    pub(crate) fn plan<'a>(&self, polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Plan {
        self.put_into(plan_of(polynomials))
    }
}

impl Kept {
    /// The plan of f(x), a component a result.
    pub(crate) fn plan(&self) -> Plan {
        self.values.plan(&self.components)
    }

    /// The plan of everything that is divided by, one result each: where one is zero there is no
    /// field.
    pub(crate) fn divisors(&self) -> Plan {
        self.values.plan(self.values.values.iter().filter_map(|value| match value {
            Value::Reciprocal(divisor) => Some(divisor),
            Value::Sum(_) => None,
        }))
    }
}

impl WithConstants {
    /// A plan in the variables of a family's line as one without values: `constant` is the index of
    /// the value that a variable of the plan stands for, `rename` what a variable of the field is
    /// called in the new plan.
    pub(crate) fn put_into_line(
        &self,
        plan: &Plan,
        constant: impl Fn(Variable) -> Result<usize, Variable>,
        rename: &dyn Fn(Variable) -> Variable,
    ) -> Plan {
        self.values.put_in(plan, |variable| constant(variable).map(|index| self.places[index]), rename)
    }

    /// A plan of this field as one of the field itself: what the values are is put in.
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
