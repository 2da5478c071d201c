//! Exact jets of a curve, for comparison with the modular computation. A point is moved by δ off
//! the curve, and its images are rational functions of δ.

use kahan_algebra::field::Field;
use kahan_algebra::kahan::RationalMap;
use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::rational::Rational;

/// Homogeneous coordinates of a point near a curve, as polynomials. The variable `delta` moves the
/// point off the curve. The variables `slopes` move it along the curve, and occur linearly.
pub(crate) struct ExactGerm {
    map: Vec<Polynomial>,
    degree: u32,
    states: Vec<Variable>,
    delta: Variable,
    slopes: Vec<Variable>,
    coordinates: Vec<Polynomial>,
}

impl ExactGerm {
    /// Returns the point of the curve that `seed` determines.
    pub(crate) fn on(field: &Field, eps: &Rational, curve: &Polynomial, seed: i64) -> Option<Self> {
        let symbols = &field.symbols;
        let n = field.dimension();
        let states: Vec<Variable> = (0..n).map(|i| symbols.state(i)).collect();
        let reduced = RationalMap::of(field).expect("within the budget").reduced;
        let mut map = reduced.numerators(symbols);
        map.push(reduced.denominator);
        let map: Vec<Polynomial> = map.iter().map(|one| one.substitute(symbols.epsilon(), eps)).collect();
        let degree = map.iter().map(|one| symbols.degree(one)).max()?;
        let solved = (0..n).find(|&i| curve.degree_in(states[i]) == 1)?;
        let mut point: Vec<Rational> = (0..n).map(|i| Rational::new(seed + 3 * i as i64, 7)).collect();
        let at = |polynomial: &Polynomial, point: &[Rational]| {
            let free = (0..n).filter(|&i| i != solved);
            free.fold(polynomial.clone(), |value, i| value.substitute(states[i], &point[i]))
        };
        let below = at(&curve.derivative(states[solved]), &point).as_constant()?;
        let above = at(&curve.substitute(states[solved], &Rational::zero()), &point).as_constant()?;
        point[solved] = -above.checked_div(&below)?;
        // The variable of state `solved` stands for δ, the others for displacements on the curve.
        let (delta, slopes): (Variable, Vec<Variable>) =
            (states[solved], (0..n).filter(|&i| i != solved).map(|i| states[i]).collect());
        let value = |polynomial: &Polynomial| {
            at(polynomial, &point).substitute(states[solved], &point[solved]).as_constant()
        };
        let linear = |variable: Variable, by: Rational| Polynomial::variable(variable).scale(&by);
        let mut coordinates = Vec::new();
        for i in 0..n {
            let moved = linear(delta, Rational::from(i as i64 + 1));
            let mut coordinate = Polynomial::constant(point[i].clone()) + moved;
            if i == solved {
                for &slope in &slopes {
                    let along = value(&curve.derivative(slope))?.checked_div(&below)?;
                    coordinate = coordinate + linear(slope, -along);
                }
            } else {
                coordinate = coordinate + Polynomial::variable(states[i]);
            }
            coordinates.push(coordinate);
        }
        coordinates.push(Polynomial::one());
        Some(ExactGerm { map, degree, states, delta, slopes, coordinates })
    }

    fn cut(&self, polynomial: &Polynomial) -> Polynomial {
        let is_kept =
            |monomial: &Monomial| monomial.degree_where(|variable| self.slopes.contains(&variable)) < 2;
        let kept = polynomial.terms().filter(|(monomial, _)| is_kept(monomial));
        Polynomial::from_terms(kept.map(|(monomial, coefficient)| (monomial.clone(), coefficient.clone())))
    }

    pub(crate) fn step(&mut self) {
        let value = |component: &Polynomial| {
            component.terms().fold(Polynomial::zero(), |sum, (monomial, coefficient)| {
                let exponents = self.states.iter().map(|&state| monomial.exponent(state));
                let exponents = exponents.chain([self.degree - monomial.degree()]);
                let factors = exponents
                    .zip(&self.coordinates)
                    .flat_map(|(exponent, one)| std::iter::repeat_n(one, exponent as usize));
                let product = factors.fold(Polynomial::constant(coefficient.clone()), |product, one| {
                    self.cut(&(&product * one))
                });
                &sum + &product
            })
        };
        let next: Vec<Polynomial> = self.map.iter().map(value).collect();
        let orders =
            next.iter().flat_map(Polynomial::terms).map(|(monomial, _)| monomial.exponent(self.delta));
        let common = orders.min().expect("not all are 0");
        let divisor = Monomial::power(self.delta, common);
        self.coordinates =
            next.iter().map(|one| one.div_monomial(&divisor).expect("a common power")).collect();
    }

    /// Returns the coordinates at δ = 0, each with its derivatives along the curve.
    fn leading(&self) -> Vec<Vec<Rational>> {
        let at_zero = |one: &Polynomial| {
            let here = one.substitute(self.delta, &Rational::zero());
            let value = here.coefficient(&Monomial::one());
            let slope = |&variable: &Variable| here.coefficient(&Monomial::variable(variable));
            [value].into_iter().chain(self.slopes.iter().map(slope)).collect()
        };
        self.coordinates.iter().map(at_zero).collect()
    }

    /// Returns homogeneous coordinates of the limit for δ → 0. The first nonzero one is 1.
    pub(crate) fn place(&self) -> Vec<Rational> {
        let values: Vec<Rational> = self.leading().into_iter().map(|row| row[0].clone()).collect();
        let unit = values.iter().find(|value| !value.is_zero()).expect("a projective point").clone();
        values.iter().map(|value| value.checked_div(&unit).expect("not 0")).collect()
    }

    pub(crate) fn is_infinite(&self) -> bool {
        self.place().last().is_some_and(Rational::is_zero)
    }

    /// Returns the dimension of the curve's image: one less than the rank of the limit and its
    /// derivatives.
    pub(crate) fn dimension(&self) -> usize {
        let mut rows = self.leading();
        let mut rank = 0;
        for column in 0..=self.slopes.len() {
            let Some(found) = (rank..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
            rows.swap(rank, found);
            let pivot = rows[rank].clone();
            for row in &mut rows[rank + 1..] {
                let factor = row[column].checked_div(&pivot[column]).expect("not 0");
                for (entry, above) in row.iter_mut().zip(&pivot) {
                    *entry = &*entry - &(&factor * above);
                }
            }
            rank += 1;
        }
        rank - 1
    }
}
