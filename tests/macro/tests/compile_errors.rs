//! What the macro says of every kind of mistake, as rustc prints it.
//!
//! One folder a topic, one file a mistake, its expected output beside it; a file's first line tells what is wrong.
//! One mistake makes one error, at the tokens to change and in the user's terms, also where code uses the broken type
//! (`fallback`). `TRYBUILD=overwrite` renews the outputs, which are then to be read.

#[test]
fn every_mistake_is_explained_once_at_its_place() {
    trybuild::TestCases::new().compile_fail("tests/compile_errors/*/*.rs");
}
