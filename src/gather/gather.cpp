#include "gather/gather.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/limit_error.hpp"
#include "gather/exact.hpp"
#include "gather/locate.hpp"
#include "gather/packing.hpp"
#include "gather/rays.hpp"

namespace sfumato::gather {

struct Gatherer::State {
  Scene scene;
  FreeEnds ends;
  std::optional<Locator> locator;  ///< empty where the mesh has no triangle
};

namespace {

/// What is gathered where there is nothing to see.
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
                                  const curves::SegmentAttributes& attributes, Ends ends) {
  Result<Scene> scene = build_scene(context, visibility, attributes);
  if (!scene) return scene.status();
  auto state = std::make_unique<State>();
  state->scene = std::move(*scene);
  if (ends == Ends::soft) {
    Result<FreeEnds> found = FreeEnds::create(context, visibility, attributes, state->scene.origin,
                                              state->scene.weight_unit);
    if (!found) return found.status();
    state->ends = std::move(*found);
  }
  if (!state->scene.triangle.empty()) {
    Result<Locator> locator = Locator::create(context, state->scene);
    if (!locator) return locator.status();
    state->locator.emplace(std::move(*locator));
  }
  return Gatherer(std::move(state));
}

int Gatherer::channel_count() const {
  return state_->scene.channel_count();
}

Status Gatherer::gather(Context& context, const PointList& points, const GatherOptions& options,
                        std::span<float> out, std::span<std::uint8_t> hit) const {
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
  const Result<LocatedPoints> located = state_->locator->locate(context, points);
  if (!located) return located.status();
  const Result<Packing> packing = pack(context, state_->scene, *located);
  if (!packing) return packing.status();
  return gather_exact(context, state_->scene, state_->ends, points, *located, *packing, out, hit);
}

}  // namespace sfumato::gather
