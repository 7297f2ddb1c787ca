// Sets the pixels that an edge cuts to 0, and marks them in the stencil. A pixel is the half-open
// square that begins at its upper left corner, as in raster::MixedPixels.
flat in vec2 begin;
flat in vec2 end;

out vec4 fragment;

void main() {
  vec2 from = begin - gl_FragCoord.xy, to = end - gl_FragCoord.xy;
  if (min(from.y, to.y) >= 0.5 || max(from.y, to.y) < -0.5) discard;
  // Where the edge enters and leaves the row; an end of the edge that lies in the row.
  vec2 row = vec2(0.0, 1.0);
  if (from.y != to.y) row = clamp((vec2(-0.5, 0.5) - from.y) / (to.y - from.y), 0.0, 1.0);
  vec2 x = mix(vec2(from.x), vec2(to.x), row);
  if (min(x.x, x.y) >= 0.5 || max(x.x, x.y) < -0.5) discard;
  fragment = vec4(0.0);
}
