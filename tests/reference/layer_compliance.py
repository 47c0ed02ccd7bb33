#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of the compliance of layers: python3 tests/reference/layer_compliance.py > tests/reference/lay_compliance.csv (mpmath).

No closed form of the project is used. Displacements and stresses of a wave obey four linear equations in the depth (plane strain):

    U' = T/G - k W,    W' = (1 - 2 nu)/(2 G (1 - nu)) S + nu/(1 - nu) k U,
    T' = 2 G/(1 - nu) k^2 U - nu/(1 - nu) k S,    S' = k T,

with u_x = i U exp(ikx), u_z = W exp(ikx), sigma_xz = i T exp(ikx), sigma_zz = S exp(ikx). The exponential of their matrix leads through
the layer. Below it stand two conditions: no displacement (bonded), none along z and no shear stress (frictionless), or the solutions that
decay with the depth, which the square of the base's matrix minus k has as columns (coating). One unit of pressure at the surface
gives its displacement, here over that of a half-space of the layer's material.
"""
import mpmath as mp

DIGITS = 17


def matrix(k, shear, nu):
    """The four equations."""
    return mp.matrix([[0, -k, 1/shear, 0], [nu/(1 - nu)*k, 0, 0, (1 - 2*nu)/(2*shear*(1 - nu))],
                      [2*shear/(1 - nu)*k**2, 0, 0, -nu/(1 - nu)*k], [0, 0, k, 0]])


def factor(base, q, nu, ratio=None, base_nu=None):
    """Displacement over that of a half-space; thickness, shear modulus of the layer and pressure are 1, q is the wave number."""
    through = mp.expm(matrix(q, mp.mpf(1), nu))
    # unknown: U and W of the surface, and with a half-space below two amplitudes there
    known = mp.matrix([0, 0, 0, -1])
    if base == "coating":
        below = matrix(q, 1/ratio, base_nu) - q*mp.eye(4)
        below = below*below
        decaying = [below[:, 0]/mp.norm(below[:, 0]), below[:, 3]/mp.norm(below[:, 3])]
        system, right = mp.matrix(4, 4), -through*known
        for row in range(4):
            system[row, 0], system[row, 1] = through[row, 0], through[row, 1]
            system[row, 2], system[row, 3] = -decaying[0][row], -decaying[1][row]
    else:
        rows = {"bonded": (0, 1), "frictionless": (1, 2)}[base]
        system, right = mp.matrix(2, 2), mp.matrix(2, 1)
        for i, row in enumerate(rows):
            system[i, 0], system[i, 1], right[i] = through[row, 0], through[row, 1], -(through*known)[row]
    displacement = mp.lu_solve(system, right)[1]
    return displacement*q/(1 - nu)


def main():
    """Print the table."""
    print("# F: displacement of a wave of pressure over that of a half-space of the layer's material; q = k H; ratio: G of the layer over "
          "G of the base")
    print("# from the equations in the depth, solved with 200 digits and more: tests/reference/layer_compliance.py")
    print("base,q,nu,ratio,base_nu,factor")
    for q in ("1e-8", "1e-5", "1e-3", "0.03", "0.2", "0.7", "1", "1.5", "3", "8", "20", "100"):
        mp.mp.dps = 200 + int(2*float(q))
        value = mp.mpf(q)
        for nu in ("0", "0.3", "0.49", "0.5"):
            for base in ("frictionless", "bonded"):
                print(base, q, nu, "", "", mp.nstr(factor(base, value, mp.mpf(nu)), DIGITS), sep=",")
            for ratio, base_nu in (("1e-9", "0.2"), ("1e-3", "0.5"), ("0.2", "0.3"), ("1", "0.3"), ("1", "0.5"), ("7", "0.1"), ("1e4", "0.5"),
                                   ("1e9", "0.3")):
                print("coating", q, nu, ratio, base_nu,
                      mp.nstr(factor("coating", value, mp.mpf(nu), mp.mpf(ratio), mp.mpf(base_nu)), DIGITS), sep=",")


if __name__ == "__main__":
    main()
