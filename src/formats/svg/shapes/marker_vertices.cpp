#include "formats/svg/shapes/marker_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::svg {
namespace {

/// A bound for the sum of two unit vectors: a shorter sum means opposite directions.
constexpr double kNoTurn = 1e-9;

/// Without overflow or underflow.
Vec2 unit_vector(Vec2 v) {
  const Vec2 scaled = v / std::max(std::abs(v.x), std::abs(v.y));
  return scaled / length(scaled);
}

/// Returns the direction half-way between two unit vectors. For opposite vectors it is a quarter
/// turn counterclockwise on the screen from the first one, as in Chromium.
Vec2 half_way(Vec2 in, Vec2 out) {
  const Vec2 sum = in + out;
  return length(sum) > kNoTurn ? unit_vector(sum) : Vec2{in.y, -in.x};
}

/// The direction at the ends of a segment; null vectors where it has no length.
struct EndDirections {
  Vec2 begin;
  Vec2 end;
};

EndDirections directions_of(std::span<const Vec2> points) {
  const auto is_not = [](Vec2 from) { return [from](Vec2 point) { return !(point == from); }; };
  const auto next = std::ranges::find_if(points, is_not(points.front()));
  if (next == points.end()) return {};
  const auto last = std::find_if(points.rbegin(), points.rend(), is_not(points.back()));
  return {unit_vector(*next - points.front()), unit_vector(points.back() - *last)};
}

/// A segment of no length takes the direction before it, else the one after it, else that of x.
void fill_directions(std::vector<EndDirections>& segments) {
  const auto has_length = [](const EndDirections& each) { return !(each.begin == Vec2{}); };
  const auto first = std::ranges::find_if(segments, has_length);
  Vec2 direction = first == segments.end() ? Vec2{1, 0} : first->begin;
  for (EndDirections& segment : segments) {
    if (!has_length(segment)) segment = {direction, direction};
    direction = segment.end;
  }
}

class VertexReader {
 public:
  VertexReader(const Context& context, TableMemory& memory)
      : context_(context), memory_(memory), poll_(context) {}

  Status add(const Subpath& subpath);
  std::vector<MarkerVertex> take() { return std::move(vertices_); }

 private:
  Status read_segments(const Subpath& subpath);

  const Context& context_;
  TableMemory& memory_;
  RarePoll<16384> poll_;
  std::vector<EndDirections> segments_;  ///< of one subpath
  std::vector<MarkerVertex> vertices_;
};

Status VertexReader::read_segments(const Subpath& subpath) {
  segments_.clear();
  SFUMATO_TRY(memory_.make_room(context_, segments_, subpath.segment_begin.size()));
  const std::span<const Vec2> points = subpath.control_points;
  for (std::size_t i = 0; i + 1 < subpath.segment_begin.size(); ++i) {
    if (poll_.cancelled()) return context_.cancel_status();
    const std::size_t begin = 3 * std::size_t{subpath.segment_begin[i]};
    const std::size_t end = 3 * std::size_t{subpath.segment_begin[i + 1]};
    segments_.push_back(directions_of(points.subspan(begin, end - begin + 1)));
  }
  if (subpath.closes_on_itself) segments_.push_back({});
  fill_directions(segments_);
  return ok_status();
}

Status VertexReader::add(const Subpath& subpath) {
  SFUMATO_TRY(read_segments(subpath));
  SFUMATO_TRY(memory_.make_room(context_, vertices_, segments_.size() + 1));
  const std::vector<Vec2>& points = subpath.control_points;
  const Vec2 around = half_way(segments_.back().end, segments_.front().begin);
  const bool is_closed = subpath.is_closed;
  vertices_.push_back({points.front(), is_closed ? around : segments_.front().begin});
  for (std::size_t i = 1; i < segments_.size(); ++i) {
    vertices_.push_back({points[3 * std::size_t{subpath.segment_begin[i]}],
                         half_way(segments_[i - 1].end, segments_[i].begin)});
  }
  vertices_.push_back({points.back(), is_closed ? around : segments_.back().end});
  return ok_status();
}

}  // namespace

Result<std::vector<MarkerVertex>> marker_vertices(const Context& context,
                                                  std::span<const Subpath> subpaths,
                                                  TableMemory& memory) {
  VertexReader reader(context, memory);
  for (const Subpath& subpath : subpaths) {
    SFUMATO_TRY(reader.add(subpath));
  }
  return reader.take();
}

}  // namespace sfumato::svg
