#!/usr/bin/env python3
"""Draws examples/evening.xml: a boat on a mountain lake, by the light of a rising moon.

    examples/make_evening.py > examples/evening.xml

The picture is thought of as a painted background (`background`), a colour for every point; curves
take the colours of their sides from it, or from the thing whose outline they are. Coordinates: x
right, y down, artboard 720 x 480.
"""

import math
import random

WIDTH, HEIGHT = 720, 480
MOON = (512, 112)
MOON_RADIUS = 33


def mix(a, b, t):
    t = min(1, max(0, t))
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def ramp(stops, t):
    """A piecewise linear colour ramp: stops are (position, colour)."""
    for (t0, a), (t1, b) in zip(stops, stops[1:]):
        if t <= t1:
            return mix(a, b, (t - t0) / (t1 - t0))
    return stops[-1][1]


def smooth_chain(points):
    """Cubic Bezier control points through points (Catmull-Rom, open)."""
    chain = [points[0]]
    count = len(points)
    for i in range(count - 1):
        before, a = points[max(i - 1, 0)], points[i]
        b, after = points[i + 1], points[min(i + 2, count - 1)]
        chain.append((a[0] + (b[0] - before[0]) / 6, a[1] + (b[1] - before[1]) / 6))
        chain.append((b[0] - (after[0] - a[0]) / 6, b[1] - (after[1] - a[1]) / 6))
        chain.append(b)
    return chain


def closed_chain(points):
    """A smooth closed chain through points; clockwise on the screen has its inside on the right."""
    count = len(points)
    chain = [points[0]]
    for i in range(count):
        before, a = points[i - 1], points[i]
        b, after = points[(i + 1) % count], points[(i + 2) % count]
        chain.append((a[0] + (b[0] - before[0]) / 6, a[1] + (b[1] - before[1]) / 6))
        chain.append((b[0] - (after[0] - a[0]) / 6, b[1] - (after[1] - a[1]) / 6))
        chain.append(b)
    return chain


def bent_chain(*parts):
    """Smooth chains joined at corners: each part begins where the part before ends."""
    chain = smooth_chain(parts[0])
    for part in parts[1:]:
        chain += smooth_chain([chain[-1]] + part)[1:]
    return chain


def point_on(chain, parameter):
    piece = min(int(parameter), (len(chain) - 1) // 3 - 1)
    t = parameter - piece
    p = chain[3 * piece:3 * piece + 4]
    w = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
    return tuple(sum(w[i] * p[i][k] for i in range(4)) for k in range(2))


def polygon(chain):
    return [point_on(chain, i / 16) for i in range(16 * ((len(chain) - 1) // 3) + 1)]


def is_inside(point, polygon):
    x, y = point
    inside = False
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:]):
        if (y0 > y) != (y1 > y) and x < x0 + (x1 - x0) * (y - y0) / (y1 - y0):
            inside = not inside
    return inside


def split_piece(p, t):
    """De Casteljau: the control points of both parts."""
    rows = [list(p)]
    while len(rows[-1]) > 1:
        row = rows[-1]
        rows.append([tuple(a + (b - a) * t for a, b in zip(q, r)) for q, r in zip(row, row[1:])])
    return [row[0] for row in rows], [row[-1] for row in reversed(rows)]


def part_of(chain, start, end):
    """The part of a chain between two parameters."""
    parts = []
    for piece in range(int(start), math.ceil(end)):
        control = chain[3 * piece:3 * piece + 4]
        lower, upper = max(0, start - piece), min(1, end - piece)
        if upper < 1:
            control = split_piece(control, upper)[0]
        if lower > 0:
            control = split_piece(control, lower / upper)[1]
        parts += control if not parts else control[1:]
    return parts


class Picture:
    """Curves: control points and the stops of both sides, a stop being (parameter, colour)."""

    def __init__(self):
        self.curves = []
        self.things = []  # outlines that hide what was thought of behind them, as polygons

    def hide_behind(self, chain):
        self.things.append(polygon(chain))

    def is_hidden(self, point):
        return any(is_inside(point, thing) for thing in self.things)

    def add_behind(self, chain, left, right, stops_per_piece=2):
        """Adds what the things of hide_behind leave of a curve."""
        pieces = (len(chain) - 1) // 3
        steps = 128 * pieces
        hidden = [self.is_hidden(point_on(chain, i / 128)) for i in range(steps + 1)]
        start = 0.0
        for i in range(steps):
            if hidden[i] == hidden[i + 1]:
                continue
            lower, upper = i / 128, (i + 1) / 128
            for _ in range(30):
                middle = (lower + upper) / 2
                if self.is_hidden(point_on(chain, middle)) == hidden[i]:
                    lower = middle
                else:
                    upper = middle
            if hidden[i]:
                start = upper
            elif lower > start:
                self.add(part_of(chain, start, lower), left, right, stops_per_piece)
        if not hidden[-1]:
            self.add(part_of(chain, start, pieces), left, right, stops_per_piece)

    def add(self, chain, left, right, stops_per_piece=2):
        """left and right give the colour at a point of the curve."""
        pieces = (len(chain) - 1) // 3
        count = pieces * stops_per_piece
        parameters = [i / stops_per_piece for i in range(count + 1)]
        stops = [[(t, side(*point_on(chain, t))) for t in parameters] for side in (left, right)]
        self.curves.append((chain, *stops))

    def xml(self):
        lines = ['<!DOCTYPE CurveSetXML>', '<!-- Drawn by make_evening.py. -->',
                 f'<curve_set image_width="{WIDTH}" image_height="{HEIGHT}" '
                 f'nb_curves="{len(self.curves)}">']
        for chain, left, right in self.curves:
            lines += [f' <curve nb_control_points="{len(chain)}" nb_left_colors="{len(left)}" '
                      f'nb_right_colors="{len(right)}" nb_blur_points="0">',
                      '  <control_points_set>']
            # The format calls the row x and the column y, and swaps red and blue.
            lines += [f'   <control_point x="{y:.2f}" y="{x:.2f}"/>' for x, y in chain]
            lines.append('  </control_points_set>')
            for name, stops in (('left', left), ('right', right)):
                lines.append(f'  <{name}_colors_set>')
                for t, colour in stops:
                    b, g, r = (round(min(255, max(0, c))) for c in colour)
                    lines.append(f'   <{name}_color R="{r}" G="{g}" B="{b}" '
                                 f'globalID="{round(10 * t)}"/>')
                lines.append(f'  </{name}_colors_set>')
            lines.append(' </curve>')
        lines.append('</curve_set>')
        return '\n'.join(lines)


# The background ---------------------------------------------------------------------------------

SKY = [(-40, (22, 28, 66)), (60, (44, 46, 98)), (130, (98, 78, 136)), (180, (178, 116, 148)),
       (215, (236, 160, 146)), (250, (252, 204, 168))]


def glow(x, y, reach):
    return math.exp(-math.hypot(x - MOON[0], y - MOON[1]) / reach)


def sky(x, y):
    return mix(ramp(SKY, y), (255, 204, 190), 0.8 * glow(x, y, 72))


# Mountain ranges, far to near: the crest, the colour of the rock there, the mist at the foot.
RANGES = [
    ([(-60, 212), (10, 196), (60, 204), (118, 168), (150, 178), (196, 142), (232, 166), (262, 160),
      (318, 196), (372, 186), (420, 204), (500, 190), (560, 204), (640, 178), (700, 188),
      (790, 166)], (146, 112, 156), (226, 170, 170)),
    ([(-60, 236), (30, 222), (92, 232), (160, 212), (240, 232), (330, 216), (398, 236), (470, 222),
      (540, 234), (604, 212), (640, 220), (684, 204), (724, 214), (790, 200)],
     (108, 90, 146), (196, 150, 172)),
    ([(-60, 240), (20, 232), (70, 246), (150, 244), (230, 258), (320, 250), (420, 264), (500, 252),
      (570, 260), (650, 238), (720, 246), (790, 230)], (74, 72, 126), (150, 124, 164)),
    ([(-60, 262), (40, 258), (130, 276), (230, 280), (330, 288), (430, 290), (520, 284), (600, 276),
      (680, 262), (790, 254)], (44, 50, 98), (92, 88, 138)),
]
SHORE = 308


def moonlit(colour, x, reach=150, strength=0.4):
    return mix(colour, (255, 214, 180), strength * math.exp(-((x - MOON[0]) / reach) ** 2))


CRESTS = [polygon(smooth_chain(crest)) for crest, _, _ in RANGES]


def crest_height(crest, x):
    for (x0, y0), (x1, y1) in zip(crest, crest[1:]):
        if x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return crest[-1][1]


WATER = [(SHORE, (34, 38, 84)), (330, (86, 72, 122)), (368, (168, 112, 146)),
         (400, (120, 86, 136)), (440, (58, 56, 110)), (510, (20, 25, 62))]


def water(x, y):
    shine = math.exp(-((x - MOON[0]) / (34 + 0.25 * (y - SHORE))) ** 2)
    return mix(ramp(WATER, y), (255, 206, 176), 0.45 * shine)


def background(x, y):
    if y >= SHORE:
        return water(x, y)
    tops = [crest_height(crest, x) for crest in CRESTS] + [SHORE]
    if y < tops[0]:
        return sky(x, y)
    for i, (_, rock, mist) in enumerate(RANGES):
        if y <= tops[i + 1] or i + 1 == len(RANGES):
            t = (y - tops[i]) / max(1, tops[i + 1] - tops[i])
            return mix(moonlit(rock, x, strength=0.2), moonlit(mist, x), t)


# The picture ------------------------------------------------------------------------------------


def paint_sky(picture):
    picture.add(smooth_chain([(-60, -20), (240, -20), (512, -20), (790, -20)]), sky, sky)
    for centre, top, half_width, tilt in ((190, 66, 128, -5), (352, 122, 88, 4),
                                          (640, 58, 84, -4)):
        points = [(centre - half_width, top + tilt), (centre - 0.35 * half_width, top - 5),
                  (centre + 0.3 * half_width, top - 4), (centre + half_width, top - tilt)]

        def fade(x, centre=centre, half_width=half_width):
            return 1 - 0.7 * abs(x - centre) / half_width

        picture.add_behind(smooth_chain(points),
                           lambda x, y: mix(sky(x, y), (226, 150, 184), 0.55 * fade(x)),
                           lambda x, y: mix(sky(x, y), (92, 66, 132), 0.5 * fade(x)))


def paint_moon(picture):
    circle = [(MOON[0] + MOON_RADIUS * math.sin(a), MOON[1] - MOON_RADIUS * math.cos(a))
              for a in (i * math.tau / 12 for i in range(12))]
    halo = lambda x, y: mix(sky(x, y), (255, 222, 196), 0.6)
    face = lambda x, y: mix((255, 252, 234), (252, 214, 168), (y - MOON[1] + MOON_RADIUS) / 66)
    picture.add(closed_chain(circle), halo, face)


def paint_mountains(picture):
    feet = [sky] + [lambda x, y, mist=mist: moonlit(mist, x) for _, _, mist in RANGES]
    for (crest, rock, _), above in zip(RANGES, feet):
        picture.add_behind(smooth_chain(crest), above,
                           lambda x, y, rock=rock: moonlit(rock, x, strength=0.2))
    shore = [(x, SHORE) for x in (-60, 120, 300, 512, 790)]
    picture.add_behind(smooth_chain(shore), feet[-1], water, 4)


def lens(centre, y, half_width, half_height):
    return closed_chain([(centre - half_width, y), (centre - 0.5 * half_width, y - half_height),
                         (centre + 0.4 * half_width, y - half_height), (centre + half_width, y),
                         (centre + 0.5 * half_width, y + half_height),
                         (centre - 0.4 * half_width, y + half_height)])


def paint_water(picture):
    picture.add(smooth_chain([(-60, 505), (240, 505), (512, 505), (790, 505)]), water, water)
    chance = random.Random(7)
    for y, x, half_width in ((340, 176, 70), (348, 656, 56), (388, 176, 96), (398, 644, 74),
                             (428, 376, 80), (450, 668, 66)):
        bend = chance.uniform(-3, 3)
        wave = [(x - half_width, y), (x - half_width / 3, y + bend), (x + half_width / 3, y - bend),
                (x + half_width, y)]
        picture.add_behind(smooth_chain(wave), lambda x, y: mix(water(x, y), (34, 34, 88), 0.12),
                           lambda x, y: mix(water(x, y), (255, 186, 186), 0.14))
    for i in range(8):
        y = SHORE + 9 + 13 * i + 1.1 * i * i
        half_width = 13 + 5.5 * i + chance.uniform(-4, 4)
        centre = MOON[0] + chance.uniform(-5, 5)
        bright = mix((255, 240, 208), (244, 186, 170), i / 9)
        picture.add(lens(centre, y, half_width, 1.6 + 0.35 * i),
                    water, lambda x, y, bright=bright: bright, 1)


class Boat:
    """At anchor, its lantern lit; (0, 0) is the foot of the mast at the water."""

    AT = (268, 374)

    def __init__(self):
        self.lamp = (self.AT[0] + 47, self.AT[1] - 17)
        self.sail = bent_chain(self.at((4, -104), (25, -74), (37, -44), (40, -18)),
                               self.at((22, -15), (4, -13)), self.at((3, -56), (4, -104)))
        self.jib = bent_chain(self.at((-1, -92), (-2, -50), (-3, -12)),
                              self.at((-18, -12), (-35, -11)), self.at((-19, -48), (-1, -92)))
        self.hull = bent_chain(self.at((-52, -10), (-20, -4), (24, -4), (58, -11)),
                               self.at((50, 3), (37, 9)), self.at((0, 11), (-35, 9)),
                               self.at((-45, 2), (-52, -10)))

    def at(self, *points):
        return [(self.AT[0] + x, self.AT[1] + y) for x, y in points]

    def lit(self, colour, strength, reach=30):
        """A colour (or a function that gives it), with the lantern's light on it."""
        def light(x, y):
            near = math.exp(-math.hypot(x - self.lamp[0], y - self.lamp[1]) / reach)
            return mix(colour(x, y), (255, 196, 110), strength * near)
        return light

    def paint(self, picture):
        x0, y0 = self.AT
        picture.add(self.sail, self.lit(background, 0.3),
                    lambda x, y: mix((255, 232, 206), (168, 118, 148), (x0 + 38 - x) / 40), 10)
        picture.add(self.jib, background,
                    lambda x, y: mix((196, 140, 158), (96, 78, 128), (x0 - x) / 30), 10)
        picture.add(self.hull, self.lit(background, 0.5),
                    self.lit(lambda x, y: mix((66, 42, 62), (24, 18, 44), (y - y0 + 9) / 18), 0.7),
                    4)
        lantern = [(self.lamp[0] + 3.4 * math.sin(a), self.lamp[1] - 4.4 * math.cos(a))
                   for a in (i * math.tau / 10 for i in range(10))]
        picture.add(closed_chain(lantern), self.lit(background, 0.75), lambda *_: (255, 246, 206))

    def paint_reflection(self, picture):
        x0, y0 = self.AT
        shade = lambda x, y: mix((30, 26, 60), water(x, y), 0.25)
        pale = lambda x, y: mix((240, 198, 188), water(x, y), 0.25)
        gold = lambda x, y: mix((255, 206, 130), water(x, y), 0.2)
        for x, y, half_width, colour in ((2, 16, 42, shade), (20, 25, 16, pale), (18, 36, 12, pale),
                                         (17, 48, 8, pale), (48, 23, 7, gold), (47, 33, 5, gold)):
            picture.add(lens(x0 + x, y0 + y, half_width, 1.7), water, colour, 1)


class Cypress:
    """A tree like a flame, its right side lit by the moon."""

    def __init__(self, foot, ground, height, width):
        self.foot, self.width = foot, width
        shares = (0.08, 0.2, 0.36, 0.54, 0.72, 0.88)
        halves = (0.2, 0.44, 0.72, 0.95, 1.0, 0.72)
        right = [(foot + half * width + (2 if i % 2 else -1.5), ground - height * (1 - share))
                 for i, (share, half) in enumerate(zip(shares, halves))]
        left = [(foot - 0.94 * half * width + (1.5 if i % 2 else -1.5),
                 ground - height * (1 - share) + 6)
                for i, (share, half) in enumerate(zip(shares, halves))]
        tip = (foot + 4, ground - height)
        self.outline = bent_chain([tip] + right + [(foot + 5, ground)], [(foot - 5, ground)],
                                  list(reversed(left)) + [tip])

    def colour(self, x, y):
        return mix((10, 16, 40), (84, 78, 116), ((x - self.foot) / self.width + 0.1) * 0.9)

    def paint(self, picture):
        picture.add_behind(self.outline, background, self.colour, 12)


def reeds():
    """Outlines of blades, each from its root up the left edge and down the right one."""
    for root, ground, lean, height in ((178, 456, -12, 74), (188, 460, 3, 104), (200, 464, 24, 80)):
        tip = (root + lean, ground - height)
        bend = (root + 0.2 * lean, ground - 0.55 * height)
        yield bent_chain([(root - 2.2, ground), (bend[0] - 1.6, bend[1]), tip],
                         [(bend[0] + 1.6, bend[1]), (root + 2.2, ground)])


def main():
    picture = Picture()
    boat = Boat()
    trees = [Cypress(70, 440, 316, 27), Cypress(128, 452, 214, 19)]
    bank = smooth_chain([(-60, 404), (20, 412), (84, 428), (150, 446), (220, 466), (300, 500)])

    picture.hide_behind(bank + [(200, 600), (-60, 600), (-60, 404)])
    for tree in trees:
        tree.paint(picture)
    blades = list(reeds())
    for blade in blades:
        picture.add_behind(blade, background,
                           lambda x, y: mix((14, 18, 44), (74, 66, 104), (460 - y) / 130))
    boat.paint_reflection(picture)
    boat.paint(picture)
    for chain in [tree.outline for tree in trees] + blades + [boat.sail, boat.jib, boat.hull]:
        picture.hide_behind(chain)

    def above_bank(x, y):
        standing = [tree for tree in trees if is_inside((x, y - 2), polygon(tree.outline))]
        return standing[0].colour(x, y) if standing else background(x, y)

    picture.add(bank, above_bank,
                lambda x, y: mix((8, 11, 30), (26, 34, 66), (x + 60) / 420), 24)
    paint_sky(picture)
    paint_moon(picture)
    paint_mountains(picture)
    paint_water(picture)
    print(picture.xml())


if __name__ == '__main__':
    main()
