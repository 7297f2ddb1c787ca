// The exact colour of a pixel, gathered at its centre by gather/point_walk.glsl. The colour is not
// premultiplied. A point that is not found keeps its pixel; its alpha is then outside 0 to 1.
//
// WITH_BLUR: some curve is blurred. WITH_OPACITY: a second field, whose triangles follow.
uniform sampler2D places;
uniform ivec2 first_place;
uniform vec3 scene_from_pixel[2];
uniform float negligible;
uniform int step_limit;
uniform int triangle_count;
uniform int interpolation;
/// Samples in a pixel that a curve cuts: 16, or 0 to leave the pixel out.
uniform int cut_samples;
uniform sampler2D end_table;
uniform ivec2 end_count;

out vec4 fragment;

const int kHops = 64;
const float kEndKnee = 25.0;

float side_of(int ax, int ay, int bx, int by, vec2 p) {
  vec2 a = intBitsToFloat(ivec2(ax, ay)), e = intBitsToFloat(ivec2(bx, by)) - a;
  return e.x * (p.y - a.y) - e.y * (p.x - a.x);
}

/// Walks from the triangle that the rasteriser found, whose corners lie on a grid of 1/256 pixels,
/// to the triangle that holds the point.
int located(vec2 p, int t) {
  for (int i = 0; i < kHops; ++i) {
    ivec4 t0 = triangle_at(3 * t), t1 = triangle_at(3 * t + 1), t2 = triangle_at(3 * t + 2);
    vec3 side = vec3(side_of(t0.x, t0.w, t0.y, t1.x, p), side_of(t0.y, t1.x, t0.z, t1.y, p),
                     side_of(t0.z, t1.y, t0.x, t0.w, p));
    float farthest = 0.0;
    int across = -1;
    for (int k = 0; k < 3; ++k) {
      if (side[k] < farthest && t2[k + 1] >= 0) {
        farthest = side[k];
        across = t2[k + 1];
      }
    }
    if (across < 0) break;
    t = across / 3;
  }
  return t;
}

/// Moves a point on a corner a thousandth inwards, because it sees two edges at no angle.
vec2 off_corners(vec2 p, int t) {
  ivec4 t0 = triangle_at(3 * t), t1 = triangle_at(3 * t + 1);
  vec3 x = intBitsToFloat(t0.xyz), y = intBitsToFloat(ivec3(t0.w, t1.xy));
  bool is_on = false;
  for (int k = 0; k < 3; ++k) is_on = is_on || (x[k] == p.x && y[k] == p.y);
  return is_on ? p + 1e-3 * (vec2(dot(x, vec3(1.0)), dot(y, vec3(1.0))) / 3.0 - p) : p;
}

/// Adds the terms of free ends, as gather/kernels/end_terms.hpp does. Returns the new weight.
float with_ends(vec2 p, int first, int count, float weight, inout vec4 mean) {
  for (int i = first; i < first + count; ++i) {
    vec4 a = table_value(end_table, 5 * i), b = table_value(end_table, 5 * i + 1);
    vec2 d = p - a.xy;
    float square = dot(d, d), x = square * b.y;
    if (!(x < 1.0 && square > 0.0)) continue;
    float fade = 1.0 - x;
    float more = b.z * (fade * fade) / (square * (1.0 + kEndKnee * x));
    weight += more;
    float r = sqrt(square), sine = b.x * r, cosine = sqrt(max(1.0 - sine * sine, 0.0));
    vec2 unbent = vec2(cosine * d.x + sine * d.y, cosine * d.y - sine * d.x);
    float across = a.z * unbent.y - a.w * unbent.x, ahead = dot(a.zw, unbent);
    float greater = sqrt(0.5 * (r + abs(ahead)) / r), other = across / (r + r) / greater;
    float half_sine = ahead > 0.0 ? other : across < 0.0 ? -greater : greater;
    float radius = across > 0.0 ? b.w : table_value(end_table, 5 * i + 2).x;
    float y = 0.5 + 0.5 * abs(across) / max(radius, 1e-30);
    float front = radius > abs(across) ? y * y * (3.0 - 2.0 * y) : 1.0;
    float share = 0.5 + 0.5 * half_sine * (2.0 * front - 1.0);
    vec4 z = mix(table_value(end_table, 5 * i + 4), table_value(end_table, 5 * i + 3), share);
    mean += more / weight * (z - mean);
  }
  return weight;
}

/// Returns the colour at p, premultiplied; alpha -1 if the point was not found.
vec4 color_at(vec2 p, int t) {
  gather(p, t, negligible, step_limit);
  if (failed) return vec4(-1.0);
  vec4 color = weight > 0.0 ? value / weight : vec4(0.0);
  float seen = with_ends(p, 0, end_count.x, weight, color), alpha = seen > 0.0 ? 1.0 : 0.0;
#ifdef WITH_OPACITY
  gather(p, t + triangle_count, negligible, step_limit);
  if (failed) return vec4(-1.0);
  vec4 opacity = weight > 0.0 ? value / weight : vec4(0.0);
  with_ends(p, end_count.x, end_count.y, weight, opacity);
  alpha *= clamp(opacity.x, 0.0, 1.0);
#endif
  return vec4(alpha * clamped_code(interpolation, color.rgb), alpha);
}

/// Returns sample i of a pixel, relative to its centre; samples are evenly spread.
vec2 sample_place(int i) {
  vec2 cell = vec2(i & 3, i >> 2);
  return (cell - 1.5) / 4.0 + (cell.yx - 1.5) * vec2(1.0, -1.0) / 16.0;
}

void main() {
  vec4 place = texelFetch(places, ivec2(gl_FragCoord.xy) - first_place, 0);
  int count = place.y == 0.0 ? cut_samples : 1;
  if (place.x < 0.0 || count == 0) discard;
  int t = int(place.x);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < count; ++i) {
    vec2 p = mapped(scene_from_pixel, gl_FragCoord.xy + (count == 1 ? vec2(0.0) : sample_place(i)));
    t = located(p, t);
    vec4 color = color_at(off_corners(p, t), t);
    if (color.a < 0.0) discard;
    sum += color;
  }
  // Mesa's llvmpipe ends all loops of a pixel after 65,535 rounds; sums would then be incomplete.
  int rounds = 0;
  for (int i = 0; i < min(step_limit, 2); ++i) ++rounds;
  if (rounds < min(step_limit, 2)) discard;
  fragment = vec4(sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), sum.a / float(count));
}
