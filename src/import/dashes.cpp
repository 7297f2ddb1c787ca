#include <algorithm>
#include <cmath>
#include <numeric>

#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"
#include "import/stroke_outline.hpp"

namespace sfumato::svg_import {
namespace {

constexpr std::size_t kDashes = 20'000;

/// The stretch of a chain between two parameters.
std::vector<Vec2> stretch(const std::vector<Vec2>& chain, double begin, double end) {
  std::vector<Vec2> points;
  const std::size_t count = (chain.size() - 1) / 3;
  for (double low = begin; low < end;) {
    const auto i = std::min(static_cast<std::size_t>(low), count - 1);
    const auto base = static_cast<double>(i);
    const double high = std::min(end, base + 1);
    const curves::Cubic part = curves::subcurve(curves::piece(chain, i), low - base, high - base);
    if (points.empty()) points.push_back(part[0]);
    points.insert(points.end(), part.begin() + 1, part.end());
    low = high;
  }
  return points;
}

Status dash_one(const std::vector<Vec2>& chain, const StrokeStyle& style, Contours& dashes) {
  const std::vector<double> lengths = curves::cumulative_length(chain);
  const double total = lengths.back();
  const double period = std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
  if (!(total > 0)) return ok_status();
  double at = -std::fmod(style.dash_offset, period);
  if (at > 0) at -= period;
  for (std::size_t i = 0; at < total; i = (i + 1) % style.dashes.size()) {
    const double end = std::min(at + style.dashes[i], total), begin = std::max(at, 0.0);
    at += style.dashes[i];
    if (i % 2 == 1 || end <= begin) {
      if (!(at + period > at)) break;
      continue;
    }
    if (dashes.size() >= kDashes) {
      return make_error(StatusCode::limit, "more than 20000 dashes in one stroke");
    }
    const auto parameter = [&](double distance) {
      return curves::parameter_at_fraction(chain, lengths, distance / total);
    };
    std::vector<Vec2> points = stretch(chain, parameter(begin), parameter(end));
    if (points.size() >= 4) dashes.push_back(std::move(points));
  }
  return ok_status();
}

}  // namespace

Result<Contours> dashed(const Context& context, const Contours& subpaths,
                        const StrokeStyle& style) {
  Contours dashes;
  // A dash costs a search along the curve: what would be far too many is refused at once.
  const double period = std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
  for (const std::vector<Vec2>& chain : subpaths) {
    if (context.cancelled()) return context.stop_status();
    if (curves::cumulative_length(chain).back() / period > kDashes) {
      return make_error(StatusCode::limit, "more than 20000 dashes in one stroke");
    }
    if (Status status = dash_one(chain, style, dashes); !status) return status;
  }
  return dashes;
}

}  // namespace sfumato::svg_import
