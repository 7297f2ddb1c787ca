#include "import/edge_loops.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <tuple>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::svg_import {
namespace {

class Linker {
 public:
  Linker(Context& context, BoundaryEdges& edges) : context_(context), edges_(edges) {}

  Result<EdgeLoops> run();

 private:
  Status sort_edges();
  Status order_begins();
  Status follow(std::size_t first);
  const Source& source_after(std::size_t edge) const;
  std::size_t next_after(std::size_t at);

  Context& context_;
  BoundaryEdges& edges_;
  TableMemory memory_{"the boundary of a shape"};
  std::vector<std::pair<LatticePoint, std::size_t>> begins_;  ///< of edges, sorted
  /// For each entry of begins_ that is the first of its point: how many of the point's edges are
  /// certainly taken.
  std::vector<std::size_t> gone_;
  std::vector<std::uint8_t> is_taken_;  ///< per edge
  EdgeLoops loops_;
};

/// Among the contours of an edge, the contour that the loop has followed so far.
const Source& Linker::source_after(std::size_t edge) const {
  const std::span<const Source> sources = edges_.sources_of(edges_.edge[edge]);
  const bool is_first = loops_.step.size() == loops_.begin.back();
  const auto goes_on = [&](const Source& source) {
    return !is_first && goes_on_from(loops_.step.back().source, source);
  };
  const auto found = std::ranges::find_if(sources, goes_on);
  return found == sources.end() ? sources.front() : *found;
}

Status Linker::sort_edges() {
  const auto place = [&](const BoundaryEdge& edge) {
    const Source& source = edges_.source[edge.first_source];
    return std::tuple(source.contour, std::min(source.begin, source.end), edge.from, edge.to);
  };
  return TableMemory::sort(
      context_, edges_.edge,
      [&](const BoundaryEdge& a, const BoundaryEdge& b) { return place(a) < place(b); });
}

Status Linker::order_begins() {
  const std::size_t count = edges_.edge.size();
  SFUMATO_TRY(memory_.reserve(context_, begins_, count));
  SFUMATO_TRY(memory_.resize(context_, gone_, count));
  SFUMATO_TRY(memory_.resize(context_, is_taken_, count));
  RarePoll<256> poll(context_);
  for (std::size_t i = 0; i < count; ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    begins_.emplace_back(edges_.edge[i].from, i);
  }
  return TableMemory::sort(context_, begins_, std::less<>());
}

/// Returns the next edge among the untaken edges that begin where edge `at` ends: the edge that
/// follows the contour, else the first; `at` if there is none.
std::size_t Linker::next_after(std::size_t at) {
  const auto point_of_entry = [](const auto& entry) { return entry.first; };
  const auto entries = std::ranges::equal_range(begins_, edges_.edge[at].to, {}, point_of_entry);
  if (entries.empty()) return at;
  std::size_t& gone = gone_[static_cast<std::size_t>(entries.begin() - begins_.begin())];
  while (gone < entries.size() && is_taken_[entries[gone].second]) ++gone;
  const auto left = std::span(entries).subspan(gone);
  const auto is_free = [&](const auto& entry) { return !is_taken_[entry.second]; };
  auto next = std::ranges::find_if(left, [&](const auto& entry) {
    return is_free(entry) && goes_on_from(loops_.step.back().source, source_after(entry.second));
  });
  if (next == left.end()) next = std::ranges::find_if(left, is_free);
  return next == left.end() ? at : next->second;
}

Status Linker::follow(std::size_t first) {
  RarePoll<256> poll(context_);
  for (std::size_t at = first; !is_taken_[at];) {
    if (poll.cancelled()) return context_.cancel_status();
    is_taken_[at] = 1;
    loops_.step.push_back({at, source_after(at)});
    if (edges_.edge[at].to == edges_.edge[first].from) break;
    at = next_after(at);
  }
  return loops_.memory.push_back(context_, loops_.begin, loops_.step.size());
}

Result<EdgeLoops> Linker::run() {
  SFUMATO_TRY(sort_edges());
  SFUMATO_TRY(order_begins());
  SFUMATO_TRY(loops_.memory.reserve(context_, loops_.step, edges_.edge.size()));
  SFUMATO_TRY(loops_.memory.push_back(context_, loops_.begin, 0));
  RarePoll<256> poll(context_);
  for (std::size_t i = 0; i < edges_.edge.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    if (!is_taken_[i]) SFUMATO_TRY(follow(i));
  }
  return std::move(loops_);
}

}  // namespace

bool goes_on_from(const Source& before, const Source& after) {
  return before.contour == after.contour && before.end == after.begin &&
         (before.begin < before.end) == (after.begin < after.end);
}

double area_of(const BoundaryEdges& edges, const EdgeLoops& loops, std::size_t loop) {
  const auto corner = [&](const LoopStep& step) {
    return edges.position_of(edges.edge[step.edge].from);
  };
  const std::span<const LoopStep> steps = loops.steps_of(loop);
  const Vec2 origin = corner(steps.front());
  Vec2 before = origin;
  double twice = 0;
  for (const LoopStep& step : steps) {
    twice += cross(before - origin, corner(step) - origin);
    before = corner(step);
  }
  return twice / 2;
}

Result<EdgeLoops> link_edges(Context& context, BoundaryEdges& edges) {
  return Linker(context, edges).run();
}

}  // namespace sfumato::svg_import
