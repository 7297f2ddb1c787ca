#include "formats/svg/shapes/mask_content.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "formats/svg/read/sketch.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// The most steps of a clip that add and remove shapes in turns; each costs the time of all steps
/// before it.
constexpr std::size_t kTurns = 64;

/// Returns the opacity that a colour stands for.
float mask_value(const Rgb& color, TileUse use) {
  if (use == TileUse::alpha_mask) return 1;
  const bool is_linear = use == TileUse::linear_light_mask;
  const Rgb light = is_linear ? from_srgb(InterpolationSpace::linear, color) : color;
  const double luminance = 0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b;
  const float value = std::clamp(static_cast<float>(luminance), 0.0F, 1.0F);
  return use == TileUse::inverted_mask ? 1 - value : value;
}

class ContentReader {
 public:
  ContentReader(Input& input, Element mask, TileUse use, Document& document, PlainContent& kept)
      : input_(input), mask_(mask), use_(use), document_(document), kept_(kept) {}

  Result<MaskContent> read(std::vector<SketchedPart> parts);

 private:
  bool is_flat(const SketchedPart& part) const {
    return part.paint().color.has_value() && part.shape->blur == 0 && !part.shape->mask;
  }
  float value(const SketchedPart& part) const { return mask_value(*part.paint().color, use_); }
  bool is_clear(const SketchedPart& part) const {
    return part.opacity == 0 || (is_flat(part) && value(part) == 0);
  }
  std::optional<float> common_value(const std::vector<SketchedPart>& parts) const;
  Status read_single(const SketchedPart& part, MaskContent& content);
  Status add_clip(const std::vector<SketchedPart>& parts, MaskContent& content);
  Status add_part(const SketchedPart& part, TableMemory& memory, PlainClip& clip);
  Status add_shader(Shader shader, MaskContent& content);
  Status recolor(Shader& shader);

  Input& input_;
  Element mask_;
  TileUse use_;
  Document& document_;
  PlainContent& kept_;
};

/// Returns the value of the parts that are not black, where all are opaque and have the same. Black
/// and the other do not take turns too often.
std::optional<float> ContentReader::common_value(const std::vector<SketchedPart>& parts) const {
  std::optional<float> common;
  std::size_t turns = 0;
  bool was_black = false;
  for (const SketchedPart& part : parts) {
    if (!is_flat(part) || part.opacity < 1) return std::nullopt;
    const bool is_black = value(part) == 0;
    turns += is_black != was_black ? 1 : 0;
    was_black = is_black;
    if (turns > kTurns) return std::nullopt;
    if (is_black) continue;
    if (common && *common != value(part)) return std::nullopt;
    common = value(part);
  }
  return common;
}

Result<MaskContent> ContentReader::read(std::vector<SketchedPart> parts) {
  // Black on a clear ground changes nothing.
  const auto begin =
      std::ranges::find_if_not(parts, [&](const auto& part) { return is_clear(part); });
  parts.erase(parts.begin(), begin);
  MaskContent content;
  if (parts.empty()) {
    content.opacity = 0;
  } else if (parts.size() == 1 && parts.front().shape->blur == 0) {
    SFUMATO_TRY(read_single(parts.front(), content));
  } else if (const auto common = common_value(parts)) {
    content.opacity = *common;
    SFUMATO_TRY(add_clip(parts, content));
  } else {
    content.is_drawn = true;
  }
  return content;
}

Status ContentReader::read_single(const SketchedPart& part, MaskContent& content) {
  content.opacity = part.opacity;
  const PlainPaint& paint = part.paint();
  if (paint.color) {
    content.opacity *= value(part);
  } else if (use_ == TileUse::linear_light_mask) {
    content.is_drawn = true;
    return ok_status();
  } else {
    Shader shader = std::move(document_.shaders[paint.shader]);
    SFUMATO_TRY(use_ == TileUse::luminance_mask ? ok_status() : recolor(shader));
    SFUMATO_TRY(add_shader(std::move(shader), content));
  }
  for (auto mask = part.shape->mask; mask; mask = kept_.masks[*mask].outer) {
    content.shaders.push_back(kept_.masks[*mask].shader);
  }
  return add_clip({part}, content);
}

/// Makes the colours of the paint white, or inverts them. Its alpha stays.
Status ContentReader::recolor(Shader& shader) {
  const bool is_white = use_ == TileUse::alpha_mask;
  if (auto* fill = std::get_if<GradientFill>(&shader.paint)) {
    for (GradientStop& stop : fill->stops) {
      const Rgb& old = stop.color;
      stop.color = is_white ? Rgb{1, 1, 1} : Rgb{1 - old.r, 1 - old.g, 1 - old.b};
    }
    return ok_status();
  }
  auto& texture = std::get<Texture>(shader.paint);
  texture.file.clear();
  RarePoll<65536> poll(input_.context());
  for (std::size_t i = 0; i + 3 < texture.rgba.size(); i += 4) {
    if (poll.cancelled()) return input_.context().cancel_status();
    for (std::size_t channel = i; channel < i + 3; ++channel) {
      const int value = is_white ? 255 : 255 - texture.rgba[channel];
      texture.rgba[channel] = static_cast<std::uint8_t>(value);
    }
  }
  return ok_status();
}

Status ContentReader::add_shader(Shader shader, MaskContent& content) {
  content.shaders.push_back(static_cast<std::uint32_t>(kept_.mask_shaders.size()));
  return input_.push_back(mask_, input_.memory().shaders, kept_.mask_shaders, std::move(shader));
}

Status ContentReader::add_clip(const std::vector<SketchedPart>& parts, MaskContent& content) {
  PlainClip clip;
  TableMemory memory("shapes");
  for (const SketchedPart& part : parts) {
    SFUMATO_TRY(add_part(part, memory, clip));
  }
  content.clip = static_cast<std::uint32_t>(kept_.clips.size());
  SFUMATO_TRY(input_.push_back(mask_, input_.memory().shapes, kept_.clips, std::move(clip)));
  input_.memory().shapes.take(std::move(memory));
  return ok_status();
}

Status ContentReader::add_part(const SketchedPart& part, TableMemory& memory, PlainClip& clip) {
  const PlainShape& shape = *part.shape;
  PlainClip::Part added;
  added.even_odd = shape.even_odd && !part.is_stroke;
  added.clip = shape.clip;
  added.is_hole = is_clear(part);
  added.artboard_from_stroke = shape.artboard_from_user;
  if (part.is_stroke) added.stroke = shape.style;
  for (const std::vector<Vec2>& chain : shape.subpaths) {
    std::vector<Vec2>& points = added.contours.emplace_back();
    SFUMATO_TRY(input_.placed(mask_, memory.append(input_.context(), chain, points)));
    for (Vec2& point : points) {
      const Vec2 mapped = shape.artboard_from_user(point);
      if (std::abs(mapped.x) > limits::kCoordinate || std::abs(mapped.y) > limits::kCoordinate) {
        return input_.error(mask_, "the content of " + tag(mask_) +
                                       " reaches too far; use coordinates of the usual size");
      }
      if (!part.is_stroke) point = mapped;
    }
  }
  return input_.push_back(mask_, memory, clip.parts, std::move(added));
}

}  // namespace

Result<MaskContent> mask_content(Input& input, Element mask, TileUse use, Document& document,
                                 const PlainContent& sketch, PlainContent& kept) {
  Result<SketchedParts> parts = parts_of(input.context(), document, sketch);
  if (!parts) return input.placed(mask, parts.status());
  if (!parts->is_plain) {
    MaskContent content;
    content.is_drawn = true;
    return content;
  }
  return ContentReader(input, mask, use, document, kept).read(std::move(parts->parts));
}

}  // namespace sfumato::svg
