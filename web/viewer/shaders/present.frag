// The finished picture, with the lines of the overlay on top.
uniform sampler2D picture;
uniform sampler2D ink;
uniform bool turned;
uniform bool premultiplied;

out vec4 fragment;

const vec3 kCurveInk = vec3(1.0, 0.42, 0.05);
const float kFreeOpacity = 0.4;

void main() {
  ivec2 size = textureSize(picture, 0);
  ivec2 place = ivec2(gl_FragCoord.xy);
  if (turned) place.y = size.y - 1 - place.y;
  vec4 pixel = texelFetch(picture, place, 0);
  vec3 color = pixel.a > 0.0 ? pixel.rgb / pixel.a : vec3(0.0);
  vec2 share = texelFetch(ink, min(place, textureSize(ink, 0) - 1), 0).rg;
  // Free edges are black or white, for the larger contrast.
  float free_ink = dot(color, vec3(0.3, 0.6, 0.1)) < 0.5 ? 1.0 : 0.0;
  color = mix(color, vec3(free_ink), kFreeOpacity * share.r);
  color = mix(color, kCurveInk, share.g);
  float alpha = max(pixel.a, max(share.r, share.g));
  fragment = vec4(premultiplied ? alpha * color : color, alpha);
}
