//! Recognises mechanical systems x′ = A p, p′ = G(x) with constant A and a potential.
//!
//! Let S be a constant symmetric matrix and V a function with ∇V = −A⁻ᵀ S G. Then ½ pᵀSp + V is an
//! integral. In a lift, a variable W with W′ = −pᵀS G replaces V, and G is affine in the variables.
//! Kahan's map then preserves
//!
//!   ½ pᵀSp + W − ε² GᵀSG/2

use std::collections::BTreeSet;

use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use crate::laurent::{Laurent, Monomial};
use crate::linear::null_space;
use crate::ring::{CoordinateDefinition, Function, Ring};

#[derive(Clone, Debug)]
pub(crate) struct Mechanical {
    /// The indices of the momenta among the states.
    pub momenta: Vec<usize>,
    /// The symmetric matrix S of the kinetic energy ½ pᵀSp.
    pub kinetic: Vec<Vec<RationalFunction>>,
    /// The potential V if an antiderivative was found.
    pub potential: Option<Laurent>,
}

const MOST_CANDIDATES: usize = 120;

impl Mechanical {
    /// Recognises a mechanical system. Exact partial derivatives prove that the forces have a
    /// potential.
    pub(crate) fn recognise(ring: &Ring) -> Option<Self> {
        let [positions, momenta] = positions_and_momenta(ring)?;
        // The partial derivative ∂/∂xᵢ is the derivative along the constant field eᵢ.
        let partials: Vec<Ring> = positions.iter().map(|&position| along(ring, position)).collect();
        let velocity = |position: usize, momentum: usize| {
            ring.field[position].coefficient(&Monomial::power(momentum, 1))
        };
        let moves: Matrix = positions
            .iter()
            .map(|&position| momenta.iter().map(|&momentum| velocity(position, momentum)).collect())
            .collect();
        let inverse = inverse_transpose(&moves)?;
        let kinetic = kinetic_energy(ring, &partials, &momenta, &moves, &inverse)?;
        let slope = |row: &Vec<RationalFunction>| {
            let mut slope = Laurent::zero();
            for (factor, kinetic) in row.iter().zip(&kinetic) {
                for (entry, &momentum) in kinetic.iter().zip(&momenta) {
                    slope.add_scaled(&ring.field[momentum], &-&(factor * entry));
                }
            }
            slope
        };
        let slopes: Vec<Laurent> = inverse.iter().map(slope).collect();
        let potential = antiderivative(ring, &partials, &positions, &slopes);
        Some(Mechanical { momenta, kinetic, potential })
    }
}

type Matrix = Vec<Vec<RationalFunction>>;

fn inverse_transpose(matrix: &Matrix) -> Option<Matrix> {
    let n = matrix.len();
    let rows = |i: usize| {
        // Row i of A⁻ᵀ is the b with A b = eᵢ. The vector (b, 1) is in the null space of (A | −eᵢ).
        let unit = |k: usize| if k == i { -&RationalFunction::one() } else { RationalFunction::zero() };
        let rows = matrix.iter().enumerate().map(|(k, row)| [&row[..], &[unit(k)]].concat()).collect();
        let mut solutions = null_space(rows, n + 1);
        let mut solution = solutions.pop().filter(|_| solutions.is_empty())?;
        let last = solution.pop().filter(|last| *last == RationalFunction::one());
        last.map(|_| solution)
    };
    (0..n).map(rows).collect()
}

fn dependencies(ring: &Ring, polynomial: &Laurent, into: &mut BTreeSet<usize>) {
    for (monomial, _) in polynomial.terms() {
        for (coordinate, _) in monomial.powers() {
            match ring.coordinates[coordinate].meaning.argument() {
                None => {
                    into.insert(coordinate);
                }
                Some(argument) => dependencies(ring, argument, into),
            }
        }
    }
}

/// Splits the states into positions and momenta of equal number. Derivatives of positions are
/// linear in momenta. Derivatives of momenta depend on positions only.
fn positions_and_momenta(ring: &Ring) -> Option<[Vec<usize>; 2]> {
    let states = ring.field.len();
    let uses = |state: usize| {
        let mut uses = BTreeSet::new();
        dependencies(ring, &ring.field[state], &mut uses);
        uses
    };
    let moved_by = |state: usize| -> Option<Vec<usize>> {
        let terms = ring.field[state].terms().map(|(monomial, _)| {
            (0..states).find(|&other| other != state && *monomial == Monomial::power(other, 1))
        });
        terms.rev().collect::<Option<Vec<usize>>>().filter(|by| !by.is_empty())
    };
    // A state with a linear derivative is a position unless it is a momentum already.
    let mut positions: Vec<usize> = Vec::new();
    let mut momenta: Vec<usize> = Vec::new();
    for state in 0..states {
        let Some(by) = moved_by(state).filter(|_| !momenta.contains(&state)) else { continue };
        if by.iter().all(|momentum| !positions.contains(momentum)) {
            positions.push(state);
            momenta.extend(by);
        }
    }
    momenta.sort_unstable();
    momenta.dedup();
    let is_mechanical = positions.len() == momenta.len()
        && positions.len() * 2 == states
        && !positions.is_empty()
        && momenta.iter().all(|&momentum| uses(momentum).iter().all(|state| positions.contains(state)));
    is_mechanical.then_some([positions, momenta])
}

fn along(ring: &Ring, state: usize) -> Ring {
    let mut ring = ring.clone();
    let unit = |other| if other == state { Laurent::number(Rational::one()) } else { Laurent::zero() };
    ring.set_field((0..ring.field.len()).map(unit).collect());
    ring
}

/// Returns the derivatives of all polynomials with respect to the first `states` coordinates.
pub(crate) fn slopes<'a>(
    ring: &Ring,
    states: usize,
    polynomials: impl Iterator<Item = &'a Laurent>,
) -> Vec<Laurent> {
    let partials: Vec<Ring> = (0..states).map(|state| along(ring, state)).collect();
    polynomials.flat_map(|one| partials.iter().map(move |along| along.derivative(one))).collect()
}

/// For x′ = Ap and p′ = G(x), returns a symmetric matrix S with −A⁻ᵀSG = ∇V for some V(x), so that
/// ½pᵀSp + V is an energy. S has no 0 on its diagonal, and is A or a diagonal matrix if possible.
fn kinetic_energy(
    ring: &Ring,
    partials: &[Ring],
    momenta: &[usize],
    moves: &Matrix,
    inverse: &Matrix,
) -> Option<Matrix> {
    let n = momenta.len();
    // The entry slopes[k][l] is ∂G_k/∂x_l.
    let slopes: Vec<Vec<Laurent>> = momenta
        .iter()
        .map(|&momentum| partials.iter().map(|along| along.derivative(&ring.field[momentum])).collect())
        .collect();
    let diagonal: Vec<(usize, usize)> = (0..n).map(|i| (i, i)).collect();
    let symmetric: Vec<(usize, usize)> = (0..n).flat_map(|i| (i..n).map(move |k| (i, k))).collect();
    for (shape, is_own) in [(&symmetric, true), (&diagonal, false), (&symmetric, false)] {
        // With B = A⁻ᵀ, −BSG is a gradient if Σ_jk B_ij S_jk ∂G_k/∂x_l is symmetric in i and l.
        let mut rows: Matrix = Vec::new();
        for i in 0..n {
            for l in i + 1..n {
                let column = |&(first, second): &(usize, usize)| {
                    let mut column = Laurent::zero();
                    let mut add = |j: usize, k: usize| {
                        column.add_scaled(&slopes[k][l], &inverse[i][j]);
                        column.add_scaled(&slopes[k][i], &-&inverse[l][j]);
                    };
                    add(first, second);
                    if first != second {
                        add(second, first);
                    }
                    column
                };
                rows.extend(coefficient_rows(&shape.iter().map(column).collect::<Vec<_>>()));
            }
        }
        let vector = if is_own {
            Some(shape.iter().map(|&(i, k)| moves[i][k].clone()).collect())
        } else {
            let add = |sum: Vec<_>, next: Vec<_>| sum.iter().zip(&next).map(|(a, b)| a + b).collect();
            null_space(rows.clone(), shape.len()).into_iter().reduce(add)
        };
        if let Some(vector) = vector {
            let holds = rows.iter().all(|row| {
                let terms = row.iter().zip(&vector).map(|(a, b)| a * b);
                terms.fold(RationalFunction::zero(), |sum, term| &sum + &term).is_zero()
            });
            let mut matrix = vec![vec![RationalFunction::zero(); n]; n];
            for (value, &(i, k)) in vector.iter().zip(shape) {
                matrix[i][k] = value.clone();
                matrix[k][i] = value.clone();
            }
            if holds && (0..n).all(|i| !matrix[i][i].is_zero()) {
                return Some(matrix);
            }
        }
    }
    None
}

fn coefficient_rows(columns: &[Laurent]) -> Matrix {
    let monomials: BTreeSet<&Monomial> =
        columns.iter().flat_map(|column| column.terms().map(|(monomial, _)| monomial)).collect();
    let row = |monomial| columns.iter().map(|column| column.coefficient(monomial)).collect();
    monomials.into_iter().map(row).collect()
}

/// Returns a function with these partial derivatives, as a combination of monomials.
fn antiderivative(
    ring: &Ring,
    partials: &[Ring],
    positions: &[usize],
    slopes: &[Laurent],
) -> Option<Laurent> {
    let mut candidates: BTreeSet<Monomial> = BTreeSet::new();
    let mut seeds: Vec<(Monomial, usize)> = slopes
        .iter()
        .zip(positions)
        .flat_map(|(slope, &position)| slope.terms().map(move |(monomial, _)| (monomial.clone(), position)))
        .collect();
    for _ in 0..2 {
        let mut next = Vec::new();
        for (monomial, position) in &seeds {
            for candidate in integrals(ring, monomial, *position) {
                if candidates.len() < MOST_CANDIDATES
                    && ring.is_normal(&candidate)
                    && candidates.insert(candidate.clone())
                {
                    next.push((candidate.over(&Monomial::power(*position, 1)), *position));
                }
            }
        }
        seeds = next;
    }
    let candidates: Vec<Monomial> = candidates.into_iter().collect();
    let mut rows = Vec::new();
    for (along, slope) in partials.iter().zip(slopes) {
        let mut columns: Vec<Laurent> = candidates.iter().map(|one| along.derivative_of(one)).collect();
        columns.push(slope.clone());
        rows.extend(coefficient_rows(&columns));
    }
    let solution = null_space(rows, candidates.len() + 1)
        .into_iter()
        .find(|vector| vector.last().is_some_and(|last| !last.is_zero()))?;
    let factor = -&RationalFunction::one().checked_div(solution.last()?)?;
    let mut potential = Laurent::zero();
    for (monomial, value) in candidates.iter().zip(&solution) {
        potential.add_term(monomial.clone(), &(value * &factor));
    }
    Some(potential)
}

/// Returns the monomials m such that the derivative of m by `position` may contain `monomial`.
fn integrals(ring: &Ring, monomial: &Monomial, position: usize) -> Vec<Monomial> {
    let x = Monomial::power(position, 1);
    let mut integrals = vec![monomial.times(&x), monomial.clone()];
    for (coordinate, _) in monomial.powers() {
        let one = Monomial::power(coordinate, 1);
        match &ring.coordinates[coordinate].meaning {
            CoordinateDefinition::Function(Function::Sin | Function::Sinh, _) => {
                integrals.push(monomial.over(&one).times(&Monomial::power(coordinate + 1, 1)));
            }
            CoordinateDefinition::Function(Function::Cos | Function::Cosh, _) => {
                integrals.push(monomial.over(&one).times(&Monomial::power(coordinate - 1, 1)));
            }
            CoordinateDefinition::Root(_, index) => {
                let raised = monomial.times(&one.pow(*index));
                integrals.extend([raised.over(&x), raised.clone()]);
            }
            _ => {}
        }
    }
    for (index, coordinate) in ring.coordinates.iter().enumerate() {
        if let CoordinateDefinition::Function(Function::Log, _) = coordinate.meaning {
            integrals.push(monomial.times(&x).times(&Monomial::power(index, 1)));
            integrals.push(Monomial::power(index, 1));
        }
    }
    integrals
}
