//! Tests over ℚ that zeros of the field are fixed points of the map.

use std::cell::{Cell, RefCell};

use kahan_core::prelude::BigRational;
use kahan_tests::exact::q;
use kahan_tests::subject::on_every_subject;

fn grid(dimension: usize) -> Vec<Vec<BigRational>> {
    let entries = [q(0, 1), q(1, 1)];
    (0..dimension).fold(vec![Vec::new()], |points, _| {
        let longer = |point: &Vec<_>| entries.clone().map(|entry| [point.clone(), vec![entry]].concat());
        points.iter().flat_map(longer).collect()
    })
}

#[test]
fn equilibria_of_the_flow_are_fixed_points_of_the_map() {
    let (found, seen) = (Cell::new(0), RefCell::new(Vec::new()));
    on_every_subject(107, |subject, _, eps, _| {
        if seen.borrow().contains(&subject.name) {
            return;
        }
        seen.borrow_mut().push(subject.name);
        let [generated, interpreted] = subject.back_ends();
        let zero = vec![q(0, 1); subject.dimension()];
        for x in grid(subject.dimension()) {
            let is_equilibrium = interpreted.field(&x) == zero;
            let has_a_step = interpreted.det_matrix(&x, eps) != q(0, 1);
            if is_equilibrium && has_a_step {
                found.set(found.get() + 1);
                for back_end in [generated, interpreted] {
                    assert_eq!(
                        back_end.step(&x, eps).as_ref(),
                        Some(&x),
                        "{} {}",
                        back_end.label(),
                        subject.name
                    );
                }
            }
        }
    });
    assert!(found.get() > 40, "{found:?}");
}
