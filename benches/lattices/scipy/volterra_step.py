"""Kahan's step of the periodic Volterra chain by NumPy and scipy.linalg.solve_banded.

    python volterra_step.py            prints nanoseconds a site and step

The matrix A(x, eps) = I - eps f'(x) is a band of three diagonals with two corners. The last unknown
is the border: two right-hand sides for the band without it, then one equation for it.
"""

import time

import numpy as np
from scipy.linalg import solve_banded


def step(x, eps):
    """x one step of 2 eps later."""
    after, before = np.roll(x, -1), np.roll(x, 1)
    field = x * (after - before)
    coupling = eps * x
    diagonal = 1.0 - eps * (after - before)
    n = len(x)
    band = np.zeros((3, n - 1))
    band[0, 1:] = -coupling[: n - 2]
    band[1] = diagonal[:-1]
    band[2, :-1] = coupling[1 : n - 1]
    sides = np.zeros((n - 1, 2))
    sides[:, 0] = field[:-1]
    # The column of the last unknown: above the corner, and beside the end.
    sides[0, 1] = coupling[0]
    sides[-1, 1] += -coupling[n - 2]
    inner = solve_banded((1, 1), band, sides, overwrite_ab=True, overwrite_b=True, check_finite=False)
    # Row n-1: coupling x[n-2] + diagonal x[n-1] - coupling x[0].
    last = coupling[-1]
    core = diagonal[-1] - last * inner[-1, 1] + last * inner[0, 1]
    right = field[-1] - last * inner[-1, 0] + last * inner[0, 0]
    end = right / core
    velocity = np.append(inner[:, 0] - end * inner[:, 1], end)
    return x + 2.0 * eps * velocity


def check():
    """The defining equation, at a random state."""
    x = 1.0 + np.random.default_rng(1).random(50)
    eps = 0.05
    y = step(x, eps)
    right = x * (np.roll(y, -1) - np.roll(y, 1)) + y * (np.roll(x, -1) - np.roll(x, 1))
    assert np.max(np.abs((y - x) / (2.0 * eps) - 0.5 * right)) < 1e-13


def main():
    check()
    print("| sites | ns a site and step |\n|---:|---:|")
    for n in [1_000, 10_000, 100_000, 1_000_000, 10_000_000]:
        x = 1.0 + 0.5 * np.sin(0.01 * np.arange(n))
        steps = max(2, 2_000_000 // n)
        least = float("inf")
        for _ in range(5):
            begun = time.perf_counter()
            y = x
            for _ in range(steps):
                y = step(y, 0.05)
            least = min(least, (time.perf_counter() - begun) / steps / n * 1e9)
        print(f"| {n} | {least:.1f} |")


if __name__ == "__main__":
    main()
