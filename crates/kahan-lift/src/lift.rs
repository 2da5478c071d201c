//! Which lift is chosen, and what is said of it.

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

use crate::candidates::{Effort, energy_candidates, field_of, modified, ordinary_candidates};
use crate::choice::{Judged, Which, choose};
use crate::embedding::{Builder, Embedding};
use crate::energy::{Mechanical, slopes};
use crate::equations::{Equations, Stated};
use crate::laurent::{Laurent, Monomial};
use crate::names::Writer;
use crate::quadratic::component;
use crate::ring::{Function, Meaning, Ring};
use crate::stability::{LARGEST_EXPONENT, Orbit};

/// The wish, the orbit and the budget from which a lift is chosen.
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

/// A variable of a lift beyond the states.
#[derive(Clone, Debug)]
pub struct NewVariable {
    /// Its name.
    pub name: String,
    /// The function of the states that it stands for, as text; none for the work done since the
    /// start, which is 0 there.
    pub expression: Option<String>,
    /// The function; 0 for the work done.
    value: Laurent,
}

/// The fate of a relation along an orbit of the map.
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
    /// Its fate along the orbit that was given; without an orbit, `Kept` or nothing.
    pub along: Option<Along>,
    /// The function that the map keeps exactly, as text.
    pub formula: Option<String>,
    /// The largest exponent of the linearised errors of all relations along the orbit, per unit of
    /// time.
    pub rate: Option<f64>,
    /// The place among the new variables of the one that the relation defines, where it defines
    /// one.
    pub defines: Option<usize>,
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
    /// Whether the search for a smaller set of monomials was complete and found none. It covers
    /// sets in which each missing monomial is a product of two variables.
    pub is_optimal: bool,
    /// The reason for the choice of this lift.
    pub chosen: String,
    /// The relations between the variables.
    pub relations: Vec<Relation>,
    /// The energy that the map keeps exactly.
    pub energy: Option<String>,
    /// Warnings: points where a new variable is infinite though the equations are
    /// not, and errors of the phases of periodic forces.
    pub notes: Vec<String>,
    ring: Ring,
    embedding: Embedding,
}

/// Finds a quadratic lift of the equations of a block.
///
/// # Errors
/// Mistakes in the text, what cannot be lifted, with its reason, and that no lift was found within
/// the budget.
pub fn lift(tokens: &[Token], options: &Options) -> Result<Lift, Vec<Diagnostic>> {
    let equations = Equations::read(tokens)?;
    let nodes = if options.budget == 0 { NODES } else { options.budget };
    let nothing = |kind, message: &str, help: &str| {
        Err(vec![Diagnostic::new(kind, Span::token(0), message.to_owned(), help.to_owned())])
    };
    let mut candidates = Vec::new();
    if matches!(options.which, Which::Automatic | Which::Energy) && !equations.stated.has_time {
        candidates = energy_candidates(&equations, Effort { nodes, surplus: options.orbit.is_some() });
    }
    if candidates.is_empty() && options.which == Which::Energy {
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
        let surplus = options.which != Which::Smallest;
        candidates = ordinary_candidates(&equations, Effort { nodes, surplus });
    }
    let orbit = followed(&equations, options);
    let Some((judged, chosen)) = choose(&candidates, options.which, orbit.as_ref()) else {
        let help = "write a part of the equations as a state of its own, or approximate it by a polynomial";
        return nothing(Kind::TooLarge, "no quadratic lift was found within the budget", help);
    };
    Ok(described(&equations, &judged, chosen))
}

/// The orbit along which lifts are judged.
fn followed(equations: &Equations, options: &Options) -> Option<Orbit> {
    let (start, parameters) = options.orbit.as_ref()?;
    Some(Orbit::new(&equations.ring, start, parameters))
}

/// Returns all lifts and forms between which [`lift`] chooses, with no reason for a choice.
///
/// # Errors
/// Mistakes in the text, and what cannot be lifted, with its reason.
pub fn lifts(tokens: &[Token], options: &Options) -> Result<Vec<Lift>, Vec<Diagnostic>> {
    let equations = Equations::read(tokens)?;
    let orbit = followed(&equations, options);
    let effort = Effort { nodes: NODES, surplus: true };
    let candidates =
        [energy_candidates(&equations, effort), ordinary_candidates(&equations, effort)].concat();
    let mut lifts = Vec::new();
    for candidate in &candidates {
        for form in &candidate.forms {
            let mut judged = Judged::new(candidate, form.clone());
            orbit.iter().for_each(|orbit| judged.follow(orbit));
            lifts.push(described(&equations, &judged, String::new()));
        }
    }
    Ok(lifts)
}

/// The answer: names, texts and the field.
fn described(equations: &Equations, judged: &Judged<'_>, chosen: String) -> Lift {
    let Stated { states, parameters, has_time } = equations.stated.clone();
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
            along: Some(Along::Kept),
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
            defines: Some(index),
        });
    }
    let energy = judged.candidate.energy.as_ref().and_then(|energy| modified(&field, energy));
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

/// Where an affine function of one state is 0, such as `v = -40`.
fn zero(argument: &Laurent, writer: &Writer<'_>) -> Option<String> {
    let mut linear = argument.terms().filter(|(monomial, _)| !monomial.is_one());
    let (monomial, slope) = linear.next().filter(|_| argument.len() <= 2)?;
    let (state, _) = monomial.powers().next().filter(|_| linear.next().is_none() && monomial.size() == 1)?;
    let name = writer.states.get(state)?;
    let value = (-&argument.coefficient(&Monomial::one())).checked_div(slope)?;
    Some(format!("{name} = {}", writer.polynomial(&Laurent::constant(value), &Text)))
}

/// Returns the warnings on the new variables.
fn notes(ring: &Ring, new: &[Laurent], writer: &Writer<'_>) -> Vec<String> {
    let occurs = |index: usize, sign: i16| {
        let mut monomials = new.iter().flat_map(Laurent::terms);
        monomials.any(|(monomial, _)| monomial.exponent(index) * sign > 0)
    };
    let mut notes = Vec::new();
    for (index, coordinate) in ring.coordinates.iter().enumerate() {
        match &coordinate.meaning {
            // 1 − exp u vanishes where u does, and the equations may hold u/(1 − exp u).
            Meaning::Root(base, 1) if base.len() == 2 && occurs(index, -1) => {
                let slope = base.terms().find(|(monomial, _)| !monomial.is_one());
                let Some((monomial, value)) = slope else { continue };
                let is_zero = (value + &base.coefficient(&Monomial::one())).is_zero();
                let mut powers = monomial.powers().filter(|_| is_zero).map(|(index, _)| index);
                if let (Some(inner), None) = (powers.next(), powers.next())
                    && let Meaning::Function(Function::Exp, argument) = &ring.coordinates[inner].meaning
                {
                    let place = zero(argument, writer)
                        .unwrap_or_else(|| format!("{} = 0", writer.polynomial(argument, &Text)));
                    notes.push(format!(
                        "1/({}) is infinite at {place}, even if the equations are finite there: orbits must not cross it",
                        writer.polynomial(base, &Text),
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

    /// That orbits are wrong after some time, where errors of the relations grow along the orbit
    /// that was followed.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let growing = |relation: &&Relation| relation.along == Some(Along::Grows);
        let rate = self.relations.iter().find(growing)?.rate?;
        Some(format!(
            "errors of the lift's relations grow like e^({rate:.3}*t), so that its orbits are wrong after some time: compare with \
             another lift (smallest, stable, relations) or with reembed"
        ))
    }

    /// The names of the states, then of the new variables.
    #[must_use]
    pub fn variables(&self) -> &[String] {
        &self.field.symbols.states
    }

    /// The equations of the quadratic field, one a line, in the language of `kahan!`.
    #[must_use]
    pub fn text(&self) -> String {
        equation_lines(&self.field).collect::<Vec<_>>().join("\n")
    }

    /// The expressions of the new variables in a notation; none for the work done since the start.
    #[must_use]
    pub fn expressions(&self, notation: &dyn Notation) -> Vec<Option<String>> {
        let writer = Writer::new(&self.ring, &self.states, &self.parameters);
        let written = |value: &Laurent| (!value.is_zero()).then(|| writer.polynomial(value, notation));
        self.new.iter().map(|one| written(&one.value)).collect()
    }

    /// The values of the new variables at these states, with these values of the parameters.
    ///
    /// # Panics
    /// If there are fewer states or parameters than the lift has.
    #[must_use]
    pub fn embed(&self, states: &[f64], parameters: &[f64]) -> Vec<f64> {
        self.embedding.values(states, parameters)
    }

    /// The values of the new variables as a program.
    #[must_use]
    pub fn embedding(&self) -> &Embedding {
        &self.embedding
    }

    /// The program that computes the derivatives of the new variables by the states without `t`,
    /// one variable after the other. The work done since the start has the derivatives 0.
    #[must_use]
    pub fn slopes(&self) -> Embedding {
        let states = self.states.len() - usize::from(self.has_time);
        Builder::embedding(&self.ring, &slopes(&self.ring, states, self.new.iter().map(|one| &one.value)))
    }

    /// The values of the new variables at these states, with these values of the parameters: exact
    /// where they are rational functions of the states, else from [`embed`](Self::embed)'s floats.
    /// `None` where one has no finite value.
    ///
    /// # Panics
    /// If there are fewer states or parameters than the lift has.
    #[must_use]
    pub fn embed_exact(&self, states: &[Rational], parameters: &[Rational]) -> Option<Vec<Rational>> {
        self.embedding.exact(states, parameters)
    }
}
