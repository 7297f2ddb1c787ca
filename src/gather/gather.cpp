#include "gather/gather.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "base/limit_error.hpp"
#include "base/parallel.hpp"
#include "base/try.hpp"
#include "gather/exact.hpp"
#include "gather/from_source.hpp"
#include "gather/rays.hpp"
#include "gather/rows/weight_class.hpp"
#include "gather/scene/changes.hpp"
#include "gather/scene/locate.hpp"
#include "gather/scene/packing.hpp"
#include "gather/scene/weak_visibility.hpp"

namespace sfumato::gather {

struct Gatherer::State {
  Scene scene;
  FreeEnds ends;
  std::optional<Locator> locator;  ///< empty where the mesh has no triangle
};

namespace {

/// The steps of find_viewers() for each triangle: gathering the nodes of a triangle takes longer.
constexpr std::size_t kStepsPerTriangle = 128;

constexpr std::size_t kPointsPerTask = 256;

/// Writes the result where there is nothing to see.
void leave_empty(const PointList& points, std::size_t channels, std::span<float> out,
                 std::span<std::uint8_t> hit) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::ranges::fill(out.subspan(channels * points.slot(i), channels), 0.0f);
    if (!hit.empty()) hit[points.slot(i)] = 0;
  }
}

}  // namespace

Gatherer::Gatherer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Gatherer::Gatherer(Gatherer&&) noexcept = default;
Gatherer& Gatherer::operator=(Gatherer&&) noexcept = default;
Gatherer::~Gatherer() = default;

Result<Gatherer> Gatherer::create(Context& context, const mesh::TriangleMesh& visibility,
                                  const curves::SegmentAttributes& attributes, Ends ends,
                                  const GatherUse& use, const MeshChange& change) {
  const State* const before = change.before ? change.before->state_.get() : nullptr;
  State* const used = change.used ? change.used->state_.get() : nullptr;
  std::optional<Scene> scene;
  if (before) {
    const std::span<const std::uint8_t> none;
    SFUMATO_TRY_ASSIGN(
        scene, extend_scene(context, visibility, attributes, change.whole ? none : use.is_watched,
                            before->scene, change.is_same, used ? &used->scene : nullptr));
  }
  const bool is_changed = scene.has_value();
  if (!is_changed) {
    GatherUse now = use;
    if (change.whole) now.is_watched = {};
    SFUMATO_TRY_ASSIGN(auto&& built, build_scene(context, visibility, attributes, now));
    scene.emplace(std::move(built));
  }
  auto state = std::make_unique<State>();
  state->scene = std::move(*scene);
  state->scene.identity = std::make_shared<const char>();
  if (ends == Ends::soft) {
    const mesh::TriangleMesh& with = change.whole ? *change.whole : visibility;
    const bool extendable = use.will_be_extended || use.may_be_changed;
    SFUMATO_TRY_ASSIGN(
        state->ends,
        is_changed ? FreeEnds::extend(context, visibility, attributes, before->ends, with,
                                      use.is_watched, change.is_same, used ? &used->ends : nullptr)
                   : FreeEnds::create(context, visibility, attributes, state->scene.origin,
                                      state->scene.weight_unit, extendable, use.beside));
  }
  if (!state->scene.triangle.empty()) {
    SFUMATO_TRY_ASSIGN(auto&& locator,
                       is_changed ? Locator::extend(context, *before->locator, state->scene)
                                  : Locator::create(context, state->scene));
    state->locator.emplace(std::move(locator));
  }
  return Gatherer(std::move(state));
}

void Gatherer::forget_before() {
  state_->ends.forget_changes();
}

Status Gatherer::watch(const Context& context, const mesh::TriangleMesh& visibility,
                       std::span<const std::uint8_t> is_watched) {
  return gather::watch(context, visibility, is_watched, state_->scene);
}

void Gatherer::forget_watched() {
  state_->scene.memory.free(state_->scene.watched);
}

std::size_t Gatherer::leave_budget() {
  std::size_t bytes = state_->scene.memory.leave_budget() + state_->ends.leave_budget();
  if (state_->locator) bytes += state_->locator->leave_budget();
  return bytes;
}

int Gatherer::channel_count() const {
  return state_->scene.channel_count();
}

float Gatherer::weight_unit() const {
  return state_->scene.weight_unit;
}

Status Gatherer::gather(Context& context, const PointList& points, const GatherOptions& options,
                        std::span<float> out, std::span<std::uint8_t> hit, bool weighs,
                        std::span<std::uint32_t> place) const {
  if (points.size() > context.limits.nodes) {
    return limit_error(context.limits, &Limits::nodes, "points to gather at");
  }
  if (options.method == Method::rays) {
    return gather_rays(context, state_->scene, state_->ends, points, options, out, hit);
  }
  if (!state_->locator) {
    leave_empty(points, static_cast<std::size_t>(channel_count()), out, hit);
    return ok_status();
  }
  SFUMATO_TRY_ASSIGN(const LocatedPoints& located, state_->locator->locate(context, points));
  if (!place.empty()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      place[points.slot(i)] = state_->scene.source[located.triangle[i]];
  }
  SFUMATO_TRY_ASSIGN(const Packing& packing,
                     pack(context, state_->scene, located, points.group_end()));
  const GatherOutput output{out, hit, weighs};
  PointSource* const source = context.point_source;
  if (source && points.size() >= source->least_points()) {
    return gather_from(context, *source, state_->scene, state_->ends, points, located, packing,
                       output);
  }
  return gather_exact(context, state_->scene, state_->ends, points, located, packing, output);
}

Result<PointPlaces> Gatherer::locate(Context& context, const PointList& points,
                                     std::span<const std::uint32_t> known) const {
  PointPlaces places;
  const std::size_t triangles = state_->scene.triangle.size();
  SFUMATO_TRY(places.memory.resize(context, places.begin, triangles + 1));
  SFUMATO_TRY(places.memory.resize(context, places.slot, points.size()));
  if (!state_->locator) return places;
  TableMemory scratch("the places of points");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint32_t>& triangle,
                     triangles_of(context, points, known, scratch));
  // Counted, summed up, then each put before the end of its triangle's part.
  for (const std::uint32_t t : triangle) ++places.begin[t];
  std::partial_sum(places.begin.begin(), places.begin.end(), places.begin.begin());
  for (std::size_t i = points.size(); i-- > 0;)
    places.slot[--places.begin[triangle[i]]] = static_cast<std::uint32_t>(points.slot(i));
  return places;
}

/// Returns per point the triangle that contains it.
Result<std::vector<std::uint32_t>> Gatherer::triangles_of(Context& context, const PointList& points,
                                                          std::span<const std::uint32_t> known,
                                                          TableMemory& memory) const {
  std::vector<std::uint32_t> triangle, unknown, place;
  TableMemory scratch("the places of points");
  SFUMATO_TRY(memory.resize(context, triangle, points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t slot = points.slot(i);
    triangle[i] = slot < known.size() ? known[slot] : kUnknownPlace;
    if (triangle[i] != kUnknownPlace) continue;
    SFUMATO_TRY(scratch.push_back(context, unknown, static_cast<std::uint32_t>(slot)));
    SFUMATO_TRY(scratch.push_back(context, place, static_cast<std::uint32_t>(i)));
  }
  SFUMATO_TRY_ASSIGN(const LocatedPoints& located,
                     state_->locator->locate(context, points.among(unknown)));
  for (std::size_t i = 0; i < place.size(); ++i)
    triangle[place[i]] = state_->scene.source[located.triangle[i]];
  return triangle;
}

Status Gatherer::find_changes(Context& context, const Gatherer& before, const PointList& points,
                              std::span<std::uint8_t> may_differ,
                              const InsertedShare* inserted) const {
  SFUMATO_TRY(mark_viewers(context, *state_, points, may_differ));
  SFUMATO_TRY(mark_viewers(context, *before.state_, points, may_differ));
  const float unit = before.weight_unit();
  for (std::size_t i = 0; inserted && i < points.size(); ++i) {
    const std::size_t slot = points.slot(i);
    if (!may_differ[slot]) continue;
    const float weight = least_weight(inserted->weight[slot]);
    may_differ[slot] = !inserted->bound.holds_at(points[i], weight, unit);
  }
  SFUMATO_TRY_ASSIGN(const ChangedEnds& ends,
                     changed_ends(context, before.state_->ends, state_->ends));
  Status status = mark_reached(context, *state_, ends.gone, points, may_differ);
  return status ? mark_reached(context, *state_, ends.fresh, points, may_differ) : status;
}

Status Gatherer::find_dependents(Context& context, const PointList& points, int channel,
                                 std::span<std::uint8_t> depends) const {
  SFUMATO_TRY(mark_viewers(context, *state_, points, depends));
  const Result<FreeEnds> ends = state_->ends.with_channel(context, channel);
  return ends ? mark_reached(context, *state_, *ends, points, depends) : ends.status();
}

Status Gatherer::mark_reached(Context& context, const State& state, const FreeEnds& ends,
                              const PointList& points, std::span<std::uint8_t> reached) {
  if (ends.empty()) return ok_status();
  return parallel_for(context, points.size(), kPointsPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) {
                          const Vec2 p = points[i] - state.scene.origin;
                          if (ends.reach(p)) reached[points.slot(i)] = 1;
                        }
                      });
}

/// Marks the points in triangles that see a watched segment.
Status Gatherer::mark_viewers(Context& context, const State& state, const PointList& points,
                              std::span<std::uint8_t> sees) {
  if (state.scene.watched.empty()) return ok_status();
  TableMemory memory("who sees a curve");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& triangle_sees,
                     find_viewers(context, state.scene, memory, kStepsPerTriangle));
  SFUMATO_TRY_ASSIGN(const LocatedPoints& located, state.locator->locate(context, points));
  return parallel_for(context, points.size(), kPointsPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) {
                          if (triangle_sees[located.triangle[i]]) sees[points.slot(i)] = 1;
                        }
                      });
}

Status Gatherer::list_changes(Context& context, const Gatherer& before,
                              std::span<const Vec2> position, const KnownPlaces& known,
                              TableMemory& memory, std::vector<std::uint32_t>& changed) const {
  if (!state_->locator) return ok_status();
  SFUMATO_TRY_ASSIGN(const ChangedEnds& ends,
                     changed_ends(context, before.state_->ends, state_->ends));
  const InsertedScene now{state_->scene, *state_->locator, ends, before.state_->scene.weight_unit};
  return ChangeSearch(context, now, position, known).run(memory, changed);
}

}  // namespace sfumato::gather
