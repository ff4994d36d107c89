#!/usr/bin/env python3
"""Prints the minimax polynomial p(K) ~ 1/sqrt(K): the one whose largest relative error |p(K) sqrt(K) - 1| is smallest.

By Remez' exchange: solve for an error that alternates in sign at degree + 2 points, move the points to where the error
of that polynomial is largest, repeat until they rest. The coefficients stand in src/math/inverse_length.h.

    tools/fit_inverse_length.py [DEGREE LOWEST HIGHEST]      (2 0.499 1)
"""
import math
import sys

GRID = 100000


def solve(rows):
    """Gauss elimination of rows [a ... | b]."""
    n = len(rows)
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(n):
            if r != i:
                factor = rows[r][i] / rows[i][i]
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[i])]
    return [rows[i][n] / rows[i][i] for i in range(n)]


def error_at(coefficients, k):
    return sum(c * k**i for i, c in enumerate(coefficients)) * math.sqrt(k) - 1


def extremes(coefficients, low, high):
    """The point of largest error of each stretch of one sign."""
    best = []
    for i in range(GRID + 1):
        k = low + (high - low) * i / GRID
        e = error_at(coefficients, k)
        if best and (best[-1][1] > 0) == (e > 0):
            if abs(e) > abs(best[-1][1]):
                best[-1] = (k, e)
        else:
            best.append((k, e))
    return best


def fit(degree, low, high):
    count = degree + 2
    points = [(low + high) / 2 - (high - low) / 2 * math.cos(math.pi * i / (count - 1)) for i in range(count)]
    for _ in range(20):
        solution = solve([[math.sqrt(k) * k**j for j in range(degree + 1)] + [(-1) ** i, 1.0]
                          for i, k in enumerate(points)])
        coefficients = solution[:-1]
        found = extremes(coefficients, low, high)
        if len(found) != count:
            sys.exit("the error does not alternate: another interval or degree")
        points = [k for k, _ in found]
    return coefficients, max(abs(e) for _, e in found)


def main():
    given = sys.argv[1:] or ["2", "0.499", "1"]
    if len(given) != 3:
        sys.exit(__doc__)
    coefficients, error = fit(int(given[0]), float(given[1]), float(given[2]))
    for power, c in enumerate(coefficients):
        print(f"K^{power}  {c:.9f}")
    print(f"largest relative error {100 * error:.4f} %")


main()
