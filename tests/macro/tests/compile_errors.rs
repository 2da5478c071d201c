//! What the macro says of every kind of mistake, as rustc prints it.
//!
//! One file a topic, one block a mistake, the expected output beside it; the line above a block
//! tells what is wrong. Where there is more than a block, a mistake has a file of its own in the
//! folder of its topic. One mistake makes one error, at the tokens to change and in the user's
//! terms, also where code uses the broken type (`fallback`). `TRYBUILD=overwrite` renews the
//! outputs, which are then to be read.

#[test]
fn every_mistake_is_explained_once_at_its_place() {
    let cases = trybuild::TestCases::new();
    for files in ["tests/compile_errors/*.rs", "tests/compile_errors/*/*.rs"] {
        cases.compile_fail(files);
    }
}
