# Kubernetes: the Job of --for kubernetes against the schemas of three versions, and its pods played by a loop.
python_with kubernetes-validate pyyaml
# Whatever the plan's name is, it is plan.toml to the pods.
cp plan.toml "a plan: #1 'ü', \"%A\".toml"
kahan-sweep "a plan: #1 'ü', \"%A\".toml" --for kubernetes --shards 5 >job.yaml
# The oldest version whose schema is known, the newest, and one between.
newest=$(kubernetes-validate --version)
for version in 1.25.0 1.30.0 "$newest"; do
    kubernetes-validate --strict --kubernetes-version "$version" job.yaml || fail "version $version refuses the Job"
done
sed 's/completions:/completion:/' job.yaml >wrong.yaml
kubernetes-validate --strict wrong.yaml >/dev/null 2>&1 && fail "a Job with a mistake is valid, too"
# No cluster is here: this plays the controller, which starts a container for each index and starts again what died.
mkdir results
python "$crate/checks/pods.py" job.yaml "/plan=$PWD" "/results=$PWD/results"
merges_to_the_same results
echo "the Job is valid in 1.25, 1.30 and $newest; five containers as it describes them, one killed: the same bytes (no cluster was here)"
