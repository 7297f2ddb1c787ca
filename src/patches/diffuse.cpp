#include "patches/diffuse.hpp"

#include <utility>

#include "patches/layer_scene.hpp"
#include "patches/layer_solver.hpp"

namespace sfumato {
namespace {

Result<PatchLayer> solve_layer(Context& context, const Document& document, std::uint32_t index,
                               const Box& viewport, const DiffuseOptions& options,
                               DiffuseStats* stats) {
  const patches::LayerSight sight = patches::sight_of_layer(document, index, viewport);
  if (sight.viewport.empty() || document.layers[index].curves.empty()) return PatchLayer{};
  Result<patches::LayerScene> scene = patches::prepare_layer(
      context, document, index, sight, options, stats, patches::LayerUse::patches);
  if (!scene) return scene.status();
  return patches::LayerSolver(context, std::move(*scene), options, stats).solve();
}

PictureItem picture_item(const LayerInstance& instance) {
  return PatchInstance{instance.layer, instance.artboard_from_layer, instance.opacity,
                       instance.blend};
}

/// What is painted as it stands in the document.
template <class Item>
PictureItem picture_item(const Item& item) {
  return item;
}

}  // namespace

Picture picture_frame(const Document& document, const Box& viewport) {
  Picture picture;
  picture.artboard = document.artboard;
  picture.viewport = viewport;
  picture.interpolation = document.interpolation;
  picture.background = document.background;
  picture.shaders = document.shaders;
  for (const StackItem& item : document.stack) {
    picture.stack.push_back(std::visit([](const auto& x) { return picture_item(x); }, item));
  }
  return picture;
}

Result<Picture> diffuse(Context& context, const Document& document, const DiffuseOptions& options,
                        DiffuseStats* stats) {
  if (Status status = patches::validate(options); !status) return status;
  if (Status status = validate(document); !status) return status;
  Picture picture = picture_frame(document, options.viewport.value_or(document.artboard));
  for (std::uint32_t i = 0; i < document.layers.size(); ++i) {
    Result<PatchLayer> layer = solve_layer(context, document, i, picture.viewport, options, stats);
    if (!layer) return layer.status();
    picture.layers.push_back(std::move(*layer));
  }
  return picture;
}

}  // namespace sfumato
