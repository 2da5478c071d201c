//! A trial draws a random point, makes several kinds of steps from it, and compares the results
//! with the exact step.

use kahan_algebra::prime_field::SplitMix64;

use super::dyadic::Dyadic;
use super::float::Float;
use super::judge::ExactStep;
use super::points::{InputSampler, Inputs};
use super::regime::Regime;
use super::steps::{StepMethods, steps};
use super::survey::{TestedMap, TrialTarget};
use super::tally::{Cell, Failure, Tally};

pub(crate) struct Trials<'a, T> {
    targets: Vec<&'a TrialTarget>,
    fixed: Vec<Vec<Option<T>>>,
    /// The indices of the systems whose maps have poles.
    with_poles: Vec<usize>,
    with_removable_poles: Vec<usize>,
    strata: u64,
    seed: u64,
}

pub(crate) struct PreparedTrials<'a, T> {
    trials: Trials<'a, T>,
    steps: Vec<Box<dyn StepMethods<T>>>,
}

pub(crate) struct Trial<'a, T> {
    index: u64,
    target: &'a TrialTarget,
    /// The index of `target` among the tested systems.
    place: usize,
    inputs: Inputs<T>,
    /// The exact inputs and the exact step, if all inputs are finite.
    known: Option<ExactTrial>,
}

/// The finite inputs of a trial, and the exact step. The step is `None` at a pole.
struct ExactTrial {
    point: Vec<Dyadic>,
    exact: Option<Box<dyn ExactStep>>,
}

/// Returns `trials` plus the trials with subnormal inputs, nonfinite inputs, and large steps.
pub(crate) fn with_special_inputs(trials: u64) -> u64 {
    trials + 3 * special(trials)
}

fn special(trials: u64) -> u64 {
    (trials / 32).max(8)
}

impl<'a, T: Float> PreparedTrials<'a, T> {
    pub(crate) fn new(tried: &'a [TestedMap], trials: u64, seed: u64) -> Self {
        let steps = |tried: &TestedMap| steps(&tried.map).expect("what is tried has no more variables");
        Self {
            steps: tried.iter().map(steps).collect(),
            trials: Trials::new(tried.iter().map(|tried| &tried.target).collect(), trials, seed),
        }
    }

    pub(crate) fn count(&self) -> u64 {
        with_special_inputs(self.trials.strata)
    }

    pub(crate) fn run(&self, index: u64, tally: &mut Tally) {
        let trial = self.trials.draw(index);
        let steps = &self.steps[trial.place];
        let Inputs { parameters, x, eps, regime } = &trial.inputs;
        let mut count = |tier, next: &[T]| trial.count_plain(tally.cell((*regime, tier, T::NAME)), next);
        count(T::STEP_TIER, &steps.step(parameters, x, *eps));
        if let Some(tier) = T::WIDER_TIER
            && let Some(next) = steps.wider_step(parameters, x, *eps)
        {
            count(tier, &next);
        }
        if *regime == Regime::LargeSteps
            && let Some(next) = steps.eliminated(parameters, x, *eps)
        {
            count("lu", &next);
        }
        trial.count_stable(steps.try_step(parameters, x, *eps), tally);
    }
}

impl<'a, T: Float> Trials<'a, T> {
    pub(crate) fn new(targets: Vec<&'a TrialTarget>, trials: u64, seed: u64) -> Self {
        let indices = |has: fn(&TrialTarget) -> bool| {
            (0..targets.len()).filter(|&i| has(targets[i])).collect::<Vec<_>>()
        };
        let fixed = |target: &&TrialTarget| {
            target.parameters.iter().map(|value| value.as_ref().map(rounded)).collect::<Vec<_>>()
        };
        Self {
            with_poles: indices(|target| target.judge.has_poles()),
            with_removable_poles: indices(|target| target.judge.has_removable_poles()),
            fixed: targets.iter().map(fixed).collect(),
            targets,
            strata: trials,
            seed,
        }
    }

    /// Draws the trial with this index and makes its exact step.
    pub(crate) fn draw(&self, index: u64) -> Trial<'a, T> {
        let (place, inputs) = self.inputs(index);
        let target = self.targets[place];
        let known = inputs.exact().map(|point| ExactTrial { exact: target.judge.step(&point), point });
        Trial { index, target, place, inputs, known }
    }

    /// Returns the index of a trial's system, and the arguments of its step.
    pub(crate) fn inputs(&self, index: u64) -> (usize, Inputs<T>) {
        let (regime, place) = self.stratum(index);
        // Trials with neighbouring indices get independent random streams.
        let seed = SplitMix64::new(self.seed ^ index.wrapping_mul(0xd134_2543_de82_ef95)).next_u64();
        let (random, TrialTarget { judge, is_odd, .. }) = (SplitMix64::new(seed), self.targets[place]);
        (
            place,
            InputSampler { judge: &**judge, fixed: &self.fixed[place], is_odd: *is_odd, random }.draw(regime),
        )
    }

    /// Returns the regime of a trial and the index of its system. Successive trials cycle through
    /// regimes, then through systems.
    fn stratum(&self, index: u64) -> (Regime, usize) {
        let (regime, turn) = match index.checked_sub(self.strata) {
            Some(special) => {
                let special_regimes = [Regime::Subnormal, Regime::NotFinite, Regime::LargeSteps];
                (special_regimes[(special % 3) as usize], special / 3)
            }
            None => (Regime::ALL[(index % 4) as usize], index / 4),
        };
        let in_turn = |of: &[usize]| of[(turn % of.len() as u64) as usize];
        let any = (turn % self.targets.len() as u64) as usize;
        match regime {
            Regime::NearRemovablePole if !self.with_removable_poles.is_empty() => {
                (regime, in_turn(&self.with_removable_poles))
            }
            Regime::NearPole | Regime::NearRemovablePole if !self.with_poles.is_empty() => {
                (Regime::NearPole, in_turn(&self.with_poles))
            }
            Regime::NearPole | Regime::NearRemovablePole => (Regime::MixedMagnitudes, any),
            _ => (regime, any),
        }
    }
}

impl<T: Float> Trial<'_, T> {
    /// Counts the result of a step other than `try_step`, for which no error bound is promised. A
    /// finite result is wrong if its error exceeds 1e-3, or if the exact step is undefined.
    fn count_plain(&self, cell: &mut Cell, next: &[T]) {
        cell.trials += 1;
        match (exact_values(next), &self.known) {
            (None, _) => cell.flagged += 1,
            (Some(next), Some(ExactTrial { exact: Some(exact), .. })) => {
                let verdict = exact.judge(&T::FORMAT, &next);
                cell.note_error(Some(verdict.error_u));
                cell.silently_wrong += u64::from(!verdict.is_rough);
            }
            _ => cell.silently_wrong += 1,
        }
    }

    /// Counts a result of `try_step`. An `Ok` is wrong if its error exceeds the bound, or if the
    /// exact step is undefined.
    pub(crate) fn count_stable(&self, next: Option<Vec<T>>, tally: &mut Tally) {
        let Self { inputs, known, target, .. } = self;
        let mut complaint = None;
        let cell = tally.cell((inputs.regime, "stable", T::NAME));
        cell.trials += 1;
        match next {
            None => {
                cell.flagged += 1;
                if let Some(condition) = self.forbidden_flag() {
                    cell.unjustified += 1;
                    complaint = Some((true, format!("is flagged at a condition number of {condition:.1e}")));
                }
            }
            Some(next) => match (exact_values(&next), known) {
                (Some(next), Some(ExactTrial { exact: Some(exact), .. })) => {
                    let verdict = exact.judge(&T::FORMAT, &next);
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
            let (name, scalar) = (&target.name, T::NAME);
            let parameters =
                if parameters.is_empty() { String::new() } else { format!(", parameters {parameters:?}") };
            let text = format!("{name} in {scalar} at {x:?}, eps {eps:?}{parameters}: try_step {complaint}");
            tally.fail(name, Failure { is_flag, index: self.index, text });
        }
    }

    /// Returns the condition number if `try_step` must accept the step, otherwise `None`. It must
    /// if the field is defined, the format holds x̃, and the number is below `FLAG_CONDITION`.
    fn forbidden_flag(&self) -> Option<f64> {
        let (ExactTrial { point, exact }, judge) = (self.known.as_ref()?, &self.target.judge);
        let limit = T::FLAG_CONDITION?;
        if !exact.as_ref()?.fits(&T::FORMAT) || !judge.equation().at(point).is_defined() {
            return None;
        }
        Some(judge.condition(point)).filter(|condition| *condition < limit)
    }
}

fn exact_values<T: Float>(result: &[T]) -> Option<Vec<Dyadic>> {
    result.iter().map(|value| value.exact()).collect()
}

fn rounded<T: Float>(value: &kahan_algebra::rational::Rational) -> T {
    let (high, low) = value.to_double_double();
    let parts = Dyadic::of(high).zip(Dyadic::of(low));
    parts.map_or_else(|| T::not_finite(2), |(high, low)| T::near(&(&high + &low)))
}
