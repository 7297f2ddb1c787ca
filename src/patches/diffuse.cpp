#include "patches/diffuse.hpp"

#include <utility>

#include "patches/layer_scene.hpp"
#include "patches/layer_solver.hpp"
#include "patches/layer_view.hpp"

namespace sfumato {
namespace {

/// The part of a layer's frame that any of its instances brings into `viewport`; empty if none.
Box layer_viewport(const Document& document, std::uint32_t layer, const Box& viewport) {
  Box box;
  for (const StackItem& item : document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance || instance->layer != layer) continue;
    box = united(box, patches::bounds_of_mapped(inverse(instance->artboard_from_layer), viewport));
  }
  return box;
}

Result<PatchLayer> solve_layer(Context& context, const Document& document, std::uint32_t index,
                               const Box& viewport, const DiffuseOptions& options,
                               DiffuseStats* stats) {
  const Layer& layer = document.layers[index];
  const Box seen = layer_viewport(document, index, viewport);
  if (seen.empty() || layer.curves.empty()) return PatchLayer{};
  Result<patches::LayerScene> scene =
      patches::prepare_layer(context, layer, document.artboard, seen, options, stats);
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

Result<Picture> diffuse(Context& context, const Document& document, const DiffuseOptions& options,
                        DiffuseStats* stats) {
  if (Status status = patches::validate(options); !status) return status;
  if (Status status = validate(document); !status) return status;
  Picture picture;
  picture.artboard = document.artboard;
  picture.viewport = options.viewport.value_or(document.artboard);
  picture.interpolation = document.interpolation;
  picture.background = document.background;
  picture.shaders = document.shaders;
  for (std::uint32_t i = 0; i < document.layers.size(); ++i) {
    Result<PatchLayer> layer = solve_layer(context, document, i, picture.viewport, options, stats);
    if (!layer) return layer.status();
    picture.layers.push_back(std::move(*layer));
  }
  for (const StackItem& item : document.stack) {
    picture.stack.push_back(std::visit([](const auto& x) { return picture_item(x); }, item));
  }
  return picture;
}

}  // namespace sfumato
