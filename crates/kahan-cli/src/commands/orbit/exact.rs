//! Exact orbits: projective integers from point to point, fractions only where a row is printed.
//!
//! An integral has one value along the whole orbit. That it has it at a row is checked by
//! multiplication (N q = D p for N/D the integral there, p/q at the first point), which is far
//! cheaper than to reduce N/D again; only where that fails is it reduced.

use dashu_int::IBig;
use dashu_int::ops::Gcd;
use kahan_algebra::Derived;
use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::interpret::Point;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;
use kahan_runtime::heights::HeightsOrbit;

use crate::printing::Refusal;
use crate::reading::Request;

/// An orbit in exact numbers.
pub(super) struct ExactOrbit<'a> {
    request: &'a Request,
    orbit: HeightsOrbit,
    time_step: Rational,
    derived: &'a Derived,
    /// The integrals at the first point.
    first: Vec<Option<Fraction>>,
}

impl<'a> ExactOrbit<'a> {
    /// The orbit at its first point; `derived` is of the request's system.
    pub(super) fn new(
        request: &'a Request,
        derived: &'a Derived,
        start: &[Rational],
    ) -> Result<Self, Refusal> {
        let Point { parameters, eps, .. } = &request.point;
        let orbit = HeightsOrbit::new(&request.system, parameters, eps, start);
        let mut orbit = orbit.map_err(|_| request.undefined_field())?;
        // The first item is the first point itself.
        orbit.next();
        let mut exact = ExactOrbit { request, orbit, time_step: eps + eps, derived, first: Vec::new() };
        let first = exact.integrals(&exact.state());
        exact.first = first.into_iter().map(|value| value.map(Fraction::reduced)).collect();
        Ok(exact)
    }

    /// t, the state and the integrals at the point n; `None` for an integral that divides by zero
    /// there.
    pub(super) fn row(&self, n: i64) -> Vec<Option<String>> {
        let state = self.state();
        let integrals = self.integrals(&state).into_iter().zip(&self.first).map(|(value, first)| {
            let value = value?;
            let conserved = first.as_ref().filter(|first| value.equals(first));
            Some(conserved.cloned().unwrap_or_else(|| value.reduced()).text())
        });
        let integrals: Vec<Option<String>> = integrals.collect();
        let time = (&Rational::from(n) * &self.time_step).to_string();
        let state = state.into_iter().map(|x| Some(x.reduced().text()));
        std::iter::once(Some(time)).chain(state).chain(integrals).collect()
    }

    /// Goes from the point n to the next; what to tell the user where there is none.
    pub(super) fn advance(&mut self, n: i64) -> Result<(), String> {
        match self.orbit.next() {
            Some(_) => Ok(()),
            None => {
                let is_reduced = self.derived.map.is_some();
                Err(self.request.pole::<kahan_algebra::arithmetic::Exact>(n, &self.orbit.point(), is_reduced))
            }
        }
    }

    /// σX/W, not reduced.
    fn state(&self) -> Vec<Fraction> {
        let unit = Fraction::from(self.orbit.projective_map().unit());
        let Some((weight, x)) = self.orbit.projective_point().split_last() else { return Vec::new() };
        let below = &unit.below * weight;
        x.iter().map(|x| Fraction { above: &unit.above * x, below: below.clone() }).collect()
    }

    fn integrals(&self, state: &[Fraction]) -> Vec<Option<Fraction>> {
        let symbols = &self.request.system.field.symbols;
        self.derived.integrals.evaluate(&Fractions, |variable| match symbols.symbol(variable) {
            Symbol::State(i) | Symbol::SecondState(i) => state[i].clone(),
            Symbol::Parameter(k) => Fraction::from(&self.request.point.parameters[k]),
            Symbol::Epsilon => Fraction::from(&self.request.point.eps),
        })
    }
}

/// A quotient of integers, not necessarily in lowest terms; the divisor is not zero.
#[derive(Clone, Debug)]
struct Fraction {
    above: IBig,
    below: IBig,
}

impl Fraction {
    fn equals(&self, other: &Fraction) -> bool {
        &self.above * &other.below == &self.below * &other.above
    }

    /// In lowest terms, the denominator positive.
    fn reduced(self) -> Fraction {
        let common = IBig::from((&self.above).gcd(&self.below));
        let common = if self.below < IBig::ZERO { -common } else { common };
        Fraction { above: self.above / &common, below: self.below / &common }
    }

    /// `p/q` or `p`.
    fn text(&self) -> String {
        if self.below == IBig::ONE {
            self.above.to_string()
        } else {
            format!("{}/{}", self.above, self.below)
        }
    }
}

impl From<&Rational> for Fraction {
    fn from(value: &Rational) -> Self {
        let integer = |bytes: Vec<u8>| IBig::from_le_bytes(&bytes);
        Fraction {
            above: integer(value.numerator().to_signed_bytes_le()),
            below: integer(value.denominator().to_signed_bytes_le()),
        }
    }
}

/// ℚ without a gcd: values are [`Fraction`]s, and equal denominators are recognised, because all
/// coordinates have the same.
struct Fractions;

impl Arithmetic for Fractions {
    type Value = Fraction;

    fn constant(&self, value: &Rational) -> Option<Fraction> {
        Some(Fraction::from(value))
    }

    fn add(&self, a: &Fraction, b: &Fraction) -> Fraction {
        if a.below == b.below {
            return Fraction { above: &a.above + &b.above, below: a.below.clone() };
        }
        Fraction { above: &a.above * &b.below + &b.above * &a.below, below: &a.below * &b.below }
    }

    fn subtract(&self, a: &Fraction, b: &Fraction) -> Fraction {
        self.add(a, &self.negate(b))
    }

    fn multiply(&self, a: &Fraction, b: &Fraction) -> Fraction {
        Fraction { above: &a.above * &b.above, below: &a.below * &b.below }
    }

    fn negate(&self, a: &Fraction) -> Fraction {
        Fraction { above: -&a.above, below: a.below.clone() }
    }

    fn divide(&self, a: &Fraction, b: &Fraction) -> Option<Fraction> {
        if self.is_zero(b) {
            return None;
        }
        // x/W over y/W is x/y.
        if a.below == b.below {
            return Some(Fraction { above: a.above.clone(), below: b.above.clone() });
        }
        Some(Fraction { above: &a.above * &b.below, below: &a.below * &b.above })
    }

    fn is_zero(&self, a: &Fraction) -> bool {
        a.above.is_zero()
    }
}
