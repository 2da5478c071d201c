"""Compares the output of the command on two processors, byte by byte: `compare.py OWN OTHER…`.

OWN is the command for this machine. OTHER… is the emulator and the command for the other processor.
Runs the commands in COMMANDS, and computes an orbit of each of 200 random quadratic fields.
"""

import random
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

COMMANDS = """
list
show e6
show e7 --latex
show lorenz
eval e1 --eps 1/2 --at -2,1,1/3
eval e6 --eps 0.05 --at 1,2,3
orbit e1 --eps 0.05 --at 1,2,3 --steps 1000
orbit e2 --eps 0.05 --at 1,2,3 --steps 1000
orbit e3 --eps 0.02 --at 1,2,3 --steps 1000
orbit e6 --eps 0.1 --at 1,2,3 --steps 1000
orbit e6 --eps 0.05 --at 1,2,3 --steps 20000 --every 1000
orbit e6 --eps 0.05 --at 1,2,3 --steps 1000 --order 4
orbit e6 --eps 0.05 --at 1,2,3 --steps 300 --order 8
orbit e6 --eps 0.05 --at 1,2,3 --steps 1000 --scalar f32
orbit e6 --eps 0.05 --at 1,2,3 --steps 1000 --order 6 --scalar dd
orbit e6 --eps 0.05 --at 1,2,3 --steps 1000 --fused
orbit e6 --eps 0.05 --at 1,2,3 --steps 300 --fused --scalar dd --order 4
orbit lv --eps 0.05 --at 1,2 --steps 1000 --fused --scalar f32
dynamics e3 --eps 0.05 --at 1,2,3 --steps 1e4 --fused
orbit e3 --eps 1/2 --at 3/7,11/13,23/47 --steps 8 --scalar exact
orbit e7 --param xi=19/17 --eps 1/2 --at 3/7,1,.5 --steps 1e5 --every 100
orbit lv --eps 0.05 --at 1,2 --steps 1000 --method rk4
orbit --field 'xdot = v; vdot = -x - x^2;' --eps 0.05 --at 0.3,0 --steps 1000 --json
orbit --field 'xdot = 10*(y - x); ydot = 28*x - y - x*z; zdot = x*y - 8/3*z;' --eps 0.005 --at 1,1,1 --steps 50000 --every 10
orbit --field 'xdot = y; ydot = 6*x^2 - a;' --over a=1:2:5 --dt 0.02 --at 0,1 --steps 100
orbit --field 'for i in open { x[i]dot = x[i+1]; }' --sites 9 --start x=i --eps 1 --steps 9
orbit --lift --field 'xdot = v; vdot = -sin(x);' --at 1,0 --eps 0.05 --steps 1000
orbit --lift --field 'xdot = v; vdot = -x + exp(-x^2);' --at 1,0 --eps 0.05 --steps 1000
discover --field 'xdot = y; ydot = 6*x^2 - 1;'
discover --field 'xdot = y*z; ydot = -2*x*z; zdot = x*y;'
discover --field 'xdot = v; vdot = -x - x^2;'
dynamics lorenz --param s=10 --param r=28 --param b=8/3 --eps 1e-3 --at 1,1,1 --steps 1e4
dynamics e3 --eps 0.05 --at 1,2,3 --steps 1e4 --json
dynamics e6 --eps 0.05 --at 1,2,3 --steps 1e4 --order 4
dynamics --field 'xdot = v; vdot = -x - x^2;' --eps 0.05 --at 0.3,0 --steps 20000
section volterra --eps 0.02 --at 1,2,3 --plane 'x - y' --steps 1e4
section e6 --eps 0.05 --at 1,2,3 --plane 'x - y' --direction both --steps 1e4
section lv --eps 0.1 --at 1,1 --over x=1:2:9 --plane y-1 --crossings 3 --order 4
periodic --field 'xdot = v; vdot = -x - x^2;' --eps 0.05 --at 0,0 --period 1
poles --field 'xdot = y; ydot = 6*x^2 - 1;'
poles e6
heights e6 --eps 1/2 --at 1,2,3 --steps 4
lift --field 'xdot = v; vdot = -sin(x);' --at 1,0 --eps 0.05
lift --field "v' = v - v^3/3 - w + 1/2, w' = (v + 0.7 - 0.8*w)*0.08" --at 1,0
verify e1
"""

FIELDS = 200


def field(draw):
    """Returns the arguments for an orbit of a random quadratic field with small coefficients."""
    names = "xyzuvw"[: draw.randint(1, 6)]
    lines = []
    for name in names:
        terms = []
        for _ in range(draw.randint(1, 4)):
            number = draw.choice(["1/2", "-1/3", "2", "-1", "0.7", "-1.3", "0.1"])
            factors = draw.choices(names, k=draw.randint(0, 2))
            terms.append(" * ".join([f"({number})", *factors]))
        lines.append(f"{name}dot = {' + '.join(terms)};")
    start = ",".join(str(draw.randint(-20, 20) / 10) for _ in names)
    more = draw.choice([[], [], ["--order", "4"], ["--scalar", "f32"]])
    return ["orbit", "--field", " ".join(lines), "--eps", draw.choice(["0.01", "0.05", "1/32"]), f"--at={start}", "--steps", "400", *more]


def said(command):
    """Returns the exit status and the output of a command, without the time that it measured."""
    run = subprocess.run(command, capture_output=True, check=False, timeout=1200)
    return run.returncode, re.sub(rb"(?m)^seconds +[0-9.]+$", b"seconds", run.stdout), run.stderr


def main():
    own, *other = sys.argv[1:]
    draw = random.Random(63)
    commands = [shlex.split(line) for line in COMMANDS.strip().splitlines()]
    cases = commands + [field(draw) for _ in range(FIELDS)]

    def compared(arguments):
        return arguments, said([own, *arguments]), said([*other, *arguments])

    different, ran, printed = 0, 0, 0
    with ThreadPoolExecutor(2) as pool:
        for arguments, here, there in pool.map(compared, cases):
            ran += here[0] == 0
            printed += len(here[1])
            if here != there:
                different += 1
                print(f"different: kahan {shlex.join(arguments)}", here[2][:300], there[2][:300], sep="\n    ")
    print(f"{len(commands)} commands and {FIELDS} fields, {ran} with exit status 0, {printed} bytes: {different} are different")
    sys.exit(different > 0)


main()
