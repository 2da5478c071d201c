//! Tests that involve several crates, in one program, so that shared modules are compiled and
//! linked once. `tests/README.md` says where a test belongs.

mod blocks {
    //! Tests `kahan!` blocks: their surroundings, their contents, and discovered blocks.

    mod discovered;
    mod same_text;
    mod surroundings;
    mod token_soup;
}

mod exact {
    //! Tests over ℚ, in generated code and in the interpreter.

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
    //! Tests floats against exact numbers, with derived bounds.

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
    //! Tests compositions, error estimates and orders.

    mod composition;
    mod error_estimate;
    mod slopes;
}
