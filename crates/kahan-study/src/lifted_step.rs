//! Steps of lifted fields, which end an orbit where the original equations become undefined.
//!
//! A step returns NaN if a variable that is positive by definition, such as a square root, would
//! become negative, or if a requested projection onto the relations does not converge.

use kahan_algebra::rational::Rational;
use kahan_core::{EmbedScalar, Step, Stopped, Workspace};
use kahan_lift::{Lift, Reembedding};
use kahan_runtime::{End, MapAt, RuntimeFloat};

use crate::error::StudyError;
use crate::question::NoOrbit;
use crate::study::Study;

/// A step of a lifted field that detects where the original equations become undefined.
pub struct LiftedStep<'a, S: Step> {
    at: S,
    lift: &'a Lift,
    positive: Vec<usize>,
    projection: Option<Projection<'a, S::Scalar>>,
}

/// A step with projection onto the relations of a lift; returns `false` if the projection does not
/// converge.
type Projection<'a, T> = Box<dyn Fn(&mut [T], &mut dyn FnMut(&mut [T])) -> bool + Send + Sync + 'a>;

/// The reason why a point of a lifted field has no successor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LiftEnds {
    /// The next step makes the new variable with this index negative, although it is positive by
    /// definition.
    Negative(usize),
    /// Symmetric projection does not converge.
    NotReembedded,
}

/// An error of a relation that grows by more than this factor along an orbit causes a warning.
const EXPONENTIAL_GROWTH: f64 = 100.0;

impl LiftEnds {
    /// Describes the end of an orbit after `steps` steps.
    #[must_use]
    pub fn in_words(self, study: &Study, steps: u64) -> String {
        let next = steps + 1;
        match (self, study.lift()) {
            (LiftEnds::Negative(place), Some(lift)) => {
                let new = &lift.new[place];
                let (name, expression) = (&new.name, new.expression.as_deref().unwrap_or_default());
                format!(
                    "ends at n = {steps}: {name} = {expression} is never negative, and would be in step {next}, as where the \
                     solution ends, or eps is too large"
                )
            }
            _ => format!(
                "ends at n = {steps}: no step {next} near it leads back to the relations of the lift; a smaller eps may lead on"
            ),
        }
    }
}

impl Study {
    /// Returns steps that check the signs of new variables; `None` if no variable has a fixed sign.
    #[must_use]
    pub fn lifted_step<S: Step + Clone>(&self, at: &S) -> Option<LiftedStep<'_, S>> {
        let lift = self.lift()?;
        let positive = lift.embedding().positive();
        (!positive.is_empty()).then(|| LiftedStep { at: at.clone(), lift, positive, projection: None })
    }

    /// Checks that the field has relations onto which steps can be projected, if requested.
    ///
    /// # Errors
    /// [`NoOrbit::Reembed`] if the field was not lifted.
    pub fn can_reembed(&self, reembed: bool) -> Result<(), StudyError> {
        let has_relations = self.lift().is_some() || !reembed;
        if has_relations { Ok(()) } else { Err(StudyError::Orbit(NoOrbit::Reembed)) }
    }

    /// Warns if an error of the lift's relations grows more than 100-fold along the orbit from `at`
    /// until t = 100; `None` if the choice of the lift already considered errors.
    #[must_use]
    pub fn relations_warning(&self, at: &[Rational], eps: f64) -> Option<String> {
        let lift = self.lift().filter(|lift| lift.relations.iter().all(|one| one.rate.is_none()))?;
        let errors = self.measure_relations(at, eps).ok()?;
        let drifts = lift.relations.iter().enumerate();
        let drifts = drifts.filter_map(|(place, relation)| Some((relation, errors.drift(place)?)));
        let worst = drifts.max_by(|a, b| a.1.total_cmp(&b.1));
        let (relation, drift) = worst.filter(|(_, drift)| *drift > EXPONENTIAL_GROWTH)?;
        Some(format!(
            "errors of the relation {} grow {drift:.0e}-fold in 100 units of time along this orbit, so that it is wrong after \
             some time: the lift was chosen without a start; choose it for this one, or another lift (smallest, stable, \
             relations), or use reembed",
            relation.text,
        ))
    }

    /// Returns steps with the lift's checks or projection; `None` if the map's own steps suffice.
    #[must_use]
    pub fn steps<T: RuntimeFloat + EmbedScalar>(
        &self,
        at: &MapAt<T>,
        reembed: bool,
    ) -> Option<LiftedStep<'_, MapAt<T>>> {
        if reembed { self.reembedded_step(at) } else { self.lifted_step(at) }
    }

    /// Returns steps with symmetric projection onto the relations of a lift.
    fn reembedded_step<T: RuntimeFloat + EmbedScalar>(
        &self,
        at: &MapAt<T>,
    ) -> Option<LiftedStep<'_, MapAt<T>>> {
        let lift = self.lift()?;
        let values = at.map().parameters();
        let value = |name: &String| {
            let place = self.parameters().iter().position(|known| known == name);
            place.map_or(f64::NAN, |place| values[place].to_f64())
        };
        let parameters: Vec<f64> = lift.parameters.iter().map(value).collect();
        let project = move |x: &mut [T], step: &mut dyn FnMut(&mut [T])| {
            let embed = |states: &[f64]| lift.embed(states, &parameters);
            let mut states: Vec<f64> = x[..lift.states.len()].iter().map(|x| x.widened()).collect();
            let is_there = Reembedding::default().step(&mut states, embed, |point| {
                x.iter_mut().zip(&*point).for_each(|(x, value)| *x = T::narrowed(*value));
                step(x);
                point.iter_mut().zip(&*x).for_each(|(value, x)| *value = x.widened());
            });
            let new = embed(&states);
            x.iter_mut().zip(states.iter().chain(&new)).for_each(|(x, value)| *x = T::narrowed(*value));
            is_there
        };
        let (at, positive) = (at.clone(), lift.embedding().positive());
        Some(LiftedStep { at, lift, positive, projection: Some(Box::new(project)) })
    }
}

impl<T: RuntimeFloat, S: Step<Scalar = T>> LiftedStep<'_, S> {
    /// Returns the first new variable that is negative although its definition makes it positive.
    fn negative(&self, x: &[T]) -> Option<usize> {
        let new = &x[self.lift.states.len()..];
        self.positive.iter().copied().find(|&place| new[place].approximate() < 0.0)
    }

    /// Advances a point. At the end of the orbit, fills it with NaN and returns `false`.
    fn next(&self, x: &mut [T], mut step: impl FnMut(&mut [T])) -> bool {
        let is_there = match &self.projection {
            None => {
                step(x);
                self.negative(x).is_none()
            }
            Some(project) => {
                // The projection makes steps from several points. Only the first of these satisfies
                // the relations, so only the signs after the first step are checked.
                let (mut is_first, mut has_signs) = (true, true);
                let is_there = project(x, &mut |point| {
                    step(point);
                    has_signs &= !std::mem::take(&mut is_first) || self.negative(point).is_none();
                });
                is_there && has_signs
            }
        };
        if !is_there {
            x.fill(f32::NAN.into());
        }
        is_there
    }

    /// Returns why the lift ends the orbit at `x`, although the map itself has a next point.
    #[must_use]
    pub fn ends(&self, x: &[T]) -> Option<LiftEnds> {
        let mut next = x.to_vec();
        let _ = self.at.run(&mut next, 1);
        let negative = self.negative(&next).map(LiftEnds::Negative);
        negative.or_else(|| self.projection.is_some().then_some(LiftEnds::NotReembedded))
    }

    /// Returns whether a point has a negative variable that is positive by definition.
    #[must_use]
    pub fn is_beyond(&self, x: &[T]) -> bool {
        self.negative(x).is_some()
    }

    /// Returns [`End::Reembed`] if the projection fails after the last point `x`, otherwise `end`.
    #[must_use]
    pub fn end(&self, end: End, x: &[T]) -> End {
        match end {
            End::Range(steps) if self.ends(x) == Some(LiftEnds::NotReembedded) => End::Reembed(steps),
            end => end,
        }
    }
}

impl<T: RuntimeFloat, S: Step<Scalar = T>> Step for LiftedStep<'_, S> {
    type Scalar = T;
    type State = Vec<T>;

    fn dimension(&self) -> usize {
        self.at.dimension()
    }

    fn eps(&self) -> &T {
        self.at.eps()
    }

    fn advance(&self, x: &mut [T], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        // Float steps continue past poles, so the result is `Ok`.
        let mut step = |x: &mut [T]| {
            let _ = self.at.advance(x, 1, workspace);
        };
        let _ = (0..steps).all(|_| self.next(x, &mut step));
        Ok(())
    }

    fn part(&self, eps: &T, x: &mut [T], workspace: &mut Workspace) -> Result<(), Stopped> {
        self.next(x, |x| {
            let _ = self.at.part(eps, x, workspace);
        });
        Ok(())
    }
}
