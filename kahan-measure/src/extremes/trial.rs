//! One trial: a point is drawn, stepped by each tier, and judged.

use kahan_algebra::prime_field::SplitMix64;

use super::Subject;
use super::dyadic::Dyadic;
use super::float::Float;
use super::judge::Exact;
use super::points::{Inputs, Points};
use super::regime::Regime;
use super::steps::Steps;
use super::tally::{Cell, Failure, Tally};

/// The trials of one scalar, ready to be run in any order.
pub(super) struct Ready<'a, T> {
    subjects: Vec<Runner<'a, T>>,
    /// The subjects that have poles and removable poles.
    with_poles: Vec<usize>,
    with_removable_poles: Vec<usize>,
    strata: u64,
    seed: u64,
}

/// A subject with its steps over one scalar.
struct Runner<'a, T> {
    subject: &'a Subject,
    steps: Steps<T>,
    fixed: Vec<Option<T>>,
}

/// The trials of one scalar, those with special inputs included.
pub(super) fn with_special_inputs(trials: u64) -> u64 {
    trials + 3 * special(trials)
}

/// The trials with subnormal inputs, and as many with inputs that are not finite, and as many large
/// steps.
fn special(trials: u64) -> u64 {
    (trials / 32).max(8)
}

impl<'a, T: Float> Ready<'a, T> {
    pub(super) fn new(subjects: &'a [Subject], trials: u64, seed: u64) -> Self {
        let runner = |subject: &'a Subject| {
            let fixed = subject.parameters.iter().map(|value| value.as_ref().map(rounded)).collect();
            Runner { subject, steps: Steps::of(&subject.map), fixed }
        };
        let subjects: Vec<Runner<'a, T>> = subjects.iter().map(runner).collect();
        let indices = |has: fn(&Subject) -> bool| {
            (0..subjects.len()).filter(|&i| has(subjects[i].subject)).collect::<Vec<_>>()
        };
        Self {
            with_poles: indices(|subject| !subject.judge.poles.is_empty()),
            with_removable_poles: indices(Subject::has_removable_poles),
            subjects,
            strata: trials,
            seed,
        }
    }

    /// How many trials there are.
    pub(super) fn trials(&self) -> u64 {
        with_special_inputs(self.strata)
    }

    /// The trial with this index.
    pub(super) fn run(&self, index: u64, tally: &mut Tally) {
        let (regime, runner) = self.stratum(index);
        // Neighbouring seeds give streams that have nothing in common.
        let seed = SplitMix64::new(self.seed ^ index.wrapping_mul(0xd134_2543_de82_ef95)).next_u64();
        let judge = &runner.subject.judge;
        let mut points = Points { judge, fixed: &runner.fixed, random: SplitMix64::new(seed) };
        let mut inputs = points.draw(regime);
        if inputs.regime == Regime::LargeSteps {
            inputs.eps = runner.eps_of_size(&inputs);
        }
        let exact = inputs.exact().map(|point| judge.step(judge.powers(&point)));
        let Inputs { parameters, x, eps, regime } = &inputs;
        let next = runner.steps.step(parameters, x, *eps);
        count_plain(tally.cell((*regime, T::STEP_TIER, T::NAME)), &next, exact.as_ref());
        if let Some(tier) = T::WIDER_TIER
            && let Some(next) = runner.steps.wider_step(parameters, x, *eps)
        {
            count_plain(tally.cell((*regime, tier, T::NAME)), &next, exact.as_ref());
        }
        if *regime == Regime::LargeSteps
            && let Some(next) = runner.steps.eliminated(parameters, x, *eps)
        {
            count_plain(tally.cell((*regime, "lu", T::NAME)), &next, exact.as_ref());
        }
        runner.stable(index, &inputs, exact.as_ref(), tally);
    }

    /// The regime and the subject of a trial: regimes in turn, and within each the subjects that it
    /// has, in turn.
    fn stratum(&self, index: u64) -> (Regime, &Runner<'a, T>) {
        let (regime, turn) = match index.checked_sub(self.strata) {
            Some(special) => {
                let special_regimes = [Regime::Subnormal, Regime::NotFinite, Regime::LargeSteps];
                (special_regimes[(special % 3) as usize], special / 3)
            }
            None => (Regime::ALL[(index % 4) as usize], index / 4),
        };
        let in_turn = |of: &[usize]| &self.subjects[of[(turn % of.len() as u64) as usize]];
        match regime {
            Regime::NearRemovablePole if !self.with_removable_poles.is_empty() => {
                (regime, in_turn(&self.with_removable_poles))
            }
            Regime::NearPole | Regime::NearRemovablePole if !self.with_poles.is_empty() => {
                (Regime::NearPole, in_turn(&self.with_poles))
            }
            Regime::NearPole | Regime::NearRemovablePole => (Regime::MixedMagnitudes, self.any(turn)),
            _ => (regime, self.any(turn)),
        }
    }

    fn any(&self, turn: u64) -> &Runner<'a, T> {
        &self.subjects[(turn % self.subjects.len() as u64) as usize]
    }
}

/// What the exact map says of the inputs: nothing where they are not finite, a pole, or a value.
type Known<'a> = Option<&'a Option<Exact>>;

/// A step without a promise: wrong is a finite result that is off by more than 1e-3, or where there
/// is none.
fn count_plain<T: Float>(cell: &mut Cell, next: &[T], known: Known<'_>) {
    cell.trials += 1;
    match (exact_values(next), known) {
        (None, _) => cell.flagged += 1,
        (Some(next), Some(Some(exact))) => {
            let verdict = exact.judge::<T>(&next);
            cell.note_error(Some(verdict.error_u));
            cell.silently_wrong += u64::from(!verdict.is_rough);
        }
        _ => cell.silently_wrong += 1,
    }
}

impl<T: Float> Runner<'_, T> {
    /// The ε for which ‖εf′‖∞ is what stands in its place, as nearly as that matters.
    fn eps_of_size(&self, inputs: &Inputs<T>) -> T {
        let Inputs { parameters, x, eps: size, .. } = inputs;
        let float = |value: &T| value.exact().map_or(0.0, |value| value.near_f64());
        let slopes = self.steps.slopes(parameters, x);
        let rows = slopes.chunks(x.len()).map(|row| row.iter().map(|slope| float(slope).abs()).sum());
        let eps = float(size) / rows.fold(0.0, f64::max);
        Dyadic::of(eps).map_or(*size, |eps| T::near(&eps))
    }

    /// `try_step`: wrong is an `Ok` outside the promise, or where there is no value.
    fn stable(&self, index: u64, inputs: &Inputs<T>, known: Known<'_>, tally: &mut Tally) {
        let place = (inputs.regime, "stable", T::NAME);
        let next = self.steps.try_step(&inputs.parameters, &inputs.x, inputs.eps);
        let mut complaint = None;
        let cell = tally.cell(place);
        cell.trials += 1;
        match next {
            None => {
                cell.flagged += 1;
                if let Some(condition) = self.forbidden_flag(known) {
                    cell.unjustified += 1;
                    complaint = Some((true, format!("is flagged at a condition number of {condition:.1e}")));
                }
            }
            Some(next) => match (exact_values(&next), known) {
                (Some(next), Some(Some(exact))) => {
                    let verdict = exact.judge::<T>(&next);
                    cell.note_error(Some(verdict.error_u));
                    if !verdict.keeps_promise {
                        cell.silently_wrong += 1;
                        complaint = Some((false, format!("is Ok and off by {:.3e} u", verdict.error_u)));
                    }
                }
                (next, known) => {
                    cell.silently_wrong += 1;
                    let why = match (next, known) {
                        (None, _) => "is Ok and not finite",
                        (_, None) => "is Ok from an input that is not finite",
                        _ => "is Ok at a pole",
                    };
                    complaint = Some((false, why.to_owned()));
                }
            },
        }
        if let Some((is_flag, complaint)) = complaint {
            let Inputs { parameters, x, eps, .. } = inputs;
            let (name, scalar) = (self.subject.name(), T::NAME);
            let parameters =
                if parameters.is_empty() { String::new() } else { format!(", parameters {parameters:?}") };
            let text = format!("{name} in {scalar} at {x:?}, eps {eps:?}{parameters}: try_step {complaint}");
            tally.fail(Failure { is_flag, index, text });
        }
    }

    /// The condition number at which a flag breaks the promise; `None` where a flag is right.
    fn forbidden_flag(&self, known: Known<'_>) -> Option<f64> {
        let exact = known?.as_ref()?;
        let limit = T::FLAG_CONDITION?;
        let condition = exact.fits::<T>().then(|| self.subject.judge.condition(exact))?;
        (condition < limit).then_some(condition)
    }
}

/// The exact values of a result; `None` if one is not finite.
fn exact_values<T: Float>(result: &[T]) -> Option<Vec<Dyadic>> {
    result.iter().map(|value| value.exact()).collect()
}

/// The scalar near a rational.
fn rounded<T: Float>(value: &kahan_algebra::rational::Rational) -> T {
    let (high, low) = value.to_double_double();
    let parts = Dyadic::of(high).zip(Dyadic::of(low));
    parts.map_or_else(|| T::not_finite(2), |(high, low)| T::near(&(&high + &low)))
}
