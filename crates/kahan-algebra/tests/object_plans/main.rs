//! Evaluates the plans of all objects in exact arithmetic, and compares the results with the
//! defining formulas. A printed step is also parsed and evaluated.

mod digits;
mod written;

use std::collections::BTreeMap;

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::derived::StepListing;
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::lexer::lex;
use kahan_algebra::plan::{Operation, Plan, StepPlan};
use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;
use kahan_algebra::{Derived, derive, read};

use written::Written;

const SYSTEMS: [&str; 6] = [
    "xdot = x*(1 - y); ydot = y*(x - 1);",
    "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;
     integral H = y/x; integral K = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
     density rho = 2/(x*y*(x^2 + y^2 + z^2));
     bracket P { {y,z} = y*(1 + eps^2*(x^2 + y^2)); {z,x} = -x*(1 + eps^2*(x^2 + y^2)); }",
    "struct S { s, r, b } xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z;",
    "struct S { m } xdot = x*y/m; ydot = (x^2 - y)/(1 + m) + 1/3; zdot = x*z;",
    "struct S { u, v, w } adot = (w - v)*y*z; bdot = (u - w)*z*x; cdot = (v - u)*x*y;
     xdot = y*c - z*b; ydot = z*a - x*c; zdot = x*b - y*a;",
    "struct S { a } xdot = a*x; bydot = by^2;
     drift F = 1/by by F - 2*eps; drift G = x^2 by ((1 + a*eps)/(1 - a*eps))^2*G;",
];

fn system(text: &str) -> System {
    let reading = read(&lex(text).tokens);
    assert!(reading.diagnostics().is_empty(), "{text}: {:?}", reading.diagnostics());
    reading.system().expect("a system")
}

fn places(system: &System) -> [Place; 2] {
    [1, -1].map(|sign| {
        let n = system.field.dimension() as i64;
        let number = |p: i64, d: i64| Rational::new(sign * p, d);
        let parameters = 0..system.field.symbols.parameters.len() as i64;
        Place {
            point: Point {
                state: (0..n).map(|i| number(2 * i + 3, i + 2)).collect(),
                parameters: parameters.map(|k| number(k + 4 - sign, 3)).collect(),
                eps: number(1, 7),
            },
            second: (0..n).map(|i| number(5 - 3 * i, 4)).collect(),
        }
    })
}

/// A test point x, and a second point y for the bilinear form Q(x,y).
struct Place {
    point: Point<Rational>,
    second: Vec<Rational>,
}

impl Place {
    /// Returns the outputs of a plan. The values of its precomputed constants are `prepared`.
    fn run(&self, plan: &Plan, symbols: &Symbols, prepared: &[Rational]) -> Vec<Option<Rational>> {
        let prepared: Vec<Option<Rational>> = prepared.iter().cloned().map(Some).collect();
        let value = |variable| {
            Some(match symbols.symbol(variable) {
                Symbol::State(i) => self.point.state[i].clone(),
                Symbol::Parameter(k) => self.point.parameters[k].clone(),
                Symbol::Epsilon => self.point.eps.clone(),
                Symbol::SecondState(i) => self.second[i].clone(),
            })
        };
        plan.evaluate(&Exact, |input| input.value(&prepared, value))
    }

    fn polynomial(&self, polynomial: &Polynomial) -> Rational {
        let all = self.point.state.iter().chain(&self.point.parameters).chain([&self.point.eps]);
        let values: Vec<&Rational> = all.collect();
        polynomial.terms().fold(Rational::zero(), |sum, (monomial, coefficient)| {
            let powers = monomial.powers().iter().map(|&(variable, exponent)| {
                values[usize::from(variable.0)].pow(exponent as i32).expect("the exponent is positive")
            });
            &sum + &powers.fold(coefficient.clone(), |product, power| &product * &power)
        })
    }
}

fn combination(terms: &[(Rational, &[Rational])]) -> Vec<Rational> {
    let entry =
        |i: usize| terms.iter().fold(Rational::zero(), |sum, (factor, vector)| &sum + &(factor * &vector[i]));
    (0..terms[0].1.len()).map(entry).collect()
}

/// Solves M X = R by elimination. Returns the columns of X and det M.
fn solved(matrix: &[Vec<Rational>], right: &[Vec<Rational>]) -> (Vec<Vec<Rational>>, Rational) {
    let n = matrix.len();
    let rows = matrix.iter().zip(right);
    let mut rows: Vec<Vec<Rational>> = rows.map(|(row, right)| [row.as_slice(), right].concat()).collect();
    let mut determinant = Rational::one();
    for k in 0..n {
        let pivot = (k..n).find(|&i| !rows[i][k].is_zero()).expect("the matrix is invertible here");
        if pivot != k {
            rows.swap(pivot, k);
            determinant = -determinant;
        }
        determinant = &determinant * &rows[k][k];
        let pivot = combination(&[(rows[k][k].recip().expect("not zero"), &rows[k])]);
        rows[k] = pivot.clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = -row[k].clone();
            *row = combination(&[(Rational::one(), row), (factor, &pivot)]);
        }
    }
    (rows.into_iter().map(|row| row[n..].to_vec()).collect(), determinant)
}

/// Computes the objects by their definitions. Because f is quadratic, differences give exact
/// derivatives.
struct Definitions<'a> {
    written: &'a Written,
    place: &'a Place,
}

impl Definitions<'_> {
    fn field(&self, x: &[Rational]) -> Vec<Rational> {
        let point = Point { state: x.to_vec(), ..self.place.point.clone() };
        self.written.field(&Exact, &point).expect("the field has a value")
    }

    fn origin(&self) -> Vec<Rational> {
        vec![Rational::zero(); self.place.point.state.len()]
    }

    /// Returns f′(x). Column j is (f(x + e) − f(x − e))/2 with the unit vector e of xⱼ.
    fn slopes(&self, x: &[Rational]) -> Vec<Vec<Rational>> {
        let n = x.len();
        let columns: Vec<Vec<Rational>> = (0..n)
            .map(|j| {
                let moved = |by: i64| {
                    let mut moved = x.to_vec();
                    moved[j] = &moved[j] + &Rational::from(by);
                    self.field(&moved)
                };
                combination(&[(half(1), &moved(1)), (half(-1), &moved(-1))])
            })
            .collect();
        (0..n).map(|i| columns.iter().map(|column| column[i].clone()).collect()).collect()
    }

    /// Returns the quadratic part Q(x) = ½[f(x) + f(−x)] − f(0).
    fn quadratic(&self, x: &[Rational]) -> Vec<Rational> {
        let opposite = combination(&[(-Rational::one(), x)]);
        let minus = -Rational::one();
        combination(&[
            (half(1), &self.field(x)),
            (half(1), &self.field(&opposite)),
            (minus, &self.field(&self.origin())),
        ])
    }

    /// Returns the bilinear form Q(x, y) = ½[Q(x+y) − Q(x) − Q(y)].
    fn bilinear(&self, x: &[Rational], y: &[Rational]) -> Vec<Rational> {
        let sum = combination(&[(Rational::one(), x), (Rational::one(), y)]);
        combination(&[
            (half(1), &self.quadratic(&sum)),
            (half(-1), &self.quadratic(x)),
            (half(-1), &self.quadratic(y)),
        ])
    }

    /// Returns Q(x,y) + ½B(x+y) + c, where Bx = ½[f(x) − f(−x)] and c = f(0).
    fn polarised(&self, x: &[Rational], y: &[Rational]) -> Vec<Rational> {
        let one = Rational::one;
        combination(&[
            (one(), &self.bilinear(x, y)),
            (half(1), &self.linear(x)),
            (half(1), &self.linear(y)),
            (one(), &self.field(&self.origin())),
        ])
    }

    fn linear(&self, x: &[Rational]) -> Vec<Rational> {
        let opposite = combination(&[(-Rational::one(), x)]);
        combination(&[(half(1), &self.field(x)), (half(-1), &self.field(&opposite))])
    }

    fn matrix(&self, x: &[Rational], eps: &Rational) -> Vec<Vec<Rational>> {
        let mut matrix = self.slopes(x);
        for (i, row) in matrix.iter_mut().enumerate() {
            *row = combination(&[(-eps.clone(), row)]);
            row[i] = &row[i] + &Rational::one();
        }
        matrix
    }

    fn right_hand_side(&self, x: &[Rational], eps: &Rational) -> Vec<Rational> {
        let constant = self.field(&self.origin());
        combination(&[(Rational::one(), x), (eps.clone(), &self.linear(x)), (eps + eps, &constant)])
    }

    /// Returns the solution x̃ of A x̃ = b and det A.
    fn next(&self) -> (Vec<Rational>, Rational) {
        let Point { state, eps, .. } = &self.place.point;
        let right: Vec<Vec<Rational>> =
            self.right_hand_side(state, eps).into_iter().map(|entry| vec![entry]).collect();
        let (next, determinant) = solved(&self.matrix(state, eps), &right);
        (next.concat(), determinant)
    }

    /// Returns the Jacobian ∂x̃/∂x = A(x,ε)⁻¹A(x̃,−ε).
    fn jacobian(&self) -> Vec<Vec<Rational>> {
        let Point { state, eps, .. } = &self.place.point;
        solved(&self.matrix(state, eps), &self.matrix(&self.next().0, &-eps.clone())).0
    }

    fn claims(&self, kind: ClaimKind) -> Vec<(String, Vec<Rational>)> {
        let claims = self.written.claims(&Exact, kind, &self.place.point).into_iter();
        claims.map(|(name, value)| (name, value.expect("the claim has a value"))).collect()
    }

    /// Returns the value of an object by its name in [`Derived::functions`].
    fn object(&self, name: &str, derived: &Derived) -> Vec<Rational> {
        let Place { point: Point { state, .. }, second } = self.place;
        let (next, determinant) = self.next();
        let over = |below: Rational| -> Vec<Rational> {
            next.iter().map(|x| x * &below).chain([below.clone()]).collect()
        };
        match name {
            "field f" => self.field(state),
            "f'(x)" => self.slopes(state).concat(),
            "Q(x,x')" => self.bilinear(state, second),
            "polarised field" => self.polarised(state, second),
            "step" | "general step" => next,
            "det A" => vec![determinant],
            "(N, D)" => over(determinant),
            // N and D are unique only up to a common factor, so D is taken from the reduced map.
            "(N, D) reduced" => {
                let map = derived.map.as_ref().expect("there is a reduced map");
                over(self.place.polynomial(&map.reduced.denominator))
            }
            "integrals" => {
                self.claims(ClaimKind::Integral).into_iter().flat_map(|(_, value)| value).collect()
            }
            "density" => self.claims(ClaimKind::Density).remove(0).1,
            name => {
                let (kind, name) = name.split_once(' ').expect("a claim has a kind and a name");
                let kind = ClaimKind::of_keyword(kind).unwrap_or_else(|| panic!("{kind} is not compared"));
                let claims = self.claims(kind).into_iter();
                claims.filter(|(known, _)| known == name).flat_map(|(_, entries)| entries).collect()
            }
        }
    }
}

fn half(n: i64) -> Rational {
    Rational::new(n, 2)
}

/// The plan of an object, and the object's values at two points, computed from its definition.
struct Object<'a> {
    name: String,
    plan: Plan,
    constants: Option<&'a Plan>,
    defined: [Vec<Rational>; 2],
}

impl Object<'_> {
    fn is(&self, plan: &Plan, constants: Option<&Plan>, places: &[Place; 2], symbols: &Symbols) -> bool {
        places.iter().zip(&self.defined).all(|(place, defined)| {
            let prepared = constants.map_or(Some(Vec::new()), |constants| {
                place.run(constants, symbols, &[]).into_iter().collect::<Option<Vec<Rational>>>()
            });
            let values = prepared.and_then(|prepared| {
                place.run(plan, symbols, &prepared).into_iter().collect::<Option<Vec<Rational>>>()
            });
            values.as_ref() == Some(defined)
        })
    }
}

fn objects<'a>(derived: &'a Derived, written: &Written, places: &[Place; 2]) -> Vec<Object<'a>> {
    let step = derived.step().expect("a closed form");
    let functions = derived.functions().into_iter().filter_map(|(name, plan)| {
        if name.ends_with(" constants") {
            return None;
        }
        // For Clebsch's field, only the step is within the budget.
        let Some(plan) = plan else {
            assert!(["det A", "(N, D)"].contains(&name.as_str()) && derived.map.is_none());
            return None;
        };
        let constants = match name.as_str() {
            "step" => Some(&step.constants),
            "general step" => step.general.as_ref().map(|general| &general.constants),
            _ => None,
        };
        let defined = places.each_ref().map(|place| Definitions { written, place }.object(&name, derived));
        Some(Object { name, plan, constants, defined })
    });
    functions.collect()
}

fn broken(plan: &Plan, index: usize) -> Option<Plan> {
    let mut plan = plan.clone();
    let operation = &mut plan.operations[index];
    *operation = match operation.clone() {
        Operation::Input(_) => return None,
        Operation::Constant(value) => Operation::Constant(&value + &Rational::one()),
        Operation::Add(a, b) => Operation::Subtract(a, b),
        Operation::Subtract(a, b) => Operation::Add(a, b),
        Operation::Multiply(a, b) => Operation::Add(a, b),
        Operation::Divide(a, b) => Operation::Add(a, b),
        Operation::Negate(a) => Operation::Add(a, a),
        Operation::MultiplyAdd(a, b, c) => Operation::MultiplySubtract(a, b, c),
        Operation::MultiplySubtract(a, b, c) => Operation::SubtractProduct(a, b, c),
        Operation::SubtractProduct(a, b, c) => Operation::MultiplyAdd(a, b, c),
    };
    Some(plan)
}

#[test]
fn every_object_is_what_its_definition_says() {
    let mut seen = BTreeMap::new();
    for text in SYSTEMS {
        let system = system(text);
        let symbols = &system.field.symbols;
        let (written, places, derived) = (Written::new(text, symbols), places(&system), derive(&system));
        for object in objects(&derived, &written, &places) {
            let constants = object.constants;
            assert!(object.is(&object.plan, constants, &places, symbols), "{} of {text}", object.name);
            *seen.entry(object.name).or_insert(0) += 1;
        }
    }
    let everywhere = ["field f", "f'(x)", "Q(x,x')", "polarised field", "step"];
    assert!(everywhere.iter().all(|name| seen[*name] == SYSTEMS.len()), "{seen:?}");
    let somewhere =
        ["general step", "det A", "(N, D)", "(N, D) reduced", "integrals", "density", "bracket P"];
    assert!(somewhere.iter().all(|name| seen[*name] > 0), "{seen:?}");
}

#[test]
fn a_plan_with_any_operation_changed_is_not_the_object() {
    let mut changed = 0;
    for text in SYSTEMS {
        let system = system(text);
        let symbols = &system.field.symbols;
        let (written, places, derived) = (Written::new(text, symbols), places(&system), derive(&system));
        for Object { name, plan, constants, defined } in objects(&derived, &written, &places) {
            let object = Object { name, plan: Plan::default(), constants: None, defined };
            for broken in (0..plan.operations.len()).filter_map(|index| broken(&plan, index)) {
                let name = &object.name;
                assert!(!object.is(&broken, constants, &places, symbols), "{name} of {text}: {broken:?}");
                changed += 1;
            }
            let Some(constants) = constants else { continue };
            for broken in (0..constants.operations.len()).filter_map(|index| broken(constants, index)) {
                let name = &object.name;
                assert!(!object.is(&plan, Some(&broken), &places, symbols), "{name} of {text}: {broken:?}");
                changed += 1;
            }
        }
    }
    assert!(changed >= 500, "{changed} changes");
}

#[test]
fn the_interpreter_s_objects_are_what_their_definitions_say() {
    for text in SYSTEMS {
        let system = system(text);
        let written = Written::new(text, &system.field.symbols);
        let interpreter = Interpreter::new(&system);
        for place in &places(&system) {
            let found = interpreter.evaluate(&Exact, &place.point).expect("the field has a value");
            let Point { state, eps, .. } = &place.point;
            let by = Definitions { written: &written, place };
            let (next, determinant) = by.next();
            let jacobian = by.jacobian();
            assert_eq!(found.field, by.field(state), "f of {text}");
            assert_eq!(found.field_jacobian, by.slopes(state), "f' of {text}");
            assert_eq!(found.matrix, by.matrix(state, eps), "A of {text}");
            assert_eq!(found.rhs, by.right_hand_side(state, eps), "b of {text}");
            assert_eq!(found.det_matrix, determinant, "det A of {text}");
            assert_eq!(found.det_jacobian, Some(solved(&jacobian, &vec![Vec::new(); state.len()]).1));
            assert_eq!(found.jacobian, Some(jacobian), "the Jacobian of {text}");
            assert_eq!(found.next, Some(next), "the step of {text}");
            let (x, y) = (&place.point, &place.second);
            assert_eq!(interpreter.bilinear(&Exact, x, y), Some(by.bilinear(state, y)), "Q of {text}");
            assert_eq!(interpreter.polarized(&Exact, x, y), Some(by.polarised(state, y)), "{text}");
            let single = |(name, value): (String, Vec<Rational>)| (name, value.into_iter().next());
            let integrals: Vec<(String, Option<Rational>)> =
                by.claims(ClaimKind::Integral).into_iter().map(single).collect();
            assert_eq!(found.integrals, integrals, "the integrals of {text}");
            let density = by.claims(ClaimKind::Density).pop().map(|claim| single(claim).1);
            assert_eq!(found.density, density, "the density of {text}");
            let above = |matrix: &Vec<Vec<Rational>>| -> Vec<Rational> {
                matrix.iter().enumerate().flat_map(|(i, row)| row[i + 1..].to_vec()).collect()
            };
            let brackets = found.brackets.iter().map(|(name, tensor)| {
                let tensor = tensor.as_ref().expect("the bracket has a value");
                for (i, row) in tensor.iter().enumerate() {
                    for (j, entry) in row.iter().enumerate() {
                        assert_eq!(*entry, -tensor[j][i].clone(), "{name} of {text}");
                    }
                }
                (name.clone(), above(tensor))
            });
            assert_eq!(brackets.collect::<Vec<_>>(), by.claims(ClaimKind::Bracket), "{text}");
        }
    }
}

#[test]
fn tangents_are_carried_by_the_jacobian() {
    let mut planned = 0;
    for text in SYSTEMS {
        let system = system(text);
        let written = Written::new(text, &system.field.symbols);
        let derived = derive(&system);
        let Some((symbols, plan)) = derived.tangent_map() else { continue };
        for Place { point, second: tangent } in places(&system) {
            let place = Place { point, second: tangent.clone() };
            let by = Definitions { written: &written, place: &place };
            let product = by
                .jacobian()
                .into_iter()
                .map(|row| row.iter().zip(&tangent).fold(Rational::zero(), |sum, (a, v)| &sum + &(a * v)));
            let Point { state, parameters, eps } = &place.point;
            let doubled = Point {
                state: [state.as_slice(), &tangent].concat(),
                parameters: parameters.clone(),
                eps: eps.clone(),
            };
            let carried = Place { point: doubled, second: by.next().0 }.run(plan, symbols, &[]);
            assert_eq!(carried, product.map(Some).collect::<Vec<_>>(), "{text}");
        }
        planned += 1;
    }
    assert!(planned >= 3, "{planned} systems have a plan for tangents");
}

#[test]
fn a_field_beyond_straight_lines_has_no_plan_of_its_step() {
    let states = ["a", "b", "c", "d", "e", "f", "g", "h"];
    let text: String =
        states.iter().map(|state| format!("{state}dot = ({})^2;", states.join(" + "))).collect();
    let dense = states.iter().enumerate().fold(text, |text, (i, state)| {
        text.replace(&format!("{state}dot = ("), &format!("{state}dot = {}*{state}*a + (", i + 2))
    });
    let system = system(&dense);
    let derived = derive(&system);
    assert!(derived.map.is_none() && derived.step().is_none(), "the field is large enough");
    let without: Vec<String> =
        derived.functions().into_iter().filter(|(_, plan)| plan.is_none()).map(|(name, _)| name).collect();
    assert_eq!(without, ["prepared constants", "step", "det A", "(N, D)"]);
}

fn compute(line: &str, values: &mut BTreeMap<String, Rational>) {
    let (name, right) = line.split_once(" = ").expect("an equation");
    let lookup = |text: &str| -> Rational {
        let (negative, text) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let inner = text.trim_start_matches('(').trim_end_matches(')');
        let value =
            values.get(inner).cloned().or_else(|| Rational::parse(inner)).expect("a name or a number");
        if negative { -value } else { value }
    };
    let product = |text: &str| -> Rational {
        // A number such as (1/2) contains a slash that is no division.
        if let Some((a, b)) = text.rsplit_once('/').filter(|(_, below)| !below.contains(')')) {
            return lookup(a).checked_div(&lookup(b)).expect("no pole");
        }
        text.split('*').map(lookup).reduce(|a, b| &a * &b).expect("a factor")
    };
    let value = if let Some((a, b)) = right.split_once(" + ") {
        &product(a) + &product(b)
    } else if let Some((a, b)) = right.split_once(" - ") {
        &product(a) - &product(b)
    } else {
        product(right)
    };
    let known = values.insert(name.to_owned(), value);
    assert!(known.is_none(), "{name} is defined twice");
}

#[test]
fn a_listing_can_be_computed_line_by_line() {
    for text in SYSTEMS {
        let system = system(text);
        let [Place { point, .. }, _] = places(&system);
        let symbols = &system.field.symbols;
        let step = StepPlan::of(&system.field).expect("a closed form");
        let listing = StepListing::of(&step, symbols);
        let states = symbols.states.iter().cloned().zip(point.state.iter().cloned());
        let parameters = symbols.parameters.iter().cloned().zip(point.parameters.iter().cloned());
        let mut values: BTreeMap<String, Rational> = states.chain(parameters).collect();
        values.insert("eps".to_owned(), point.eps.clone());
        let kept = |line: &&String| line.contains('=');
        let lines = listing.constants.iter().filter(kept).chain(&listing.kernel).chain(&listing.next);
        for line in lines {
            compute(line, &mut values);
        }
        let next = Interpreter::new(&system).next(&Exact, &point).expect("no pole");
        for (state, value) in symbols.states.iter().zip(next) {
            assert_eq!(values[&format!("{state}~")], value, "{state}~ of {text}");
        }
        for reciprocal in listing.reciprocals.iter().flatten() {
            assert!(values.contains_key(reciprocal), "{reciprocal} of {text}");
        }
    }
}
