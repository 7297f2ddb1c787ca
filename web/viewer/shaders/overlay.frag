// The share of ink of an edge's line, from the distance to the pixel's centre.
flat in vec2 begin;
flat in vec2 end;
flat in float half_width;
flat in int is_curve;

out vec4 fragment;

void main() {
  vec2 along = end - begin;
  float square = dot(along, along);
  vec2 d = gl_FragCoord.xy - begin;
  float t = square > 0.0 ? clamp(dot(d, along) / square, 0.0, 1.0) : 0.0;
  float share = clamp(half_width + 0.5 - length(d - t * along), 0.0, 1.0);
  fragment = is_curve != 0 ? vec4(0.0, share, 0.0, 0.0) : vec4(share, 0.0, 0.0, 0.0);
}
