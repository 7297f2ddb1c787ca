#!/usr/bin/env python3
"""Draws the textures of examples/textures.svg and examples/blur.svg, which repeat without a seam.

    examples/make_patterns.py examples/waves.png examples/hemp.png

waves.png: seigaiha, rows of overlapping scales of concentric arcs. hemp.png: asanoha, triangles
parted from their centres.
"""

import math
import sys

from texture import write_texture

PALETTE_SIZE = 48
WAVE_RADIUS = 96
# An equilateral lattice has the period 1 : sqrt(3); 97 / 56 is 1.7321.
HEMP_EDGE, HEMP_HEIGHT = 112, 194
INDIGO = [(0, (18, 44, 84)), (.45, (36, 92, 142)), (.7, (108, 166, 190)), (1, (240, 238, 222))]
LACQUER = [(0, (116, 22, 26)), (.3, (158, 34, 32)), (.55, (206, 104, 52)), (1, (248, 214, 140))]


def smooth_step(low, high, x):
    t = min(1, max(0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def wave(x, y):
    """The value of the scales at a pixel: rows half a radius apart, every other one shifted."""
    radius, step = WAVE_RADIUS, WAVE_RADIUS // 2
    # The scale on top is the one with the lowest centre that still reaches the pixel.
    for row in range(math.floor(y / step) + 2, math.floor(y / step) - 1, -1):
        shift = radius * (row % 2)
        column = math.floor((x - shift) / (2 * radius) + .5)
        distance = math.hypot(x - shift - 2 * radius * column, y - row * step)
        if distance < radius:
            return rings(distance / radius)
    return 0


def rings(r):
    """Across one scale, from its centre, 0, to its rim, 1: five arcs, the outer one the widest."""
    edge = .9 / WAVE_RADIUS
    value = .22 + .3 * r
    for inner, outer in ((.06, .16), (.26, .34), (.45, .53), (.64, .73), (.86, .985)):
        inside = smooth_step(inner - edge, inner + edge, r) - smooth_step(outer - edge,
                                                                          outer + edge, r)
        value += inside * (.96 - value)
    return value * (1 - .8 * smooth_step(1 - 2 * edge, 1, r))


def hemp(x, y):
    """The value of the triangles at a pixel: bright where a line is near, else shaded."""
    height = HEMP_HEIGHT / 2
    row = math.floor(y / height)
    shift = HEMP_EDGE / 2 * (row % 2)
    u = (x - shift) / HEMP_EDGE - (y / height - row) / 2
    v = y / height - row
    column = math.floor(u)
    s = u - column
    corners = [(0, 0), (1, 0), (0, 1)] if s + v < 1 else [(1, 1), (0, 1), (1, 0)]
    points = [((a + b / 2) * HEMP_EDGE, b * height) for a, b in corners]
    here = ((s + v / 2) * HEMP_EDGE, v * height)
    centre = tuple(sum(c) / 3 for c in zip(*points))
    lines = [(points[i], points[i - 1]) for i in range(3)] + [(p, centre) for p in points]
    distance = min(distance_to_line(here, a, b) for a, b in lines)
    away = math.hypot(here[0] - centre[0], here[1] - centre[1]) / HEMP_EDGE
    ground = .12 + .3 * away + (.08 if s + v < 1 else 0)
    return ground + (.97 - ground) * (1 - smooth_step(1.1, 2.7, distance))


def distance_to_line(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)
    t = min(1, max(0, t))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def main():
    write_texture(sys.argv[1], (2 * WAVE_RADIUS, WAVE_RADIUS), wave, INDIGO, PALETTE_SIZE)
    write_texture(sys.argv[2], (HEMP_EDGE, HEMP_HEIGHT), hemp, LACQUER, PALETTE_SIZE)


if __name__ == '__main__':
    main()
