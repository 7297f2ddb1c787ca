#include "curves/polyline_builder.hpp"

#include <algorithm>

#include "base/limit_error.hpp"

namespace sfumato::curves {
namespace {

constexpr std::size_t kFirstVertices = 1024;

}  // namespace

void PolylineBuilder::begin_curve() {
  if (status_.ok() && context_.cancelled()) status_ = context_.cancel_status();
  end_last_curve();
}

void PolylineBuilder::end_last_curve() {
  if (!status_.ok()) return;
  const auto next = static_cast<std::uint32_t>(flat_.vertex.size());
  status_ = memory_.push_back(context_, flat_.curve_begin, next);
}

void PolylineBuilder::push(Vec2 point, double parameter) {
  if (poll_.cancelled()) status_ = context_.cancel_status();
  if (flat_.vertex.size() == flat_.vertex.capacity()) make_room();
  if (!status_.ok()) return;
  const bool first = flat_.vertex.size() == flat_.curve_begin.back();
  const double before = first ? 0.0 : flat_.arc_length.back();
  const double step = first ? 0.0 : length(point - flat_.vertex.back());
  flat_.vertex.push_back(point);
  flat_.parameter.push_back(parameter);
  flat_.arc_length.push_back(before + step);
  flat_.vertex_curve.push_back(static_cast<std::uint32_t>(flat_.curve_begin.size() - 1));
}

void PolylineBuilder::set_bow(const ChordBow& bow) {
  if (status_)
    status_ = memory_.grow(context_, flat_.bow, flat_.vertex.size(), 2 * flat_.vertex.size());
  if (status_) flat_.bow.back() = bow;
}

void PolylineBuilder::make_room() {
  const std::size_t most = context_.limits.segments + 1;
  const std::size_t room = flat_.vertex.capacity();
  if (room >= most) {
    status_ = limit_error(context_.limits, &Limits::segments,
                          "segments after flattening; a larger tolerance makes fewer");
    return;
  }
  const std::size_t larger = std::min(std::max(2 * room, kFirstVertices), most);
  const auto reserve = [&](auto& table) {
    if (status_) status_ = memory_.reserve(context_, table, larger);
  };
  reserve(flat_.parameter);
  reserve(flat_.arc_length);
  reserve(flat_.vertex_curve);
  reserve(flat_.vertex);
}

}  // namespace sfumato::curves
