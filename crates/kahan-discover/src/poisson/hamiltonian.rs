//! Constant Poisson structures K of the field f = K∇H, and modified Hamiltonians of the map.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Budget, Polynomial, Variable, gcd_within};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::Notation;
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::upper_index;

use crate::deadline::Deadline;
use crate::densities::determinant::{bordered_determinant, determinant};
use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::{Sample, SearchField};
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::reconstruction::reconstruct;
use crate::modular::subspace::combination;
use crate::orbits::relations::monomial_gradients;

const MOST_TERMS: usize = 1500;
const MODIFIED_WORK: u64 = 10_000_000;

const MOST_STRUCTURES: usize = 4;

/// For n components of the field, a system has 6n more equations than unknowns.
const SPARE_EQUATIONS: usize = 6;

/// A decomposition f = K∇H with a constant antisymmetric matrix K.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hamiltonian {
    /// The matrix K, row by row. Its entries contain no state.
    pub tensor: Vec<Vec<RationalFunction>>,
    /// The function H, a polynomial in the states of degree at most three.
    pub hamiltonian: RationalFunction,
}

const MOST_COEFFICIENTS: usize = 400;

/// Returns whether H in n variables has at most 400 coefficients, the limit of the search.
#[must_use]
pub fn is_within_reach(n: usize) -> bool {
    Monomials::count(n, 3) <= MOST_COEFFICIENTS
}

/// Finds constant matrices K and functions H with f = K∇H.
///
/// The matrix f′(x)K must be symmetric for all x. The matrices K with this property form a space
/// with a reduced basis. For each K of the basis, f = K∇H is a linear equation for the coefficients
/// of a cubic H. If none has a solution, the sum of the basis is tried as K. The result is empty if
/// H has more than 400 coefficients, or if the field is zero.
pub fn hamiltonians(
    searched: &SearchField,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Vec<Hamiltonian> {
    let n = searched.dimension();
    if n < 2 || !is_within_reach(n) {
        return Vec::new();
    }
    let monomials = Monomials::new(n, 3);
    let Some(sample) = searched.sample(Modulus::mersenne_61(), random) else { return Vec::new() };
    let tensors = tensors(&sample.map, random);
    let mut has_potential = |choice: &usize| {
        tensor_of_choice(&sample.map, &tensors, *choice)
            .is_some_and(|k| potential(&sample.map, &monomials, &k, random, deadline).is_some())
    };
    let mut choices: Vec<usize> = (1..=tensors.len()).filter(&mut has_potential).collect();
    if choices.is_empty() && has_potential(&0) {
        choices.push(0);
    }
    let over_the_rationals =
        |choice| reconstructed(searched, &monomials, tensors.len(), choice, random, deadline);
    choices.into_iter().take(MOST_STRUCTURES).filter_map(over_the_rationals).collect()
}

fn reconstructed(
    searched: &SearchField,
    monomials: &Monomials,
    count: usize,
    choice: usize,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Hamiltonian> {
    let n = searched.dimension();
    let mut oracle = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
        let map = searched.at(modulus, unknowns)?;
        let found = self::tensors(&map, random);
        if found.len() != count {
            return None;
        }
        let tensor = tensor_of_choice(&map, &found, choice)?;
        let potential = potential(&map, monomials, &tensor, random, deadline)?;
        Some([tensor, potential].concat())
    };
    let entries = reconstruct(&mut oracle, &searched.unknown_variables(), random, deadline)?;
    let (upper, coefficients) = entries.split_at(n * (n - 1) / 2);
    let symbols = searched.family().symbols();
    let states: Vec<Variable> = (0..n).map(|i| symbols.state(i)).collect();
    let support: Vec<usize> = (1..monomials.len()).collect();
    let (coefficients, common) = RationalFunction::over_common(coefficients);
    let hamiltonian =
        RationalFunction::new(combination(&states, monomials, &support, &coefficients), common)?;
    if hamiltonian.is_zero() {
        return None;
    }
    let mut tensor = vec![vec![RationalFunction::zero(); n]; n];
    for ((i, j), entry) in pairs(n).into_iter().zip(upper) {
        tensor[i][j] = entry.clone();
        tensor[j][i] = -entry;
    }
    Some(Hamiltonian { tensor, hamiltonian })
}

fn pairs(n: usize) -> Vec<(usize, usize)> {
    (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).collect()
}

/// Returns a basis of the antisymmetric matrices K for which f′(x)K is symmetric for all x, as
/// entries above the diagonal.
fn tensors(map: &ModularMap, random: &mut SplitMix64) -> Vec<Vec<u64>> {
    let modulus = map.modulus();
    let n = map.dimension();
    let places = pairs(n);
    let mut rows = Vec::new();
    // The matrix f′ is affine in x, so n + 1 points in general position suffice. One more is taken
    // for safety.
    for _ in 0..n + 2 {
        let (_, slopes) = map.field(&map.point(random));
        for &(i, j) in &places {
            // Equation (i, j) is (f′K)ᵢⱼ − (f′K)ⱼᵢ = Σₗ f′ᵢₗ Kₗⱼ − f′ⱼₗ Kₗᵢ = 0.
            let mut row = vec![0; places.len()];
            let mut add = |a: usize, b: usize, value: u64| {
                if a == b {
                    return;
                }
                let place = upper_index(n, a.min(b), a.max(b));
                let signed = if a < b { value } else { modulus.opposite(value) };
                row[place] = modulus.plus(row[place], signed);
            };
            for (l, (left, right)) in slopes[i].iter().zip(&slopes[j]).enumerate() {
                add(l, j, *left);
                add(l, i, modulus.opposite(*right));
            }
            rows.push(row);
        }
    }
    Echelon::null_vectors(modulus, rows, places.len(), &Deadline::never()).expect("there is no deadline")
}

/// Returns the sum of the basis for choice 0, and basis element `choice` − 1 otherwise.
fn tensor_of_choice(map: &ModularMap, tensors: &[Vec<u64>], choice: usize) -> Option<Vec<u64>> {
    if choice > 0 {
        return tensors.get(choice - 1).cloned();
    }
    let (first, others) = tensors.split_first()?;
    let add = |sum: Vec<u64>, other: &Vec<u64>| {
        sum.iter().zip(other).map(|(a, b)| map.modulus().plus(*a, *b)).collect()
    };
    Some(others.iter().fold(first.clone(), add))
}

/// Returns the coefficients of a cubic H with K∇H = f, without the constant term.
fn potential(
    map: &ModularMap,
    monomials: &Monomials,
    tensor: &[u64],
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Vec<u64>> {
    let modulus = map.modulus();
    let n = map.dimension();
    let width = monomials.len() - 1;
    let mut rows = Vec::new();
    while rows.len() < width + n * SPARE_EQUATIONS {
        let point = map.point(random);
        let (value, _) = map.field(&point);
        let slopes = monomial_gradients(modulus, monomials, &point);
        for (i, &right) in value.iter().enumerate() {
            let mut row: Vec<u64> = (1..=width)
                .map(|index| {
                    (0..n).filter(|&j| j != i).fold(0, |sum, j| {
                        let entry = tensor[upper_index(n, i.min(j), i.max(j))];
                        let entry = if i < j { entry } else { modulus.opposite(entry) };
                        modulus.plus(sum, modulus.times(entry, slopes[index][j]))
                    })
                })
                .collect();
            row.push(right);
            rows.push(row);
        }
    }
    let echelon = Echelon::within(modulus, rows, width + 1, deadline)?;
    if echelon.pivots.last() == Some(&width) {
        return None;
    }
    let mut coefficients = vec![0; width];
    for (row, &pivot) in echelon.rows.iter().zip(&echelon.pivots) {
        coefficients[pivot] = row[width];
    }
    Some(coefficients)
}

impl Hamiltonian {
    /// Tests f = K∇H by expansion over ℚ. The modified Hamiltonian is then an integral of the map
    /// (Celledoni, McLachlan, Owren and Quispel).
    #[must_use]
    pub fn holds(&self, field: &Field) -> bool {
        let slopes: Vec<RationalFunction> =
            (0..field.dimension()).map(|i| self.hamiltonian.derivative(field.symbols.state(i))).collect();
        self.tensor.iter().zip(&field.components).all(|(row, component)| {
            let products = row.iter().zip(&slopes).map(|(entry, slope)| entry * slope);
            let value = products.fold(RationalFunction::zero(), |sum, product| &sum + &product);
            value == *component
        })
    }

    /// Writes the modified Hamiltonian in the compact form H + (x̃ − x)·∇H/3, where `x~` stands for
    /// x̃. The value equals [`modified`](Self::modified).
    #[must_use]
    pub fn compact(&self, symbols: &Symbols, notation: &dyn Notation) -> String {
        let written = |function: &RationalFunction| notation.function(symbols, function);
        let term = |(i, state): (usize, &String)| {
            let slope = self.hamiltonian.derivative(symbols.state(i));
            let slope = (!slope.is_zero()).then(|| written(&slope))?;
            let distance = format!("({} - {})", notation.image(state), notation.name(state));
            Some(notation.product(&[distance, format!("({slope})")]))
        };
        let moved: Vec<String> = symbols.states.iter().enumerate().filter_map(term).collect();
        let third = notation.number(&Rational::new(1, 3));
        let moved = notation.product(&[third, format!("({})", moved.join(" + "))]);
        format!("{} + {moved}", written(&self.hamiltonian))
    }

    /// Returns the gradient of the modified Hamiltonian at a point of a sampled map, up to a
    /// factor.
    #[must_use]
    pub fn modified_gradient(
        &self,
        searched: &SearchField,
        sample: &Sample,
        here: &[u64],
    ) -> Option<Vec<u64>> {
        let modulus = sample.map.modulus();
        let n = searched.dimension();
        let there = sample.map.next(here)?;
        let jacobian = sample.map.jacobian(here, &there)?;
        let symbols = searched.family().symbols();
        let potential = self.hamiltonian.numerator();
        let first: Vec<Polynomial> = (0..n).map(|i| potential.derivative(symbols.state(i))).collect();
        let slopes: Vec<u64> =
            first.iter().map(|slope| searched.evaluate(slope, sample, here)).collect::<Option<_>>()?;
        let third = modulus.inverse(modulus.integer(3))?;
        (0..n)
            .map(|j| {
                let mut moved = modulus.opposite(slopes[j]);
                for i in 0..n {
                    let second = searched.evaluate(&first[i].derivative(symbols.state(j)), sample, here)?;
                    let distance = modulus.minus(there[i], here[i]);
                    moved = modulus.plus(moved, modulus.times(second, distance));
                    moved = modulus.plus(moved, modulus.times(slopes[i], jacobian[i][j]));
                }
                Some(modulus.plus(slopes[j], modulus.times(third, moved)))
            })
            .collect()
    }

    /// Returns numerator and denominator of the modified Hamiltonian H̃, up to a factor without
    /// states.
    ///
    /// H̃ = H + (h/3) ∇Hᵀ (I − (h/2) f′)⁻¹ f with h = 2ε is an integral of the map (Celledoni,
    /// McLachlan, Owren, Quispel, "Geometric properties of Kahan's method", 2013). Returns `None`
    /// if I − ε f′ is singular for all x, or if H̃ has more than 1500 terms. The fraction may be
    /// reducible.
    #[must_use]
    pub fn modified(&self, searched: &SearchField, field: &Field) -> Option<(Polynomial, Polynomial)> {
        let symbols = &field.symbols;
        let mut budget = Budget::new(MOST_TERMS, MODIFIED_WORK);
        // With H = P/q, D = det A and A = I − ε f′: 3q H̃ = (3PD + 2ε ∇Pᵀ adj(A) f)/D.
        let potential = self.hamiltonian.numerator();
        let slopes: Vec<Polynomial> =
            (0..field.dimension()).map(|i| potential.derivative(symbols.state(i))).collect();
        let below = determinant(field, &mut budget).ok()?;
        let along = bordered_determinant(field, &slopes, &mut budget).ok()?;
        let two_eps = Polynomial::variable(symbols.epsilon()).scale(&Rational::from(2));
        let start = potential.mul_within(&below, &mut budget).ok()?.scale(&Rational::from(3));
        let above = start + along.mul_within(&two_eps, &mut budget).ok()?;
        let (above, below) = (searched.at_eps(above), searched.at_eps(below));
        if below.is_zero() {
            return None;
        }
        match gcd_within(&above, &below, &mut Budget::new(MOST_TERMS, MODIFIED_WORK)) {
            Ok(common) => Some((above.checked_div(&common)?, below.checked_div(&common)?)),
            Err(_) => Some((above, below)),
        }
    }
}
