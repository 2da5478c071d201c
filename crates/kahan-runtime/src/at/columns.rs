//! Many trajectories as columns, one a variable.
//!
//! In: columns, and ε and parameters, one for all trajectories or one each. Out: the columns some
//! steps later, and how far each trajectory went; or the map of each. A trajectory has the same
//! bits whatever stands beside it.

use core::slice;

use kahan_algebra::arithmetic::Float64;
use kahan_core::Scalar;
use smallvec::SmallVec;

use super::{MachineFloat, MapAt};
use crate::dimension::Argument;
use crate::engine::Columns;
use crate::follow::{advance_while_finite, is_finite};
use crate::{DimensionError, Ended, Followed};

impl<T: MachineFloat> MapAt<T> {
    /// Advances many trajectories: column c holds variable c of all of them, in one order.
    ///
    /// `eps` holds ε for each trajectory, or one for all, or nothing, which means that of the map.
    /// `parameters` has a list a parameter, each of a value for each trajectory or one for all; an
    /// empty one means those of the map. A trajectory has the same bits whatever stands beside it,
    /// and those of an ensemble at its ε and parameters.
    ///
    /// What is not a number stays so, and a trajectory at whose parameters the field divides by
    /// zero is not a number either. The rest never notices.
    ///
    /// # Errors
    /// [`DimensionError`] for what has another length.
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
        let (own, own_eps) = self.own();
        let eps = if eps.is_empty() { &[own_eps] } else { eps };
        let own: SmallVec<[&[T]; 8]> = own.iter().map(slice::from_ref).collect();
        let are_own = parameters.is_empty();
        let mut columns = Columns { columns, eps, parameters: if are_own { &own } else { parameters } };
        let code = (self.instructions, &*self.columns);
        self.engine().advance_columns(&mut columns, self.composition, steps, code);
        if !are_own && self.map.field().has_divisors() {
            self.forget_undefined(&mut columns);
        }
        Ok(())
    }

    /// Where the field divides by zero at a trajectory's parameters there is no map; its code,
    /// which has no such divisor any more, does not notice.
    fn forget_undefined(&self, Columns { columns, parameters, .. }: &mut Columns<'_, '_, T>) {
        let trajectories = columns.first().map_or(0, |column| column.len());
        for k in 0..trajectories {
            let values = parameters.iter().flat_map(|values| own(values, k));
            let values: Vec<f64> = values.map(Scalar::approximate).collect();
            if !self.map.field().derived().is_defined_at(&Float64, &values) {
                columns.iter_mut().for_each(|column| column[k] = T::zero() / T::zero());
            }
        }
    }

    /// Advances many trajectories as [`advance_columns`](Self::advance_columns) does, and tells how
    /// far each went: one that leaves the range of the scalar stands at its last finite point.
    ///
    /// Bits are those of [`advance_columns`](Self::advance_columns), whose last digits may differ
    /// from those of single orbits.
    ///
    /// Cost: a copy of the columns; and for each trajectory that leaves the range its steps again,
    /// up to twice.
    ///
    /// # Errors
    /// [`DimensionError`] for what has another length.
    pub fn follow_columns(
        &self,
        columns: &mut [&mut [T]],
        eps: &[T],
        parameters: &[&[T]],
        steps: u64,
    ) -> Result<Vec<Followed<()>>, DimensionError> {
        let starts: Vec<Vec<T>> = columns.iter().map(|column| column.to_vec()).collect();
        self.advance_columns(columns, eps, parameters, steps)?;
        let trajectories = columns.first().map_or(0, |column| column.len());
        let follow = |k: usize| {
            if columns.iter().all(|column| is_finite(&column[k..=k])) {
                return Followed { report: (), steps, ended: Ended::Complete };
            }
            let eps = own(eps, k);
            let parameters: SmallVec<[&[T]; 8]> = parameters.iter().map(|values| own(values, k)).collect();
            let mut x: Vec<T> = starts.iter().map(|column| column[k]).collect();
            let steps = advance_while_finite(&mut x, steps, |x, steps| {
                let mut columns: SmallVec<[&mut [T]; 8]> = x.iter_mut().map(slice::from_mut).collect();
                self.advance_columns(&mut columns, eps, &parameters, steps).expect("they have fitted");
            });
            columns.iter_mut().zip(x).for_each(|(column, x)| column[k] = x);
            Followed { report: (), steps, ended: Ended::Range }
        };
        Ok((0..trajectories).map(follow).collect())
    }

    /// The maps of many trajectories, each at its own ε and parameters, which are given as
    /// [`advance_columns`](Self::advance_columns) takes them; one map where nothing is given for
    /// each. They are what [`observe_columns`](Self::observe_columns) takes.
    ///
    /// A map at whose parameters the field has no value takes every point to what is not a number.
    ///
    /// Cost: some microseconds a map.
    ///
    /// # Errors
    /// [`DimensionError`] for what has another length.
    ///
    /// ```
    /// use kahan_core::observe::Fli;
    /// use kahan_runtime::{Field, MapAt, WhileFinite};
    ///
    /// let field = Field::parse("xdot = y; ydot = a*x^2 - x;").unwrap();
    /// let maps = field.with([("a", 1)]).unwrap().at(0.05).each(&[0.05, 0.1], &[&[1.0, 0.5]]).unwrap();
    /// let maps: Vec<&MapAt<f64>> = maps.iter().collect();
    /// let (mut x, mut y) = ([0.2, 0.4], [0.0, 0.0]);
    /// let observers = |orbit: usize| WhileFinite::new(Fli::new(maps[orbit]));
    /// let found = MapAt::observe_columns(&maps, &mut [&mut x, &mut y], 100, observers).unwrap();
    /// assert!(found.iter().all(|followed| followed.steps == 100 && followed.report < 10.0));
    /// ```
    pub fn each(&self, eps: &[T], parameters: &[&[T]]) -> Result<Vec<Self>, DimensionError> {
        let lengths = parameters.iter().map(|values| values.len()).chain([eps.len().max(1)]);
        let maps = lengths.into_iter().find(|length| *length != 1).unwrap_or(1);
        self.check_constants(eps, parameters, maps)?;
        let (own_parameters, own_eps) = self.own();
        let field = self.map.field();
        let map = |k: usize| {
            let eps = own(eps, k).first().copied().unwrap_or(own_eps);
            if parameters.is_empty() {
                return self.at_constants(self.map.clone(), own_parameters.iter().copied(), eps);
            }
            let values = parameters.iter().flat_map(|values| own(values, k)).copied();
            let named = field.parameters().iter().zip(values.clone().map(|value| value.approximate()));
            match field.with(named) {
                Ok(map) => self.at_constants(map, values, eps),
                Err(_) => {
                    let nothing = T::zero() / T::zero();
                    self.at_constants(self.map.clone(), own_parameters.iter().copied(), nothing)
                }
            }
        };
        Ok((0..maps).map(map).collect())
    }

    /// That there are columns of one length for this map.
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

    /// That ε and parameters are those of the map, or one for all trajectories, or one each.
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

/// Of what is given once for all trajectories, or once each, or not at all, what a trajectory has.
fn own<T>(values: &[T], trajectory: usize) -> &[T] {
    if values.len() > 1 { &values[trajectory..=trajectory] } else { values }
}
