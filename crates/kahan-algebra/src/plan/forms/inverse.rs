//! Writes forms that are divided by the time step. With h = 1/(2ε), the denominator 1 + 2εx becomes
//! h + x.
//!
//! The product with ε in 1 + 2εx delays the division, and therefore each step. In h + x, only the
//! prepared constant h contains ε. If h is the only rounded constant, the step is exactly Kahan's
//! map for a time step within one ulp of 2ε. The form is undefined at ε = 0 and overflows near it.
//! For these ε, the plan contains another form.

use kahan_syntax::rational::Rational;

use crate::poly::{Monomial, Polynomial, Variable};

use crate::plan::forms::candidate::Candidate;
use crate::plan::forms::factored_map::FactoredMap;
use crate::plan::step::recurrence::least_recurrence;
use crate::plan::writing::nesting::FormGoal;
use crate::plan::writing::numerators::Power;
use crate::plan::writing::plan_draft::Signed;
use crate::plan::writing::scaling::{is_power_of_two, over_eps};
use crate::plan::writing::writer::Writer;

/// The largest power of ε by which forms are divided. With higher powers, floats overflow or
/// underflow too early.
const MOST_POWERS: u32 = 2;

impl FactoredMap<'_> {
    /// Returns candidates divided by ε or ε² whose dependence chain from step to step may be
    /// shorter than `recurrence`. Their constants are rounded once.
    pub(in crate::plan) fn over_time_step(&self, recurrence: u64) -> Vec<Candidate> {
        if self.empty.iter().any(|writer| writer.scaling.folds) {
            // Each term has a prepared constant that contains ε, so division by ε saves nothing.
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
                let written = writer.write_scaled(&denominator, FormGoal::Early);
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

    /// Returns whether a product of states has a sum of constants as coefficient.
    fn has_sums_of_constants(&self, polynomial: &Polynomial) -> bool {
        let groups = polynomial.group(|variable| self.field.symbols.is_state(variable));
        groups.iter().any(|(states, coefficient)| !states.is_one() && coefficient.len() > 1)
    }

    /// Writes a polynomial with one prepared constant for each product of states.
    fn with_coefficients(&self, writer: &mut Writer, polynomial: &Polynomial) -> Signed {
        let groups = polynomial.group(|variable| self.field.symbols.is_state(variable));
        let terms = groups.into_iter().map(|(states, coefficient)| {
            let prepared = Monomial::variable(writer.coefficient(&coefficient));
            (states.mul(&prepared), Rational::one())
        });
        let gathered = Polynomial::from_terms(terms.collect::<Vec<_>>());
        writer.write(&gathered, FormGoal::Early)
    }

    /// Writes the increment 2εn/d as (n/εᵏ⁻¹)·(c/q) with a number c and k = `power`. The node
    /// `denominator` has the value q = c·d/(2εᵏ). Returns `None` if the dependence chain from step
    /// to step would not be shorter than `recurrence`, or if a constant is rounded twice.
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

    fn moving_states(&self) -> Vec<Variable> {
        let components = self.numerators.iter().enumerate();
        let moving = components.filter(|(_, numerator)| !numerator.coefficient.is_zero());
        moving.map(|(i, _)| self.field.symbols.state(i)).collect()
    }

    /// Returns forms for a denominator p·q, one for each k up to `MOST_POWERS`. The increment 2εn/p
    /// becomes 2(n/εᵏ⁻¹)/(p/εᵏ), and 2εn/(p·q) becomes 2(n/εᵏ)/(p/εᵏ)/(q/ε).
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

    /// Returns q and c with c/q = 2εᵏ/p, where p = `polynomial` and k = `power`. The polynomial q
    /// is p/εᵏ, divided by its content if that is a power of two.
    fn divided(&self, polynomial: &Polynomial, power: u32) -> (Polynomial, Rational) {
        let divided = over_eps(polynomial, power, self.field.symbols.epsilon());
        let two = Rational::from(2);
        let content = divided.content().abs();
        let parts = content.recip().filter(|_| is_power_of_two(&content));
        parts.map_or((divided.clone(), two.clone()), |inverse| (divided.scale(&inverse), &two * &inverse))
    }
}
