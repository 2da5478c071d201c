//! Derives integrals of Kahan's map from integrals of the flow, by linear algebra over rational
//! functions of the parameters.
//!
//! # Theorems
//!
//! Let x̃ be the image of x and f(x,x̃) the polarised field, so that x̃ − x = 2ε f(x,x̃). Two
//! theorems hold in any dimension.
//!
//! **Polarisation.** Let I = a·x + xᵀCx with a symmetric constant matrix C, dI/dt = 0 and Cf
//! affine. Then I − ε² fᵀCf is an integral. Proof: write I = a·x + yᵀCy with affine functions y
//! whose derivatives ẏ = ℓ along the field are affine. A tilde denotes values at x̃. Polarise
//! dI/dt = 2ℓᵀCy + a·f = 0 to ℓᵀCỹ + ℓ̃ᵀCy + a·f(x,x̃) = 0, and ẏ = ℓ to ỹ − y = ε(ℓ + ℓ̃). Then
//!
//! Ĩ − I = ε(ℓ + ℓ̃)ᵀC(y + ỹ) − 2ε(ℓᵀCỹ + ℓ̃ᵀCy) = ε(ℓ̃ − ℓ)ᵀC(ỹ − y) = ε²(ℓ̃ᵀCℓ̃ − ℓᵀCℓ).
//!
//! **Rotation.** Let ẏ = mNy with a vector y of affine functions of x, an affine m and a constant
//! matrix N. Let I = yᵀQy, let QN be antisymmetric (dI/dt = 0), and let QN² = −δQ. Then I/(1 +
//! ε²δm²) is an integral. Proof: polarisation gives (1 − εmN)ỹ = (1 + εm̃N)y. Since QN = −NᵀQ, vᵀQv
//! is (1 + ε²δm²)Ĩ if v is the left-hand side, and (1 + ε²δm̃²)I if v is the right-hand side.

mod linear_relations;

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::poly::{
    Budget, Monomial, OverBudget, Polynomial, Variable, WithinBudget, gcd_all_within, gcd_within,
};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;
use linear_relations::{Relation, linear_relations};

/// The most terms of a formula.
const MOST_TERMS: usize = 20_000;
const MOST_WORK: u64 = 4_000_000;

/// The theorem from which an integral follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// If I = a·x + xᵀCx with a symmetric constant matrix C is an integral of the flow ẋ = f, and
    /// Cf is affine, then I − ε² fᵀCf is an integral of the map.
    ///
    /// A linear integral I of the flow is also an integral of the map. For linear f, every
    /// quadratic integral I is an integral of the map.
    ///
    /// For example, if ẋ = y and w − x² is an integral of the flow, then w − x² + ε²y² is an
    /// integral of the map. If ẋ = p, ṗ = −F and Ẇ = F·p, then |p|²/2 + W − ε²|F|²/2 is an integral
    /// of the map.
    Polarisation,
    /// Let y be a vector of affine functions of x with ẏ = mNy, where m is affine and N a constant
    /// matrix with N² = −δ, δ > 0. If yᵀQy is an integral of the flow, then yᵀQy/(1 + ε²δm²) is an
    /// integral of the map. For example, let s and c be affine with ṡ = αcm and ċ = −βsm, where
    /// αβ > 0 is constant. Then (βs² + αc²)/(1 + ε²αβm²) is an integral.
    Rotation,
    /// Like [`Rotation`](Rule::Rotation), but with δ < 0. Affine functions s and w with ṡ = κsm and
    /// ẇ = −κwm for a constant κ give sw/(1 − ε²κ²m²). If δ contains parameters, the sign of its
    /// leading coefficient decides between `Rotation` and `Hyperbolic`.
    Hyperbolic,
}

/// An integral of the flow, and the corresponding integral of Kahan's map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModifiedIntegral {
    /// The theorem that proves the integral of the map.
    pub rule: Rule,
    /// The integral I of the flow, of degree at most 2 in the states.
    pub of_flow: Polynomial,
    /// The integral of the map. At ε = 0 it equals the integral of the flow.
    pub of_map: RationalFunction,
}

/// Returns all integrals by polarisation and rotation within a bounded amount of work.
///
/// First comes a basis of the linear integrals. Integrals by polarisation follow, but no products
/// of linear integrals. Integrals by rotation come last, ordered by m of [`Rule::Rotation`]. All
/// are linearly independent, and usually also functionally independent.
#[must_use]
pub fn modified_integrals(field: &Field) -> Vec<ModifiedIntegral> {
    let Ok(flow) = Flow::of(field, &mut budget()) else { return Vec::new() };
    let mut found = Vec::new();
    let _ = flow.add_polarised(&mut found, &mut budget());
    let _ = flow.add_rotations(&mut found, &mut budget());
    found
}

/// Returns an integral of the map from `integral`, an integral of the flow of degree at most 2. At
/// ε = 0, an integral by polarisation equals `integral`. An integral by rotation equals
/// a·`integral` + b there, where a and b contain no states. Returns `None` if neither theorem
/// applies, or if the work is too large.
#[must_use]
pub fn modified_integral(field: &Field, integral: &Polynomial) -> Option<ModifiedIntegral> {
    let flow = Flow::of(field, &mut budget()).ok()?;
    flow.polarised(integral, &mut budget()).or_else(|_| flow.rotated(integral, &mut budget())).ok()
}

/// Returns a basis of the linear integrals Σ cₖ xₖ with numeric coefficients, as pairs (k, cₖ).
/// Linear integrals of the flow are integrals of the map for all parameters and ε. The list is
/// empty if the work is too large.
///
/// The list `order` must be a permutation of the states. The last variable of each integral, in
/// this order, occurs in no other integral.
///
/// # Panics
/// If `order` contains an index that is not a state.
#[must_use]
pub fn linear_integrals(field: &Field, order: &[usize]) -> Vec<Vec<(usize, Rational)>> {
    let mut budget = budget();
    let Ok(flow) = Flow::of(field, &mut budget) else { return Vec::new() };
    let components: Vec<Polynomial> = order.iter().map(|k| flow.components[*k].clone()).collect();
    let relations = linear_relations(&components, |_| true, &mut budget).unwrap_or_default();
    let number = |coefficient: &Polynomial| coefficient.as_constant().expect("no variable is left in it");
    let integral = |relation: &Relation| relation.iter().map(|(k, c)| (order[*k], number(c))).collect();
    relations.iter().map(integral).collect()
}

fn budget() -> Budget {
    Budget::new(MOST_TERMS, MOST_WORK)
}

/// The error that a premise fails or the budget is spent.
#[derive(Clone, Copy, Debug)]
struct NoIntegral;

impl From<OverBudget> for NoIntegral {
    fn from(OverBudget: OverBudget) -> Self {
        NoIntegral
    }
}

/// A function y and its slope: ẏ for polarisation, ẏ/m for rotation with an affine m.
type WithSlope = (Polynomial, Polynomial);

/// A product `value` of two linear integrals. The product of the two states `pair` occurs in it,
/// but in no later `value`.
#[derive(Clone)]
struct Product {
    value: Polynomial,
    pair: [Variable; 2],
}

/// The flow of ẋ = F(x)/q. The divisor q contains no states.
struct Flow<'a> {
    symbols: &'a Symbols,
    components: Vec<Polynomial>,
    divisor: Polynomial,
}

impl<'a> Flow<'a> {
    fn of(field: &'a Field, budget: &mut Budget) -> WithinBudget<Self> {
        let (components, divisor) = RationalFunction::over_common_within(field.components.iter(), budget)?;
        Ok(Flow { symbols: &field.symbols, components, divisor })
    }

    fn state(&self, i: usize) -> Polynomial {
        Polynomial::variable(self.symbols.state(i))
    }

    fn directional_derivative(
        &self,
        polynomial: &Polynomial,
        v: &[Polynomial],
        budget: &mut Budget,
    ) -> WithinBudget<Polynomial> {
        let slopes = polynomial.gradient(|variable| self.symbols.is_state(variable));
        slopes.iter().try_fold(Polynomial::zero(), |sum, (variable, slope)| {
            sum.add_within(&slope.mul_within(&v[usize::from(variable.0)], budget)?, budget)
        })
    }

    fn add_polarised(
        &self,
        found: &mut Vec<ModifiedIntegral>,
        budget: &mut Budget,
    ) -> Result<(), NoIntegral> {
        let symbols = self.symbols;
        let states: Vec<Polynomial> = (0..self.components.len()).map(|i| self.state(i)).collect();
        let is_quadratic = |monomial: &Monomial| monomial.degree_where(|v| symbols.is_state(v)) == 2;
        let of_degree_two = |component: &Polynomial| {
            component.map_monomials(|monomial| is_quadratic(monomial).then(|| monomial.clone()))
        };
        let quadratic: Vec<Polynomial> = self.components.iter().map(of_degree_two).collect();
        let constant = linear_relations(&self.components, |v| symbols.is_state(v), budget)?;
        let affine = linear_relations(&quadratic, |v| symbols.is_state(v), budget)?;
        let is_last = |index: usize| constant.iter().any(|relation| last_index(relation) == index);
        let others = affine.iter().filter(|relation| !is_last(last_index(relation)));
        let mut forms = Vec::new();
        for relation in constant.iter().chain(others) {
            let form = combination(relation, &states, budget)?;
            forms.push((form, combination(relation, &self.components, budget)?));
        }
        for (form, _) in &forms[..constant.len()] {
            found.push(self.polarised(&symbols.primitive_part(form), budget)?);
        }
        let products = self.products(&constant, &forms, budget)?;
        let linear = states.into_iter().zip(self.components.iter().cloned()).enumerate();
        let linear = linear.filter(|(index, _)| !is_last(*index)).map(|(_, pair)| pair).collect();
        for mut integral in self.invariants(&forms, constant.len(), linear, budget)? {
            // Subtract multiples of products until the integral lacks the product of each `pair`.
            for Product { value, pair } in &products {
                let [own, other] = [&integral, value].map(|of| of.derivative(pair[0]).derivative(pair[1]));
                let scaled = integral.mul_within(&other, budget)?;
                integral = scaled.add_within(&-&value.mul_within(&own, budget)?, budget)?;
            }
            found.push(self.polarised(&symbols.primitive_part(&integral), budget)?);
        }
        Ok(())
    }

    /// Returns all products of two linear integrals, with squares last.
    fn products(
        &self,
        relations: &[Relation],
        forms: &[WithSlope],
        budget: &mut Budget,
    ) -> WithinBudget<Vec<Product>> {
        let (mut of_two, mut squares) = (Vec::new(), Vec::new());
        for i in 0..relations.len() {
            for j in 0..=i {
                let is_square = i == j;
                let other = if is_square { relations[i][0].0 } else { last_index(&relations[j]) };
                let pair = [last_index(&relations[i]), other].map(|state| self.symbols.state(state));
                if pair[0] != pair[1] {
                    let value = forms[i].0.mul_within(&forms[j].0, budget)?;
                    if is_square { &mut squares } else { &mut of_two }.push(Product { value, pair });
                }
            }
        }
        Ok([of_two, squares].concat())
    }

    fn add_rotations(
        &self,
        found: &mut Vec<ModifiedIntegral>,
        budget: &mut Budget,
    ) -> Result<(), NoIntegral> {
        for multiplier in self.multipliers(budget)? {
            // Divide all derivatives by m, and keep the variables with affine quotients.
            let mut slopes = Vec::with_capacity(self.components.len());
            for component in &self.components {
                let slope = component.div_within(&multiplier, budget)?;
                slopes.push(slope.filter(|slope| self.symbols.degree(slope) < 2));
            }
            self.remove_dependent(&mut slopes);
            let members: Vec<usize> = (0..slopes.len()).filter(|&i| slopes[i].is_some()).collect();
            let slopes: Vec<Polynomial> = slopes.into_iter().map(Option::unwrap_or_default).collect();
            let (mut values, mut first, mut second) =
                (vec![Polynomial::one()], vec![Polynomial::zero()], vec![Polynomial::zero()]);
            let mut deltas: Vec<Polynomial> = Vec::new();
            for &i in &members {
                let twice = self.directional_derivative(&slopes[i], &slopes, budget)?;
                let delta = -&twice.derivative(self.symbols.state(i));
                if !delta.is_zero() && !deltas.contains(&delta) {
                    deltas.push(delta);
                }
                values.push(self.state(i));
                first.push(slopes[i].clone());
                second.push(twice);
            }
            for delta in deltas {
                // Let Dy = ẏ/m and `twice` = D(Dy). Find the affine y with D(Dy) = −δy.
                let vector = |(value, twice): (&Polynomial, &Polynomial)| {
                    twice.add_within(&delta.mul_within(value, budget)?, budget)
                };
                let vectors = values.iter().zip(&second).map(vector).collect::<WithinBudget<Vec<_>>>()?;
                let mut forms = Vec::new();
                for relation in linear_relations(&vectors, |v| self.symbols.is_state(v), budget)? {
                    let form = combination(&relation, &values, budget)?;
                    forms.push((form, combination(&relation, &first, budget)?));
                }
                for integral in self.invariants(&forms, 0, Vec::new(), budget)? {
                    found.push(self.rotated(&integral, budget)?);
                }
            }
        }
        Ok(())
    }

    /// Returns the integrals Σ cᵢⱼ λᵢλⱼ + Σ aₖ vₖ with the λᵢ in `forms` and the vₖ in `further`.
    /// The first `constant` entries of `forms` are integrals; their products are omitted.
    fn invariants(
        &self,
        forms: &[WithSlope],
        constant: usize,
        further: Vec<WithSlope>,
        budget: &mut Budget,
    ) -> WithinBudget<Vec<Polynomial>> {
        let (mut values, mut derivatives) = (Vec::new(), Vec::new());
        for (i, (first, first_slope)) in forms.iter().enumerate() {
            for (second, second_slope) in &forms[i.max(constant)..] {
                values.push(first.mul_within(second, budget)?);
                let left = first.mul_within(second_slope, budget)?;
                derivatives.push(left.add_within(&first_slope.mul_within(second, budget)?, budget)?);
            }
        }
        for (value, derivative) in further {
            values.push(value);
            derivatives.push(derivative);
        }
        let mut integrals = Vec::new();
        for relation in linear_relations(&derivatives, |v| self.symbols.is_state(v), budget)? {
            integrals.push(self.symbols.primitive_part(&combination(&relation, &values, budget)?));
        }
        Ok(integrals)
    }

    /// Returns candidates for the affine function m of a rotation: divisors of components.
    fn multipliers(&self, budget: &mut Budget) -> WithinBudget<Vec<Polynomial>> {
        let mut found: Vec<Polynomial> = Vec::new();
        let mut add = |divisor: &Polynomial| {
            let form = self.symbols.primitive_part(divisor);
            if self.symbols.degree(&form) == 1 && !found.contains(&form) {
                found.push(form);
            }
        };
        for (i, component) in self.components.iter().enumerate() {
            if let Some(quotient) = component.div_within(&self.state(i), budget)? {
                add(&quotient);
            }
            for variable in component.variables() {
                let j = usize::from(variable.0);
                if self.symbols.is_state(variable) && j != i && !self.components[j].is_zero() {
                    add(&gcd_within(component, &self.components[j], budget)?);
                }
            }
        }
        Ok(found)
    }

    /// Removes variables until no quotient ẋᵢ/m in `slopes` contains a removed variable.
    fn remove_dependent(&self, slopes: &mut [Option<Polynomial>]) {
        loop {
            let is_out = |slope: &Polynomial| {
                let mut states = slope.variables().into_iter().filter(|&v| self.symbols.is_state(v));
                states.any(|variable| slopes[usize::from(variable.0)].is_none())
            };
            let out: Vec<usize> =
                (0..slopes.len()).filter(|&i| slopes[i].as_ref().is_some_and(is_out)).collect();
            if out.is_empty() {
                return;
            }
            out.into_iter().for_each(|i| slopes[i] = None);
        }
    }

    /// Returns the integral I − ε² fᵀCf by polarisation of an integral I.
    fn polarised(&self, integral: &Polynomial, budget: &mut Budget) -> Result<ModifiedIntegral, NoIntegral> {
        self.check(integral, budget)?;
        // For a linear field, the map is the midpoint rule, which preserves I.
        if self.components.iter().all(|component| self.symbols.degree(component) < 2) {
            let of_map = integral.clone().into();
            return Ok(ModifiedIntegral { rule: Rule::Polarisation, of_flow: integral.clone(), of_map });
        }
        // Here 2fᵀCf = Σ fᵢ (2Cf)ᵢ, and (2Cf)ᵢ is the derivative of ∂I/∂xᵢ along the field.
        let mut twice = Polynomial::zero();
        for (variable, slope) in integral.gradient(|variable| self.symbols.is_state(variable)) {
            let second = self.directional_derivative(&slope, &self.components, budget)?;
            if self.symbols.degree(&second) > 1 {
                return Err(NoIntegral);
            }
            let product = second.mul_within(&self.components[usize::from(variable.0)], budget)?;
            twice = twice.add_within(&product, budget)?;
        }
        let eps = Polynomial::variable(self.symbols.epsilon());
        let correction = (&eps * &eps).scale(&Rational::new(1, 2)).mul_within(&twice, budget)?;
        let below = self.divisor.mul_within(&self.divisor, budget)?;
        let above = integral.mul_within(&below, budget)?.add_within(&-&correction, budget)?;
        let of_map = RationalFunction::new_within(above, below, budget)?.expect("a divisor is not zero");
        Ok(ModifiedIntegral { rule: Rule::Polarisation, of_flow: integral.clone(), of_map })
    }

    /// Returns the integral I/(1 + ε²δm²) by rotation. For the partial derivatives y of I, there
    /// must be affine functions u with ẏ = m u and u̇ = −δ m y.
    fn rotated(&self, integral: &Polynomial, budget: &mut Budget) -> Result<ModifiedIntegral, NoIntegral> {
        self.check(integral, budget)?;
        let symbols = self.symbols;
        let slopes = integral.gradient(|variable| symbols.is_state(variable));
        // A further variable x₀ = 1 makes I a quadratic form. Its derivative by x₀ is `first`.
        let mut first = integral.scale(&Rational::from(2));
        for (variable, slope) in slopes.iter() {
            let product = Polynomial::variable(*variable).mul_within(slope, budget)?;
            first = first.add_within(&-&product, budget)?;
        }
        let forms: Vec<Polynomial> =
            std::iter::once(first).chain(slopes.into_iter().map(|(_, y)| y)).collect();
        let derivatives =
            forms.iter().map(|form| self.directional_derivative(form, &self.components, budget));
        let derivatives = derivatives.collect::<WithinBudget<Vec<_>>>()?;
        let multiplier = symbols.primitive_part(&gcd_all_within(&derivatives, budget)?);
        if symbols.degree(&multiplier) != 1 {
            return Err(NoIntegral);
        }
        let mut second = Vec::with_capacity(forms.len());
        for derivative in &derivatives {
            let over = derivative.div_within(&multiplier, budget)?.ok_or(NoIntegral)?;
            let twice = self.directional_derivative(&over, &self.components, budget)?;
            second.push(twice.div_within(&multiplier, budget)?.ok_or(NoIntegral)?);
        }
        let [form, turned] = [&forms, &second].map(|list| list[1].clone());
        let delta = RationalFunction::new_within(-&turned, form, budget)?.ok_or(NoIntegral)?;
        let (above, below) = (delta.numerator(), delta.denominator());
        if delta.is_zero() || symbols.has_state(above) || symbols.has_state(below) {
            return Err(NoIntegral);
        }
        // For each y, u̇/m + δy must be 0. For `first`, any constant is allowed in place of 0,
        // because a constant can be added to I.
        let mut rest = Vec::with_capacity(forms.len());
        for (form, turned) in forms.iter().zip(&second) {
            let turned = turned.mul_within(below, budget)?;
            rest.push(turned.add_within(&form.mul_within(above, budget)?, budget)?);
        }
        if symbols.has_state(&rest[0]) || rest[1..].iter().any(|rest| !rest.is_zero()) {
            return Err(NoIntegral);
        }
        let twice = above.scale(&Rational::from(2));
        let centred = integral.mul_within(&twice, budget)?.add_within(&-&rest[0], budget)?;
        let centred = RationalFunction::new_within(centred, twice, budget)?.expect("δ is not 0");
        let of_flow = centred.numerator().clone();
        let (_, leading) = above.leading_term().expect("δ is not 0");
        let rule = if leading.is_negative() { Rule::Hyperbolic } else { Rule::Rotation };
        // If m is an integral, so is 1 + ε²δm², and the division may be omitted.
        if self.directional_derivative(&multiplier, &self.components, budget)?.is_zero() {
            return Ok(ModifiedIntegral { rule, of_map: of_flow.clone().into(), of_flow });
        }
        let eps = symbols.epsilon();
        let squared = [Polynomial::variable(eps), multiplier].map(|factor| &factor * &factor);
        let scale = self.divisor.mul_within(&self.divisor, budget)?.mul_within(below, budget)?;
        let turning = squared[0].mul_within(&squared[1], budget)?.mul_within(above, budget)?;
        let factor = RationalFunction::new_within(scale.add_within(&turning, budget)?, scale, budget)?;
        let of_map = RationalFunction::from(of_flow.clone())
            .div_within(&factor.expect("a divisor is not zero"), budget)?;
        Ok(ModifiedIntegral { rule, of_flow, of_map: of_map.expect("1 + ε²δm² is not zero") })
    }

    /// Returns an error unless the polynomial is an integral of the flow of degree 1 or 2 without
    /// ε.
    fn check(&self, integral: &Polynomial, budget: &mut Budget) -> Result<(), NoIntegral> {
        let is_fit = (1..=2).contains(&self.symbols.degree(integral))
            && integral.variables().iter().all(|variable| *variable < self.symbols.epsilon())
            && self.directional_derivative(integral, &self.components, budget)?.is_zero();
        if is_fit { Ok(()) } else { Err(NoIntegral) }
    }
}

fn last_index(relation: &Relation) -> usize {
    relation.last().expect("a relation has a coefficient").0
}

fn combination(relation: &Relation, vectors: &[Polynomial], budget: &mut Budget) -> WithinBudget<Polynomial> {
    relation.iter().try_fold(Polynomial::zero(), |sum, (index, coefficient)| {
        sum.add_within(&coefficient.mul_within(&vectors[*index], budget)?, budget)
    })
}
