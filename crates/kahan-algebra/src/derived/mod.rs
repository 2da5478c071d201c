//! Derives the field, the map and the claims of a system as straight-line plans.
//!
//! Code generators, maps at run time and printers read their plans from [`Derived`]. From equal
//! plans, all of them compute equal operations in equal order. [`Lines`] has the plans for one site
//! of a family.

mod lines;
mod listing;
mod names;

use std::sync::OnceLock;

pub use lines::{EntryPosition, Lines};
pub use listing::StepListing;
pub use names::{ValueName, ValueNames, constant_names};

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::ClaimKind;

use crate::arithmetic::OverRationals;
use crate::elimination::{Couplings, MOST_EXPANDED};
use crate::field::Field;
use crate::kahan::{RationalMap, SparseRows, bilinear_form, matrix_of, polarization, scaled_rhs};
use crate::plan::{DenseField, Node, Plan, PlanBuilder, StepPlan, plan_of, tangent_plan};
use crate::poly::Polynomial;
use crate::subexpressions::{FieldWithConstants, Subexpressions};
use crate::symbols::{Symbol, Symbols};
use crate::system::{Claim, System};

/// The plans of a system. Inputs are the states, the parameters and ε, which is half the time step.
#[derive(Clone, Debug)]
pub struct Derived {
    /// The system from which the plans are derived.
    pub system: System,
    /// The plan of the divisors of the field. The field is undefined where a divisor is zero.
    pub divisors: Plan,
    /// The map as polynomials. `None` if the budget of terms is exceeded.
    pub map: Option<RationalMap>,
    /// The plan of det A(x,ε) in expanded form. `None` if the budget is exceeded.
    pub det_matrix: Option<Plan>,
    /// The plan of the map before common factors are cancelled. Numerators come first, then the
    /// common denominator. `None` if the budget is exceeded.
    pub rational_map: Option<Plan>,
    /// The plan of the reduced map. Numerators come first, then the denominator. `None` if
    /// numerators and denominator of the map have no common factor that contains a state.
    pub reduced_map: Option<Plan>,
    /// The plan of all unconditional integrals.
    pub integrals: Plan,
    /// The names of the unconditional integrals.
    pub integral_names: Vec<String>,
    /// The plan of the unconditional density.
    pub density: Option<Plan>,
    /// The unconditional brackets by name. Each plan has the entries above the diagonal, row by
    /// row.
    pub brackets: Vec<(String, Plan)>,
    /// The unconditional drifts by name. Each plan computes F(x) and the claimed value of F(x̃).
    pub drifts: Vec<(String, Plan)>,
    /// The plans of the conditional claims. Each condition determines a name, and its value is
    /// substituted.
    pub conditional: Vec<Plan>,
    made: LazyPlans,
}

#[derive(Clone, Debug, Default)]
struct LazyPlans {
    planned: OnceLock<PlannedField>,
    at_eps_zero: OnceLock<Box<Derived>>,
    dense: OnceLock<Option<DenseField>>,
    field: OnceLock<Plan>,
    coefficients: OnceLock<Option<Plan>>,
    field_jacobian: OnceLock<Plan>,
    matrix: OnceLock<Plan>,
    bilinear: OnceLock<Plan>,
    polarized: OnceLock<Plan>,
    rhs: OnceLock<Plan>,
    step: OnceLock<Option<StepPlan>>,
    couplings: OnceLock<Option<Couplings>>,
    carry: OnceLock<Option<(Symbols, Plan)>>,
}

/// Derives the plans of a system. Methods of [`Derived`] derive further plans at their first call.
///
/// The cost is that of [`RationalMap::of`], some milliseconds for a system of the catalog.
#[must_use]
pub fn derive(system: &System) -> Derived {
    let System { field, kept, .. } = system;
    let map = if field.dimension() > MOST_EXPANDED { None } else { RationalMap::of(field) };
    let planned = map.as_ref().map(|map| PlannedField::of(system, Some(map)));
    let of_map = |plan: &dyn Fn(&RationalMap) -> Plan| planned.as_ref()?.with_map(plan);
    let claims = |kind| system.accessors(kind).map(|claim| (claim.name.text.clone(), &claim.plan));
    let single = |plan: &Plan| Plan::together([plan]);
    Derived {
        divisors: kept.divisors(),
        det_matrix: of_map(&|map| over_product(map, [&map.denominator])),
        rational_map: of_map(&|map| over_product(map, map.numerators.iter().chain([&map.denominator]))),
        reduced_map: planned.as_ref().and_then(PlannedField::reduced_map),
        map,
        made: LazyPlans {
            planned: planned.map_or_else(OnceLock::new, OnceLock::from),
            ..LazyPlans::default()
        },
        integrals: Plan::together(claims(ClaimKind::Integral).map(|(_, plan)| plan)),
        integral_names: claims(ClaimKind::Integral).map(|(name, _)| name).collect(),
        density: claims(ClaimKind::Density).next().map(|(_, plan)| single(plan)),
        brackets: claims(ClaimKind::Bracket).map(|(name, plan)| (name, single(plan))).collect(),
        drifts: claims(ClaimKind::Drift).map(|(name, plan)| (name, single(plan))).collect(),
        conditional: system.conditional().map(Claim::where_it_holds).collect(),
        system: system.clone(),
    }
}

#[derive(Clone, Debug)]
struct PlannedField {
    with_constants: FieldWithConstants,
    map: Option<RationalMap>,
}

impl PlannedField {
    /// Replaces subexpressions without states by parameters. Returns the field unchanged if the
    /// parameters would hide a common factor of the map's numerators and denominator.
    fn of(system: &System, map: Option<&RationalMap>) -> Self {
        let with = system.kept.with_constants(&system.field);
        let Some(map) = map.filter(|_| !with.is_plain()) else {
            return PlannedField { with_constants: with, map: map.cloned() };
        };
        // If the field depends on ε, a parameter replaces ε². Then degrees in ε are not compared.
        let counts_eps = !system.field.depends_on_eps();
        let is_as_short = |own: &RationalMap| {
            let (symbols, others) = (&with.field.symbols, &system.field.symbols);
            own.reduced.is_as_short(symbols, &map.reduced, others, counts_eps)
        };
        match RationalMap::of(&with.field).filter(is_as_short) {
            Some(own) => PlannedField { with_constants: with, map: Some(own) },
            None => PlannedField {
                with_constants: FieldWithConstants::plain(&system.field),
                map: Some(map.clone()),
            },
        }
    }

    fn with_map(&self, plan: impl FnOnce(&RationalMap) -> Plan) -> Option<Plan> {
        self.map.as_ref().map(|map| self.with_constants.put_into(&plan(map)))
    }

    fn reduced_map(&self) -> Option<Plan> {
        let symbols = &self.with_constants.field.symbols;
        let reduced = &self.map.as_ref()?.reduced;
        let plan = || plan_of(reduced.numerators(symbols).iter().chain([&reduced.denominator]));
        symbols.has_state(&reduced.common_factor).then(|| self.with_constants.put_into(&plan()))
    }
}

impl Derived {
    /// Returns the plans of the field at ε = 0. The map approximates the flow of this field.
    pub fn at_eps_zero(&self) -> &Derived {
        match self.system.field.depends_on_eps() {
            true => self.made.at_eps_zero.get_or_init(|| {
                let system = self.system.at_eps(&Rational::ZERO);
                derive(&system.expect("a checked field has a value at eps = 0")).into()
            }),
            false => self,
        }
    }

    /// Returns the plan of f(x) with one output for each component.
    pub fn field(&self) -> &Plan {
        self.made.field.get_or_init(|| match self.dense() {
            Some(dense) => dense.field(),
            None => self.system.kept.plan(),
        })
    }

    /// Returns the plan of the coefficients of a dense field, which contains many products of two
    /// variables. Returns `None` for other fields. Each component lists its constant cᵢ, the
    /// coefficients bᵢⱼ of variables, and the coefficients qᵢⱼₖ of products xⱼxₖ with j ≤ k, row by
    /// row:
    ///
    /// fᵢ = cᵢ + Σⱼ xⱼ·(bᵢⱼ + Σₖ qᵢⱼₖxₖ) with k ≥ j,
    ///
    /// ∂fᵢ/∂xⱼ = bᵢⱼ + Σₖ qᵢⱼₖxₖ, where the term k = j is doubled.
    ///
    /// Plans of f and its derivatives add terms in this order and skip zero coefficients.
    pub fn coefficients(&self) -> Option<&Plan> {
        let coefficients = || Some(self.dense()?.coefficients());
        self.made.coefficients.get_or_init(coefficients).as_ref()
    }

    /// Returns whether the field has [coefficients](Self::coefficients).
    pub fn is_dense(&self) -> bool {
        self.dense().is_some()
    }

    /// Returns the [coefficients](Self::coefficients) if the field has them and all are numbers.
    pub fn numbers(&self) -> Option<Vec<&Rational>> {
        self.dense()?.numbers()
    }

    fn dense(&self) -> Option<&DenseField> {
        let System { field, kept, .. } = &self.system;
        self.made.dense.get_or_init(|| DenseField::of(kept, &field.symbols)).as_ref()
    }

    /// Returns the plan of the Jacobian f′(x), row by row.
    pub fn field_jacobian(&self) -> &Plan {
        self.made.field_jacobian.get_or_init(|| match self.dense() {
            Some(dense) => dense.slopes(dense.entries()),
            None => {
                let (values, slopes) = self.slopes();
                values.plan(crate::kahan::dense(slopes).iter().flatten())
            }
        })
    }

    /// Returns the plan of the matrix A(x,ε), row by row.
    pub fn matrix(&self) -> &Plan {
        self.made.matrix.get_or_init(|| {
            let (values, slopes) = self.slopes();
            let epsilon = self.system.field.symbols.epsilon();
            values
                .plan(matrix_of(crate::kahan::dense(slopes), epsilon, |_| Polynomial::one()).iter().flatten())
        })
    }

    /// Returns the plan of the field's bilinear form Q(x,y), with y as [`Symbol::SecondState`].
    pub fn bilinear(&self) -> &Plan {
        self.made.bilinear.get_or_init(|| self.over_divisors(bilinear_form))
    }

    /// Returns the plan of the polarised field Q(x,y) + ½B(x+y) + c. The second states are y.
    pub fn polarized(&self) -> &Plan {
        self.made.polarized.get_or_init(|| self.over_divisors(polarization))
    }

    /// Returns the plan of the right-hand side b of A(x,ε)·x̃ = b(x,ε).
    pub fn rhs(&self) -> &Plan {
        self.made.rhs.get_or_init(|| self.over_divisors(scaled_rhs))
    }

    fn slopes(&self) -> (Subexpressions, SparseRows) {
        let System { field, kept, .. } = &self.system;
        kept.jacobian(&field.symbols)
    }

    fn planned(&self) -> &PlannedField {
        self.made.planned.get_or_init(|| PlannedField::of(&self.system, self.map.as_ref()))
    }

    fn over_divisors(&self, polynomials: impl FnOnce(&Field) -> Vec<Polynomial>) -> Plan {
        let with = &self.planned().with_constants;
        let polynomials = polynomials(&with.field);
        with.put_into(&quotients(polynomials.iter().zip(with.field.denominators())))
    }

    /// Returns the straight-line plan of the step. Returns `None` if steps solve their linear
    /// systems by elimination, as for large fields.
    ///
    /// The first call takes some milliseconds for a system of the catalog.
    pub fn step(&self) -> Option<&StepPlan> {
        let plan = || {
            let PlannedField { with_constants: with, map } = self.planned();
            let step = StepPlan::of_map(&with.field, with.kept.as_ref(), map.as_ref())?;
            Some(step.mapped(&|plan| with.put_into(plan)))
        };
        let is_written = self.system.field.dimension() <= MOST_EXPANDED;
        self.made.step.get_or_init(|| is_written.then(plan).flatten()).as_ref()
    }

    /// Returns the plan of Gaussian elimination in A(x,ε). Returns `None` if the step has a
    /// straight-line plan.
    ///
    /// The first call plans the [`step`](Self::step) and searches for an elimination order.
    pub fn couplings(&self) -> Option<&Couplings> {
        let found = || {
            let (values, slopes) = match self.dense() {
                Some(dense) => return Couplings::of_all(dense),
                None => self.slopes(),
            };
            Couplings::of(&values, &slopes)
        };
        self.made.couplings.get_or_init(|| self.step().is_none().then(found)).as_ref()
    }

    /// Returns the plan of (∂x̃/∂x)·v for a tangent vector v, given x, v and x̃. Returns `None` if
    /// the step has no straight-line plan, if a common factor was divided out of the map, or if
    /// every plan that is short enough loses digits in long steps.
    ///
    /// The symbols are those of the [variational](System::variational) field. Its states are x and
    /// v, and [`SecondState(i)`](Symbol::SecondState) stands for x̃ᵢ. The first call costs about as
    /// much as planning a step.
    pub fn tangent_map(&self) -> Option<(&Symbols, &Plan)> {
        let plan = || {
            let System { field, kept, .. } = self.system.variational();
            let with = kept.with_constants(&field);
            let plan = tangent_plan(&with.field)?;
            Some((field.symbols.clone(), with.put_into(&plan)))
        };
        let has_other_poles = self.reduced_map.is_some();
        let planned = || if has_other_poles || self.step().is_none() { None } else { plan() };
        self.made.carry.get_or_init(planned).as_ref().map(|(symbols, plan)| (symbols, plan))
    }

    /// Returns whether no divisor of the field is zero at this ε and these parameters.
    pub fn is_defined_at<A: OverRationals>(
        &self,
        arithmetic: &A,
        parameters: &[A::Value],
        eps: &A::Value,
    ) -> bool {
        let symbols = &self.system.field.symbols;
        let divisors = self.divisors.evaluate(arithmetic, |input| match symbols.symbol(input.variable()?) {
            Symbol::Parameter(k) => Some(parameters[k].clone()),
            Symbol::Epsilon => Some(eps.clone()),
            _ => unreachable!("divisors are free of states"),
        });
        divisors.iter().all(|value| value.as_ref().is_some_and(|value| !arithmetic.is_zero(value)))
    }

    /// Returns each function of the generated code with its plan and a description such as `det A`.
    /// The plan is `None` if the code eliminates in a loop.
    #[must_use]
    pub fn functions(&self) -> Vec<(String, Option<Plan>)> {
        let symbols = &self.system.field.symbols;
        let some = |name: &str, plan: &Plan| (name.to_owned(), Some(plan.clone()));
        let perhaps = |name: &str, plan: Option<&Plan>| (name.to_owned(), plan.cloned());
        let step = self.step();
        let general = step.and_then(|step| step.general.as_deref());
        let constants = |step: &StepPlan| step.constants.clone();
        let next = |step: &StepPlan| step.next(symbols);
        let mut functions = vec![
            some("field f", self.at_eps_zero().field()),
            some("f'(x)", self.at_eps_zero().field_jacobian()),
            some("Q(x,x')", self.at_eps_zero().bilinear()),
            some("polarised field", self.at_eps_zero().polarized()),
            ("prepared constants".to_owned(), step.map(constants)),
            ("step".to_owned(), step.map(next)),
        ];
        if let Some(general) = general {
            functions.push(("general constants".to_owned(), Some(constants(general))));
            functions.push(("general step".to_owned(), Some(next(general))));
        }
        functions.push(perhaps("det A", self.det_matrix.as_ref()));
        functions.push(perhaps("(N, D)", self.rational_map.as_ref()));
        functions.extend(self.reduced_map.iter().map(|plan| some("(N, D) reduced", plan)));
        if !self.integral_names.is_empty() {
            functions.push(some("integrals", &self.integrals));
        }
        functions.extend(self.density.iter().map(|plan| some("density", plan)));
        functions.extend(self.brackets.iter().map(|(name, plan)| some(&format!("bracket {name}"), plan)));
        functions.extend(self.drifts.iter().map(|(name, plan)| some(&format!("drift {name}"), plan)));
        let conditional = self.system.conditional().zip(&self.conditional);
        let named = |claim: &Claim| format!("{} {}", claim.kind.keyword(), claim.name.text);
        functions.extend(conditional.map(|(claim, plan)| some(&named(claim), plan)));
        functions
    }
}

fn quotients<'a>(quotients: impl IntoIterator<Item = (&'a Polynomial, &'a Polynomial)>) -> Plan {
    let mut builder = PlanBuilder::default();
    let quotients = quotients.into_iter().map(|(above, below)| builder.quotient(above, below));
    let outputs: Vec<Node> = quotients.collect();
    builder.finish(&outputs)
}

fn over_product<'a>(map: &'a RationalMap, polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Plan {
    quotients(polynomials.into_iter().map(|polynomial| (polynomial, &map.divisor)))
}
