//! Writes job descriptions for Slurm and Kubernetes from templates.

use std::path::Path;

/// Returns a Slurm array job with one task for each shard.
pub(crate) fn slurm(plan: &Path, out: &Path, shards: u64) -> String {
    let places = [("shards", shards.to_string()), ("plan", quoted(plan)), ("out", quoted(out))];
    fill_template(include_str!("scripts/slurm.sh"), &places)
}

/// Returns an indexed Kubernetes Job with one completion for each shard.
pub(crate) fn kubernetes(plan: &Path, shards: u64) -> String {
    let places = [
        ("shards", shards.to_string()),
        ("parallelism", shards.min(64).to_string()),
        ("backoff", (6 * shards).to_string()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("plan", quoted(plan)),
    ];
    fill_template(include_str!("scripts/kubernetes.yaml"), &places)
}

/// Replaces each `@name@` in a template by its text, in one pass.
fn fill_template(template: &str, places: &[(&str, String)]) -> String {
    let parts = template.split('@').enumerate().map(|(part, text)| {
        let filled = places.iter().find(|(name, _)| part % 2 == 1 && *name == text);
        filled.map_or(text, |(_, value)| value)
    });
    parts.collect()
}

fn quoted(path: &Path) -> String {
    let text = path.to_string_lossy();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-+./:=,".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text.into_owned()
    } else {
        // The Slurm script also has the path in a comment. Newlines would end the comment.
        format!("'{}'", text.replace('\'', r"'\''").replace('\n', r"'$'\n''"))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::process::Command;

    use super::{kubernetes, quoted, slurm};

    const NAMES: [&str; 5] =
        ["plan.toml", "it's a plan: #1.toml", "ü \"%A\" $HOME `x`", "two\nlines", "a&b;c|d>e"];

    #[cfg(unix)]
    #[test]
    fn a_shell_reads_paths_as_they_are() {
        for name in NAMES {
            let script = format!("printf %s {}", quoted(Path::new(name)));
            let said = Command::new("bash").args(["-c", &script]).output().expect("a shell").stdout;
            assert_eq!(String::from_utf8(said).as_deref(), Ok(name));
        }
    }

    #[test]
    fn names_leave_job_descriptions_as_they_are() {
        let lines = |text: String| {
            let lines = text.lines().filter(|line| !line.starts_with("exec") && !line.starts_with("# "));
            lines.map(|line| format!("{line}\n")).collect::<String>()
        };
        let comments = |text: String| text.lines().filter(|line| line.starts_with('#')).count();
        let of = |name: &str| [slurm(Path::new(name), Path::new(name), 7), kubernetes(Path::new(name), 7)];
        for name in NAMES {
            for (text, plain) in of(name).into_iter().zip(of("plan.toml")) {
                assert_eq!(lines(text.clone()), lines(plain.clone()), "{name}");
                assert_eq!(comments(text), comments(plain), "{name}");
            }
        }
    }
}
