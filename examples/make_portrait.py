#!/usr/bin/env python3
"""Draws examples/portrait.svg: a woman before the setting sun, as a poster of the 1920s.

    examples/make_portrait.py > examples/portrait.svg

The face is one outline with colours along it and a few soft curves inside. The hair is made of
locks: two edges, and strands that are blended between them. Coordinates: x right, y down, artboard
600 x 760; the light comes from the left.
"""

import math
import random

from drawing import (clockwise, css, curve, document, element, group, layer, mix, number, path,
                     path_data, ramp, rgb, smooth_chain, stops)

WIDTH, HEIGHT = 600, 760
SUN = (322, 318)
SUN_RADIUS = 218

# The skin's outline as (x, y, colour inside), from below the picture up the breast, the profile,
# over the skull and down the back: clockwise.
BREAST = [(20, 820, '#b9806a'), (62, 722, '#e0a788'), (122, 668, '#ebb797'), (190, 624, '#dfa587'),
          (234, 576, '#cd9076'), (254, 528, '#b87862'), (258, 492, '#a86a5c')]
CHIN = [(248, 468, '#b87a66'), (226, 461, '#dba184'), (209, 455, '#e6b092'), (198, 442, '#f5cdb0'),
        (197, 428, '#f7d2b6'), (202, 415, '#e6b296')]
LOWER_LIP = [(195, 407, '#d9907c'), (188, 399, '#d9907c'), (194, 389, '#c87a6c')]
UPPER_LIP = [(185, 381, '#d9907c'), (190, 371, '#e0a08a')]
NOSE = [(197, 362, '#e8b094'), (188, 357, '#eab295'), (175, 352, '#f2bfa2'), (169, 343, '#fbd3b8'),
        (177, 331, '#fbd8bd'), (190, 308, '#fbdcc2'), (203, 284, '#f0c6a8')]
FOREHEAD = [(203, 270, '#f3cbae'), (200, 252, '#fde3cb'), (203, 226, '#fde6d0'),
            (214, 196, '#f6d2b6')]
SKULL = [(240, 160, '#e0ac8e'), (290, 146, '#c98f74'), (345, 165, '#b47a62'),
         (372, 230, '#a86e58'), (376, 330, '#a0644f'), (368, 430, '#98604e'),
         (384, 520, '#a86e58'), (440, 600, '#b47a62'), (530, 660, '#b47a62'),
         (600, 720, '#b47a62'), (640, 820, '#a86e58')]
SILHOUETTE = BREAST + CHIN + LOWER_LIP + UPPER_LIP + NOSE + FOREHEAD + SKULL


# The background ---------------------------------------------------------------------------------


def background():
    x, y = SUN
    lines = ['<defs>',
             f'  <radialGradient id="dusk" gradientUnits="userSpaceOnUse" cx="{x}" cy="{y}" '
             'r="560">',
             '    <stop offset=".38" stop-color="#2f7078"/><stop offset=".62" '
             'stop-color="#16424f"/>',
             '    <stop offset="1" stop-color="#0a1c2c"/></radialGradient>',
             f'  <radialGradient id="sun" gradientUnits="userSpaceOnUse" cx="{x}" cy="{y}" '
             f'r="{SUN_RADIUS}" fx="{x - 90}" fy="{y + 40}">',
             '    <stop offset="0" stop-color="#fff4d2"/><stop offset=".55" '
             'stop-color="#fbd58a"/>',
             '    <stop offset="1" stop-color="#ee9a4b"/></radialGradient>', '</defs>']
    disc = element('circle', cx=x, cy=y, r=SUN_RADIUS, sf_left='url(#dusk)', sf_right='url(#sun)',
                   fill='url(#sun)', stroke='url(#dusk)')
    return lines + layer('sun-and-dusk', [disc])


def rays():
    """Wedges of light around the sun, fading outwards."""
    wedges = []
    count = 36
    for i in range(count):
        angle = math.tau * (i + .5) / count
        reach = 560 if i % 2 else 430
        near, far = (SUN_RADIUS + 14) * .999, reach
        points = [(SUN[0] + r * math.cos(angle + a), SUN[1] + r * math.sin(angle + a))
                  for r, a in ((near, -.012), (far, -.034), (far, .034), (near, .012))]
        data = 'M' + 'L'.join(f'{number(px)} {number(py)}' for px, py in points) + 'Z'
        wedges.append(curve(data, sf_left='#7cc0a8', sf_right='#7cc0a8', sf_left_opacity=0,
                            sf_right_opacity='.6, 0 47%, 0 53%, .6', fill='#7cc0a8',
                            fill_opacity='.3'))
    return layer('rays', wedges)


def ring(radius, width, alpha):
    """A thin golden circle: a local curve."""
    return element('circle', cx=SUN[0], cy=SUN[1], r=radius, fill='none', stroke='#f0c070',
                   sf_left='#ffe6a8, #b87a34 30%, #ffe6a8 55%, #a86a2c 80%, #ffe6a8',
                   sf_radius=width, sf_alpha=alpha)


# The face ---------------------------------------------------------------------------------------


def silhouette():
    return smooth_chain([(x, y) for x, y, _ in SILHOUETTE])


def at_points(colours):
    """A stop list that gives each point of an outline its colour."""
    return ', '.join(f'{colour} @{i}' for i, colour in enumerate(colours))


def skin():
    outline = curve(path_data(silhouette(), True), sf_left='#f2c6a6',
                    sf_right=at_points(colour for _, _, colour in SILHOUETTE),
                    sf_left_opacity=0, sf_right_opacity=1, fill='#f0c0a0')
    jaw = curve(path([(248, 468), (272, 457), (296, 438), (314, 410), (322, 372)]),
                sf_left='#c08470, #e4ad90 25%, #dfa487 60%, #cf9074',
                sf_right='#b07260, #9c5c4c 40%, #a2614f',
                sf_blur='1, 10 30%, 14', fill='none', stroke='#9c5c4a')
    return layer('skin', [outline, jaw])


def soft(name, points, colour, opacity, blur):
    """A breath of colour: a closed curve that fades on both sides."""
    return layer(name, [curve(path_data(clockwise(smooth_chain(points + points[:1])), True),
                              sf_left=colour, sf_right=colour, sf_left_opacity=0,
                              sf_right_opacity=opacity, sf_blur=blur, fill=colour,
                              fill_opacity='.3')])


def blush():
    cheek = [(224, 344), (250, 322), (284, 318), (292, 340), (264, 366), (236, 368)]
    lid = [(213, 288), (222, 276), (240, 272), (256, 276), (250, 290), (232, 299)]
    nose = [(178, 348), (190, 340), (200, 346), (196, 356), (184, 354)]
    return (soft('cheek', cheek, '#e0604e', '.5', 24) + soft('lid', lid, '#3f7f86', '.75', 7)
            + soft('nose', nose, '#d98468', '.35', 6))


def lips():
    pieces = silhouette()
    first = len(BREAST + CHIN) - 1
    front = pieces[first:first + 5]
    corner = (226, 389)
    parting, crown = front[2][3], front[-1][3]
    lower = front[:3] + smooth_chain([parting, (206, 392), (219, 390), corner])
    lower += smooth_chain([corner, (220, 402), (209, 412), front[0][0]])
    upper = front[3:] + smooth_chain([crown, (197, 372), (213, 380), corner])
    upper += smooth_chain([corner, (219, 390), (206, 392), parting])
    return layer('upper-lip', [
        curve(path_data(upper, True), sf_left='#a8323c', sf_left_opacity=0, sf_right_opacity=1,
              sf_right='#b02c3a, #bd4048 25%, #9c2734 60%, #6e1626 85%, #7e1a2a', sf_blur='.6',
              fill='#a8323c')]) + layer('lower-lip', [
        curve(path_data(lower, True), sf_left='#c2464a', sf_left_opacity=0, sf_right_opacity=1,
              sf_right='#b53a42, #dd6064 12%, #a02a36 28%, #93202f 55%, #b83a44 80%, #b53a42',
              sf_blur='.6', fill='#c2464a'),
        curve('M196 400C202 403 209 403 215 399', sf_left='#dd6468, #d4565c', sf_blur=3,
              sf_right='#cf4a52, #c8444c', fill='none', stroke='#dd6468')])


def eye():
    """Closed: the line of the lashes, the crease above, the brow."""
    line = smooth_chain([(210, 290), (220, 298), (235, 300), (250, 294), (262, 284)])
    line += smooth_chain([(262, 284), (249, 290), (235, 294), (221, 293), (210, 290)])
    brow = smooth_chain([(206, 259), (220, 248), (244, 242), (264, 246), (284, 258)])
    brow += smooth_chain([(284, 258), (263, 251), (244, 248), (222, 255), (206, 259)])
    lines = layer('lash-line', [dark_shape(line, '#2a1018')])
    lines += layer('brow', [dark_shape(brow, '#5a2418')])
    lashes = [((212, 292), (206, 300), (197, 303)), ((217, 296), (211, 305), (202, 310)),
              ((223, 299), (218, 309), (210, 316)), ((230, 300), (227, 311), (220, 319)),
              ((238, 299), (238, 310), (233, 319)), ((246, 296), (248, 306), (246, 315))]
    strokes = [stroke(path(list(lash)), '#2a1018', '1.7, 1.2 50%, .4', 1) for lash in lashes]
    strokes.append(stroke('M214 280C224 270 244 266 262 273', '#8a4a44', '.8, 2.4 40%, .6', .7))
    strokes.append(stroke('M198 355C206 357 211 350 208 340', '#b06650', '.8, 2.4 40%, .8', .7))
    strokes.append(stroke('M185 356C189 352 194 352 197 356', '#7a3a34', '1, 2 50%, 1', .8))
    return lines + group('lashes', strokes)


def dark_shape(chain, colour):
    return curve(path_data(clockwise(chain), True), sf_left=colour, sf_right=colour,
                 sf_left_opacity=0, sf_right_opacity=1, fill=colour)


def stroke(data, colour, radius, alpha):
    """A local curve."""
    return curve(data, sf_left=colour, sf_right=colour, sf_radius=radius, sf_alpha=alpha,
                 fill='none', stroke=colour)


# The hair ---------------------------------------------------------------------------------------

HAIR = [rgb(colour) for colour in ('#240a12', '#5a1a18', '#98391c', '#d3702c', '#f6b458',
                                   '#ffe0a0')]


def resample(points, count):
    """count + 1 points of the smooth chain through points, evenly spaced along it."""
    dense = []
    for a, b, c, d in smooth_chain(points):
        for i in range(24):
            t = i / 24
            w = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
            dense.append(tuple(sum(w[k] * p[axis] for k, p in enumerate((a, b, c, d)))
                               for axis in range(2)))
    dense.append(points[-1])
    reached = [0]
    for p, q in zip(dense, dense[1:]):
        reached.append(reached[-1] + math.dist(p, q))
    result, k = [], 0
    for i in range(count + 1):
        wanted = reached[-1] * i / count
        while k < len(reached) - 2 and reached[k + 1] < wanted:
            k += 1
        result.append(mix(dense[k], dense[k + 1],
                          (wanted - reached[k]) / (reached[k + 1] - reached[k])))
    return result


class Lock:
    """Hair between two edges, from the same root to the same tip.

    near, far: points of the edges; going to the tip, far is on the left. gloss: where along the
    lock it shines (share, width, strength); shade: how much darker it is as a whole.
    """

    STEPS = 12

    def __init__(self, name, far, near, strands, gloss, shade=0):
        self.name, self.strands, self.gloss, self.shade = name, strands, gloss, shade
        self.far, self.near = resample(far, self.STEPS), resample(near, self.STEPS)

    def at(self, s, across):
        """across: 0 is the far edge, 1 the near one."""
        position = min(self.STEPS - 1e-6, s * self.STEPS)
        i, t = int(position), position % 1
        return mix(mix(self.far[i], self.far[i + 1], t), mix(self.near[i], self.near[i + 1], t),
                   across)

    def light(self, s, across):
        shine = sum(strength * math.exp(-((s - at) / width) ** 2)
                    for at, width, strength in self.gloss)
        return .30 + shine * (1 - .5 * abs(2 * across - .8)) - self.shade - .12 * across

    def colour(self, s, across, change=0):
        return css(ramp(HAIR, self.light(s, across) + change))

    def outline(self):
        edges = smooth_chain(self.far) + smooth_chain(self.near[::-1])
        shares = (0, .2, .4, .6, .8, 1)
        colours = [self.colour(s, 0, -.1) for s in shares] + [
            self.colour(s, 1, -.16) for s in shares[-2::-1]]
        return curve(path_data(edges, True), sf_left=stops(colours), sf_right=stops(colours),
                     sf_left_opacity=0, sf_right_opacity=1, fill=self.colour(.5, .5))

    def strand(self, chance, across):
        start, end = chance.uniform(.02, .08), chance.uniform(.86, .98)
        shares = [start + (end - start) * i / 9 for i in range(10)]
        drift = chance.uniform(-.25, .25) / self.strands
        points = [self.at(s, across + drift * math.sin(5 * s)) for s in shares]
        depth = chance.uniform(.05, .16)
        fade = [math.sin(math.pi * i / 9) ** .5 for i in range(10)]
        lit, dim = ([self.colour(s, across, sign * depth * f - .13 * (1 - f))
                     for s, f in zip(shares, fade)] for sign in (1, -1))
        return curve(path(points), sf_left=stops(lit), sf_right=stops(dim),
                     sf_right_blur='2, 5 50%, 2', fill='none', stroke=lit[4])

    def layers(self, chance):
        count = self.strands
        strands = [self.strand(chance, .05 + .9 * (k + .5 + chance.uniform(-.22, .22)) / count)
                   for k in range(count)]
        return self.shadow() + layer(self.name, [self.outline()] + strands)

    def shadow(self):
        edges = [(x + 3, y + 9) for x, y in self.far + self.near[::-1]]
        return layer(self.name + '-shadow', [curve(
            path(edges, True), sf_left='#2a0a18', sf_right='#2a0a18', sf_left_opacity=0,
            sf_right_opacity='0, .55 20%, 0 45%, 0 55%, .55 80%, 0', sf_blur='4, 14 50%, 4',
            fill='#2a0a18', fill_opacity='.3')], ' style="mix-blend-mode:multiply"')


def cap():
    """The dark below all locks."""
    points = [(216, 196), (240, 158), (290, 134), (345, 148), (392, 216), (402, 330), (396, 430),
              (410, 520), (350, 520), (322, 440), (318, 372), (304, 310), (288, 264), (258, 222),
              (216, 196)]
    return layer('cap', [dark_shape(smooth_chain(points), '#3a0f14')])


LOCKS = [
    Lock('nape', [(344, 360), (386, 440), (450, 520), (520, 590), (580, 640), (650, 660)],
         [(344, 360), (340, 480), (366, 590), (420, 680), (500, 740), (650, 790)], 14,
         [(.35, .2, .3), (.75, .15, .3)], .06),
    Lock('veil', [(300, 128), (390, 140), (439, 214), (473, 280), (518, 300), (557, 268)],
         [(300, 128), (350, 260), (384, 370), (439, 440), (507, 400), (557, 268)], 12,
         [(.55, .12, .3)], .16),
    Lock('down', [(330, 200), (386, 270), (404, 340), (428, 410), (466, 460), (511, 474),
                  (542, 458), (561, 420)],
         [(330, 200), (318, 300), (330, 380), (348, 460), (392, 526), (452, 556), (525, 524),
          (561, 420)], 16, [(.3, .14, .35), (.66, .12, .45)], .04),
    Lock('middle', [(222, 192), (262, 172), (310, 174), (358, 206), (394, 262), (435, 322),
                    (482, 346), (530, 328), (561, 284)],
         [(222, 192), (262, 205), (300, 232), (326, 275), (352, 330), (402, 392), (464, 412),
          (525, 374), (561, 284)], 18, [(.3, .12, .5), (.68, .12, .5)], .02),
    Lock('crown', [(215, 197), (230, 154), (272, 120), (335, 110), (395, 136), (439, 192),
                   (482, 226), (526, 216), (561, 170)],
         [(215, 197), (245, 184), (295, 176), (345, 196), (390, 248), (433, 286), (482, 292),
          (528, 256), (561, 170)], 20, [(.32, .12, .6), (.7, .12, .55)]),
    Lock('front', [(220, 190), (268, 200), (310, 242), (340, 310), (354, 390), (376, 470),
                   (402, 550), (396, 630), (350, 712)],
         [(220, 190), (256, 222), (284, 264), (300, 310), (314, 372), (318, 440), (332, 520),
          (350, 600), (350, 712)], 16, [(.2, .1, .5), (.55, .12, .45), (.85, .08, .35)]),
]


def stray_hairs():
    """Single hairs that the wind has taken: local curves."""
    hairs = [[(312, 122), (400, 114), (436, 140), (470, 190), (525, 186)],
             [(388, 146), (448, 190), (497, 198)], [(464, 300), (507, 318), (547, 268)],
             [(430, 350), (490, 372), (544, 330)], [(410, 430), (464, 492), (525, 500), (552, 476)],
             [(372, 470), (392, 560), (384, 650)], [(318, 440), (324, 540), (340, 620)],
             [(222, 198), (238, 226), (262, 250), (276, 290)]]
    return group('stray-hairs', [stroke(path(hair), '#b5521f', '.3, 1.1 40%, .3', .9)
                                 for hair in hairs])


# Her clothes ------------------------------------------------------------------------------------

NECKLINE = [(86, 690), (130, 692), (190, 706), (254, 706), (320, 690), (400, 662), (500, 626),
            (620, 580)]


def gown():
    outline = smooth_chain(NECKLINE + [(660, 700), (660, 840), (-20, 840), (26, 780), (58, 718),
                                       NECKLINE[0]])
    folds = []
    for x, tilt in ((110, -18), (170, -10), (240, 0), (310, 8)):
        top = 706 if 150 < x < 280 else 696
        folds.append(curve(path([(x, top), (x + .4 * tilt, top + 30), (x + tilt, 800)]),
                           sf_left='#2b8f86, #14605f', sf_right='#16605e, #0d4a4c 30%, #0a3238',
                           fill='none', sf_left_blur=2, sf_right_blur=14, stroke='#2b8f86'))
    body = curve(path_data(clockwise(outline), True), sf_left='#14605f',
                 sf_right='#1c7a74, #1a706c 20%, #0f4548 45%, #0a2a32 70%, #14605f',
                 sf_left_opacity=0, sf_right_opacity=1, fill='#14605f')
    trim = curve(path(NECKLINE), sf_left='#ffe6a8, #b87a34 30%, #ffe6a8 45%, #8a5424 70%',
                 sf_right='#e0a850, #8a5424 30%, #e0a850 45%, #6a3c1a 70%',
                 sf_radius='1, 4.5 6%, 4.5', sf_alpha='1.2', fill='none', stroke='#f0c070')
    return layer('gown', [body] + folds) + [trim]


def earring():
    """A drop of jade on a golden thread."""
    thread = curve('M310 366L306 396', sf_left='#ffe6a8', sf_right='#b87a34', sf_radius=1.6,
                   fill='none', stroke='#f0c070')
    drop = smooth_chain([(306, 394), (313, 410), (315, 424), (306, 434), (297, 424), (299, 410),
                         (306, 394)])
    jade = layer('jade', [
        curve(path_data(clockwise(drop), True), sf_left='#0d4a4c', sf_left_opacity=0,
              sf_right_opacity=1, fill='#1f8a7c', sf_blur='.5',
              sf_right='#4fc0a4, #1f8a7c 25%, #0b4a4a 45%, #3fae92 65%, #9fe8cc 85%, #4fc0a4')])
    shadow = soft('earring-shadow', [(312, 400), (322, 418), (318, 440), (306, 442), (302, 420)],
                  '#5a2420', '.5', 8)
    glint = stroke('M302 412C301 417 301 421 303 425', '#f4fff8', '.8, 2.2 40%, .6', 1)
    return shadow + group('earring', [thread, *jade, glint])


def blossoms():
    """One petal, five times a blossom, three blossoms: solved once."""
    petal = smooth_chain([(0, -3), (-9, -11), (-10, -22), (-4, -28), (0, -26), (4, -28), (10, -22),
                          (9, -11), (0, -3)])
    lines = ['<defs>'] + ['  ' + line for line in layer('petal', [
        curve(path_data(clockwise(petal), True), sf_left='#c98a70', sf_left_opacity=0,
              sf_right_opacity=1, sf_blur='.4', fill='#fff4e0',
              sf_right='#d9785c, #fbdcc0 25%, #fffaf0 50%, #fff0dc 75%, #d9785c'),
        curve('M0 -6C1 -12 0 -17 -1 -21', sf_left='#c8553f, #fbe0cc', sf_right='#e59a80, #fff0e0',
              sf_blur='1, 4', fill='none', stroke='#e59a80')])]
    lines += ['  ' + line for line in layer('stamens', [
        element('circle', cx=0, cy=0, r=5, sf_left='#8a4a1c', sf_left_opacity=0,
                sf_right_opacity=1, sf_right='#8a4a1c, #c9822c 50%, #ffd870 70%, #8a4a1c',
                sf_blur='.8', fill='#e0a030')])]
    turns = ''.join(f'<use xlink:href="#petal" transform="rotate({72 * i})"/>' for i in range(5))
    lines += [f'  <g id="blossom">{turns}<use xlink:href="#stamens"/></g>', '</defs>']
    places = ((336, 246, 20, 1.05), (318, 292, -14, 1.3), (338, 338, 34, .95))
    return lines + group('blossoms', [
        f'<use xlink:href="#blossom" transform="translate({x} {y}) rotate({turn}) scale({scale})"/>'
        for x, y, turn, scale in places])


def frame():
    """A dark border with two golden lines."""
    inset = 20
    border = element('rect', x=inset, y=inset, width=WIDTH - 2 * inset, height=HEIGHT - 2 * inset,
                     sf_left='#0a1826', sf_right='#0a1826', sf_left_opacity=1, sf_right_opacity=0,
                     fill='none', stroke='#0a1826')
    lines = []
    for distance, radius in ((inset, 3), (inset - 7, 1.4)):
        lines.append(element('rect', x=distance, y=distance, width=WIDTH - 2 * distance,
                             height=HEIGHT - 2 * distance, fill='none', stroke='#f0c070',
                             sf_left='#ffe6a8, #a86a2c 25%, #ffe6a8 50%, #a86a2c 75%, #ffe6a8',
                             sf_radius=radius))
    return layer('border', [border]) + group('border-lines', lines)


def main():
    chance = random.Random(11)
    lines = background() + rays()
    lines += group('rings', [ring(SUN_RADIUS + 6, 3, 1), ring(SUN_RADIUS + 14, 1.6, .8)])
    *behind, front = LOCKS
    lines += behind[0].layers(chance) + skin() + blush() + lips() + eye() + gown() + cap()
    for lock in behind[1:]:
        lines += lock.layers(chance)
    lines += earring() + front.layers(chance) + stray_hairs() + blossoms() + frame()
    print(document(WIDTH, HEIGHT, 'A woman before the setting sun', [
        'Drawn by make_portrait.py. Strands of hair are open curves with a light side and a dark',
        'one; locks, lips and lashes are layers whose outlines bear opacity; thin golden lines and',
        'stray hairs are local curves.'], '#16424f', lines))


if __name__ == '__main__':
    main()
