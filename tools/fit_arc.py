#!/usr/bin/env python3
"""Prints the coefficients of kArcFit (src/math/row_normals.h): the polynomials of an arc whose largest error is smallest,
errors weighted by 1 / (FLATNESS + z).

Both parts are linear in their coefficients. Lawson's method: solve least squares, weigh every point by its error, repeat;
the weights gather where a minimax solution has its largest errors.

    tools/fit_arc.py
"""
import math

ROUNDS = 1000
FLATNESS = 0.03  # small angles are the common ones: their errors count up to 17 times as much


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


def lawson(rows, wanted):
    weights = [1.0] * len(rows)
    count = len(rows[0])
    best = (math.inf, [])
    for _ in range(ROUNDS):
        normal = [[0.0] * (count + 1) for _ in range(count)]
        for row, value, weight in zip(rows, wanted, weights):
            for i in range(count):
                scaled = weight * row[i]
                for j in range(count):
                    normal[i][j] += scaled * row[j]
                normal[i][count] += scaled * value
        c = solve(normal)
        errors = [abs(sum(a * b for a, b in zip(c, row)) - value) for row, value in zip(rows, wanted)]
        best = min(best, (max(errors), c))
        weights = [w * e for w, e in zip(weights, errors)]
        mean = sum(weights) / len(weights)
        weights = [w / mean for w in weights]
    return best


def main():
    points = [((1 - math.cos(math.pi * i / 30)) / 4, j / 24) for i in range(1, 31) for j in range(24)]
    even, even_wanted, odd, odd_wanted = [], [], [], []
    for z, t in points:
        half, e = math.asin(math.sqrt(z)), 1 - t * t
        weight = 1 / (FLATNESS + z)
        even.append([weight * 2 * math.cos(half) * e * v for v in (z, z**2, z**3, z**4, e * z**2, e * z**3)])
        even_wanted.append(weight * (math.cos(t * half) - math.cos(half)))
        odd.append([weight * 2 * math.sin(half) * t * e * v for v in (z, z**2, z**3, e * z**2)])
        odd_wanted.append(weight * (math.sin(t * half) - t * math.sin(half)))
    for name, rows, wanted in (("even", even, even_wanted), ("odd", odd, odd_wanted)):
        error, c = lawson(rows, wanted)
        print(f"{name}  {', '.join(f'{v:.9f}' for v in c)}  largest weighted error {error:.2e}")


main()
