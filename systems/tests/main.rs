//! The catalog: its entries, what the steps of its systems cost, and its closed solutions.

mod catalog {
    //! The entries, swept, and what the steps of the systems cost.

    mod entries;
    mod operation_counts;
}

mod lattices;

mod solutions {
    //! Special functions and explicit solutions: against values of another program, against
    //! identities, against each other in two precisions, and against exact orbits.

    mod e9_quadrature;
    mod exact_orbits;
    mod flows;
    mod integrals_transcendental;
    mod measure;
    mod orbits_elliptic;
    mod orbits_gamma;
    mod orbits_hyperbolic;
    mod orbits_rational;
    mod precise;
    mod root_three;
    mod rotation_numbers;
    mod special_identities;
    mod special_ulps;
    mod special_values;
}
