"""Sparse fields: a step of lattices beside SuperLU, and of fewer variables beside a loop over the rows in Numba."""

import time
from collections.abc import Callable
from typing import Any

import numpy as np

import kahan
from peers import is_here

ROUNDS = 7


def lattice(side: int) -> str:
    """Logistic growth at side × side sites, each coupled to those beside it."""
    equations = []
    for i in range(side):
        for j in range(side):
            beside = [(i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)]
            names = [f"x{a * side + b}" for a, b in beside if 0 <= a < side and 0 <= b < side]
            x = f"x{i * side + j}"
            equations.append(f"{x}dot = {x} - {x}^2 + 3/10*({' + '.join(names)} - {len(names)}*{x});")
    return "\n".join(equations)


def by_super_lu(side: int) -> Callable[[np.ndarray, float, int], None]:
    """So many steps of the lattice."""
    import scipy.sparse as sp
    from scipy.sparse.linalg import splu

    sites = np.arange(side * side).reshape(side, side)
    pairs = [(sites[:-1], sites[1:]), (sites[:, :-1], sites[:, 1:])]
    rows = np.concatenate([np.concatenate([a.ravel(), b.ravel()]) for a, b in pairs])
    columns = np.concatenate([np.concatenate([b.ravel(), a.ravel()]) for a, b in pairs])
    coupling = sp.csc_matrix((np.full(rows.size, 0.3), (rows, columns)))
    coupling = (coupling - sp.diags(np.asarray(coupling.sum(axis=1)).ravel())).tocsc()
    identity = sp.identity(side * side, format="csc")

    def steps(x: np.ndarray, eps: float, count: int) -> None:
        for _ in range(count):
            A = (identity - eps * (coupling + sp.diags(1 - 2 * x))).tocsc()
            x += 2 * eps * splu(A, permc_spec="MMD_AT_PLUS_A").solve(x - x * x + coupling @ x)

    return steps


def drawn(n: int) -> tuple[str, np.ndarray, np.ndarray]:
    """A field of four drawn products a row and a decay, with the products: i, j and k, and their coefficients."""
    draw = np.random.default_rng(n)
    indices = np.array([(i, *draw.integers(0, n, 2)) for i in range(n) for _ in range(4)])
    coefficients = draw.integers(-999, 1000, 4 * n) / 1000
    products = [f"{c}*x{j}*x{k}" for c, (_, j, k) in zip(coefficients, indices)]
    text = [f"x{i}dot = -1/2*x{i} + {' + '.join(products[4 * i:4 * i + 4])};" for i in range(n)]
    return "\n".join(text).replace("+ -", "- "), indices, coefficients


def eliminated(n: int, indices: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """An order of least degree, and of A in it, with what elimination fills in, where rows begin and the columns."""
    around = [{j for i, *pair in indices if i == row for j in pair} for row in range(n)]
    mutual = [{j for j in range(n) if j != i and (j in around[i] or i in around[j])} for i in range(n)]
    order: list[int] = []
    while len(order) < n:
        chosen = min(set(range(n)) - set(order), key=lambda i: len(mutual[i]))
        for i in mutual[chosen]:
            mutual[i] = (mutual[i] | mutual[chosen]) - {i, chosen}
        order.append(chosen)
    turn = {i: k for k, i in enumerate(order)}
    rows: list[list[int]] = []
    for k, i in enumerate(order):
        columns = {turn[j] for j in around[i]} | {k}
        for p in range(k):
            if p in columns:
                columns |= {j for j in rows[p] if j > p}
        rows.append(sorted(columns))
    starts = np.cumsum([0, *map(len, rows)])
    return np.array(order), starts, np.concatenate([np.array(row) for row in rows])


def by_rows() -> Callable[..., None]:
    """So many steps that eliminate row by row along the entries of A, by loops in Numba."""
    import numba

    @numba.njit
    def loop(x: Any, indices: Any, coefficients: Any, order: Any, starts: Any, columns: Any, eps: float, steps: int) -> None:
        n = x.size
        turn = np.empty(n, np.int64)
        turn[order] = np.arange(n)
        values, row, f, diagonals = np.empty(columns.size), np.zeros(n), np.empty(n), np.empty(n, np.int64)
        slopes = np.zeros((n, n))
        for _ in range(steps):
            for k in range(n):
                f[k] = -0.5 * x[order[k]]
                for place in range(starts[k], starts[k + 1]):
                    slopes[k, columns[place]] = 0.0
                slopes[k, k] = -0.5
            for term in range(coefficients.size):
                i, j, k = indices[term]
                c = coefficients[term]
                f[turn[i]] += c * x[j] * x[k]
                slopes[turn[i], turn[j]] += c * x[k]
                slopes[turn[i], turn[k]] += c * x[j]
            for k in range(n):
                for place in range(starts[k], starts[k + 1]):
                    row[columns[place]] = -eps * slopes[k, columns[place]]
                row[k] += 1.0
                for place in range(starts[k], starts[k + 1]):
                    p = columns[place]
                    if p == k:
                        diagonals[k] = place
                    if p >= k:
                        break
                    row[p] *= values[diagonals[p]]
                    for upper in range(diagonals[p] + 1, starts[p + 1]):
                        row[columns[upper]] -= row[p] * values[upper]
                    f[k] -= row[p] * f[p]
                for place in range(starts[k], starts[k + 1]):
                    values[place] = row[columns[place]]
                values[diagonals[k]] = 1.0 / values[diagonals[k]]
            for k in range(n - 1, -1, -1):
                for place in range(diagonals[k] + 1, starts[k + 1]):
                    f[k] -= values[place] * f[columns[place]]
                f[k] *= values[diagonals[k]]
            for k in range(n):
                x[order[k]] += 2 * eps * f[k]

    return loop


def sparse_fields(limit: Callable[..., None], skipped: Callable[[str, str], None]) -> None:
    """The steps of single orbits, in turns; what is compared has the same end but for rounding."""
    if not is_here("numba") or not is_here("scipy"):
        return skipped("a step of sparse fields", "numba or scipy is not installed")

    def timed(work: Callable[[], np.ndarray]) -> tuple[float, np.ndarray]:
        begun = time.perf_counter()
        found = work()
        return time.perf_counter() - begun, found

    loop = by_rows()
    for n in [12, 50]:
        text, indices, coefficients = drawn(n)
        tables = eliminated(n, indices)
        s, start, eps = kahan.System(text), np.random.default_rng(0).uniform(-0.5, 0.5, n), 1e-4
        steps, ratios = 600_000 // n**2, []

        def peer() -> np.ndarray:
            x = start.copy()
            loop(x, indices, coefficients, *tables, eps, steps)
            return x

        for _ in range(2 * ROUNDS):
            (theirs, x), (ours, found) = timed(peer), timed(lambda: s.orbit(start, eps, steps).x[-1])
            assert np.allclose(found, x, rtol=1e-9, atol=1e-12), "the two have the same end"
            ratios.append(ours / theirs)
        # The first round compiles machine code, so its time is left out.
        limit(f"a step of a sparse field of {n} variables / a loop over rows in Numba", 0.33, ratios[1:])

    for side, at_most in [(30, 0.25), (60, 0.4), (100, 0.4)]:
        s, super_lu = kahan.System(lattice(side)), by_super_lu(side)
        start, steps = np.random.default_rng(0).uniform(0.1, 0.4, side * side), 2
        ratios, small = [], []
        for _ in range(ROUNDS):
            x = start.copy()
            theirs, _ = timed(lambda: super_lu(x, 0.1, steps))
            ours, found = timed(lambda: s.orbit(start, 0.1, steps).x[-1])
            assert np.allclose(found, x, rtol=1e-9, atol=1e-12), "the two have the same end"
            ratios.append(ours / theirs)
            small.append(timed(lambda: s.orbit(start, 1e-9, steps).x[-1])[0] / ours)
        limit(f"a step of a lattice of {side} × {side} sites / SuperLU", at_most, ratios[1:])
        limit(f"a step of a lattice of {side} × {side} sites at ε = 1e-9 / at ε = 0.1", 1.2, small[1:])
