//! Forms divided by the time step: with h = 1/(2ε), the inverse time step, 1 + 2εx becomes h + x.
//!
//! A denominator d is 1 + O(ε) up to a constant, and what multiplies ε in it is on the way from
//! each state to the next. Divided by a power of ε it has that factor on a constant instead, which
//! a prepared step knows: E1's 1/(h + x) waits for one addition. Where h alone is left, as for
//! homogeneous fields of degree two in ε, it is the only rounded constant: the step is that of
//! Kahan's map at the half step 1/(2h), which differs from ε by half an ulp.
//!
//! Such a step has no value at ε = 0 and leaves the range of the scalar earlier, so whoever takes
//! it has another one besides.

use kahan_syntax::rational::Rational;

use crate::poly::{Monomial, Polynomial, Variable};

use crate::plan::forms::candidate::Candidate;
use crate::plan::forms::factored_map::FactoredMap;
use crate::plan::step::recurrence::least_recurrence;
use crate::plan::writing::draft::Signed;
use crate::plan::writing::nesting::Goal;
use crate::plan::writing::numerators::Power;
use crate::plan::writing::scaling::{is_power_of_two, over_eps};
use crate::plan::writing::writer::Writer;

/// The most powers of ε that are divided by: more of them leave the range of a scalar too early.
const MOST_POWERS: u32 = 2;

impl FactoredMap<'_> {
    /// The forms over ε and over ε², and the one with two divisions, as far as no constant in them
    /// is rounded twice and their [recurrence](crate::plan::StepPlan::recurrence) may be below this
    /// one.
    pub(in crate::plan) fn over_time_step(&self, recurrence: u64) -> Vec<Candidate> {
        if self.empty.iter().any(|writer| writer.scaling.folds) {
            // Constants are one product there, whatever is divided.
            return Vec::new();
        }
        let degree = self.map.reduced.denominator.degree_in(self.field.symbols.epsilon());
        let mut forms = self.two_divisions_over_time_step();
        let over_power = |power: u32, writer: Writer, denominator: Signed, c: &Rational| {
            self.over_power(power, writer, denominator, c, recurrence)
        };
        for power in 1..=degree.min(MOST_POWERS) {
            let (denominator, c) = self.divided(&self.map.reduced.denominator, power);
            for empty in &self.empty {
                let mut writer = empty.clone();
                let written = writer.write_scaled(&denominator, Goal::Early);
                forms.extend(over_power(power, writer, written, &c));
                if self.has_sums_of_constants(&denominator) {
                    let mut writer = empty.clone();
                    let written =
                        self.with_coefficients(&mut writer, &denominator.scale(&Rational::new(1, 2)));
                    forms.extend(over_power(power, writer, written, &(&c * &Rational::new(1, 2))));
                }
            }
        }
        forms.retain(Candidate::is_rounded_once);
        forms
    }

    /// Whether a product of states has a coefficient that is a sum, which is prepared as one where
    /// ε is left in it.
    fn has_sums_of_constants(&self, polynomial: &Polynomial) -> bool {
        let groups = polynomial.group(|variable| self.field.symbols.is_state(variable));
        groups.iter().any(|(states, coefficient)| !states.is_one() && coefficient.len() > 1)
    }

    /// A polynomial with all its coefficients prepared, so that a factor of all costs nothing.
    fn with_coefficients(&self, writer: &mut Writer, polynomial: &Polynomial) -> Signed {
        let groups = polynomial.group(|variable| self.field.symbols.is_state(variable));
        let terms = groups.into_iter().map(|(states, coefficient)| {
            let prepared = Monomial::variable(writer.coefficient(&coefficient));
            (states.mul(&prepared), Rational::one())
        });
        let gathered = Polynomial::from_terms(terms.collect::<Vec<_>>());
        writer.write(&gathered, Goal::Early)
    }

    /// x̃ − x = 2(n/εᵏ⁻¹)/(d/εᵏ), the denominator being written, and c/(that) its reciprocal;
    /// `None` where that tells already that the form is of no use.
    fn over_power(
        &self,
        power: u32,
        mut writer: Writer,
        denominator: Signed,
        c: &Rational,
        recurrence: u64,
    ) -> Option<Candidate> {
        let reciprocal = writer.reciprocal(c, denominator.node);
        let least = least_recurrence(&writer.draft.builder, reciprocal, &self.moving_states());
        if least >= recurrence || !writer.is_rounded_once(reciprocal) {
            return None;
        }
        let numerators = self.written_numerators(&mut writer, |_| Power::OverEps(power - 1), None);
        let over = |numerator| (numerator, reciprocal, denominator.negative);
        Some(Candidate::over(writer, numerators.into_iter().map(over)))
    }

    /// The states whose components are not zero.
    fn moving_states(&self) -> Vec<Variable> {
        let components = self.numerators.iter().enumerate();
        let moving = components.filter(|(_, numerator)| !numerator.coefficient.is_zero());
        moving.map(|(i, _)| self.field.symbols.state(i)).collect()
    }

    /// 2(n/εᵏ⁻¹)/(p/εᵏ) for numerators that one factor p divides, 2(n/εᵏ)/(p/εᵏ)/(q/ε) for those
    /// that both do.
    fn two_divisions_over_time_step(&self) -> Vec<Candidate> {
        let Some((needed, other)) = self.two_factors() else { return Vec::new() };
        let epsilon = self.field.symbols.epsilon();
        let second = over_eps(other, 1, epsilon);
        let powers = 1..=needed.degree_in(epsilon).min(MOST_POWERS);
        let form = |power: u32| {
            let (first, c) = self.divided(needed, power);
            let powers = [Power::OverEps(power - 1), Power::OverEps(power)];
            self.divided_twice([&first, &second], other, &c, powers)
        };
        powers.filter_map(form).collect()
    }

    /// p/εᵏ without a power of two, and what to divide by it for 2/(p/εᵏ).
    fn divided(&self, polynomial: &Polynomial, power: u32) -> (Polynomial, Rational) {
        let divided = over_eps(polynomial, power, self.field.symbols.epsilon());
        let two = Rational::from(2);
        let content = divided.content().abs();
        let parts = content.recip().filter(|_| is_power_of_two(&content));
        parts.map_or((divided.clone(), two.clone()), |inverse| (divided.scale(&inverse), &two * &inverse))
    }
}
