#include "sfumato/solve/point_evaluator.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "solve/layers/prepare_layer.hpp"

namespace sfumato {
struct PointEvaluator::State {
  struct Fields {
    solve::PreparedField color;
    std::optional<solve::PreparedField> opacity;
    Box frame;  ///< the box for gathering, layer frame
  };

  /// Returns null where no part of the layer is visible, and for a moved-from evaluator.
  static const solve::PreparedField* color(const State* state, std::uint32_t layer) {
    const bool is_there = state && layer < state->layers.size() && state->layers[layer];
    return is_there ? &state->layers[layer]->color : nullptr;
  }
  static const solve::PreparedField* opacity(const State* state, std::uint32_t layer) {
    if (!color(state, layer) || !state->layers[layer]->opacity) return nullptr;
    return &*state->layers[layer]->opacity;
  }

  std::vector<std::optional<Fields>> layers;  ///< empty where no part of the layer is visible
  gather::GatherOptions gather;
};

PointEvaluator& PointEvaluator::operator=(PointEvaluator&& other) noexcept {
  std::swap(state_, other.state_);
  return *this;
}

PointEvaluator::~PointEvaluator() {
  delete state_;
}

Result<PointEvaluator> PointEvaluator::create(Context& context, const Document& document,
                                              const DiffuseOptions& options, DiffuseStats* stats) {
  return public_verb(context, [&]() -> Result<PointEvaluator> {
    SFUMATO_TRY(solve::validate(options));
    SFUMATO_TRY(validate(context, document));
    auto state = std::make_unique<State>();
    state->gather = options.gather;
    state->layers.resize(document.layers.size());
    const Box viewport = options.viewport.value_or(document.artboard);
    for (std::uint32_t i = 0; i < document.layers.size(); ++i) {
      const solve::LayerSight sight = solve::sight_of_layer(document, i, viewport);
      if (sight.viewport.empty() || document.layers[i].curves.empty()) continue;
      SFUMATO_TRY_ASSIGN(auto&& prepared,
                         solve::prepare_layer(context, document, i, sight, options, stats));
      state->layers[i].emplace(
          State::Fields{std::move(prepared.color), std::move(prepared.opacity), sight.viewport});
    }
    return PointEvaluator(state.release());
  });
}

int PointEvaluator::color_channels(std::uint32_t layer) const {
  const solve::PreparedField* field = State::color(state_, layer);
  return field ? field->attributes.channel_count() : 0;
}

int PointEvaluator::opacity_channels(std::uint32_t layer) const {
  const solve::PreparedField* field = State::opacity(state_, layer);
  return field ? field->attributes.channel_count() : 0;
}

std::span<const std::uint32_t> PointEvaluator::color_shaders(std::uint32_t layer) const {
  const solve::PreparedField* field = State::color(state_, layer);
  if (!field) return {};
  return field->attributes.shader;
}

std::span<const std::uint32_t> PointEvaluator::opacity_shaders(std::uint32_t layer) const {
  const solve::PreparedField* field = State::opacity(state_, layer);
  if (!field) return {};
  return field->attributes.shader;
}

Status PointEvaluator::evaluate(Context& context, std::uint32_t layer, std::span<const Vec2> points,
                                std::span<float> color, std::span<std::uint8_t> hit,
                                std::span<float> opacity) const {
  return public_verb(context, [&] {
    const auto channels = static_cast<std::size_t>(color_channels(layer));
    const auto opacity_size = static_cast<std::size_t>(opacity_channels(layer)) * points.size();
    if (channels == 0) return make_error(StatusCode::bad_input, "a layer without colours");
    if (color.size() != channels * points.size() || hit.size() != points.size() ||
        (!opacity.empty() && opacity.size() != opacity_size)) {
      return make_error(StatusCode::bad_input, "tables of another size than the points ask for");
    }
    RarePoll<4096> poll(context);
    for (const Vec2 point : points) {
      if (poll.cancelled()) return context.cancel_status();
      if (state_->layers[layer]->frame.contains(point)) continue;
      return make_error(StatusCode::bad_input, "a point outside what was prepared");
    }
    return gather(context, layer, points, color, hit, opacity);
  });
}

Status PointEvaluator::gather(Context& context, std::uint32_t layer, std::span<const Vec2> points,
                              std::span<float> color, std::span<std::uint8_t> hit,
                              std::span<float> opacity) const {
  const State::Fields& fields = *state_->layers[layer];
  Status status = fields.color.gatherer.gather(context, points, state_->gather, color, hit);
  if (!status || !fields.opacity || opacity.empty()) return status;
  return fields.opacity->gatherer.gather(context, points, state_->gather, opacity);
}

}  // namespace sfumato
