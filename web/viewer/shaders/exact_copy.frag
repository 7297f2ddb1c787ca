// Replaces pixels by the exact pixels that have been gathered.
uniform sampler2D exact;

out vec4 fragment;

void main() {
  vec4 pixel = texelFetch(exact, ivec2(gl_FragCoord.xy), 0);
  if (pixel.a < 0.0) discard;
  fragment = vec4(pixel.a * pixel.rgb, pixel.a);
}
