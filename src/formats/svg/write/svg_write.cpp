#include "sfumato/formats/svg/svg_write.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "document/names.hpp"
#include "formats/svg/write/svg_write_curve.hpp"
#include "formats/svg/write/svg_write_ids.hpp"
#include "formats/svg/write/svg_write_shader.hpp"
#include "formats/svg/write/svg_write_text.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato {
namespace {

/// A sheet that is true of everything keeps svgo from renaming ids, which it does without looking
/// into attributes of other namespaces, and from dropping fills that nobody sees.
constexpr const char* kStyle = "*{stroke-linejoin:round}";

/// Returns a length with start + length == end where there is one: that is how a reader gets `end`
/// back.
double length_between(double start, double end) {
  const double length = end - start;
  for (const double candidate :
       {length, std::nextafter(length, 0.0), std::nextafter(length, 2 * length)}) {
    if (start + candidate == end) return candidate;
  }
  return length;
}

/// The order of shaders in <defs>: in the order of first use, then unused shaders.
class UseOrder {
 public:
  /// Sets the number of steps; called first.
  Status begin(const Context& context, TableMemory& memory, std::size_t count) {
    Status status = memory.resize(context, seen_, count);
    return status ? memory.reserve(context, order_, count) : status;
  }

  void note(std::size_t index) {
    if (seen_[index] != 0) return;
    seen_[index] = 1;
    order_.push_back(static_cast<std::uint32_t>(index));
  }

  template <class Value>
  void note_shader(const SideShader<Value>& side) {
    if (side.kind == ShaderKind::image_domain) note(side.shader);
  }

  std::vector<std::uint32_t> complete() {
    for (std::size_t i = 0; i < seen_.size(); ++i) note(i);
    return std::move(order_);
  }

 private:
  std::vector<std::uint8_t> seen_;
  std::vector<std::uint32_t> order_;
};

class SvgWriter {
 public:
  SvgWriter(Context& context, const Document& document)
      : context_(context), document_(document), writer_(context) {}

  Result<std::string> write();

 private:
  Status make_orders();
  Status make_names();
  Status charge_ids() { return id_memory_.settle(context_, ids_.kept_bytes(), id_bytes_); }
  svg::Attributes root_attributes() const;
  Status write_defs();
  void write_background();
  Status write_stack();
  Status write_item(const LayerInstance& instance);
  Status write_item(const LocalStroke& stroke);
  Status write_item(const GroupBegin& group);
  Status write_item(const GroupEnd&);
  Status write_layer(std::uint32_t layer, const svg::Attributes& attributes);
  /// Checks the length of the text so far against the length that can be read back.
  Status check_progress();

  bool has_references() const;
  bool is_in_place(std::uint32_t layer) const { return use_count_[layer] == 1; }

  Context& context_;
  const Document& document_;
  svg::ElementWriter writer_;
  TableMemory memory_{"layers and shaders"};
  TableMemory id_memory_{"ids"};
  std::size_t id_bytes_ = 0;
  svg::IdPool ids_;
  std::vector<std::uint32_t> use_count_;    ///< per layer
  std::vector<std::uint32_t> layer_order_;  ///< layers as they stand in the text
  std::vector<std::uint32_t> shader_order_;
  std::vector<std::string> layer_id_;  ///< empty: written without
  std::vector<std::string> shader_id_;
  std::string stroke_width_;
};

Result<std::string> SvgWriter::write() {
  SFUMATO_TRY(make_orders());
  SFUMATO_TRY(make_names());
  writer_.open("svg", root_attributes());
  writer_.text_element("style", kStyle);
  SFUMATO_TRY(write_defs());
  write_background();
  SFUMATO_TRY(write_stack());
  writer_.close("svg");
  return writer_.take();
}

Status SvgWriter::make_orders() {
  UseOrder layers, shaders;
  SFUMATO_TRY(memory_.resize(context_, use_count_, document_.layers.size()));
  SFUMATO_TRY(layers.begin(context_, memory_, document_.layers.size()));
  SFUMATO_TRY(shaders.begin(context_, memory_, document_.shaders.size()));
  for (const StackItem& item : document_.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance) continue;
    ++use_count_[instance->layer];
    layers.note(instance->layer);
  }
  layer_order_ = layers.complete();
  for (const std::uint32_t layer : layer_order_) {
    for (const Curve& curve : document_.layers[layer].curves) {
      shaders.note_shader(curve.left.color);
      shaders.note_shader(curve.right.color);
      shaders.note_shader(curve.left.opacity);
      shaders.note_shader(curve.right.opacity);
    }
  }
  shader_order_ = shaders.complete();
  return ok_status();
}

Status SvgWriter::make_names() {
  SFUMATO_TRY(memory_.resize(context_, shader_id_, document_.shaders.size()));
  SFUMATO_TRY(memory_.resize(context_, layer_id_, document_.layers.size()));
  for (const std::uint32_t i : shader_order_) {
    const Shader& shader = document_.shaders[i];
    shader_id_[i] = ids_.claim_or_make(shader.id, svg::kind_of(shader));
  }
  for (const std::uint32_t i : layer_order_) {
    const std::string& id = document_.layers[i].id;
    if (!id.empty() || !is_in_place(i)) layer_id_[i] = ids_.claim_or_make(id, "layer");
  }
  // About a pixel where the picture is shown at 512.
  const Box& artboard = document_.artboard;
  stroke_width_ = rounded_number_text(std::max(artboard.width(), artboard.height()) / 512, 2);
  return charge_ids();
}

svg::Attributes SvgWriter::root_attributes() const {
  const Box& artboard = document_.artboard;
  svg::Attributes attributes;
  attributes.add("xmlns", "http://www.w3.org/2000/svg").add("xmlns:sf", "urn:sfumato:1");
  // Inkscape up to 1.2 follows no plain href.
  if (has_references()) attributes.add("xmlns:xlink", "http://www.w3.org/1999/xlink");
  if (document_.size_px) {
    attributes.add("width", number_text(document_.size_px->x));
    attributes.add("height", number_text(document_.size_px->y));
  }
  attributes.add("viewBox", number_text(artboard.min.x) + ' ' + number_text(artboard.min.y) + ' ' +
                                number_text(length_between(artboard.min.x, artboard.max.x)) + ' ' +
                                number_text(length_between(artboard.min.y, artboard.max.y)));
  attributes.add("sf:version", "1");
  if (document_.interpolation == InterpolationSpace::linear) {
    attributes.add("sf:interpolation", "linear");
  } else if (document_.interpolation == InterpolationSpace::oklab) {
    attributes.add("sf:interpolation", "oklab");
  }
  return attributes;
}

/// Returns whether there is a <use> or an <image>.
bool SvgWriter::has_references() const {
  const auto is_texture = [](const Shader& shader) {
    return std::holds_alternative<Texture>(shader.paint);
  };
  return std::ranges::any_of(use_count_, [](std::uint32_t count) { return count > 1; }) ||
         std::ranges::any_of(document_.shaders, is_texture);
}

Status SvgWriter::write_defs() {
  const bool all_in_place = std::ranges::all_of(use_count_, [](auto count) { return count == 1; });
  if (document_.shaders.empty() && all_in_place) return ok_status();
  writer_.open("defs", {});
  for (const std::uint32_t i : shader_order_) {
    SFUMATO_TRY(svg::write_shader(context_, writer_, document_.shaders[i], shader_id_[i]));
    SFUMATO_TRY(check_progress());
  }
  for (const std::uint32_t i : layer_order_) {
    SFUMATO_TRY(is_in_place(i) ? ok_status() : write_layer(i, {}));
    SFUMATO_TRY(check_progress());
  }
  writer_.close("defs");
  return ok_status();
}

void SvgWriter::write_background() {
  if (!document_.background) return;
  svg::Attributes attributes;
  attributes.add("x", number_text(document_.artboard.min.x));
  attributes.add("y", number_text(document_.artboard.min.y));
  // In percent: svgo makes a path of a rectangle in numbers, and a path is no background.
  attributes.add("width", "100%").add("height", "100%");
  writer_.leaf("rect", attributes.add("fill", color_text(*document_.background)));
}

Status SvgWriter::write_stack() {
  for (const StackItem& item : document_.stack) {
    SFUMATO_TRY(std::visit([this](const auto& content) { return write_item(content); }, item));
    SFUMATO_TRY(check_progress());
  }
  return ok_status();
}

Status SvgWriter::check_progress() {
  if (!writer_.status()) return writer_.status();
  SFUMATO_TRY(charge_ids());
  if (context_.cancelled()) return context_.cancel_status();
  return svg::check_length(context_, writer_.text().size());
}

void add_compositing(svg::Attributes& attributes, float opacity, BlendMode blend) {
  if (opacity != 1) attributes.add("opacity", number_text(opacity));
  if (blend == BlendMode::normal) return;
  attributes.add("style", "mix-blend-mode:" + std::string(blend_name(blend)));
}

void add_transform(svg::Attributes& attributes, const Affine& map) {
  if (!(map == Affine{})) attributes.add("transform", transform_text(map));
}

Status SvgWriter::write_item(const LayerInstance& instance) {
  svg::Attributes attributes;
  const bool in_place = is_in_place(instance.layer);
  if (!in_place) attributes.add("xlink:href", '#' + layer_id_[instance.layer]);
  add_transform(attributes, instance.artboard_from_layer);
  add_compositing(attributes, instance.opacity, instance.blend);
  if (in_place) return write_layer(instance.layer, attributes);
  writer_.leaf("use", attributes);
  return ok_status();
}

/// `attributes`: the attributes of the place where the layer is painted.
Status SvgWriter::write_layer(std::uint32_t layer, const svg::Attributes& attributes) {
  const std::vector<Curve>& curves = document_.layers[layer].curves;
  // svgo merges a group with its only child, unless both have a class.
  const bool has_classes = curves.size() == 1;
  svg::Attributes all;
  if (!layer_id_[layer].empty()) all.add("id", layer_id_[layer]);
  if (has_classes) all.add("class", "layer");
  all.add("sf:diffuse", "true");
  for (const auto& [name, value] : attributes.list()) all.add(name, value);
  all.add("fill", "none").add("stroke-width", stroke_width_);
  writer_.open("g", all);
  RarePoll<64> poll(context_);
  for (const Curve& curve : curves) {
    if (poll.cancelled()) return context_.cancel_status();
    svg::Attributes path;
    if (!curve.id.empty()) path.add("id", ids_.claim(curve.id));
    if (has_classes) path.add("class", "curve");
    SFUMATO_TRY(svg::add_curve(context_, path, curve, shader_id_));
    SFUMATO_TRY(charge_ids());
    writer_.leaf("path", path);
    if (!writer_.status()) return writer_.status();
  }
  writer_.close("g");
  return ok_status();
}

Status SvgWriter::write_item(const LocalStroke& stroke) {
  if (stroke.curve.left_color.empty() && stroke.curve.right_color.empty()) return ok_status();
  svg::Attributes attributes;
  if (!stroke.curve.id.empty()) attributes.add("id", ids_.claim(stroke.curve.id));
  add_transform(attributes, stroke.artboard_from_stroke);
  SFUMATO_TRY(svg::add_local_curve(context_, attributes, stroke.curve));
  writer_.leaf("path", attributes);
  return ok_status();
}

Status SvgWriter::write_item(const GroupBegin& group) {
  svg::Attributes attributes;
  add_compositing(attributes, group.opacity, group.blend);
  if (attributes.list().empty()) attributes.add("style", "isolation:isolate");
  writer_.open("g", attributes);
  return ok_status();
}

Status SvgWriter::write_item(const GroupEnd&) {
  writer_.close("g");
  return ok_status();
}

Result<std::string> write(Context& context, const Document& document) {
  SFUMATO_TRY(validate(context, document));
  return SvgWriter(context, document).write();
}

}  // namespace

Result<std::string> write_svg(Context& context, const Document& document) {
  return public_verb(context, [&] { return write(context, document); });
}

}  // namespace sfumato
