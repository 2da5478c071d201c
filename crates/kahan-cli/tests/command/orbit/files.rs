//! Output files.

use super::*;
use crate::running::refusal;

const SHORT: [&str; 7] = ["e6", "--eps", "0.1", "--at", "1,2,3", "--steps", "9"];

#[test]
fn a_file_holds_what_would_be_printed_and_replaces_an_older_one() {
    let folder = folder();
    let file = folder.path().join("orbit.csv");
    fs::write(&file, "older").expect("a file");
    let arguments: Vec<&str> = SHORT.into_iter().chain(["--out", path_text(&file)]).collect();
    assert_eq!(answer(&arguments), "");
    assert_eq!(fs::read_to_string(&file).expect("the file"), answer(&SHORT));
    assert_eq!(contents(&folder), ["orbit.csv"]);
}

#[cfg(unix)]
#[test]
fn a_file_may_be_read_by_whom_new_files_may_be_read_by_and_links_are_followed() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder();
    let (file, other, link) =
        (folder.path().join("orbit.csv"), folder.path().join("other"), folder.path().join("link"));
    fs::write(&other, "").expect("a file");
    std::os::unix::fs::symlink(&other, &link).expect("a link");
    answer(&SHORT.into_iter().chain(["--out", path_text(&file)]).collect::<Vec<_>>());
    answer(&SHORT.into_iter().chain(["--out", path_text(&link)]).collect::<Vec<_>>());
    let mode = |path: &Path| fs::metadata(path).expect("a file").permissions().mode();
    assert_eq!(mode(&file), mode(&other));
    assert_eq!(fs::read(&file).expect("the file"), fs::read(&other).expect("the file"));
    assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
}

#[test]
fn the_ending_of_a_table_is_that_of_its_format() {
    let parquet = ["--out", "no.parquet"];
    let orbit = refusal(&[&["orbit"], &SHORT[..], &parquet].concat());
    let start = ["--eps", "1/9", "--at", "1,2", "--steps", "9"];
    let heights = refusal(&[&["heights", "lv"], &start[..], &parquet].concat());
    let section = refusal(&[&["section", "lv", "--plane", "x - 1"], &start[..], &parquet].concat());
    for told in [orbit, heights, section] {
        assert!(told.contains("no.parquet") && told.contains("ends in .csv"), "{told}");
    }
}

#[test]
fn what_is_refused_leaves_an_older_file_alone() {
    let folder = folder();
    let file = folder.path().join("orbit.csv");
    fs::write(&file, "older").expect("a file");
    let output = kahan(&["e6", "--eps", "0.1", "--at", "1,2", "--steps", "9", "--out", path_text(&file)]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(fs::read_to_string(&file).expect("the file"), "older");
    assert_eq!(contents(&folder), ["orbit.csv"]);
}

#[cfg(unix)]
#[test]
fn places_without_a_file_are_refused() {
    let folder = folder();
    let missing = folder.path().join("no/such/folder/orbit.csv");
    for (place, reason) in
        [(folder.path(), "directory"), (&missing, "does not exist"), (Path::new("/dev/null"), "ordinary")]
    {
        let output = kahan(&SHORT.into_iter().chain(["--out", path_text(place)]).collect::<Vec<_>>());
        let paragraph = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{paragraph}");
        assert!(paragraph.contains("--out") && paragraph.contains(reason), "{paragraph}");
    }
}

struct Endless(Child);

impl Drop for Endless {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn a_file_that_is_not_finished_never_has_its_name() {
    let folder = folder();
    let file = folder.path().join("orbit.csv");
    let arguments =
        ["lv", "--eps", "0.1", "--at", "1/2,5/3", "--steps", "1000000000000", "--every", "1000000"];
    let child = command(&arguments).args(["--out", path_text(&file)]).stderr(Stdio::null()).spawn();
    let running = Endless(child.expect("the command runs"));
    let is_begun = (0..6000).any(|_| {
        std::thread::sleep(Duration::from_millis(5));
        !contents(&folder).is_empty()
    });
    assert!(is_begun, "nothing is written");
    assert!(!file.exists());
    drop(running);
    assert!(!file.exists());
}
