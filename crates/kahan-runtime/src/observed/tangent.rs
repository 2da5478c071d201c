//! Propagates tangent vectors along an orbit, for a lifted field in its original variables only.
//!
//! Lifting adds variables w = g(x). A tangent vector e of x then corresponds to (e, Dg·e), where Dg
//! is the Jacobian of g. The space of these vectors, called the plane, is propagated from point to
//! point.
//!
//! # Resets
//!
//! If the map preserves w = g(x), the propagated plane stays near the plane of the vectors (e,
//! Dg·e). Replacing it by that plane at every step would change Lyapunov exponents by a term of
//! order ε. Therefore the plane is reset only at the start, if its error exceeds
//! [`LARGEST_DERIVATIVE_ERROR`], or if its vectors become dependent in x.

use core::fmt;
use std::cell::RefCell;
use std::rc::Rc;

use kahan_core::observe::{GROUP, Grouped, SideBySide, TangentMap};
use kahan_core::{EmbedScalar, Scalar, Step, Stopped, Workspace};

use crate::engine::determinant;
use crate::{MachineFloat, MapAt};

/// The relations w = g(x) of a lifted field, between original variables x and added variables w.
pub trait Relations: fmt::Debug + Sync {
    /// Returns the number of original variables x, which come first.
    fn originals(&self) -> usize;

    /// Returns the matrix ∂g/∂x (row-major) at a point of all variables and these parameters.
    fn slopes(&self, x: &[f64], parameters: &[f64]) -> Vec<f64>;
}

/// If the propagated gradient of an added variable has a larger relative error, the plane is reset.
const LARGEST_DERIVATIVE_ERROR: f64 = 1.0 / 64.0;

#[derive(Clone, Debug)]
pub(super) struct TangentCarrier<'a, T: MachineFloat> {
    map: &'a MapAt<T>,
    /// The propagated plane of a lifted field; `None` if tangent vectors have an entry for every
    /// variable.
    pub(super) plane: Option<Rc<RefCell<CarriedPlane<'a, T>>>>,
}

#[derive(Clone, Debug)]
pub(super) struct CarriedPlane<'a, T: MachineFloat> {
    map: &'a MapAt<T>,
    relations: &'a dyn Relations,
    parameters: Vec<f64>,
    place: Vec<T>,
    /// Basis vectors of the plane. In the original variables, row i is the i-th unit vector.
    basis: Vec<Vec<T>>,
    /// The images of the rows of `basis` under the last step, restricted to the original variables.
    images: Vec<Vec<T>>,
    /// For each added variable, the largest squared norm of its gradient so far.
    largest: Vec<f64>,
}

impl<'a, T: MachineFloat + EmbedScalar> TangentCarrier<'a, T> {
    pub(super) fn new(map: &'a MapAt<T>, relations: Option<&'a dyn Relations>) -> Self {
        let plane = |relations| CarriedPlane {
            map,
            relations,
            parameters: map.parameters_and_eps().0.iter().map(T::approximate).collect(),
            place: Vec::new(),
            basis: Vec::new(),
            images: Vec::new(),
            largest: Vec::new(),
        };
        TangentCarrier { map, plane: relations.map(|relations| Rc::new(RefCell::new(plane(relations)))) }
    }

    pub(super) fn follow(&self, step: u64, x: &[T]) {
        if let Some(plane) = &self.plane {
            plane.borrow_mut().follow(step, x);
        }
    }

    pub(super) fn seen<'x>(&self, x: &'x [T]) -> &'x [T] {
        &x[..Step::dimension(self)]
    }
}

impl<T: MachineFloat + EmbedScalar> CarriedPlane<'_, T> {
    fn follow(&mut self, step: u64, x: &[T]) {
        if step == 0 {
            self.begin(x);
        } else {
            for vector in &mut self.basis {
                self.map.push_forward(&self.place, vector);
            }
            let n = self.basis.len();
            self.images = self.basis.iter().map(|vector| vector[..n].to_vec()).collect();
            let is_plane = has_reduced(&mut self.basis);
            self.replace_if_far(x, !is_plane);
        }
        self.place.clear();
        self.place.extend_from_slice(x);
    }

    fn slopes(&self, x: &[T]) -> Vec<f64> {
        let x: Vec<f64> = x.iter().map(T::approximate).collect();
        self.relations.slopes(&x, &self.parameters)
    }

    fn begin(&mut self, x: &[T]) {
        let n = self.relations.originals();
        let axis = |i| (0..x.len()).map(|k| if k == i { T::one() } else { T::zero() }).collect();
        self.basis = (0..n).map(axis).collect();
        self.largest = vec![0.0; x.len() - n];
        self.replace_if_far(x, true);
    }

    /// Resets the propagated plane to the tangent plane of the relations, if its error exceeds
    /// [`LARGEST_DERIVATIVE_ERROR`] or `must`
    /// is set.
    fn replace_if_far(&mut self, x: &[T], must: bool) {
        let (n, slopes) = (self.basis.len(), self.slopes(x));
        let mut is_far = must;
        for ((k, row), largest) in (n..).zip(slopes.chunks_exact(n)).zip(&mut self.largest) {
            let squares = |sum: f64, one: f64| sum + one * one;
            *largest = largest.max(row.iter().copied().fold(0.0, squares));
            let errors = row.iter().zip(&self.basis).map(|(slope, vector)| vector[k].approximate() - slope);
            let error = errors.fold(0.0, squares);
            // If an added variable has only zero derivatives, `largest` is 0, and nothing is reset.
            let is_near = error <= LARGEST_DERIVATIVE_ERROR * LARGEST_DERIVATIVE_ERROR * *largest;
            is_far |= *largest > 0.0 && !is_near;
        }
        if is_far {
            for (k, row) in (n..).zip(slopes.chunks_exact(n)) {
                for (vector, slope) in self.basis.iter_mut().zip(row) {
                    vector[k] = T::narrowed(*slope);
                }
            }
        }
    }
}

/// Brings rows to reduced row echelon form; `false` if the square block on the left is singular.
fn has_reduced<T: Scalar + Copy>(rows: &mut [Vec<T>]) -> bool {
    for k in 0..rows.len() {
        let better =
            |best: usize, i: usize| if rows[i][k].is_better_pivot(&rows[best][k]) { i } else { best };
        let pivot = (k + 1..rows.len()).fold(k, better);
        rows.swap(k, pivot);
        let (above, rest) = rows.split_at_mut(k);
        let Some((row, below)) = rest.split_first_mut() else { break };
        let inverse = row[k].reciprocal().unwrap_or_else(T::zero);
        row.iter_mut().for_each(|entry| *entry *= inverse);
        for other in above.iter_mut().chain(below) {
            let factor = other[k];
            other.iter_mut().zip(&*row).for_each(|(entry, own)| *entry -= factor * *own);
        }
    }
    rows.iter().flatten().all(|entry| entry.approximate().is_finite())
}

impl<T: MachineFloat + EmbedScalar> Step for TangentCarrier<'_, T> {
    type Scalar = T;
    type State = Vec<T>;

    fn dimension(&self) -> usize {
        let originals = self.plane.as_ref().map(|plane| plane.borrow().relations.originals());
        originals.unwrap_or(Step::dimension(self.map))
    }

    fn eps(&self) -> &T {
        Step::eps(self.map)
    }

    fn advance(&self, x: &mut [T], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        Step::advance(self.map, x, steps, workspace)
    }

    fn part(&self, eps: &T, x: &mut [T], workspace: &mut Workspace) -> Result<(), Stopped> {
        self.map.part(eps, x, workspace)
    }
}

impl<T: MachineFloat + EmbedScalar> TangentMap for TangentCarrier<'_, T> {
    /// Propagates a vector. For a lifted field, uses the images of the unit vectors under the last
    /// step.
    fn push_forward(&self, x: &[T], v: &mut Vec<T>) {
        let Some(plane) = &self.plane else { return self.map.push_forward(x, v) };
        let mut sum = vec![T::zero(); v.len()];
        for (image, entry) in plane.borrow().images.iter().zip(&*v) {
            sum.iter_mut().zip(image).for_each(|(sum, one)| *sum += *entry * *one);
        }
        *v = sum;
    }

    fn det_jacobian(&self, x: &[T]) -> T {
        let Some(plane) = &self.plane else { return self.map.det_jacobian(x) };
        let images = &plane.borrow().images;
        determinant(&mut images.concat(), images.len())
    }

    fn push_forward_group<P: Grouped<T>>(maps: [&Self; GROUP], work: SideBySide<'_, T, P>) -> Option<usize> {
        if maps.iter().any(|carrier| carrier.plane.is_some()) {
            return None;
        }
        MapAt::push_forward_group(maps.map(|carrier| carrier.map), work)
    }
}
