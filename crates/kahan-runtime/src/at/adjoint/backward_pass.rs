//! The reverse sweep of the adjoint method over one step, stage by stage.

use kahan_core::{Composition, Scalar};

use crate::engine::{MapObject, TransposedSolver, stage_constants};
use crate::follow::is_within;
use crate::{MapAt, RuntimeFloat};

use super::Gradient;
use super::terms::Terms;

/// If solving with the transpose of A enlarges the gradient by more than this factor, det A is
/// nearly 0, and the stage is differentiated by dual numbers.
const LARGEST_GROWTH: f64 = 1024.0;

pub(super) struct BackwardPass<'a, T: RuntimeFloat> {
    /// For each distinct coefficient γ of the composition: Kahan's map at γε, and γ itself.
    distinct: Vec<(MapAt<T>, T)>,
    /// The terms of the field; `None` if coefficients depend on ε.
    terms: Option<Terms<T>>,
    solver: TransposedSolver<'a, T>,
    /// The entries of f′ at the points before and after a stage.
    slopes: [Vec<T>; 2],
    room: Vec<T>,
}

impl<'a, T: RuntimeFloat> BackwardPass<'a, T> {
    pub(super) fn of(at: &'a MapAt<T>) -> Self {
        let kahan = at.composed(Composition::KAHAN);
        let composition = at.composition;
        let stages = stage_constants(at.kind, &at.constants, composition).into_iter();
        let distinct = stages.zip(composition.coefficients()).map(|(mut constants, gamma)| {
            let eps = constants.pop().unwrap_or_else(|| unreachable!("there is an eps"));
            (kahan.at_constants(at.map.clone(), constants.into_iter(), eps), T::constant(gamma))
        });
        let solver = at.engine().transposed();
        let terms = || Terms::of(&at.map, solver.entries().len(), solver.places());
        let terms = (!at.map.field().system().field.depends_on_eps()).then(terms);
        let slopes = [(); 2].map(|()| vec![T::zero(); solver.entries().len()]);
        BackwardPass { distinct: distinct.collect(), terms, solver, slopes, room: Vec::new() }
    }

    pub(super) fn stages(&self) -> usize {
        2 * self.distinct.len() - 1
    }

    fn stage(&self, k: usize) -> usize {
        k.min(self.stages() - 1 - k)
    }

    pub(super) fn begin(&mut self, x: &[T]) {
        if let Some(terms) = &self.terms {
            terms.slopes(x, &mut self.slopes[1]);
        }
    }

    pub(super) fn make_step(&mut self, points: &mut Vec<T>) {
        let n = self.distinct[0].0.dimension();
        for k in 0..self.stages() {
            let first = points.len() - n;
            points.extend_from_within(first..);
            self.distinct[self.stage(k)].0.advance_checked([&mut points[first + n..], &mut []], 1);
        }
    }

    /// Propagates `gradient.start` back over the last step, and removes the step's points.
    pub(super) fn take_step(&mut self, points: &mut Vec<T>, gradient: &mut Gradient<T>) {
        let n = gradient.start.len();
        for k in (0..self.stages()).rev() {
            let (before, next) = points.split_at(points.len() - n);
            self.take_stage(self.stage(k), [&before[before.len() - n..], next], gradient);
            points.truncate(points.len() - n);
        }
    }

    fn take_stage(&mut self, stage: usize, [x, next]: [&[T]; 2], gradient: &mut Gradient<T>) {
        let BackwardPass { distinct, terms, solver, slopes: [before, behind], room: mu } = self;
        let Some(terms) = terms else { return self.take_by_duals(stage, x, gradient) };
        let (map, gamma) = &distinct[stage];
        let eps = map.eps();
        terms.slopes(x, before);
        mu.clear();
        mu.extend_from_slice(&gradient.start);
        solver.solve(before, eps, mu);
        if !is_within(mu, LARGEST_GROWTH * largest(&gradient.start)) {
            self.take_by_duals(stage, x, gradient);
        } else {
            let half = T::one() / (T::one() + T::one());
            // Let f(x) = c + Bx + Q(x,x). The right-hand side c + ½B(x + x̃) + Q(x,x̃) of the step
            // equals c + ½Bx + ½f′(x)x̃. Its scalar product with μ becomes `along`.
            let mut along = terms.along_linear(x, mu);
            gradient.start.copy_from_slice(mu);
            for (((i, j), before), behind) in solver.entries().iter().zip(&*before).zip(&*behind) {
                along += half * mu[*i] * *before * next[*j];
                gradient.start[*j] += eps * *behind * mu[*i];
            }
            terms.add_by_parameters(eps, [x, next], mu, &mut gradient.parameters);
            gradient.eps += *gamma * (along + along);
        }
        self.slopes.swap(0, 1);
    }

    /// Propagates the gradient back over a stage by dual numbers, which also works near det A = 0.
    fn take_by_duals(&mut self, stage: usize, x: &[T], gradient: &mut Gradient<T>) {
        let (map, gamma) = &self.distinct[stage];
        let n = x.len();
        let mut jacobian = vec![T::zero(); n * n];
        map.engine().evaluate(MapObject::Jacobian, &map.constants, x, &mut jacobian);
        let by = |k: usize| {
            let slopes = map.engine().by_constant(&map.constants, k, x);
            slopes.iter().zip(&gradient.start).fold(T::zero(), |sum, (slope, weight)| sum + *slope * *weight)
        };
        let parameters = gradient.parameters.len();
        let own: Vec<T> = (0..=parameters).map(by).collect();
        gradient.parameters.iter_mut().zip(&own).for_each(|(sum, more)| *sum += *more);
        gradient.eps += *gamma * own[parameters];
        let column =
            |j: usize| (0..n).fold(T::zero(), |sum, i| sum + jacobian[i * n + j] * gradient.start[i]);
        gradient.start = (0..n).map(column).collect();
    }
}

fn largest<T: Scalar>(numbers: &[T]) -> f64 {
    numbers.iter().fold(0.0, |most: f64, number| most.max(number.approximate().abs()))
}
