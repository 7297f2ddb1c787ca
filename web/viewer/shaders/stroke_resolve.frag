// Converts the sums of a local curve to colour and opacity: Z, and min(1, alpha W) (paper eq. 14).
uniform sampler2D sums;
uniform int interpolation;
uniform float alpha;

out vec4 fragment;

void main() {
  vec4 sum = texelFetch(sums, ivec2(gl_FragCoord.xy), 0);
  float opacity = min(alpha * sum.a, 1.0);
  fragment = vec4(opacity * clamped_code(interpolation, sum.rgb / max(sum.a, 1e-30)), opacity);
}
