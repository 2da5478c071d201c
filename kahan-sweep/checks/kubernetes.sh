# Kubernetes: the Job of --for kubernetes against the schemas of three versions, and its pods played by a loop.
python_with kubernetes-validate pyyaml
kahan-sweep plan.toml --for kubernetes --shards 5 >job.yaml
for version in $(kubernetes-validate --help | grep -oE '1\.[0-9]+' | sort -uV | tail -n 3); do
    kubernetes-validate --strict --version "$version" job.yaml || fail "version $version refuses the Job"
done
# No cluster is here: this plays the controller, which starts a container for each index and starts again what died.
mkdir results
python "$crate/checks/pods.py" job.yaml "/plan=$PWD" "/results=$PWD/results"
merges_to_the_same results
echo "the Job is valid; five containers as it describes them, one killed: the same bytes (no cluster was here)"
