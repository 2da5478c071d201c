//! Tests the laws of Kahan's map over ℚ, in both back ends, at seeded points. Expected values are
//! computed from values of the field only.

use kahan_tests::back_end::BackEnd;
use kahan_tests::exact::{
    Matrix, Q, Vector, adjugate_product, determinant, difference, matrix_product, product, q, scaled, sum,
    transposed,
};
use kahan_tests::subject::{on_every_back_end, on_every_subject};

fn origin(x: &[Q]) -> Vector {
    vec![q(0, 1); x.len()]
}

/// Computes Q(x) = ½[f(x) + f(−x)] − f(0), the quadratic part of the field f.
fn quadratic_part(back_end: &dyn BackEnd, x: &[Q]) -> Vector {
    let even = sum(&back_end.field(x), &back_end.field(&scaled(&q(-1, 1), x)));
    difference(&scaled(&q(1, 2), &even), &back_end.field(&origin(x)))
}

/// Computes Bx = ½[f(x) − f(−x)], the linear part of the field f.
fn linear_part(back_end: &dyn BackEnd, x: &[Q]) -> Vector {
    let odd = difference(&back_end.field(x), &back_end.field(&scaled(&q(-1, 1), x)));
    scaled(&q(1, 2), &odd)
}

/// Computes 2f((x+y)/2) − ½f(x) − ½f(y), the right-hand side of the midpoint form of the map.
fn midpoint_form(back_end: &dyn BackEnd, x: &[Q], y: &[Q]) -> Vector {
    let middle = back_end.field(&scaled(&q(1, 2), &sum(x, y)));
    let ends = sum(&back_end.field(x), &back_end.field(y));
    difference(&scaled(&q(2, 1), &middle), &scaled(&q(1, 2), &ends))
}

#[test]
fn the_bilinear_form_is_q_of_the_sum_less_q_of_both_halved() {
    on_every_back_end(201, |back_end, x, _, rationals| {
        let y = rationals.point(x.len());
        let of_sum = quadratic_part(back_end, &sum(x, &y));
        let of_both = sum(&quadratic_part(back_end, x), &quadratic_part(back_end, &y));
        let form = scaled(&q(1, 2), &difference(&of_sum, &of_both));
        assert_eq!(back_end.bilinear(x, &y), form);
        assert_eq!(back_end.bilinear(&y, x), form);
    });
}

#[test]
fn the_polarized_field_is_the_midpoint_form_and_f_on_the_diagonal() {
    on_every_back_end(202, |back_end, x, _, rationals| {
        let y = rationals.point(x.len());
        assert_eq!(back_end.polarized(x, &y), midpoint_form(back_end, x, &y));
        assert_eq!(back_end.polarized(x, x), back_end.field(x));
    });
}

#[test]
fn the_field_s_slope_is_its_central_difference() {
    on_every_back_end(203, |back_end, x, _, _| {
        let slopes = back_end.field_jacobian(x);
        for j in 0..x.len() {
            let (mut right, mut left) = (x.to_vec(), x.to_vec());
            right[j] += q(1, 1);
            left[j] -= q(1, 1);
            let slope = scaled(&q(1, 2), &difference(&back_end.field(&right), &back_end.field(&left)));
            let column: Vector = slopes.iter().map(|row| row[j].clone()).collect();
            assert_eq!(column, slope, "column {j}");
        }
    });
}

#[test]
fn the_matrix_is_one_less_eps_times_the_slope() {
    on_every_back_end(204, |back_end, x, eps, _| {
        let mut expected = back_end.field_jacobian(x);
        for (i, row) in expected.iter_mut().enumerate() {
            *row = scaled(&-eps, row);
            row[i] += q(1, 1);
        }
        assert_eq!(back_end.matrix(x, eps), expected);
        assert_eq!(back_end.det_matrix(x, eps), determinant(&expected));
    });
}

#[test]
fn the_right_hand_side_is_x_and_eps_times_the_linear_and_twice_the_constant_part() {
    on_every_back_end(205, |back_end, x, eps, _| {
        let constant = scaled(&(q(2, 1) * eps), &back_end.field(&origin(x)));
        let expected = sum(&sum(x, &scaled(eps, &linear_part(back_end, x))), &constant);
        assert_eq!(back_end.rhs(x, eps), expected);
    });
}

fn step(back_end: &dyn BackEnd, x: &[Q], eps: &Q) -> Vector {
    back_end.step(x, eps).expect("off det A = 0 there is a step")
}

#[test]
fn the_step_satisfies_the_defining_equation() {
    on_every_back_end(206, |back_end, x, eps, _| {
        let next = step(back_end, x, eps);
        let increment = scaled(&(q(2, 1) * eps), &back_end.polarized(x, &next));
        assert_eq!(difference(&next, x), increment);
    });
}

#[test]
fn the_step_satisfies_the_midpoint_form() {
    on_every_back_end(207, |back_end, x, eps, _| {
        let next = step(back_end, x, eps);
        let increment = scaled(&(q(2, 1) * eps), &midpoint_form(back_end, x, &next));
        assert_eq!(difference(&next, x), increment);
    });
}

#[test]
fn the_step_solves_the_linear_system_and_its_increment_form() {
    on_every_back_end(208, |back_end, x, eps, _| {
        let (next, matrix) = (step(back_end, x, eps), back_end.matrix(x, eps));
        assert_eq!(product(&matrix, &next), back_end.rhs(x, eps));
        let increment = scaled(&(q(2, 1) * eps), &back_end.field(x));
        assert_eq!(product(&matrix, &difference(&next, x)), increment);
    });
}

#[test]
fn stepping_back_returns_the_start_exactly() {
    on_every_back_end(209, |back_end, x, eps, _| {
        let next = step(back_end, x, eps);
        let back = -eps;
        assert_eq!(product(&back_end.matrix(&next, &back), x), back_end.rhs(&next, &back));
        if back_end.det_matrix(&next, &back) != q(0, 1) {
            assert_eq!(step(back_end, &next, &back), x);
        }
    });
}

#[test]
fn a_step_of_no_time_stays() {
    on_every_back_end(210, |back_end, x, _, _| {
        assert_eq!(step(back_end, x, &q(0, 1)), x);
        assert_eq!(back_end.det_matrix(x, &q(0, 1)), q(1, 1));
    });
}

#[test]
fn the_jacobian_is_the_inverse_of_a_here_times_a_there_with_minus_eps() {
    on_every_back_end(211, |back_end, x, eps, _| {
        let next = step(back_end, x, eps);
        let (here, there) = (back_end.matrix(x, eps), back_end.matrix(&next, &-eps));
        let jacobian = back_end.jacobian(x, eps).expect("off det A = 0 there is a Jacobian");
        assert_eq!(matrix_product(&here, &jacobian), there);
        let quotient = determinant(&there) / determinant(&here);
        assert_eq!(back_end.det_jacobian(x, eps), Some(quotient));
    });
}

#[test]
fn tangent_vectors_are_carried_by_the_jacobian() {
    on_every_back_end(219, |back_end, x, eps, rationals| {
        let (next, v) = (step(back_end, x, eps), rationals.point(x.len()));
        let jacobian = back_end.jacobian(x, eps).expect("off det A = 0 there is a Jacobian");
        assert_eq!(back_end.push_forward(x, &next, &v, eps), Some(product(&jacobian, &v)));
    });
}

#[test]
fn the_rational_map_is_cramer_s_rule() {
    on_every_back_end(212, |back_end, x, eps, _| {
        let (numerators, denominator) = back_end.rational_map(x, eps);
        let matrix = back_end.matrix(x, eps);
        assert_eq!(denominator, determinant(&matrix));
        assert_eq!(numerators, adjugate_product(&matrix, &back_end.rhs(x, eps)));
        assert_eq!(numerators, scaled(&denominator, &step(back_end, x, eps)));
    });
}

/// For ε = 1/(∂f₁/∂x₁) the entry A₁₁ is 0, so elimination must exchange rows.
#[test]
fn a_zero_in_the_first_pivot_s_place_changes_nothing() {
    let swapped = std::cell::Cell::new(0);
    on_every_back_end(216, |back_end, x, _, _| {
        let slope = back_end.field_jacobian(x)[0][0].clone();
        if slope == q(0, 1) {
            return;
        }
        let eps = q(1, 1) / slope;
        let matrix = back_end.matrix(x, &eps);
        assert_eq!(matrix[0][0], q(0, 1));
        assert_eq!(back_end.det_matrix(x, &eps), determinant(&matrix));
        if determinant(&matrix) == q(0, 1) {
            return;
        }
        swapped.set(swapped.get() + 1);
        let next = step(back_end, x, &eps);
        assert_eq!(product(&matrix, &next), back_end.rhs(x, &eps));
        let there = back_end.matrix(&next, &-&eps);
        let jacobian = back_end.jacobian(x, &eps).expect("off det A = 0 there is a Jacobian");
        assert_eq!(matrix_product(&matrix, &jacobian), there);
        assert_eq!(back_end.det_jacobian(x, &eps), Some(determinant(&there) / determinant(&matrix)));
    });
    assert!(swapped.get() >= 40, "only {} points", swapped.get());
}

#[test]
fn an_orbit_is_repeated_steps_and_ends_only_at_a_pole() {
    on_every_back_end(213, |back_end, x, eps, _| {
        let (points, stopped) = back_end.orbit(x, eps, 2);
        assert_eq!(points[0], x);
        for pair in points.windows(2) {
            assert_eq!(back_end.step(&pair[0], eps).as_ref(), Some(&pair[1]));
        }
        let last = &points[points.len() - 1];
        assert_eq!(stopped, points.len() < 3);
        assert!(!stopped || back_end.step(last, eps).is_none());
    });
}

#[test]
fn a_homogeneous_field_has_both_forms_of_the_map_and_scales() {
    let homogeneous = std::cell::Cell::new(0);
    on_every_subject(214, |subject, x, eps, rationals| {
        if !subject.system.field.is_homogeneous() {
            return;
        }
        homogeneous.set(homogeneous.get() + 1);
        let factor = rationals.nonzero();
        for back_end in subject.back_ends() {
            let next = step(back_end, x, eps);
            assert_eq!(back_end.rhs(x, eps), x);
            assert_eq!(product(&back_end.matrix(&next, &-eps), x), next, "x̃ = A(x̃,−ε)x");
            assert_eq!(step(back_end, &scaled(&factor, x), &(eps / &factor)), scaled(&factor, &next));
        }
    });
    assert!(homogeneous.get() >= 3 * 16, "the catalog but for one, and the sparse fields");
}

#[test]
fn integrals_densities_and_brackets_are_invariant() {
    let compared = std::cell::Cell::new(0);
    let count = || compared.set(compared.get() + 1);
    on_every_back_end(215, |back_end, x, eps, _| {
        let next = step(back_end, x, eps);
        let jacobian = back_end.jacobian(x, eps).expect("off det A = 0 there is a Jacobian");
        if let (Some(here), Some(there)) = (back_end.integrals(x, eps), back_end.integrals(&next, eps)) {
            assert_eq!(here, there);
            count();
        }
        if let (Some(here), Some(there)) = (back_end.density(x, eps), back_end.density(&next, eps)) {
            assert_eq!(here, there * determinant(&jacobian));
            count();
        }
        for name in ["P", "Q"] {
            let (here, there) = (back_end.bracket(name, x, eps), back_end.bracket(name, &next, eps));
            if let (Some(here), Some(there)) = (here, there) {
                let moved: Matrix = matrix_product(&matrix_product(&jacobian, &here), &transposed(&jacobian));
                assert_eq!(moved, there, "{name}");
                count();
            }
        }
    });
    assert!(compared.get() >= 200, "only {} claims had values", compared.get());
}
