// The pixels that an edge cuts become 0, and are marked in the stencil.
flat in vec2 begin;
flat in vec2 end;

out vec4 fragment;

void main() {
  vec2 from = begin - gl_FragCoord.xy, to = end - gl_FragCoord.xy, along = to - from;
  // The square and the edge are apart along x, along y, or across the edge.
  if (min(from.x, to.x) >= 0.5 || max(from.x, to.x) < -0.5) discard;
  if (min(from.y, to.y) >= 0.5 || max(from.y, to.y) < -0.5) discard;
  float across = from.x * along.y - from.y * along.x;
  if (abs(across) > 0.5 * (abs(along.x) + abs(along.y))) discard;
  fragment = vec4(0.0);
}
