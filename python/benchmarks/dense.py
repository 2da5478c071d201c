"""Dense fields: a step of an orbit beside loops in Numba, and beside LAPACK."""

import time
from collections.abc import Callable
from typing import Any

import numpy as np

import kahan
from peers import is_here

# Short steps keep the states small.
EPS, SMALL, ROUNDS = 1e-6, 0.05, 15


def field(n: int) -> tuple[str, tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """The text of a field whose coefficients are all drawn, and c, B and Q of f = c + Bx + xᵀQx, Q symmetric."""
    draw = np.random.default_rng(n)
    c, B = (draw.integers(-999, 1000, shape) / 1000 for shape in (n, (n, n)))
    Q = draw.integers(-999, 1000, (n, n, n)) / 1000
    Q = (Q + Q.transpose(0, 2, 1)) / 2
    names = [f"x{i}" for i in range(n)]
    components = []
    for i in range(n):
        linear = [f"{B[i, j]}*{names[j]}" for j in range(n)]
        products = [f"{(1 if j == k else 2) * Q[i, j, k]:.3f}*{names[j]}*{names[k]}" for j in range(n) for k in range(j, n)]
        components.append(f"{names[i]}dot = " + " + ".join([f"{c[i]}", *linear, *products]).replace("+ -", "- ") + ";")
    return "\n".join(components), (c, B, Q)


def by_numba() -> tuple[Callable[..., None], Callable[..., None]]:
    """So many steps by loops that eliminate with partial pivoting, and by LAPACK's."""
    import numba

    @numba.njit
    def assemble(x: Any, c: Any, B: Any, Q: Any, eps: float, A: Any, f: Any) -> None:
        n = x.size
        for i in range(n):
            f[i] = c[i]
            for j in range(n):
                product = 0.0
                for k in range(n):
                    product += Q[i, j, k] * x[k]
                f[i] += (B[i, j] + product) * x[j]
                A[i, j] = -eps * (B[i, j] + 2 * product)
            A[i, i] += 1

    @numba.njit
    def loops(x: Any, c: Any, B: Any, Q: Any, eps: float, steps: int) -> None:
        n = x.size
        A, f = np.empty((n, n)), np.empty(n)
        for _ in range(steps):
            assemble(x, c, B, Q, eps, A, f)
            for k in range(n):
                pivot = k
                for i in range(k + 1, n):
                    if abs(A[i, k]) > abs(A[pivot, k]):
                        pivot = i
                if pivot != k:
                    for j in range(k, n):
                        A[k, j], A[pivot, j] = A[pivot, j], A[k, j]
                    f[k], f[pivot] = f[pivot], f[k]
                for i in range(k + 1, n):
                    factor = A[i, k] / A[k, k]
                    for j in range(k + 1, n):
                        A[i, j] -= factor * A[k, j]
                    f[i] -= factor * f[k]
            for k in range(n - 1, -1, -1):
                for j in range(k + 1, n):
                    f[k] -= A[k, j] * f[j]
                f[k] /= A[k, k]
            for i in range(n):
                x[i] += 2 * eps * f[i]

    @numba.njit
    def lapack(x: Any, c: Any, B: Any, Q: Any, eps: float, steps: int) -> None:
        n = x.size
        A, f = np.empty((n, n)), np.empty(n)
        for _ in range(steps):
            assemble(x, c, B, Q, eps, A, f)
            x += 2 * eps * np.linalg.solve(A, f)

    return loops, lapack


def dense_fields(limit: Callable[..., None], skipped: Callable[[str, str], None]) -> None:
    """The steps of single orbits, in turns; what is compared has the same end but for rounding."""
    if not is_here("numba") or not is_here("scipy"):
        return skipped("a step of dense fields", "numba or scipy is not installed")
    from scipy.linalg.lapack import dgesv

    loops, lapack = by_numba()
    for n, peer, name, at_most in [
        (6, loops, "loops of Numba", 0.4), (8, loops, "loops of Numba", 0.65), (12, loops, "loops of Numba", 0.5),
        (20, loops, "loops of Numba", 0.35), (40, lapack, "LAPACK from Numba", 0.5), (60, lapack, "LAPACK from Numba", 0.45),
        (100, lapack, "LAPACK from Numba", 0.55),
    ]:
        text, (c, B, Q) = field(n)
        s, start = kahan.System(text), SMALL * np.random.default_rng(0).uniform(-1, 1, n)
        steps = 400_000 // n**2
        ratios, bare = [], []
        for _ in range(ROUNDS + 1):
            x = start.copy()
            begun = time.perf_counter()
            peer(x, c, B, Q, EPS, steps)
            theirs, begun = time.perf_counter() - begun, time.perf_counter()
            found = s.orbit(start, EPS, steps)
            ours = time.perf_counter() - begun
            assert np.allclose(found.x[-1], x, rtol=1e-9, atol=1e-12), "the two have the same end"
            ratios.append(ours / theirs)
            A, b = np.asfortranarray(np.eye(n) - EPS * (B + 2 * Q @ x)), c.copy()
            begun = time.perf_counter()
            dgesv(A, b, overwrite_a=True, overwrite_b=True)
            bare.append(ours / steps / (time.perf_counter() - begun))
        # The first round compiles machine code, so its time is left out.
        limit(f"a step of a dense field of {n} variables / {name}", at_most, ratios[1:])
        if n == 40:
            limit("a step of a dense field of 40 variables / a bare `dgesv`", 1.0, bare[1:])


def from_arrays(limit: Callable[..., None]) -> None:
    """Fields from arrays: the first step, and steps and ensembles beside the field read as text."""
    n, rng = 40, np.random.default_rng(40)
    x, starts, begins = rng.uniform(-SMALL, SMALL, n), rng.uniform(-SMALL, SMALL, (1000, n)), []
    for _ in range(ROUNDS):
        s = None
        c, B, Q = (rng.normal(size=shape) / n**len(shape) for shape in ((n,), (n, n), (n, n, n)))
        begun = time.perf_counter()
        s = kahan.System.from_arrays(c, B, Q + Q.transpose(0, 2, 1))
        s.step(x, EPS)
        begins.append(1e3 * (time.perf_counter() - begun))
    limit("a field of 40 variables from arrays, to its first step", 10, begins, " ms")
    text = kahan.System(s.text)
    for name, call in {
        "1e5 steps": lambda field: field.orbit(x, EPS, 100_000, every=1000),
        "1e3 trajectories of 100 steps": lambda field: field.ensemble(starts, EPS, 100),
    }.items():
        ratios = []
        for _ in range(5):
            times = []
            for field in (s, text):
                begun = time.perf_counter()
                call(field)
                times.append(time.perf_counter() - begun)
            ratios.append(times[0] / times[1])
        limit(f"{name} of 40 variables from arrays / from text", 1.05, ratios)
