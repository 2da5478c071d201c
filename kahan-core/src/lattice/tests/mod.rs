//! Tests of chains, on handwritten families.

mod dense;
#[cfg(feature = "exact")]
mod exact;
mod families;
mod parts;

#[test]
fn a_total_keeps_what_its_sum_lost() {
    let mut total = super::sums::CompensatedSum::zero();
    for term in [1.0_f64, 1e100, 1.0, -1e100] {
        total.add(&term);
    }
    assert_eq!(total.sum(), 2.0);
}

fn random(seed: u64) -> impl Iterator<Item = u64> {
    (1_u64..).map(move |k| {
        let z = (seed ^ k.wrapping_mul(0x9e37_79b9_7f4a_7c15)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (z ^ (z >> 29)).wrapping_mul(0x94d0_49bb_1331_11eb) ^ (z >> 32)
    })
}
