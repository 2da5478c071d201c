//! Seeded random fields as trees, for `kahan extremes` and for tests of generated code.
//!
//! Fields may be sparse or dense, and have linear and constant terms, parameters as factors and
//! divisors, and awkward spellings.

mod draw;
pub(crate) mod odd;
mod tree;

use Tree::{Name, Product, Sum};
use draw::{COLLIDING_STATE_NAMES, PLAIN_STATE_NAMES};
pub use draw::{DIMENSIONS, Draw};
pub use tree::Tree;
use tree::{literal, negated, power, quotient};

const PARAMETERS: [&str; 3] = ["a", "b", "k"];

/// A random field with the names of its states and parameters.
#[derive(Clone, Debug)]
pub struct RandomField {
    /// The name of the generated type.
    pub name: String,
    /// The kind of the field in words.
    pub kind: &'static str,
    /// The names of the states, in order.
    pub states: Vec<&'static str>,
    /// The names of the parameters.
    pub parameters: Vec<&'static str>,
    /// The right-hand sides, one for each state.
    pub equations: Vec<Tree>,
}

/// A generator of fields with a given number of variables, at most [`DIMENSIONS`].
pub type FieldGenerator = fn(usize, &mut Draw) -> RandomField;

/// The kinds of fields that [`numbered`] draws in turn.
const ALL_KINDS: [FieldGenerator; 7] = [sparse, coupled, affine, scaled, spelled, coupled, dense];

/// Draws the field with this number. Successive numbers cycle through 2 to 6 variables and through
/// the kinds.
#[must_use]
pub fn numbered(seed: u64, number: usize) -> RandomField {
    let n = 2 + number % (DIMENSIONS - 1);
    let make = ALL_KINDS[number / (DIMENSIONS - 1) % ALL_KINDS.len()];
    let field = make(n, &mut Draw::seeded(&format!("{seed} {number}")));
    RandomField { name: format!("{}_{number}", field.name), ..field }
}

fn field(
    title: &str,
    kind: &'static str,
    states: &[&'static str],
    equations: Vec<Tree>,
    parameters: &[&'static str],
) -> RandomField {
    let name = format!("{title}{}", states.len());
    RandomField { name, kind, states: states.to_vec(), parameters: parameters.to_vec(), equations }
}

/// Draws a field with one or two quadratic terms in each equation.
pub fn sparse(n: usize, draw: &mut Draw) -> RandomField {
    let states = &PLAIN_STATE_NAMES[..n];
    let equation = |draw: &mut Draw| {
        let terms = draw.below(2) + 1;
        Sum((0..terms)
            .map(|_| Product(vec![draw.coefficient(), draw.state(states), draw.state(states)]))
            .collect())
    };
    let equations = (0..n).map(|_| equation(draw)).collect();
    field("Sparse", "one or two quadratic terms an equation", states, equations, &[])
}

/// Draws fields with constant, linear and quadratic terms.
pub fn affine(n: usize, draw: &mut Draw) -> RandomField {
    let states = &PLAIN_STATE_NAMES[..n];
    let equation = |draw: &mut Draw| {
        Sum(vec![
            draw.coefficient(),
            Product(vec![draw.coefficient(), draw.state(states)]),
            Product(vec![draw.coefficient(), draw.state(states), draw.state(states)]),
            Product(vec![draw.coefficient(), draw.state(states)]),
        ])
    };
    let equations = (0..n).map(|_| equation(draw)).collect();
    field("Affine", "constant, linear and quadratic terms", states, equations, &[])
}

/// Draws fields with parameters as factors and in divisors.
pub fn scaled(n: usize, draw: &mut Draw) -> RandomField {
    let states = &PLAIN_STATE_NAMES[..n];
    let (a, b, k) = (|| Name("a"), || Name("b"), || Name("k"));
    let factors = [
        a(),
        negated(b()),
        Product(vec![a(), b()]),
        quotient(literal("1"), Sum(vec![a(), negated(b())])),
        quotient(b(), Sum(vec![literal("1"), power(k(), 2)])),
        quotient(Sum(vec![a(), negated(k())]), Product(vec![literal("3"), k()])),
    ];
    let mut equation = |i: usize| {
        let mut terms = vec![
            Product(vec![draw.choose(&factors).clone(), draw.state(states), draw.state(states)]),
            quotient(Product(vec![draw.state(states), draw.choose(&factors).clone()]), k()),
        ];
        if i == 0 {
            terms.push(Sum(vec![a(), negated(b())]));
        }
        Sum(terms)
    };
    let equations = (0..n).map(&mut equation).collect();
    field("Scaled", "parameters, and divisors of them", states, equations, &PARAMETERS)
}

/// Draws a field with coefficients ±1 and parameters. Terms of det A cancel at parameters ±1.
fn coupled(n: usize, draw: &mut Draw) -> RandomField {
    let states = &PLAIN_STATE_NAMES[..n];
    let sign = |draw: &mut Draw, term: Tree| if draw.below(2) == 0 { term } else { negated(term) };
    let mut equation = |i: usize| {
        let own = Product(vec![Name(PARAMETERS[draw.below(2)]), draw.state(states)]);
        let square = Product(vec![draw.state(states), draw.state(states)]);
        let mut terms = vec![sign(draw, own), sign(draw, Name(states[i])), sign(draw, square)];
        // For n > 4 one of these terms is kept, so that closed forms stay short.
        if n > 4 {
            terms = vec![terms.swap_remove((draw.below(2) + i) % 3)];
        }
        if i == 0 {
            let difference = Sum(vec![Name("a"), negated(Name("b"))]);
            terms.push(Product(vec![difference, draw.state(states)]));
        }
        Sum(terms)
    };
    let equations = (0..n).map(&mut equation).collect();
    field("Coupled", "parameters before unit terms", states, equations, &PARAMETERS[..2])
}

/// Draws fields that are written in unusual ways, with cubic terms that cancel.
pub fn spelled(n: usize, draw: &mut Draw) -> RandomField {
    let states = &COLLIDING_STATE_NAMES[..n];
    let start = draw.below(n);
    let equation = |i: usize| {
        let state = |k: usize| Name(states[(start + i + k) % n]);
        let (x, y, z) = (state(0), state(1), state(2));
        let first = match (i + 2 * n) % 5 {
            0 => negated(power(x.clone(), 2)),
            1 => Product(vec![x.clone(), power(Sum(vec![y.clone(), negated(z.clone())]), 1)]),
            2 => {
                quotient(power(Sum(vec![x.clone(), Product(vec![literal("2"), y.clone()])]), 2), literal("3"))
            }
            3 => Product(vec![Sum(vec![x.clone(), y.clone()]), Sum(vec![x.clone(), negated(y.clone())])]),
            _ => negated(negated(Product(vec![x.clone(), literal("0.1"), y.clone()]))),
        };
        let second = match (i + n) % 4 {
            0 => Product(vec![literal("1.5e-3"), z.clone()]),
            1 => Product(vec![literal("12.50"), power(y.clone(), 0)]),
            2 => negated(quotient(Product(vec![z.clone(), literal("1e2")]), literal("0.7"))),
            _ => quotient(literal("1_000"), literal("3")),
        };
        let cubic = Product(vec![power(x.clone(), 2), y.clone()]);
        let again = negated(Product(vec![x.clone(), y, x]));
        Sum(vec![first, cubic, second, again])
    };
    let equations = (0..n).map(equation).collect();
    field("Spelled", "awkward spellings, and cubic terms that cancel", states, equations, &[])
}

/// Draws fields in which every equation has every monomial.
pub fn dense(n: usize, draw: &mut Draw) -> RandomField {
    let states = &PLAIN_STATE_NAMES[..n];
    let mut equation = || {
        let mut terms = vec![draw.coefficient()];
        for i in 0..n {
            terms.push(Product(vec![draw.coefficient(), Name(states[i])]));
            for state in &states[i..] {
                terms.push(Product(vec![draw.coefficient(), Name(states[i]), Name(state)]));
            }
        }
        Sum(terms)
    };
    let equations = (0..n).map(|_| equation()).collect();
    field("Dense", "every monomial in every equation", states, equations, &[])
}

impl RandomField {
    /// Returns the equations as text, separated by spaces.
    #[must_use]
    pub fn equations(&self) -> String {
        let equations = self.states.iter().zip(&self.equations);
        equations.map(|(state, value)| format!("{state}dot = {value};")).collect::<Vec<_>>().join(" ")
    }

    /// Returns the block in the language of `kahan!`.
    #[must_use]
    pub fn block(&self) -> String {
        let header = header(&self.name, &self.parameters);
        let documentation = format!("/// Of dimension {}: {}.\n", self.states.len(), self.kind);
        let equations = self.states.iter().zip(&self.equations);
        let equations: String = equations.map(|(state, value)| format!("{state}dot = {value};\n")).collect();
        format!("{documentation}{header}\n{equations}")
    }
}

fn header(name: &str, parameters: &[&str]) -> String {
    match parameters {
        [] => format!("pub struct {name};"),
        parameters => format!("pub struct {name} {{ {} }}", parameters.join(", ")),
    }
}
