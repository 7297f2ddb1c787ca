// Composites source over backdrop: W3C Compositing and Blending Level 1, sections 5, 10.1 and 10.2,
// on code values. b is the backdrop's colour, s the source's colour: Cb and Cs in the
// specification.
uniform sampler2D source;
uniform float opacity;
#ifdef WITH_EDGES
uniform sampler2D edges;
uniform bool is_opaque;
uniform vec3 frame_from_pixel[2];
#endif

out vec4 fragment;

/// Clamps a sum, which may be out of range.
vec4 in_range(vec4 pixel) {
  float alpha = clamp(pixel.a, 0.0, 1.0);
  return vec4(clamp(pixel.rgb, 0.0, alpha), alpha);
}

#ifdef WITH_EDGES
// If half of the square around a centre is covered, the centre rule decides.
const float kLeastArea = 0.5 + 1e-4;
// From this area on the whole pixel is covered; the sum is rounded, in half precision too.
const float kWholeArea = 1.0 - 2e-3;

/// Returns whether the whole pixel lies in the layer's frame, which is [0, 1]².
bool in_frame() {
  vec2 center = mapped(frame_from_pixel, gl_FragCoord.xy);
  vec2 reach = 0.5 * vec2(abs(frame_from_pixel[0].x) + abs(frame_from_pixel[0].y),
                          abs(frame_from_pixel[1].x) + abs(frame_from_pixel[1].y));
  return all(greaterThanEqual(center - reach, vec2(0.0))) &&
         all(lessThanEqual(center + reach, vec2(1.0)));
}

/// Returns the mean over the pixel's square where a curve cuts it. The frame is not an outline, as
/// in raster::MixedPixels.
vec4 with_edges(vec4 pixel) {
  vec4 mean = texelFetch(edges, ivec2(gl_FragCoord.xy), 0);
  if (mean.a < 0.0) return pixel;
  if (is_opaque && mean.a > kWholeArea) return mean / mean.a;
  if (!is_opaque || in_frame()) return mean;
  return mean.a < kLeastArea ? pixel : mean / mean.a;
}
#endif

vec4 source_pixel() {
  vec4 pixel = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
#ifdef WITH_EDGES
  pixel = with_edges(pixel);
#endif
  return opacity * in_range(pixel);
}

#ifdef WITHOUT_BACKDROP
void main() {
  fragment = source_pixel();
}
#else
uniform sampler2D backdrop;
uniform int blend_mode;

// The order of BlendMode.
const int kMultiply = 1;
const int kScreen = 2;
const int kOverlay = 3;
const int kDarken = 4;
const int kLighten = 5;
const int kColorDodge = 6;
const int kColorBurn = 7;
const int kHardLight = 8;
const int kSoftLight = 9;
const int kDifference = 10;
const int kExclusion = 11;
const int kHue = 12;
const int kSaturation = 13;
const int kColor = 14;
const int kLuminosity = 15;

float hard_light(float b, float s) {
  float twice = s + s;
  return s <= 0.5 ? b * twice : b + (twice - 1.0) - b * (twice - 1.0);
}

float color_dodge(float b, float s) {
  if (b <= 0.0) return 0.0;
  return s < 1.0 ? min(b / (1.0 - s), 1.0) : 1.0;
}

float color_burn(float b, float s) {
  if (b >= 1.0) return 1.0;
  return s > 0.0 ? 1.0 - min((1.0 - b) / s, 1.0) : 0.0;
}

float soft_light(float b, float s) {
  float d = b <= 0.25 ? ((16.0 * b - 12.0) * b + 4.0) * b : sqrt(b);
  return b + (s + s - 1.0) * (s <= 0.5 ? b * (1.0 - b) : d - b);
}

/// Returns B(Cb, Cs) of the separable modes.
float separable(float b, float s) {
  switch (blend_mode) {
    case kMultiply: return b * s;
    case kScreen: return b + s - b * s;
    case kOverlay: return hard_light(s, b);
    case kDarken: return min(b, s);
    case kLighten: return max(b, s);
    case kColorDodge: return color_dodge(b, s);
    case kColorBurn: return color_burn(b, s);
    case kHardLight: return hard_light(b, s);
    case kSoftLight: return soft_light(b, s);
    case kDifference: return abs(b - s);
    case kExclusion: return b + s - 2.0 * b * s;
  }
  return s;
}

float luminosity_of(vec3 c) {
  return dot(c, vec3(0.3, 0.59, 0.11));
}

float least(vec3 c) {
  return min(c.r, min(c.g, c.b));
}

float greatest(vec3 c) {
  return max(c.r, max(c.g, c.b));
}

/// SetLum with its ClipColor.
vec3 with_luminosity(vec3 c, float luminosity) {
  vec3 moved = c + (luminosity - luminosity_of(c));
  float center = luminosity_of(moved), low = least(moved), high = greatest(moved);
  float from_below = low < 0.0 ? center / (center - low) : 1.0;
  float from_above = high > 1.0 ? (1.0 - center) / (high - center) : 1.0;
  return center + (moved - center) * from_below * from_above;
}

float saturation_of(vec3 c) {
  return greatest(c) - least(c);
}

/// SetSat: the least channel becomes 0, the greatest `saturation`.
vec3 with_saturation(vec3 c, float saturation) {
  float range = saturation_of(c);
  return range > 0.0 ? (c - least(c)) * (saturation / range) : vec3(0.0);
}

vec3 blended(vec3 b, vec3 s) {
  switch (blend_mode) {
    case kHue:
      return with_luminosity(with_saturation(s, saturation_of(b)), luminosity_of(b));
    case kSaturation:
      return with_luminosity(with_saturation(b, saturation_of(s)), luminosity_of(b));
    case kColor: return with_luminosity(s, luminosity_of(b));
    case kLuminosity: return with_luminosity(b, luminosity_of(s));
  }
  return vec3(separable(b.r, s.r), separable(b.g, s.g), separable(b.b, s.b));
}

vec3 unpremultiplied(vec4 pixel) {
  return pixel.a > 0.0 ? min(pixel.rgb / pixel.a, 1.0) : vec3(0.0);
}

void main() {
  vec4 s = source_pixel();
  vec4 b = in_range(texelFetch(backdrop, ivec2(gl_FragCoord.xy), 0));
  vec3 mixed = blended(unpremultiplied(b), unpremultiplied(s));
  vec3 top = blend_mode == 0 ? s.rgb : s.rgb * (1.0 - b.a) + s.a * b.a * mixed;
  fragment = vec4(top + b.rgb * (1.0 - s.a), s.a + b.a * (1.0 - s.a));
}
#endif
