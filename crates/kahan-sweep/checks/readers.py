"""Reads a merged file with four libraries, which must agree: readers.py FILE

The file is that of `check`'s plan, so that its axes can be computed here, too."""

import json
import sys

import duckdb
import pandas
import polars
import pyarrow.parquet

path = sys.argv[1]

arrow = pyarrow.parquet.read_table(path)
names = arrow.column_names
tables = {
    "pyarrow": {name: arrow.column(name).to_numpy() for name in names},
    "pandas": {name: pandas.read_parquet(path)[name].to_numpy() for name in names},
    "Polars": {name: polars.read_parquet(path)[name].to_numpy() for name in names},
    "DuckDB": duckdb.execute("select * from read_parquet(?)", [path]).fetchnumpy(),
}
for reader, table in tables.items():
    assert list(table) == names, (reader, list(table))
    for name in names:
        # Bits, so that NaN is NaN and no rounding goes unseen.
        assert bytes(table[name]) == bytes(tables["pyarrow"][name]), (reader, name)

metadata = {
    "pyarrow": {key.decode(): value.decode() for key, value in arrow.schema.metadata.items()},
    "Polars": polars.read_parquet_metadata(path),
    "DuckDB": {
        bytes(key).decode(): bytes(value).decode()
        for key, value in duckdb.execute("select key, value from parquet_kv_metadata(?)", [path]).fetchall()
    },
}
for reader, said in metadata.items():
    assert {key: said[key] for key in metadata["pyarrow"]} == metadata["pyarrow"], reader
said = metadata["pyarrow"]
meanings = json.loads(said["kahan.columns"])
assert set(meanings) == set(names) and all(meanings.values()), meanings
assert meanings["eps"] == "half the time step, in units of time", meanings["eps"]
assert "steps" in said["kahan.plan"] and len(said["kahan.plan.sha256"]) == 64 and said["kahan.seed"] == "7"

# What the plan says: each point in its place, draws fastest, then eps, then z.
table = tables["pyarrow"]
draws = 8192
assert (table["index"] == range(10 * draws)).all()
assert (table["z"].reshape(2, 5 * draws) == [[1.0], [2.0]]).all()
assert (table["eps"].reshape(2, 5, draws) == [[[0.01], [0.02], [0.03], [0.04], [0.05]]]).all()
assert (table["x"].reshape(10, draws) == table["x"][:draws]).all()
assert -1 <= table["x"].min() < -0.99 and 0.99 < table["x"].max() < 1
assert 0.1 <= table["y"].min() < 0.11 and 0.49 < table["y"].max() < 0.5
# A reader that looks at one column and some rows uses the statistics; they must be true.
few = duckdb.execute("select count(*) from read_parquet(?) where index >= 70000", [path]).fetchone()[0]
assert few == 11920, few

print(f"{len(names)} columns of {len(table['index'])} rows, the same bits in {', '.join(tables)}")
for name in names:
    print(f"  {name:14} {meanings[name]}")
print("  " + "\n  ".join(said["kahan.plan"].splitlines()))
