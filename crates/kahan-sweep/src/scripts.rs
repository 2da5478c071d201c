//! Job descriptions for the schedulers that are there.

use std::path::Path;

/// An array job for Slurm, a task a shard.
pub(crate) fn slurm(plan: &Path, out: &Path, shards: u64) -> String {
    let (plan, out) = (quoted(plan), quoted(out));
    format!(
        "#!/bin/bash\n\
         # An array of {shards} tasks, a shard each; `sbatch` this file. A task that is cut short goes on where it\n\
         # stopped when this is submitted again.\n\
         #SBATCH --job-name=kahan-sweep\n\
         #SBATCH --array=1-{shards}\n\
         #SBATCH --ntasks=1\n\
         #SBATCH --cpus-per-task=1\n\
         #SBATCH --time=01:00:00\n\
         #SBATCH --output=kahan-sweep-%A-%a.log\n\
         #SBATCH --requeue\n\
         set -eu\n\
         exec kahan-sweep {plan} --out {out} --shard \"$SLURM_ARRAY_TASK_ID/{shards}\" --threads \"${{SLURM_CPUS_PER_TASK:-1}}\"\n\
         # When all tasks are done: kahan-sweep {plan} --out {out} --merge\n"
    )
}

/// An indexed Job for Kubernetes, a completion a shard.
pub(crate) fn kubernetes(plan: &Path, shards: u64) -> String {
    // Keys of config maps are of few letters, so the plan has one name there, whatever its file's
    // is.
    let plan = quoted(plan);
    format!(
        "# An indexed Job of {shards} completions, a shard each. Before it:\n\
         #   kubectl create configmap kahan-sweep-plan --from-file=plan.toml={plan}\n\
         # and a claim `kahan-sweep-results` for a volume that all nodes can write, and an image with kahan-sweep in it.\n\
         apiVersion: batch/v1\n\
         kind: Job\n\
         metadata:\n\
         \x20 name: kahan-sweep\n\
         spec:\n\
         \x20 completionMode: Indexed\n\
         \x20 completions: {shards}\n\
         \x20 parallelism: {parallelism}\n\
         \x20 backoffLimit: {backoff}\n\
         \x20 template:\n\
         \x20   spec:\n\
         \x20     restartPolicy: OnFailure\n\
         \x20     containers:\n\
         \x20       - name: kahan-sweep\n\
         \x20         image: kahan-sweep:{version}\n\
         \x20         args: [\"/plan/plan.toml\", \"--out\", \"/results\", \"--threads\", \"1\"]\n\
         \x20         env:\n\
         \x20           - name: KAHAN_SHARDS\n\
         \x20             value: \"{shards}\"\n\
         \x20         resources:\n\
         \x20           requests: {{ cpu: \"1\", memory: 300Mi }}\n\
         \x20         volumeMounts:\n\
         \x20           - {{ name: plan, mountPath: /plan, readOnly: true }}\n\
         \x20           - {{ name: results, mountPath: /results }}\n\
         \x20     volumes:\n\
         \x20       - name: plan\n\
         \x20         configMap: {{ name: kahan-sweep-plan }}\n\
         \x20       - name: results\n\
         \x20         persistentVolumeClaim: {{ claimName: kahan-sweep-results }}\n",
        parallelism = shards.min(64),
        backoff = 6 * shards,
        version = env!("CARGO_PKG_VERSION"),
    )
}

/// A path as a shell reads it.
fn quoted(path: &Path) -> String {
    let text = path.to_string_lossy();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-+./:=,".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text.into_owned()
    } else {
        // A line within a comment would end it.
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
