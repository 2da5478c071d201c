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
    let name = plan.file_name().unwrap_or_default().to_string_lossy().into_owned();
    format!(
        "# An indexed Job of {shards} completions, a shard each. Before it:\n\
         #   kubectl create configmap kahan-sweep-plan --from-file={name}\n\
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
         \x20         args: [\"/plan/{name}\", \"--out\", \"/results\", \"--threads\", \"1\"]\n\
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
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}
