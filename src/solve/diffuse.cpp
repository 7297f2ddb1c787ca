#include "sfumato/solve/diffuse.hpp"

#include <utility>

#include "base/charge.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "solve/exact_fields.hpp"
#include "solve/layer_runs.hpp"
#include "solve/prepare_layer.hpp"

namespace sfumato {
namespace {

PictureItem picture_item(const LayerInstance& instance) {
  return PatchInstance{instance.layer, instance.artboard_from_layer, instance.opacity,
                       instance.blend};
}

/// What is painted as it stands in the document.
template <class Item>
PictureItem picture_item(const Item& item) {
  return item;
}

/// The shaders of a document. The files that textures came from are in them too: the HTML viewer
/// takes these.
Result<std::vector<Shader>> copy_shaders(Context& context, const std::vector<Shader>& shaders) {
  std::vector<Shader> copies;
  TableMemory memory("textures");
  for (const Shader& shader : shaders) {
    if (const auto* texture = std::get_if<Texture>(&shader.paint)) {
      Texture copy{texture->width,   texture->height, {}, texture->layer_from_texture,
                   texture->repeats, texture->period, {}};
      Status status = memory.append(context, texture->rgba, copy.rgba);
      if (status) status = memory.append(context, texture->file, copy.file);
      if (!status) return status;
      copies.push_back({shader.id, std::move(copy)});
    } else {
      copies.push_back(shader);
    }
  }
  return copies;
}

/// Of the local curves on the stack.
std::size_t stroke_bytes(const Document& document) {
  std::size_t bytes = 0;
  for (const StackItem& item : document.stack) {
    if (const auto* stroke = std::get_if<LocalStroke>(&item)) bytes += bytes_of(stroke->curve);
  }
  return bytes;
}

Result<Picture> make_frame(Context& context, const Document& document, const Box& viewport) {
  Result<std::vector<Shader>> shaders = copy_shaders(context, document.shaders);
  if (!shaders) return shaders.status();
  Picture picture;
  picture.artboard = document.artboard;
  picture.viewport = viewport;
  picture.interpolation = document.interpolation;
  picture.background = document.background;
  picture.shaders = std::move(*shaders);
  ScopedCharge charge;
  TableMemory memory("the picture's stack");
  Status status = charge.add(context, stroke_bytes(document), "the picture's stack");
  if (status) status = memory.reserve(context, picture.stack, document.stack.size());
  if (!status) return status;
  for (const StackItem& item : document.stack) {
    picture.stack.push_back(std::visit([](const auto& x) { return picture_item(x); }, item));
  }
  return picture;
}

Result<Picture> solve_document(Context& context, const Document& document,
                               const DiffuseOptions& options, DiffuseStats* stats) {
  if (Status status = solve::validate(options); !status) return status;
  if (Status status = validate(context, document); !status) return status;
  Result<Picture> frame =
      make_frame(context, document, options.viewport.value_or(document.artboard));
  if (!frame) return frame.status();
  Picture picture = std::move(*frame);
  ScopedCharge charge;  // of the frame, while layers are solved
  Status status = charge.add(context, bytes_of(picture), "the picture");
  if (!status) return status;
  Result<std::vector<solve::LayerSight>> sights =
      solve::sights_of_layers(context, document, picture.viewport);
  if (!sights) return sights.status();
  std::vector<solve::LayerTask> tasks(sights->size());
  for (std::uint32_t i = 0; i < tasks.size(); ++i) tasks[i] = {i, std::move((*sights)[i])};
  solve::LayerRuns runs(context, document, tasks, options);
  status = runs.run();
  if (stats) runs.add_to(*stats);
  if (!status) return status;
  picture.layers = runs.take();
  if (options.exact_fields) status = solve::add_exact_fields(context, document, options, &picture);
  if (!status) return status;
  return picture;
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
