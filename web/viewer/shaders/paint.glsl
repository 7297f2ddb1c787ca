// Image-domain shaders: gradients and textures, each the mean over a pixel of the image
// (docs/mathematics.md, "Image-domain shaders"). Colours are code values, not premultiplied.
const int kMostPaints = 128;

uniform sampler2D paint_table;
uniform usampler2D paint_texels;
layout(std140) uniform PaintViews {
  vec4 paint_view[2 * kMostPaints];
};

const int kRadial = 1;
const int kTexture = 2;
const int kReflect = 1;
const int kRepeat = 2;

/// Converts code values to the interpolation space.
vec3 from_code(int space, vec3 code) {
  if (space == 0) return code;
  vec3 power = pow((max(code, 0.04045) + 0.055) / 1.055, vec3(2.4));
  vec3 c = mix(code / 12.92, power, greaterThan(code, vec3(0.04045)));
  if (space == kLinearLight) return c;
  vec3 cone = vec3(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b,
                   0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b,
                   0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
  vec3 root = pow(max(cone, 0.0), vec3(1.0 / 3.0));
  return vec3(0.2104542553 * root.x + 0.7936177850 * root.y - 0.0040720468 * root.z,
              1.9779984951 * root.x - 2.4285922050 * root.y + 0.4505937099 * root.z,
              0.0259040371 * root.x + 0.7827717662 * root.y - 0.8086757660 * root.z);
}

vec4 premultiplied(vec4 color) {
  return vec4(color.rgb * color.a, color.a);
}

// ---- Gradients. `at` is the first texel of the paint.

struct Gradient {
  int at, spread, segment_count;
};

int segment_texel(Gradient gradient, int i) {
  return gradient.at + 5 + 4 * i;
}

/// Returns the segment that holds t from 0 to 1; at a border the later one.
int segment_at(Gradient gradient, float t) {
  int low = 0, high = gradient.segment_count;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (t < table_value(paint_table, segment_texel(gradient, middle)).x)
      high = middle;
    else
      low = middle;
  }
  return low;
}

vec4 segment_color(Gradient gradient, int i, float t) {
  int at = segment_texel(gradient, i);
  float along = t - table_value(paint_table, at).x;
  return table_value(paint_table, at + 1) + along * table_value(paint_table, at + 2);
}

/// Returns the integral of the premultiplied colour and of alpha over [low, high] of a segment.
vec4 segment_integral(Gradient gradient, int i, float low, float high) {
  float width = high - low;
  vec4 middle = segment_color(gradient, i, 0.5 * (low + high));
  vec4 slope = table_value(paint_table, segment_texel(gradient, i) + 2);
  vec3 bend = slope.rgb * slope.a * (width * width / 12.0);
  return width * vec4(middle.rgb * middle.a + bend, middle.a);
}

/// Returns the same over [low, high] in [0, 1]. Parts next to the ends are not differences of sums,
/// so that short intervals keep their precision.
vec4 unit_integral(Gradient gradient, float low, float high) {
  int i = segment_at(gradient, low), j = segment_at(gradient, high);
  if (i == j) return segment_integral(gradient, i, low, high);
  float end = table_value(paint_table, segment_texel(gradient, i)).y;
  float begin = table_value(paint_table, segment_texel(gradient, j)).x;
  vec4 between = table_value(paint_table, segment_texel(gradient, j) + 3) -
                 table_value(paint_table, segment_texel(gradient, i + 1) + 3);
  return segment_integral(gradient, i, low, end) + between +
         segment_integral(gradient, j, begin, high);
}

/// Returns the same in the cell [k, k + 1] of a repeating gradient, from k + low to k + high.
vec4 cell_integral(Gradient gradient, float k, float low, float high) {
  bool backwards = gradient.spread == kReflect && mod(k, 2.0) == 1.0;
  return backwards ? unit_integral(gradient, 1.0 - high, 1.0 - low)
                   : unit_integral(gradient, low, high);
}

vec4 spread_integral(Gradient gradient, float low, float high) {
  if (gradient.spread == 0) {
    float from = clamp(low, 0.0, 1.0), to = clamp(high, 0.0, 1.0);
    vec4 first = premultiplied(table_value(paint_table, gradient.at + 2));
    vec4 last = premultiplied(table_value(paint_table, gradient.at + 3));
    return unit_integral(gradient, from, to) + (from - low) * first + (high - to) * last;
  }
  float i = floor(low), j = floor(high);
  if (i == j) return cell_integral(gradient, i, low - i, high - i);
  return cell_integral(gradient, i, low - i, 1.0) + cell_integral(gradient, j, 0.0, high - j) +
         (j - i - 1.0) * table_value(paint_table, gradient.at + 4);
}

/// Returns the offset with the same colour, from 0 to 1 except for pad.
float folded(Gradient gradient, float t) {
  if (gradient.spread == 0 || (t >= 0.0 && t < 1.0)) return t;
  if (gradient.spread == kRepeat) return t - floor(t);
  float u = t - 2.0 * floor(t / 2.0);
  return u <= 1.0 ? u : 2.0 - u;
}

vec4 gradient_mean(Gradient gradient, float center, float half_width) {
  float t = folded(gradient, center);
  float low = t - half_width, high = t + half_width;
  if (gradient.spread == 0 && high <= 0.0) return table_value(paint_table, gradient.at + 2);
  if (gradient.spread == 0 && low >= 1.0) return table_value(paint_table, gradient.at + 3);
  if (low >= 0.0 && high <= 1.0) {
    int i = segment_at(gradient, low);
    if (high <= table_value(paint_table, segment_texel(gradient, i)).y)
      return segment_color(gradient, i, t);
  }
  vec4 sum = spread_integral(gradient, low, high);
  vec3 color = sum.a > 0.0 ? clamp(sum.rgb / sum.a, 0.0, 1.0) : vec3(0.0);
  return vec4(color, clamp(sum.a / (high - low), 0.0, 1.0));
}

// Beyond this offset a gradient shows the same everywhere.
const float kLargestOffset = 1e9;

float change_over_pixel(vec3 row[2], vec2 slope) {
  return length(slope.x * row[0].xy + slope.y * row[1].xy);
}

/// Returns gradient_offset() if the focus is a circle of radius f, or lies outside the circle.
vec3 cone_offset(vec2 e, float f, vec3 row[2], vec2 p) {
  float grows = 1.0 - f;
  float a = grows * grows - dot(e, e), b = dot(p, e) + f * grows, q = dot(p, p) - f * f;
  float under_root = b * b + a * q;
  float change = change_over_pixel(row, 2.0 * (b * e + a * p));
  float coverage = change > 0.0 ? clamp(under_root / change + 0.5, 0.0, 1.0)
                                : float(under_root > 0.0);
  float root = sqrt(max(under_root, 0.0));
  float sum = b > 0.0 ? b + root : b - root;
  float one = sum != 0.0 ? q / sum : 0.0, other = a != 0.0 ? -sum / a : one;
  float t = max(one, other);
  if (!(f + t * grows >= 0.0)) t = min(one, other);
  if (!(f + t * grows >= 0.0) || coverage == 0.0) return vec3(kLargestOffset, 0.0, 0.0);
  float slope = root > 0.0 ? change_over_pixel(row, p - e * t) / root : kLargestOffset;
  float most = a != 0.0 ? sqrt(0.5 * change) / abs(a) : kLargestOffset;
  return vec3(clamp(t, -kLargestOffset, kLargestOffset), min(0.5 * slope, most), coverage);
}

/// Returns the offset of a point, half the pixel's width there, and the share of the pixel that the
/// gradient covers. raster::Gradient has the formulas.
vec3 gradient_offset(bool radial, vec4 circle, vec3 row[2], vec2 pixel) {
  vec2 p = mapped(row, pixel), e = circle.xy;
  if (!radial)
    return vec3(clamp(p.x, -kLargestOffset, kLargestOffset), 0.5 * length(row[0].xy), 1.0);
  if (circle.w > 0.0) return cone_offset(e, circle.z, row, p);
  float a = 1.0 - dot(e, e), b = dot(p, e), q = dot(p, p);
  float root = sqrt(b * b + a * q);
  float t = b > 0.0 ? q / (b + root) : (root - b) / a;
  vec2 slope = root > 0.0 ? (p - e * t) / root : vec2(1.0, 0.0);
  return vec3(min(t, kLargestOffset), min(0.5 * change_over_pixel(row, slope), kLargestOffset), 1.0);
}

vec4 gradient_color(int at, vec4 head, vec3 row[2], vec2 pixel) {
  Gradient gradient = Gradient(at, int(head.y), int(head.z));
  vec4 circle = table_value(paint_table, at + 1);
  vec3 offset = gradient_offset(int(head.x) == kRadial, circle, row, pixel);
  return gradient_mean(gradient, offset.x, offset.y) * vec4(1.0, 1.0, 1.0, offset.z);
}

// ---- Textures.

struct Level {
  ivec2 size;
  int first;
  vec2 scale, period;
  bool repeats;
};

Level texture_level(int at, int i, bool repeats) {
  vec4 place = table_value(paint_table, at + 1 + 2 * i);
  vec4 frame = table_value(paint_table, at + 2 + 2 * i);
  return Level(ivec2(place.xy), 2048 * int(place.w) + int(place.z), frame.xy, frame.zw, repeats);
}

/// Returns coordinates reduced to [0, period), or to the surroundings of a texture that does not
/// repeat.
vec2 reduced(Level level, vec2 p) {
  if (!level.repeats) return clamp(p, -level.period - 2.0, 2.0 * level.period + 2.0);
  vec2 inside = p - level.period * floor(p / level.period);
  return mix(inside, vec2(0.0), greaterThanEqual(inside, level.period));
}

vec4 texel(Level level, ivec2 place) {
  ivec2 last = level.size - 1;
  ivec2 i = clamp(place, ivec2(0), last);
  if (level.repeats) {
    ivec2 repeated = min(ivec2(reduced(level, vec2(place) + 0.5)), last);
    if (i.x != place.x) i.x = repeated.x;
    if (i.y != place.y) i.y = repeated.y;
  }
  return vec4(texelFetch(paint_texels, table_texel(level.first + i.y * level.size.x + i.x), 0));
}

/// Returns Keys' weights (a = -1/2) of the texels at -1, 0, 1, 2 for a point f past texel 0.
vec4 cubic_weights(float f) {
  float square = f * f;
  return vec4(f * (-0.5 + f * (1.0 - 0.5 * f)), 1.0 + square * (-2.5 + 1.5 * f),
              f * (0.5 + f * (2.0 - 1.5 * f)), square * (-0.5 + 0.5 * f));
}

/// Returns the cubic convolution, kept within the range of the four texels around the point.
vec4 magnified(Level level, vec2 p) {
  vec2 place = reduced(level, p) - 0.5;
  ivec2 base = ivec2(floor(place));
  vec4 across = cubic_weights(place.x - float(base.x)), down = cubic_weights(place.y - float(base.y));
  vec4 sum = vec4(0.0), low = vec4(65535.0), high = vec4(0.0);
  for (int j = 0; j < 4; ++j) {
    vec4 row = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
      vec4 value = texel(level, base + ivec2(i - 1, j - 1));
      row += across[i] * value;
      if (i == 1 || i == 2) {
        low = j == 1 || j == 2 ? min(low, value) : low;
        high = j == 1 || j == 2 ? max(high, value) : high;
      }
    }
    sum += down[j] * row;
  }
  return clamp(sum, low, high);
}

/// A tent two pixels wide, in the frame of a level: weight (1 - |across · d|) (1 - |down · d|).
struct Tent {
  vec2 across, down;
  float area, shorter_side;
};

/// Returns singular values and directions of the map's linear part; neither value below one texel.
Tent make_tent(vec2 row_x, vec2 row_y) {
  float e = dot(row_x, row_x), g = dot(row_y, row_y), f = dot(row_x, row_y);
  float difference = 0.5 * (e - g), root = length(vec2(difference, f));
  float large = sqrt(0.5 * (e + g) + root);
  vec2 major = e >= g ? vec2(difference + root, f) : vec2(f, root - difference);
  major = dot(major, major) > 0.0 ? normalize(major) : vec2(1.0, 0.0);
  vec2 source = row_x * major.x + row_y * major.y;
  source = large > 0.0 ? source / large : vec2(1.0, 0.0);
  float determinant = abs(row_x.x * row_y.y - row_x.y * row_y.x);
  float small = large > 0.0 ? max(determinant / large, 1.0) : 1.0;
  large = max(large, 1.0);
  vec2 minor = vec2(-major.y, major.x);
  return Tent(major * (source.x / large) - minor * (source.y / small),
              major * (source.y / large) + minor * (source.x / small), large * small, small);
}

/// Narrows `range` to the places i with |low + i step| < 1.
void narrow(float low, float step, inout vec2 range) {
  if (abs(step) < 1e-12) return;
  vec2 ends = (vec2(-1.0, 1.0) - low) / step;
  range = vec2(max(range.x, floor(min(ends.x, ends.y))), min(range.y, ceil(max(ends.x, ends.y))));
}

/// Returns the mean of all texels under the tent.
vec4 minified(Level level, Tent tent, vec2 p) {
  vec2 place = reduced(level, p) - 0.5;
  vec2 reach = tent.area * (abs(tent.across.yx) + abs(tent.down.yx));
  vec4 sum = vec4(0.0);
  float total = 0.0;
  float left = floor(place.x - reach.x), right = floor(place.x + reach.x) + 1.0;
  for (float j = floor(place.y - reach.y); j < place.y + reach.y; ++j) {
    vec2 d = vec2(left, j) - place;
    float u = dot(tent.across, d), v = dot(tent.down, d);
    vec2 range = vec2(0.0, right - left);
    narrow(u, tent.across.x, range);
    narrow(v, tent.down.x, range);
    for (float i = range.x; i <= range.y; ++i) {
      float w = max(1.0 - abs(u + i * tent.across.x), 0.0) * max(1.0 - abs(v + i * tent.down.x), 0.0);
      if (w == 0.0) continue;
      sum += w * texel(level, ivec2(left + i, j));
      total += w;
    }
  }
  return sum / max(total, 1e-20);
}

// The same choice as in raster::evaluate_texture, with room for rounding.
const float kKeepsSize = 1.0 + 1e-5;
const float kMostTexelsAcross = 14.0 * (1.0 + 1e-5);
const float kLargestFootprint = 512.0 * (1.0 + 1e-5);

float largest_stretch(vec2 row_x, vec2 row_y) {
  float e = dot(row_x, row_x), g = dot(row_y, row_y), f = dot(row_x, row_y);
  return sqrt(0.5 * (e + g) + length(vec2(0.5 * (e - g), f)));
}

vec4 texture_sum(int at, int level_count, bool repeats, vec3 row[2], vec2 pixel) {
  Level level = texture_level(at, 0, repeats);
  vec2 p = mapped(row, pixel);
  if (largest_stretch(row[0].xy, row[1].xy) <= kKeepsSize) return magnified(level, p);
  int i = 0;
  Tent tent = make_tent(row[0].xy, row[1].xy);
  while (i + 1 < level_count &&
         !(tent.area <= kLargestFootprint && tent.shorter_side <= kMostTexelsAcross)) {
    level = texture_level(at, ++i, repeats);
    tent = make_tent(level.scale.x * row[0].xy, level.scale.y * row[1].xy);
  }
  // The last level is one texel, which is read whole.
  if (i + 1 == level_count) tent = Tent(vec2(1.0, 0.0), vec2(0.0, 1.0), 1.0, 1.0);
  return minified(level, tent, level.scale * p);
}

vec4 texture_color(int at, vec4 head, vec3 row[2], vec2 pixel) {
  vec4 sum = texture_sum(at, int(head.z), head.y == 1.0, row, pixel);
  if (head.w == 1.0) return vec4(min(sum.rgb / 65535.0, 1.0), 1.0);
  return vec4(sum.a > 0.0 ? min(sum.rgb / sum.a, 1.0) : vec3(0.0), sum.a / 65535.0);
}

/// Returns paint i of the layer at the centre of a pixel of the image.
vec4 paint_color(int i, vec2 pixel) {
  vec4 x = paint_view[2 * i], y = paint_view[2 * i + 1];
  vec3 row[2] = vec3[2](x.xyz, y.xyz);
  int at = int(x.w);
  vec4 head = table_value(paint_table, at);
  return int(head.x) == kTexture ? texture_color(at, head, row, pixel)
                                 : gradient_color(at, head, row, pixel);
}
