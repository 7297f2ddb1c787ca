#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/try.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

/// Invariants of the parts of documents, wherever the parts are: in a Document, in a Picture that
/// took them over, in options. Each invariant is defined only here.
namespace sfumato::rules {

bool is_coordinate(double value);  ///< at most limits::kCoordinate in magnitude
bool is_coordinate(Vec2 p);
bool is_share(double value);  ///< 0 to 1
bool is_color(const Rgb& color);
/// Returns whether its corners are coordinates and width and height are above 0.
bool has_area(const Box& box);
/// Returns whether its entries are coordinates and it has an inverse.
bool is_usable(const Affine& map);

Status check_interpolation(InterpolationSpace space);
Status check_background(const std::optional<Rgb>& background);
Status check_compositing(float opacity, BlendMode blend);

/// Returns `status` with the place prepended to its message.
Status inside(const std::string& place, Status status);

/// Checks the items of a stack one after another: instances of layers, strokes, groups.
class StackChecker {
 public:
  StackChecker(const Context& context, std::size_t layer_count)
      : context_(context), layer_count_(layer_count) {}

  /// Checks a LayerInstance or a PatchInstance.
  template <class Instance>
  Status operator()(const Instance& instance) const {
    return check_instance(instance.layer, instance.artboard_from_layer, instance.opacity,
                          instance.blend);
  }
  Status operator()(const LocalStroke& stroke) const { return validate(context_, stroke); }
  Status operator()(const GroupBegin& group);
  Status operator()(const GroupEnd&);

  /// Checks that groups are closed. Call it after the last item.
  Status finish() const;

 private:
  Status check_instance(std::size_t layer, const Affine& artboard_from_layer, float opacity,
                        BlendMode blend) const;

  const Context& context_;
  std::size_t layer_count_;
  std::size_t open_groups_ = 0;
};

/// Returns the error if there are more items than the limit.
Status check_stack_size(const Context& context, std::size_t item_count);

/// Checks a whole stack, a document's or a picture's. Errors: bad_input, limit, cancelled.
template <class Item>
Status check_stack(const Context& context, const std::vector<Item>& stack,
                   std::size_t layer_count) {
  SFUMATO_TRY(check_stack_size(context, stack.size()));
  StackChecker checker(context, layer_count);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (context.cancelled()) return context.cancel_status();
    if (Status status = std::visit(checker, stack[i]); !status) {
      return inside("stack item " + std::to_string(i), std::move(status));
    }
  }
  return checker.finish();
}

}  // namespace sfumato::rules
