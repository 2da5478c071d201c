//! Finds candidates for a lift. A lift is a quadratic field that is equivalent to given equations.
//!
//! The input consists of checked equations and limits of the search. The output consists of sets of
//! new variables that make the equations quadratic. Each set comes with alternative quadratic
//! fields and with relations.

use std::collections::BTreeMap;
use std::rc::Rc;

use kahan_algebra::field::Field;
use kahan_algebra::modified_integrals::{ModifiedIntegral, modified_integral};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

use crate::energy::Mechanical;
use crate::equations::Equations;
use crate::laurent::{Laurent, Monomial};
use crate::quadratic::{Products, Quadratic, component, times};
use crate::ring::Ring;
use crate::search::{CoverProblem, MOST_VARIABLES, founded, search};

/// At most this many sets of one size become candidates.
const MOST_SETS: usize = 8;

#[derive(Clone, Copy, Debug)]
pub(crate) struct SearchEffort {
    pub(crate) nodes: usize,
    /// Whether the search also returns sets with one variable more than the smallest set, and sets
    /// with a relation for each new variable.
    pub(crate) surplus: bool,
}

#[derive(Clone, Debug)]
pub(crate) struct Candidate {
    pub(crate) ring: Rc<Ring>,
    /// The new variables as functions of the states. An energy lift may have a variable for the
    /// work of the forces. If the work is no function of the states, its entry is 0.
    pub(crate) new: Vec<Laurent>,
    /// Alternative quadratic fields, with the preferred field first.
    pub(crate) forms: Vec<Vec<Quadratic>>,
    /// Polynomials in all variables that vanish if each new variable equals its function.
    pub(crate) relations: Vec<Quadratic>,
    pub(crate) is_optimal: bool,
    /// The energy that the flow preserves. Kahan's map of the lift preserves a modified energy.
    pub(crate) energy: Option<Quadratic>,
}

/// Returns the lifts with the fewest new variables, and lifts with one more variable.
pub(crate) fn ordinary_candidates(equations: &Equations, effort: SearchEffort) -> Vec<Candidate> {
    let surplus = usize::from(effort.surplus);
    let rings = [Some(equations.ring.clone()), equations.ring.with_frequent_sums()];
    let found: Vec<_> = rings
        .into_iter()
        .flatten()
        .filter_map(|ring| {
            let found = search(&ring, &equations.problem_in(&ring), effort.nodes, surplus, MOST_VARIABLES)?;
            Some((Rc::new(ring), found))
        })
        .collect();
    let least = found.iter().map(|(_, found)| found.sets[0].len()).min().unwrap_or(0);
    let mut candidates = Vec::new();
    for (ring, found) in &found {
        for size in least..=least + surplus {
            let sets = found.sets.iter().filter(|set| set.len() == size).take(MOST_SETS);
            candidates.extend(
                sets.filter_map(|set| {
                    ordinary_candidate(ring, set.clone(), found.is_optimal && size == least)
                }),
            );
        }
    }
    if effort.surplus
        && let Some(set) = founded(&equations.ring, &equations.problem_in(&equations.ring))
    {
        candidates.extend(ordinary_candidate(&Rc::new(equations.ring.clone()), set, false));
    }
    candidates.sort_by_key(|candidate| candidate.new.len());
    candidates
}

fn ordinary_candidate(ring: &Rc<Ring>, new: Vec<Laurent>, is_optimal: bool) -> Option<Candidate> {
    let products = Products::new(ring, &new);
    let forms = products.quadratic_fields(&BTreeMap::new())?;
    let relations = products.relations;
    Some(Candidate { ring: Rc::clone(ring), new, forms, relations, is_optimal, energy: None })
}

/// Returns the lifts of a mechanical system whose map preserves an energy.
pub(crate) fn energy_candidates(equations: &Equations, effort: SearchEffort) -> Vec<Candidate> {
    let Some(mechanical) = Mechanical::recognise(&equations.ring) else { return Vec::new() };
    let lifts = |ring: &Ring, least: usize| {
        let ring = Rc::new(ring.clone());
        let lifts = |as_sums| energy_lifts(equations, &ring, &mechanical, as_sums, effort, least);
        [false, true].into_iter().flat_map(lifts).collect::<Vec<_>>()
    };
    // The first search also allows sums of terms as variables. The second search allows only
    // monomials, and no more variables than the smallest lift that the first search found.
    let grouped =
        equations.ring.with_frequent_sums().map_or_else(Vec::new, |ring| lifts(&ring, MOST_VARIABLES));
    let least = grouped.iter().map(|one| one.new.len()).min().unwrap_or(MOST_VARIABLES);
    let mut candidates = lifts(&equations.ring, least);
    candidates.extend(grouped);
    candidates.sort_by_key(|one: &Candidate| one.new.len());
    candidates
}

/// Returns energy lifts in which the nonlinear terms of forces are variables. With `as_sums`, one
/// variable stands for the sum of all nonlinear terms of a force. Otherwise each monomial is a
/// variable. The size `least` of the smallest known lift limits the search.
fn energy_lifts(
    equations: &Equations,
    ring: &Rc<Ring>,
    mechanical: &Mechanical,
    as_sums: bool,
    effort: SearchEffort,
    least: usize,
) -> Vec<Candidate> {
    let states = ring.field.len();
    let mut problem = CoverProblem { required: Vec::new(), ..equations.problem_in(ring) };
    let mut forces: Vec<Laurent> = Vec::new();
    for &momentum in &mechanical.momenta {
        let curved = ring.field[momentum].filtered(|monomial| monomial.size() > 1 || !monomial.is_in(states));
        let parts: Vec<Laurent> = if as_sums && curved.len() > 1 {
            vec![curved.primitive().1]
        } else {
            curved.terms().map(|(monomial, _)| Laurent::from(monomial.clone())).collect()
        };
        for part in parts {
            if !forces.contains(&part) {
                forces.push(part);
            }
        }
    }
    for force in &forces {
        problem.required.extend(ring.derivative(force).terms().map(|(monomial, _)| monomial.clone()));
        match force.as_monomial() {
            Some(monomial) => problem.given.push(monomial.clone()),
            None => problem.sums.push(force.clone()),
        }
    }
    let surplus = usize::from(effort.surplus);
    let monomials = forces.len() - problem.sums.len();
    let most = (least + surplus).saturating_sub(monomials).min(MOST_VARIABLES);
    let Some(found) = search(ring, &problem, effort.nodes, surplus, most) else {
        return Vec::new();
    };
    let least = found.sets[0].len();
    let lift = |set: &Vec<Laurent>| {
        let mut new = [&forces[..], set].concat();
        // A sum that is an affine function of the other variables need not be a variable.
        let mut index = 0;
        while index < new.len() {
            let others: Vec<Laurent> = [&new[..index], &new[index + 1..]].concat();
            if new[index].len() > 1 && Products::new(ring, &others).affine(&new[index]).is_some() {
                new.remove(index);
            } else {
                index += 1;
            }
        }
        let is_optimal = found.is_optimal && set.len() == least;
        with_potential(ring, mechanical, new, is_optimal)
    };
    let of_size = |size: usize| found.sets.iter().filter(move |set| set.len() == size).take(MOST_SETS / 2);
    let founded = effort.surplus.then(|| founded(ring, &problem)).flatten();
    of_size(least).chain(of_size(least + 1)).chain(&founded).filter_map(lift).collect()
}

/// Chooses equations with which the map preserves the energy. Adds a variable for the potential if
/// the other variables do not suffice.
fn with_potential(
    ring: &Rc<Ring>,
    mechanical: &Mechanical,
    mut new: Vec<Laurent>,
    is_optimal: bool,
) -> Option<Candidate> {
    let states = ring.field.len();
    let is_quadratic = |monomial: &Monomial| monomial.size() <= 2 && monomial.is_in(states);
    let products = Products::new(ring, &new);
    let mut fixed = BTreeMap::new();
    for &momentum in &mechanical.momenta {
        let force = &ring.field[momentum];
        let sum = new.iter().position(|one| {
            one.len() > 1 && {
                let curved = force.filtered(|monomial| one.coefficient(monomial) != RationalFunction::zero());
                curved.len() == one.len()
            }
        });
        let equation = products.affine(force).or_else(|| {
            let sum = sum?;
            let (monomial, own) = new[sum].terms().next()?;
            let factor = force.coefficient(monomial).checked_div(own)?;
            let mut rest = force.clone();
            rest.add_scaled(&new[sum], &-&factor);
            let mut equation = products.affine(&rest)?;
            equation.add_term(Monomial::power(states + sum, 1), &factor);
            Some(equation)
        })?;
        fixed.insert(momentum, equation);
    }
    // The energy is ½ pᵀSp (momenta p, kinetic matrix S) plus quadratic terms of the potential.
    let half = RationalFunction::constant(Rational::new(1, 2));
    let mut energy = Quadratic::default();
    let mut power = Quadratic::default();
    for (row, &left) in mechanical.kinetic.iter().zip(&mechanical.momenta) {
        for (factor, &right) in row.iter().zip(&mechanical.momenta) {
            energy.add_term(Monomial::power(left, 1).times(&Monomial::power(right, 1)), &(factor * &half));
            power.add_scaled(&times(&fixed[&right], left)?, &-factor);
        }
    }
    let potential = mechanical.potential.as_ref().map(|potential| ring.normalised(potential));
    let curved = potential.as_ref().map(|potential| potential.filtered(|monomial| !is_quadratic(monomial)));
    if let Some(potential) = &potential {
        let plain = potential.filtered(is_quadratic);
        energy.add_scaled(&plain, &RationalFunction::one());
        for state in 0..states {
            let velocity = products.affine(&ring.field[state]);
            for (monomial, factor) in plain.partial(state).terms() {
                power.add_scaled(&velocity.as_ref()?.shifted(monomial), &-factor);
            }
        }
    }
    let mut forms = products.quadratic_fields(&fixed)?;
    let one = RationalFunction::one();
    let with_curved = curved.as_ref().and_then(|curved| products.affine(curved)).map(|affine| {
        let mut energy = energy.clone();
        energy.add_scaled(&affine, &one);
        let keeps = |form: &&Vec<Quadratic>| modified_quadratic(&field_of(ring, form), &energy).is_some();
        let kept: Vec<Vec<Quadratic>> = forms.iter().filter(keeps).cloned().collect();
        (energy, kept)
    });
    match with_curved.filter(|(_, kept)| !kept.is_empty()) {
        Some((with_curved, kept)) => (energy, forms) = (with_curved, kept),
        None => {
            energy.add_term(Monomial::power(states + new.len(), 1), &one);
            forms.iter_mut().for_each(|form| form.push(power.clone()));
            new.push(curved.unwrap_or_default());
        }
    }
    let relations = products.relations;
    Some(Candidate { ring: Rc::clone(ring), new, forms, relations, is_optimal, energy: Some(energy) })
}

/// Returns the modified integral that Kahan's map preserves, for a quadratic integral of the field.
pub(crate) fn modified_quadratic(field: &Field, integral: &Quadratic) -> Option<ModifiedIntegral> {
    let integral = component(integral, field.dimension());
    modified_integral(field, integral.numerator())
}

pub(crate) fn field_of(ring: &Ring, form: &[Quadratic]) -> Field {
    let numbered = |prefix: &str, count: usize| (0..count).map(|i| format!("{prefix}{i}")).collect();
    let symbols = Symbols { states: numbered("x", form.len()), parameters: numbered("p", ring.parameters) };
    Field { components: form.iter().map(|equation| component(equation, form.len())).collect(), symbols }
}
