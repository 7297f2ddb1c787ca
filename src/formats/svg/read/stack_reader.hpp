#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "formats/svg/paint/paints.hpp"
#include "formats/svg/read/compositing.hpp"
#include "formats/svg/read/curve_reader.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "formats/svg/read/totals.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg {

struct BackgroundRect;

/// Traverses the document and builds layers and the stack. Each layer is read where it is first
/// drawn; every later drawing of it is an instance.
///
/// This class reads Sfumato's own content. The further work of an import is virtual, so a program
/// that imports nothing contains no code for it, which matters in WebAssembly.
class StackReader {
 public:
  /// Fills document.layers, shaders, stack and, from a <rect>, background. The artboard is set.
  StackReader(Input& input, Document& document, const ResourceLoader* loader)
      : input_(input),
        document_(document),
        totals_(input),
        paints_(input, totals_, loader),
        curves_(input, totals_, paints_, document.artboard) {}
  virtual ~StackReader() = default;
  StackReader(const StackReader&) = delete;
  StackReader& operator=(const StackReader&) = delete;

  /// Errors: bad_input, limit, out_of_memory.
  Status read();
  /// Returns the source of each curve of each layer. Call once, after read().
  std::vector<std::vector<CurveSource>> take_sources() { return std::move(sources_); }

 protected:
  /// The current place of the traversal.
  struct Place {
    Affine frame_from_user{};  ///< to the artboard or, in a layer, to the layer's frame
    Layer* layer = nullptr;    ///< the layer to which curves are added; null outside of layers
    std::vector<CurveSource>* sources = nullptr;  ///< of the layer's curves
    bool is_visible = true;
    std::optional<std::uint32_t> clip{};  ///< of ordinary shapes
    std::optional<std::uint32_t> mask{};  ///< likewise, of PlainContent::masks
    float own_opacity = 1;                ///< that the mask of this element alone gives
    /// The nearest one of ordinary content, in its user space, for percentages; none: the artboard.
    std::optional<Box> viewport{};
    int depth = 0;
    /// The <use>, for an element to which it refers directly.
    Element use{};
    /// Whether this is inside content to which a <use> refers. Copies do not get the id of the
    /// original.
    bool is_copy = false;
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
    bool is_use = false;                    ///< its end removes the last entry of used_
    bool is_switch = false;                 ///< no child has been chosen yet
    Place outside{};                        ///< of a <use>
    std::optional<ContextPaints> paints{};  ///< of a <use>, as soon as its content asks for them
  };

  /// That of an <svg> within the document, or of a symbol.
  struct Viewport {
    Affine user_from_view{};
    std::optional<Box> clip{};     ///< user space, for ordinary content
    std::optional<Box> content{};  ///< within it, for percentages of ordinary content
  };

  /// The target: the document, or content in it that is drawn like a separate document.
  struct Scope {
    std::string_view reading = "<use>";  ///< through which elements are read again
    std::size_t open_begin = 0;          ///< the elements that are open within it begin here
    std::size_t used_begin = 0;          ///< the targets of the <use>s within it begin here
  };

  /// Returns whether the content here is that of an ordinary SVG, which is imported.
  virtual bool is_ordinary(const Place& place) const;
  virtual bool is_shown(Element element, const Place& place);
  virtual Status visit_child(Element child, OpenElement& parent);
  virtual Status visit_known(Element element, const Place& place);
  /// A shape without attributes of ours, outside of layers.
  virtual Status visit_bare(Element element, const Place& place);
  virtual Result<Affine> own_transform(Element element, const Place& place);
  /// Visits an element with its clip and its mask, and warns of its effects that are not drawn.
  virtual Status visit_effects(Element element, Place place);
  /// Paints the backdrop of a group's content, and changes the place of that content.
  virtual Status open_inside(Element element, Place& place);
  /// Returns whether the opacity and the blend mode of an element belong to something around it.
  virtual bool is_bare(Element element) const;
  /// Clips content to a viewport. box: user space.
  virtual Status clip_to_box(Element element, const Box& box, Place& place);
  /// Returns ok after a warning where the element is left out, otherwise the failure.
  virtual Status leave_out(Element element, const Place& place, Status status);

  Status visit_root(Place place);
  Status visit(Element element, Place place);
  void warn_of_unread(Element element);
  void open_children(Element element, const Place& place, const std::optional<OpenGroup>& group);
  Status visit_open(std::size_t count);
  Status visit_group(Element element, const Place& place);
  void warn_of_uncut(Element element, const Place& place);
  Status count_visit(Element element, const Place& place);
  Status check_map(Element element, const Affine& map);
  std::string_view id_for(Element element, const Place& place) const;
  const Box& viewport_in(const Place& place) const {
    return place.viewport ? *place.viewport : document_.artboard;
  }
  Result<BackgroundRect> background_rect(Element element, const Place& place);
  void set_background(const BackgroundRect& rect);
  Result<OpenGroup> open_group(Element element, const Place& place);
  Status close_group(Element element, const OpenGroup& group);
  Status push_item(Element element, StackItem item);
  Result<Viewport> viewport_of(Element element, const Place& place);

  Input& input_;
  Document& document_;
  Totals totals_;
  Paints paints_;
  std::vector<OpenElement> open_;  ///< outermost first
  std::vector<Element> used_;      ///< the targets of the <use>s around this place, outermost first
  Scope scope_;
  bool may_be_background_ = true;

 private:
  /// The elements of one kind that are never drawn.
  struct Unused {
    Element first_layer{}, first_paint{};
    std::size_t layers = 0, paints = 0;
  };

  bool is_visible(Element element, bool inherited);
  Status visit_nested_svg(Element element, Place place);
  Status visit_shape(Element element, const Place& place);
  Status visit_use(Element element, Place place);
  Result<Element> use_target(Element use, const Place& place);
  Status visit_used(Element target, Element use, Place place);
  Status visit_symbol(Element symbol, Place place);
  Status draw_layer(Element element, const Place& place);
  Result<std::uint32_t> layer_of(Element element, const Place& place);
  Status draw_strokes(Element element, const Place& place);
  Result<Box> shown_box(Element element, const Place& place);
  void note_unused(Element element, Unused& unused) const;
  void warn_of_unused();

  CurveReader curves_;
  std::unordered_map<const void*, std::uint32_t> layer_of_;
  std::vector<std::vector<CurveSource>> sources_;  ///< of each layer
  int group_height_ = 0;                           ///< height of the closed groups in the open one
};

/// Returns whether an element paints nothing where it stands, such as <defs>.
bool paints_nothing(std::string_view element_name);

}  // namespace sfumato::svg
