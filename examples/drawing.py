"""Functions for the scripts that draw the examples: colours, Bezier chains, stop lists, elements."""


def mix(a, b, t):
    """a at t = 0, b at t = 1; t is clamped. Points and colours."""
    t = min(1, max(0, t))
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def rgb(text):
    """The three code values of '#rrggbb'."""
    return tuple(int(text[i:i + 2], 16) for i in (1, 3, 5))


def css(colour):
    return '#' + ''.join(f'{round(min(255, max(0, c))):02x}' for c in colour)


def ramp(colours, t):
    """Colours spread evenly over 0..1."""
    position = min(1, max(0, t)) * (len(colours) - 1)
    i = min(len(colours) - 2, int(position))
    return mix(colours[i], colours[i + 1], position - i)


def number(value):
    return f'{value:.1f}'.removesuffix('.0')


def smooth_chain(points):
    """Cubic pieces (a, control, control, b) through points: Catmull-Rom."""
    chain = []
    for i in range(len(points) - 1):
        a, b = points[i], points[i + 1]
        before, after = points[max(i - 1, 0)], points[min(i + 2, len(points) - 1)]
        chain.append((a, (a[0] + (b[0] - before[0]) / 6, a[1] + (b[1] - before[1]) / 6),
                      (b[0] - (after[0] - a[0]) / 6, b[1] - (after[1] - a[1]) / 6), b))
    return chain


def path_data(chain, closed=False):
    """Returns path data of cubic pieces; each begins where the one before ends."""
    commands = [f'M{number(chain[0][0][0])} {number(chain[0][0][1])}']
    for piece in chain:
        commands.append('C' + ' '.join(f'{number(x)} {number(y)}' for x, y in piece[1:]))
    return ' '.join(commands) + ('Z' if closed else '')


def path(points, closed=False):
    return path_data(smooth_chain(points), closed)


def clockwise(chain):
    """A closed chain so turned that, on the screen, its inside lies on its right."""
    corners = [point for piece in chain for point in piece[:3]]
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))
    return chain if area > 0 else [piece[::-1] for piece in reversed(chain)]


def stops(values, offsets=None, form=str):
    """A stop list; offsets are shares of the arc length, or None: evenly spread."""
    if offsets is None:
        return ', '.join(form(value) for value in values)
    return ', '.join(f'{form(value)} {round(100 * offset)}%'
                     for value, offset in zip(values, offsets))


def element(tag, **attributes):
    """An attribute whose name begins with sf_ belongs to the namespace of Sfumato."""
    names = ((name.replace('sf_', 'sf:').replace('_', '-'), value)
             for name, value in attributes.items())
    return f'<{tag} ' + ' '.join(f'{name}="{value}"' for name, value in names) + '/>'


def curve(data, **attributes):
    return element('path', d=data, **attributes)


def group(name, lines, more=''):
    return [f'<g id="{name}"{more}>', *('  ' + line for line in lines), '</g>']


def layer(name, curves, more=''):
    if len(curves) > 1:
        return group(name, curves, ' sf:diffuse="true"' + more)
    # svgo merges a group with its only child, unless both have a class.
    only = curves[0].replace(' ', ' class="curve" ', 1)
    return group(name, [only], ' class="layer" sf:diffuse="true"' + more)


def document(width, height, title, comment, background, lines):
    """The whole file; comment is a list of lines, background a colour."""
    text = ('\n' + 7 * ' ').join(comment)
    # Inkscape 1.2 follows xlink:href only; later ones, and browsers, know both.
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" '
            f'xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:sf="urn:sfumato:1" '
            f'viewBox="0 0 {width} {height}" sf:version="1">')
    # svgo renames ids, which it does not find in attributes of other namespaces, unless there is a
    # style sheet; a rectangle in percent stays a rectangle.
    return '\n'.join([head, f'  <title>{title}</title>', f'  <!-- {text} -->',
                      '  <style>*{stroke-linejoin:round}</style>',
                      f'  <rect width="100%" height="100%" fill="{background}"/>',
                      *('  ' + line for line in lines), '</svg>'])
