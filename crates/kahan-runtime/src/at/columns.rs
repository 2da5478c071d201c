//! Many trajectories in columns, one column for each variable.
//!
//! In: columns, and ε and parameters with one value for all trajectories or one for each. Out: the
//! columns after some steps, and on request how each trajectory ended.

use core::ops::ControlFlow;
use core::slice;

use kahan_algebra::arithmetic::Float64;
use kahan_core::Scalar;
use smallvec::SmallVec;

use super::{MachineFloat, MapAt};
use crate::dimension::Argument;
use crate::engine::{Columns, values_of, with_scratch};
use crate::follow::is_finite;
use crate::machine_code::StepKind;
use crate::{DimensionError, End, Follow, Followed};

impl<T: MachineFloat> MapAt<T> {
    /// Advances many trajectories; column c holds variable c of all trajectories.
    ///
    /// `eps` holds one ε for each trajectory, or one for all; an empty `eps` stands for the map's
    /// own ε. `parameters` holds one list of the same form for each parameter, or is empty. Each
    /// trajectory equals that of an ensemble at its ε and parameters.
    ///
    /// A trajectory becomes NaN if the field divides by zero at its parameters.
    ///
    /// # Errors
    /// [`DimensionError`] for columns, `eps` or `parameters` of a wrong length.
    ///
    /// ```
    /// use kahan_runtime::Field;
    ///
    /// let map = Field::parse("xdot = r*x*(1 - y); ydot = r*y*(x - 1);").unwrap().with([("r", 1)]).unwrap();
    /// let (mut x, mut y) = ([1.5, 1.5, 0.7], [1.0, 1.0, 0.7]);
    /// let rates = [1.0, 0.5, 1.0];
    /// map.at(0.05).advance_columns(&mut [&mut x, &mut y], &[], &[&rates], 100).unwrap();
    ///
    /// let mut alone = [1.5_f64, 1.0];
    /// map.at(0.05).advance(&mut alone, 100).unwrap();
    /// assert!((x[0] - alone[0]).abs() < 1e-12 && x[1] != x[0]);
    /// ```
    pub fn advance_columns(
        &self,
        columns: &mut [&mut [T]],
        eps: &[T],
        parameters: &[&[T]],
        steps: u64,
    ) -> Result<(), DimensionError> {
        let trajectories = self.check_columns(columns)?;
        self.check_constants(eps, parameters, trajectories)?;
        self.advance_in(StepKind { is_general: true, ..self.kind }, columns, eps, parameters, steps);
        Ok(())
    }

    fn advance_in(
        &self,
        kind: StepKind,
        columns: &mut [&mut [T]],
        eps: &[T],
        parameters: &[&[T]],
        steps: u64,
    ) {
        let (own, own_eps) = self.parameters_and_eps();
        let eps = if eps.is_empty() { &[own_eps] } else { eps };
        let own: SmallVec<[&[T]; 8]> = own.iter().map(slice::from_ref).collect();
        let are_own = parameters.is_empty();
        let mut columns = Columns { columns, eps, parameters: if are_own { &own } else { parameters } };
        if !self.engine().has_advanced_columns(&mut columns, self.composition, steps, kind, self.set) {
            match self.coded.as_ref().filter(|stages| stages.has_loops()) {
                Some(stages) if are_own && columns.eps == [own_eps] => {
                    let alone = |x: &mut [T], steps| self.advance_checked([x, &mut []], steps);
                    stages.advance_columns(columns.columns, steps, alone);
                }
                Some(_) => self.advance_one_by_one(&mut columns, steps),
                None => self.engine().interpret_columns(&mut columns, self.composition, steps, kind),
            }
        }
        let field = &self.map.field().system().field;
        if (!are_own || field.depends_on_eps()) && self.map.field().has_divisors() {
            self.forget_undefined(&mut columns);
        }
    }

    fn advance_one_by_one(&self, all: &mut Columns<'_, '_, T>, steps: u64) {
        let Columns { columns, eps, parameters } = all;
        let mut x = with_scratch(T::single(), |scratch| std::mem::take(&mut scratch.given));
        for k in 0..columns.first().map_or(0, |column| column.len()) {
            x.clear();
            x.extend(columns.iter().map(|column| column[k]));
            let alone = k..k + 1;
            let values = parameters.iter().map(|values| values_of(values, &alone)[0]);
            let map = self.at_constants(self.map.clone(), values, values_of(eps, &alone)[0]);
            map.advance_checked([&mut x, &mut []], steps);
            columns.iter_mut().zip(&x).for_each(|(column, x)| column[k] = *x);
        }
        with_scratch(T::single(), |scratch| scratch.given = x);
    }

    /// Sets a trajectory to NaN if the field divides by zero at its parameters.
    fn forget_undefined(&self, Columns { columns, eps, parameters }: &mut Columns<'_, '_, T>) {
        let trajectories = columns.first().map_or(0, |column| column.len());
        for k in 0..trajectories {
            let values = parameters.iter().flat_map(|values| values_of(values, &(k..k + 1)));
            let values: Vec<f64> = values.map(Scalar::approximate).collect();
            let eps = values_of(eps, &(k..k + 1))[0].approximate();
            if !self.map.field().derived().is_defined_at(&Float64, &values, &eps) {
                columns.iter_mut().for_each(|column| column[k] = undefined());
            }
        }
    }

    /// Advances many trajectories as [`advance_columns`](Self::advance_columns) does, and returns
    /// how each ended. A trajectory that ended early becomes NaN in the columns.
    ///
    /// Points and ends equal those of single orbits, bit for bit. Cost: the steps, and up to two
    /// thousand further steps for each trajectory that leaves the range of floats.
    ///
    /// # Errors
    /// [`DimensionError`] for columns, `eps` or `parameters` of a wrong length.
    ///
    /// ```
    /// use kahan_runtime::{End, Field};
    ///
    /// let map = Field::parse("xdot = x^2;").unwrap().map().unwrap().at(0.05);
    /// let mut x = [1.0, -1.0_f64];
    /// let ends = map.follow_columns(&mut [&mut x], &[], &[], 11).unwrap();
    /// assert_eq!(ends, [End::Range(9), End::Complete]);
    /// assert!(x[0].is_nan() && x[1] < 0.0);
    /// ```
    pub fn follow_columns(
        &self,
        columns: &mut [&mut [T]],
        eps: &[T],
        parameters: &[&[T]],
        steps: u64,
    ) -> Result<Vec<End>, DimensionError> {
        const TOGETHER: usize = 1024;

        let trajectories = self.check_columns(columns)?;
        self.check_constants(eps, parameters, trajectories)?;
        let own_eps = [self.parameters_and_eps().1];
        let of_kind = if eps.is_empty() { &own_eps } else { eps };
        let Some(kind) = self.engine().kind_of_orbits(self.kind, of_kind, self.composition) else {
            return self.follow_one_by_one(columns, eps, parameters, steps);
        };
        let mut ends = vec![End::Complete; trajectories];
        let mut before = vec![Vec::new(); columns.len()];
        for first in (0..trajectories).step_by(TOGETHER) {
            let piece = first..trajectories.min(first + TOGETHER);
            let mut columns: Vec<&mut [T]> =
                columns.iter_mut().map(|column| &mut column[piece.clone()]).collect();
            let parameters: Vec<&[T]> = parameters.iter().map(|values| values_of(values, &piece)).collect();
            let constants = (values_of(eps, &piece), &parameters[..]);
            self.follow_piece(kind, &mut columns, constants, steps, &mut before, &mut ends[piece]);
        }
        Ok(ends)
    }

    fn follow_piece(
        &self,
        kind: StepKind,
        columns: &mut [&mut [T]],
        (eps, parameters): (&[T], &[&[T]]),
        steps: u64,
        before: &mut [Vec<T>],
        ends: &mut [End],
    ) {
        const LOOK: u64 = 1024;

        let mut made = 0;
        loop {
            let now = LOOK.min(steps - made);
            for (before, column) in before.iter_mut().zip(&*columns) {
                before.clear();
                before.extend_from_slice(column);
            }
            if now > 0 {
                self.advance_in(kind, columns, eps, parameters, now);
            }
            let lost = lost_trajectories(columns, ends);
            if !lost.is_empty() {
                let of = |values: &[T]| -> Vec<T> {
                    if values.len() > 1 { lost.iter().map(|&k| values[k]).collect() } else { values.to_vec() }
                };
                let own: Vec<Vec<T>> = parameters.iter().map(|values| of(values)).collect();
                let own: Vec<&[T]> = own.iter().map(Vec::as_slice).collect();
                let starts = before.iter().map(|column| lost.iter().map(|&k| column[k]).collect()).collect();
                let finite = self.finite_steps(kind, starts, &of(eps), &own, now);
                for (&k, steps) in lost.iter().zip(finite) {
                    ends[k] = End::Range(made + steps);
                    columns.iter_mut().for_each(|column| column[k] = undefined());
                }
            }
            made += now;
            if made == steps {
                return;
            }
        }
    }

    /// Returns, for each start, the number of steps to the last finite point. All points after
    /// `steps` steps must be nonfinite.
    fn finite_steps(
        &self,
        kind: StepKind,
        mut starts: Vec<Vec<T>>,
        eps: &[T],
        parameters: &[&[T]],
        steps: u64,
    ) -> Vec<u64> {
        let mut taken = vec![0; starts.first().map_or(0, Vec::len)];
        // A binary search finds the last finite point, because nonfinite points stay nonfinite.
        for power in (0..=steps.checked_ilog2().unwrap_or(0)).rev() {
            let mut ahead = starts.clone();
            let mut columns: Vec<&mut [T]> = ahead.iter_mut().map(Vec::as_mut_slice).collect();
            self.advance_in(kind, &mut columns, eps, parameters, 1 << power);
            for (k, taken) in taken.iter_mut().enumerate() {
                if ahead.iter().all(|column| is_finite(&column[k..=k])) {
                    *taken += 1 << power;
                    starts.iter_mut().zip(&ahead).for_each(|(own, ahead)| own[k] = ahead[k]);
                }
            }
        }
        taken
    }

    /// Follows trajectories one at a time, because some ε in `eps` is so near 0 that its steps need
    /// a formula without division by ε.
    fn follow_one_by_one(
        &self,
        columns: &mut [&mut [T]],
        eps: &[T],
        parameters: &[&[T]],
        steps: u64,
    ) -> Result<Vec<End>, DimensionError> {
        let maps = self.each(eps, parameters)?;
        let trajectories = columns.first().map_or(0, |column| column.len());
        let follow = |k: usize| {
            let map = &maps[k.min(maps.len() - 1)];
            let mut x: Vec<T> = columns.iter().map(|column| column[k]).collect();
            let Followed { end, .. } = map.follow(&mut x, steps, |_| ControlFlow::Continue(()))?;
            x.iter_mut().filter(|_| end != End::Complete).for_each(|x| *x = undefined());
            columns.iter_mut().zip(x).for_each(|(column, x)| column[k] = x);
            Ok(end)
        };
        (0..trajectories).map(follow).collect()
    }

    /// Returns the maps of many trajectories, each at its own ε and parameters. If all values are
    /// shared, returns one map. [`observe_columns`](Self::observe_columns) takes these maps as
    /// input. Arguments are those of [`advance_columns`](Self::advance_columns).
    ///
    /// If the field divides by zero at the parameters of a map, this map takes every point to NaN.
    ///
    /// # Errors
    /// [`DimensionError`] for `eps` or `parameters` of a wrong length.
    ///
    /// ```
    /// use kahan_core::observe::Fli;
    /// use kahan_runtime::{End, Field, MapAt, WhileFinite};
    ///
    /// let field = Field::parse("xdot = y; ydot = a*x^2 - x;").unwrap();
    /// let maps = field.with([("a", 1)]).unwrap().at(0.05).each(&[0.05, 0.1], &[&[1.0, 0.5]]).unwrap();
    /// let maps: Vec<&MapAt<f64>> = maps.iter().collect();
    /// let (mut x, mut y) = ([0.2, 0.4], [0.0, 0.0]);
    /// let observers = |orbit: usize| WhileFinite::new(Fli::new(maps[orbit]));
    /// let found = MapAt::observe_columns(&maps, &mut [&mut x, &mut y], 100, observers).unwrap();
    /// assert!(found.iter().all(|followed| followed.end == End::Complete && followed.report < 10.0));
    /// ```
    pub fn each(&self, eps: &[T], parameters: &[&[T]]) -> Result<Vec<Self>, DimensionError> {
        let lengths = parameters.iter().map(|values| values.len()).chain([eps.len().max(1)]);
        let maps = lengths.into_iter().find(|length| *length != 1).unwrap_or(1);
        self.check_constants(eps, parameters, maps)?;
        let (own_parameters, own_eps) = self.parameters_and_eps();
        let field = self.map.field();
        let map = |k: usize| {
            let eps = values_of(eps, &(k..k + 1)).first().copied().unwrap_or(own_eps);
            if parameters.is_empty() {
                return self.at_constants(self.map.clone(), own_parameters.iter().copied(), eps);
            }
            let values = parameters.iter().flat_map(|values| values_of(values, &(k..k + 1))).copied();
            let named = field.parameters().iter().zip(values.clone().map(|value| value.approximate()));
            match field.with(named) {
                Ok(map) => self.at_constants(map, values, eps),
                Err(_) => self.at_constants(self.map.clone(), own_parameters.iter().copied(), undefined()),
            }
        };
        Ok((0..maps).map(map).collect())
    }

    /// Checks the number and lengths of columns, and returns the number of trajectories.
    pub(super) fn check_columns(&self, columns: &[&mut [T]]) -> Result<usize, DimensionError> {
        DimensionError::check(Argument::Columns, columns.len(), self.dimension())?;
        let trajectories = columns.first().map_or(0, |column| column.len());
        let mut named = columns.iter().zip(self.map.field().variables());
        match named.find(|(column, _)| column.len() != trajectories) {
            Some((column, variable)) => {
                Err(DimensionError::new(Argument::Column(variable.clone()), column.len(), trajectories))
            }
            None => Ok(trajectories),
        }
    }

    fn check_constants(
        &self,
        eps: &[T],
        parameters: &[&[T]],
        trajectories: usize,
    ) -> Result<(), DimensionError> {
        let names = self.map.field().parameters();
        if eps.len() > 1 {
            DimensionError::check(Argument::Eps, eps.len(), trajectories)?;
        }
        if !parameters.is_empty() {
            DimensionError::check(Argument::Parameters, parameters.len(), names.len())?;
        }
        let mut named = parameters.iter().zip(names);
        match named.find(|(values, _)| values.len() != 1 && values.len() != trajectories) {
            Some((values, name)) => {
                Err(DimensionError::new(Argument::Parameter(name.clone()), values.len(), trajectories))
            }
            None => Ok(()),
        }
    }
}

fn undefined<T: MachineFloat>() -> T {
    T::zero() / T::zero()
}

fn lost_trajectories<T: MachineFloat>(columns: &[&mut [T]], ends: &[End]) -> Vec<usize> {
    if columns.iter().all(|column| is_finite(column)) {
        return Vec::new();
    }
    let is_lost = |k: usize| !columns.iter().all(|column| is_finite(&column[k..=k]));
    (0..ends.len()).filter(|&k| ends[k] == End::Complete && is_lost(k)).collect()
}
