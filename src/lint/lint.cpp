#include "sfumato/lint/lint.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/boxes.hpp"
#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "lint/coverage.hpp"
#include "lint/curve_hints.hpp"
#include "lint/stroke_hints.hpp"

namespace sfumato {
namespace {

using lint_detail::Cover;
using lint_detail::LayerUnderTest;

/// If even a picture of this length shows less than a pixel for two texels, the texture is larger
/// than needed.
constexpr double kLargestPicturePx = 4096;
constexpr double kTexelsPerPixel = 2;

template <class Value>
void note_shader(const SideShader<Value>& shader, std::vector<bool>& used) {
  if (shader.kind == ShaderKind::image_domain) used[shader.shader] = true;
}

/// Returns the shaders that a layer uses.
std::vector<bool> shaders_of(const Layer& layer, std::size_t shader_count) {
  std::vector<bool> used(shader_count, false);
  for (const Curve& curve : layer.curves) {
    for (const Side* side : {&curve.left, &curve.right}) {
      note_shader(side->color, used);
      note_shader(side->opacity, used);
    }
  }
  return used;
}

Box bounds_of(std::span<const Curve> curves) {
  Box box;
  for (const Curve& curve : curves) box = united(box, box_of_points(curve.control_points));
  return box;
}

bool is_one_sided(const Curve& curve) {
  const bool is_closed = curve.control_points.front() == curve.control_points.back();
  const bool left = curves::has_value(curve.left.color);
  const bool right = curves::has_value(curve.right.color);
  const SideShader<Rgb>& other = left ? curve.right.color : curve.left.color;
  return is_closed && left != right && other.kind == ShaderKind::open;
}

/// Returns whether a layer may flood the artboard: it has closed curves with a colour on one side
/// and nothing on the other; all other curves have no colour or lie within the largest of these;
/// and no curve has opacity. A curve around the whole view is a frame and does not count.
bool may_flood(const Layer& layer, const Box& sight) {
  Box largest;
  for (const Curve& curve : layer.curves) {
    const Box box = box_of_points(curve.control_points);
    const bool is_larger =
        largest.empty() || box.width() * box.height() > largest.width() * largest.height();
    if (is_one_sided(curve) && is_larger) largest = box;
  }
  const bool is_frame = largest.contains(sight.min) && largest.contains(sight.max);
  return !largest.empty() && !is_frame &&
         std::ranges::all_of(layer.curves, [&](const Curve& curve) {
           if (curve.left.opacity.kind != ShaderKind::open) return false;
           if (curve.right.opacity.kind != ShaderKind::open) return false;
           const bool has_color =
               curves::has_value(curve.left.color) || curves::has_value(curve.right.color);
           const Box box = box_of_points(curve.control_points);
           const bool is_within = largest.contains(box.min) && largest.contains(box.max);
           return is_one_sided(curve) || !has_color || is_within;
         });
}

class Linter {
 public:
  Linter(Context& context, const Document& document)
      : context_(context),
        document_(document),
        shader_used_(document.shaders.size(), false),
        shader_scale_(document.shaders.size(), 0) {}

  Result<std::vector<Hint>> run();

 private:
  Status check_layer(std::uint32_t layer);
  void check_attributes(std::uint32_t layer);
  void note_shaders(std::uint32_t layer, double scale);
  Status check_instances(LayerUnderTest& test);
  Status check_stack();
  void check_stack_item(std::uint32_t i);
  void check_shader(std::uint32_t i);

  Hint& add_to_stack(HintKind kind, std::uint32_t item, std::string message) {
    return hints_.emplace_back(
        Hint{.kind = kind, .stack_item = item, .message = std::move(message)});
  }
  Hint& add_to_shader(HintKind kind, std::uint32_t shader, std::string message) {
    return hints_.emplace_back(Hint{.kind = kind, .shader = shader, .message = std::move(message)});
  }

  Context& context_;
  const Document& document_;
  std::vector<Hint> hints_;
  std::vector<bool> shader_used_;
  std::vector<double> shader_scale_;  ///< artboard units to a unit of the layers that use it
};

Result<std::vector<Hint>> Linter::run() {
  for (std::uint32_t i = 0; i < document_.layers.size(); ++i) {
    SFUMATO_TRY(check_layer(i));
  }
  SFUMATO_TRY(check_stack());
  for (std::uint32_t i = 0; i < document_.shaders.size(); ++i) check_shader(i);
  return std::move(hints_);
}

Status Linter::check_layer(std::uint32_t layer) {
  const solve::LayerSight sight = solve::sight_of_layer(document_, layer, document_.artboard);
  const bool is_painted = !sight.viewport.empty();
  note_shaders(layer, is_painted ? sight.scale : 0);
  if (!is_painted) {
    hints_.push_back(
        {.kind = HintKind::unused_layer,
         .layer = layer,
         .message = "nothing paints this layer; move it out of <defs>, or add a <use> of it"});
    return ok_status();
  }
  if (document_.layers[layer].curves.empty()) {
    hints_.push_back({.kind = HintKind::empty_layer,
                      .layer = layer,
                      .message = "the layer has no curves; add some, or delete it"});
    return ok_status();
  }
  DiffuseOptions options;
  options.pixels_per_unit = 1 / lint_detail::artboard_pixel(document_);
  SFUMATO_TRY_ASSIGN(auto&& prepared,
                     solve::prepare_layer(context_, document_, layer, sight, options, nullptr));
  SFUMATO_TRY_ASSIGN(const mesh::TriangleMesh& mesh, prepared.mesher.visibility_mesh(context_));
  LayerUnderTest test{context_, document_, layer, sight, prepared, mesh, hints_};
  SFUMATO_TRY(lint_detail::check_curves(test));
  SFUMATO_TRY(lint_detail::check_visibility(test));
  SFUMATO_TRY(lint_detail::check_meetings(test));
  check_attributes(layer);
  return check_instances(test);
}

void Linter::note_shaders(std::uint32_t layer, double scale) {
  const std::vector<bool> used = shaders_of(document_.layers[layer], document_.shaders.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    shader_used_[i] = true;
    shader_scale_[i] = std::max(shader_scale_[i], scale);
  }
}

void Linter::check_attributes(std::uint32_t layer) {
  bool has_color = false, has_opacity = false;
  for (const Curve& curve : document_.layers[layer].curves) {
    for (const Side* side : {&curve.left, &curve.right}) {
      has_color |= curves::has_value(side->color);
      has_opacity |= curves::has_value(side->opacity);
    }
  }
  if (!has_opacity || has_color) return;
  hints_.push_back({.kind = HintKind::opacity_without_color,
                    .layer = layer,
                    .message = "its curves have opacity but no colour, so the layer paints "
                               "nothing; add a colour to a side"});
}

Status Linter::check_instances(LayerUnderTest& test) {
  const Box bounds = bounds_of(test.curves());
  bool leak_told = false;
  for (std::uint32_t i = 0; i < document_.stack.size(); ++i) {
    const auto* instance = std::get_if<LayerInstance>(&document_.stack[i]);
    if (!instance || instance->layer != test.layer || instance->opacity == 0) continue;
    const bool is_above = i > 0;  // a layer over the background alone is the ground of the picture
    const bool is_outside =
        !overlap(mapped_box(instance->artboard_from_layer, bounds), document_.artboard);
    const bool floods = !is_above && may_flood(document_.layers[test.layer], test.sight.viewport);
    const bool may_leak =
        (is_above || floods) && !leak_told && instance->blend == BlendMode::normal;
    if (!may_leak && !is_outside) continue;
    SFUMATO_TRY_ASSIGN(const Cover& cover,
                       lint_detail::cover_of(test, instance->artboard_from_layer, may_leak));
    if (floods && cover == Cover::all) {
      leak_told = true;
      test.add(HintKind::flood,
               "closed curves have a colour on one side only, so the colour passes through and "
               "floods the artboard; give the other side a colour, or none as a barrier")
          .stack_item = i;
    } else if (may_leak && cover == Cover::all) {
      leak_told = true;
      test.add(HintKind::leak,
               "its colours leak to infinity: they reach the artboard's border all around and "
               "cover everything below; close the outer curve and give its outside nothing, a "
               "barrier or an opacity of 0")
          .stack_item = i;
    } else if (is_outside && cover == Cover::none) {
      test.add(HintKind::instance_outside,
               "it lies outside the artboard, so nothing of it shows; move or delete it")
          .stack_item = i;
    }
  }
  return ok_status();
}

Status Linter::check_stack() {
  RarePoll<16> poll(context_);  // a local curve may have many stops
  for (std::uint32_t i = 0; i < document_.stack.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    check_stack_item(i);
  }
  return context_.check();
}

void Linter::check_stack_item(std::uint32_t i) {
  const StackItem& item = document_.stack[i];
  const char* message = "its opacity is 0, so nothing of it shows; raise the opacity, or delete it";
  if (const auto* instance = std::get_if<LayerInstance>(&item)) {
    if (instance->opacity == 0) {
      add_to_stack(HintKind::invisible, i, message).layer = instance->layer;
    }
  } else if (const auto* group = std::get_if<GroupBegin>(&item)) {
    if (group->opacity == 0) add_to_stack(HintKind::invisible, i, message);
  } else if (const auto* stroke = std::get_if<LocalStroke>(&item)) {
    lint_detail::check_stroke(document_, i, *stroke, hints_);
  }
}

void Linter::check_shader(std::uint32_t i) {
  const Shader& shader = document_.shaders[i];
  if (!shader_used_[i]) {
    add_to_shader(HintKind::unused_shader, i, "no curve uses it; delete it");
    return;
  }
  if (const auto* fill = std::get_if<GradientFill>(&shader.paint)) {
    if (fill->stops.size() > 1) return;
    add_to_shader(HintKind::one_stop_gradient, i,
                  "the gradient has one stop; use a plain colour, or add a stop");
    return;
  }
  const auto& texture = std::get<Texture>(shader.paint);
  const double texel = std::sqrt(std::abs(texture.layer_from_texture.determinant())) *
                       shader_scale_[i];  // artboard units
  const double pixel = longer_side(document_.artboard) / kLargestPicturePx;
  if (shader_scale_[i] == 0 || texel * kTexelsPerPixel > pixel) return;
  add_to_shader(HintKind::large_texture, i,
                "each pixel of a picture of 4096 pixels shows " +
                    rounded_number_text(pixel / texel, 2) +
                    " of its texels side by side; use a smaller image");
}

}  // namespace

Result<std::vector<Hint>> lint(Context& context, const Document& document) {
  SFUMATO_TRY(validate(context, document));
  return public_verb(context, [&] { return Linter(context, document).run(); });
}

}  // namespace sfumato
