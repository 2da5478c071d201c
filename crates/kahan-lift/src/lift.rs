//! Which lift is chosen, and what is said of it.

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use kahan_algebra::diagnostics::{Diagnostic, Kind};
use kahan_algebra::field::{Component, Field};
use kahan_algebra::modified_integrals::{ModifiedIntegral, modified_integral};
use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::{Formulas, Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::Header;
use kahan_algebra::token::{Span, Token};

use crate::embedding::{Builder, Embedding};
use crate::energy::Mechanical;
use crate::equations::Equations;
use crate::exact;
use crate::laurent::{Laurent, Monomial};
use crate::names::Writer;
use crate::numeric::Numeric;
use crate::quadratic::{Products, Quadratic};
use crate::ring::{Function, Meaning, Ring};
use crate::search::{Problem, founded, search};
use crate::stability::{Growth, LARGEST_EXPONENT, Orbit};

/// Which lift is wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Which {
    /// The energy lift of a mechanical system; else one whose relations are kept exactly; else one
    /// whose relations do not grow; else one of the least order.
    #[default]
    Automatic,
    /// The energy lift of a mechanical system.
    Energy,
    /// A lift with as many relations kept exactly as can be.
    Relations,
    /// A lift whose relations do not grow along the orbit.
    Stable,
    /// A lift of the least order.
    Smallest,
}

impl Which {
    /// All of them.
    pub const ALL: [Which; 5] =
        [Which::Automatic, Which::Energy, Which::Relations, Which::Stable, Which::Smallest];

    /// Its name, as `--lift=NAME` has it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Which::Automatic => "automatic",
            Which::Energy => "energy",
            Which::Relations => "relations",
            Which::Stable => "stable",
            Which::Smallest => "smallest",
        }
    }

    /// The lift that it asks for.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Which::Automatic => "The first of the others that there is",
            Which::Energy => "The energy lift of a mechanical system",
            Which::Relations => "As many relations kept exactly as can be",
            Which::Stable => "Relations that do not grow along the orbit",
            Which::Smallest => "As few new variables as can be",
        }
    }
}

/// What the choice between lifts is made from.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Which lift is wanted.
    pub which: Which,
    /// The start of an orbit and the values of the parameters, in their order. Without them no
    /// lift is judged by its orbit.
    pub orbit: Option<(Vec<f64>, Vec<f64>)>,
    /// The most nodes of the search; 0 for the number that suits a command.
    pub budget: usize,
}

/// The nodes of a search where none are given.
const NODES: usize = 20_000;
/// More parameters than a field has.
const MOST_PARAMETERS: usize = 1_000;
/// The most sets of new variables of one size that are judged.
const MOST_SETS: usize = 8;
/// The most pairs of a lift and a form that are followed along an orbit.
const MOST_FOLLOWED: usize = 24;

/// A variable of a lift beyond the states.
#[derive(Clone, Debug)]
pub struct NewVariable {
    /// Its name.
    pub name: String,
    /// The function of the states that it stands for, as text; none for the work done since the
    /// start, which is 0 there.
    pub expression: Option<String>,
    value: Option<Laurent>,
}

/// What becomes of a relation along an orbit of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// The map keeps a formula exactly.
    Kept,
    /// Its error stays bounded.
    Bounded,
    /// Its error decays but for what each step adds.
    Decays,
    /// Its error grows in proportion to time.
    Drifts,
    /// Its error grows exponentially.
    Grows,
}

/// A relation between the variables of a lift.
#[derive(Clone, Debug)]
pub struct Relation {
    /// The function that is 0 where the relation holds, as text.
    pub text: String,
    /// What becomes of it along the orbit that was given; kept without an orbit, too.
    pub along: Option<Along>,
    /// What the map keeps exactly, as text.
    pub formula: Option<String>,
    /// The exponent of its linearised error along the orbit, per unit of time.
    pub rate: Option<f64>,
}

/// A quadratic field that is equivalent to the equations where its new variables have the values
/// that their expressions say.
#[derive(Clone, Debug)]
pub struct Lift {
    /// The header, where the block has one.
    pub header: Option<Header>,
    /// The states as written, then `t` where it was lifted.
    pub states: Vec<String>,
    /// Whether the last state is the time.
    pub has_time: bool,
    /// The parameters.
    pub parameters: Vec<String>,
    /// The new variables.
    pub new: Vec<NewVariable>,
    /// The quadratic field, in the states and the new variables.
    pub field: Field,
    /// Whether no smaller set of monomials makes the equations quadratic.
    pub is_optimal: bool,
    /// Why this lift was chosen.
    pub chosen: String,
    /// The relations between the variables.
    pub relations: Vec<Relation>,
    /// The energy that the map keeps exactly.
    pub energy: Option<String>,
    /// What a user should know of: points where a new variable is infinite though the equations are
    /// not, and errors of the phases of periodic forces.
    pub notes: Vec<String>,
    ring: Ring,
    embedding: Embedding,
}

/// A lift with one form of its equations.
struct Candidate {
    ring: Ring,
    new: Vec<Option<Laurent>>,
    /// Forms of the field, the preferred one first.
    forms: Vec<Vec<Quadratic>>,
    /// Relations between the variables.
    relations: Vec<Quadratic>,
    is_optimal: bool,
    /// The energy of the flow.
    energy: Option<Quadratic>,
}

/// A candidate with one form, and what is known of it.
struct Judged<'a> {
    candidate: &'a Candidate,
    form: Vec<Quadratic>,
    kept: Vec<(Quadratic, ModifiedIntegral)>,
    growth: Option<Growth>,
}

/// Finds a quadratic lift of the equations of a block.
///
/// # Errors
/// Mistakes in the text, what cannot be lifted, with its reason, and that no lift was found within
/// the budget.
pub fn lift(tokens: &[Token], options: &Options) -> Result<Lift, Vec<Diagnostic>> {
    let equations = Equations::read(tokens)?;
    let budget = if options.budget == 0 { NODES } else { options.budget };
    let nothing = |kind, message: &str, help: &str| {
        vec![Diagnostic::new(kind, Span::token(0), message.to_owned(), help.to_owned())]
    };
    let mut candidates = Vec::new();
    if matches!(options.which, Which::Automatic | Which::Energy) && !equations.has_time {
        candidates = energy_candidates(&equations, budget);
    }
    if candidates.is_empty() && options.which == Which::Energy {
        let help =
            "the energy lift is for x' = p, p' = -grad V(x) with constant masses; leave `=energy` away";
        return Err(nothing(Kind::NotAPolynomial, "this is not a mechanical system with a potential", help));
    }
    if candidates.is_empty() {
        candidates = ordinary_candidates(&equations, budget, options.which != Which::Smallest);
    }
    let numeric = options.orbit.as_ref().map(|(start, parameters)| {
        let numeric = Numeric::new(&equations.ring, parameters);
        let orbit = Orbit::new(&numeric, start);
        (orbit, parameters)
    });
    let count = equations.parameters.len();
    let Some((judged, chosen)) = choose(&candidates, options.which, numeric.as_ref(), count) else {
        let help = "write a part of the equations as a state of its own, or approximate it by a polynomial";
        return Err(nothing(Kind::TooLarge, "no quadratic lift was found within the budget", help));
    };
    Ok(described(&equations, &judged, chosen))
}

/// The lifts of the least order and of one more.
fn ordinary_candidates(equations: &Equations, budget: usize, surplus: bool) -> Vec<Candidate> {
    let rings = [Some(equations.ring.clone()), equations.ring.grouped()];
    let found: Vec<_> = rings
        .into_iter()
        .flatten()
        .filter_map(|ring| {
            let found = search(&ring, &equations.problem_in(&ring), budget, usize::from(surplus))?;
            Some((ring, found))
        })
        .collect();
    let least = found.iter().map(|(_, found)| found.sets[0].len()).min().unwrap_or(0);
    let mut candidates = Vec::new();
    for (ring, found) in &found {
        for size in least..=least + usize::from(surplus) {
            let sets = found.sets.iter().filter(|set| set.len() == size).take(MOST_SETS);
            candidates.extend(sets.filter_map(|set| {
                let new = set.iter().cloned().map(Laurent::from).collect();
                candidate(ring, new, found.is_optimal && size == least, &BTreeMap::new())
            }));
        }
    }
    if surplus && let Some(set) = founded(&equations.ring, &equations.problem_in(&equations.ring)) {
        let new = set.into_iter().map(Laurent::from).collect();
        candidates.extend(candidate(&equations.ring, new, false, &BTreeMap::new()));
    }
    candidates.sort_by_key(|candidate| candidate.new.len());
    candidates
}

/// All variables: states, then new ones.
fn variables(ring: &Ring, new: &[Laurent]) -> Vec<Laurent> {
    (0..ring.field.len()).map(Laurent::coordinate).chain(new.iter().cloned()).collect()
}

fn candidate(
    ring: &Ring,
    new: Vec<Laurent>,
    is_optimal: bool,
    fixed: &BTreeMap<usize, Quadratic>,
) -> Option<Candidate> {
    let variables = variables(ring, &new);
    let products = Products::new(ring, &variables);
    let forms = products.forms(ring.field.len(), fixed)?;
    let relations = products.relations.clone();
    let new = new.into_iter().map(Some).collect();
    Some(Candidate { ring: ring.clone(), new, forms, relations, is_optimal, energy: None })
}

/// The lifts of a mechanical system whose map keeps an energy, of the least order.
fn energy_candidates(equations: &Equations, budget: usize) -> Vec<Candidate> {
    let Some(mechanical) = Mechanical::recognise(&equations.ring) else { return Vec::new() };
    let rings = [Some(equations.ring.clone()), equations.ring.grouped()];
    let mut candidates = Vec::new();
    for ring in rings.iter().flatten() {
        for as_sums in [false, true] {
            candidates.extend(energy_lifts(equations, ring, &mechanical, as_sums, budget));
        }
    }
    let least = candidates.iter().map(|one: &Candidate| one.new.len()).min();
    candidates.retain(|one| Some(one.new.len()) == least);
    candidates
}

/// The energy lifts in which the components of the force are variables, each as a sum or each of
/// its monomials.
fn energy_lifts(
    equations: &Equations,
    ring: &Ring,
    mechanical: &Mechanical,
    as_sums: bool,
    budget: usize,
) -> Vec<Candidate> {
    let states = ring.field.len();
    let is_state =
        |monomial: &Monomial| monomial.is_one() || (0..states).any(|i| *monomial == Monomial::power(i, 1));
    let mut problem = Problem { required: Vec::new(), ..equations.problem_in(ring) };
    let mut forces: Vec<Laurent> = Vec::new();
    for &momentum in &mechanical.momenta {
        let curved = ring.field[momentum].filtered(|monomial| !is_state(monomial));
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
    let Some(found) = search(ring, &problem, budget, 0) else { return Vec::new() };
    let lift = |set: &Vec<Monomial>| {
        let mut new = [forces.clone(), set.iter().cloned().map(Laurent::from).collect()].concat();
        // A sum that is affine in the other variables is no variable.
        let mut index = 0;
        while index < new.len() {
            let others: Vec<Laurent> = [&new[..index], &new[index + 1..]].concat();
            let variables = variables(ring, &others);
            if new[index].len() > 1 && Products::new(ring, &variables).affine(&new[index]).is_some() {
                new.remove(index);
            } else {
                index += 1;
            }
        }
        with_potential(ring, mechanical, new, found.is_optimal)
    };
    found.sets.iter().filter_map(lift).collect()
}

/// Adds the variable for the potential where it is needed, and the equations that keep the energy.
fn with_potential(
    ring: &Ring,
    mechanical: &Mechanical,
    new: Vec<Laurent>,
    is_optimal: bool,
) -> Option<Candidate> {
    let states = ring.field.len();
    let is_quadratic = |monomial: &Monomial| {
        monomial.size() <= 2 && monomial.powers().all(|(i, exponent)| i < states && exponent > 0)
    };
    let variables = variables(ring, &new);
    let products = Products::new(ring, &variables);
    let mut fixed = BTreeMap::new();
    for &momentum in &mechanical.momenta {
        let force = &ring.field[momentum];
        // A sum is written by its variable.
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
            equation.add_scaled(&Quadratic::multiple(states + sum, &RationalFunction::one()), &factor);
            Some(equation)
        })?;
        fixed.insert(momentum, equation);
    }
    // ½ pᵀSp and, of V, the part that is quadratic in the positions.
    let half = RationalFunction::constant(Rational::new(1, 2));
    let mut energy = Quadratic::default();
    let mut power = Quadratic::default();
    for (row, &left) in mechanical.kinetic.iter().zip(&mechanical.momenta) {
        for (factor, &right) in row.iter().zip(&mechanical.momenta) {
            energy.add_scaled(&Quadratic::product(left, right), &(factor * &half));
            power.add_scaled(&fixed[&right].times(left)?, &-factor);
        }
    }
    let potential = mechanical.potential.as_ref().map(|potential| ring.normalised(potential));
    let curved = potential.as_ref().map(|potential| potential.filtered(|monomial| !is_quadratic(monomial)));
    if let Some(potential) = &potential {
        let plain = Quadratic::in_states(&potential.filtered(is_quadratic));
        energy.add_scaled(&plain, &RationalFunction::one());
        for (&(left, right), factor) in &plain.0 {
            // d(x y)/dt = x′y + x y′ with velocities that are multiples of momenta.
            for (moved, other) in [(left, right), (right, left)] {
                let Some(moved) = moved else { continue };
                let velocity = products.affine(&ring.field[moved])?;
                let term = match other {
                    Some(other) => velocity.times(other)?,
                    None => velocity,
                };
                power.add_scaled(&term, &-factor);
            }
        }
    }
    let mut found = candidate(ring, new, is_optimal, &fixed)?;
    let one = RationalFunction::one();
    if let Some(affine) = curved.as_ref().and_then(|curved| products.affine(curved)) {
        let mut energy = energy.clone();
        energy.add_scaled(&affine, &one);
        let keeps = |form: &&Vec<Quadratic>| modified(&field_of(form, MOST_PARAMETERS), &energy).is_some();
        let forms: Vec<Vec<Quadratic>> = found.forms.iter().filter(keeps).cloned().collect();
        if !forms.is_empty() {
            return Some(Candidate { energy: Some(energy), forms, ..found });
        }
    }
    energy.add_scaled(&Quadratic::multiple(states + found.new.len(), &one), &one);
    found.forms.iter_mut().for_each(|form| form.push(power.clone()));
    found.new.push(curved);
    Some(Candidate { energy: Some(energy), ..found })
}

/// What the map keeps in the place of a quadratic integral.
fn modified(field: &Field, integral: &Quadratic) -> Option<ModifiedIntegral> {
    let integral = integral.component(field.dimension());
    modified_integral(field, integral.numerator())
}

/// The field of a form, with numbers for names.
fn field_of(form: &[Quadratic], parameters: usize) -> Field {
    let numbered = |prefix: &str, count: usize| (0..count).map(|i| format!("{prefix}{i}")).collect();
    let symbols = Symbols { states: numbered("x", form.len()), parameters: numbered("p", parameters) };
    let component = |equation: &Quadratic| {
        let value = equation.component(form.len());
        Component { numerator: value.numerator().clone(), denominator: value.denominator().clone() }
    };
    Field { components: form.iter().map(component).collect(), symbols }
}

/// The best candidate with its best form, and why it is.
fn choose<'a>(
    candidates: &'a [Candidate],
    which: Which,
    orbit: Option<&(Orbit, &Vec<f64>)>,
    parameters: usize,
) -> Option<(Judged<'a>, String)> {
    let mut judged: Vec<Judged<'_>> = Vec::new();
    // Preferred forms come before others, so that a limit leaves out the others.
    let most = candidates.iter().map(|candidate| candidate.forms.len()).max()?;
    for place in 0..most {
        for candidate in candidates {
            let Some(form) = candidate.forms.get(place) else { continue };
            if judged.len() < MOST_FOLLOWED {
                judged.push(Judged::new(candidate, form.clone(), orbit, parameters));
            }
        }
    }
    let order = |one: &Judged<'_>| one.candidate.new.len();
    let exponent = |one: &Judged<'_>| one.growth.map_or(0.0, |growth| growth.exponent);
    let best = |judged: Vec<Judged<'a>>| {
        judged.into_iter().reduce(|best, next| {
            let key = |one: &Judged<'_>| (order(one), usize::MAX - one.kept.len());
            let better =
                key(&next).cmp(&key(&best)).then(exponent(&next).total_cmp(&exponent(&best))).is_lt();
            if better { next } else { best }
        })
    };
    if candidates[0].energy.is_some() {
        let (stable, others): (Vec<_>, Vec<_>) =
            judged.into_iter().partition(|one| one.growth.is_none_or(|growth| growth.is_stable()));
        let found = best(if stable.is_empty() { others } else { stable })?;
        return Some((found, "its map keeps the energy exactly".to_owned()));
    }
    if matches!(which, Which::Automatic | Which::Relations) {
        let (kept, others): (Vec<_>, Vec<_>) = judged.into_iter().partition(Judged::keeps_all);
        if !kept.is_empty() {
            let chosen = "its map keeps every relation between its variables exactly".to_owned();
            return Some((best(kept)?, chosen));
        }
        judged = others;
        if which == Which::Relations {
            let most = judged.iter().map(|one| one.kept.len()).max()?;
            judged.retain(|one| one.kept.len() == most);
            let chosen = format!("its map keeps {most} of the relations exactly, and no other one more");
            return Some((best(judged)?, chosen));
        }
    }
    if which == Which::Smallest || orbit.is_none() {
        let least = judged.iter().map(order).min()?;
        judged.retain(|one| order(one) == least);
        let why = if which == Which::Smallest { "" } else { "; without a start, no orbit was followed" };
        return Some((best(judged)?, format!("no other lift has fewer new variables{why}")));
    }
    let (stable, others): (Vec<_>, Vec<_>) =
        judged.into_iter().partition(|one| one.growth.is_some_and(|growth| growth.is_stable()));
    if !stable.is_empty() {
        let chosen = "errors of its relations do not grow along the orbit, and no smaller lift has that";
        return Some((best(stable)?, chosen.to_owned()));
    }
    for one in &others {
        for damped in one.damped(orbit, parameters) {
            if damped.growth.is_some_and(|growth| growth.is_stable()) {
                let chosen = "multiples of its relations in its equations make their errors decay";
                return Some((damped, chosen.to_owned()));
            }
        }
    }
    let least = others.into_iter().min_by(|a, b| exponent(a).total_cmp(&exponent(b)))?;
    let rate = exponent(&least);
    let chosen = format!("errors of its relations grow least along the orbit, yet at the rate {rate:.3}");
    Some((least, chosen))
}

impl<'a> Judged<'a> {
    fn new(
        candidate: &'a Candidate,
        form: Vec<Quadratic>,
        orbit: Option<&(Orbit, &Vec<f64>)>,
        parameters: usize,
    ) -> Self {
        let field = field_of(&form, parameters);
        let kept = candidate
            .relations
            .iter()
            .filter_map(|relation| Some((relation.clone(), modified(&field, relation)?)))
            .collect();
        let growth = orbit.map(|(orbit, parameters)| {
            let numeric = Numeric::new(&candidate.ring, parameters);
            let known: Vec<Laurent> = candidate.new.iter().map_while(Clone::clone).collect();
            orbit.growth(&numeric, &known, &form[..candidate.ring.field.len() + known.len()], parameters)
        });
        Judged { candidate, form, kept, growth }
    }

    /// Forms with multiples of the relations that let errors decay: w′ −= κ R, where the relation R
    /// holds w linearly. κ exceeds the rate at which errors grow.
    fn damped(&self, orbit: Option<&(Orbit, &Vec<f64>)>, parameters: usize) -> Vec<Judged<'a>> {
        let states = self.candidate.ring.field.len();
        let rate = self.growth.map_or(1.0, |growth| growth.exponent.clamp(1e-3, 1e3));
        let damped = |factor: f64| {
            let damping = Rational::from_f64((factor * rate).log2().ceil().exp2())?;
            let mut form = self.form.clone();
            for (variable, equation) in form.iter_mut().enumerate().skip(states) {
                let own = (None, Some(variable));
                let others = |relation: &Quadratic| {
                    let new = |index: &Option<usize>| {
                        index.is_some_and(|index| index >= states && index != variable)
                    };
                    relation.0.keys().filter(|(left, right)| new(left) || new(right)).count()
                };
                let relations = self.candidate.relations.iter().filter(|one| one.0.contains_key(&own));
                let relation = relations.min_by_key(|relation| others(relation))?;
                let scale = RationalFunction::constant(-&damping).checked_div(&relation.0[&own])?;
                equation.add_scaled(relation, &scale);
            }
            Some(Judged::new(self.candidate, form, orbit, parameters))
        };
        [2.0, 8.0, 32.0].into_iter().filter_map(damped).collect()
    }

    /// Whether the map keeps one relation for each new variable, and one for each pair of a sine and
    /// a cosine.
    fn keeps_all(&self) -> bool {
        let Candidate { ring, new, .. } = self.candidate;
        let is_cosine = |value: &Option<Laurent>| {
            let monomial = value.as_ref().and_then(Laurent::as_monomial);
            monomial.is_some_and(|one| {
                one.size() == 1
                    && one.powers().all(|(index, _)| {
                        matches!(
                            ring.coordinates[index].meaning,
                            Meaning::Function(Function::Cos | Function::Cosh, _)
                        )
                    })
            })
        };
        self.kept.len() + new.iter().filter(|value| is_cosine(value)).count() >= new.len()
    }
}

/// The answer: names, texts and the field.
fn described(equations: &Equations, judged: &Judged<'_>, chosen: String) -> Lift {
    let ring = &judged.candidate.ring;
    let parameters = Symbols { states: Vec::new(), parameters: equations.parameters.clone() };
    let writer = Writer { ring, states: &equations.states, parameters: &parameters };
    let mut taken: Vec<String> =
        equations.states.iter().chain(&equations.parameters).cloned().chain(["eps".to_owned()]).collect();
    let mut new = Vec::new();
    for value in &judged.candidate.new {
        let mut name = match value.as_ref().map(Laurent::as_monomial) {
            Some(Some(monomial)) => writer.name(monomial),
            Some(None)
                if judged.candidate.energy.is_some() && new.len() + 1 == judged.candidate.new.len() =>
            {
                "W".to_owned()
            }
            Some(None) => format!("F{}", new.len() + 1),
            None => "W".to_owned(),
        };
        while taken.contains(&name) {
            name.push('_');
        }
        taken.push(name.clone());
        let expression = value.as_ref().map(|value| writer.polynomial(value, &Text));
        new.push(NewVariable { name, expression, value: value.clone() });
    }
    let variables: Vec<String> =
        equations.states.iter().cloned().chain(new.iter().map(|one| one.name.clone())).collect();
    let symbols = Symbols { states: variables, parameters: equations.parameters.clone() };
    let field = Field { symbols, ..field_of(&judged.form, equations.parameters.len()) };
    let text = |polynomial: &Polynomial| Text.polynomial(&field.symbols, polynomial);
    let fraction = |value: &RationalFunction| {
        if value.denominator().is_one() {
            text(value.numerator())
        } else {
            Text.fraction(&field.symbols, value.numerator(), value.denominator())
        }
    };
    let mut relations: Vec<Relation> = judged
        .kept
        .iter()
        .map(|(relation, kept)| Relation {
            text: text(relation.component(field.dimension()).numerator()),
            along: Some(Along::Kept),
            formula: Some(fraction(&kept.of_map)),
            rate: None,
        })
        .collect();
    let states = equations.states.len();
    for (index, variable) in new.iter().enumerate() {
        let Some(expression) = &variable.expression else { continue };
        let is_monomial = variable.value.as_ref().is_some_and(|value| {
            value.as_monomial().is_some_and(|one| one.powers().all(|(i, power)| i < states && power > 0))
        });
        let occurs = |relation: &Quadratic| relation.0.contains_key(&(None, Some(states + index)));
        if is_monomial && judged.kept.iter().any(|(relation, _)| occurs(relation)) {
            continue;
        }
        let along = judged.growth.map(|growth| match growth {
            growth if growth.exponent < -LARGEST_EXPONENT => Along::Decays,
            growth if growth.is_stable() => Along::Bounded,
            growth if growth.is_polynomial() => Along::Drifts,
            _ => Along::Grows,
        });
        relations.push(Relation {
            text: format!("{} - ({expression})", variable.name),
            along,
            formula: None,
            rate: judged.growth.map(|growth| growth.exponent),
        });
    }
    let energy = judged.candidate.energy.as_ref().and_then(|energy| modified(&field, energy));
    let energy = energy.map(|energy| fraction(&energy.of_map));
    let embedding = Builder::embedding(ring, new.iter().map(|new| new.value.as_ref()));
    Lift {
        header: equations.header.clone(),
        states: equations.states.clone(),
        has_time: equations.has_time,
        parameters: equations.parameters.clone(),
        new,
        is_optimal: judged.candidate.is_optimal,
        chosen,
        relations,
        energy,
        notes: notes(ring, &judged.candidate.new, &writer),
        ring: ring.clone(),
        embedding,
        field,
    }
}

/// What a user should know of the new variables.
fn notes(ring: &Ring, new: &[Option<Laurent>], writer: &Writer<'_>) -> Vec<String> {
    let occurs = |index: usize, sign: i16| {
        let mut monomials = new.iter().flatten().flat_map(Laurent::terms);
        monomials.any(|(monomial, _)| monomial.exponent(index) * sign > 0)
    };
    let mut notes = Vec::new();
    for (index, coordinate) in ring.coordinates.iter().enumerate() {
        match &coordinate.meaning {
            // 1 − exp u vanishes where u does, and the equations may hold u/(1 − exp u).
            Meaning::Root(base, 1) if occurs(index, -1) => {
                let exponent = base.terms().find_map(|(monomial, _)| {
                    let (inner, power) =
                        monomial.powers().next().filter(|_| monomial.powers().count() == 1)?;
                    match &ring.coordinates[inner].meaning {
                        Meaning::Function(Function::Exp, argument) => Some((inner, power, argument)),
                        _ => None,
                    }
                });
                let Some((inner, power, argument)) = exponent else { continue };
                let value_at_one =
                    base.terms().try_fold(RationalFunction::zero(), |sum, (monomial, value)| {
                        (monomial.is_one() || *monomial == Monomial::power(inner, power))
                            .then(|| &sum + value)
                    });
                if value_at_one.is_some_and(|value| value.is_zero()) {
                    notes.push(format!(
                        "1/({}) is infinite where {} = 0, even if the equations are finite there: orbits must not cross it",
                        writer.polynomial(base, &Text),
                        writer.polynomial(argument, &Text),
                    ));
                }
            }
            Meaning::Function(Function::Sin, argument) if occurs(index, 1) => {
                let frequency = ring.derivative(argument);
                if frequency.as_constant().is_some() {
                    notes.push(format!(
                        "the phase of sin({}) falls behind by ({})^3*eps^2/3 in a unit of time",
                        writer.polynomial(argument, &Text),
                        writer.polynomial(&frequency, &Text),
                    ));
                }
            }
            _ => {}
        }
    }
    notes
}

impl Lift {
    /// The number of new variables; `t` is not counted.
    #[must_use]
    pub fn order(&self) -> usize {
        self.new.len()
    }

    /// The names of the states, then of the new variables.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.field.symbols.states
    }

    /// The equations of the quadratic field, one a line, in the language of `kahan!`.
    #[must_use]
    pub fn text(&self) -> String {
        let sides = Formulas { field: &self.field, map: None, notation: &Text }.field();
        let lines = self.variables().iter().zip(sides).map(|(name, side)| format!("{name}dot = {side};"));
        lines.collect::<Vec<_>>().join("\n")
    }

    /// The expressions of the new variables in a notation; none for the work done since the start.
    #[must_use]
    pub fn expressions(&self, notation: &dyn Notation) -> Vec<Option<String>> {
        let parameters = Symbols { states: Vec::new(), parameters: self.parameters.clone() };
        let writer = Writer { ring: &self.ring, states: &self.states, parameters: &parameters };
        let written = |value: &Laurent| writer.polynomial(value, notation);
        self.new.iter().map(|one| one.value.as_ref().map(written)).collect()
    }

    /// The values of the new variables at these states, with these values of the parameters.
    ///
    /// # Panics
    /// If there are fewer states or parameters than the lift has.
    #[must_use]
    pub fn embed(&self, states: &[f64], parameters: &[f64]) -> Vec<f64> {
        self.embedding.values(states, parameters)
    }

    /// The values of the new variables as steps.
    #[must_use]
    pub fn embedding(&self) -> &Embedding {
        &self.embedding
    }

    /// The values of the new variables at these states, with these values of the parameters: exact
    /// where they are rational functions of the states, else from [`embed`](Self::embed)'s floats.
    /// `None` where one has no finite value.
    ///
    /// # Panics
    /// If there are fewer states or parameters than the lift has.
    #[must_use]
    pub fn embed_exact(&self, states: &[Rational], parameters: &[Rational]) -> Option<Vec<Rational>> {
        let coordinates = exact::coordinates(&self.ring, states, parameters)?;
        let value = |new: &NewVariable| match &new.value {
            Some(value) => exact::value(value, &coordinates, parameters),
            None => Some(Rational::zero()),
        };
        self.new.iter().map(value).collect()
    }
}
