"""Damages a part in every way of one byte: damage.py PLAN.toml UNDISTURBED DIR/PART

Every byte with one bit flipped, and every length from nothing on: merging is refused with a reason,
or its bytes are the undisturbed run's."""

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from shutil import copytree
from tempfile import TemporaryDirectory

plan, undisturbed, part = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
right = (undisturbed / "results.parquet").read_bytes()
whole = part.read_bytes()


def flipped(at):
    return whole[:at] + bytes([whole[at] ^ (1 << at % 8)]) + whole[at + 1:]


def merged(damaged):
    """Whether it was refused; a wrong file ends everything."""
    what, content = damaged
    with TemporaryDirectory() as folder:
        copytree(part.parent, folder, dirs_exist_ok=True)
        (Path(folder) / part.name).write_bytes(content)
        merge = subprocess.run(["kahan-sweep", plan, "--out", folder, "--merge"], capture_output=True, text=True)
        result = Path(folder) / "results.parquet"
        if merge.returncode == 0:
            return "same" if result.read_bytes() == right else f"{what}: merged with other bytes"
        if merge.returncode != 1 or not merge.stderr.startswith("error: ") or result.exists():
            return f"{what}: status {merge.returncode}: {merge.stderr}"
        return "refused"


ways = [(f"byte {at} flipped", flipped(at)) for at in range(len(whole))]
ways += [(f"cut to {length} bytes", whole[:length]) for length in range(len(whole))]
with ThreadPoolExecutor() as pool:
    ends = list(pool.map(merged, ways))
wrong = [end for end in ends if end not in ("same", "refused")]
print(f"{len(ways)} ways of damage: {ends.count('refused')} refused, {ends.count('same')} merged to the same bytes")
sys.exit("\n".join(wrong[:20] + [f"{len(wrong)} in all"]) if wrong else 0)
