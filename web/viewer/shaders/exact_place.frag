// The triangle that holds a pixel's centre, up to the rounding of corners. 1: no curve cuts the
// pixel (edges.frag writes 0 there).
flat in float triangle;

out vec4 fragment;

void main() {
  fragment = vec4(triangle, 1.0, 0.0, 0.0);
}
