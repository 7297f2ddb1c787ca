#!/usr/bin/env python3
"""Draws examples/fish.svg: a school of one fish, drawn once, over a reef.

    examples/make_fish.py > examples/fish.svg

The fish, a bubble and a blade of kelp are layers in <defs>; everything else that swims, rises or
grows is a <use> of them. Depth is opacity: what is far lets the water through. Coordinates: x
right, y down, artboard 840 x 560; the light comes from above.
"""

import math
import random

from drawing import curve, document, element, group, layer, path, smooth_chain

WIDTH, HEIGHT = 840, 560


def number(value, digits=1):
    """With at most so many digits after the point, at least one."""
    return f'{value:.{digits}f}'.rstrip('0').rstrip('.')


# The outline of the fish, clockwise from its nose: the end of each cubic and its control points.
OUTLINE = [
    ((5, -8), (20, -26), (46, -33)), ((50, -45), (58, -55), (69, -57)),
    ((82, -57), (92, -47), (101, -33)), ((95, -24), (91, -15), (93, -7)),
    ((103, -11), (114, -21), (128, -27)), ((120, -12), (120, 13), (129, 28)),
    ((114, 22), (103, 12), (93, 8)), ((91, 16), (94, 26), (98, 36)), ((89, 45), (75, 51), (62, 48)),
    ((55, 44), (50, 40), (46, 35)), ((32, 31), (11, 18), (0, 2))]
# Where the edges of the two dark bands meet the outline: on its first and on its last cubic.
BANDS = ((.69, .46), (.755, .385), (.885, .21), (.945, .13))


def on_outline(segment, t):
    a, (b, c, d) = OUTLINE[segment - 1][2], OUTLINE[segment]
    return tuple((1 - t) ** 3 * p + 3 * t * (1 - t) ** 2 * q + 3 * t * t * (1 - t) * r + t ** 3 * s
                 for p, q, r, s in zip(a, b, c, d))


def outline_colours():
    """Inside the outline: steps where bands meet it, light along the rims of the fins."""
    dark, (front, first, second, back) = '#3f2430', (t for t, _ in BANDS)
    top = (f'#e8791a @0, #f2951c @.35, #ef8c16 @{front}, {dark} @{front}, {dark} @{first}, '
           f'#fffdf2 @{first}, #fffdf2 @{second}, {dark} @{second}, {dark} @{back}, '
           f'#ee9a1c @{back}, #e58a16 @1')
    fins = ('#f5b529 @1.4, #fbe27a @2, #f9cf4a @2.6, #ea9a20 @3, #d97f14 @3.7, #e8921c @4, '
            '#fbd35a @4.6, #fdeb9a @5, #fff2b8 @5.5, #fdeb9a @6, #fbd35a @6.5, #e08a18 @7, '
            '#e9a02a @7.4, #fbd862 @8, #fdeaa0 @8.6, #fbd45c @9, #f4c050 @9.8')
    front, first, second, back = (number(10 + t, 3) for _, t in BANDS)
    bottom = (f'#fdeaa8 @10, #fdeaa8 @{back}, {dark} @{back}, {dark} @{second}, #f4efe4 @{second}, '
              f'#f4efe4 @{first}, {dark} @{first}, {dark} @{front}, #fdd79a @{front}, '
              '#f9c48a @10.7, #e8791a @11')
    return ', '.join((top, fins, bottom))


def band_edge(which, left, right, blur):
    (x0, y0), (x1, y1) = on_outline(0, BANDS[which][0]), on_outline(10, BANDS[which][1])
    data = (f'M{number(x0, 2)} {number(y0, 2)}C{number(x0 + 8)} -13 {number(x1 + 8)} 13 '
            f'{number(x1, 2)} {number(y1, 2)}')
    return curve(data, sf_left=left, sf_right=right, sf_blur=blur)


def bands():
    dark, white = '#3f2430, #5c2f3e 40%, #3f2430', '#fffdf2, #ffffff 40%, #f4efe4'
    return [band_edge(0, dark, '#ef8c16, #f7a024 45%, #fdd79a', '.4, 1.5, .4'),
            band_edge(1, white, dark, '.3, .8, .3'), band_edge(2, dark, white, '.3, .8, .3'),
            band_edge(3, '#ee9a1c, #fbc232 45%, #fdeaa8', dark, '.4, 1.5, .4')]


def fish():
    """Facing left, its nose at the origin, 129 long; one curve around it bears the opacity."""
    outline = 'M0 2' + ''.join('C' + ' '.join(f'{x} {y}' for x, y in piece) for piece in OUTLINE)
    body = [
        curve(outline + 'Z', sf_left='#d9861a', sf_left_opacity=0, sf_right_opacity=1,
              sf_right=outline_colours(), fill='#f5b529',
              sf_blur='.5 @0, .5 @1, 1.5 @1.5, 2.5 @2.5, .7 @3.5, 3 @5, 3 @6, .7 @7, 2.5 @8.3, '
                      '.7 @9.6, .5 @10, .5 @11'),
        # Where the fins begin: the body on the one side, the fin on the other.
        curve('M46 -33C62 -33 82 -24 93 -7', sf_left='#d9760f, #d97a12 50%, #cf6c10',
              sf_right='#e08a16, #ea9a1c 50%, #c96a10', sf_blur='.6, 2.5, 1'),
        curve('M93 -7C98 -3 98 4 93 8', sf_left='#e07c10', sf_right='#c9620c', sf_blur='1.5'),
        curve('M93 8C80 25 64 36 46 35', sf_left='#dd8f1c, #e9a12a 50%, #f0c050',
              sf_right='#e08a14, #fbd95a 45%, #fff0bc', sf_blur='1, 2.5, .6'),
        # The flank: lit above the middle, and again by the sand below.
        curve('M57 -19C66 -20 77 -14 84 -5', sf_left='#fbc22e, #f9b728 60%, #e9951a',
              sf_right='#fdd850, #fcc838 60%, #ea9a1c', sf_blur='0, 3, 0'),
        curve('M56 17C65 18 75 13 82 6', sf_left='#fde484, #fcd24c 60%, #f0a622',
              sf_right='#feeda4, #fcda5e 60%, #f0a622', sf_blur='0, 3, 0'),
        # The dark bar before the tail.
        curve('M87 -10C90 -4 90 6 87 12', sf_left='#5a2c22, #7a3a20, #5a2c22',
              sf_right='#f0a01c', sf_blur='1.6'),
        # Mouth and cheek.
        curve('M1 3C4 5 7 6 10 5', sf_left='#e5811c, #d87014', sf_right='#8a3a16, #f3a845',
              sf_blur='.3, .8'),
        curve('M25 -10C30 -2 29 9 23 15', sf_left='#f9b03a, #fbc65a', sf_right='#dd7812, #ea9a36',
              sf_blur='.5, 2.5, .5')]
    rays = [curve(data, sf_left=light, sf_right=dark, sf_blur='.4, 1.2')
            for data, light, dark in fin_rays()]
    eye = [element('circle', cx=15, cy=-7, r=5.4, sf_left='#d9740f', sf_right='#fbe6a0',
                   sf_blur='.5'),
           element('circle', cx=15, cy=-7, r=3.9, sf_left='#f3c860', sf_right='#140f18'),
           element('circle', cx=13.6, cy=-8.5, r=1.2, sf_left='#241c2a', sf_right='#ffffff')]
    pectoral = layer('fish-fin', [
        curve('M46 7C53 1 64 3 71 11C67 18 58 21 52 19C48 16 46 12 46 7Z', sf_left='#c9690f',
              sf_right='#d97a14, #fbd45a 30%, #fff0b0 50%, #f9c848 75%, #d97a14',
              sf_left_opacity=0, sf_right_opacity='1, .95 30%, .85 50%, .95 75%, 1',
              sf_blur='.3, 1 40%, 1 60%, .3', fill='#f9c848'),
        curve('M49 9C55 8 62 9 67 12', sf_left='#fbd45a', sf_right='#d98a1c', sf_blur='.5, 1'),
        curve('M49 12C54 14 59 16 63 16', sf_left='#f5c040', sf_right='#d0801a', sf_blur='.5, 1')])
    glint = curve('M55 -25C65 -26 75 -21 82 -13', sf_left='#fffbe0', sf_right='#fffbe0',
                  sf_radius='1, 4 40%, 1', sf_alpha='.5')
    cheek = curve('M11 -11C14 -15 18 -18 23 -20', sf_left='#fff0c8', sf_right='#fff0c8',
                  sf_radius='.8, 2 50%, .8', sf_alpha='.45')
    return group('fish', [*layer('fish-body', body + bands() + rays + eye), *pectoral, glint,
                          cheek])


def fin_rays():
    """(path data, light, dark) of the rays of all fins."""
    for start, end in (((58, -35), (66, -52)), ((67, -33), (77, -50)), ((75, -29), (87, -45)),
                       ((83, -23), (94, -36))):
        yield ray(start, end, 2), '#f9c648, #fdea9e', '#cf7d12, #eeb446'
    for start, end in (((98, -3), (121, -18)), ((99, 0), (118, -8)), ((99, 2), (118, 8)),
                       ((98, 4), (121, 19))):
        yield ray(start, end, 1), '#f7bb36, #fff0b4', '#cf7d12, #f3c45c'
    for start, end in (((85, 22), (91, 37)), ((75, 31), (80, 44)), ((64, 37), (67, 45))):
        yield ray(start, end, -2), '#f9d05c, #fdeeb0', '#d08a1e, #f0c058'


def ray(start, end, bend):
    (x0, y0), (x1, y1) = start, end
    x, y = (x0 + x1) / 2, (y0 + y1) / 2 - bend
    return f'M{x0} {y0}Q{number(x)} {number(y)} {x1} {y1}'


def bubble():
    """Radius 10 at the origin: nearly clear, bright along the rim."""
    return group('bubble', [
        *layer('bubble-skin', [
            element('circle', r=10, sf_left='#e8ffff', sf_right='#b5eef5, #eaffff 40%, #ffffff 62%,'
                    '#d5f7fa 80%, #b5eef5', sf_left_opacity=0,
                    sf_right_opacity='.35, .5 25%, .75 62%, .4', sf_blur='.6'),
            element('circle', r=7.4, sf_left='#dffbff', sf_right='#9fe3ee',
                    sf_opacity='.08, .14 25%, .2 62%, .08', sf_blur='2')]),
        curve('M-6 -1C-5.6 -4 -4 -5.6 -1.6 -6.2', sf_left='#fff', sf_right='#fff',
              sf_radius='.4, 1.6 50%, .4', sf_alpha='.95')])


def kelp():
    """A blade that grows from the origin 240 up, its tip to the right."""
    rib = [(0, 10), (6, -40), (-8, -90), (8, -140), (2, -190), (22, -240)]
    half = (6, 9, 11, 11, 8, 0)
    left = [(x - w, y) for (x, y), w in zip(rib, half)]
    right = [(x + w, y) for (x, y), w in zip(rib, half)]
    outline = path(left + right[-2::-1] + [left[0]], True)
    colours = '#123f3c, #2a7a4c 25%, #8fc65c 48%, #4f9a50 54%, #16594a 80%, #0e3a3a'
    return layer('kelp', [
        curve(outline, sf_left='#1a5a4a', sf_right=colours, sf_left_opacity=0,
              sf_right_opacity=1, sf_blur='1, 2 45%, 3 50%, 2 55%, 1', fill='#2a7a4c'),
        curve(path(rib[:-1]), sf_left='#1d6a4a, #4f9d50 60%, #86bf58',
              sf_right='#0c3c38, #1b6448 60%, #3f8a4c', sf_blur='2, 5, 2')])


def water():
    """Everything behind: bright under the surface, dark in the deep."""
    frame = curve('M-120 -90L960 -90L960 650L-120 650Z',
                  sf_right='#5fd0d8, #7fe0dc 10%, #4dc2d4 29%, #0b5a8c 40%, #05325e 50%, '
                           '#04284e 65%, #063a68 80%, #1a87ae 90%, #5fd0d8', fill='none')
    glow = curve('M40 -60C200 70 440 70 640 -60', sf_left='#c6f6e6, #f2fff0 45%, #b5f0e4',
                 sf_right='#7fe2dc, #a5f0e0 45%, #6fd8dc', sf_blur='40, 90 50%, 40', fill='none')
    middle = curve('M-100 300C140 260 520 330 940 250', sf_left='#2aa3c4, #35b2cc 40%, #1a83b0',
                   sf_right='#1f8fb8, #2a9cc0 40%, #12709f', sf_blur='60', fill='none')
    return layer('water', [frame, glow, middle])


def rays():
    """Light that falls through the waves: sharper above, wide and faint below."""
    lines = []
    for x, top, lean, foot, light in ((150, 26, -120, 70, .34), (240, 40, -70, 110, .45),
                                      (330, 18, -20, 60, .3), (400, 46, 40, 120, .42),
                                      (490, 22, 110, 80, .3), (570, 34, 190, 110, .26)):
        low = 470 - abs(lean) / 2
        data = (f'M{x} -30L{x + top} -30L{x + lean + top / 2 + foot} {low}'
                f'L{x + lean + top / 2 - foot / 4} {low}Z')
        lines += layer(f'ray-{x}', [curve(
            data, sf_left='#d5fff2', sf_right='#d5fff2', sf_left_opacity=0,
            sf_right_opacity=f'{light}@0, {light}@1, 0@1.95, 0@3.05, {light}@4'.replace('@', ' @'),
            sf_blur=f'4 @0, 4 @1, {foot / 3:.0f} @2, {foot / 3:.0f} @3, 4 @4', fill='#d5fff2',
            fill_opacity='.2')])
    return group('rays', lines, ' style="mix-blend-mode:soft-light"')


def coral(chance):
    """A bush of local curves, 100 high, each branch as thick as its radius; it stands at 0, 0."""
    lines = []

    def grow(x, y, angle, length, radius, age):
        bend = chance.uniform(-.35, .35)
        middle = (x + .5 * length * math.sin(angle), y - .5 * length * math.cos(angle))
        end = (x + length * math.sin(angle + bend), y - length * math.cos(angle + bend))
        colours = CORAL[age:age + 2]
        lines.append(curve(
            f'M{number(x)} {number(y)}Q{number(middle[0])} {number(middle[1])} '
            f'{number(end[0])} {number(end[1])}',
            sf_left=', '.join(light for light, _ in colours),
            sf_right=', '.join(dark for _, dark in colours), sf_blur=number(.8 * radius),
            sf_radius=f'{number(radius)}, {number(.8 * radius)}', sf_alpha='1.6'))
        if age < len(CORAL) - 2:
            for side in (-1, 1, chance.choice((-.2, .3))):
                grow(*end, angle + bend + side * chance.uniform(.3, .6), length * .74, radius * .78,
                     age + 1)

    for angle in (-.55, 0, .5):
        grow(0, 0, angle, 34, 8, 0)
    return group('coral', lines, ' fill="none" stroke="#d8506a"')


# Light and dark of a branch, from the foot to the tips.
CORAL = [('#8a3a5c', '#4a1d40'), ('#c4496a', '#6a2450'), ('#e8667a', '#8e3058'),
         ('#ff9a92', '#b84466'), ('#ffd2bc', '#e0788a')]


def rock():
    """A boulder 200 wide, 90 high, its foot at 0, 0: moss in the light, blue in the shade."""
    return layer('rock', [
        curve('M-100 20C-100 -20 -70 -64 -34 -68C-4 -92 50 -76 70 -46C94 -34 104 -4 106 20Z',
              sf_left='#3b7f8a', sf_left_opacity=0, sf_right_opacity=1, fill='#2c5f70',
              sf_right='#1b4a5e, #4f9a8e 20%, #9fd0a0 34%, #8cc49c 44%, #3f8088 55%, #123a55 68%, '
                       '#0b2d48 80%, #0b2d48 95%, #1b4a5e',
              sf_blur='2 @0, 2 @3, 22 @3.2, 22 @3.8, 2 @4'),
        curve('M-70 0C-58 -30 -30 -42 0 -40', sf_left='#2f6d78, #7fb69a 50%, #5aa394',
              sf_right='#2f6d78, #1f5468 50%, #5aa394', sf_blur='1, 9, 1'),
        curve('M10 -66C30 -50 40 -24 38 6', sf_left='#5f9f92, #113a56 40%, #14425c',
              sf_right='#5f9f92, #6fb096 40%, #14425c', sf_blur='1, 9, 1'),
        curve('M-20 -20C-4 -14 4 -2 6 14', sf_left='#1f5468, #0f3852 50%, #103a56',
              sf_right='#1f5468, #34757f 50%, #103a56', sf_blur='1, 8, 1')])


def caustics(chance):
    """The net of light that waves throw on the sand: thin local curves."""
    lines = []
    for _ in range(46):
        y = chance.uniform(505, 556)
        x, length = chance.uniform(-20, WIDTH), chance.uniform(26, 60) * (y - 420) / 90
        points = [(x + length * t, y + chance.uniform(-3.2, 3.2)) for t in (0, .33, .66, 1)]
        wide = (y - 440) / 60 * chance.uniform(.9, 1.6)
        lines.append(curve(path(points), sf_left='#eafff0', sf_right='#eafff0', sf_alpha='.5',
                           sf_radius=f'.4, {number(wide)} 50%, .4'))
    return group('caustics', lines, ' fill="none" stroke="#eafff0" opacity=".55" '
                 'style="mix-blend-mode:soft-light"')


def reef(name, points, colours, deep, blur, opacity):
    """A ridge against the water; colours, evenly spread along its upper edge; deep below it."""
    last = len(points) - 1
    closed = path(points) + f'L{number(points[-1][0])} 700L{number(points[0][0])} 700Z'
    edge = [f'{colour} @{number(last * i / (len(colours) - 1))}'
            for i, colour in enumerate(colours)]
    inside = ', '.join([*edge, f'{deep} @{last + .3}', f'{deep} @{last + 2.7}', edge[0][:7]])
    return layer(name, [curve(closed, sf_left=colours[0], sf_right=inside, sf_left_opacity=0,
                              sf_right_opacity=opacity, sf_blur=blur, fill=deep)])


def use(name, x, y, scale, turn=0, mirrored=False, opacity=1):
    flip = f'scale({-scale:.3g} {scale:.3g})' if mirrored else f'scale({scale:.3g})'
    turned = f' rotate({turn:.0f})' if round(turn) else ''
    attributes = {'xlink:href': '#' + name,
                  'transform': f'translate({x:.0f} {y:.0f}){turned} {flip}'}
    if opacity < 1:
        attributes['opacity'] = f'{opacity:.2f}'
    return element('use', **attributes)


def on_route(route, t):
    """The point at t, 0 to 1, of a smooth curve through route, and its angle in degrees."""
    chain = smooth_chain(route)
    segment = min(len(chain) - 1, int(t * len(chain)))
    u = t * len(chain) - segment
    weights = ((1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u * u * (1 - u), u ** 3)
    slopes = (-(1 - u) ** 2, (1 - u) ** 2 - 2 * u * (1 - u), 2 * u * (1 - u) - u * u, u * u)
    point, way = (tuple(sum(w * p[k] for w, p in zip(ws, chain[segment])) for k in (0, 1))
                  for ws in (weights, slopes))
    return point, math.degrees(math.atan2(way[1], way[0]))


class School:
    """Fish in the water, none before another; from the far, small and pale, to the near."""

    def __init__(self, chance):
        self.chance, self.fish = chance, []

    def is_free(self, x, y, scale):
        return all(math.hypot(x - a, y - b) > 66 * (scale + other) for a, b, other, *_ in self.fish)

    def add(self, x, y, scale, turn, opacity=1):
        """Adds a fish. turn: the angle of its direction."""
        self.fish.append((x, y, scale, turn, opacity))

    def follow(self, route, count, scales, opacities, spread):
        """scales, opacities: at the beginning and the end of the route; spread to either side."""
        for _ in range(40 * count):
            if count == 0:
                return
            t = self.chance.random()
            (x, y), angle = on_route(route, t)
            scale = (scales[0] + (scales[1] - scales[0]) * t ** 1.5) * self.chance.uniform(.85, 1.1)
            x += self.chance.uniform(-1, 1) * spread * (.4 + t)
            y += self.chance.uniform(-1, 1) * spread * (.4 + t)
            if self.is_free(x, y, scale):
                opacity = opacities[0] + (opacities[1] - opacities[0]) * t
                self.add(x, y, scale, angle + self.chance.uniform(-7, 7), opacity)
                count -= 1

    def lines(self):
        for x, y, scale, turn, opacity in sorted(self.fish, key=lambda one: one[2]):
            mirrored = math.cos(math.radians(turn)) > 0
            tilt = turn if mirrored else (turn + 180 + 180) % 360 - 180
            shift = -64 * scale * (-1 if mirrored else 1)
            x += shift * math.cos(math.radians(tilt))
            y += shift * math.sin(math.radians(tilt))
            yield use('fish', x, y, scale, tilt, mirrored, opacity)


def school(chance):
    fish = School(chance)
    fish.add(262, 318, 1.5, 172)
    fish.add(560, 380, .95, -10)
    fish.follow([(640, 60), (770, 110), (730, 200), (600, 225), (480, 190), (390, 150), (250, 130),
                 (110, 190)], 34, (.1, .78), (.18, 1), 46)
    fish.follow([(90, 400), (240, 445), (400, 430), (540, 350), (790, 270)], 14, (.14, .46),
                (.22, .85), 34)
    return group('school', list(fish.lines()))


def garden(chance, name, places, opacity):
    lines = []
    for x, y, scale, mirrored in places:
        lines.append(use('kelp', x, y, scale, chance.uniform(-9, 9), mirrored, opacity))
    return group(name, lines)


def bubbles(chance):
    lines = []
    for x, y, count, spread in ((160, 320, 12, 16), (720, 350, 10, 14), (90, 420, 9, 12)):
        for i in range(count):
            t = i / count
            lines.append(use('bubble', x + spread * math.sin(5 * t) + chance.uniform(-8, 8),
                             y - 300 * t - chance.uniform(0, 18),
                             (.2 + .75 * t) * chance.uniform(.6, 1.2), 0, False, .9))
    return group('bubbles', lines)


def main():
    chance = random.Random(11)
    lines = ['<defs>', *('  ' + line for part in
                        (fish(), bubble(), kelp(), coral(chance), rock()) for line in part),
             '</defs>', *water(), *rays()]
    lines += reef('reef-far', [(-60, 420), (60, 380), (150, 400), (240, 440), (360, 470),
                               (480, 455), (580, 430), (680, 380), (780, 350), (900, 370)],
                  ['#2a93b4', '#2f9ab8', '#1b7aa4'], '#0d5586', '6', '.75')
    lines += school(chance)
    lines += garden(chance, 'kelp-far', [(40, 500, .8, False), (75, 510, 1, True),
                                         (770, 500, 1.1, False), (810, 510, .9, True),
                                         (735, 520, .7, False)], .6)
    lines += reef('floor', [(-60, 470), (80, 480), (200, 505), (340, 500), (480, 520), (620, 500),
                            (740, 490), (900, 470)],
                  ['#5fae9c', '#8cc7a4', '#6fb8a0', '#3f8f94'], '#0c3f5e', '4', '1')
    lines += caustics(chance)
    lines += group('rocks', [
        use('rock', 700, 492, .8, 4, True), use('coral', 655, 470, .8, -8),
        use('rock', 130, 520, 1, -3), use('coral', 190, 520, .9, 10, True),
        use('coral', 105, 470, .75, -6), use('rock', 770, 540, 1.15, 0),
        use('coral', 715, 535, 1.0, 4), use('rock', 225, 546, .5, 0, True),
        use('coral', 590, 545, .5, -4)])
    lines += garden(chance, 'kelp-near', [(20, 580, 1.35, False), (-5, 590, 1.7, True),
                                          (60, 590, 1.0, True), (825, 590, 1.6, True),
                                          (790, 600, 1.15, False)], 1)
    lines += bubbles(chance)
    print(document(WIDTH, HEIGHT, 'A school of fish', [
        'Drawn by make_fish.py. One fish, one bubble and one blade of kelp are solved; all others',
        'are instances of them, and the far ones let the water through.'], '#0b5a8c', lines))


if __name__ == '__main__':
    main()
