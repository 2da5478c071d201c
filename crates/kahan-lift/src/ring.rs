//! The differential ring that the states and functions of the equations generate.
//!
//! Coordinates are the states and the functions in the equations, and in some rings frequent sums.
//! Derivatives of coordinates are Laurent polynomials in coordinates. Relations such as sin² = 1 −
//! cos² rewrite monomials to a normal form.

use std::sync::{Mutex, MutexGuard, PoisonError};

use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use rustc_hash::FxHashMap;

use crate::laurent::{Laurent, Monomial};

/// An elementary function whose derivative is a Laurent polynomial in coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// The exponential function exp u.
    Exp,
    /// The natural logarithm log u.
    Log,
    /// The sine sin u.
    Sin,
    /// The cosine cos u.
    Cos,
    /// The tangent tan u.
    Tan,
    /// The hyperbolic sine sinh u.
    Sinh,
    /// The hyperbolic cosine cosh u.
    Cosh,
    /// The hyperbolic tangent tanh u.
    Tanh,
    /// The inverse sine arcsin u.
    Asin,
    /// The inverse tangent arctan u.
    Atan,
    /// The inverse hyperbolic sine arsinh u.
    Asinh,
    /// The inverse hyperbolic cosine arcosh u.
    Acosh,
    /// The inverse hyperbolic tangent artanh u.
    Atanh,
}

type Value = fn(f64) -> f64;

const FUNCTIONS: [(&str, Value); 13] = [
    ("exp", libm::exp),
    ("log", libm::log),
    ("sin", libm::sin),
    ("cos", libm::cos),
    ("tan", libm::tan),
    ("sinh", libm::sinh),
    ("cosh", libm::cosh),
    ("tanh", libm::tanh),
    ("asin", libm::asin),
    ("atan", libm::atan),
    ("asinh", libm::asinh),
    ("acosh", libm::acosh),
    ("atanh", libm::atanh),
];

impl Function {
    /// Returns the name of the function in expressions.
    #[must_use]
    pub fn name(self) -> &'static str {
        FUNCTIONS[self as usize].0
    }

    pub(crate) fn at(self, argument: f64) -> f64 {
        FUNCTIONS[self as usize].1(argument)
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum CoordinateDefinition {
    State(usize),
    /// An elementary function of a polynomial in coordinates.
    Function(Function, Laurent),
    /// The n-th root of a polynomial, where n = 1 means the polynomial itself.
    Root(Laurent, i16),
    /// A power of a polynomial with an exponent that depends on parameters.
    Power(Laurent, RationalFunction),
    /// A sum of terms that becomes one variable. `with_frequent_sums` finds these sums.
    Sum(Laurent),
}

impl CoordinateDefinition {
    /// Returns the polynomial to which the function is applied.
    pub(crate) fn argument(&self) -> Option<&Laurent> {
        match self {
            CoordinateDefinition::State(_) => None,
            CoordinateDefinition::Function(_, inner)
            | CoordinateDefinition::Root(inner, _)
            | CoordinateDefinition::Power(inner, _)
            | CoordinateDefinition::Sum(inner) => Some(inner),
        }
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Coordinate {
    pub meaning: CoordinateDefinition,
    /// The derivative of the function with respect to its argument; 1 for a state.
    pub slope: Laurent,
}

/// A relation between coordinates that rewrites monomials.
#[derive(Clone, Debug)]
enum RewriteRule {
    /// The monomial is replaced by the polynomial.
    Replace(Monomial, Laurent),
    /// The coordinate b is a root with b^index = `base`. Exponents of b are kept below `index`.
    /// Beside a negative power of b, the monomial `leading` of `base` is replaced by `instead`.
    Root { coordinate: usize, index: i16, base: Laurent, leading: Monomial, instead: Laurent },
}

/// Coordinates with relations and derivatives. Products are in normal form.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ring {
    /// The coordinates, with the states first. Arguments contain only earlier coordinates.
    pub coordinates: Vec<Coordinate>,
    rules: Vec<RewriteRule>,
    pub field: Vec<Laurent>,
    pub parameters: usize,
    derivatives: PolynomialCache,
    normal: PolynomialCache,
}

/// A cache of polynomials that several threads may use. Cloning it gives an empty cache.
#[derive(Debug, Default)]
struct PolynomialCache(Mutex<FxHashMap<Monomial, Laurent>>);

impl PolynomialCache {
    fn known(&self) -> MutexGuard<'_, FxHashMap<Monomial, Laurent>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Clone for PolynomialCache {
    fn clone(&self) -> Self {
        PolynomialCache::default()
    }
}

/// Solves polynomial = value for the leading monomial of the polynomial.
fn solved(polynomial: &Laurent, value: Monomial) -> (Monomial, Laurent) {
    let (leading, factor) = polynomial.leading_term().expect("roots and sums have terms");
    let mut instead = Laurent::from(value);
    instead.add_scaled(&polynomial.filtered(|monomial| monomial != leading), &-&RationalFunction::one());
    (leading.clone(), instead.scale(&factor.recip().expect("coefficients are not 0")))
}

impl Ring {
    pub(crate) fn add(&mut self, meaning: CoordinateDefinition, slope: Laurent) -> usize {
        self.coordinates.push(Coordinate { meaning, slope });
        self.coordinates.len() - 1
    }

    pub(crate) fn find(&self, meaning: &CoordinateDefinition) -> Option<usize> {
        self.coordinates.iter().position(|known| known.meaning == *meaning)
    }

    /// Returns the index of the coordinate with this definition. A new coordinate is added; then
    /// `slope` is called with its index, and returns its time derivative.
    pub(crate) fn coordinate(
        &mut self,
        meaning: CoordinateDefinition,
        slope: impl FnOnce(usize) -> Laurent,
    ) -> usize {
        self.find(&meaning).unwrap_or_else(|| {
            let slope = slope(self.coordinates.len());
            self.add(meaning, slope)
        })
    }

    pub(crate) fn replace(&mut self, monomial: Monomial, polynomial: Laurent) {
        self.rules.push(RewriteRule::Replace(monomial, polynomial));
        self.clear_cache();
    }

    pub(crate) fn relate_root(&mut self, coordinate: usize, index: i16, base: &Laurent) {
        let (leading, instead) = solved(base, Monomial::power(coordinate, index));
        self.rules.push(RewriteRule::Root { coordinate, index, base: base.clone(), leading, instead });
        self.clear_cache();
    }

    pub(crate) fn set_field(&mut self, field: Vec<Laurent>) {
        self.field = field;
        self.derivatives.known().clear();
    }

    /// Returns the ring with frequent sums as further coordinates. Returns `None` if no sum is
    /// frequent.
    ///
    /// For each root of a polynomial, the frequent sums occur in its first three time derivatives.
    /// In Kepler's problem, the root r = |x| leads to x·p and p·p.
    pub(crate) fn with_frequent_sums(&self) -> Option<Self> {
        let mut ring = self.clone();
        let is_polynomial = |monomial: &Monomial| monomial.size() > 1 && monomial.is_in(self.field.len());
        let bases = self.coordinates.iter().filter_map(|coordinate| match &coordinate.meaning {
            CoordinateDefinition::Root(base, _) if base.len() > 1 => Some(base),
            _ => None,
        });
        for base in bases {
            let mut sum = base.clone();
            for _ in 0..3 {
                let derivative = ring.derivative(&sum).filtered(is_polynomial);
                sum = derivative.primitive().1;
                if !(2..=12).contains(&sum.len())
                    || ring.find(&CoordinateDefinition::Sum(sum.clone())).is_some()
                {
                    break;
                }
                let coordinate =
                    ring.add(CoordinateDefinition::Sum(sum.clone()), Laurent::number(Rational::one()));
                let (leading, instead) = solved(&sum, Monomial::power(coordinate, 1));
                ring.replace(leading, instead);
            }
        }
        let field = ring.field.iter().map(|side| ring.normalised(side)).collect();
        ring.set_field(field);
        (ring.coordinates.len() > self.coordinates.len()).then_some(ring)
    }

    fn clear_cache(&mut self) {
        self.derivatives.known().clear();
        self.normal.known().clear();
    }

    pub(crate) fn is_normal(&self, monomial: &Monomial) -> bool {
        self.rewritten(monomial).is_none()
    }

    /// Rewrites a monomial by one rule. Returns `None` if the monomial is in normal form.
    fn rewritten(&self, monomial: &Monomial) -> Option<Laurent> {
        self.rules.iter().find_map(|rule| match rule {
            RewriteRule::Replace(from, to) => {
                monomial.is_multiple_of(from).then(|| to.shifted(&monomial.over(from)))
            }
            RewriteRule::Root { coordinate, index, base, leading, instead } => {
                let exponent = monomial.exponent(*coordinate);
                let root = Monomial::power(*coordinate, *index);
                if exponent >= *index {
                    return Some(base.shifted(&monomial.over(&root)));
                }
                if leading.is_one() {
                    // For a root b with constant base c = b^index, b⁻¹ is b^(index−1)/c.
                    return (exponent < 0).then(|| {
                        let inverse = RationalFunction::one().checked_div(&base.coefficient(leading));
                        Laurent::from(monomial.times(&root)).scale(&inverse.expect("not 0"))
                    });
                }
                let single = base.len() == 1 && leading.size() == 1;
                if single && leading.powers().any(|(inner, _)| monomial.exponent(inner) < 0) {
                    let inverse = Laurent::from(monomial.times(leading).over(&root));
                    return Some(inverse.scale(&base.coefficient(leading)));
                }
                (exponent < 0 && monomial.is_multiple_of(leading))
                    .then(|| instead.shifted(&monomial.over(leading)))
            }
        })
    }

    pub(crate) fn normal_form(&self, monomial: &Monomial) -> Laurent {
        if let Some(known) = self.normal.known().get(monomial) {
            return known.clone();
        }
        let normal = match self.rewritten(monomial) {
            Some(polynomial) => self.normalised(&polynomial),
            None => Laurent::from(monomial.clone()),
        };
        self.normal.known().insert(monomial.clone(), normal.clone());
        normal
    }

    pub(crate) fn normalised(&self, polynomial: &Laurent) -> Laurent {
        let mut sum = Laurent::zero();
        for (monomial, coefficient) in polynomial.terms() {
            sum.add_scaled(&self.normal_form(monomial), coefficient);
        }
        sum
    }

    pub(crate) fn product(&self, left: &Laurent, right: &Laurent) -> Laurent {
        let mut product = Laurent::zero();
        for (monomial, coefficient) in left.terms() {
            product.add_scaled(&self.normalised(&right.shifted(monomial)), coefficient);
        }
        product
    }

    fn derivative_of_coordinate(&self, index: usize) -> Laurent {
        let Coordinate { meaning, slope } = &self.coordinates[index];
        match meaning.argument() {
            None => self.field.get(index).cloned().unwrap_or_default(),
            Some(argument) => self.product(slope, &self.derivative(argument)),
        }
    }

    /// Returns the derivative of a monomial along the field, in normal form.
    pub(crate) fn derivative_of(&self, monomial: &Monomial) -> Laurent {
        if let Some(known) = self.derivatives.known().get(monomial) {
            return known.clone();
        }
        let mut derivative = Laurent::zero();
        for (coordinate, exponent) in monomial.powers() {
            let lower = monomial.over(&Monomial::power(coordinate, 1));
            let inner = if monomial.size() == 1 && exponent == 1 {
                self.derivative_of_coordinate(coordinate)
            } else {
                self.derivative_of(&Monomial::power(coordinate, 1))
            };
            let factor = RationalFunction::constant(Rational::from(i64::from(exponent)));
            derivative.add_scaled(&self.normalised(&inner.shifted(&lower)), &factor);
        }
        self.derivatives.known().insert(monomial.clone(), derivative.clone());
        derivative
    }

    /// Returns the derivative of a polynomial along the field, in normal form.
    pub(crate) fn derivative(&self, polynomial: &Laurent) -> Laurent {
        let mut derivative = Laurent::zero();
        for (monomial, coefficient) in polynomial.terms() {
            derivative.add_scaled(&self.derivative_of(monomial), coefficient);
        }
        derivative
    }
}
