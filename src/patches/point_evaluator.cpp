#include "patches/point_evaluator.hpp"

#include <algorithm>
#include <vector>

#include "patches/layer_scene.hpp"
#include "patches/layer_view.hpp"

namespace sfumato {

struct PointEvaluator::State {
  struct Instance {
    gather::Gatherer gatherer;
    Affine layer_from_artboard;
  };
  std::vector<Instance> stack;  ///< bottom first
  gather::GatherOptions gather;
};

PointEvaluator::PointEvaluator(std::unique_ptr<State> state) : state_(std::move(state)) {}
PointEvaluator::PointEvaluator(PointEvaluator&&) noexcept = default;
PointEvaluator& PointEvaluator::operator=(PointEvaluator&&) noexcept = default;
PointEvaluator::~PointEvaluator() = default;

Result<PointEvaluator> PointEvaluator::create(Context& context, const Document& document,
                                              const DiffuseOptions& options, DiffuseStats* stats) {
  if (Status status = patches::validate(options); !status) return status;
  if (Status status = validate(document); !status) return status;
  auto state = std::make_unique<State>();
  state->gather = options.gather;
  const Box viewport = options.viewport.value_or(document.artboard);
  for (const StackItem& item : document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance || document.layers[instance->layer].curves.empty()) continue;
    const Affine layer_from_artboard = inverse(instance->artboard_from_layer);
    Result<patches::LayerScene> scene = patches::prepare_layer(
        context, document.layers[instance->layer], document.artboard,
        patches::bounds_of_mapped(layer_from_artboard, viewport), options, stats);
    if (!scene) return scene.status();
    state->stack.push_back({std::move(scene->gatherer), layer_from_artboard});
  }
  return PointEvaluator(std::move(state));
}

Status PointEvaluator::evaluate(Context& context, std::span<const Vec2> points,
                                std::span<float> rgb, std::span<std::uint8_t> hit) const {
  std::fill(rgb.begin(), rgb.end(), 0.0f);
  std::fill(hit.begin(), hit.end(), std::uint8_t{0});
  std::vector<Vec2> mapped(points.size());
  std::vector<float> layer_rgb(rgb.size());
  std::vector<std::uint8_t> layer_hit(hit.size());
  for (const State::Instance& instance : state_->stack) {
    std::transform(points.begin(), points.end(), mapped.begin(), instance.layer_from_artboard);
    Status status = instance.gatherer.gather(context, mapped, state_->gather, layer_rgb, layer_hit);
    if (!status) return status;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!layer_hit[i]) continue;
      std::copy_n(layer_rgb.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                  rgb.begin() + static_cast<std::ptrdiff_t>(3 * i));
      hit[i] = 1;
    }
  }
  return ok_status();
}

}  // namespace sfumato
