//! Finds special polynomials P + cQ for an integral P/Q: those that factor, have lower degree, or
//! do not contain ε.
//!
//! Let F(s, t) be P + cQ on a random plane, and d its degree. F factors over ℂ or has a square
//! factor if and only if the equation ∂(G/F)/∂t = ∂(H/F)/∂s has solutions (G, H) of degree below d
//! other than multiples of ∇F (Ruppert, J. reine angew. Math. 369, 1986; Gao, Math. Comp. 72,
//! 2003). The matrix of this linear system is linear in c. The wanted c are therefore roots of a
//! polynomial modulo a prime. The caller must prove the results.

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_factor::dense::{derivative, gcd, quotient_and_rest, trimmed};

use crate::deadline::Deadline;
use crate::maps::parametric_field::evaluate;
use crate::maps::search_field::SearchField;
use crate::modular::matrix::Echelon;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::modular::reconstruction::Oracle;
use crate::modular::subspace::{
    Form, FormulaVariables, PolynomialSpace, primitive_in_states, reconstruct_space,
};

/// The most multiplications modulo a prime in one search.
const MOST_WORK: u64 = 100_000_000;

const WORK_OF_LOOK: u64 = 50_000;

/// The number of random choices of the parameters and ε at which elements P + cQ are counted.
const PARAMETER_SAMPLES: usize = 4;

/// Finds elements P + cQ that factor, have lower degree or do not contain ε, where c is a rational
/// function of the parameters and ε. Elements that are too expensive to reconstruct are missing.
pub(crate) fn special_members(
    searched: &SearchField,
    numerator: &Polynomial,
    denominator: &Polynomial,
) -> Vec<Polynomial> {
    let symbols = searched.family().symbols();
    let degree = symbols.degree(numerator).max(symbols.degree(denominator));
    let monomials = Monomials::new(searched.dimension(), degree);
    let unknowns = searched.unknown_variables();
    let [above, below] = [numerator, denominator].map(|side| {
        let groups = side.group(|variable| symbols.is_state(variable)).into_iter();
        let index = |(monomial, own): (Monomial, Polynomial)| {
            let exponents = (0..searched.dimension()).map(|i| monomial.exponent(symbols.state(i)));
            let exponents: Vec<u32> = exponents.collect();
            let found = (0..monomials.len()).find(|&index| monomials.exponents(index) == exponents);
            (found.expect("its degree is the largest"), own)
        };
        groups.map(index).collect::<Vec<_>>()
    });
    let pair = |modulus: Modulus, values: &[u64], _: &mut SplitMix64| {
        let value = |variable: Variable| {
            unknowns.iter().position(|known| *known == variable).map_or(0, |place| values[place])
        };
        let side = |groups: &[(usize, Polynomial)]| {
            let mut coefficients = vec![0; monomials.len()];
            for (index, own) in groups {
                coefficients[*index] = evaluate(&modulus, own, value)?;
            }
            Some(coefficients)
        };
        Some([side(&above)?, side(&below)?])
    };
    members(searched, &monomials, pair)
}

/// Finds the elements of [`special_members`]. `pair` returns P and Q at given parameters and ε.
pub(crate) fn members(
    searched: &SearchField,
    monomials: &Monomials,
    mut pair: impl FnMut(Modulus, &[u64], &mut SplitMix64) -> Option<[Vec<u64>; 2]>,
) -> Vec<Polynomial> {
    let degree = monomials.degree() as usize;
    if degree < 2 || searched.dimension() < 2 {
        return Vec::new();
    }
    let work = WORK_OF_LOOK + ((degree * (degree + 1)) as u64).pow(4);
    let mut left = MOST_WORK;
    let mut pair = |modulus: Modulus, values: &[u64], random: &mut SplitMix64| {
        left = left.checked_sub(work)?;
        pair(modulus, values, random)
    };
    let random = &mut SplitMix64::new(59);
    let modulus = Modulus::mersenne_61();
    let symbols = searched.family().symbols();
    let mut found = Vec::new();
    let mut add = |form: Form, at: &mut Oracle<'_>| {
        let at = |modulus: Modulus, values: &[u64], random: &mut SplitMix64| {
            let all = at(modulus, values, random)?;
            let is_of_form = (0..all.len()).all(|index| all[index] == 0 || form.support.contains(&index));
            let own = form.support.iter().map(|&index| all[index]).collect();
            is_of_form.then(|| PolynomialSpace::of_form(&modulus, &form, vec![own]))?
        };
        let random = &mut SplitMix64::new(60);
        let far = Deadline::never();
        let member = reconstruct_space(&FormulaVariables::of(searched), monomials, &form, at, random, &far);
        for member in member.unwrap_or_default().iter().map(|member| primitive_in_states(symbols, member)) {
            if !found.contains(&member) {
                found.push(member);
            }
        }
    };
    if searched.eps().is_none() {
        let mut free = |modulus: Modulus, values: &[u64], random: &mut SplitMix64| {
            let mut other = values.to_vec();
            *other.last_mut()? = modulus.sample(random);
            let (here, there) = (pair(modulus, values, random)?, pair(modulus, &other, random)?);
            common_element(&modulus, &here, &there)
        };
        let values: Vec<u64> = (0..searched.unknowns()).map(|_| modulus.sample(random)).collect();
        if let Some(member) = free(modulus, &values, random) {
            let support = (0..member.len()).filter(|&index| member[index] != 0).collect();
            add(Form { support, pivots: vec![0] }, &mut free);
        }
    }
    let mut at = |modulus: Modulus, values: &[u64], random: &mut SplitMix64| {
        special_elements(&modulus, monomials, &pair(modulus, values, random)?, random)
    };
    // Counts the elements with equal `MemberProperties` at each sample.
    let mut kinds: Vec<(MemberProperties, Vec<usize>)> = Vec::new();
    for look in 0..PARAMETER_SAMPLES {
        let values: Vec<u64> = (0..searched.unknowns()).map(|_| modulus.sample(random)).collect();
        for (kind, _) in at(modulus, &values, random).unwrap_or_default() {
            match kinds.iter_mut().find(|(known, _)| *known == kind) {
                Some((_, counts)) => counts[look] += 1,
                None => {
                    let mut counts = vec![0; PARAMETER_SAMPLES];
                    counts[look] = 1;
                    kinds.push((kind, counts));
                }
            }
        }
    }
    kinds.retain(|(_, counts)| counts.iter().min() == Some(&1));
    for (kind, _) in kinds {
        let form = Form { support: kind.support.clone(), pivots: vec![0] };
        add(form, &mut |modulus, values, random| {
            let mut own = at(modulus, values, random)?.into_iter().filter(|(other, _)| *other == kind);
            own.next().filter(|_| own.next().is_none()).map(|(_, member)| member)
        });
    }
    found
}

/// Returns a vector in the intersection of the spans of `here` and `there`, if this is a line.
fn common_element(modulus: &Modulus, here: &[Vec<u64>; 2], there: &[Vec<u64>; 2]) -> Option<Vec<u64>> {
    let rows = (0..here[0].len()).map(|index| here.iter().chain(there).map(|side| side[index]).collect());
    let null = Echelon::of(modulus, rows.collect(), 4).null_space(modulus);
    let [vector] = &null[..] else { return None };
    let own = |index: usize| modulus.dot(&vector.entries[..2], &[here[0][index], here[1][index]]);
    Some((0..here[0].len()).map(own).collect())
}

/// Properties of a special element F that are equal in all samples. They identify F.
#[derive(Clone, Debug, PartialEq, Eq)]
struct MemberProperties {
    multiplicity: usize,
    /// The dimension of the space of solutions G, H of ∂(G/F)/∂t = ∂(H/F)/∂s.
    solutions: usize,
    /// The degree of gcd(L, L′), where L is the leading form of F with t = 1.
    at_infinity: usize,
    support: Vec<usize>,
}

/// Returns the elements P + cQ at one sample that factor or have lower degree.
fn special_elements(
    modulus: &Modulus,
    monomials: &Monomials,
    pair: &[Vec<u64>; 2],
    random: &mut SplitMix64,
) -> Option<Vec<(MemberProperties, Vec<u64>)>> {
    let combined = |[left, right]: &[Vec<u64>; 2], factor: u64| -> Vec<u64> {
        let sum = |(own, other): (&u64, &u64)| modulus.plus(*own, modulus.times(factor, *other));
        left.iter().zip(right).map(sum).collect()
    };
    // P and Q are replaced by a random basis, so that no special element has c = ∞.
    let pair = [0, 1].map(|_| combined(pair, modulus.sample(random)));
    let degree = monomials.degree() as usize;
    let plane = Plane::random(*modulus, monomials, random);
    let sides = pair.each_ref().map(|side| plane.restricted(side));
    let [first, second] = sides.each_ref().map(|side| equations(modulus, degree, side));
    let field = modulus.field();
    let residues = |values: &[u64]| values.iter().map(|&value| modulus.residue(value)).collect::<Vec<_>>();
    // For one c the polynomial F = P + cQ lacks the highest power of s. Then ∇F is a solution even
    // if F is irreducible. `spectrum` is therefore divided by this root.
    let highest = sides.each_ref().map(|side| side[place(degree, degree, 0)]);
    if highest[1] == 0 {
        return None;
    }
    let mut spectrum =
        quotient_and_rest(field, &spectrum(modulus, &first, &second, random)?, &residues(&highest)).0;
    let mut found = Vec::new();
    while let Some(root) = kahan_factor::root(field, &spectrum, || modulus.residue(modulus.sample(random))) {
        let mut multiplicity = 0;
        loop {
            let (quotient, rest) = quotient_and_rest(field, &spectrum, &[field.neg(root), 1]);
            if !rest.is_empty() {
                break;
            }
            spectrum = quotient;
            multiplicity += 1;
        }
        let root = modulus.integer(root);
        let rows = first.iter().zip(&second).map(|(p, q)| combined(&[p.clone(), q.clone()], root)).collect();
        let solutions = first.len() - Echelon::of(modulus, rows, first[0].len()).rank();
        let member = combined(&pair, root);
        let support = (0..member.len()).filter(|&index| member[index] != 0).collect();
        let own = combined(&sides, root);
        let leading: Vec<u64> = (0..=degree).map(|a| own[place(degree, a, degree - a)]).collect();
        let leading = trimmed(residues(&leading));
        let repeated = gcd(field, &derivative(field, &leading), &leading);
        let at_infinity = repeated.len().checked_sub(1).unwrap_or(degree);
        found.push((MemberProperties { multiplicity, solutions, at_infinity, support }, member));
    }
    Some(found)
}

/// A random plane in the space of the states, on which each state is an affine function of s and t.
struct Plane<'a> {
    modulus: Modulus,
    monomials: &'a Monomials,
    powers: Vec<Vec<Vec<u64>>>,
}

/// Returns the index of the coefficient of sᵃtᵇ in a polynomial of this degree.
fn place(degree: usize, a: usize, b: usize) -> usize {
    a * (degree + 1) + b
}

impl<'a> Plane<'a> {
    fn random(modulus: Modulus, monomials: &'a Monomials, random: &mut SplitMix64) -> Self {
        let degree = monomials.degree() as usize;
        let mut plane = Plane { modulus, monomials, powers: Vec::new() };
        for _ in 0..monomials.variables() {
            let mut one = vec![0; (degree + 1) * (degree + 1)];
            let mut form = one.clone();
            one[0] = modulus.one();
            for (a, b) in [(0, 0), (0, 1), (1, 0)] {
                form[place(degree, a, b)] = modulus.sample(random);
            }
            let mut powers = vec![one];
            for exponent in 0..degree {
                powers.push(plane.product(&powers[exponent], &form));
            }
            plane.powers.push(powers);
        }
        plane
    }

    fn product(&self, left: &[u64], right: &[u64]) -> Vec<u64> {
        let mut product = vec![0; left.len()];
        for (i, &own) in left.iter().enumerate().filter(|(_, own)| **own != 0) {
            for (j, &other) in right.iter().enumerate().filter(|(_, other)| **other != 0) {
                product[i + j] = self.modulus.plus(product[i + j], self.modulus.times(own, other));
            }
        }
        product
    }

    fn restricted(&self, coefficients: &[u64]) -> Vec<u64> {
        let mut sum: Vec<u64> = vec![0; self.powers[0][0].len()];
        for (index, &value) in coefficients.iter().enumerate().filter(|(_, value)| **value != 0) {
            let mut term = vec![0; sum.len()];
            term[0] = value;
            for (powers, &exponent) in self.powers.iter().zip(self.monomials.exponents(index)) {
                if exponent > 0 {
                    term = self.product(&term, &powers[exponent as usize]);
                }
            }
            for (entry, own) in sum.iter_mut().zip(term) {
                *entry = self.modulus.plus(*entry, own);
            }
        }
        sum
    }
}

/// Returns the polynomial whose roots are the c for which the linear system with the matrix p + cq
/// has a nonzero solution. Its coefficients are residues, with the constant term first.
fn spectrum(modulus: &Modulus, p: &[Vec<u64>], q: &[Vec<u64>], random: &mut SplitMix64) -> Option<Vec<u64>> {
    let columns = p.len();
    let mut determinants = Vec::new();
    for _ in 0..2 {
        // Each row is a random combination of the equations. It holds a row of a square matrix Q
        // made from `q`, and then a row of P made from `p`.
        let mixed = (0..columns).map(|_| {
            let mixer: Vec<u64> = (0..p[0].len()).map(|_| modulus.sample(random)).collect();
            q.iter().chain(p).map(|column| modulus.dot(&mixer, column)).collect()
        });
        let echelon = Echelon::of(modulus, mixed.collect(), 2 * columns);
        if echelon.rank_of_first(columns) < columns {
            return None;
        }
        // Elimination leaves Q⁻¹P, whose eigenvalues are −c for the roots c of det(P + cQ).
        let negated = |row: &Vec<u64>| row[columns..].iter().map(|&entry| modulus.opposite(entry)).collect();
        let coefficients = characteristic(modulus, echelon.rows.iter().map(negated).collect());
        determinants.push(coefficients.iter().map(|&value| modulus.residue(value)).collect::<Vec<_>>());
    }
    Some(gcd(modulus.field(), &determinants[0], &determinants[1]))
}

/// Returns the coefficients of det(λ − M), lowest first, from Hessenberg's form of M (Cohen, A
/// Course in Computational Algebraic Number Theory, 1993, algorithm 2.2.9).
fn characteristic(modulus: &Modulus, mut rows: Vec<Vec<u64>>) -> Vec<u64> {
    let size = rows.len();
    for column in 1..size.max(1) {
        let Some(pivot) = (column..size).find(|&row| rows[row][column - 1] != 0) else { continue };
        rows.swap(pivot, column);
        rows.iter_mut().for_each(|row| row.swap(pivot, column));
        let inverse = modulus.inverse(rows[column][column - 1]).expect("a pivot is not zero");
        let (upper, lower) = rows.split_at_mut(column + 1);
        let own = &upper[column];
        let mut factors = Vec::with_capacity(lower.len());
        for row in lower {
            let factor = modulus.times(row[column - 1], inverse);
            for (entry, above) in row.iter_mut().zip(own) {
                *entry = modulus.minus(*entry, modulus.times(factor, *above));
            }
            factors.push(factor);
        }
        for row in &mut rows {
            row[column] = modulus.plus(row[column], modulus.dot(&factors, &row[column + 1..]));
        }
    }
    let mut leading = vec![vec![modulus.one()]];
    for last in 0..size {
        let before = &leading[last];
        let mut next = vec![0; last + 2];
        next[1..].copy_from_slice(before);
        let mut product = modulus.one();
        for first in (0..=last).rev() {
            let factor = modulus.times(product, rows[first][last]);
            for (entry, own) in next.iter_mut().zip(&leading[first]) {
                *entry = modulus.minus(*entry, modulus.times(factor, *own));
            }
            if first > 0 {
                product = modulus.times(product, rows[first][first - 1]);
            }
        }
        leading.push(next);
    }
    leading.pop().expect("there is one for each size")
}

/// Returns the columns of the linear system F ∂G/∂t − G ∂F/∂t − F ∂H/∂s + H ∂F/∂s = 0 for G and H.
/// The polynomial G lacks the highest power of s, which excludes the solution ∇F.
fn equations(modulus: &Modulus, degree: usize, f: &[u64]) -> Vec<Vec<u64>> {
    let wide = 2 * degree;
    let mut columns = Vec::new();
    for is_first in [true, false] {
        for (i, j) in (0..degree).flat_map(|i| (0..degree - i).map(move |j| (i, j))) {
            if is_first && i + 1 == degree {
                continue;
            }
            let mut column = vec![0; wide * wide];
            for (a, b) in (0..=degree).flat_map(|a| (0..=degree - a).map(move |b| (a, b))) {
                let factor = if is_first { j as i64 - b as i64 } else { a as i64 - i as i64 };
                let value = modulus.times(f[place(degree, a, b)], modulus.integer(factor.unsigned_abs()));
                let value = if factor < 0 { modulus.opposite(value) } else { value };
                if value != 0 {
                    let (s, t) = if is_first { (a + i, b + j - 1) } else { (a + i - 1, b + j) };
                    column[s * wide + t] = modulus.plus(column[s * wide + t], value);
                }
            }
            columns.push(column);
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_algebra::symbols::Symbols;
    use kahan_algebra::{lexer, read};

    fn polynomials(expressions: &[&str]) -> (SearchField, Symbols, Vec<Polynomial>) {
        let field = "xdot = a*x + y^2; ydot = x^2;";
        let claims = expressions.iter().enumerate().map(|(k, own)| format!(" integral H{k} = {own};"));
        let text = [field.to_owned()].into_iter().chain(claims).collect::<String>();
        let system = kahan_algebra::read_unproved(&lexer::lex(&text).tokens).system().expect("a system");
        let sides = system.claims.iter().map(|claim| crate::tests::function(claim).numerator().clone());
        let searched =
            SearchField::new(&read(&lexer::lex(field).tokens).system().expect("a system").field, None);
        (searched, system.field.symbols.clone(), sides.collect())
    }

    /// Tests three conics that factor, two of them for irrational c, and a cubic that factors.
    #[test]
    fn the_member_that_falls_apart_is_found() {
        for (product, other) in [
            ("(x + a*y - 1)*(x - 2*y + a)", "x^2 + x*y + 3 - eps*a*y^2"),
            ("(x + eps*y)*(x^2 - a*y + 2)", "x^3 + y^3 - x + 5"),
        ] {
            let mixed =
                [format!("{product} + ({other})"), format!("2*({product}) - ({other})"), product.to_owned()];
            let (searched, symbols, sides) = polynomials(&mixed.each_ref().map(String::as_str));
            let members = special_members(&searched, &sides[0], &sides[1]);
            assert!(members.contains(&primitive_in_states(&symbols, &sides[2])), "{product}: {members:?}");
        }
    }

    #[test]
    fn the_member_without_epsilon_is_found() {
        let (free, other) = ("x^3 + y^2 - a", "1 + eps^2*(x^2 + a*y^3)");
        let mixed = [format!("{free} + eps*({other})"), format!("eps*({free}) - ({other})"), free.to_owned()];
        let (searched, symbols, sides) = polynomials(&mixed.each_ref().map(String::as_str));
        assert!(
            special_members(&searched, &sides[0], &sides[1])
                .contains(&primitive_in_states(&symbols, &sides[2]))
        );
    }

    #[test]
    fn characteristic_polynomials_are_right() {
        let modulus = Modulus::mersenne_61();
        let number = |value: &i64| {
            let size = modulus.integer(value.unsigned_abs());
            if *value < 0 { modulus.opposite(size) } else { size }
        };
        for (rows, expected) in [
            ([[0, 0, 0, -5], [1, 0, 0, 0], [0, 1, 0, 3], [0, 0, 1, 2]], [5, 0, -3, -2, 1]),
            ([[2, 0, 0, 1], [0, 3, 4, 0], [0, -4, 3, 0], [0, 0, 0, -1]], [-50, -13, 29, -7, 1]),
            ([[1, 2, -1, 3], [4, 0, 5, 1], [-2, 3, 1, 2], [6, 1, -3, 2]], [170, 86, -33, -4, 1]),
        ] {
            let rows = rows.iter().map(|row| row.iter().map(number).collect()).collect();
            assert_eq!(characteristic(&modulus, rows), expected.iter().map(number).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_general_pencil_has_no_such_member() {
        let general = ["x^3 + 2*x*y^2 - y + eps*a", "eps^2*y^3 + x^2 - a*x + 7*x*y + 1"];
        let (searched, _, sides) = polynomials(&general);
        assert_eq!(special_members(&searched, &sides[0], &sides[1]), []);
    }
}
