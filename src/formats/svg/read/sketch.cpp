#include "formats/svg/read/sketch.hpp"

#include <cmath>
#include <map>
#include <variant>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "formats/svg/style/plain_style.hpp"

namespace sfumato::svg {
namespace {

constexpr std::size_t kComparedParts = 256;
constexpr double kBlurReach = 3;  ///< in standard deviations

}  // namespace

Result<SketchedParts> parts_of(const Context& context, const Document& document,
                               const PlainContent& content) {
  SketchedParts sketch;
  std::map<std::uint32_t, SketchedPart> part_of;
  RarePoll<256> poll(context);
  for (const PlainShape& shape : content.shapes) {
    if (shape.fill) part_of[shape.fill_layer] = {&shape, false};
    if (shape.stroke) part_of[shape.stroke_layer] = {&shape, true};
    if (poll.cancelled()) return context.cancel_status();
  }
  for (const StackItem& item : document.stack) {
    if (poll.cancelled()) return context.cancel_status();
    if (const auto* group = std::get_if<GroupBegin>(&item)) {
      sketch.is_plain &= group->opacity == 1 && group->blend == BlendMode::normal;
    }
    if (std::holds_alternative<LocalStroke>(item)) sketch.is_plain = false;
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance) continue;
    const auto found = part_of.find(instance->layer);
    sketch.is_plain &= found != part_of.end() && instance->blend == BlendMode::normal;
    if (found == part_of.end()) continue;
    SketchedPart part = found->second;
    part.opacity = instance->opacity;
    SFUMATO_TRY(sketch.memory.push_back(context, sketch.parts, part));
  }
  return sketch;
}

Box box_around(const SketchedPart& part) {
  const PlainShape& shape = *part.shape;
  const Affine& map = shape.artboard_from_user;
  Box box;
  for (const std::vector<Vec2>& chain : shape.subpaths) {
    for (const Vec2 point : chain) box.extend(map(point));
  }
  box = box.grown_by(kBlurReach * shape.blur);
  if (!part.is_stroke) return box;
  const double reach = stroke_reach(shape.style);
  if (!shape.style.is_scaled) return box.grown_by(reach);
  const Vec2 grown{reach * (std::abs(map.a) + std::abs(map.c)),
                   reach * (std::abs(map.b) + std::abs(map.d))};
  return {box.min - grown, box.max + grown};
}

Result<bool> are_apart(const Context& context, const SketchedParts& sketch, Box& box) {
  TableMemory memory("shapes");
  std::vector<Box> boxes;
  bool apart = sketch.is_plain && sketch.parts.size() <= kComparedParts;
  for (const SketchedPart& part : sketch.parts) {
    if (context.cancelled()) return context.cancel_status();
    const Box own = box_around(part);
    box = united(box, own);
    for (const Box& other : boxes) apart = apart && !overlap(own, other);
    if (!apart) continue;
    SFUMATO_TRY(memory.push_back(context, boxes, own));
  }
  return apart || sketch.parts.size() == 1;
}

}  // namespace sfumato::svg
