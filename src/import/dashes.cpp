#include <algorithm>
#include <cmath>
#include <numeric>

#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"
#include "import/chords.hpp"
#include "import/stroke_outline.hpp"

namespace sfumato::svg_import {
namespace {

constexpr std::size_t kDashes = 20'000;
/// Of a subpath's length: by so much a sum of dashes misses its end by rounding; a dash is a dot.
constexpr double kSlack = 1e-9;

Status too_many() {
  return make_error(StatusCode::limit, "more than 20000 dashes in one stroke");
}

/// Whether a dash lies on the beginning of a subpath whose first dash begins at `at` <= 0.
bool begins_with_dash(const svg::StrokeStyle& style, double at) {
  for (std::size_t i = 0; i < style.dashes.size() && at <= 0; ++i) {
    const double end = at + style.dashes[i];
    if (end > 0 || (end == 0 && at == 0)) return i % 2 == 0;
    at = end;
  }
  return false;
}

std::vector<Vec2> dot_at(const std::vector<Vec2>& chain, double parameter,
                         const svg::StrokeStyle& style) {
  const std::size_t last = (chain.size() - 1) / 3 - 1;
  const std::size_t i = std::min(static_cast<std::size_t>(parameter), last);
  const curves::Cubic cubic = curves::piece(chain, i);
  const double t = parameter - static_cast<double>(i);
  return dot(curves::point_at(cubic, t), tangent_at(cubic, t), style);
}

void dash_one(PointMeter& meter, const std::vector<Vec2>& chain, const std::vector<double>& lengths,
              const svg::StrokeStyle& style, TableMemory& memory, Contours& dashes) {
  const double total = lengths.back();
  const double period = std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
  double at = -std::fmod(style.dash_offset, period);
  if (at > 0) at -= period;
  if (!(total > 0)) {
    std::vector<Vec2> points;
    if (begins_with_dash(style, at) && meter.take(chain.size()) &&
        meter.keep(memory.append(meter.context(), chain, points))) {
      meter.keep(memory.push_back(meter.context(), dashes, std::move(points)));
    }
    return;
  }
  // A dot on the end of a closed subpath is that on its beginning.
  const double last_dot =
      chain.front() == chain.back() ? total * (1 - kSlack) : total * (1 + kSlack);
  for (std::size_t i = 0; at < std::max(total, last_dot) && meter.take(0);
       i = (i + 1) % style.dashes.size()) {
    const double end = std::min(at + style.dashes[i], total), begin = std::max(at, 0.0);
    const bool is_dot = style.dashes[i] <= kSlack * total && at >= 0 && at <= last_dot;
    at += style.dashes[i];
    if (i % 2 == 1 || (end - begin <= kSlack * total && !is_dot)) {
      if (!(at + period > at)) break;
      continue;
    }
    if (dashes.size() >= kDashes) return meter.fail(too_many());
    const auto parameter = [&](double distance) {
      return curves::parameter_at_fraction(chain, lengths, distance / total);
    };
    std::vector<Vec2> points;
    Status status;
    if (is_dot) {
      status = memory.append(meter.context(), dot_at(chain, parameter(begin), style), points);
    } else {
      status =
          append_stretch(meter.context(), chain, parameter(begin), parameter(end), memory, points);
    }
    if (!meter.keep(std::move(status))) return;
    // Two searches along the curve, each of a millisecond where it turns back in cusps.
    if (!meter.look() || !meter.take(points.size())) return;
    if (points.size() < 4) {
      memory.free(points);
    } else {
      meter.keep(memory.push_back(meter.context(), dashes, std::move(points)));
    }
  }
}

}  // namespace

Result<Contours> dashed(PointMeter& meter, const Contours& subpaths, const svg::StrokeStyle& style,
                        TableMemory& memory) {
  Contours dashes;
  const double period = std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
  for (const std::vector<Vec2>& chain : subpaths) {
    if (!meter.take((chain.size() - 1) / 3)) return meter.status();
    TableMemory length_memory("the lengths of a stroke");
    const auto lengths = curves::cumulative_length(meter.context(), chain, length_memory);
    if (!lengths) return lengths.status();
    // A dash costs a search along the curve: what would be far too many is refused at once.
    if (lengths->back() / period > kDashes) return too_many();
    dash_one(meter, chain, *lengths, style, memory, dashes);
    if (meter.failed()) return meter.status();
  }
  return dashes;
}

}  // namespace sfumato::svg_import
