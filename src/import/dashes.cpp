#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"
#include "import/chords.hpp"
#include "import/stroke_outline.hpp"

namespace sfumato::svg_import {
namespace {

/// A share of a subpath's length: rounding makes a sum of dashes miss the end by this much. A
/// shorter dash is a dot.
constexpr double kSlack = 1e-9;
constexpr const char* kLengthsPurpose = "the lengths of a stroke";

Status too_many(const Context& context) {
  return limit_error(context.limits, &Limits::dashes, "dashes in one stroke");
}

/// Returns whether a dash lies on the beginning of a subpath whose first dash begins at `at` <= 0.
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

/// Joins the dash at the end of a closed subpath, the last, with that at its beginning.
Status join_ends(PointMeter& meter, std::size_t beginning, TableMemory& memory, Dashes& dashes) {
  std::vector<Vec2>& first = dashes.chains[beginning];
  std::vector<Vec2>& last = dashes.chains.back();
  const std::span<const Vec2> rest = std::span(first).subspan(1);
  SFUMATO_TRY(memory.append(meter.context(), rest, last));
  std::swap(first, last);
  memory.free(last);
  dashes.chains.pop_back();
  dashes.is_open.pop_back();
  return ok_status();
}

Status add_dash(PointMeter& meter, std::vector<Vec2> points, bool is_open, TableMemory& memory,
                Dashes& dashes) {
  Status status = memory.push_back(meter.context(), dashes.chains, std::move(points));
  return status ? memory.push_back(meter.context(), dashes.is_open, is_open ? 1 : 0) : status;
}

void dash_one(PointMeter& meter, const std::vector<Vec2>& chain, bool is_closed,
              const std::vector<double>& lengths, const svg::StrokeStyle& style,
              TableMemory& memory, Dashes& dashes) {
  const double total = lengths.back();
  const double period = std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
  double at = -std::fmod(style.dash_offset, period);
  if (at > 0) at -= period;
  if (!(total > 0)) {
    std::vector<Vec2> points;
    if (begins_with_dash(style, at) && meter.take(chain.size()) &&
        meter.keep(memory.append(meter.context(), chain, points))) {
      meter.keep(add_dash(meter, std::move(points), !is_closed, memory, dashes));
    }
    return;
  }
  // A dot on the end of a closed subpath is the same as the dot on its beginning.
  const std::size_t beginning = dashes.chains.size();
  bool begins = false, ends = false;  // with a dash that is no dot
  const double last_dot = is_closed ? total * (1 - kSlack) : total * (1 + kSlack);
  for (std::size_t i = 0; at < std::max(total, last_dot) && meter.take(0);
       i = (i + 1) % style.dashes.size()) {
    const double end = std::min(at + style.dashes[i], total), begin = std::max(at, 0.0);
    const bool is_dot = style.dashes[i] <= kSlack * total && at >= 0 && at <= last_dot;
    at += style.dashes[i];
    if (i % 2 == 1 || (end - begin <= kSlack * total && !is_dot)) {
      if (!(at + period > at)) break;
      continue;
    }
    if (dashes.chains.size() >= meter.context().limits.dashes) {
      return meter.fail(too_many(meter.context()));
    }
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
    // Searches twice along the curve; each search takes a millisecond if the curve turns back in
    // cusps.
    if (!meter.look() || !meter.take(points.size())) return;
    if (points.size() < 4) {
      memory.free(points);
      continue;
    }
    begins |= begin == 0 && !is_dot;
    ends = end >= total * (1 - kSlack) && !is_dot;
    const bool is_whole = is_closed && begin == 0 && ends;
    meter.keep(add_dash(meter, std::move(points), !is_whole, memory, dashes));
  }
  if (is_closed && begins && ends && dashes.chains.size() > beginning + 1 && !meter.failed()) {
    meter.keep(join_ends(meter, beginning, memory, dashes));
  }
}

/// How much longer the subpaths are than the author says; 1 where nothing is said.
Result<double> path_scale(const PointMeter& meter, const Contours& subpaths, double said) {
  if (!(said > 0)) return 1.0;
  double total = 0;
  for (const std::vector<Vec2>& chain : subpaths) {
    TableMemory memory(kLengthsPurpose);
    SFUMATO_TRY_ASSIGN(const auto& lengths,
                       curves::cumulative_length(meter.context(), chain, memory));
    total += lengths.back();
  }
  return total > 0 ? total / said : 1;
}

}  // namespace

Result<Dashes> dashed(PointMeter& meter, const Contours& subpaths,
                      const svg::StrokeStyle& said_style, TableMemory& memory) {
  SFUMATO_TRY_ASSIGN(const double scale, path_scale(meter, subpaths, said_style.path_length));
  svg::StrokeStyle style = said_style;
  style.dash_offset *= scale;
  for (double& dash : style.dashes) dash *= scale;
  Dashes dashes;
  const double period = std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
  for (std::uint32_t i = 0; i < subpaths.size(); ++i) {
    const std::vector<Vec2>& chain = subpaths[i];
    if (!meter.take((chain.size() - 1) / 3)) return meter.status();
    TableMemory length_memory(kLengthsPurpose);
    SFUMATO_TRY_ASSIGN(const auto& lengths,
                       curves::cumulative_length(meter.context(), chain, length_memory));
    // Each dash requires a search along the curve, so far too many dashes are refused at once.
    if (lengths.back() / period > static_cast<double>(meter.context().limits.dashes)) {
      return too_many(meter.context());
    }
    dash_one(meter, chain, style.is_closed(i, chain), lengths, style, memory, dashes);
    if (meter.failed()) return meter.status();
  }
  return dashes;
}

}  // namespace sfumato::svg_import
