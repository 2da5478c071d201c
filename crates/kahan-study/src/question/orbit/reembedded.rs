//! Orbits of lifted fields whose steps are projected symmetrically onto the relations.

use kahan_algebra::arithmetic::Float64;
use kahan_algebra::rational::Rational;
use kahan_lift::Reembedding;

use crate::count::Count;
use crate::numbers::{Number, Printable};
use crate::study::Study;

use super::maps::Floats;
use super::points::{Halt, Points, Why, one_by_one};

/// An orbit in doubles on the relations of a lift.
pub(super) struct Reembedded<'a> {
    study: &'a Study,
    floats: Floats<f64>,
    /// The values of the lift's parameters.
    parameters: Vec<f64>,
    reembedding: Reembedding,
}

impl<'a> Reembedded<'a> {
    /// The orbit at its first point; `None` of a field that was not lifted.
    pub(super) fn new(study: &'a Study, floats: Floats<f64>) -> Option<Self> {
        let (lift, values) = (study.lift()?, study.values().ok()?);
        let value = |name: &String| {
            let place = study.parameters().iter().position(|known| known == name);
            place.map_or(f64::NAN, |place| Rational::to_f64(&values[place]))
        };
        let parameters = lift.parameters.iter().map(value).collect();
        Some(Reembedded { study, floats, parameters, reembedding: Reembedding::default() })
    }

    fn step(&mut self) -> Result<(), Why> {
        let Reembedded { study, floats: Floats { at, x, .. }, parameters, reembedding } = self;
        let lift = study.lift().expect("the field was lifted");
        let (states, new) = x.split_at_mut(lift.states.len());
        let embed = |states: &[f64]| lift.embed(states, parameters);
        let step = |point: &mut [f64]| at.advance(point, 1).expect("the point is of the field");
        if !reembedding.step(states, embed, step) {
            return Err(Why::NotReembedded);
        }
        new.copy_from_slice(&lift.embed(states, parameters));
        Ok(())
    }
}

impl Points<Float64> for Reembedded<'_> {
    fn row(&mut self, cells: &mut Vec<f64>) {
        self.floats.append::<Float64>(&self.floats.x, cells);
    }

    fn advance(&mut self, steps: u64, progress: &Count<'_>) -> Result<(), Halt> {
        one_by_one(steps, progress, || self.step())
    }

    fn point(&self) -> Vec<Number> {
        self.floats.x.iter().map(Float64::number).collect()
    }
}
