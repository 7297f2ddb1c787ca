// The nodes of a local curve's segments, sixteen instances per segment, each a quad as large as the
// node's reach. It follows curves::StrokeSegment and raster/kernels/local_stroke_isa.cpp.
uniform sampler2D stroke_segment;
uniform int first_segment;
uniform vec3 pixel_from_frame[2];
uniform mat2 frame_from_pixel;
uniform vec2 target_size;
uniform float smallest_radius;

flat out vec2 node_pixel;
flat out float inverse_radius_squared;
flat out float node_weight;
flat out vec2 tangent;
flat out float blur_squared;
flat out float turn;
flat out vec3 right_color;
flat out vec3 difference;

// A pixel's square, and the distances that a node stands for, as blur: docs/mathematics.md.
const float kPixelVariance = 5.0 / 12.0;
const float kRangeVariance = 5.0 / 3.0;

void main() {
  int at = 7 * (first_segment + gl_InstanceID / 16);
  vec4 s[7];
  for (int i = 0; i < 7; ++i) s[i] = table_value(stroke_segment, at + i);
  float step = float(gl_InstanceID % 16) + 0.5, count = s[2].y;
  float u = step / count;

  vec2 c1 = s[0].zw, c2 = s[1].xy, c3 = s[1].zw;
  vec2 position = s[0].xy + u * (c1 + u * (c2 + u * c3));
  vec2 speed = c1 + u * (2.0 * c2 + 3.0 * u * c3);
  vec2 bend = 2.0 * c2 + 6.0 * u * c3;
  float squared = max(dot(speed, speed), 1e-30);
  float influence = mix(s[2].z, s[2].w, u);
  float radius = max(influence, smallest_radius);
  inverse_radius_squared = 1.0 / (radius * radius);
  // A stroke thinner than a pixel is drawn one pixel wide, and fainter by the same factor.
  node_weight = sqrt(squared) * s[2].x * influence * inverse_radius_squared;

  tangent = speed * inversesqrt(squared);
  vec2 normal = vec2(tangent.y, -tangent.x);
  // The components of the normal along the pixel's edges.
  vec2 edge = normal * frame_from_pixel;
  float blur = mix(s[3].x, s[3].y, u);
  blur_squared = blur * blur + kPixelVariance * dot(edge, edge);
  float angle = (speed.x * bend.y - speed.y * bend.x) / (squared * count);
  turn = 0.25 * kRangeVariance * angle * angle;

  vec3 left = mix(vec3(s[3].zw, s[4].x), s[4].yzw, u);
  right_color = mix(s[5].xyz, vec3(s[5].w, s[6].xy), u);
  difference = left - right_color;

  node_pixel = mapped(pixel_from_frame, position);
  vec2 reach = radius * vec2(length(pixel_from_frame[0].xy), length(pixel_from_frame[1].xy));
  int corner = gl_VertexID % 6;
  vec2 side = vec2(corner == 1 || corner == 3 || corner == 4 ? 1.0 : -1.0,
                   corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0);
  vec2 p = node_pixel + side * (reach + 0.01);
  bool drawn = step < count && node_weight > 0.0;
  gl_Position = vec4(drawn ? 2.0 * p / target_size - 1.0 : vec2(2.0), 0.0, 1.0);
}
