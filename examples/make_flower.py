#!/usr/bin/env python3
"""Draws examples/flower.svg: a lily, near petals in focus, leaves and far petals out of it.

    examples/make_flower.py > examples/flower.svg

A petal is a bent midrib and a half width along it. Depth is blur: every outline has a blur radius
that grows from the throat of the flower to a tip that is out of focus. Coordinates: x right, y
down, artboard 560 x 640; the light comes from the upper left.
"""

import math
import random

from drawing import css, curve, document, element, group, layer, mix, number, path, ramp, rgb, stops

WIDTH, HEIGHT = 560, 640
THROAT = (272, 322)


class Blade:
    """The form of a petal or a leaf.

    base and aim of the midrib; bend: how far the tip swings to the left of its aim; width: the
    largest half width; profile: (s, share of the width), s from the base, 0, to the tip, 1.
    """

    def __init__(self, base, aim, bend, width, profile, ruffle=0):
        self.base, self.aim, self.bend, self.width = base, aim, bend, width
        self.profile, self.ruffle = profile, ruffle

    def rib(self, s):
        """The point of the midrib at s, and the unit vector to its left."""
        (x0, y0), (x1, y1) = self.base, self.aim
        length = math.hypot(x1 - x0, y1 - y0)
        left = ((y1 - y0) / length, -(x1 - x0) / length)
        swing = self.bend * (s * s - .35 * s)
        slope = self.bend * (2 * s - .35) / length
        point = (x0 + (x1 - x0) * s + left[0] * swing, y0 + (y1 - y0) * s + left[1] * swing)
        normal = (left[0] - slope * (x1 - x0) / length, left[1] - slope * (y1 - y0) / length)
        size = math.hypot(*normal)
        return point, (normal[0] / size, normal[1] / size)

    def at(self, s, across):
        """across: -1 is the left rim, 1 the right one, as seen from the base."""
        (x, y), (nx, ny) = self.rib(s)
        share = next((a + (b - a) * (s - s0) / (s1 - s0) for (s0, a), (s1, b)
                      in zip(self.profile, self.profile[1:]) if s0 <= s <= s1), 0)
        reach = -across * share * self.width
        return x + nx * reach, y + ny * reach

    def outline(self):
        """From the base along the left rim to the tip and back: clockwise, inside on the right."""
        steps = [s for s, _ in self.profile[:-1]]
        left = [self.at(s, -1 - self.ruffle * math.sin(13 * s)) for s in steps]
        right = [self.at(s, 1 + self.ruffle * math.sin(11 * s + 2)) for s in steps]
        return left + [self.rib(1)[0]] + right[::-1] + [left[0]]

    def along(self, across, steps):
        return path([self.at(s, across) for s in steps])


class Petal(Blade):
    """blur: the radius at the tip; shade: 0 in the light to 1; lights: of both halves, in -1..1."""

    PROFILE = [(0, .2), (.1, .36), (.22, .66), (.36, .92), (.5, 1), (.64, .92), (.78, .66),
               (.9, .32), (.98, .1), (1, 0)]
    RIM = [rgb('#a04a60'), rgb('#f0b4c8'), rgb('#fdeaf0'), rgb('#fff6f6'), rgb('#f6f0e2')]
    BAND = [rgb('#7d1440'), rgb('#cf3f78'), rgb('#ea7fa6'), rgb('#f7bccf'), rgb('#f8ede5')]
    RIB = [rgb('#5e7a2e'), rgb('#a61a55'), rgb('#c72765'), rgb('#dc6790'), rgb('#f6efe4')]

    def __init__(self, name, aim, bend, width, blur, shade, lights, start=(0, 0), ruffle=0):
        super().__init__((THROAT[0] + start[0], THROAT[1] + start[1]), aim, bend, width,
                         self.PROFILE, ruffle)
        self.name, self.blur, self.shade, self.lights = name, blur, shade, lights

    def tint(self, colours, s, light):
        """A colour of the petal at s; light above 0 whitens, below 0 darkens it to purple."""
        colour = ramp(colours, s)
        colour = mix(colour, rgb('#fffaf4'), .5 * light) if light > 0 else mix(
            colour, rgb('#6d2a5c'), -.6 * light)
        return mix(colour, rgb('#3a1238'), self.shade)

    def rim_colours(self):
        """Along the outline; both halves meet at the tip in one colour."""
        left, right = self.lights
        halves = ((.2, left), (.45, left), (.72, left), (1, (left + right) / 2), (.72, right),
                  (.45, right), (.2, right))
        return [self.tint(self.RIM, s, light) for s, light in ((0, left), *halves, (0, right))]

    def layers(self):
        offsets = (0, .1, .22, .36, .5, .64, .78, .9, 1)
        colours = stops(map(css, self.rim_colours()), offsets)
        blur = stops([.2 * self.blur, self.blur, .2 * self.blur], form=number)
        outline = curve(path(self.outline(), True), sf_left=colours, sf_right=colours,
                        sf_left_opacity=0, sf_right_opacity='0, 1 9%, 1 91%, 0', sf_blur=blur,
                        fill=css(self.tint(self.RIM, .5, 0)))
        return layer(self.name, [outline] + list(self.bands()) + [self.midrib()])

    def bands(self):
        """Half way to the rims, where the pink fades."""
        for across, light in ((-.46, self.lights[0]), (.46, self.lights[1])):
            steps = (.03, .25, .5, .72, .87)
            colours = stops(css(self.tint(self.BAND, s, light)) for s in steps)
            yield curve(self.along(across, steps), sf_left=colours, sf_right=colours, fill='none',
                        stroke=css(self.tint(self.BAND, .5, light)))

    def midrib(self):
        steps = (.02, .2, .45, .7, .95)
        sides = [stops(css(self.tint(self.RIB, s, light + groove * (.95 - s))) for s in steps)
                 for light, groove in zip(self.lights, (-.4, .4))]
        return curve(self.along(0, steps), sf_left=sides[0], sf_right=sides[1],
                     sf_blur=stops([1 + self.blur / 2, 4 + self.blur, 1], form=number), fill='none',
                     stroke=css(self.tint(self.RIB, .5, 0)))

    def shadow(self):
        """Returns the shadow of the petal on the petals behind it."""
        points = [(x + 7, y + 12) for x, y in self.outline()]
        return layer(self.name + '-shadow', [curve(
            path(points, True), sf_left='#3c0c30', sf_right='#3c0c30', sf_left_opacity=0,
            sf_right_opacity='.1, .5 15%, .2 50%, .5 85%, .1',
            sf_blur=stops([6, 20, 6], form=number), fill='#3c0c30', fill_opacity='.3')],
            ' style="mix-blend-mode:multiply"')

    def freckles(self, chance, count):
        """Dark spots near the throat: local curves as long as they are wide."""
        lines = []
        for _ in range(count):
            s, across = chance.uniform(.14, .52), chance.uniform(-.62, .62)
            x, y = self.at(s, across)
            dx, dy = (b - a for a, b in zip(self.rib(s)[0], self.rib(s + .02)[0]))
            radius = (1.6 + 1.4 * (1 - s)) * chance.uniform(.7, 1.15) + .3 * self.blur
            lines.append(curve(f'M{number(x)} {number(y)} l{number(dx)} {number(dy)}',
                               sf_left='#6d0d33', sf_right='#6d0d33', sf_radius=number(radius),
                               sf_alpha=number(.9 - .05 * self.blur)))
        return lines


class Leaf(Blade):
    """A leaf out of focus; blurs: the radii at base, middle and tip; colours: light, dark, rib."""

    PROFILE = [(0, .2), (.12, .5), (.3, .9), (.45, 1), (.62, .88), (.8, .52), (.94, .16), (1, 0)]

    def __init__(self, name, base, aim, bend, width, blurs, colours):
        super().__init__(base, aim, bend, width, self.PROFILE)
        self.name, self.blurs, self.colours = name, blurs, colours

    def layers(self):
        light, dark, rib = self.colours
        colours = f'{dark}, {light} 20%, {light} 49%, {dark} 52%, {dark}'
        base, middle, tip = self.blurs
        outline = curve(path(self.outline(), True), sf_left=colours, sf_right=colours,
                        sf_left_opacity=0, sf_right_opacity=1,
                        sf_blur=stops([base, middle, tip, middle, base], form=number), fill=light)
        midrib = curve(self.along(0, (0, .25, .5, .75, .95)), sf_left=light, sf_right=rib,
                       sf_blur=stops([middle, base], form=number), fill='none', stroke=rib)
        return layer(self.name, [outline, midrib])


class Stalk(Blade):
    """A filament, the style, an anther: a thin thing in focus, light on its left."""

    def __init__(self, start, aim, bend, width, profile, colours):
        super().__init__(start, aim, bend, width, profile)
        self.colours = colours

    def shape(self):
        light, body, dark = self.colours
        return curve(path(self.outline(), True), sf_left=body, sf_left_opacity=0,
                     sf_right_opacity=1, sf_blur=.7, fill=body,
                     sf_right=f'{body}, {light} 15%, {light} 40%, {dark} 55%, {dark} 85%, {body}')

    def shadow(self):
        """On the petals behind; the farther from the throat, the softer."""
        points = [(x + 5 + 7 * k, y + 6 + 12 * k) for (x, y), k in
                  zip(self.outline(), self.distances())]
        return curve(path(points, True), sf_left='#4a0c30', sf_right='#4a0c30', sf_left_opacity=0,
                     sf_right_opacity='.2, .5 20%, .4 50%, .5 80%, .2', sf_blur='2, 5 50%, 2',
                     fill='#4a0c30', fill_opacity='.3')

    def distances(self):
        steps = [s for s, _ in self.profile[:-1]]
        return steps + [1] + steps[::-1] + [0]


FILAMENT = [(0, .6), (.3, .9), (.6, .8), (.97, .55), (1, 0)]
STYLE = [(0, .7), (.3, .6), (.8, .75), (.93, 1.3), (.99, 1), (1, 0)]
ANTHER = [(0, .25), (.1, .75), (.3, 1), (.5, .92), (.7, 1), (.9, .75), (.98, .3), (1, 0)]
GREEN = ('#f2f4c8', '#c9d591', '#8ea05c')
RUST = ('#f0a04e', '#b9531c', '#6a240c')
PURPLE = ('#d9a3c8', '#8e4a86', '#4a1f52')


def stamens():
    """Where each filament aims, its bend, and the way its anther points."""
    filaments, anthers = [], []
    for aim, bend, (dx, dy) in (((172, 262), -34, (17, -13)), ((214, 196), -24, (20, 4)),
                                ((318, 186), 20, (20, -4)), ((378, 250), 34, (15, 15)),
                                ((372, 356), 40, (5, 21)), ((166, 354), -36, (-4, 21))):
        start = mix(THROAT, aim, .07)
        filament = Stalk(start, aim, bend, 3.4, FILAMENT, GREEN)
        x, y = filament.rib(1)[0]
        filaments.append(filament)
        anthers.append(Stalk((x - dx, y - dy), (x + dx, y + dy), 5, 6, ANTHER, RUST))
    return filaments, anthers


def heart():
    """The throat, and what stands in it."""
    x, y = THROAT
    throat = element('ellipse', cx=x, cy=y, rx=30, ry=24, sf_left='#3c1a24', sf_right='#4b5a20',
                     sf_left_opacity=0, sf_right_opacity='.9', sf_blur=22, fill='#4b5a20',
                     fill_opacity='.5')
    filaments, anthers = stamens()
    style = Stalk(THROAT, (322, 440), -34, 5, STYLE, GREEN)
    end = style.rib(1)[0]
    stigma = [Stalk((end[0] - .6 * dx, end[1] - .6 * dy), (end[0] + dx, end[1] + dy), 2, 6.5,
                    ANTHER, PURPLE) for dx, dy in ((-12, 4), (12, -1), (3, 13))]
    lines = layer('throat', [throat])
    for name, stalks in (('filament-shadows', filaments + [style]), ('anther-shadows', anthers)):
        lines += layer(name, [stalk.shadow() for stalk in stalks],
                       ' style="mix-blend-mode:multiply"')
    for name, stalks in (('filaments', filaments), ('style', [style]), ('anthers', anthers)):
        lines += layer(name, [stalk.shape() for stalk in stalks])
    for i, lobe in enumerate(stigma):
        lines += layer(f'stigma-{i + 1}', [lobe.shape()])
    return lines


LEAVES = [
    Leaf('leaf-far-left', (-30, 330), (170, 20), 60, 50, (26, 22, 18),
         ('#6f9a58', '#31573c', '#456f48')),
    Leaf('leaf-far-right', (600, 250), (400, 10), -70, 56, (26, 24, 20),
         ('#4f8058', '#1f4435', '#31593f')),
    Leaf('leaf-right', (420, 680), (556, 330), -60, 48, (8, 14, 20),
         ('#5b8f4e', '#17382a', '#2c5a3a')),
    Leaf('leaf-left', (180, 690), (10, 470), 60, 46, (5, 10, 16),
         ('#7fae58', '#1f4a30', '#3c6d3e')),
]


def garden():
    """Returns the background: only soft light and dark."""
    frame = curve('M-60 -60L620 -60L620 700L-60 700Z', fill='none', stroke='#2d4f3a',
                  sf_right='#86a877, #3f6b52 20%, #10271f 45%, #0c1d18 60%, #16352a 85%, #86a877')
    glow = curve('M150 70C230 130 330 130 420 60', sf_left='#9fbd84, #b8cf94 40%, #5d8a68',
                 sf_right='#4d7a58, #2f5b44 50%, #264f40', sf_blur='50, 90 50%, 50', fill='none',
                 stroke='#b8cf94')
    gloom = curve('M60 470C200 560 380 560 500 450', sf_left='#20452f', sf_right='#0d2219',
                  sf_blur='40, 80 50%, 40', fill='none', stroke='#0d2219')
    return layer('garden', [frame, glow, gloom])


def glints(chance):
    """Sun between far leaves, as a lens draws it: pale discs."""
    discs = []
    for x, y, radius in ((66, 92, 26), (122, 40, 17), (196, 30, 22), (352, 42, 24), (404, 96, 15),
                         (520, 70, 20), (30, 176, 16), (540, 214, 14), (470, 24, 14)):
        discs.append(element('circle', cx=x, cy=y, r=radius, sf_left='#e9f2b8',
                             sf_right='#e9f2b8', sf_left_opacity=0,
                             sf_right_opacity=f'{chance.uniform(.12, .3):.2f}', sf_blur=4,
                             fill='#e9f2b8', fill_opacity='.2'))
    return layer('glints', discs)


def main():
    chance = random.Random(3)
    petals = [
        Petal('petal-top', (270, 26), -60, 44, 12, .30, (.1, -.5), (-2, 10)),
        Petal('petal-left', (34, 372), -80, 44, 3, .12, (.1, -.3), (12, -6)),
        Petal('petal-right', (506, 398), 84, 46, 3, .16, (-.1, -.5), (-12, -6)),
        Petal('petal-upper-left', (66, 142), -80, 68, 7, .06, (.5, -.1), (10, 10), .04),
        Petal('petal-upper-right', (488, 142), 84, 66, 7, .10, (.2, -.35), (-10, 10), .04),
        Petal('petal-front', (262, 580), 50, 72, 0, 0, (.0, .4), (2, -14), .04),
    ]
    lines = garden() + glints(chance)
    for leaf in LEAVES:
        lines += leaf.layers()
    for petal in petals:
        lines += petal.shadow() + petal.layers()
        lines += group(petal.name + '-freckles', petal.freckles(chance, 26),
                       ' fill="none" stroke="#6d0d33"')
    lines += heart()
    print(document(WIDTH, HEIGHT, 'A lily', [
        'Drawn by make_flower.py. Every petal and leaf is a layer of its own: its outline bears',
        'opacity, and a blur radius that follows the depth.'], '#23452f', lines))


if __name__ == '__main__':
    main()
