"""Compares the measurements of `arm/steps`: `steps.py FOLDER RUSTC…`.

Reads the output of the tests from FOLDER. In `code`, each line `// NAME BYTES` has the size of a
step's machine code. The same operations follow as a Rust function, which RUSTC… compiles.
"""

import re
import subprocess
import sys
from pathlib import Path

# The largest ratios of the instructions to those of rustc, and of the time to the interpreter's.
INSTRUCTIONS, TIME = 1.05, 0.25


def loop(assembly, name):
    """Returns the number of instructions in the longest loop of a function."""
    labels, count, longest = {}, 0, 0
    body = assembly.split(f"\n{name}:", 1)[1].split(".Lfunc_end", 1)[0]
    for line in map(str.strip, body.splitlines()):
        if label := re.match(r"(\.L\w+):", line):
            labels[label[1]] = count
        elif line and not line.startswith((".", "//")):
            count += 1
            target = re.search(r"(\.L\w+)$", line)
            if target and line.startswith(("b", "cb", "tb")) and target[1] in labels:
                longest = max(longest, count - labels[target[1]])
    return longest


def seconds(text):
    """Returns the time of the single test that ran, in seconds."""
    (passed, time), = re.findall(r"(\d+) passed;.* finished in ([0-9.]+)s", text)
    assert passed == "1", text
    return float(time)


def main():
    folder, rustc = Path(sys.argv[1]), sys.argv[2:]
    text = (folder / "code").read_text()
    source, assembly = folder / "steps.rs", folder / "steps.s"
    source.write_text("".join(re.findall(r"(?ms)^#\[unsafe.*?^}\n", text)))
    options = ["-O", "--edition=2024", "--crate-type=lib", "--emit=asm"]
    subprocess.run([*rustc, *options, "-o", assembly, source], check=True)
    assembly = assembly.read_text()
    sizes = re.findall(r"(?m)^// (\w+) (\d+)$", text)
    rows = [(name, int(size) // 4, loop(assembly, name)) for name, size in sizes]
    for name, own, other in rows:
        print(f"{name:20} {own:5} {other:5} {own / other:6.3f}")
    own, other = (sum(row[i] for row in rows) for i in (1, 2))
    code, interpreted = (
        seconds((folder / name).read_text()) for name in ("in_code", "interpreted")
    )
    print(f"instructions of {len(rows)} steps: {own} and {other} of rustc, {own / other:.3f}")
    print(f"ten million steps: {code} s, interpreted {interpreted} s, {code / interpreted:.3f}")
    sys.exit(own > INSTRUCTIONS * other or code > TIME * interpreted)


main()
