// The contribution of a node to W Z and W (paper eq. 12 to 16).
uniform mat2 frame_from_pixel;
uniform bool two_sided;

flat in vec2 node_pixel;
flat in float inverse_radius_squared;
flat in float node_weight;
flat in vec2 tangent;
flat in float blur_squared;
flat in float turn;
flat in vec3 right_color;
flat in vec3 difference;

out vec4 fragment;

/// Returns the left side's share at d from the node.
float beta(vec2 d) {
  float across = tangent.y * d.x - tangent.x * d.y, along = dot(tangent, d);
  float u = 0.5 + 0.5 * across * inversesqrt(blur_squared + turn * along * along);
  return smoothstep(0.0, 1.0, u);
}

void main() {
  vec2 d = frame_from_pixel * (gl_FragCoord.xy - node_pixel);
  float q = min(dot(d, d) * inverse_radius_squared, 1.0);
  float w = (1.0 - q * (3.0 - 2.0 * sqrt(q))) * node_weight;
  vec3 color = right_color;
  if (two_sided) color += beta(d) * difference;
  fragment = vec4(w * color, w);
}
