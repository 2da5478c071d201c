//! What no single crate can test. One program, so that what its modules share is compiled and
//! linked once; `tests/README.md` says which test goes where.

mod blocks {
    //! Blocks of `kahan!`: wherever they stand, whatever is in them, and from what is found.

    mod discovered;
    mod same_text;
    mod surroundings;
    mod token_soup;
}

mod exact {
    //! Over ℚ, with `==`, in both back ends.

    mod back_ends;
    mod defining_laws;
    mod fixed_points;
    mod folding;
    mod oracle_cases;
    mod printed_formulas;
    mod there_and_back;
    mod through_poles;
}

mod floats {
    //! Floats against exact numbers, within bounds that are derived.

    mod allocation;
    mod compensated;
    mod derived_bounds;
    mod double_double_steps;
    mod half_steps;
    mod long_tangents;
    mod one_step;
    mod prepared;
    mod stable;
    mod through_f64;
}

mod many;

mod methods {
    //! Compositions, estimates, orders.

    mod composition;
    mod error_estimate;
    mod slopes;
}
