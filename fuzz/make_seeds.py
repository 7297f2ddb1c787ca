#!/usr/bin/env python3
"""Draws the first inputs of the fuzz targets: python3 fuzz/make_seeds.py FOLDER makes FOLDER/TARGET.

fuzz/corpus has the inputs that the fuzzers found since then; use this script to start again from
nothing.
"""

import gzip
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent

HEAD = ('<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
        'xmlns:sf="urn:sfumato:1" viewBox="0 0 64 64" sf:version="1"%s>%s</svg>')


def svg(content, attributes=''):
    return HEAD % (attributes, content)


def layer(content, attributes=''):
    return svg('<g sf:diffuse="true"%s>%s</g>' % (attributes, content))


TINY_PNG = ('iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAD0lEQVR4nGP4z8DwnwGMAAv7Av9JhQDaAAAA'
            'AElFTkSuQmCC')

PAINTS = ('<defs><linearGradient id="l" x1="0" y1="1" x2="1" y2="0" spreadMethod="reflect">'
          '<stop offset="0" stop-color="red"/><stop offset="50%" stop-color="#08f" '
          'stop-opacity=".5"/></linearGradient><radialGradient id="r" href="#l" cx=".3" r=".4" '
          'fx=".2" fy=".3" gradientTransform="rotate(20)"/><pattern id="p" '
          'patternUnits="userSpaceOnUse" width="8" height="4" patternTransform="scale(2)">'
          '<image href="data:image/png;base64,' + TINY_PNG + '" width="8" height="4" '
          'preserveAspectRatio="none"/></pattern></defs>')

DOCUMENTS = [
    layer('<path d="M8 32C20 8 40 56 56 32" sf:left="red,blue 50%,#0f0" sf:right="#fff @0,#000 @1"/>'),
    layer('<circle cx="32" cy="32" r="20" sf:left="gold" sf:right="navy" sf:blur="0,5 50%,0"/>'
          '<line x1="2" y1="9" x2="60" y2="50" sf:left="none" sf:right="hsl(20 80% 50%)" '
          'sf:weight="2"/>'),
    layer('<rect x="4" y="5" width="30" height="20" rx="3" sf:left="#123" sf:opacity="1,0"/>'
          '<ellipse cx="40" cy="40" rx="9" ry="5" sf:right-opacity=".3" sf:left-opacity="none"/>'
          '<polygon points="1,2 30,4 20,40" sf:right="rgb(20% 30% 40%)"/>'
          '<polyline points="50 50 60 10" sf:left-blur="3" sf:left="tan" sf:right="red"/>'),
    svg('<path d="M5 5q20 0 20 20t10 5" sf:radius="3,9 50%,1" sf:left="#abc" sf:alpha=".7"/>'
        '<path d="M5 60L60 5" sf:radius="4" sf:right="red" sf:blur="1" opacity=".4"/>'),
    svg('<defs><g id="a" sf:diffuse="true"><path d="M0 0L9 9" sf:left="red" sf:right="blue"/></g>'
        '<symbol id="s" viewBox="0 0 4 4"><use xlink:href="#a"/></symbol></defs>'
        '<use href="#a" transform="translate(9 3) rotate(30)" opacity=".5"/>'
        '<g opacity=".6" style="mix-blend-mode:multiply"><use href="#s" x="3" y="4" width="20" '
        'height="20"/></g>'),
    svg(PAINTS + '<g sf:diffuse="true"><path d="M9 9C30 20 30 40 9 60" sf:left="url(#l)" '
        'sf:right="url(#p)" sf:opacity="url(#r)"/></g>'),
    svg('<style>.a{opacity:.5} #b,path{display:inline;fill:red}/*c*/ *{visibility:visible}</style>'
        '<rect width="64" height="64" fill="#eee"/><g id="b" class="a" sf:diffuse="true">'
        '<path style="visibility:visible" d="M1 1h40v40z" sf:left="red"/></g>',
        ' sf:interpolation="oklab" sf:background="none"'),
    svg('<g transform="matrix(1 .2 -.3 1 4 5) skewX(9)" style="isolation:isolate">'
        '<g sf:diffuse="true"><g transform="scale(-1 2)"><path id="x" d="M1 2a9 5 30 1 0 20 9" '
        'sf:left="red"/><use href="#x" y="9"/></g></g></g><text>no</text>'),
    '<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY a "b">]><!-- c --><s:svg '
    'xmlns:s="http://www.w3.org/2000/svg" xmlns:f="urn:sfumato:1" width="2in" height="5cm" '
    'f:version="1"><s:g f:diffuse="true"><s:path d="M1,1 2,3" f:left="red"/></s:g></s:svg>',
]

ICONS = [
    svg('<title>i</title><rect x="8" y="8" width="48" height="48" rx="9" fill="#246"/>'
        '<path d="M20 32L30 42L46 22" fill="none" stroke="#fff" stroke-width="5" '
        'stroke-linecap="round" stroke-linejoin="round"/>'),
    svg('<path fill-rule="evenodd" d="M5 5h50v50h-50zM15 15h30v30h-30zM30 0L60 60L0 20L60 20L0 60z" '
        'fill="red" stroke="#0008" stroke-width="3" stroke-dasharray="5 2 1" '
        'stroke-dashoffset="-3" stroke-linejoin="bevel" stroke-linecap="square"/>'),
    svg('<linearGradient id="a"><stop stop-color="red" stop-opacity=".3"/><stop offset="1"/>'
        '</linearGradient><radialGradient id="b" href="#a" fx=".2" spreadMethod="reflect"/>'
        '<g opacity=".5" style="mix-blend-mode:screen"><circle cx="20" cy="20" r="15" '
        'fill="url(#a)"/><circle cx="30" cy="25" r="15" fill="url(#b)" stroke="url(#a)" '
        'stroke-width="4" stroke-miterlimit="1"/></g>', ' width="100" height="20" '
        'preserveAspectRatio="none"'),
    svg('<symbol id="s" viewBox="0 0 4 4"><path d="M0 0C9 9-5 9 4 0Q2 2 0 4A3 2 20 1 0 4 4z"/>'
        '</symbol><use href="#s" width="40" height="30" fill="gold"/><use href="#s" x="9" y="20" '
        'width="30" height="40" style="fill:tan;stroke:navy;stroke-width:.1" '
        'transform="rotate(30) skewX(20)"/>'),
    '<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY s "fill:red;"><!ENTITY n '
    '"http://www.w3.org/2000/svg"><!ENTITY e "<g style=\'&s;\'>&#38;amp;<circle r=\'9\'/></g>">'
    '<!ENTITY x SYSTEM "y"><!ENTITY % p "q">%p;]><svg xmlns="&n;" viewBox="0 0 64 64">&e;&x;&e;'
    '<path style="&s;" d="M9 9h9v9z"/></svg>',
    svg('<switch fill="red"><foreignObject requiredExtensions="&a;"/><g systemLanguage="de"/>'
        '<g requiredFeatures="b" systemLanguage="fr, en-GB"><circle r="9"/></g><rect/></switch>'),
    '<svg xmlns="http://www.w3.org/2000/svg" width="100%"><rect width="-1" height="1"/><use '
    'href="#a"/><g id="a" transform="NaN"><use href="#a"/><circle cx="1e7" r="9"/><circle r="9" '
    'stroke="red" stroke-width="3"/></g><svg viewBox="0 0 9 9" width="auto"/></svg>',
    svg('<marker id="a" viewBox="0 0 2 1" refX="center" orient="auto-start-reverse" fill="context-stroke">'
        '<path id="b" d="M0 0L2 1" marker-end="url(#c)"/></marker><marker id="c" orient="40grad" '
        'markerUnits="userSpaceOnUse" markerWidth="9" preserveAspectRatio="none"><use href="#b"/></marker>'
        '<path d="M9 9L9 9C20 9 30 30 40 9zM5 5" style="marker:url(#a);paint-order:markers"/>'
        '<polyline points="1 1 9 9 20 1" stroke="red" marker-mid="url(#c)" marker-end="url(#d)"/>'),
    svg('<style>:root{--m:#1a8f5a;--n:var(--m)} .p > g [data-a^="b"]:not(:first-child), .p + rect '
        '{fill:var(--n);transform:rotate(30deg);transform-origin:50% 20px;transform-box:fill-box}'
        '</style><g class="p" font-size="120%"><g><path d="M0 0"/><circle data-a="bc" cx="2em" cy="5vh" '
        'r="1ex" stroke="var(--x, var(--m))" stroke-width=".2rem" vector-effect="non-scaling-stroke"/>'
        '</g></g><rect style="x:5px;y:2mm;width:50%;height:1in;--a:var(--b);--b:var(--a)"/>'),
    svg('<pattern id="p" width="8" height="4" patternUnits="userSpaceOnUse" patternTransform="rotate(20)">'
        '<circle r="3" fill="url(#q)"/><rect width="2" height="9" fill="#08f8"/></pattern><pattern id="q" '
        'width=".5" height=".5" viewBox="0 0 2 2" preserveAspectRatio="none"><path d="M0 0H1V1z" '
        'fill="url(#p)"/></pattern><pattern id="o" href="#p" width="3" patternContentUnits="objectBoundingBox"'
        '/><rect width="30" height="20" fill="url(#p)"/><circle r="9" fill="url(#o)" stroke="url(#q)"/>'),
    svg('<image width="20" height="9" opacity=".5" href="data:image/png;base64,' + TINY_PNG + '"/><svg '
        'x="30" viewBox="0 0 2 1" preserveAspectRatio="xMaxYMin slice"><image id="i" width="auto" '
        'preserveAspectRatio="xMinYMid slice" transform="rotate(9)" href="data:image/png;base64,'
        + TINY_PNG + '"/></svg><use href="#i" y="30"/><image href="missing.png"/>'),
    svg('<clipPath id="c" clip-path="url(#d)"><circle cx="20" cy="20" r="15"/><path clip-rule="evenodd" '
        'd="M9 9H50V50H9zM20 20H30V30H20z"/><use href="#e"/></clipPath><clipPath id="d" '
        'clipPathUnits="objectBoundingBox"><rect id="e" width=".7" height="1"/></clipPath><g '
        'clip-path="url(#c)"><path d="M0 0H60V60z" style="clip-path:url(#d)" stroke="red"/></g><symbol '
        'id="s" viewBox="0 0 4 4" clip-path="url(#c)"><circle r="4"/></symbol><use href="#s" width="9"/>'),
    svg('<filter id="f"><feGaussianBlur in="SourceGraphic" stdDeviation="2 2"/></filter><filter id="g" '
        'primitiveUnits="objectBoundingBox"><feGaussianBlur stdDeviation=".1"/><feOffset/></filter><rect '
        'width="30" height="20" filter="url(#f)" fill="#c43"/><circle r="9" style="filter:blur(2px)" '
        'fill="none" stroke="navy"/><path d="M0 0H9V9z" filter="url(#g)"/>'),
    svg('<style>@media screen{svg &gt; .a ~ [d$="z" i],#b:not(.a):first-child{fill:color(display-p3 0 1 0)}}'
        '*{stroke:oklch(60% .2 none/.5)!important}</style><g id="b" class="a"/><path class="a" d="M0 0z"/>'
        '<path d="M9 9H40V30z" fill="lab(50 40 -60/50%)"/><g fill="hwb(1turn 20% 30%)"><path d="M1 1H9V9z" '
        'color="#f80c" stroke="currentColor" paint-order="stroke"/></g><rect width="9" height="9" '
        'fill="color(xyz-d50 .1 .2 .3)"/><rect width="5" height="5" fill="oklab(2 -9 1e9)"/>'),
    svg('<linearGradient id="f"><stop stop-color="#fff"/><stop offset="1" stop-opacity="0"/></linearGradient>'
        '<mask id="m" maskUnits="userSpaceOnUse" x="4" y="5%" width="50" height="40" mask="url(#n)">'
        '<rect width="64" height="64" fill="url(#f)"/></mask><mask id="n" mask-type="alpha" '
        'maskContentUnits="objectBoundingBox"><rect width=".7" height="1"/><circle cx=".5" cy=".5" r=".3" '
        'fill="red" opacity=".5"/></mask><g mask="url(#m)" opacity=".5"><circle cx="20" cy="20" r="15" '
        'stroke="tan" stroke-width="3"/><rect x="9" y="9" width="30" height="9" fill="url(#f)" '
        'mask="url(#n)"/></g><mask id="o" color-interpolation="linearRGB"><path d="M0 0H64V64z" fill="#fff"/>'
        '<path d="M9 9H40" stroke="#000" stroke-width="5" mask="url(#o)"/></mask><path d="M0 0H60V60z" '
        'mask="url(#o)"/>'),
    svg('<clipPath id="c" style="clip-path:inset(5% 2px round 9px / 4px 20%)"><circle cx="20" cy="20" r="15" '
        'clip-path="polygon(evenodd, 0 0, 100% 0, 50% 99px, 9px 3px)"/><use href="#r"/></clipPath>'
        '<g clip-path="url(#c)"><rect id="r" x="9" y="9" width="40" height="30" stroke="red" '
        'style="clip-path:circle(farthest-side at right 9px top 20%) stroke-box"/></g>'
        '<path d="M9 9H50V40z" style="clip-path:path(\'M0 0H20V20z\') view-box"/><ellipse rx="20" ry="9" '
        'clip-path="xywh(1 2 30 9 round 3) fill-box"/>'),
]

CURVE_SETS = [
    '<curve_set image_width="64" image_height="48" nb_curves="1"><curve nb_control_points="4">'
    '<control_points_set><control_point x="1" y="2"/><control_point x="9" y="20"/>'
    '<control_point x="30" y="4"/><control_point x="40" y="44"/></control_points_set>'
    '<left_colors_set><left_color R="1" G="255" B="33.5" globalID="0"/>'
    '<left_color R="100" G="5" B="3" globalID="7"/></left_colors_set>'
    '<right_colors_set boundary="Neumann"/>'
    '<blur_points_set><best_scale value="2" globalID="3"/></blur_points_set>'
    '<weight_set><weight w="2"/></weight_set></curve></curve_set>',
    '<scene image_width="9" image_height="8"><curve_set><curve><control_points_set>'
    + '<control_point x="1e1" y="-2"/>' * 7 +
    '</control_points_set><right_colors_set><right_color R="0" G="0" B="0" globalID="12"/>'
    '</right_colors_set></curve></curve_set><other/></scene>',
]

STOP_LISTS = ['red', 'red, gold', 'red, gold 30%, white', 'red 50%, blue 50%',
              'red @0, gold @2.5, white @4', '0, 12 50%, 0', '#abc 10%,#aabbcc,hsl(20deg 80% 50%)',
              'rgb(1 2 3/1) 1e1%,rgb(10%,20%,30%)', '.5,1e-3 @1.25,.7 99%', 'hwb(1turn 2% 3%)',
              'oklch(70% .15 250deg), lab(50 40 -60) 20%, color(display-p3 0 1 0)']

OPTION_STRINGS = [
    (0, 'threads=2 max-memory=1000 max-time=off limit.curves=9'), (0, 'simd=avx2 limit.nodes=1e9'),
    (1, 'artboard=0,0,400,300 interpolation=oklab background="rgb(1 2 3)"'),
    (2, 'viewport=-1,2,3e2,4.5 width=12 height=30 detail=2 method=rays rays=64 seed=7 no-blur'),
    (2, 'scale=0.5 tolerance=0.02 ends=paper max-error=0 max-area=1% min-angle=33 order=linear'),
    (3, 'background=none dither no-antialias mesh-overlay'), (3, 'dither no-dither'),
    (4, 'depth=16 quality=90 lossless'), (4, 'dpi=72 svg=vector force pdf-flatten=never'),
    (4, 'title="a \\"b\\" \\\\ c"'), (5, 'quality=101'), (5, 'lossless=yes'), (6, 'max-error'),
    (6, 'width=0 hieght=3'), (2, 'width="1'), (2, ' =1'), (2, 'width=1 width=2'), (0, ''),
]

PATHS = ['M1 2L3 4', 'm1,2 3-4.5.6z', 'M0 0H9V9h-3v-3Z', 'M1 1C2 3 4 5 6 7S1 2 3 4',
         'M1 1Q2 3 4 5T6 7t1 1', 'M1 1A9 5 30 1 0 20 9a1 1 0 0110,5', 'none', 'M1 1 2 2 3 3zm4 4l1 1',
         'M-1e2+3L1e-7.5', 'matrix(1 2 3 4 5 6)', 'translate(3) rotate(30, 4 5),scale(2)',
         'skewX(9)skewY(8) scale(1 -1)']

SHEETS = ['path{fill:red;opacity:.5}', '.a, #a , *{display:none !important}/*c*/',
          '@media x{path{fill:red}} @import "a";.a{opacity:1}', '<!-- *{fill:"a;b"} -->',
          'path{fill:url(a;b)}.a{fill:}', '.a > b + c ~ d e[f|="g" i]:not(.h):root{--x:y;fill:var(--x,var(--z))}',
          'rebeccapurple', '#abcd', '#aabbccdd', 'rgb(1,2,3,.4)',
          'hsla(20deg,30%,40%,.5)', 'hwb(.5turn 10% 20%/30%)', 'rgb(1e2% 0 none)',
          'oklch(.9 .4 150 / 50%)', 'lab(50% 32% -48%)', 'lch(60 60 none)', 'oklab(.5 .1 -.1)',
          'color(a98-rgb .2 60% .3)', 'color(prophoto-rgb 0 0 1)', 'color(xyz-d50 .3 .4 .2)']


def chunk(name, data):
    body = name + data
    return struct.pack('>I', len(data)) + body + struct.pack('>I', zlib.crc32(body))


def png(depth, kind, interlaced=0, extra=b''):
    """Returns a picture of 5 x 3 pixels; 9 x 9 if interlaced."""
    width, height = (9, 9) if interlaced else (5, 3)
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[kind]
    header = struct.pack('>IIBBBBB', width, height, depth, kind, 0, 0, interlaced)
    passes = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2),
              (0, 1, 1, 2)] if interlaced else [(0, 0, 1, 1)]
    rows = b''
    for x, y, step_x, step_y in passes:
        columns = len(range(x, width, step_x))
        for row in range(y, height, step_y) if columns else ():
            rows += bytes([row % 5]) + bytes(
                (37 * i + row) % 256
                for i in range((columns * channels * depth + 7) // 8))
    if kind == 3:
        extra = chunk(b'PLTE', bytes(7 * i % 256 for i in range(3 << depth))) + extra
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + extra +
            chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b''))


def pngs():
    for depth, kind in [(1, 0), (2, 0), (4, 0), (8, 0), (16, 0), (8, 2), (16, 2), (1, 3), (2, 3),
                        (4, 3), (8, 3), (8, 4), (16, 4), (8, 6), (16, 6)]:
        yield png(depth, kind)
        yield png(depth, kind, 1)
    yield png(8, 3, 0, chunk(b'tRNS', b'\0\x80\xff'))
    yield png(8, 2, 0, chunk(b'tRNS', b'\0\1\0\2\0\3') + chunk(b'gAMA', b'\0\0\xb1\x8f'))
    yield png(16, 0, 0, chunk(b'tRNS', b'\0\1') + chunk(b'sRGB', b'\0') +
              chunk(b'tEXt', b'Title\0a') + chunk(b'pHYs', b'\0\0\0\1\0\0\0\1\1'))
    rows = bytes(random.Random(1).randrange(256) for _ in range(60))
    for depth in range(5):
        for kind in range(5):
            yield bytes([5, 3, depth, kind, 0, 9, 2]) + rows


def jpegs():
    """Uses netpbm, if installed: baseline and progressive, gray and colour, full resolution and
    subsampled."""
    if not shutil.which('pnmtojpeg'):
        return
    pixels = bytes((i * i // 7) % 256 for i in range(17 * 9 * 3))
    for picture in (b'P6 17 9 255\n' + pixels, b'P5 17 9 255\n' + pixels[:17 * 9]):
        for flags in ([], ['-progressive'], ['-optimize', '-restart=2'], ['-quality=3'],
                      ['-arith'], ['-progressive', '-arith']):
            run = subprocess.run(['pnmtojpeg', *flags], input=picture, capture_output=True,
                                 check=False)
            if run.returncode == 0 and run.stdout:
                yield run.stdout


def icc(space, tags):
    """Returns a profile of version 4; tags of its colours by name."""
    table, content, at = struct.pack('>I', len(tags)), b'', 132 + 12 * len(tags)
    for name, data in tags:
        data += bytes(-len(data) % 4)
        table += name + struct.pack('>II', at + len(content), len(data))
        content += data
    size = at + len(content)
    white = struct.pack('>iii', 63190, 65536, 54061)
    header = (struct.pack('>I', size) + b'lcms' + b'\x04\x30\0\0' + b'mntr' + space + b'XYZ ' +
              bytes(12) + b'acsp' + bytes(28) + white + bytes(48))
    return header + table + content


def iccs():
    def xyz(x, y, z):
        return b'XYZ \0\0\0\0' + struct.pack('>iii', *(round(65536 * v) for v in (x, y, z)))

    gamma = b'curv\0\0\0\0' + struct.pack('>IH', 1, 563)
    table = b'curv\0\0\0\0' + struct.pack('>IHHHH', 4, 0, 9000, 30000, 65535)
    srgb = b'para\0\0\0\0\0\3\0\0' + struct.pack('>iiiii', 157286, 62119, 3417, 5072, 2651)
    primaries = [(b'rXYZ', xyz(.515, .241, -.001)), (b'gXYZ', xyz(.292, .692, .042)),
                 (b'bXYZ', xyz(.157, .067, .784)), (b'wtpt', xyz(.964, 1, .825))]
    for curve in (gamma, table, srgb):
        yield icc(b'RGB ', primaries + [(name, curve) for name in (b'rTRC', b'gTRC', b'bTRC')])
        yield icc(b'GRAY', [(b'wtpt', xyz(.964, 1, .825)), (b'kTRC', curve)])
    lut = (b'mft1\0\0\0\0\4\3\2\0' + struct.pack('>9i', *(65536 * (i % 4 == 0) for i in range(9))) +
           bytes(range(256)) * 4 + bytes(5 * i % 256 for i in range(48)) + bytes(range(256)) * 3)
    profile = icc(b'CMYK', [(b'A2B0', lut)])
    yield profile[:12] + b'prtr' + profile[16:20] + b'Lab ' + profile[24:]


def webps():
    """Uses libwebp's tool, if installed: lossy and lossless, with and without alpha."""
    if not shutil.which('cwebp'):
        return
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / 'a.png'
        for kind in (2, 6):
            path.write_bytes(png(8, kind))
            for flags in ([], ['-lossless'], ['-q', '5']):
                run = subprocess.run(['cwebp', '-quiet', *flags, path, '-o', '-'],
                                     capture_output=True, check=False)
                if run.returncode == 0 and run.stdout:
                    yield run.stdout


def photos():
    profiles = list(iccs())
    exif = b'II*\0\x08\0\0\0\1\0\x12\1\3\0\1\0\0\0\6\0\0\0\0\0\0\0'
    yield from (exif, b'Exif\0\0' + exif)
    for kind in range(8):
        yield from (bytes([kind]) + profile for profile in profiles)
    for profile in profiles[:2]:
        extra = (chunk(b'iCCP', b'n\0\0' + zlib.compress(profile, 9)) + chunk(b'eXIf', exif))
        yield from (png(8, kind, 0, extra) for kind in (0, 2, 3, 4, 6))
        yield from (png(16, kind, 0, extra) for kind in (0, 2, 4, 6))
    yield png(8, 2, 0, chunk(b'gAMA', struct.pack('>I', 90000)) +
              chunk(b'cHRM', struct.pack('>8I', 31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000)))

    def segment(marker, data):
        return b'\xff' + marker + struct.pack('>H', len(data) + 2) + data

    for file in jpegs():
        yield (file[:2] + segment(b'\xe1', b'Exif\0\0' + exif) +
               segment(b'\xe2', b'ICC_PROFILE\0\1\1' + profiles[0]) + file[2:])
    for file in webps():
        yield file
        header = struct.pack('<IBBBBBB', 0x28 | 0x10 * (b'ALPH' in file), 4, 0, 0, 2, 0, 0)
        chunks = b'WEBPVP8X' + struct.pack('<I', 10) + header
        for name, data in ((b'ICCP', profiles[0]), (None, file[12:]), (b'EXIF', exif)):
            chunks += name + struct.pack('<I', len(data)) + data if name else data
        if file[12:16] != b'VP8X':
            yield b'RIFF' + struct.pack('<I', len(chunks)) + chunks


def noise(seed, count, longest):
    numbers = random.Random(seed)
    for _ in range(count):
        yield bytes(numbers.randrange(256) for _ in range(numbers.randrange(8, longest)))


def traces():
    """Makes options, a size and a kind, then levels of cells: noise, and two or three colours."""
    numbers = random.Random(8)
    for kind in range(64):
        head = [numbers.randrange(256) for _ in range(4)] + [kind % 8, numbers.randrange(256),
                numbers.randrange(12, 48), numbers.randrange(12, 48), kind * 4 // 3 % 256]
        colors = [bytes(numbers.randrange(256) for _ in range(4)) for _ in range(3)]
        cells = [numbers.choice(colors) for _ in range(numbers.randrange(1, 60))]
        levels = bytes(numbers.randrange(256) for _ in range(200)) if kind % 3 == 0 else b''.join(cells)
        yield bytes(head) + levels


class PictureFile:
    """Returns bytes in the layout of docs/picture-file.md, without the checksum, which the target
    corrects."""

    def __init__(self):
        self.bytes = b'SFPICT\x1a\x01' + struct.pack('<IQQ', 0x01020304, 0, 0)

    def put(self, kinds, *numbers):
        self.bytes += struct.pack('<' + kinds, *numbers)

    def table(self, kind, numbers, columns=1):
        self.put('Q', len(numbers) // columns)
        self.bytes += bytes(-len(self.bytes) % 16) + struct.pack(f'<{len(numbers)}{kind}', *numbers)

    def text(self, text):
        self.put('Q', len(text))
        self.bytes += text

    def field(self, channels, triangles, paints):
        self.put('i', channels)
        nodes = 10 if channels > 0 else 0
        self.table('I', [i % nodes for i in range(10 * triangles)] if nodes else [])
        self.table('f', [i / (nodes * channels) for i in range(nodes * channels)])
        self.table('I', paints)

    def layer(self, order, triangles, soft_edges, paints, opacity):
        self.put('4dB', 0, 0, 8, 6, order)
        self.table('d', [0, 0, 8, 0, 8, 6, 0, 6], 2)
        corners = [0, 1, 2, 0, 2, 3][:3 * triangles]
        self.table('I', corners)
        self.table('B', [i % 2 for i in range(len(corners))])
        self.put('Q', soft_edges)
        for _ in range(soft_edges):
            self.put('II4df', 0, 5 if triangles > 1 else 0xffffffff, 0, 0.3, 0.2, 0, 1)
        self.field(3 + len(paints), triangles, paints)
        self.field(opacity, triangles, [])

    def stops(self, kinds, rows):
        self.put('BQ', 1, len(rows))
        for row in rows:
            self.put('d' + kinds, *row)

    def instance(self, layer, blend):
        self.put('BI6dfB', 0, layer, 1, 0, 0, 1, 0.5, 0.25, 0.75, blend)

    def stroke(self):
        self.put('B', 1)
        self.text(b'stroke')
        self.table('d', [1, 1, 3, 0, 5, 6, 7, 4], 2)
        self.stops('fff', [(0, 1, 0, 0), (1, 0, 0, 1)])
        self.stops('fff', [(0, 0, 1, 0)])
        self.stops('f', [(0, 0.5)])
        self.stops('f', [(0, 1), (1, 2)])
        self.put('d6d', 1, 1, 0, 0, 1, 0, 0)

    def gradient(self, radial):
        self.text(b'g')
        self.put('BB', 0, radial)
        self.put('5d' if radial else '4d', *([4, 3, 4, 3, 5] if radial else [0, 0, 8, 0]))
        self.put('B6dQ', radial, 1, 0, 0, 1, 0, 0, 2)
        self.put('d4fd4f', 0, 1, 0, 0, 1, 1, 0, 1, 0, 0.5)

    def texture(self):
        self.text(b't')
        self.put('Bii', 1, 2, 2)
        self.table('B', [255, 0, 0, 255, 0, 255, 0, 128] * 2)
        self.put('6dB2d', 1, 0, 0, 1, 0, 0, 1, 0, 0)
        self.table('B', [])


def pictures():
    """Makes picture files of few triangles: layers with paints and opacity, groups, strokes."""
    for kind in range(24):
        file = PictureFile()
        file.put('4d', 1, 1, 1, 1)  # origin: own scale, pixels per unit, max-error
        file.put('4d4dB', 0, 0, 8, 6, 0, 0, 8, 6, kind % 3)
        file.put('B', kind % 2)
        if kind % 2:
            file.put('3f', 1, 0.5, 0)
        paints = kind % 4
        file.put('Q', paints)
        for paint in range(paints):
            file.texture() if paint == 2 else file.gradient(paint)
        layers = kind % 3
        file.put('Q', layers)
        for layer in range(layers):
            file.layer((kind + layer) % 3, 1 + layer, kind // 2 % 3, list(range(paints)), layer)
        grouped = kind % 5 == 0
        strokes = kind // 4 % 2
        file.put('Q', layers + strokes + 2 * grouped)
        if grouped:
            file.put('BfB', 2, 0.5, kind % 16)
        for layer in range(layers):
            file.instance(layer, kind * 5 % 16)
        if strokes:
            file.stroke()
        if grouped:
            file.put('B', 3)
        yield file.bytes


def examples():
    """Returns our small drawings."""
    for file in [*ROOT.glob('examples/*.svg'), *ROOT.glob('tests/*/*.svg')]:
        if file.stat().st_size < 4000:
            yield file.read_bytes()
    for file in ROOT.glob('docs/format*.md'):
        yield from (text.encode() for text in re.findall('```xml\n(.*?)```', file.read_text(), re.S))


def seeds():
    documents = [text.encode() for text in DOCUMENTS] + list(examples())
    orzan = [text.encode() for text in CURVE_SETS]
    yield 'orzan', orzan + [text for text in documents if b'curve_set' in text]
    yield 'svg', documents + orzan + [gzip.compress(text, 9, mtime=0) for text in documents[:3]]
    yield 'import', [text.encode() for text in ICONS] + documents
    yield 'stop_list', [text.encode() for text in STOP_LISTS]
    yield 'path_data', [text.encode() for text in PATHS]
    yield 'style_sheet', [text.encode() for text in SHEETS]
    yield 'option_string', [bytes([call]) + text.encode() for call, text in OPTION_STRINGS]
    yield 'png', list(pngs())
    yield 'jpeg', list(jpegs())
    yield 'photo', list(photos())
    yield 'mesher', list(noise(1, 40, 200))
    yield 'gather', list(noise(2, 40, 400))
    yield 'picture_file', list(pictures())
    yield 'pixels', documents + orzan + list(noise(3, 40, 300))
    yield 'round_trip', documents + orzan + list(noise(4, 40, 300))
    yield 'export', [bytes([kind]) + text for kind in range(9)
                     for text in documents[:8] + list(noise(kind, 8, 250))]
    steps = random.Random(5)
    yield 'solution', [bytes(steps.randrange(256) for _ in range(24)) + text
                       for text in documents[:12] + list(noise(6, 40, 300))]
    yield 'drag', [bytes(steps.randrange(256) for _ in range(42)) + text
                   for text in documents[:12] + list(noise(7, 60, 300))]
    yield 'trace', list(traces())


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for target, inputs in seeds():
        folder = pathlib.Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for i, content in enumerate(inputs):
            (folder / f'seed-{i:03}').write_bytes(content)
        print(f'{target}: {len(inputs)}')


main()
