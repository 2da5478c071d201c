//! A step from a point some of whose coordinates share most of W.
//!
//! Where a component is a short fraction beside long ones (x of dE7 has four digits, z ten
//! thousand), its Xᵢ and W are a long common factor g times short numbers: Xᵢ = g aᵢ, W = g b. A
//! form N of degree d is then Σ gʲ Nⱼ(a, b, the other coordinates), Nⱼ the part of degree j in the
//! short ones: a few long products are left of it, and the least j of all forms is divided out for
//! nothing.
//!
//! After that every part is a multiple of g but those of degree 0, so what these share with g is
//! content too. For dE7 they are multiples of y², whose denominator squared is nearly all of W: but
//! for a few digits g is content, and the gcd that finds it is quick, because Euclid's algorithm
//! ends after as many steps as the quotients by the gcd have digits.

use dashu_int::ops::{BitTest, DivRem, Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};
use kahan_algebra::plan::{Plan, plan_of};
use kahan_algebra::poly::Polynomial;

use super::integers::{bits, short_gcd, values};

/// Below this many bits of W a split gains nothing.
const LONG: usize = 1 << 12;

/// The forms of a map, and what is known of their splits.
#[derive(Clone, Debug)]
pub(crate) struct Splits {
    /// N₁ … N_n, D.
    forms: Vec<Polynomial>,
    /// The split that was used last: an orbit changes it seldom.
    last: Option<Split>,
}

#[derive(Clone, Debug)]
struct Split {
    /// Which coordinates are short multiples of g, W among them.
    is_short: Vec<bool>,
    /// The nonzero parts of all forms, one form after the other.
    plan: Plan,
    /// The degree in the short coordinates of each part, less the least degree of all; form by
    /// form.
    degrees: Vec<Vec<usize>>,
}

impl Splits {
    /// Nothing is split before it is asked for.
    pub(crate) fn of(forms: Vec<Polynomial>) -> Self {
        Splits { forms, last: None }
    }

    /// The image of a point, its content in part divided out; `None` where no component is short.
    pub(crate) fn apply(&mut self, point: &[IBig], factors: &[UBig]) -> Option<Vec<IBig>> {
        let size = point.last().map(bits).filter(|size| *size >= LONG)?;
        let mut is_short: Vec<bool> = factors.iter().map(|factor| 4 * factor.bit_len() >= 3 * size).collect();
        let shared = factors.iter().zip(&is_short).filter(|(_, short)| **short).map(|(factor, _)| factor);
        let g = shared.cloned().reduce(Gcd::gcd).filter(|g| 2 * g.bit_len() >= size)?;
        is_short.push(true);
        if self.last.as_ref().is_none_or(|split| split.is_short != is_short) {
            self.last = Some(Split::of(&self.forms, is_short));
        }
        self.last.as_ref().map(|split| split.apply(point, &g))
    }
}

impl Split {
    fn of(forms: &[Polynomial], is_short: Vec<bool>) -> Self {
        let degree_of = |form: &Polynomial, degree: u32| {
            let part = form.terms().filter(|(monomial, _)| {
                monomial.degree_where(|variable| is_short[usize::from(variable.0)]) == degree
            });
            Polynomial::from_terms(
                part.map(|(monomial, coefficient)| (monomial.clone(), coefficient.clone())),
            )
        };
        let (mut parts, mut degrees) = (Vec::new(), Vec::new());
        for form in forms {
            let of_form = (0..=form.degree()).map(|degree| (degree as usize, degree_of(form, degree)));
            let (present, mut polynomials): (Vec<usize>, Vec<Polynomial>) =
                of_form.filter(|(_, part)| !part.is_zero()).unzip();
            degrees.push(present);
            parts.append(&mut polynomials);
        }
        let least = degrees.iter().flatten().copied().min().unwrap_or(0);
        degrees.iter_mut().flatten().for_each(|degree| *degree -= least);
        Split { is_short, plan: plan_of(&parts), degrees }
    }

    fn apply(&self, point: &[IBig], g: &UBig) -> Vec<IBig> {
        let scaled: Vec<IBig> = point
            .iter()
            .zip(&self.is_short)
            .map(|(x, short)| if *short { x / g } else { x.clone() })
            .collect();
        // The quotients by g of the parts of degree 0, and the remainders; all else remains of the
        // others.
        let divisor = IBig::from(g.clone());
        let divided =
            |(part, &j): (IBig, &usize)| if j == 0 { part.div_rem(&divisor) } else { (IBig::ZERO, part) };
        let degrees = || self.degrees.iter().flatten();
        let parts = values(&self.plan, &scaled).into_iter().zip(degrees());
        let parts: Vec<(IBig, IBig)> = parts.map(divided).collect();
        let lowest = parts.iter().zip(degrees()).filter(|(_, j)| **j == 0).map(|((_, rest), _)| rest);
        let content = lowest.fold(g.clone(), |content, rest| short_gcd(&content, &rest.unsigned_abs()));
        // gʲ/content for j > 0.
        let highest = degrees().copied().max().unwrap_or(0).max(1);
        let powers = std::iter::successors(Some(g / &content), |power| Some(power * g));
        let powers: Vec<UBig> = powers.take(highest).collect();
        let share = |(&j, (quotient, rest)): (&usize, (IBig, IBig))| {
            if j == 0 { quotient * &powers[0] + rest / &content } else { rest * &powers[j - 1] }
        };
        let mut parts = parts.into_iter();
        let form = |degrees: &Vec<usize>| degrees.iter().zip(parts.by_ref()).map(share).sum();
        self.degrees.iter().map(form).collect()
    }
}
