//! The permutation of 1600 bits that SHA-3 is made of (FIPS 202, section 3).
//!
//! In goes a state of 25 lanes, lane x + 5y at column x and row y; it comes out permuted. It is
//! written as plain loops, which take less than half the time of a crate for it where nothing is
//! optimised: in every expansion of the macro in a debug build.

/// What ι adds in each round.
const ROUNDS: [u64; 24] = [
    0x0000_0000_0000_0001,
    0x0000_0000_0000_8082,
    0x8000_0000_0000_808a,
    0x8000_0000_8000_8000,
    0x0000_0000_0000_808b,
    0x0000_0000_8000_0001,
    0x8000_0000_8000_8081,
    0x8000_0000_0000_8009,
    0x0000_0000_0000_008a,
    0x0000_0000_0000_0088,
    0x0000_0000_8000_8009,
    0x0000_0000_8000_000a,
    0x0000_0000_8000_808b,
    0x8000_0000_0000_008b,
    0x8000_0000_0000_8089,
    0x8000_0000_0000_8003,
    0x8000_0000_0000_8002,
    0x8000_0000_0000_0080,
    0x0000_0000_0000_800a,
    0x8000_0000_8000_000a,
    0x8000_0000_8000_8081,
    0x8000_0000_0000_8080,
    0x0000_0000_8000_0001,
    0x8000_0000_8000_8008,
];

/// π moves all lanes but the first in one cycle: where each goes, lane 1 first.
const PLACES: [usize; 24] =
    [10, 7, 11, 17, 18, 3, 5, 16, 8, 21, 24, 4, 15, 23, 19, 13, 12, 2, 20, 14, 22, 9, 6, 1];

/// By how many bits ρ turns the lane that goes there: the triangular numbers.
const TURNS: [u32; 24] =
    [1, 3, 6, 10, 15, 21, 28, 36, 45, 55, 2, 14, 27, 41, 56, 8, 25, 43, 62, 18, 39, 61, 20, 44];

/// Permutes a state.
pub(super) fn permute(state: &mut [u64; 25]) {
    for round in ROUNDS {
        add_columns(state);
        let mut moved = state[1];
        let mut step = 0;
        while step < 24 {
            let place = PLACES[step];
            let next = state[place];
            state[place] = moved.rotate_left(TURNS[step]);
            moved = next;
            step += 1;
        }
        combine_rows(state);
        state[0] ^= round;
    }
}

/// θ: to each lane the parities of the columns beside it.
fn add_columns(state: &mut [u64; 25]) {
    let mut parity = [0; 5];
    let mut lane = 0;
    while lane < 25 {
        parity[lane % 5] ^= state[lane];
        lane += 1;
    }
    lane = 0;
    while lane < 25 {
        state[lane] ^= parity[(lane + 4) % 5] ^ parity[(lane + 1) % 5].rotate_left(1);
        lane += 1;
    }
}

/// χ: to each lane what the two behind it in its row make.
fn combine_rows(state: &mut [u64; 25]) {
    let mut row = 0;
    while row < 25 {
        let [a, b, c, d, e] = [state[row], state[row + 1], state[row + 2], state[row + 3], state[row + 4]];
        state[row] = a ^ (!b & c);
        state[row + 1] = b ^ (!c & d);
        state[row + 2] = c ^ (!d & e);
        state[row + 3] = d ^ (!e & a);
        state[row + 4] = e ^ (!a & b);
        row += 5;
    }
}
