//! Chooses the formulas by which a step is computed.

use crate::field::Field;
use crate::kahan::RationalMap;
use crate::subexpressions::FieldWithSubexpressions;

use crate::plan::StepPlan;
use crate::plan::accuracy::Accuracy;
use crate::plan::forms::candidate::Candidate;
use crate::plan::forms::candidates;

impl StepPlan {
    /// Returns the plan of a field's step. Returns `None` if the field is too large for
    /// straight-line code.
    #[must_use]
    pub fn of(field: &Field) -> Option<Self> {
        Self::of_map(field, None, RationalMap::of(field).as_ref())
    }

    /// Returns the plan of a step from the field as written and from its map.
    #[must_use]
    pub(crate) fn of_map(
        field: &Field,
        kept: Option<&FieldWithSubexpressions>,
        map: Option<&RationalMap>,
    ) -> Option<Self> {
        let is_reduced = |map: &RationalMap| map.reduced.common_factor.as_constant().is_none();
        let kept = kept.filter(|kept| kept.needs_sums(&field.symbols) && !map.is_some_and(is_reduced));
        let plan = |form: &Candidate| Self::new(&form.builder, field, &form.numerators, &form.reciprocals);
        let forms = candidates::forms(field, kept, map)?;
        let accuracy = Accuracy::of(field);
        // The formula with the fewest operations is best for many orbits in SIMD lanes. In a single
        // orbit, one with a shorter dependence chain from step to step may be faster.
        let cheapest = plan(&forms.best);
        let recurrence = cheapest.recurrence();
        let one_orbit = forms.of_one_orbit(recurrence);
        let one_orbit = one_orbit.iter().map(plan);
        let shortest = one_orbit.min_by_key(|plan| (plan.recurrence(), plan.operations()));
        let shortest = shortest.filter(|shortest| shortest.recurrence() < recurrence);
        let mut loss = accuracy.loss(&cheapest);
        let mut general = cheapest;
        if loss.is_refused() {
            let steady = match kept {
                Some(_) => Vec::new(),
                None => candidates::steady_forms(field, map, &forms.best),
            };
            if let Some(steady) = steady.iter().map(plan).find(|form| accuracy.is_kept(form)) {
                loss = accuracy.loss(&steady);
                general = steady;
            }
        }
        general.holds_to = loss.holds_to();
        let shortest = shortest
            .map(|shortest| (accuracy.loss(&shortest), shortest))
            .filter(|(own, _)| !own.is_refused() || loss.is_refused());
        Some(match shortest {
            Some((own, shortest)) => {
                StepPlan { holds_to: own.holds_to(), general: Some(Box::new(general)), ..shortest }
            }
            None => general,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns plans that take less time per step of an orbit than the cheapest plan, and the
    /// number of plans that were tried.
    fn shorter_recurrences(
        field: &Field,
        map: &RationalMap,
        recurrence: impl Fn(u64) -> u64,
    ) -> (Vec<StepPlan>, usize) {
        let plan =
            |form: &Candidate| StepPlan::new(&form.builder, field, &form.numerators, &form.reciprocals);
        let forms = candidates::forms(field, None, Some(map)).expect("the field is small");
        let limit = plan(&forms.best).recurrence();
        let made: Vec<StepPlan> = forms.of_one_orbit(recurrence(limit)).iter().map(plan).collect();
        let shorter = made.iter().filter(|plan| plan.recurrence() < limit).cloned();
        (shorter.collect(), made.len())
    }

    #[test]
    fn no_form_that_an_orbit_waits_less_for_is_given_up() {
        let mut given_up = 0;
        for text in [
            "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;",
            "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;",
            "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);",
            "xdot = x*(1 - y); ydot = y*(x - 1);",
            "struct P { a, b } xdot = a*x*y; ydot = b*y^2 - x;",
            "struct P { a, b, c, d, k } xdot = a*x*(1 - x/k) - b*x*y; ydot = c*x*y - d*y - b*y*z; zdot = b*y*z - a*z;",
        ] {
            let field = crate::read(&kahan_syntax::lexer::lex(text).tokens).system().expect("a system").field;
            let map = RationalMap::of(&field).expect("the field is small");
            let (all, made) = shorter_recurrences(&field, &map, |_| u64::MAX);
            let (some, fewer) = shorter_recurrences(&field, &map, |limit| limit);
            assert_eq!(all, some, "{text}");
            given_up += made - fewer;
        }
        assert!(given_up > 0, "no form is given up");
    }
}
