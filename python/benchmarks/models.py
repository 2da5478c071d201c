#!/usr/bin/env python3
"""The models of a folder, read by `kahan.read`, beside libroadrunner: the largest error, and times at equal error.

    ROADRUNNER_PYTHON=roadrunner/bin/python python benchmarks/models.py [FOLDER] [--time 10] [--error 1e-8] [--record FILE]

Models are files .xml, .sbml, .ant and .ode; one of the last kind needs a twin .ant of its name, since libroadrunner does not
read it. libroadrunner has an environment of its own, which ROADRUNNER_PYTHON names, where `pip install libroadrunner antimony`
was called. `--record` writes its solutions, which the tests of the package compare with.
"""

import argparse
import json
import os
import subprocess
import sys
import time
import timeit
from pathlib import Path
from typing import Any

MODELS = Path(__file__).resolve().parents[1] / "tests/models"
POINTS, TURNS, MOST_STEPS = 10, 5, 1 << 17
TOLERANCES = [10.0**-k for k in range(4, 14)]


def by_roadrunner(path: str, horizon: float) -> None:
    """Prints the solution of one model at `POINTS` times, and its times and solutions at several tolerances."""
    import antimony
    import roadrunner

    roadrunner.Logger.setLevel(roadrunner.Logger.LOG_ERROR)
    text = Path(path).read_text()
    if path.endswith(".ant"):
        antimony.loadAntimonyFile(path)
        text = antimony.getSBMLString(antimony.getMainModuleName())
    model = roadrunner.RoadRunner(text)
    import xml.etree.ElementTree as tree

    # The symbol of a species means the amount or the concentration, as the model says.
    species = {one.get("id") or one.get("name"): one.get("hasOnlySubstanceUnits") == "true"
               for one in tree.fromstring(text).iter() if one.tag.endswith("}species")}
    ids = [*model.model.getFloatingSpeciesIds(), *model.model.getBoundarySpeciesIds()]
    names = {name: name if species[name] else f"[{name}]" for name in ids}
    names |= {name: name for name in [*model.model.getGlobalParameterIds(), *model.model.getCompartmentIds()]}
    model.timeCourseSelections = list(names.values())

    def solve(tolerance: float) -> Any:
        model.resetAll()
        model.integrator.relative_tolerance = tolerance
        model.integrator.absolute_tolerance = tolerance * 1e-3
        model.integrator.maximum_num_steps = 10**6
        return model.simulate(0, horizon, POINTS + 1)

    rows = []
    for tolerance in TOLERANCES:
        points = solve(tolerance).tolist()
        seconds = min(timeit.repeat(lambda: solve(tolerance), number=1, repeat=TURNS))
        rows.append({"seconds": seconds, "points": points})
    print("\n" + json.dumps({"names": list(names), "rows": rows}))


def asked(python: str, path: Path, horizon: float) -> dict[str, Any]:
    """The solution of libroadrunner, which has an interpreter of its own."""
    path = path.with_suffix(".ant") if path.suffix == ".ode" else path
    done = subprocess.run([python, __file__, "--one", path, "--time", str(horizon)], capture_output=True, text=True)
    if done.returncode:
        return {"error": done.stderr.strip().splitlines()[-1]}
    found: dict[str, Any] = json.loads(done.stdout.strip().splitlines()[-1])
    return found


def apart(left: Any, right: Any) -> float:
    """The largest difference of two solutions, relative to the largest value of each state."""
    import numpy as np

    scale = np.abs(right).max(axis=0)
    scale = np.maximum(scale, 1e-9 * scale.max())
    return float((np.abs(left - right) / scale).max())


def refined(system: Any, horizon: float, start: int = POINTS) -> list[tuple[int, Any]]:
    """The orbits of order 8 with twice as many steps each, until they change no more, and their numbers of steps."""
    orbits: list[tuple[int, Any]] = []
    steps, best = start, float("inf")
    while steps <= MOST_STEPS:
        orbit = system.orbit(eps=horizon / steps / 2, steps=steps, every=steps // POINTS, order=8)
        if len(orbit.x) == POINTS + 1:
            orbits.append((steps, orbit.x))
            if len(orbits) > 1:
                change = apart(orbits[-2][1], orbit.x)
                # Further steps would only add rounding errors.
                if change < 1e-13 or (change > best and best < 1e-10):
                    break
                best = min(best, change)
        steps *= 2
    return orbits


def compared(path: Path, python: str, horizon: float, error: float) -> dict[str, Any]:
    import numpy as np

    import kahan

    # Processor time excludes other work of the machine.
    begun = time.process_time()
    try:
        system = kahan.read(path)
    except ValueError as why:
        return {"refused": str(why).strip().splitlines()[0]}
    seconds = time.process_time() - begun
    other = asked(python, path, horizon)
    if "error" in other:
        return {"refused": f"libroadrunner: {other['error']}"}
    columns = [other["names"].index(name if name in other["names"] else name.removesuffix("_")) for name in system.variables]
    peers = [(row["seconds"], np.array(row["points"])[:, columns]) for row in other["rows"]]
    orbits = refined(system, horizon)
    if not orbits:
        return {"refused": "no orbit is complete"}
    ours = orbits[-2 if len(orbits) > 2 else -1][1]
    # The smallest tolerance does not always give the most accurate solution.
    nearest = min((points for _, points in peers), key=lambda points: apart(ours, points))
    row = {"states": len(system.variables), "new": system.lifted.order if system.lifted else 0, "read": seconds,
           "error": apart(ours, nearest), "points": nearest.tolist(), "names": list(system.variables)}
    steps = next((steps for steps, x in orbits if apart(x, ours) <= error), None)
    if steps is not None:
        call = lambda: system.orbit(eps=horizon / steps / 2, steps=steps, every=steps // POINTS, order=8)  # noqa: E731
        row |= {"steps": steps, "ours": min(timeit.repeat(call, number=1, repeat=4 * TURNS))}
    times = [seconds for seconds, points in peers if apart(points, ours) <= error]
    return row | ({"peer": min(times)} if times else {})


def table(folder: Path, python: str, horizon: float = 10.0, error: float = 1e-8) -> tuple[float, dict[str, Any]]:
    """Prints the table of a folder's models; returns the largest error and libroadrunner's solutions."""
    print(f"Solutions up to the time {horizon:g}; kahan has order 8. Times are those of the fastest settings with an error of at most "
          f"{error:g}.\nThe ratio is libroadrunner's time to kahan's; below 1, in bold, kahan is slower.\n")
    print("| model | states + new | read, CPU s | largest error | steps | kahan, ms | libroadrunner, ms | ratio |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    recorded, worst, wins = {}, 0.0, 0
    for path in sorted(path for path in folder.iterdir() if path.suffix in (".xml", ".sbml", ".ant", ".ode")):
        row = compared(path, python, horizon, error)
        if "refused" in row:
            print(f"| {path.name} | {row['refused']} | | | | | | |", flush=True)
            continue
        worst = max(worst, row["error"])
        recorded[path.name] = {"time": horizon, "names": row["names"], "points": row["points"]}
        ours, peer = (f"{row[name] * 1e3:.3f}" if name in row else "–" for name in ("ours", "peer"))
        ratio = row["peer"] / row["ours"] if "peer" in row and "ours" in row else None
        wins += ratio is not None and ratio >= 1
        shown = "–" if ratio is None else f"{ratio:.3g}" if ratio >= 1 else f"**{ratio:.2g}**"
        print(f"| {path.name} | {row['states']} + {row['new']} | {row['read']:.2g} | {row['error']:.1e} "
              f"| {row.get('steps', '–')} | {ours} | {peer} | {shown} |", flush=True)
    print(f"\n{len(recorded)} models; the largest error is {worst:.1e}; kahan is as fast or faster in {wins}.")
    return worst, recorded


def main() -> int:
    parser = argparse.ArgumentParser(description="The models of a folder beside libroadrunner.")
    parser.add_argument("folder", nargs="?", default=MODELS, type=Path)
    parser.add_argument("--time", type=float, default=10.0)
    parser.add_argument("--error", type=float, default=1e-8)
    parser.add_argument("--record", type=Path)
    parser.add_argument("--one", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        by_roadrunner(given.one, given.time)
        return 0
    python = os.environ.get("ROADRUNNER_PYTHON")
    if python is None:
        parser.error("ROADRUNNER_PYTHON names the interpreter of an environment with libroadrunner and antimony")
    worst, recorded = table(given.folder, python, given.time, given.error)
    if given.record:
        given.record.write_text(json.dumps(recorded, indent=0) + "\n")
    return int(worst > given.error)


if __name__ == "__main__":
    sys.exit(main())
