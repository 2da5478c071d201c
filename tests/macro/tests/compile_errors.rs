//! Tests the macro's error messages, as rustc prints them.
//!
//! Each file covers a topic. It has one mistake in each block, and a comment above the block. The
//! expected output is beside the file. Mistakes that need more than a block have files in the
//! topic's folder. Every mistake must give one error, at the tokens to change and in the user's
//! terms, even where code uses the broken type (folder `fallback`). `TRYBUILD=overwrite` renews the
//! outputs; review them.

#[test]
fn every_mistake_is_explained_once_at_its_place() {
    let cases = trybuild::TestCases::new();
    for files in ["tests/compile_errors/*.rs", "tests/compile_errors/*/*.rs"] {
        cases.compile_fail(files);
    }
}
