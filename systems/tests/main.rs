//! Tests of the catalog: entries, costs of steps, lattices and closed solutions.

mod catalog {

    mod entries;
    mod operation_counts;
}

mod lattices;

mod solutions {
    //! Compares special functions and closed solutions with mpmath, identities, exact orbits and
    //! results of a second precision.

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
