//! Mechanical systems: x′ = A p, p′ = G(x) with a potential.
//!
//! If S is a constant symmetric matrix and V(x) a function with ∇V = −A⁻ᵀ S G, then
//! ½ pᵀSp + V is constant along solutions. A lift in which the components of G are affine in the
//! variables, and a variable W stands for V with W′ = −pᵀS G, has a map that keeps
//!
//!   ½ pᵀSp + W − ε² GᵀSG/2
//!
//! exactly, whatever the other equations are: the rule of polarisation with y = p.

use std::collections::BTreeSet;

use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use crate::laurent::{Laurent, Monomial};
use crate::linear::null_space;
use crate::ring::{Function, Meaning, Ring};

/// A mechanical system.
#[derive(Clone, Debug)]
pub(crate) struct Mechanical {
    /// The states that are momenta.
    pub momenta: Vec<usize>,
    /// S: ½ pᵀSp is the kinetic energy.
    pub kinetic: Vec<Vec<RationalFunction>>,
    /// V, where an antiderivative was found.
    pub potential: Option<Laurent>,
}

/// The most monomials that an antiderivative is made of.
const MOST_CANDIDATES: usize = 120;

impl Mechanical {
    /// Recognises a mechanical system; its curl is tested exactly.
    pub(crate) fn recognise(ring: &Ring) -> Option<Self> {
        let [positions, momenta] = positions_and_momenta(ring)?;
        // The partial derivatives by the positions are derivatives along constant fields.
        let partials: Vec<Ring> = positions.iter().map(|&position| along(ring, position)).collect();
        let moves: Vec<RationalFunction> = (0..positions.len())
            .map(|i| ring.field[positions[i]].coefficient(&Monomial::power(momenta[i], 1)))
            .collect();
        let kinetic = kinetic_energy(ring, &partials, &momenta, &moves)?;
        let slopes: Vec<Laurent> = (0..positions.len())
            .map(|i| {
                let mut slope = Laurent::zero();
                for (factor, &momentum) in kinetic[i].iter().zip(&momenta) {
                    slope.add_scaled(&ring.field[momentum], &-factor);
                }
                slope.scale(&RationalFunction::one().checked_div(&moves[i]).expect("a velocity is not 0"))
            })
            .collect();
        let potential = antiderivative(ring, &partials, &positions, &slopes);
        Some(Mechanical { momenta, kinetic, potential })
    }
}

/// The states that a polynomial depends on, also through functions.
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

/// Positions, each of which moves by a constant multiple of one momentum, and these momenta, whose
/// derivatives depend on positions only.
fn positions_and_momenta(ring: &Ring) -> Option<[Vec<usize>; 2]> {
    let states = ring.field.len();
    let uses: Vec<BTreeSet<usize>> = ring
        .field
        .iter()
        .map(|side| {
            let mut uses = BTreeSet::new();
            dependencies(ring, side, &mut uses);
            uses
        })
        .collect();
    let moved_by = |state: usize| {
        let (monomial, _) = ring.field[state].terms().next().filter(|_| ring.field[state].len() == 1)?;
        let momentum = (0..states).find(|&other| *monomial == Monomial::power(other, 1))?;
        (momentum != state).then_some(momentum)
    };
    // A state that moves by one momentum is a position unless it is a momentum itself.
    let mut positions: Vec<usize> = Vec::new();
    let mut momenta: Vec<usize> = Vec::new();
    for state in 0..states {
        if let Some(momentum) = moved_by(state)
            && !momenta.contains(&state)
            && !momenta.contains(&momentum)
            && !positions.contains(&momentum)
        {
            positions.push(state);
            momenta.push(momentum);
        }
    }
    let is_mechanical = positions.len() * 2 == states
        && !positions.is_empty()
        && momenta.iter().all(|&momentum| uses[momentum].iter().all(|state| positions.contains(state)));
    is_mechanical.then_some([positions, momenta])
}

/// The ring with the field that moves one state at unit speed.
fn along(ring: &Ring, state: usize) -> Ring {
    let mut ring = ring.clone();
    let unit = |other| if other == state { Laurent::number(Rational::one()) } else { Laurent::zero() };
    ring.set_field((0..ring.field.len()).map(unit).collect());
    ring
}

/// A symmetric matrix S for which −A⁻ᵀSG is a gradient: A itself, else a diagonal matrix, else any.
fn kinetic_energy(
    ring: &Ring,
    partials: &[Ring],
    momenta: &[usize],
    moves: &[RationalFunction],
) -> Option<Vec<Vec<RationalFunction>>> {
    let n = momenta.len();
    // slopes[k][l] = ∂G_k/∂x_l.
    let slopes: Vec<Vec<Laurent>> = momenta
        .iter()
        .map(|&momentum| partials.iter().map(|along| along.derivative(&ring.field[momentum])).collect())
        .collect();
    let shapes: [Vec<(usize, usize)>; 2] =
        [(0..n).map(|i| (i, i)).collect(), (0..n).flat_map(|i| (i..n).map(move |k| (i, k))).collect()];
    let inverse: Vec<RationalFunction> = moves
        .iter()
        .map(|factor| RationalFunction::one().checked_div(factor).expect("a velocity is not 0"))
        .collect();
    for shape in shapes {
        let mut rows: Vec<Vec<RationalFunction>> = Vec::new();
        for i in 0..n {
            for l in i + 1..n {
                // (1/a_i) Σ s_ik ∂G_k/∂x_l = (1/a_l) Σ s_lk ∂G_k/∂x_i.
                let mut columns: Vec<Laurent> = vec![Laurent::zero(); shape.len()];
                for (column, &(first, second)) in columns.iter_mut().zip(&shape) {
                    let mut add = |row: usize, k: usize| {
                        if row == i {
                            column.add_scaled(&slopes[k][l], &inverse[i]);
                        }
                        if row == l {
                            column.add_scaled(&slopes[k][i], &-&inverse[l]);
                        }
                    };
                    add(first, second);
                    if first != second {
                        add(second, first);
                    }
                }
                rows.extend(coefficient_rows(&columns));
            }
        }
        let solutions = null_space(rows.clone(), shape.len());
        let own: Vec<RationalFunction> = shape
            .iter()
            .map(|&(i, k)| if i == k { moves[i].clone() } else { RationalFunction::zero() })
            .collect();
        let sum = solutions.iter().fold(vec![RationalFunction::zero(); shape.len()], |sum, next| {
            sum.iter().zip(next).map(|(a, b)| a + b).collect()
        });
        for vector in [own, sum] {
            let holds = rows.iter().all(|row| {
                let terms = row.iter().zip(&vector).map(|(a, b)| a * b);
                terms.fold(RationalFunction::zero(), |sum, term| &sum + &term).is_zero()
            });
            let mut matrix = vec![vec![RationalFunction::zero(); n]; n];
            for (value, &(i, k)) in vector.iter().zip(&shape) {
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

/// One row of coefficients a monomial that occurs in the columns.
fn coefficient_rows(columns: &[Laurent]) -> Vec<Vec<RationalFunction>> {
    let monomials: BTreeSet<&Monomial> =
        columns.iter().flat_map(|column| column.terms().map(|(monomial, _)| monomial)).collect();
    monomials
        .into_iter()
        .map(|monomial| columns.iter().map(|column| column.coefficient(monomial)).collect())
        .collect()
}

/// V with these partial derivatives, as a combination of monomials whose derivatives resemble them.
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

/// Monomials whose derivative by a position may contain `monomial`.
fn integrals(ring: &Ring, monomial: &Monomial, position: usize) -> Vec<Monomial> {
    let x = Monomial::power(position, 1);
    let mut integrals = vec![monomial.times(&x), monomial.clone()];
    for (coordinate, _) in monomial.powers() {
        let one = Monomial::power(coordinate, 1);
        match &ring.coordinates[coordinate].meaning {
            Meaning::Function(Function::Sin | Function::Sinh, _) => {
                integrals.push(monomial.over(&one).times(&Monomial::power(coordinate + 1, 1)));
            }
            Meaning::Function(Function::Cos | Function::Cosh, _) => {
                integrals.push(monomial.over(&one).times(&Monomial::power(coordinate - 1, 1)));
            }
            Meaning::Root(_, index) => {
                let raised = monomial.times(&one.pow(*index));
                integrals.extend([raised.over(&x), raised.clone()]);
            }
            _ => {}
        }
    }
    for (index, coordinate) in ring.coordinates.iter().enumerate() {
        if let Meaning::Function(Function::Log, _) = coordinate.meaning {
            integrals.push(monomial.times(&x).times(&Monomial::power(index, 1)));
            integrals.push(Monomial::power(index, 1));
        }
    }
    integrals
}
