//! Double-double arithmetic in the instructions of doubles: the operations of
//! [`Dd`](kahan_core::Dd) in their order, where nothing overflows or underflows.
//!
//! What would have to be computed otherwise is not branched upon but noted: every operation that
//! looks at the size of a number adds to a guard, which is 0 as long as all sizes were moderate and
//! not a number from the first one on that was not. Whoever runs the program looks at the guard
//! now and then, and steps again by other means where it is not 0.

use std::cell::RefCell;

use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::rational::Rational;
use kahan_jit::Instruction::*;

use super::recorder::Recorder;

/// A number as the instructions of its two parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub(super) high: usize,
    pub(super) low: usize,
}

/// Double-double arithmetic over the instructions of doubles.
#[derive(Debug)]
pub(super) struct DoubleDouble<'a> {
    base: &'a Recorder,
    /// Whether multiply-adds are fused, which decides how the error of a product is found.
    fuses: bool,
    /// What the guard is the sum of.
    notes: RefCell<Vec<usize>>,
    /// Leading parts that are known to be neither large nor small.
    moderate: RefCell<Vec<usize>>,
}

/// A divisor between 2^−DIVISORS and 2^DIVISORS is taken for one that leaves room for everything.
const DIVISORS: i32 = 400;

/// 2^exponent
fn power_of_two(exponent: i32) -> f64 {
    f64::exp2(f64::from(exponent))
}

impl<'a> DoubleDouble<'a> {
    /// The arithmetic that writes into a program.
    pub(super) fn new(base: &'a Recorder, fuses: bool) -> Self {
        DoubleDouble { base, fuses, notes: RefCell::default(), moderate: RefCell::default() }
    }

    /// A guard that was 0 before, after everything that was written.
    pub(super) fn guarded(&self, guard: usize) -> usize {
        // The sum of a step's notes does not wait for the step before.
        let notes = self.notes.borrow();
        match notes.iter().copied().reduce(|a, b| self.add(a, b)) {
            Some(sum) => self.add(guard, sum),
            None => guard,
        }
    }

    /// Notes 0 where |a|·2^exponent is finite, and else what is not a number.
    fn note_below(&self, a: usize, exponent: i32) {
        let grown = self.multiply(a, self.number(power_of_two(exponent)));
        self.notes.borrow_mut().push(self.multiply(grown, self.number(0.0)));
    }

    /// Notes whether a is too large or too small to be divided, or to be divided by; `inverse` is
    /// near 1/a.
    fn note_moderate(&self, a: usize, inverse: usize) {
        self.note_below(a, 1024 - DIVISORS);
        self.note_below(inverse, 1024 - DIVISORS);
    }

    fn number(&self, value: f64) -> usize {
        self.base.push(Literal(value))
    }

    fn add(&self, a: usize, b: usize) -> usize {
        self.base.push(Add(a, b))
    }

    fn subtract(&self, a: usize, b: usize) -> usize {
        self.base.push(Subtract(a, b))
    }

    fn multiply(&self, a: usize, b: usize) -> usize {
        self.base.push(Multiply(a, b))
    }

    /// a·b + c, rounded once where that is one instruction.
    fn multiply_add(&self, a: usize, b: usize, c: usize) -> usize {
        self.base.push(MultiplyAdd(a, b, c))
    }

    /// a + b and its error (Knuth).
    fn two_sum(&self, a: usize, b: usize) -> (usize, usize) {
        let sum = self.add(a, b);
        let from_a = self.subtract(sum, b);
        let from_b = self.subtract(sum, from_a);
        (sum, self.add(self.subtract(a, from_a), self.subtract(b, from_b)))
    }

    /// The same where |a| ≥ |b| (Dekker).
    fn fast_two_sum(&self, a: usize, b: usize) -> Pair {
        let high = self.add(a, b);
        Pair { high, low: self.subtract(b, self.subtract(high, a)) }
    }

    /// a·b and its error: by one fused operation, or by halves (Dekker).
    fn two_product(&self, a: usize, b: usize) -> (usize, usize) {
        let product = self.multiply(a, b);
        if self.fuses {
            return (product, self.base.push(MultiplySubtract(a, b, product)));
        }
        let ((a_high, a_low), (b_high, b_low)) = (self.split(a), self.split(b));
        let left = self.subtract(self.multiply(a_high, b_high), product);
        let left = self.add(left, self.multiply(a_high, b_low));
        let left = self.add(left, self.multiply(a_low, b_high));
        (product, self.add(left, self.multiply(a_low, b_low)))
    }

    /// Two floats of 26 bits with the sum a (Veltkamp); a beyond 2⁹⁹⁵ is noted.
    fn split(&self, a: usize) -> (usize, usize) {
        self.note_below(a, 1024 - 995);
        let spread = self.multiply(self.number(power_of_two(27) + 1.0), a);
        let high = self.subtract(spread, self.subtract(spread, a));
        (high, self.subtract(a, high))
    }

    /// whole − a·b, where that is a float.
    fn remainder(&self, whole: usize, a: usize, b: usize) -> usize {
        if self.fuses {
            return self.base.push(SubtractProduct(whole, a, b));
        }
        let (product, error) = self.two_product(a, b);
        self.subtract(self.subtract(whole, product), error)
    }

    /// A leading sum or product leaves room for what is added to it: else it is noted.
    fn leaves_room(&self, leading: usize) {
        self.note_below(leading, 1024 - 1022);
    }

    fn opposite(&self, a: Pair) -> Pair {
        Pair { high: self.base.push(Negate(a.high)), low: self.base.push(Negate(a.low)) }
    }

    /// x·y + z
    fn product_plus(&self, x: Pair, y: Pair, z: Pair) -> Pair {
        let (leading, product_error) = self.two_product(x.high, y.high);
        let (sum, sum_error) = self.two_sum(leading, z.high);
        self.leaves_room(sum);
        let lower = self.multiply_add(x.low, y.high, self.multiply_add(x.high, y.low, z.low));
        self.fast_two_sum(sum, self.add(sum_error, self.add(product_error, lower)))
    }
}

impl Arithmetic for DoubleDouble<'_> {
    type Value = Pair;

    fn constant(&self, value: &Rational) -> Option<Pair> {
        let (high, low) = value.to_double_double();
        Some(Pair { high: self.number(high), low: self.number(low) })
    }

    fn add(&self, a: &Pair, b: &Pair) -> Pair {
        let (leading, error) = self.two_sum(a.high, b.high);
        self.leaves_room(leading);
        let (lower, rest) = self.two_sum(a.low, b.low);
        let Pair { high, low } = self.fast_two_sum(leading, self.add(error, lower));
        self.fast_two_sum(high, self.add(rest, low))
    }

    fn subtract(&self, a: &Pair, b: &Pair) -> Pair {
        Arithmetic::add(self, a, &self.opposite(*b))
    }

    fn multiply(&self, a: &Pair, b: &Pair) -> Pair {
        let (leading, error) = self.two_product(a.high, b.high);
        self.leaves_room(leading);
        let lower = self.multiply_add(a.low, b.high, self.multiply(a.high, b.low));
        self.fast_two_sum(leading, self.add(error, lower))
    }

    fn negate(&self, a: &Pair) -> Pair {
        self.opposite(*a)
    }

    fn divide(&self, a: &Pair, b: &Pair) -> Option<Pair> {
        let leading = self.base.push(Divide(a.high, b.high));
        let reciprocal = self.base.push(Divide(self.number(1.0), b.high));
        self.note_moderate(b.high, reciprocal);
        let is_ordinary = self.base.literal(a.high).is_some_and(|value| {
            // So that the quotient can be divided once more.
            (power_of_two(-40)..power_of_two(40)).contains(&value.abs())
        });
        if is_ordinary {
            self.moderate.borrow_mut().push(leading);
        } else if !self.moderate.borrow().contains(&a.high) {
            self.note_moderate(a.high, self.base.push(Divide(self.number(1.0), a.high)));
        }
        let correction = self.base.push(SubtractProduct(a.low, leading, b.low));
        let remainder = self.add(self.remainder(a.high, leading, b.high), correction);
        Some(self.fast_two_sum(leading, self.multiply(remainder, reciprocal)))
    }

    fn multiply_add(&self, a: &Pair, b: &Pair, c: &Pair) -> Pair {
        self.product_plus(*a, *b, *c)
    }

    fn multiply_subtract(&self, a: &Pair, b: &Pair, c: &Pair) -> Pair {
        self.product_plus(*a, *b, self.opposite(*c))
    }

    fn subtract_product(&self, a: &Pair, b: &Pair, c: &Pair) -> Pair {
        self.product_plus(self.opposite(*b), *c, *a)
    }

    fn is_zero(&self, _: &Pair) -> bool {
        false
    }
}
