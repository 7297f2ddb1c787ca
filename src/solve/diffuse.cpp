#include "sfumato/solve/diffuse.hpp"

#include <utility>

#include "base/charge.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "solve/layers/layer_runs.hpp"
#include "solve/layers/prepare_layer.hpp"
#include "solve/layers/rough.hpp"
#include "solve/points/exact_fields.hpp"

namespace sfumato {
namespace {

PictureItem picture_item(const LayerInstance& instance) {
  return PatchInstance{instance.layer, instance.artboard_from_layer, instance.opacity,
                       instance.blend};
}

/// Returns an item that is painted unchanged from the document.
template <class Item>
PictureItem picture_item(const Item& item) {
  return item;
}

/// Copies the shaders of a document, with the files of their textures, which the HTML viewer needs.
Result<std::vector<Shader>> copy_shaders(Context& context, const std::vector<Shader>& shaders) {
  std::vector<Shader> copies;
  TableMemory memory("textures");
  for (const Shader& shader : shaders) {
    if (const auto* texture = std::get_if<Texture>(&shader.paint)) {
      Texture copy{texture->width,   texture->height, {}, texture->layer_from_texture,
                   texture->repeats, texture->period, {}};
      SFUMATO_TRY(memory.append(context, texture->rgba, copy.rgba));
      SFUMATO_TRY(memory.append(context, texture->file, copy.file));
      copies.push_back({shader.id, std::move(copy)});
    } else {
      copies.push_back(shader);
    }
  }
  return copies;
}

/// Returns the bytes of the local curves on the stack.
std::size_t stroke_bytes(const Document& document) {
  std::size_t bytes = 0;
  for (const StackItem& item : document.stack) {
    if (const auto* stroke = std::get_if<LocalStroke>(&item)) bytes += bytes_of(stroke->curve);
  }
  return bytes;
}

Result<Picture> make_frame(Context& context, const Document& document, const Box& viewport) {
  SFUMATO_TRY_ASSIGN(auto&& shaders, copy_shaders(context, document.shaders));
  Picture picture;
  picture.artboard = document.artboard;
  picture.viewport = viewport;
  picture.interpolation = document.interpolation;
  picture.background = document.background;
  picture.shaders = std::move(shaders);
  ScopedCharge charge;
  TableMemory memory("the picture's stack");
  SFUMATO_TRY(charge.add(context, stroke_bytes(document), "the picture's stack"));
  SFUMATO_TRY(memory.reserve(context, picture.stack, document.stack.size()));
  for (const StackItem& item : document.stack) {
    picture.stack.push_back(std::visit([](const auto& x) { return picture_item(x); }, item));
  }
  return picture;
}

Result<Picture> solve_document(Context& context, const Document& document,
                               const DiffuseOptions& options, DiffuseStats* stats) {
  SFUMATO_TRY(solve::validate(options));
  SFUMATO_TRY(validate(context, document));
  SFUMATO_TRY_ASSIGN(auto&& picture,
                     make_frame(context, document, options.viewport.value_or(document.artboard)));
  picture.for_pixel_grid = options.exact_pixels || solve::is_for_pixel_grid(options);
  ScopedCharge charge;  // for the frame, while layers are solved
  SFUMATO_TRY(charge.add(context, bytes_of(picture), "the picture"));
  SFUMATO_TRY_ASSIGN(auto&& sights, solve::sights_of_layers(context, document, picture.viewport));
  std::vector<solve::LayerTask> tasks(sights.size());
  for (std::uint32_t i = 0; i < tasks.size(); ++i) tasks[i] = {i, std::move(sights[i])};
  solve::LayerRuns runs(context, document, tasks, options);
  Status status = runs.run();
  if (stats) runs.add_to(*stats);
  if (!status) return status;
  picture.layers = runs.take();
  if (options.exact_fields)
    SFUMATO_TRY(solve::add_exact_fields(context, document, options, &picture));
  return std::move(picture);
}

}  // namespace

Result<Picture> picture_frame(Context& context, const Document& document, const Box& viewport) {
  return public_verb(context, [&] { return make_frame(context, document, viewport); });
}

Result<Picture> diffuse(Context& context, const Document& document, const DiffuseOptions& options,
                        DiffuseStats* stats) {
  return public_verb(context, [&] { return solve_document(context, document, options, stats); });
}

}  // namespace sfumato
