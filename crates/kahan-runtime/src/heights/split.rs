//! A faster step from long points at which gcd(Xᵢ, W) has most of the digits of W for some
//! coordinates Xᵢ.
//!
//! For the catalog's system E7, for example, x is a fraction of four digits while z has ten
//! thousand. Then some Xᵢ and W have a long common factor g: Xᵢ = g aᵢ, W = g b with short aᵢ and
//! b. A homogeneous polynomial N is Σ gʲ Nⱼ, where Nⱼ has degree j in the aᵢ and b.
//!
//! # Gain
//!
//! Few long products remain. The result is divided by the lowest power of g in all N, at no cost,
//! and by the gcd of g and the terms N₀, which for E7 is g up to a few digits.

use dashu_int::ops::{BitTest, DivRem, Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};
use kahan_algebra::plan::{Plan, plan_of};
use kahan_algebra::poly::Polynomial;

use super::integers::{bits, short_gcd, values};

/// The number of bits of W from which splitting pays.
const LEAST_SPLIT_BITS: usize = 1 << 12;

#[derive(Clone, Debug)]
pub(crate) struct Splits {
    forms: Vec<Polynomial>,
    /// The split that was used last, which usually applies to the next point, too.
    last: Option<Split>,
}

#[derive(Clone, Debug)]
struct Split {
    /// For each coordinate, W last: whether it is the common factor g times a short number.
    is_short: Vec<bool>,
    /// The plan that computes the nonzero Nⱼ in N = Σ gʲ Nⱼ, for one N of the map after another.
    plan: Plan,
    /// For each nonzero Nⱼ in N = Σ gʲ Nⱼ: j minus the exponent of g that is divided out.
    degrees: Vec<Vec<usize>>,
}

impl Splits {
    pub(crate) fn of(forms: Vec<Polynomial>) -> Self {
        Splits { forms, last: None }
    }

    /// Looks for a g with at least half of W's digits that divides W and some Xᵢ; `None` if there
    /// is none. Otherwise returns the image of the point, divided by common factors.
    pub(crate) fn apply(&mut self, point: &[IBig], factors: &[UBig]) -> Option<Vec<IBig>> {
        let size = point.last().map(bits).filter(|size| *size >= LEAST_SPLIT_BITS)?;
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
        // Only N₀ is divided by g with remainder, because the other terms gʲ Nⱼ are multiples of g.
        let divisor = IBig::from(g.clone());
        let divided =
            |(part, &j): (IBig, &usize)| if j == 0 { part.div_rem(&divisor) } else { (IBig::ZERO, part) };
        let degrees = || self.degrees.iter().flatten();
        let parts = values(&self.plan, &scaled).into_iter().zip(degrees());
        let parts: Vec<(IBig, IBig)> = parts.map(divided).collect();
        let lowest = parts.iter().zip(degrees()).filter(|(_, j)| **j == 0).map(|((_, rest), _)| rest);
        let content = lowest.fold(g.clone(), |content, rest| short_gcd(&content, &rest.unsigned_abs()));
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
