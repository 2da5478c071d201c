//! Finds, chooses and describes a lift.

#[cfg(test)]
mod tests;

use kahan_algebra::diagnostics::{Diagnostic, Kind};
use kahan_algebra::field::Field;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::{Notation, Text, equation_lines};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::Header;
use kahan_algebra::token::{Span, Token};

use crate::candidates::{SearchEffort, energy_candidates, field_of, modified_quadratic, ordinary_candidates};
use crate::choice::{LiftCriterion, RatedCandidate, choose};
use crate::embedding::{Builder, Embedding};
use crate::energy::{Mechanical, slopes};
use crate::equations::{EquationNames, Equations};
use crate::laurent::{Laurent, Monomial};
use crate::names::Writer;
use crate::quadratic::component;
use crate::ring::{CoordinateDefinition, Function, Ring};
use crate::stability::{LARGEST_EXPONENT, Orbit};

/// The settings by which a lift is chosen.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The criterion of the choice.
    pub which: LiftCriterion,
    /// The initial values and parameters of an orbit, in the order of [`EquationNames`].
    pub orbit: Option<(Vec<f64>, Vec<f64>)>,
    /// The largest number of search nodes. The value 0 means 20 000.
    pub budget: usize,
}

const DEFAULT_SEARCH_BUDGET: usize = 20_000;

/// A variable of a lift beyond the states.
#[derive(Clone, Debug)]
pub struct NewVariable {
    /// The name of the variable.
    pub name: String,
    /// The function of the states as text; `None` if the variable is the work done by the forces
    /// since the start, which is 0 at first.
    pub expression: Option<String>,
    value: Laurent,
}

/// The behaviour of a relation along an orbit of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RelationBehaviour {
    /// The map exactly preserves a modified relation, which differs from this one by terms in ε.
    Kept,
    /// The error stays bounded.
    Bounded,
    /// The error decays, while each step adds a new small error.
    Decays,
    /// The error grows in proportion to time.
    Drifts,
    /// The error grows exponentially.
    Grows,
}

/// A relation between the variables of a lift.
#[derive(Clone, Debug)]
pub struct Relation {
    /// The function that vanishes where the relation holds.
    pub text: String,
    /// The behaviour along the given orbit. Without an orbit, only `Kept` is known.
    pub along: Option<RelationBehaviour>,
    /// If the relation is `Kept`, the modified function that the map preserves exactly.
    pub formula: Option<String>,
    /// The growth rate of errors per unit of time. All relations of a lift get the largest rate.
    pub rate: Option<f64>,
    /// The index of the new variable that the relation defines.
    pub defines: Option<usize>,
}

/// A quadratic field that is equivalent to the original equations, if each new variable starts at
/// the value of its expression.
#[derive(Clone, Debug)]
pub struct Lift {
    /// The header of the block.
    pub header: Option<Header>,
    /// The names of the states. The time `t` comes last.
    pub states: Vec<String>,
    /// Whether the final state is the time.
    pub has_time: bool,
    /// The names of the parameters.
    pub parameters: Vec<String>,
    /// The new variables, in the order of their equations.
    pub new: Vec<NewVariable>,
    /// The quadratic field in the states and the new variables.
    pub field: Field,
    /// Whether a complete search proved that no lift has fewer new variables. The search covers
    /// lifts that write each monomial of the field as a product of at most two variables.
    pub is_optimal: bool,
    /// The reason why this lift was chosen.
    pub chosen: String,
    /// The relations between the variables of the lift.
    pub relations: Vec<Relation>,
    /// The energy that the map preserves exactly.
    pub energy: Option<String>,
    /// Warnings that a new variable is infinite at a point where the equations are finite, or that
    /// the phase of a periodic force lags behind in the map.
    pub notes: Vec<String>,
    ring: Ring,
    embedding: Embedding,
}

/// Finds a quadratic lift of the equations of a block.
///
/// # Errors
/// Returns diagnostics of mistakes in the text and of functions that cannot be lifted. Fails if no
/// lift is found within the budget.
pub fn lift(tokens: &[Token], options: &Options) -> Result<Lift, Vec<Diagnostic>> {
    let equations = Equations::read(tokens)?;
    let nodes = if options.budget == 0 { DEFAULT_SEARCH_BUDGET } else { options.budget };
    let nothing = |kind, message: &str, help: &str| {
        Err(vec![Diagnostic::new(kind, Span::token(0), message.to_owned(), help.to_owned())])
    };
    let mut candidates = Vec::new();
    if matches!(options.which, LiftCriterion::Automatic | LiftCriterion::Energy) && !equations.stated.has_time
    {
        candidates = energy_candidates(&equations, SearchEffort { nodes, surplus: options.orbit.is_some() });
    }
    if candidates.is_empty() && options.which == LiftCriterion::Energy {
        let (message, help) = if Mechanical::recognise(&equations.ring).is_some() {
            (
                "no energy lift of this mechanical system was found within the budget",
                "leave `=energy` away, or approximate the potential by a simpler one",
            )
        } else {
            (
                "this is not a mechanical system with a potential",
                "the energy lift is for x' = p, p' = -grad V(x) with constant masses; leave `=energy` away",
            )
        };
        return nothing(Kind::NotAPolynomial, message, help);
    }
    if candidates.is_empty() {
        let surplus = options.which != LiftCriterion::Smallest;
        candidates = ordinary_candidates(&equations, SearchEffort { nodes, surplus });
    }
    let orbit = followed(&equations, options);
    let Some((judged, chosen)) = choose(&candidates, options.which, orbit.as_ref()) else {
        let help = "write a part of the equations as a state of its own, or approximate it by a polynomial";
        return nothing(Kind::TooLarge, "no quadratic lift was found within the budget", help);
    };
    Ok(describe_lift(&equations, &judged, chosen))
}

fn followed(equations: &Equations, options: &Options) -> Option<Orbit> {
    let (start, parameters) = options.orbit.as_ref()?;
    Some(Orbit::new(&equations.ring, start, parameters))
}

/// Returns all lifts among which [`lift`] chooses with its default budget. Only the orbit of
/// `options` is used.
///
/// # Errors
/// Returns mistakes in the text, and functions that cannot be lifted.
pub fn lifts(tokens: &[Token], options: &Options) -> Result<Vec<Lift>, Vec<Diagnostic>> {
    let equations = Equations::read(tokens)?;
    let orbit = followed(&equations, options);
    let effort = SearchEffort { nodes: DEFAULT_SEARCH_BUDGET, surplus: true };
    let candidates =
        [energy_candidates(&equations, effort), ordinary_candidates(&equations, effort)].concat();
    let mut lifts = Vec::new();
    for candidate in &candidates {
        for form in &candidate.forms {
            let mut judged = RatedCandidate::new(candidate, form.clone());
            orbit.iter().for_each(|orbit| judged.follow(orbit));
            lifts.push(describe_lift(&equations, &judged, String::new()));
        }
    }
    Ok(lifts)
}

fn describe_lift(equations: &Equations, judged: &RatedCandidate<'_>, chosen: String) -> Lift {
    let EquationNames { states, parameters, has_time } = equations.stated.clone();
    let ring = &judged.candidate.ring;
    let writer = Writer::new(ring, &states, &parameters);
    let mut taken: Vec<String> =
        states.iter().chain(&parameters).cloned().chain(["eps".to_owned()]).collect();
    let mut new = Vec::new();
    for value in &judged.candidate.new {
        let is_last = new.len() + 1 == judged.candidate.new.len();
        let mut name = match value.as_monomial() {
            Some(monomial) => writer.name(monomial),
            None if is_last && judged.candidate.energy.is_some() => "W".to_owned(),
            None => format!("F{}", new.len() + 1),
        };
        while taken.contains(&name) {
            name.push('_');
        }
        taken.push(name.clone());
        let expression = (!value.is_zero()).then(|| writer.polynomial(value, &Text));
        new.push(NewVariable { name, expression, value: value.clone() });
    }
    let variables: Vec<String> =
        states.iter().cloned().chain(new.iter().map(|one| one.name.clone())).collect();
    let symbols = Symbols { states: variables, parameters: parameters.clone() };
    let field = Field { symbols, ..field_of(ring, &judged.form) };
    let text = |polynomial: &Polynomial| Text.polynomial(&field.symbols, polynomial);
    let fraction = |value: &RationalFunction| Text.function(&field.symbols, value);
    let mut relations: Vec<Relation> = judged
        .kept
        .iter()
        .map(|(relation, kept)| Relation {
            text: text(component(relation, field.dimension()).numerator()),
            along: Some(RelationBehaviour::Kept),
            formula: Some(fraction(&kept.of_map)),
            rate: None,
            defines: None,
        })
        .collect();
    for (index, variable) in new.iter().enumerate() {
        let Some(expression) = &variable.expression else { continue };
        let monomial = variable.value.as_monomial();
        let is_monomial = monomial.is_some_and(|one| one.is_in(states.len()));
        let own = Monomial::power(states.len() + index, 1);
        if is_monomial && judged.kept.iter().any(|(relation, _)| relation.contains(&own)) {
            continue;
        }
        let along = judged.growth.map(|growth| match growth {
            growth if growth.exponent < -LARGEST_EXPONENT => RelationBehaviour::Decays,
            growth if growth.is_stable() => RelationBehaviour::Bounded,
            growth if growth.is_polynomial() => RelationBehaviour::Drifts,
            _ => RelationBehaviour::Grows,
        });
        relations.push(Relation {
            text: format!("{} - ({expression})", variable.name),
            along,
            formula: None,
            rate: judged.growth.map(|growth| growth.exponent),
            defines: Some(index),
        });
    }
    let energy = judged.candidate.energy.as_ref().and_then(|energy| modified_quadratic(&field, energy));
    let energy = energy.map(|energy| fraction(&energy.of_map));
    let embedding = Builder::embedding(ring, &judged.candidate.new);
    Lift {
        header: equations.header.clone(),
        has_time,
        new,
        is_optimal: judged.candidate.is_optimal,
        chosen,
        relations,
        energy,
        notes: notes(ring, &judged.candidate.new, &writer),
        states,
        parameters,
        ring: Ring::clone(ring),
        embedding,
        field,
    }
}

/// Returns the zero of an affine function of one state, such as `v = -40`.
fn zero_of_affine(argument: &Laurent, writer: &Writer<'_>) -> Option<String> {
    let mut linear = argument.terms().filter(|(monomial, _)| !monomial.is_one());
    let (monomial, slope) = linear.next().filter(|_| argument.len() <= 2)?;
    let (state, _) = monomial.powers().next().filter(|_| linear.next().is_none() && monomial.size() == 1)?;
    let name = writer.states.get(state)?;
    let value = (-&argument.coefficient(&Monomial::one())).checked_div(slope)?;
    Some(format!("{name} = {}", writer.polynomial(&Laurent::constant(value), &Text)))
}

fn notes(ring: &Ring, new: &[Laurent], writer: &Writer<'_>) -> Vec<String> {
    let occurs = |index: usize, sign: i16| {
        let mut monomials = new.iter().flat_map(Laurent::terms);
        monomials.any(|(monomial, _)| monomial.exponent(index) * sign > 0)
    };
    let mut notes = Vec::new();
    for (index, coordinate) in ring.coordinates.iter().enumerate() {
        match &coordinate.meaning {
            // 1/(1 − exp u) is infinite at u = 0, but equations with u/(1 − exp u) are finite.
            CoordinateDefinition::Root(base, 1) if base.len() == 2 && occurs(index, -1) => {
                let slope = base.terms().find(|(monomial, _)| !monomial.is_one());
                let Some((monomial, value)) = slope else { continue };
                let is_zero = (value + &base.coefficient(&Monomial::one())).is_zero();
                let mut powers = monomial.powers().filter(|_| is_zero).map(|(index, _)| index);
                if let (Some(inner), None) = (powers.next(), powers.next())
                    && let CoordinateDefinition::Function(Function::Exp, argument) =
                        &ring.coordinates[inner].meaning
                {
                    let place = zero_of_affine(argument, writer)
                        .unwrap_or_else(|| format!("{} = 0", writer.polynomial(argument, &Text)));
                    notes.push(format!(
                        "1/({}) is infinite at {place}, even if the equations are finite there: orbits must not cross it",
                        writer.polynomial(base, &Text),
                    ));
                }
            }
            CoordinateDefinition::Function(Function::Sin, argument) if occurs(index, 1) => {
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
    /// Returns the number of new variables. The time is not one of them.
    #[must_use]
    pub fn order(&self) -> usize {
        self.new.len()
    }

    /// Returns a warning if errors of the relations grow along the orbit.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let growing = |relation: &&Relation| relation.along == Some(RelationBehaviour::Grows);
        let rate = self.relations.iter().find(growing)?.rate?;
        Some(format!(
            "errors of the lift's relations grow like e^({rate:.3}*t), so that its orbits are wrong after some time: compare with \
             another lift (smallest, stable, relations) or with reembed"
        ))
    }

    /// Returns the names of the states, followed by those of the new variables.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.field.symbols.states
    }

    /// Returns the quadratic equations in the language of `kahan!`, one for each line.
    #[must_use]
    pub fn text(&self) -> String {
        equation_lines(&self.field).collect::<Vec<_>>().join("\n")
    }

    /// Returns the expressions of the new variables. The work done since the start has no
    /// expression.
    #[must_use]
    pub fn expressions(&self, notation: &dyn Notation) -> Vec<Option<String>> {
        let writer = Writer::new(&self.ring, &self.states, &self.parameters);
        let written = |value: &Laurent| (!value.is_zero()).then(|| writer.polynomial(value, notation));
        self.new.iter().map(|one| written(&one.value)).collect()
    }

    /// Returns the values of the new variables at a point.
    ///
    /// # Panics
    /// If there are fewer values than states or parameters.
    #[must_use]
    pub fn embed(&self, states: &[f64], parameters: &[f64]) -> Vec<f64> {
        self.embedding.values(states, parameters)
    }

    /// Returns the program that computes the new variables.
    #[must_use]
    pub fn embedding(&self) -> &Embedding {
        &self.embedding
    }

    /// Returns the program that computes the derivatives of each new variable by all states except
    /// `t`. The results are ordered by variable, then by state. The derivatives of the work done
    /// since the start are 0.
    #[must_use]
    pub fn slopes(&self) -> Embedding {
        let states = self.states.len() - usize::from(self.has_time);
        Builder::embedding(&self.ring, &slopes(&self.ring, states, self.new.iter().map(|one| &one.value)))
    }

    /// Returns the values of the new variables at a point. Rational functions are computed exactly.
    /// Other functions get the floats that [`embed`](Self::embed) computes. Returns `None` if a
    /// value is infinite.
    ///
    /// # Panics
    /// If there are fewer values than states or parameters.
    #[must_use]
    pub fn embed_exact(&self, states: &[Rational], parameters: &[Rational]) -> Option<Vec<Rational>> {
        self.embedding.exact(states, parameters)
    }
}
