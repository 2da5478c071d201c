//! Spaces of polynomials in the states, with bases in reduced echelon form on fixed monomials.
//!
//! The entries of the reduced basis are rational functions of the parameters, ε, and constants of
//! level sets.

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::Symbols;

use crate::claims::writing::begins_negative;
use crate::deadline::Deadline;
use crate::maps::search_field::SearchField;
use crate::modular::grading::{Grading, reconstruct_graded};
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::reconstruction::reconstruct;
use crate::modular::weights::Weights;

/// The monomials that occur in a basis, and the leading monomial of each element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form {
    /// The indices of the monomials that occur, in ascending or descending order.
    pub support: Vec<usize>,
    /// For each element, the position of its leading monomial in `support`.
    pub pivots: Vec<usize>,
}

/// A space of polynomials with a basis in reduced form.
///
/// Each element begins with its leading monomial, whose coefficient is 1. The other elements do not
/// contain that monomial.
#[derive(Clone, Debug)]
pub struct PolynomialSpace {
    /// The monomials of the basis and the leading monomials.
    pub form: Form,
    /// For each element, the coefficients of the monomials in `form.support`.
    pub rows: Vec<Vec<u64>>,
}

impl PolynomialSpace {
    /// Returns the span of vectors with an entry for each monomial. The reduced basis orders
    /// monomials from low to high or from high to low, whichever gives fewer terms.
    #[must_use]
    pub fn spanned(modulus: &Modulus, vectors: Vec<Vec<u64>>) -> Self {
        let columns = vectors.first().map_or(0, Vec::len);
        let used: Vec<usize> =
            (0..columns).filter(|&column| vectors.iter().any(|row| row[column] != 0)).collect();
        let in_order = |support: Vec<usize>| {
            let rows =
                vectors.iter().map(|row| support.iter().map(|&column| row[column]).collect()).collect();
            let echelon = Echelon::of(modulus, rows, support.len());
            PolynomialSpace { form: Form { support, pivots: echelon.pivots }, rows: echelon.rows }
        };
        let terms =
            |space: &PolynomialSpace| (0..space.dimension()).map(|index| space.terms(index)).sum::<usize>();
        let low_first = in_order(used.clone());
        let high_first = in_order(used.into_iter().rev().collect());
        if terms(&high_first) < terms(&low_first) { high_first } else { low_first }
    }

    /// Returns the span of vectors whose entries are coefficients of the monomials in
    /// `form.support`. Returns `None` if the reduced basis has other leading monomials than `form`.
    #[must_use]
    pub fn of_form(modulus: &Modulus, form: &Form, vectors: Vec<Vec<u64>>) -> Option<Self> {
        let echelon = Echelon::of(modulus, vectors, form.support.len());
        (echelon.pivots == form.pivots).then(|| PolynomialSpace { form: form.clone(), rows: echelon.rows })
    }

    /// Returns the number of basis elements.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.rows.len()
    }

    /// Returns a basis element as the vector of the coefficients of all `count` monomials.
    #[must_use]
    pub fn element(&self, index: usize, count: usize) -> Vec<u64> {
        spread_to_monomials(&self.form.support, &self.rows[index], count)
    }

    /// Returns the number of terms of a basis element.
    #[must_use]
    pub fn terms(&self, index: usize) -> usize {
        self.rows[index].iter().filter(|&&value| value != 0).count()
    }
}

/// Returns a vector of length `len` with `entries` at the given indices, and zeros elsewhere.
pub(crate) fn spread_to_monomials<'a>(
    places: impl IntoIterator<Item = &'a usize>,
    entries: &[u64],
    len: usize,
) -> Vec<u64> {
    let mut all = vec![0; len];
    for (&place, &entry) in places.into_iter().zip(entries) {
        all[place] = entry;
    }
    all
}

/// The variables that occur in formulas for a space of polynomials.
#[derive(Clone, Debug)]
pub struct FormulaVariables {
    /// The unknowns of the space: parameters, ε, and constants that define a level set.
    pub unknowns: Vec<Variable>,
    /// The states that the monomials contain.
    pub states: Vec<Variable>,
    /// The scaling symmetries, and for each unknown its weights under them, if known.
    pub weights: Option<(Weights, Vec<Vec<Rational>>)>,
}

impl FormulaVariables {
    /// Returns the variables for formulas that may contain every state of the map.
    #[must_use]
    pub fn of(searched: &SearchField) -> Self {
        let symbols = searched.family().symbols();
        let unknowns = searched.unknown_variables();
        let own = unknowns.iter().map(|&unknown| searched.weights().of_variable(unknown)).collect();
        FormulaVariables {
            unknowns,
            states: (0..searched.dimension()).map(|i| symbols.state(i)).collect(),
            weights: Some((searched.weights().clone(), own)),
        }
    }

    /// Returns the weights of the basis's coefficients. In an element with the leading monomial p,
    /// the coefficient of a monomial m has the weight of p/m.
    fn grading(
        &self,
        weights: &(Weights, Vec<Vec<Rational>>),
        monomials: &Monomials,
        form: &Form,
    ) -> Grading {
        let weight = |place: usize| {
            let exponents = monomials.exponents(form.support[place]);
            let powers = self.states.iter().copied().zip(exponents.iter().copied());
            weights.0.of_monomial(&powers.collect())
        };
        let entries = form.pivots.iter().flat_map(|&pivot| {
            let leading = weight(pivot);
            (0..form.support.len())
                .map(|place| leading.iter().zip(weight(place)).map(|(a, b)| a - &b).collect())
                .collect::<Vec<Vec<Rational>>>()
        });
        Grading { unknowns: weights.1.clone(), entries: entries.collect() }
    }
}

/// Reconstructs the basis of a space over ℚ, as polynomials with coprime integer coefficients. The
/// function `at` returns the space at values of the unknowns. Returns `None` if this space has
/// other monomials than `form`, or if [`reconstruct`] fails.
pub fn reconstruct_space(
    names: &FormulaVariables,
    monomials: &Monomials,
    form: &Form,
    mut at: impl FnMut(Modulus, &[u64], &mut SplitMix64) -> Option<PolynomialSpace>,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<Vec<Polynomial>> {
    let mut oracle = |modulus: Modulus, unknowns: &[u64], random: &mut SplitMix64| {
        let space = at(modulus, unknowns, random)?;
        (space.form == *form).then(|| space.rows.concat())
    };
    let entries = match &names.weights {
        Some(weights) => {
            let grading = names.grading(weights, monomials, form);
            reconstruct_graded(&mut oracle, &names.unknowns, &grading, random, deadline)?
        }
        None => reconstruct(&mut oracle, &names.unknowns, random, deadline)?,
    };
    let rows = entries.chunks(form.support.len());
    Some(rows.map(|row| integer_combination(&names.states, monomials, &form.support, row)).collect())
}

/// Returns Σ cₘ m over the monomials m, scaled to coprime integer coefficients.
#[must_use]
pub fn integer_combination(
    states: &[Variable],
    monomials: &Monomials,
    support: &[usize],
    coefficients: &[RationalFunction],
) -> Polynomial {
    combination(states, monomials, support, &RationalFunction::over_common(coefficients).0).primitive_part()
}

pub(crate) fn combination(
    states: &[Variable],
    monomials: &Monomials,
    support: &[usize],
    coefficients: &[Polynomial],
) -> Polynomial {
    support.iter().zip(coefficients).fold(Polynomial::zero(), |sum, (&index, coefficient)| {
        let exponents = states.iter().copied().zip(monomials.exponents(index).iter().copied());
        sum + coefficient.mul_monomial(&exponents.collect::<Monomial>())
    })
}

/// Divides a polynomial by all factors that contain no state, and chooses the sign for which the
/// first printed term is positive.
#[must_use]
pub fn primitive_in_states(symbols: &Symbols, polynomial: &Polynomial) -> Polynomial {
    let primitive = symbols.primitive_part(polynomial);
    if begins_negative(&primitive) { -&primitive } else { primitive }
}
