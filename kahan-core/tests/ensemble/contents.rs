//! Tests the points, columns and grids of an ensemble.

use kahan_core::prelude::*;
use kahan_core::{Axis, Ensemble, Level};

use crate::ensemble::points;
use crate::systems::LotkaVolterra;

#[test]
fn points_come_back_in_order() {
    for len in [0, 1, 15, 16, 17, 40] {
        let start = points::<3>(len);
        let ensemble = Ensemble::new(start.clone());
        assert_eq!((ensemble.len(), ensemble.is_empty()), (len, len == 0));
        assert_eq!(ensemble.points().len(), len);
        assert!(ensemble.points().eq(start.iter().copied()));
        assert!(ensemble.points().rev().eq(start.iter().rev().copied()));
        for c in 0..3 {
            assert!(ensemble.column(c).iter().eq(start.iter().map(|x| &x[c])));
        }
        assert_eq!(ensemble.point(len), None);
        assert_eq!(len.checked_sub(1).map(|i| ensemble.point(i)), start.last().copied().map(Some));
        assert_eq!(ensemble.clone(), ensemble);
    }
}

#[test]
fn columns_begin_with_a_cache_line() {
    for len in [1, 100, 1000] {
        let ensemble = Ensemble::new(points::<3>(len));
        for ensemble in [ensemble.clone(), ensemble] {
            for c in 0..3 {
                assert!(cfg!(miri) || ensemble.column(c).as_ptr().addr().is_multiple_of(64));
            }
        }
    }
}

#[test]
#[should_panic(expected = "variable 2 of a state of 2")]
fn there_is_a_column_for_each_variable_only() {
    Ensemble::new(vec![vector![1.0, 2.0]]).column(2);
}

#[test]
fn ensembles_are_equal_where_their_points_are() {
    let ensemble = Ensemble::new(points::<2>(20));
    let mut other = ensemble.clone().at_level(Level::Baseline).expect("every processor has it");
    assert_eq!(ensemble, other);
    assert_ne!(ensemble, Ensemble::new(points(19)));
    other.advance(&LotkaVolterra.at(0.1), 1);
    assert_ne!(ensemble, other);
    assert_eq!(format!("{:?}", Ensemble::new(vec![vector![1.0, 2.0]])), "[[[1.0, 2.0]]]");
}

#[test]
fn a_grid_is_in_the_order_of_nested_loops() {
    let axes = [
        Axis { start: 0.0, end: 1.0, count: 11 },
        Axis { start: -1.0, end: 1.0, count: 1 },
        Axis { start: 2.0, end: -2.0, count: 5 },
    ];
    let grid = Ensemble::grid(axes);
    let mut expected = Vec::new();
    for x in [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0] {
        for z in [2.0, 1.0, 0.0, -1.0, -2.0] {
            expected.push(vector![x, -1.0, z]);
        }
    }
    assert!(grid.points().eq(expected));
    assert!(Ensemble::grid([Axis { start: 0.0_f32, end: 1.0, count: 0 }; 2]).is_empty());
}

#[test]
fn a_grid_of_one_kind_of_float_is_that_of_the_other_rounded() {
    let double = Ensemble::grid([Axis { start: -3.0, end: 5.0, count: 97 }]);
    let single = Ensemble::grid([Axis { start: -3.0_f32, end: 5.0, count: 97 }]);
    assert!(double.points().zip(single.points()).all(|(double, single)| double[0] as f32 == single[0]));
}

#[test]
#[should_panic(expected = "a grid of more points than memory can hold")]
fn a_grid_beyond_memory_is_refused() {
    let _ = Ensemble::grid([Axis { start: 0.0, end: 1.0, count: usize::MAX }; 2]);
}
