//! A map at one ε, over slices.

mod drift;
mod group;
mod objects;
mod observe;
mod tangent;

pub use drift::IntegralDrift;

use core::slice;
use std::sync::{Arc, OnceLock};

use kahan_algebra::arithmetic::Float64;
use kahan_core::{Composition, Increments, Level, Room, Step, Stopped};
use smallvec::SmallVec;

use crate::dimension::Argument;
use crate::engine::{
    CodedStages, Columns, ColumnsOnce, Engine, Instructions, Scratches, Stage, split, stage_constants,
};
use crate::machine::StepKind;
use crate::{DimensionError, Map};

/// A float of the machine: `f64` or `f32`.
pub trait MachineFloat: Scratches {}

/// A point; in up to eight variables it is no allocation.
pub type RuntimePoint<T> = SmallVec<[T; 8]>;

impl MachineFloat for f32 {}
impl MachineFloat for f64 {}

/// Kahan's map at one ε, half the time step; made by [`Map::at`].
///
/// States are slices, an entry a variable. Bits are those of the code that `kahan!` writes, for
/// single steps and for columns (where those are ensembles at [`Level::Baseline`]), unless
/// [another level](Self::at_level) is asked for. It runs as machine code where that can be had, and
/// else interpreted, by the same calls and with the same bits. Nothing panics, whatever the numbers
/// are: a pole shows as numbers that are not finite. After the first call on a thread no step
/// allocates. A map can be used from any number of threads at once, none of which waits for
/// another.
#[derive(Clone, Debug)]
pub struct MapAt<T> {
    map: Map,
    /// The parameters, and ε behind them.
    constants: Arc<[T]>,
    composition: Composition,
    instructions: Instructions,
    /// Those that differ.
    stages: Arc<[Stage<T>]>,
    /// The same as machine code, where there is some.
    coded: Option<CodedStages<T>>,
    columns: Arc<ColumnsOnce<T>>,
    /// The map of the variational field, which carries tangent vectors, once one is carried.
    variational: Arc<OnceLock<MapAt<T>>>,
}

impl<T: MachineFloat> MapAt<T> {
    /// The map with the parameters, and ε behind them.
    pub(crate) fn new(map: Map, constants: Arc<[T]>) -> Self {
        let composition = Composition::KAHAN;
        let instructions = Instructions::OF_THE_BUILD;
        MapAt {
            map,
            constants,
            composition,
            instructions,
            stages: Arc::default(),
            coded: None,
            columns: Arc::default(),
            variational: Arc::default(),
        }
        .composed(composition)
    }

    /// The same map with each step replaced by a composition of steps, which has a higher order; a
    /// step still takes the time 2ε. [`Composition`] says what survives and what does not.
    ///
    /// It changes [`step`](Self::step) and what advances. Everything else, the Jacobian too, is of
    /// the map itself at ε.
    #[must_use]
    pub fn composed(&self, composition: Composition) -> Self {
        let (engine, constants) = (self.engine(), &self.constants);
        let stages = engine.stages(constants, composition).into();
        let kind = StepKind::of::<T>(self.instructions.fuses);
        let coded = engine.coded_stages(kind, &stage_constants(constants, composition), |number| [number]);
        MapAt { composition, stages, coded, variational: Arc::default(), ..self.clone() }
    }

    /// The same map with the bits of a level of ensembles, whose larger ones fuse multiply-adds,
    /// and its columns on the instructions of that level; `None` if this processor lacks them, or
    /// there is no machine code for the step.
    ///
    /// [`Level::Baseline`] is what a map is without being asked: the bits of this build, computed
    /// in registers as wide as there are.
    #[must_use]
    pub fn at_level(&self, level: Level) -> Option<Self> {
        let instructions = Instructions::at_level(level);
        let at = MapAt { instructions, columns: Arc::default(), ..self.clone() }.composed(self.composition);
        (level == Level::Baseline || level.is_available() && at.coded.is_some()).then_some(at)
    }

    /// Whether its steps are machine code, and not interpreted.
    #[must_use]
    pub fn is_code(&self) -> bool {
        self.coded.is_some()
    }

    /// The map.
    #[must_use]
    pub fn map(&self) -> &Map {
        &self.map
    }

    /// ε, half the time step.
    #[must_use]
    pub fn eps(&self) -> T {
        self.own().1
    }

    /// The parameters, and ε.
    fn own(&self) -> (&[T], T) {
        split(&self.constants)
    }

    /// x̃, the state one time step of 2ε later.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` or `next` has not an entry a variable.
    pub fn step(&self, x: &[T], next: &mut [T]) -> Result<(), DimensionError> {
        self.check_out(next, self.dimension())?;
        self.check_state(x)?;
        match &self.coded {
            Some(stages) => stages.step(x, next),
            None => {
                next.copy_from_slice(x);
                self.engine().advance(&self.stages, [next, &mut []], 1);
            }
        }
        Ok(())
    }

    /// Replaces `x` by the state so many steps later.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` has not an entry a variable.
    pub fn advance(&self, x: &mut [T], steps: u64) -> Result<(), DimensionError> {
        self.check_state(x)?;
        self.advance_checked(x, steps);
        Ok(())
    }

    fn advance_checked(&self, x: &mut [T], steps: u64) {
        match &self.coded {
            Some(stages) => stages.advance(x, steps),
            None => self.engine().advance(&self.stages, [x, &mut []], steps),
        }
    }

    /// The same with the rounding error of each addition carried into the next one: the orbit is at
    /// `x` + `carry`. Begin with zeros, and hand the same carry over again to go on.
    ///
    /// See [`Orbit::compensated`](kahan_core::Orbit::compensated) for what that cures.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` or `carry` has not an entry a variable.
    pub fn advance_with_carry(&self, x: &mut [T], carry: &mut [T], steps: u64) -> Result<(), DimensionError> {
        self.check_state(x)?;
        DimensionError::check(Argument::Carry, carry.len(), self.dimension())?;
        let engine = self.engine();
        let by_code = |stages| engine.has_advanced_with_carry(stages, x, carry, steps);
        if !self.coded.as_ref().is_some_and(by_code) {
            engine.advance(&self.stages, [x, carry], steps);
        }
        Ok(())
    }

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
        let trajectories = columns.first().map_or(0, |column| column.len());
        self.check_columns(columns, eps, parameters, trajectories)?;
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
            let of_trajectory = |values: &&[T]| if values.len() == 1 { values[0] } else { values[k] };
            let values: Vec<f64> =
                parameters.iter().map(|values| of_trajectory(values).approximate()).collect();
            if !self.map.field().derived().is_defined_at(&Float64, &values) {
                columns.iter_mut().for_each(|column| column[k] = T::zero() / T::zero());
            }
        }
    }

    fn check_columns(
        &self,
        columns: &[&mut [T]],
        eps: &[T],
        parameters: &[&[T]],
        trajectories: usize,
    ) -> Result<(), DimensionError> {
        let symbols = &self.map.field().system().field.symbols;
        DimensionError::check(Argument::Columns, columns.len(), self.dimension())?;
        let refused = |argument, found| Err(DimensionError::new(argument, found, trajectories));
        for (column, variable) in columns.iter().zip(&symbols.states) {
            if column.len() != trajectories {
                return refused(Argument::Column(variable.clone()), column.len());
            }
        }
        if eps.len() > 1 && eps.len() != trajectories {
            return refused(Argument::Eps, eps.len());
        }
        if !parameters.is_empty() {
            DimensionError::check(Argument::Parameters, parameters.len(), symbols.parameters.len())?;
        }
        for (values, name) in parameters.iter().zip(&symbols.parameters) {
            if values.len() != 1 && values.len() != trajectories {
                return refused(Argument::Parameter(name.clone()), values.len());
            }
        }
        Ok(())
    }

    fn engine(&self) -> &Engine {
        &self.map.field().engine
    }

    fn dimension(&self) -> usize {
        self.engine().dimension()
    }

    fn check_state(&self, x: &[T]) -> Result<(), DimensionError> {
        DimensionError::check(Argument::State, x.len(), self.dimension())
    }

    fn check_out(&self, out: &[T], expected: usize) -> Result<(), DimensionError> {
        DimensionError::check(Argument::Out, out.len(), expected)
    }
}

/// Bits are those of [`advance`](MapAt::advance). A state of another length panics here, as
/// dimensions of nalgebra do.
impl<T: MachineFloat> Step for MapAt<T> {
    type Scalar = T;
    type State = Vec<T>;

    fn dimension(&self) -> usize {
        MapAt::dimension(self)
    }

    fn eps(&self) -> &T {
        self.constants.last().unwrap_or_else(|| unreachable!("eps is one of them"))
    }

    #[track_caller]
    fn advance(&self, x: &mut [T], steps: u64, _room: &mut Room) -> Result<(), Stopped> {
        fitting(MapAt::advance(self, x, steps));
        Ok(())
    }

    #[track_caller]
    fn part(&self, eps: &T, x: &mut [T], room: &mut Room) -> Result<(), Stopped> {
        let constants = self.own().0.iter().copied().chain([*eps]).collect();
        let columns = Arc::default();
        Step::advance(&MapAt { constants, columns, ..self.clone() }.composed(self.composition), x, 1, room)
    }
}

/// Bits are those of [`advance_with_carry`](MapAt::advance_with_carry).
impl<T: MachineFloat> Increments for MapAt<T> {
    type Carried = Vec<T>;

    #[track_caller]
    fn next_with_carry(&self, x: &Vec<T>, room: &mut Room) -> Option<Vec<T>> {
        let mut next = x.clone();
        Increments::advance_with_carry(self, &mut next, 1, room).ok()?;
        Some(next)
    }

    #[track_caller]
    fn advance_with_carry(&self, x: &mut [T], steps: u64, _room: &mut Room) -> Result<(), Stopped> {
        let (point, carry) = x.split_at_mut(x.len().min(self.dimension()));
        fitting(MapAt::advance_with_carry(self, point, carry, steps));
        Ok(())
    }
}

/// What a call without errors of its own makes of a state of another length.
#[track_caller]
pub(crate) fn fitting(checked: Result<(), DimensionError>) {
    if let Err(error) = checked {
        panic!("{error}")
    }
}
