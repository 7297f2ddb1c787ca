"""Writes a picture of grey values as a PNG with a palette, for the scripts that draw textures."""

import struct
import zlib


def ramp(stops, t):
    """The colour at t of (position, (red, green, blue)), positions from 0 to 1, as three bytes."""
    for (t0, a), (t1, b) in zip(stops, stops[1:]):
        if t <= t1:
            return bytes(round(p + (q - p) * (t - t0) / (t1 - t0)) for p, q in zip(a, b))
    return bytes(stops[-1][1])


def chunk(name, data):
    body = name + data
    return struct.pack('>I', len(data)) + body + struct.pack('>I', zlib.crc32(body))


def write_texture(name, size, value, stops, palette_size):
    """value(x, y), 0 to 1, at the centres of size = (width, height) pixels, coloured by stops."""
    width, height = size
    last = palette_size - 1
    rows = (bytes(round(min(1, max(0, value(x + 0.5, y + 0.5))) * last) for x in range(width))
            for y in range(height))
    palette = b''.join(ramp(stops, i / last) for i in range(palette_size))
    header = struct.pack('>IIBBBBB', width, height, 8, 3, 0, 0, 0)
    pixels = zlib.compress(b''.join(b'\0' + row for row in rows), 9)
    with open(name, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + chunk(b'PLTE', palette)
                   + chunk(b'IDAT', pixels) + chunk(b'IEND', b''))
