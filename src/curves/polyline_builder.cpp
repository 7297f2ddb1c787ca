#include "curves/polyline_builder.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/charge.hpp"
#include "base/limit_error.hpp"

namespace sfumato::curves {
namespace {

constexpr std::size_t kBytesPerVertex = sizeof(Vec2) + 2 * sizeof(double) + sizeof(std::uint32_t);
constexpr std::size_t kFirstVertices = 1024;

}  // namespace

void PolylineBuilder::begin_curve() {
  if (status_.ok() && context_.cancelled()) status_ = context_.cancel_status();
  flat_.curve_begin.push_back(static_cast<std::uint32_t>(flat_.vertex.size()));
}

void PolylineBuilder::end_last_curve() {
  flat_.curve_begin.push_back(static_cast<std::uint32_t>(flat_.vertex.size()));
}

void PolylineBuilder::push(Vec2 point, double parameter) {
  if (poll_.cancelled()) status_ = context_.cancel_status();
  if (flat_.vertex.size() == room_) make_room();
  if (!status_.ok()) return;
  const bool first = flat_.vertex.size() == flat_.curve_begin.back();
  const double before = first ? 0.0 : flat_.arc_length.back();
  const double step = first ? 0.0 : length(point - flat_.vertex.back());
  flat_.vertex.push_back(point);
  flat_.parameter.push_back(parameter);
  flat_.arc_length.push_back(before + step);
  flat_.vertex_curve.push_back(static_cast<std::uint32_t>(flat_.curve_begin.size() - 1));
}

/// Doubles the tables, charged before; old and new are there while one moves to the other.
void PolylineBuilder::make_room() {
  const std::size_t most = context_.limits.segments + 1;
  if (room_ >= most) {
    status_ = limit_error(context_.limits, &Limits::segments,
                          "segments after flattening; a larger tolerance makes fewer");
    return;
  }
  const std::size_t larger = std::min(std::max(2 * room_, kFirstVertices), most);
  ScopedCharge charge;
  status_ = charge.add(context_, larger * kBytesPerVertex, "flattening");
  if (!status_) return;
  flat_.vertex.reserve(larger);
  flat_.parameter.reserve(larger);
  flat_.arc_length.reserve(larger);
  flat_.vertex_curve.reserve(larger);
  room_ = larger;
  charge_ = std::move(charge);
}

}  // namespace sfumato::curves
