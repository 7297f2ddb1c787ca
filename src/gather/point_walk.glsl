// The exact gather of one point by one thread: windows of directions are walked outward through the
// visibility mesh (triangular expansion), narrowed at every edge that rays pass, and integrated in
// closed form at every edge that stops them. kernels/packet_walk.hpp, edge_views.hpp and
// integrator.hpp do the same for a packet of points, and also handle far fields and free ends.
//
// One text, read as GLSL ES 3.10 (compute), GLSL ES 3.00 (fragment, WebGL 2), C++ (the twin,
// point_walk_twin.hpp) and CUDA. It has no division, square root or transcendental function of the
// hardware, whose last bits differ: where P is `precise`, all readers give the same bits.
//
// The file that includes it defines
//   FN           the specifiers before a function
//   P            `precise`, or nothing
//   STACK        how many windows may wait, a power of two
//   BLEND        1 where SceneView::blend exists, else 0
//   beyond_at, hit_at, blend_at, triangle_at
//                texel i of a table, 16 bytes as an ivec4: EdgeBeyond has 2 texels, HitEdge and
//                HitBlend 4, SceneTriangle 3 (kernels/scene_layout.hpp)
//   add_share(shader, weight)
//                adds to W_s of an image-domain shader; called where BLEND is 1
//
// The windows that wait are in a ring buffer, which never overflows: the oldest is dropped, and
// when all others are done the walk begins again at the point's triangle, right of the finished
// windows.

vec2 point;
float weight;   // W
vec4 value;     // sum of w z
int steps;      // windows that passed an edge
bool failed;    // the walk did not come to its end; the sums are of no use

FN float number(int bits) { return intBitsToFloat(bits); }

// base/lanes.hpp, bit for bit. Unsigned: differences may wrap.
FN float reciprocal(float a) {
  P float y = uintBitsToFloat(0x7EF338D3u - floatBitsToUint(a));
  P float z = y * (2.00128007f - a * y);
  P float r = z * (2.00000072f - a * z);
  return r;
}

FN float reciprocal_sqrt(float a) {
  P float y = uintBitsToFloat(0x5F1FFFF9u - uint(floatBitsToInt(a) >> 1));
  P float z = y * (1.33492804f - 0.558729529f * (a * (y * y)));
  P float r = z * (1.88988197f - a * (z * z));
  return r;
}

FN float root(float a) {
  P float r = a * reciprocal_sqrt(a);
  return r;
}

// Closed form: kernels/closed_form.hpp.
FN float h1_of_cosine(float c) {
  P float c2 = c * c;
  P float even = ((0.375298610f * c2 + 1.18969841f) * c2 + 1.17074506f) * c2 + 0.785395477f;
  P float odd = ((-0.0760769620f * c2 + -0.841909030f) * c2 + -1.27015964f) * c2 + -0.999659733f;
  P float r = odd * c + even;
  return r;
}

float part_weight;  // of what set_part() was told
float part_lean;

FN void set_part(vec2 q1, vec2 q2, float cross_q, float length_squared) {
  P float r1_squared = q1.x * q1.x + q1.y * q1.y;
  P float r2_squared = q2.x * q2.x + q2.y * q2.y;
  P float product = r1_squared * r2_squared;
  float u1u2 = min(reciprocal_sqrt(product), 1e7f);
  P float s_far = cross_q * u1u2;
  float s = max(s_far, 0.0f);
  P float c = (q1.x * q2.x + q1.y * q2.y) * u1u2;
  float h1 = h1_of_cosine(c);
  if (c < 0.0f) {
    P float s_near = (q1.x * q2.y - q1.y * q2.x) * u1u2;
    float s_direct = max(s_near, 1e-4f);
    float rest = h1_of_cosine(min(abs(c), 1.0f));
    P float cube = s_direct * s_direct * s_direct;
    P float h1_direct = 1.57079633f * reciprocal(cube) - rest;
    s = s_direct;
    h1 = h1_direct;
  }
  P float both = u1u2 * s;
  P float steep = h1 * u1u2;
  P float w = both + both * (steep * length_squared);
  P float lean = both * (steep * (r1_squared - r2_squared));
  part_weight = w;
  part_lean = lean;
}

FN void add_value(float w, float lean, vec4 middle, vec4 half_change) {
  P float x = w * middle.x + lean * half_change.x;
  P float y = w * middle.y + lean * half_change.y;
  P float z = w * middle.z + lean * half_change.z;
  P float a = w * middle.w + lean * half_change.w;
  P float sum_x = value.x + x;
  P float sum_y = value.y + y;
  P float sum_z = value.z + z;
  P float sum_a = value.w + a;
  value = vec4(sum_x, sum_y, sum_z, sum_a);
}

// Returns where the line through a along e is parallel to a ray, as a share of e.
FN float cut(vec2 a, vec2 e, vec2 ray) {
  P float across = a.y * ray.x - a.x * ray.y;
  P float slope = e.x * ray.y - e.y * ray.x;
  P float t = across * reciprocal(slope);
  return min(max(t, 0.0f), 1.0f);
}

#if BLEND

float back_weight;  // what of a part's weight goes to the side behind it: eq. 11
float back_lean;

// Uses one radius for the whole part: kernels/integrator.hpp, back_of_even().
FN void set_back_of_even(float w, float lean, float radius_middle, float radius_change,
                         float distance) {
  P float quotient = lean * reciprocal(w);
  float mean = w > 0.0f ? quotient : 0.0f;
  P float radius = radius_middle + radius_change * mean;
  float back = 0.0f;
  if (radius > distance) {
    P float x = 0.5f + 0.5f * distance * reciprocal(radius);
    P float rest = 1.0f - x * x * (3.0f - 2.0f * x);
    back = rest;
  }
  P float of_weight = w * back;
  P float of_lean = lean * back;
  back_weight = of_weight;
  back_lean = of_lean;
}

// kernels/blur_kernel.hpp: 2 x^2 - 1 of Gauss's six nodes x in [0, 1], and their weights times x.
FN vec2 blur_node(int i) {
  return i == 0   ? vec2(-0.997719817f, 0.0057848131f)
         : i == 1 ? vec2(-0.94261046f, 0.0611113173f)
         : i == 2 ? vec2(-0.710149628f, 0.178130346f)
         : i == 3 ? vec2(-0.232911256f, 0.289783588f)
         : i == 4 ? vec2(0.379808313f, 0.299650256f)
                  : vec2(0.867219212f, 0.165539679f);
}

// Computes means over a part of 1 - beta, and of (1 - beta) T, like back_means() there.
FN vec2 back_means(float near_length, float far_length, float cosine, float near_radius,
                   float far_radius, float distance) {
  float c = min(max(cosine, -1.0f), 1.0f);
  P float edge = 2.0f + root(2.0f + 2.0f * c);
  P float square = edge * edge;
  P float k = (2.0f - 2.0f * c) * reciprocal(square);
  P float total = 0.0f;
  P float back = 0.0f;
  P float moment = 0.0f;
  for (int i = 0; i < 6; ++i) {
    vec2 node = blur_node(i);
    P float k_tau = k * node.x;
    P float a = far_length * ((1.0f - node.x) * (1.0f + k_tau));
    P float b = near_length * ((1.0f + node.x) * (1.0f - k_tau));
    P float both = a + b;
    P float stretch = 1.0f + k_tau * node.x;
    P float cube = stretch * stretch * stretch;
    P float per_length = node.y * both * reciprocal(cube);
    P float reach = near_radius * a + far_radius * b;
    P float share = distance * both * reciprocal(reach);
    float y = min(share, 1.0f);
    P float behind = 0.25f * ((1.0f - y) * (1.0f - y) * (2.0f + y));
    total = total + per_length * both;
    back = back + per_length * both * behind;
    moment = moment + per_length * b * behind;
  }
  P float per_total = reciprocal(total);
  P float mean_share = back * per_total;
  P float mean_moment = moment * per_total;
  return vec2(mean_share, mean_moment);
}

// Integrates where the radius varies along the part from t1 to t2: kernels/integrator.hpp,
// back_of_growing().
FN void set_back_of_growing(vec2 a, vec2 b, vec2 e, float area, float length_squared, float part1,
                            float part2, float radius_middle, float radius_change,
                            float distance) {
  back_weight = 0.0f;
  back_lean = 0.0f;
  bool grows = radius_change > 0.0f;
  P float radius_a = radius_middle - radius_change;
  P float change = 2.0f * radius_change;
  P float twice = 2.0f * abs(radius_change);
  P float per_change = grows ? reciprocal(twice) : -reciprocal(twice);
  P float reached = (distance - radius_a) * per_change;
  float t1 = grows ? max(part1, reached) : part1;
  float t2 = grows ? part2 : min(part2, reached);
  if (!(t1 < t2)) {
    return;
  }
  P float share = t2 - t1;
  P float q1_x = a.x + t1 * e.x;
  P float q1_y = a.y + t1 * e.y;
  P float cut_x = a.x + t2 * e.x;
  P float cut_y = a.y + t2 * e.y;
  vec2 q1 = vec2(q1_x, q1_y);
  vec2 q2 = t2 == 1.0f ? b : vec2(cut_x, cut_y);
  P float cross_q = area * share;
  P float part_squared = length_squared * (share * share);
  set_part(q1, q2, cross_q, part_squared);
  P float squared1 = q1.x * q1.x + q1.y * q1.y;
  P float squared2 = q2.x * q2.x + q2.y * q2.y;
  float length1 = root(squared1);
  float length2 = root(squared2);
  P float lengths = length1 * length2;
  P float cosine = (q1.x * q2.x + q1.y * q2.y) * reciprocal(lengths);
  P float radius1 = radius_a + change * t1;
  P float radius2 = radius_a + change * t2;
  vec2 mean = back_means(grows ? length1 : length2, grows ? length2 : length1, cosine,
                         grows ? radius1 : radius2, grows ? radius2 : radius1, distance);
  P float place = (2.0f * (grows ? t1 : t2) - 1.0f) * mean.x +
                  (grows ? 2.0f : -2.0f) * (share * mean.y);
  P float of_weight = part_weight * mean.x;
  P float of_lean = part_weight * place;
  back_weight = of_weight;
  back_lean = of_lean;
}

FN void add_side(int shader, float w, float lean, float k, vec4 middle, vec4 half_change) {
  if (shader >= 0) {
    P float share = w * k;
    add_share(shader, share);
  } else {
    add_value(w, lean, middle, half_change);
  }
}

#endif

// Adds the part of a HitEdge that is seen between two rays. whole_right: its right end is seen, not
// cut off.
FN void integrate(int hit, vec2 right, vec2 left, bool whole_right, bool whole_left) {
  ivec4 ends = hit_at(4 * hit);
  ivec4 line = hit_at(4 * hit + 1);
  P float ax = number(ends.x) - point.x;
  P float ay = number(ends.y) - point.y;
  P float bx = number(ends.z) - point.x;
  P float by = number(ends.w) - point.y;
  vec2 a = vec2(ax, ay);
  vec2 b = vec2(bx, by);
  vec2 e = vec2(number(line.x), number(line.y));
  P float area = a.x * e.y - a.y * e.x;
  float t1 = whole_right ? 0.0f : cut(a, e, right);
  float t2 = whole_left ? 1.0f : cut(a, e, left);
  P float q1_x = a.x + t1 * e.x;
  P float q1_y = a.y + t1 * e.y;
  P float cut_x = a.x + t2 * e.x;
  P float cut_y = a.y + t2 * e.y;
  vec2 q2 = whole_left ? b : vec2(cut_x, cut_y);
  P float share = t2 - t1;
  P float cross_q = area * share;
  float length_squared = number(line.z);
  P float part_squared = length_squared * (share * share);
  set_part(vec2(q1_x, q1_y), q2, cross_q, part_squared);
  float w = part_weight;
  P float lean = w * (t1 + t2 - 1.0f) + part_lean * share;
  float k = number(line.w);
  P float more = w * k;
  P float sum = weight + more;
  weight = sum;
  ivec4 m = hit_at(4 * hit + 2);
  ivec4 h = hit_at(4 * hit + 3);
  vec4 middle = vec4(number(m.x), number(m.y), number(m.z), number(m.w));
  vec4 half_change = vec4(number(h.x), number(h.y), number(h.z), number(h.w));
#if BLEND
  ivec4 blur = blend_at(4 * hit);
  float radius_middle = number(blur.y);
  float radius_change = number(blur.z);
  P float across = area * number(blur.x);
  float distance = max(across, 0.0f);
  P float widest = radius_middle + abs(radius_change);
  if (!(distance < widest)) {
    add_side(blur.w, w, lean, k, middle, half_change);
    return;
  }
  P float even = 0.03125f * radius_middle;  // kEvenChange
  if (abs(radius_change) <= even) {
    set_back_of_even(w, lean, radius_middle, radius_change, distance);
  } else {
    set_back_of_growing(a, b, e, area, length_squared, t1, t2, radius_middle, radius_change,
                        distance);
  }
  P float front_weight = w - back_weight;
  P float front_lean = lean - back_lean;
  add_side(blur.w, front_weight, front_lean, k, middle, half_change);
  ivec4 b1 = blend_at(4 * hit + 1);
  ivec4 b2 = blend_at(4 * hit + 2);
  ivec4 b3 = blend_at(4 * hit + 3);
  add_side(b1.x, back_weight, back_lean, k,
           vec4(number(b1.y), number(b1.z), number(b1.w), number(b2.x)),
           vec4(number(b2.y), number(b2.z), number(b2.w), number(b3.x)));
#else
  add_value(w, lean, middle, half_change);
#endif
}

// Returns whether the part seen through an edge weighs less than `least`: nothing behind it is
// nearer than the edge's line, at distance d, so that an angle D weighs at most D / d^2.
FN bool is_negligible(ivec4 line, vec2 right, vec2 left, float least) {
  P float d = number(line.x) * point.x + (number(line.y) * point.y + number(line.z));
  P float sine = right.x * left.y - right.y * left.x;
  P float cosine = right.x * left.x + right.y * left.y;
  P float bound = least * (d * d) * cosine;
  return abs(sine) < bound;
}

// Sets weight, value, steps and failed.
//   at           a point of the triangle
//   negligible   the share of the weight so far below which a window is not followed (kPointNegligible)
//   step_limit   steps after which the walk has failed
FN void gather(vec2 at, int triangle, float negligible, int step_limit) {
  point = at;
  weight = 0.0f;
  value = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  steps = 0;
  // The waiting windows lie left of an apex: their right rays point to it.
  vec4 ring_rays[STACK];  // right, left
  int ring_edge[STACK];   // 2 edge + (1 if the left end of the edge is seen)
  ring_edge[0] = 0;       // compilers cannot see that none is read before it is set
  int ring_begin = 0;
  int ring_size = 0;
  bool has_forgotten = false;
  bool catches_up = false;  // all that is met was met before
  bool has_window = false;
  int corner = 0;  // the next window leaves the triangle from this corner to the one after it
  int edge = 0;
  int first_edge = 0;  // of the triangle, and its left ray
  vec2 first_left = vec2(0.0f, 0.0f);
  vec2 right = first_left;
  vec2 left = first_left;
  bool whole_right = false;
  bool whole_left = false;
  ivec4 t0 = triangle_at(3 * triangle);
  ivec4 t1 = triangle_at(3 * triangle + 1);
  ivec4 t2 = triangle_at(3 * triangle + 2);
  for (;;) {
    if (!has_window) {
      if (ring_size > 0) {
        --ring_size;
        int slot = (ring_begin + ring_size) & (STACK - 1);
        vec4 rays = ring_rays[slot];
        right = vec2(rays.x, rays.y);
        left = vec2(rays.z, rays.w);
        edge = ring_edge[slot] >> 1;
        whole_right = true;
        whole_left = (ring_edge[slot] & 1) != 0;
        catches_up = false;
      } else if (has_forgotten) {
        // Windows are finished from right to left: all right of the last one's left ray is done.
        right = left;
        left = first_left;
        edge = first_edge;
        whole_right = false;
        whole_left = true;
        has_forgotten = false;
        catches_up = true;
      } else {
        if (corner == 3) {
          break;
        }
        int right_x = corner == 0 ? t0.x : corner == 1 ? t0.y : t0.z;
        int right_y = corner == 0 ? t0.w : corner == 1 ? t1.x : t1.y;
        int left_x = corner == 0 ? t0.y : corner == 1 ? t0.z : t0.x;
        int left_y = corner == 0 ? t1.x : corner == 1 ? t1.y : t0.w;
        edge = corner == 0 ? t1.z : corner == 1 ? t1.w : t2.x;
        ++corner;
        P float rx = number(right_x) - point.x;
        P float ry = number(right_y) - point.y;
        P float lx = number(left_x) - point.x;
        P float ly = number(left_y) - point.y;
        right = vec2(rx, ry);
        left = vec2(lx, ly);
        first_left = left;
        first_edge = edge;
        whole_right = true;
        whole_left = true;
        catches_up = false;
        if (edge < 0) {
          if (edge != -1) {
            integrate(-2 - edge, right, left, true, true);
          }
          continue;
        }
      }
      has_window = true;
    }
    ++steps;
    if (steps > step_limit) {
      break;
    }
    // At every second step, because the test costs as much as the step.
    if ((steps & 1) == 0 && !catches_up) {
      P float least = negligible * weight;
      if (is_negligible(beyond_at(2 * edge + 1), right, left, least)) {
        has_window = false;
        continue;
      }
    }
    ivec4 beyond = beyond_at(2 * edge);
    P float apex_x = number(beyond.x) - point.x;
    P float apex_y = number(beyond.y) - point.y;
    P float right_cross1 = right.x * apex_y;
    P float right_cross2 = right.y * apex_x;
    P float left_cross1 = apex_x * left.y;
    P float left_cross2 = apex_y * left.x;
    vec2 apex = vec2(apex_x, apex_y);
    bool turns_right = right_cross1 > right_cross2;
    bool turns_left = left_cross1 > left_cross2;
    vec2 left_of_right = turns_left ? apex : left;
    vec2 right_of_left = turns_right ? apex : right;
    if (!catches_up) {
      if (turns_right && beyond.z < -1) {
        integrate(-2 - beyond.z, right, left_of_right, whole_right, turns_left);
      }
      if (turns_left && beyond.w < -1) {
        integrate(-2 - beyond.w, right_of_left, left, turns_right, whole_left);
      }
    }
    bool goes_right = turns_right && beyond.z >= 0;
    bool goes_left = turns_left && beyond.w >= 0;
    if (goes_right) {
      if (goes_left) {
        if (ring_size == STACK) {
          has_forgotten = true;
          ring_begin = (ring_begin + 1) & (STACK - 1);
          --ring_size;
        }
        int slot = (ring_begin + ring_size) & (STACK - 1);
        ring_rays[slot] = vec4(apex.x, apex.y, left.x, left.y);
        ring_edge[slot] = 2 * beyond.w + (whole_left ? 1 : 0);
        ++ring_size;
      }
      left = left_of_right;
      whole_left = turns_left;
      edge = beyond.z;
    } else if (goes_left) {
      // The dropped windows began at this very apex; or the walk keeps to the right of it.
      bool is_there = apex.x == right.x && apex.y == right.y;
      catches_up = catches_up && !is_there && !turns_right;
      right = right_of_left;
      whole_right = turns_right;
      edge = beyond.w;
    } else {
      has_window = false;
    }
  }
  // Decided by the final state, since drivers may end a loop without an error (Mesa's llvmpipe
  // after 65,535 rounds).
  failed = steps > step_limit || has_window || has_forgotten || ring_size > 0 || corner < 3;
}
