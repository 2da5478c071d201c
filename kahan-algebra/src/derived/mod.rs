//! The plans of everything that is generated for a system: one object a row of what `kahan show --plan` prints.
//!
//! In: a checked system. Out: for each object its straight-line plan, as generated code computes it, so that what it
//! costs can be counted, printed and estimated before anything is compiled.

mod dual;
mod estimate;
mod listing;
mod names;

pub use estimate::Estimate;
pub use listing::StepListing;

use crate::field::Field;
use crate::kahan::{RationalMap, bilinear_form, field_jacobian, polarization};
use crate::plan::{Cost, Node, Operation, Plan, PlanBuilder, StepPlan};
use crate::poly::Polynomial;
use crate::rational::Rational;
use crate::syntax::ClaimKind;
use crate::system::{Claim, System};

/// One function that is generated for a system.
#[derive(Clone, Debug)]
pub struct Object {
    /// What it is called: `field f`, `det A`, `bracket P`.
    pub name: String,
    /// How it is written.
    pub style: Style,
    /// What it computes; `None` where it is elimination in a loop.
    pub plan: Option<Plan>,
}

/// How an object's code is written: what its size depends on beside its operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A function of one point.
    Plain,
    /// A function of two points.
    TwoPoints,
    /// A function of one point over dual numbers.
    Dual,
}

/// Everything that is generated for a system.
#[derive(Clone, Debug)]
pub struct Objects {
    /// The map in closed form; `None` beyond the budget.
    pub map: Option<RationalMap>,
    /// The step in straight lines; `None` where it eliminates with pivoting.
    pub step: Option<StepPlan>,
    /// The objects in the order of the generated code.
    pub list: Vec<Object>,
}

impl Object {
    fn new(name: impl Into<String>, plan: impl Into<Option<Plan>>) -> Self {
        Object { name: name.into(), style: Style::Plain, plan: plan.into() }
    }

    fn styled(self, style: Style) -> Self {
        Object { style, ..self }
    }

    /// The operations of the object and its chain; `None` where it is elimination.
    #[must_use]
    pub fn cost(&self) -> Option<Cost> {
        self.plan.as_ref().map(Plan::cost)
    }

    /// The machine code and the time to compile it, estimated; `None` where the object is elimination.
    #[must_use]
    pub fn estimate(&self) -> Option<Estimate> {
        self.plan.as_ref().map(|plan| Estimate::of(plan, self.style))
    }
}

impl Objects {
    /// Derives the map of a system, plans its step, and the plans of all else.
    ///
    /// Cost: that of [`RationalMap::of`] and [`StepPlan::of_map`], some milliseconds for a system of the catalog.
    #[must_use]
    pub fn of(system: &System) -> Self {
        let map = RationalMap::of(&system.field);
        let step = StepPlan::of_map(&system.field, map.as_ref());
        Self::from_parts(system, map, step)
    }

    /// The same from a map and a step that are known already.
    #[must_use]
    pub fn from_parts(system: &System, map: Option<RationalMap>, step: Option<StepPlan>) -> Self {
        let field = &system.field;
        let mut list = vec![
            Object::new("field f", field_plan(field)),
            Object::new("f'(x)", field_jacobian_plan(field)),
            Object::new("Q(x,x')", bilinear_plan(field)).styled(Style::TwoPoints),
            Object::new("polarised field", polarized_plan(field)).styled(Style::TwoPoints),
            Object::new("prepared constants", step.as_ref().map(|step| step.constants.clone())),
            Object::new("step", step.as_ref().map(|step| next_plan(field, step))),
            Object::new("Jacobian", step.as_ref().map(|step| dual::jacobian_plan(field, step)))
                .styled(Style::Dual),
            Object::new("det A", map.as_ref().map(det_matrix_plan)),
            Object::new("(N, D)", map.as_ref().map(rational_map_plan)),
        ];
        let integrals: Vec<&Claim> = system.accessors(ClaimKind::Integral).collect();
        if !integrals.is_empty() {
            list.push(Object::new("integrals", Plan::together(integrals.iter().map(|claim| &claim.plan))));
        }
        let densities = system.accessors(ClaimKind::Density).take(1);
        list.extend(densities.map(|claim| Object::new("density", claim.plan.clone())));
        list.extend(system.accessors(ClaimKind::Bracket).map(|claim| {
            let name = format!("bracket {}", claim.name.text);
            Object::new(name, claim.plan.clone())
        }));
        Objects { map, step, list }
    }
}

/// f(x), a component a result.
#[must_use]
pub fn field_plan(field: &Field) -> Plan {
    let numerators: Vec<Polynomial> =
        field.components.iter().map(|component| component.numerator.clone()).collect();
    over_denominators(field, &numerators, 1)
}

/// f′(x), row by row.
#[must_use]
pub fn field_jacobian_plan(field: &Field) -> Plan {
    let entries: Vec<Polynomial> = field_jacobian(field).into_iter().flatten().collect();
    over_denominators(field, &entries, field.dimension())
}

/// Q(x, y), a component a result; y are the second states.
#[must_use]
pub fn bilinear_plan(field: &Field) -> Plan {
    over_denominators(field, &bilinear_form(field), 1)
}

/// Q(x,y) + ½B(x+y) + c, a component a result.
#[must_use]
pub fn polarized_plan(field: &Field) -> Plan {
    over_denominators(field, &polarization(field), 1)
}

/// det A(x,ε), expanded.
#[must_use]
pub fn det_matrix_plan(map: &RationalMap) -> Plan {
    over_divisor(map, [&map.denominator])
}

/// (N, D), the numerators before the denominator, unreduced.
#[must_use]
pub fn rational_map_plan(map: &RationalMap) -> Plan {
    over_divisor(map, map.numerators.iter().chain([&map.denominator]))
}

/// The numerators x·d + 2εn of the reduced map, expanded, before its denominator d; `None` where nothing that depends on a
/// state was divided out, so that they are (N, D) up to a factor without poles.
#[must_use]
pub fn reduced_map_plan(field: &Field, map: &RationalMap) -> Option<Plan> {
    let symbols = &field.symbols;
    if !map.reduced.common_factor.variables().into_iter().any(|variable| symbols.is_state(variable)) {
        return None;
    }
    let two_eps = Polynomial::variable(symbols.epsilon()).scale(&Rational::from(2));
    let denominator = &map.reduced.denominator;
    let numerator = |(i, increment): (usize, &Polynomial)| {
        &(&Polynomial::variable(symbols.state(i)) * denominator) + &(&two_eps * increment)
    };
    let numerators: Vec<Polynomial> = map.reduced.increments.iter().enumerate().map(numerator).collect();
    Some(Plan::of(numerators.iter().chain([denominator])))
}

/// x̃ from x and the prepared constants: the kernel of a step, and its last multiply-add a component.
///
/// A numerator −n is subtracted rather than negated, as every compiler does it.
#[must_use]
pub fn next_plan(field: &Field, step: &StepPlan) -> Plan {
    let mut operations = step.kernel.operations.clone();
    let mut push = |operation: Operation| {
        operations.push(operation);
        Node(operations.len() - 1)
    };
    let (numerators, reciprocals) = step.kernel.outputs.split_at(field.dimension());
    let mut outputs = Vec::with_capacity(numerators.len());
    for (i, (&numerator, reciprocal)) in numerators.iter().zip(&step.reciprocals).enumerate() {
        let state = push(Operation::Input(field.symbols.state(i)));
        let negated = match step.kernel.operations[numerator.0] {
            Operation::Negate(inner) => Some(inner),
            _ => None,
        };
        outputs.push(push(match (negated, reciprocal.map(|index| reciprocals[index])) {
            (Some(inner), Some(reciprocal)) => Operation::SubtractProduct(state, inner, reciprocal),
            (Some(inner), None) => Operation::Subtract(state, inner),
            (None, Some(reciprocal)) => Operation::MultiplyAdd(numerator, reciprocal, state),
            (None, None) => Operation::Add(state, numerator),
        }));
    }
    // Each step once, and none that no result needs.
    Plan::together([&Plan { operations, outputs }])
}

/// These numerators, `width` of them over each component's denominator.
fn over_denominators(field: &Field, numerators: &[Polynomial], width: usize) -> Plan {
    let mut builder = PlanBuilder::default();
    let mut outputs = Vec::with_capacity(numerators.len());
    for (row, component) in numerators.chunks(width).zip(&field.components) {
        for numerator in row {
            let above = builder.polynomial(numerator);
            let below = builder.polynomial(&component.denominator);
            outputs.push(builder.divide(above, below));
        }
    }
    builder.finish(&outputs)
}

/// These polynomials over ∏q.
fn over_divisor<'a>(map: &RationalMap, polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Plan {
    let mut builder = PlanBuilder::default();
    let below = builder.polynomial(&map.divisor);
    let outputs: Vec<Node> = polynomials
        .into_iter()
        .map(|polynomial| {
            let above = builder.polynomial(polynomial);
            builder.divide(above, below)
        })
        .collect();
    builder.finish(&outputs)
}
