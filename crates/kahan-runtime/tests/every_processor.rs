//! Steps and orbits have equal bits on every processor; the expected bits were found on x86-64.
#![cfg(not(target_feature = "fma"))]

use kahan_core::prelude::*;
use kahan_runtime::{Field, MapAt};
use kahan_systems::{E1, E3};

const FIELDS: [(&str, &[f64]); 4] = [
    ("xdot = 10*(y - x); ydot = 28*x - y - x*z; zdot = x*y - 8/3*z;", &[1.0, 1.0, 1.0]),
    ("xdot = y*z; ydot = -2*x*z; zdot = x*y;", &[1.0, 2.0, 3.0]),
    ("xdot = v; vdot = -x - x^2;", &[0.3, 0.0]),
    ("xdot = x*(1 - y); ydot = y*(x - 1) + z/7; zdot = u*x - z; udot = -z*u;", &[1.5, 1.0, 0.25, -0.5]),
];

fn read(text: &str) -> Field {
    Field::parse(text).expect("a field")
}

fn bits(map: &MapAt<f64>, start: &[f64]) -> Vec<u64> {
    let mut alone = start.to_vec();
    map.advance(&mut alone, 5000).expect("finite");
    let mut columns: Vec<Vec<f64>> = start.iter().map(|x| vec![*x; 9]).collect();
    let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    map.advance_columns(&mut slices, &[], &[], 5000).expect("finite");
    let last = columns.iter().map(|column| column[8]);
    alone.iter().copied().chain(last).map(f64::to_bits).collect()
}

#[test]
fn fields_read_at_run_time() {
    let found: Vec<Vec<u64>> = FIELDS
        .iter()
        .map(|(text, start)| {
            let field = read(text);
            let map = field.with::<&str, f64>([]).expect("it has no parameters").at(0.005);
            bits(&map, start)
        })
        .collect();
    assert_eq!(found, EXPECTED.map(<[u64]>::to_vec), "{found:#x?}");
}

#[test]
fn generated_code() {
    let after = |step: &dyn Fn(&SVector<f64, 3>) -> SVector<f64, 3>| {
        let end = (0..1000).fold(SVector::from([1.0, 2.0, 3.0]), |x, _| step(&x));
        [end[0], end[1], end[2]].map(f64::to_bits)
    };
    let found = [after(&|x| E1.step(x, 0.01)), after(&|x| E3.step(x, 0.01))];
    assert_eq!(found, GENERATED, "{found:#x?}");
}

/// For each field, the bits of an orbit's last point by `advance`, then by `advance_columns`.
const EXPECTED: [&[u64]; 4] = [
    &[
        0xc006_cb97_8df5_bc3e,
        0x3ffe_6252_b6b5_a891,
        0x403b_f3e4_ef04_5120,
        0xc006_cb97_8df5_bc3e,
        0x3ffe_6252_b6b5_a891,
        0x403b_f3e4_ef04_5120,
    ],
    &[
        0xbff2_7957_d8bd_f752,
        0xbffd_36be_40b8_0643,
        0x4008_70ba_b8e1_6e9c,
        0xbff2_7957_d8bd_f752,
        0xbffd_36be_40b8_0643,
        0x4008_70ba_b8e1_6e9c,
    ],
    &[0xbfd7_c166_c744_30a4, 0x3fb0_d11f_bb33_20f4, 0xbfd7_c166_c744_307b, 0x3fb0_d11f_bb33_217a],
    &[
        0x0000_0000_0000_0003,
        0x3cda_08d6_0cb2_2997,
        0x3cb0_2945_6d57_b932,
        0x94ba_e363_b91b_3e4a,
        0x0000_0000_0000_0003,
        0x3cda_08d6_0cb2_2997,
        0x3cb0_2945_6d57_b932,
        0x94ba_e363_b91b_3e4a,
    ],
];

const GENERATED: [[u64; 3]; 2] = [
    [0x3fa8_6186_1861_8615, 0x3fb8_6186_1861_8615, 0x4062_5a5f_c7c8_1a7b],
    [0x3931_f231_cfee_d8e4, 0x3941_f231_cfee_d8e4, 0x400d_ecff_d347_bb3f],
];
