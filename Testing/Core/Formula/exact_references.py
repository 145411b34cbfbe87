# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes ExactReferences.h: Monge forms of five surfaces, computed with 50 digits.

Run once, by hand: python3 exact_references.py > ExactReferences.h (needs mpmath; half a minute).
Shares no method with the code that it is to test: the height over the tangent plane is a root that
Newton's method finds, and its derivatives are finite differences with enough digits to lose.
"""

import random

import mpmath as mp

mp.mp.dps = 60

SURFACES = {
    "1 - exp(-0.7*((x/0.15)^2+(y/0.25)^2+(z/0.35)^2-1))"
    " - exp(-0.7*(((x-0.25)/0.1)^2+((y-0.1)/0.2)^2+((z-0.1)/0.3)^2-1))": (
        lambda x, y, z: 1
        - mp.exp(
            -N("0.7") * ((x / N("0.15")) ** 2 + (y / N("0.25")) ** 2 + (z / N("0.35")) ** 2 - 1)
        )
        - mp.exp(
            -N("0.7")
            * (
                ((x - N("0.25")) / N("0.1")) ** 2
                + ((y - N("0.1")) / N("0.2")) ** 2
                + ((z - N("0.1")) / N("0.3")) ** 2
                - 1
            )
        ),
        0.3,
    ),
    "x^2/1.96 + y^2 + z^2/0.36 - 1": (
        lambda x, y, z: x**2 / N("1.96") + y**2 + z**2 / N("0.36") - 1,
        1.0,
    ),
    "(sqrt(x^2+y^2) - 1 - 0.1*x)^2 + z^2 - (0.4 + 0.05*y)^2": (
        lambda x, y, z: (mp.sqrt(x**2 + y**2) - 1 - N("0.1") * x) ** 2
        + z**2
        - (N("0.4") + N("0.05") * y) ** 2,
        1.0,
    ),
    "sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x) - 0.3*tanh(x*y)": (
        lambda x, y, z: mp.sin(x) * mp.cos(y)
        + mp.sin(y) * mp.cos(z)
        + mp.sin(z) * mp.cos(x)
        - N("0.3") * mp.tanh(x * y),
        1.5,
    ),
    "log(1+x^2) + (1+y^2)^1.5/(2+z) + atan(z)^2*cosh(x/2) - 1.2^x": (
        lambda x, y, z: mp.log(1 + x**2)
        + (1 + y**2) ** N("1.5") / (2 + z)
        + mp.atan(z) ** 2 * mp.cosh(x / 2)
        - N("1.2") ** x,
        0.8,
    ),
}
POINTS = 6


def N(text):
    """A constant as a program has it: rounded to a double."""
    return mp.mpf(float(text))


def vector(values):
    return mp.matrix(list(values))


def dot(a, b):
    return sum(a[i] * b[i] for i in range(3))


def cross(a, b):
    return vector(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )


def unit(a):
    return a / mp.sqrt(dot(a, a))


def gradient(f, p):
    orders = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    return vector(mp.diff(f, tuple(p), order) for order in orders)


def project(f, p):
    for _ in range(40):
        g = gradient(f, p)
        step = f(*p) / dot(g, g) * g
        p = p - step
        if dot(step, step) < mp.mpf(10) ** -110:
            return p
    return None


def height(f, p, frame):
    """w(u, v) with f(p + u t1 + v t2 + w n) = 0."""
    t1, t2, n = frame

    def w(u, v):
        base = p + u * t1 + v * t2
        slope = mp.diff(lambda h: f(*(base + h * n)), 0)
        h = mp.mpf(0)
        for _ in range(200):
            step = f(*(base + h * n)) / slope
            h -= step
            if abs(step) < mp.mpf(10) ** (3 - mp.mp.dps):
                break
        return h

    return w


def monge(f, p):
    n = unit(gradient(f, p))
    t1 = unit(cross(n, vector([1, 2, 3])))
    t2 = cross(n, t1)
    w = height(f, p, (t1, t2, n))
    a, b, c = (mp.diff(w, (0, 0), order) for order in [(2, 0), (1, 1), (0, 2)])
    angle = mp.atan2(2 * b, a - c) / 2
    d1 = mp.cos(angle) * t1 + mp.sin(angle) * t2
    d2 = cross(n, d1)
    w = height(f, p, (d1, d2, n))
    k1, k2 = (mp.diff(w, (0, 0), order) for order in [(2, 0), (0, 2)])
    third = [mp.diff(w, (0, 0), (3 - i, i)) for i in range(4)]
    c0, c4 = (mp.diff(w, (0, 0), order) for order in [(4, 0), (0, 4)])
    p1 = 3 * third[1] ** 2 + (k1 - k2) * (c0 - 3 * k1**3)
    p2 = 3 * third[2] ** 2 + (k2 - k1) * (c4 - 3 * k2**3)
    return [*n, *d1, k1, k2, *third, p1, p2]


def points(f, size, generator):
    while True:
        start = vector(size * generator.uniform(-1, 1) for _ in range(3))
        p = project(f, start)
        if p is not None and max(abs(v) for v in p) < 2 * size:
            yield p


def main():
    print("// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors")
    print("// SPDX-License-Identifier: BSD-3-Clause")
    print("// Made by exact_references.py.")
    print("// clang-format off")
    print("#ifndef ExactReferences_h\n#define ExactReferences_h\n")
    print("struct ExactReference\n{")
    print("  const char* formula;\n  double point[3], n[3], d1[3], k1, k2, b[4], P1, P2;\n};\n")
    print("constexpr ExactReference ExactReferences[] = {")
    generator = random.Random(5)
    for text, (f, size) in SURFACES.items():
        found = 0
        for p in points(f, size, generator):
            form = monge(f, p)
            if form[6] - form[7] < 0.05 * max(abs(form[6]), abs(form[7])):
                continue  # near an umbilic
            x, n, d1, (k1, k2), b, (p1, p2) = (
                [mp.nstr(v, 20) for v in part]
                for part in (p, form[0:3], form[3:6], form[6:8], form[8:12], form[12:14])
            )
            triples = ", ".join("{ " + ", ".join(part) + " }" for part in (x, n, d1))
            print(f'  {{ "{text}",\n    {triples},')
            print(f"    {k1}, {k2}, {{ {', '.join(b)} }}, {p1}, {p2} }},", flush=True)
            found += 1
            if found == POINTS:
                break
    print("};\n\n#endif")


if __name__ == "__main__":
    main()
