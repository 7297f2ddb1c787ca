#!/usr/bin/env python3
"""Draws examples/strokes.svg: a peacock's feather of local curves, twice.

    examples/make_strokes.py > examples/strokes.svg

The feather is a group of more than 300 local curves. On the left it lies on nothing but paper, on the
right the same is blended over a layer. A barb takes its colours from the place where it passes: an
eye of ovals near the tip of the feather. Coordinates of the feather: x right, y down, the eye at
the origin, the quill below; artboard 900 x 640.
"""

import math
import random

from drawing import (css, curve, document, element, group, layer, mix, number, path, path_data,
                     rgb, smooth_chain)

WIDTH, HEIGHT = 900, 640
# The eye from its heart outwards: (how far, colour); bronze and green beyond it.
EYE = [(0, '#141a5c'), (.3, '#1b1f7a'), (.46, '#1550b8'), (.56, '#18a9c4'), (.74, '#2fd0b8'),
       (.86, '#8a5a1c'), (1.02, '#c98a2e'), (1.16, '#8a6a20'), (1.32, '#c8b83e'),
       (1.5, '#5f9a34'), (1.8, '#2f7a44'), (2.4, '#56742c'), (3.6, '#7a6a34'), (6, '#8d7a52')]


def eye_distance(x, y):
    """How far a point is from the heart of the eye, which is notched below; 1 is its bronze rim."""
    notch = 14 * math.exp(-(x / 9) ** 2) if y > 0 else 0
    return math.hypot(x / 50, (y + notch - 6) / (62 if y < 6 else 50))


def feather_colour(x, y):
    far = eye_distance(x, y)
    for (d0, a), (d1, b) in zip(EYE, EYE[1:]):
        if far <= d1:
            return mix(rgb(a), rgb(b), (far - d0) / (d1 - d0))
    return rgb(EYE[-1][1])


def quill(s):
    """The point of the quill at s: 0 at the eye's heart, 1 at the foot."""
    return 46 * s * s + 16 * math.sin(3 * s), 330 * s + 4


class Barb:
    """From the quill at s to one side: rises at first, then bends outwards; tip hangs by droop."""

    def __init__(self, chance, s, side):
        x, y = quill(s)
        fullness = min(1, 1.25 - s) if s > .25 else 1
        length = (88 + 22 * min(1, 3 * s)) * fullness * chance.uniform(.9, 1.08)
        rise = math.radians(62 - 26 * s + chance.uniform(-4, 4))
        bend = math.radians(30 + 26 * min(1, 2.5 * s) + chance.uniform(-8, 8))
        self.points, heading = [(x, y)], rise
        for _ in range(8):
            x += side * length / 8 * math.cos(heading)
            y -= length / 8 * math.sin(heading)
            self.points.append((x, y))
            heading -= bend / 8
        self.side = side

    def at(self, t):
        i = min(len(self.points) - 2, int(t * (len(self.points) - 1)))
        return mix(self.points[i], self.points[i + 1], t * (len(self.points) - 1) - i)

    def line(self, chance):
        shade = chance.uniform(-.2, .2)
        colours = [tinted(feather_colour(*self.at(i / 15)), shade) for i in range(16)]
        light = ', '.join(css(mix(colour, (255, 252, 220), .25)) for colour in colours)
        dark = ', '.join(css(mix(colour, (10, 12, 40), .35)) for colour in colours)
        left, right = (light, dark) if self.side > 0 else (dark, light)
        radius = chance.uniform(2.6, 3.8)
        return curve(path(self.points), sf_left=left, sf_right=right, sf_blur='1.5',
                     sf_radius=f'1.5, {number(radius)} 40%, {number(.7 * radius)} 80%, .5',
                     sf_alpha=f'{chance.uniform(.8, 1.15):.2f}')


def tinted(colour, shade):
    return mix(colour, (255, 246, 190) if shade > 0 else (8, 10, 36), abs(shade))


def crown(chance):
    """The barbs of the tip, which rise from the heart of the eye like rays, outer ones first."""
    count = 74
    for i in sorted(range(count), key=lambda i: -abs(2 * i - count + 1)):
        angle = math.radians(-84 + 168 * i / (count - 1) + chance.uniform(-2, 2))
        barb = Barb(chance, 0, 1 if angle > 0 else -1)
        length = 100 * (1 - .08 * math.cos(angle)) * chance.uniform(.9, 1.06)
        barb.points = [(length * t * math.sin(angle * (.68 + .32 * t)),
                        12 - length * t * math.cos(angle * (.68 + .32 * t)))
                       for t in (i / 8 for i in range(9))]
        yield barb


def glow():
    """The body of the eye below the barbs: short strokes that reach far."""
    for y, width, radius, colour, alpha in ((4, 26, 62, '#a8742a', '.9'), (4, 20, 44, '#22b8c0', 1),
                                            (6, 10, 32, '#1b3aa0', 1.2),
                                            (10, 6, 22, '#14155c', 1.5)):
        yield curve(f'M{-width} {y}L{width} {y}', sf_left=colour, sf_right=colour,
                    sf_radius=number(radius), sf_alpha=alpha)


# Along the ribbon: its point, the colours of its left and right, its radii of influence and blur.
RIBBON = [
    ((-158, 326), '#f8cf78', '#c03a62', 1, 1), ((-108, 370), '#f49a68', '#8e2a5c', 14, 9),
    ((-30, 372), '#ee5f72', '#6e1a58', 21, 18), ((62, 330), '#f2906c', '#a42e64', 16, 12),
    ((96, 282), '#f6b066', '#c43a6c', 8, 5), ((54, 258), '#f08a6a', '#b03468', 6, 4),
    ((0, 286), '#e2507a', '#7c2260', 9, 6), ((2, 336), '#d83a74', '#4c1456', 12, 10),
    ((66, 374), '#ea6c80', '#702260', 20, 18), ((132, 362), '#f5b490', '#9c3668', 21, 18),
    ((164, 316), '#fbe0a0', '#c04a72', 1, 1)]


def ribbon():
    """Silk around the quill. Two curves, because one that crosses itself mixes there."""
    chain = smooth_chain([knot[0] for knot in RIBBON])
    for first, last in ((4, 10), (0, 6)):
        _, left, right, radius, blur = (
            ', '.join(f'{knot[k]} @{i}' for i, knot in enumerate(RIBBON[first:last + 1]))
            for k in range(5))
        yield curve(path_data(chain[first:last]), sf_left=left, sf_right=right, sf_radius=radius,
                    sf_blur=blur, sf_alpha='1.3')


def feather(chance):
    loose = [Barb(chance, s + chance.uniform(-.01, .01), side) for i in range(17)
             for s in (.92 - .35 * i / 16,) for side in (-1, 1)]
    lower = [Barb(chance, .3 + .32 * (i / 32), side) for i in range(32, -1, -1) for side in (-1, 1)]
    upper = [Barb(chance, .03 + .3 * i / 70, side) for i in range(70, -1, -1) for side in (-1, 1)]
    lines = [*ribbon(), *(barb.line(chance) for barb in [*loose, *lower]), *glow(),
             *(barb.line(chance) for barb in [*upper, *crown(chance)])]
    shaft = [quill(s) for s in (1.12, .9, .7, .5, .3, .15, .03)]
    lines.append(curve(path(shaft), sf_left='#fbf3d8, #efe2ae 50%, #a8c47a 80%, #2a6a9a',
                       sf_right='#b39a68, #94854a 50%, #4a6a3a 80%, #14306a', sf_blur='2',
                       sf_radius='4, 3 40%, 2 80%, .6', sf_alpha='1.6'))
    return group('feather', lines, ' fill="none" stroke="#2f7a44"')


def ground():
    """Returns the right half: dusk, where the feather shines. Its edge has only an opacity."""
    return layer('dusk', [
        curve('M450 0L900 0L900 640L450 640Z', sf_left_opacity=0, sf_right_opacity=1,
              fill='#2a2148', fill_opacity='.9'),
        curve('M200 -40L1150 -40', sf_right='#14203f, #1d2a52 50%, #2a2450', fill='none'),
        curve('M200 700L1150 700', sf_left='#1a1230, #2e1838 50%, #1c1230', fill='none'),
        curve('M260 500C540 360 740 440 1090 270', sf_left='#34407e, #6a4a8c 50%, #4a3a78',
              sf_right='#7a3a64, #a8556e 50%, #703058', sf_blur='60, 120 50%, 60', fill='none',
              stroke='#6a4a88')])


def main():
    chance = random.Random(5)
    lines = ['<defs>', *('  ' + line for line in feather(chance)), '</defs>', *ground()]
    for x in (208, 658):
        lines.append(element('use', **{'xlink:href': '#feather',
                                       'transform': f'translate({x} 152) rotate(-4) scale(1.16)'}))
    print(document(WIDTH, HEIGHT, 'A feather of local curves', [
        'Drawn by make_strokes.py. Left: local curves alone, on paper. Right: the same group,',
        'blended over a layer.'], '#f7f3ea', lines))


if __name__ == '__main__':
    main()
