void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= point_count) {
    return;
  }
  int first = numbers_of_point * i;
  first_share = first + 5;
  for (int k = first_share; k < first + numbers_of_point; ++k) {
    results[k] = 0.0;
  }
  gather(vec2(points[i].x, points[i].y), points[i].triangle, negligible_share, step_limit);
  results[first] = failed ? -1.0 : weight;
  results[first + 1] = value.x;
  results[first + 2] = value.y;
  results[first + 3] = value.z;
  results[first + 4] = value.w;
}
