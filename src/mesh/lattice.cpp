#include "mesh/lattice.hpp"

#include "base/try.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::mesh {
namespace {

__extension__ typedef __int128 Int128;

/// Returns the largest power of two not above `value`. Precondition: value > 0 and finite.
double power_of_two_below(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

bool in_range(Vec2 p) {
  // Callers inflate frames a little, so that frames may exceed the limit of documents.
  const double most = 4 * limits::kCoordinate;
  return std::fabs(p.x) <= most && std::fabs(p.y) <= most;
}

Status checked_box(const curves::FlatCurves& flat, const MeshOptions& options, Box& box) {
  const Box& frame = options.frame;
  if (!(frame.width() > 0 && frame.height() > 0) || !in_range(frame.min) || !in_range(frame.max)) {
    return make_error(StatusCode::bad_input, "mesh frame is empty or out of range");
  }
  if (!(options.unit_size > 0 && options.unit_size <= limits::kCoordinate) ||
      !(options.weld_px > 0 && options.weld_px <= limits::kCoordinate)) {
    return make_error(StatusCode::bad_input, "mesh unit size or weld distance is out of range");
  }
  box = frame;
  for (const Vec2 v : flat.vertex) {
    if (!in_range(v)) return make_error(StatusCode::bad_input, "curve vertex is out of range");
    box.extend(v);
  }
  if (options.room.empty()) return ok_status();
  if (!in_range(options.room.min) || !in_range(options.room.max)) {
    return make_error(StatusCode::bad_input, "mesh room is out of range");
  }
  box = united(box, options.room);
  return ok_status();
}

}  // namespace

bool in_circle_exact(Point a, Point b, Point c, Point d) {
  const std::int64_t ax = a.x - d.x, ay = a.y - d.y;
  const std::int64_t bx = b.x - d.x, by = b.y - d.y;
  const std::int64_t cx = c.x - d.x, cy = c.y - d.y;
  const Int128 determinant = Int128{ax * ax + ay * ay} * (bx * cy - cx * by) +
                             Int128{bx * bx + by * by} * (cx * ay - ax * cy) +
                             Int128{cx * cx + cy * cy} * (ax * by - bx * ay);
  return determinant > 0;
}

Result<Lattice> choose_lattice(const curves::FlatCurves& flat, const MeshOptions& options) {
  Box box;
  SFUMATO_TRY(checked_box(flat, options, box));
  const double frame_side = std::min(options.frame.width(), options.frame.height());
  const double weld = std::min(options.weld_px * options.unit_size, frame_side / 32);
  const double pad = std::max(box.width(), box.height()) / 16 + 8 * weld;
  const double side = std::max(box.width(), box.height()) + 2 * pad;
  const double farthest = std::max(
      {std::fabs(box.min.x), std::fabs(box.min.y), std::fabs(box.max.x), std::fabs(box.max.y)});

  Lattice lattice;
  double step = power_of_two_below(std::min(options.unit_size / 4096, weld / kLeastWeldSteps));
  // The padding is widened by 256 steps below: four times the least weld on each side.
  const double most_steps = std::ldexp(1.0, kLatticeBits) - 1024;
  while (side / step > most_steps || farthest / step > std::ldexp(1.0, 50)) step *= 2;
  const double steps_pad = std::floor(pad / step) + 256;
  lattice.step = step;
  lattice.inverse_step = 1 / step;
  lattice.origin = {std::floor(box.min.x / step) - steps_pad,
                    std::floor(box.min.y / step) - steps_pad};
  const auto offset = [&](double value, double origin) {
    return static_cast<std::int32_t>(value / step - origin);
  };
  lattice.width = offset(box.max.x, lattice.origin.x) + 1 + static_cast<std::int32_t>(steps_pad);
  lattice.height = offset(box.max.y, lattice.origin.y) + 1 + static_cast<std::int32_t>(steps_pad);
  lattice.frame_min = {offset(options.frame.min.x, lattice.origin.x),
                       offset(options.frame.min.y, lattice.origin.y)};
  lattice.frame_max = {offset(std::ceil(options.frame.max.x / step) * step, lattice.origin.x),
                       offset(std::ceil(options.frame.max.y / step) * step, lattice.origin.y)};
  const double weld_steps = std::max(kLeastWeldSteps, std::floor(weld / step));
  lattice.weld_squared = static_cast<std::int64_t>(weld_steps * weld_steps);
  return lattice;
}

}  // namespace sfumato::mesh
