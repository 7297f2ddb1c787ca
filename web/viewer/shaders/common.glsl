// The beginning of every shader. docs/gpu.md describes the interface.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

/// Nodes of a triangle, in the order of picture/patch.hpp.
const int kNodes = 10;

/// Returns the texel of entry i of a data texture.
ivec2 table_texel(int i) {
  return ivec2(i & 2047, i >> 11);
}

vec4 table_value(sampler2D table, int i) {
  return texelFetch(table, table_texel(i), 0);
}

int table_index(usampler2D table, int i) {
  return int(texelFetch(table, table_texel(i), 0).r);
}

vec2 mapped(vec3 row[2], vec2 p) {
  return vec2(dot(row[0], vec3(p, 1.0)), dot(row[1], vec3(p, 1.0)));
}

// Where the strips of a blur end, in radii from the edge, and the largest radius, pixels: as in
// raster/coverage/soft_strip.hpp.
const float kStripReach[4] = float[4](0.08373, 0.25630, 0.44840, 0.71157);
const float kMostReach = 64.0;

float longest_edge_squared(vec2 a, vec2 b, vec2 c) {
  return max(dot(b - a, b - a), max(dot(c - b, c - b), dot(a - c, a - c)));
}

/// Returns whether a triangle's colours may bend within a pixel, as raster::MixedPixels does.
bool is_small(vec2 a, vec2 b, vec2 c) {
  return longest_edge_squared(a, b, c) <= 9.0;
}

/// Returns whether a small triangle is divided into quarters of a pixel, as raster::MixedPixels
/// does.
bool is_read_in_quarters(vec2 a, vec2 b, vec2 c) {
  return is_small(a, b, c) && longest_edge_squared(a, b, c) > 0.36;
}

// Spaces of interpolation.
const int kLinearLight = 1;
const int kOklab = 2;

vec3 code_from_linear(vec3 linear) {
  vec3 power = 1.055 * pow(max(linear, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
  return mix(12.92 * linear, power, greaterThan(linear, vec3(0.0031308)));
}

vec3 linear_from_oklab(vec3 lab) {
  vec3 root = vec3(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z,
                   lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z,
                   lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
  vec3 c = root * root * root;
  return vec3(4.0767416621 * c.x - 3.3077115913 * c.y + 0.2309699292 * c.z,
              -1.2684380046 * c.x + 2.6097574011 * c.y - 0.3413193965 * c.z,
              -0.0041960863 * c.x - 0.7034186147 * c.y + 1.7076147010 * c.z);
}

/// Converts a colour of the interpolation space to code values, clamped to [0, 1].
vec3 clamped_code(int space, vec3 color) {
  if (space == kOklab) color = linear_from_oklab(color);
  color = clamp(color, 0.0, 1.0);
  return space == 0 ? color : code_from_linear(color);
}
