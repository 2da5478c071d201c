//! The differential ring that the equations span: coordinates, their derivatives along the field,
//! and the algebraic relations between them.
//!
//! Coordinates are the states and the functions that occur. The derivative of each is a Laurent
//! polynomial in the coordinates; relations rewrite monomials, such as sin² to 1 − cos².

use std::sync::{Mutex, MutexGuard, PoisonError};

use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use rustc_hash::FxHashMap;

use crate::laurent::{Laurent, Monomial};

/// An elementary function whose derivative is a Laurent polynomial in coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// exp u
    Exp,
    /// log u
    Log,
    /// sin u
    Sin,
    /// cos u
    Cos,
    /// tan u
    Tan,
    /// sinh u
    Sinh,
    /// cosh u
    Cosh,
    /// tanh u
    Tanh,
    /// arcsin u
    Asin,
    /// arctan u
    Atan,
    /// arsinh u
    Asinh,
    /// arcosh u
    Acosh,
    /// artanh u
    Atanh,
}

/// A function of floats.
type Value = fn(f64) -> f64;

/// Names and values of the functions, in the order of [`Function`].
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
    /// The name by which it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        FUNCTIONS[self as usize].0
    }

    /// The value at an argument.
    pub(crate) fn at(self, argument: f64) -> f64 {
        FUNCTIONS[self as usize].1(argument)
    }
}

/// The function that a coordinate stands for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Meaning {
    /// The state with this index.
    State(usize),
    /// A function of a polynomial in coordinates.
    Function(Function, Laurent),
    /// The root of a polynomial with this index; the polynomial itself where the index is 1.
    Root(Laurent, i16),
    /// A power of a polynomial whose exponent depends on parameters.
    Power(Laurent, RationalFunction),
    /// A sum that occurs often.
    Sum(Laurent),
}

impl Meaning {
    /// The polynomial that the function is applied to; none for a state.
    pub(crate) fn argument(&self) -> Option<&Laurent> {
        match self {
            Meaning::State(_) => None,
            Meaning::Function(_, inner)
            | Meaning::Root(inner, _)
            | Meaning::Power(inner, _)
            | Meaning::Sum(inner) => Some(inner),
        }
    }
}

/// A coordinate z = F(u).
#[derive(Clone, Debug)]
pub(crate) struct Coordinate {
    /// Its meaning.
    pub meaning: Meaning,
    /// F′(u) as a polynomial in coordinates; 1 for a state.
    pub slope: Laurent,
}

/// A relation between coordinates, as a rule that rewrites monomials.
#[derive(Clone, Debug)]
enum Rule {
    /// Multiples of the monomial are multiples of the polynomial.
    Replace(Monomial, Laurent),
    /// b^index = base, where `leading` of base, with the coefficient 1, is the first field: powers
    /// of b stay below the index, and beside negative powers of b no multiple of the leading
    /// monomial stands.
    Root { coordinate: usize, index: i16, base: Laurent, leading: Monomial, instead: Laurent },
}

/// Coordinates with their relations. Products of polynomials are in normal form.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ring {
    /// The coordinates; each argument contains earlier ones only. States come first.
    pub coordinates: Vec<Coordinate>,
    rules: Vec<Rule>,
    /// The derivatives of the states.
    pub field: Vec<Laurent>,
    /// The number of parameters.
    pub parameters: usize,
    derivatives: Memory,
    normal: Memory,
}

/// Polynomials of monomials that were computed before. Rings are shared between threads; a clone
/// begins empty, since most clones need few of them.
#[derive(Debug, Default)]
struct Memory(Mutex<FxHashMap<Monomial, Laurent>>);

impl Memory {
    fn known(&self) -> MutexGuard<'_, FxHashMap<Monomial, Laurent>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Clone for Memory {
    fn clone(&self) -> Self {
        Memory::default()
    }
}

/// The leading monomial of a polynomial with this value, and the polynomial that equals it.
fn solved(polynomial: &Laurent, value: Monomial) -> (Monomial, Laurent) {
    let (leading, factor) = polynomial.leading_term().expect("roots and sums have terms");
    let mut instead = Laurent::from(value);
    instead.add_scaled(&polynomial.filtered(|monomial| monomial != leading), &-&RationalFunction::one());
    (leading.clone(), instead.scale(&factor.recip().expect("coefficients are not 0")))
}

impl Ring {
    /// Adds a coordinate.
    pub(crate) fn add(&mut self, meaning: Meaning, slope: Laurent) -> usize {
        self.coordinates.push(Coordinate { meaning, slope });
        self.coordinates.len() - 1
    }

    /// The coordinate with this meaning.
    pub(crate) fn find(&self, meaning: &Meaning) -> Option<usize> {
        self.coordinates.iter().position(|known| known.meaning == *meaning)
    }

    /// The coordinate with this meaning. Where it is new, `slope` gives F′(u) by its number.
    pub(crate) fn coordinate(&mut self, meaning: Meaning, slope: impl FnOnce(usize) -> Laurent) -> usize {
        self.find(&meaning).unwrap_or_else(|| {
            let slope = slope(self.coordinates.len());
            self.add(meaning, slope)
        })
    }

    /// Adds the relation monomial = polynomial.
    pub(crate) fn replace(&mut self, monomial: Monomial, polynomial: Laurent) {
        self.rules.push(Rule::Replace(monomial, polynomial));
        self.forget();
    }

    /// Adds the relation b^index = base.
    pub(crate) fn relate_root(&mut self, coordinate: usize, index: i16, base: &Laurent) {
        let (leading, instead) = solved(base, Monomial::power(coordinate, index));
        self.rules.push(Rule::Root { coordinate, index, base: base.clone(), leading, instead });
        self.forget();
    }

    /// Sets the derivatives of the states.
    pub(crate) fn set_field(&mut self, field: Vec<Laurent>) {
        self.field = field;
        self.derivatives.known().clear();
    }

    /// The ring with sums that occur in derivatives as coordinates: for the base P of each root,
    /// the parts of P′, P″ and P‴ that are polynomials in the states. Kepler's problem becomes one
    /// in r, x·p and p·p. `None` if no derivative has such a part.
    pub(crate) fn grouped(&self) -> Option<Self> {
        let mut ring = self.clone();
        let is_polynomial = |monomial: &Monomial| monomial.size() > 1 && monomial.is_in(self.field.len());
        let bases = self.coordinates.iter().filter_map(|coordinate| match &coordinate.meaning {
            Meaning::Root(base, _) if base.len() > 1 => Some(base),
            _ => None,
        });
        for base in bases {
            let mut sum = base.clone();
            for _ in 0..3 {
                let derivative = ring.derivative(&sum).filtered(is_polynomial);
                sum = derivative.primitive().1;
                if !(2..=12).contains(&sum.len()) || ring.find(&Meaning::Sum(sum.clone())).is_some() {
                    break;
                }
                let coordinate = ring.add(Meaning::Sum(sum.clone()), Laurent::number(Rational::one()));
                let (leading, instead) = solved(&sum, Monomial::power(coordinate, 1));
                ring.replace(leading, instead);
            }
        }
        let field = ring.field.iter().map(|side| ring.normalised(side)).collect();
        ring.set_field(field);
        (ring.coordinates.len() > self.coordinates.len()).then_some(ring)
    }

    fn forget(&mut self) {
        self.derivatives.known().clear();
        self.normal.known().clear();
    }

    /// Whether no relation rewrites the monomial.
    pub(crate) fn is_normal(&self, monomial: &Monomial) -> bool {
        self.rewritten(monomial).is_none()
    }

    /// Rewrites a monomial by one rule; `None` if it is in normal form.
    fn rewritten(&self, monomial: &Monomial) -> Option<Laurent> {
        self.rules.iter().find_map(|rule| match rule {
            Rule::Replace(from, to) => {
                monomial.is_multiple_of(from).then(|| to.shifted(&monomial.over(from)))
            }
            Rule::Root { coordinate, index, base, leading, instead } => {
                let exponent = monomial.exponent(*coordinate);
                let root = Monomial::power(*coordinate, *index);
                if exponent >= *index {
                    return Some(base.shifted(&monomial.over(&root)));
                }
                if leading.is_one() {
                    // The base is a constant c: b^−1 = b^(index−1)/c.
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

    /// The normal form of a monomial.
    pub(crate) fn normal(&self, monomial: &Monomial) -> Laurent {
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

    /// The normal form of a polynomial.
    pub(crate) fn normalised(&self, polynomial: &Laurent) -> Laurent {
        let mut sum = Laurent::zero();
        for (monomial, coefficient) in polynomial.terms() {
            sum.add_scaled(&self.normal(monomial), coefficient);
        }
        sum
    }

    /// The product, in normal form.
    pub(crate) fn product(&self, left: &Laurent, right: &Laurent) -> Laurent {
        let mut product = Laurent::zero();
        for (monomial, coefficient) in left.terms() {
            product.add_scaled(&self.normalised(&right.shifted(monomial)), coefficient);
        }
        product
    }

    /// The derivative of a coordinate along the field.
    fn derivative_of_coordinate(&self, index: usize) -> Laurent {
        let Coordinate { meaning, slope } = &self.coordinates[index];
        match meaning.argument() {
            None => self.field.get(index).cloned().unwrap_or_default(),
            Some(argument) => self.product(slope, &self.derivative(argument)),
        }
    }

    /// The derivative of a monomial along the field, in normal form.
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

    /// The derivative of a polynomial along the field, in normal form.
    pub(crate) fn derivative(&self, polynomial: &Laurent) -> Laurent {
        let mut derivative = Laurent::zero();
        for (monomial, coefficient) in polynomial.terms() {
            derivative.add_scaled(&self.derivative_of(monomial), coefficient);
        }
        derivative
    }
}
