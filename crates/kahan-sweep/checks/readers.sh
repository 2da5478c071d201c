# The merged file in pandas, Polars, DuckDB and pyarrow: names, numbers, units, the plan.
python_with pandas polars duckdb pyarrow
python "$crate/checks/readers.py" "$undisturbed/results.parquet"
