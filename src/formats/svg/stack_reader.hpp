#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "formats/svg/compositing.hpp"
#include "formats/svg/curve_reader.hpp"
#include "formats/svg/input.hpp"
#include "formats/svg/paints.hpp"
#include "formats/svg/plain_svg.hpp"
#include "formats/svg/totals.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg {

/// Traverses the document and builds layers and the stack. Each layer is read where it is first
/// drawn; every later drawing of it is an instance.
class StackReader {
 public:
  /// Fills document.layers, shaders, stack and, from a <rect>, background. The artboard is set.
  /// plain   receives the shapes of ordinary SVG; null: these are ignored
  StackReader(Input& input, Document& document, const ResourceLoader* loader,
              std::vector<PlainShape>* plain = nullptr)
      : input_(input),
        document_(document),
        plain_(plain),
        totals_(input),
        paints_(input, totals_, document.artboard, loader),
        curves_(input, totals_, paints_, document.artboard) {}

  /// Errors: bad_input, limit, out_of_memory.
  Status read();
  /// Of each curve of each layer. Call once, after read().
  std::vector<std::vector<CurveSource>> take_sources() { return std::move(sources_); }

 private:
  /// The current place of the traversal.
  struct Place {
    Affine frame_from_user{};  ///< to the artboard or, in a layer, to the layer's frame
    Layer* layer = nullptr;    ///< the layer to which curves are added; null outside of layers
    std::vector<CurveSource>* sources = nullptr;  ///< of the layer's curves
    bool is_visible = true;
    int depth = 0;
    /// The <use>, for an element to which it refers directly.
    Element use{};
    /// Whether this is inside content to which a <use> refers. Copies do not get the id of the
    /// original.
    bool is_copy = false;
  };

  /// The elements of one kind that are never drawn.
  struct Unused {
    Element first_layer{}, first_paint{};
    std::size_t layers = 0, paints = 0;
  };

  /// Everything painted between these two calls is composited as one.
  struct OpenGroup {
    Compositing compositing;
    std::size_t begin = 0;  ///< the index of its GroupBegin in the stack
    int outer_height = 0;
    bool is_open = false;
  };

  /// An element whose end has not been reached.
  struct OpenElement {
    Element element;
    Element next;  ///< the child, of any kind, to be visited next; null: the end
    Place inside;
    std::optional<OpenGroup> group;
    bool is_use = false;  ///< its end removes the last entry of used_
  };

  Status visit(Element element, Place place);
  bool is_visible(Element element, bool inherited);
  Status visit_known(Element element, const Place& place);
  void open_children(Element element, const Place& place, const std::optional<OpenGroup>& group);
  Status visit_open(std::size_t count);
  Status visit_group(Element element, const Place& place);
  Status visit_nested_svg(Element element, Place place);
  Status visit_shape(Element element, const Place& place);
  Status visit_plain(Element element, const Place& place);
  Status read_plain(Element element, const Place& place);
  Status keep_subpaths(Element element, std::span<const Subpath> subpaths, TableMemory& memory,
                       std::vector<std::vector<Vec2>>& kept);
  Status add_plain(Element element, const Place& place, PlainShape shape);
  Status add_plain_layer(Element element, const std::optional<PlainPaint>& paint,
                         std::uint32_t& layer);
  Status push_item(Element element, StackItem item);
  Status visit_use(Element element, Place place);
  Status visit_used(Element target, Element use, Place place);
  Status visit_symbol(Element symbol, const Place& place);
  Status draw_layer(Element element, const Place& place);
  Result<std::uint32_t> layer_of(Element element, const Place& place);
  Status draw_strokes(Element element, const Place& place);
  Status read_background(Element element, const Place& place);

  Result<Affine> own_transform(Element element);
  Result<Affine> viewport_transform(Element element, Element use);
  Result<OpenGroup> open_group(Element element, const Place& place);
  Status close_group(Element element, const OpenGroup& group);
  void note_unused(Element element, Unused& unused) const;
  void warn_of_unused();
  Status count_visit(Element element, const Place& place);
  Status check_map(Element element, const Affine& map);
  std::string_view id_for(Element element, const Place& place) const;

  Input& input_;
  Document& document_;
  std::vector<PlainShape>* plain_;
  Totals totals_;
  Paints paints_;
  CurveReader curves_;
  std::unordered_map<const void*, std::uint32_t> layer_of_;
  std::vector<std::vector<CurveSource>> sources_;  ///< of each layer
  std::vector<OpenElement> open_;                  ///< outermost first
  std::vector<Element> used_;  ///< the targets of the <use>s around this place, outermost first
  int group_height_ = 0;       ///< height of the closed groups in the open one
  bool may_be_background_ = true;
};

}  // namespace sfumato::svg
