#include "formats/svg/read/stack_reader.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/paint/background.hpp"
#include "formats/svg/paint/paint_attributes.hpp"
#include "formats/svg/read/bare.hpp"
#include "formats/svg/shapes/element_transform.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "formats/svg/style/vocabulary.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// Elements that paint nothing where they stand.
constexpr std::array<std::string_view, 16> kNotPainted{
    "defs",    "metadata",       "title",          "desc",     "style", "symbol",
    "pattern", "linearGradient", "radialGradient", "clipPath", "mask",  "filter",
    "marker",  "script",         "cursor",         "view"};

constexpr std::size_t kFirstWords = 40;  ///< bytes of a text that a warning shows

/// Returns the beginning of the characters in an element, white space collapsed.
std::string first_words(Element text) {
  std::string words;
  for (Element at = text.first_child(); at && words.size() < kFirstWords;) {
    if (at.type() == pugi::node_pcdata || at.type() == pugi::node_cdata) {
      for (const char c : std::string_view(at.value())) {
        const bool is_space = std::string_view(" \t\n\r").find(c) != std::string_view::npos;
        if (is_space && (words.empty() || words.back() == ' ')) continue;
        words += is_space ? ' ' : c;
        if (words.size() >= kFirstWords) break;
      }
    }
    Element next = at.first_child() ? at.first_child() : at.next_sibling();
    while (!next && at.parent() && at.parent() != text) {
      at = at.parent();
      next = at.next_sibling();
    }
    at = next;
  }
  return std::string(ascii_trimmed(words));
}

/// Returns the image-domain shaders that the layer's curves use.
std::size_t count_shaders(const Layer& layer) {
  std::set<std::uint32_t> shaders;
  const auto note = [&shaders](const auto& side) {
    if (side.kind == ShaderKind::image_domain) shaders.insert(side.shader);
  };
  for (const Curve& curve : layer.curves) {
    note(curve.left.color);
    note(curve.left.opacity);
    note(curve.right.color);
    note(curve.right.opacity);
  }
  return shaders.size();
}

/// Returns whether a gradient is a colour of Inkscape's palette, which is not there to be drawn.
bool is_swatch(Element gradient) {
  return std::ranges::any_of(gradient.attributes(), [](const pugi::xml_attribute& attribute) {
    const std::string_view name = attribute.name();
    return (name.ends_with(":swatch") || name.ends_with(":paint")) &&
           std::string_view(attribute.value()) == "solid";
  });
}

}  // namespace

bool paints_nothing(std::string_view name) {
  return std::ranges::find(kNotPainted, name) != kNotPainted.end();
}

Status StackReader::read() {
  Status status = visit_root({});
  if (status) warn_of_unused();
  document_.shaders = paints_.take();
  return status;
}

Status StackReader::visit_root(Place place) {
  const Element root = input_.root();
  place.is_visible = is_visible(root, true);
  const bool is_displayed = input_.keyword(root, css::Property::display) != "none";
  Status status = is_displayed ? visit_group(root, place) : ok_status();
  return status ? visit_open(0) : status;
}

/// Layers and paints in the element that were not asked for, all the way down.
void StackReader::note_unused(Element element, Unused& unused) const {
  const std::string_view name = element.name();
  const bool is_paint = name == "linearGradient" || name == "radialGradient" || name == "pattern";
  if (is_paint && !paints_.is_used(element) && !is_swatch(element)) {
    if (unused.paints++ == 0) unused.first_paint = element;
  } else if (name == "g" && input_.sf(element, "diffuse").value_or("") == "true" &&
             !layer_of_.contains(element.internal_object())) {
    if (unused.layers++ == 0) unused.first_layer = element;
  }
  for (const Element child : element.children()) {
    if (child.type() == pugi::node_element) note_unused(child, unused);
  }
}

void StackReader::warn_of_unused() {
  Unused unused;
  note_unused(input_.root(), unused);
  const auto warn = [this](Element first, std::size_t count, const char* kind) {
    if (count == 0) return;
    const std::string others = count == 1 ? "" : " (and " + std::to_string(count - 1) + " more)";
    const std::string name = first.attribute("id").empty() ? "without an id" : hash_id(first);
    input_.warn(
        std::string("/unused ") + kind, first,
        std::string("the ") + kind + " " + name + others + " is drawn nowhere; it is left out");
  };
  warn(unused.first_layer, unused.layers, "layer");
  warn(unused.first_paint, unused.paints, "paint");
}

/// One element wherever it stands: whether it is painted at all, and its transform.
Status StackReader::visit(Element element, Place place) {
  SFUMATO_TRY(count_visit(element, place));
  if (!is_shown(element, place)) return ok_status();
  place.is_visible = is_visible(element, place.is_visible);
  SFUMATO_TRY_ASSIGN(const Affine& own, own_transform(element, place));
  place.frame_from_user = place.frame_from_user * own;
  if (place.frame_from_user.determinant() == 0) {
    input_.warn("/flat", element,
                tag(element) + " is flattened to nothing by its transform; it is left out");
    return ok_status();
  }
  Status status = check_map(element, place.frame_from_user);
  if (!status) return leave_out(element, place, std::move(status));
  return visit_effects(element, place);
}

bool StackReader::is_shown(Element element, const Place&) {
  return !paints_nothing(element.name()) &&
         input_.keyword(element, css::Property::display) != "none";
}

bool StackReader::is_ordinary(const Place&) const {
  return false;
}

Status StackReader::visit_effects(Element element, Place place) {
  warn_of_effects(input_, element, {});
  return visit_known(element, place);
}

/// Clips and masks cut ordinary shapes alone.
void StackReader::warn_of_uncut(Element element, const Place& place) {
  if (!place.clip && !place.mask) return;
  input_.warn("/uncut", element,
              tag(element) +
                  " has attributes of Sfumato; the clips and masks around it, and its "
                  "own, do not cut it");
}

Status StackReader::open_inside(Element, Place&) {
  return ok_status();
}

bool StackReader::is_bare(Element) const {
  return false;
}

Status StackReader::clip_to_box(Element, const Box&, Place&) {
  return ok_status();
}

Status StackReader::leave_out(Element, const Place&, Status status) {
  return status;
}

/// `visibility`, which is inherited through <use> too.
bool StackReader::is_visible(Element element, bool inherited) {
  const Input::Cascaded visibility = input_.cascaded(element, css::Property::visibility);
  if (visibility.keyword == css::WideKeyword::initial) return true;
  if (!visibility.value) return inherited;
  return css::keyword_of(*visibility.value, input_.text_poll()) == "visible";
}

Status StackReader::visit_known(Element element, const Place& place) {
  const std::string_view name = element.name();
  if (name == "g" || name == "a") return visit_group(element, place);
  if (name == "use") return visit_use(element, place);
  if (name == "svg" || name == "symbol") return visit_nested_svg(element, place);
  if (is_shape(name)) return visit_shape(element, place);
  warn_of_unread(element);
  return ok_status();
}

void StackReader::warn_of_unread(Element element) {
  // A picture to trace over is meant for editors.
  if (input_.sf(element, "reference") == "true") return;
  if (std::string_view(element.name()) == "text") {
    input_.warn(
        "text", element,
        "the text " + text::quoted(first_words(element)) +
            " is not read; convert text to paths before (in Inkscape: Path > Object to Path)");
    return;
  }
  input_.warn(element.name(), element, tag(element) + " is not read; such elements are ignored");
}

Status StackReader::count_visit(Element element, const Place& place) {
  if (static_cast<std::size_t>(place.depth) >= input_.limits().xml_depth) {
    return input_.over_limit(element, &Limits::xml_depth,
                             "elements within each other after every use was followed");
  }
  if (!place.is_copy) return ok_status();
  return input_.charge_reading(element, scope_.reading);
}

Status StackReader::check_map(Element element, const Affine& map) {
  if (is_usable(map)) return ok_status();
  return input_.error(element, "the transforms around " + tag(element) +
                                   " together are too large or too small; use entries of "
                                   "usual size");
}

Result<Affine> StackReader::own_transform(Element element, const Place& place) {
  return element_transform(input_, element, viewport_in(place));
}

void StackReader::open_children(Element element, const Place& place,
                                const std::optional<OpenGroup>& group) {
  OpenElement open{element, element.first_child(), place, group};
  ++open.inside.depth;
  open.inside.use = {};
  open.inside.own_opacity = 1;
  open_.push_back(std::move(open));
}

/// Visits the content of the open elements, and closes them, until `count` are left. Uses a
/// separate stack, because elements may be nested deeper than a thread's small stack allows.
Status StackReader::visit_open(std::size_t count) {
  Status status = ok_status();
  while (status && open_.size() > count) {
    if (status = input_.check(); !status) break;
    OpenElement& top = open_.back();
    if (const Element child = top.next) {
      top.next = child.next_sibling();
      if (child.type() == pugi::node_element) status = visit_child(child, top);
    } else {
      const OpenElement done = top;
      open_.pop_back();
      if (done.is_use) used_.pop_back();
      if (done.group) status = close_group(done.element, *done.group);
    }
  }
  return status;
}

Status StackReader::visit_child(Element child, OpenElement& parent) {
  return visit(child, parent.inside);
}

Status StackReader::visit_group(Element element, const Place& place) {
  const std::string_view diffuse = input_.sf(element, "diffuse").value_or("false");
  if (diffuse == "true") return draw_layer(element, place);
  if (diffuse != "false") {
    return input_.error(element, "sf:diffuse of " + tag(element) + " is " + text::quoted(diffuse) +
                                     "; use true or false");
  }
  SFUMATO_TRY_ASSIGN(const OpenGroup& group, open_group(element, place));
  Place inside = place;
  SFUMATO_TRY(open_inside(element, inside));
  open_children(element, inside, group);
  return ok_status();
}

/// Returns the element to which a <use> refers. It is not an element around the <use>.
Result<Element> StackReader::use_target(Element use, const Place& place) {
  SFUMATO_TRY_ASSIGN(auto&& target, input_.referred(use));
  // A document of Sfumato is refused once it has gone round.
  const auto open = std::span(open_).subspan(scope_.open_begin);
  const auto used = std::span(used_).subspan(scope_.used_begin);
  const bool is_around =
      is_ordinary(place) && std::ranges::find(open, target, &OpenElement::element) != open.end();
  const bool is_used = std::ranges::find(used, target) != used.end();
  if (!is_around && !is_used && target != input_.root()) return std::move(target);
  std::string chain;
  for (const Element element : used_) chain += hash_id(element) + " → ";
  return input_.error(use, "the <use> goes round in a circle: " + chain + hash_id(target));
}

Status StackReader::visit_use(Element element, Place place) {
  const Result<Element> target = use_target(element, place);
  if (!target) return leave_out(element, place, target.status());
  const Box& viewport = viewport_in(place);
  const Result<double> x = length_of(input_, element, "x", viewport, Axis::x, 0);
  if (!x) return leave_out(element, place, x.status());
  const Result<double> y = length_of(input_, element, "y", viewport, Axis::y, 0);
  if (!y) return leave_out(element, place, y.status());
  const Place outside = place;
  place.frame_from_user = place.frame_from_user * Affine{1, 0, 0, 1, *x, *y};
  SFUMATO_TRY_ASSIGN(const OpenGroup& group, open_group(element, place));
  OpenElement open{element, {}, place, group, true};
  open.outside = outside;
  open_.push_back(std::move(open));
  place.own_opacity = 1;
  return visit_used(*target, element, place);
}

Status StackReader::visit_used(Element target, Element use, Place place) {
  used_.push_back(target);
  ++place.depth;
  place.use = use;
  place.is_copy = true;
  const bool is_symbol = std::string_view(target.name()) == "symbol";
  return is_symbol ? visit_symbol(target, place) : visit(target, place);
}

/// Returns the id of a curve: its own id or, for a copy, the id of its <use> or none.
std::string_view StackReader::id_for(Element element, const Place& place) const {
  if (!place.is_copy) return element.attribute("id").value();
  return place.use ? std::string_view(place.use.attribute("id").value()) : std::string_view();
}

Status StackReader::visit_shape(Element element, const Place& place) {
  if (!place.is_visible) return ok_status();
  const bool is_local = input_.sf(element, "radius").has_value();
  if (place.layer) {
    if (is_local) {
      return input_.error(element, tag(element) +
                                       " with sf:radius is a local curve and stands in "
                                       "a layer; move it before or after the layer");
    }
    if (!input_.has_sf(element)) input_.warn("/bare", element, why_bare(input_, element));
    return curves_.read_curves(element, place.frame_from_user, id_for(element, place),
                               place.layer->curves, *place.sources);
  }
  if (is_local) return draw_strokes(element, place);
  if (!input_.has_sf(element)) return visit_bare(element, place);
  return input_.error(element, tag(element) +
                                   " has attributes of a diffusion curve but stands in "
                                   "no layer; put it in <g sf:diffuse=\"true\">, "
                                   "or with sf:radius to be a local curve");
}

/// Returns the background if a shape is one and the background may still come.
Result<BackgroundRect> StackReader::background_rect(Element element, const Place& place) {
  if (!may_be_background_) return BackgroundRect{};
  return read_background_rect(input_, element, place.frame_from_user, document_.artboard,
                              viewport_in(place));
}

/// An explicit background takes precedence over one that is painted for other programs.
void StackReader::set_background(const BackgroundRect& rect) {
  if (!input_.sf(input_.root(), "background")) document_.background = rect.color;
}

Status StackReader::visit_bare(Element element, const Place& place) {
  SFUMATO_TRY_ASSIGN(const BackgroundRect& rect, background_rect(element, place));
  may_be_background_ = false;
  if (rect.covers) {
    set_background(rect);
  } else {
    input_.warn(element.name(), element,
                tag(element) +
                    " has no attribute of Sfumato and is ignored; put it in a "
                    "layer, or a <rect> over the whole viewBox as the background");
  }
  return ok_status();
}

Status StackReader::draw_strokes(Element element, const Place& place) {
  may_be_background_ = false;
  warn_of_uncut(element, place);
  std::vector<LocalCurve> strokes;
  SFUMATO_TRY_ASSIGN(const OpenGroup& group, open_group(element, place));
  SFUMATO_TRY(curves_.read_local_curves(element, id_for(element, place), strokes));
  for (LocalCurve& stroke : strokes) {
    SFUMATO_TRY(push_item(element, LocalStroke{std::move(stroke), place.frame_from_user}));
  }
  input_.memory().curves.free(strokes);
  return close_group(element, group);
}

Status StackReader::draw_layer(Element element, const Place& place) {
  may_be_background_ = false;
  if (place.layer) {
    return input_.error(element, "the layer " + hash_id(element) +
                                     " is inside another layer; put layers side by side");
  }
  if (!place.is_visible) return ok_status();
  warn_of_uncut(element, place);
  SFUMATO_TRY_ASSIGN(const Compositing& compositing, read_compositing(input_, element));
  SFUMATO_TRY_ASSIGN(const std::uint32_t layer, layer_of(element, place));
  return push_item(
      element, LayerInstance{layer, place.frame_from_user, compositing.opacity * place.own_opacity,
                             compositing.blend});
}

Status StackReader::push_item(Element element, StackItem item) {
  SFUMATO_TRY(totals_.count_stack_item(element));
  return input_.push_back(element, input_.memory().stack, document_.stack, std::move(item));
}

/// Returns the layer's index; reads it where this is its first place.
Result<std::uint32_t> StackReader::layer_of(Element element, const Place& place) {
  const auto known = layer_of_.find(element.internal_object());
  if (known != layer_of_.end()) return known->second;
  if (document_.layers.size() >= input_.limits().layers) {
    return input_.over_limit(element, &Limits::layers, "layers");
  }
  Layer layer{element.attribute("id").value(), {}};
  std::vector<CurveSource> sources;
  Place inside;
  inside.layer = &layer;
  inside.sources = &sources;
  inside.depth = place.depth;
  const std::size_t open_around = open_.size();
  open_children(element, inside, std::nullopt);
  SFUMATO_TRY(visit_open(open_around));
  if (layer.curves.empty()) {
    input_.warn("/empty layer", element, "the layer has no curves and paints nothing");
  }
  if (count_shaders(layer) > input_.limits().shaders_per_layer) {
    return input_.over_limit(element, &Limits::shaders_per_layer, "paints in one layer");
  }
  const auto index = static_cast<std::uint32_t>(document_.layers.size());
  TableMemory& memory = input_.memory().stack;
  SFUMATO_TRY(input_.push_back(element, memory, document_.layers, std::move(layer)));
  SFUMATO_TRY(input_.push_back(element, memory, sources_, std::move(sources)));
  layer_of_.emplace(element.internal_object(), index);
  return index;
}

Result<StackReader::OpenGroup> StackReader::open_group(Element element, const Place& place) {
  SFUMATO_TRY_ASSIGN(const Compositing& compositing, read_compositing(input_, element));
  OpenGroup group{compositing, document_.stack.size(), group_height_, false};
  if (is_bare(element)) return group;
  group.compositing.opacity *= place.own_opacity;
  if (place.layer) {
    if (compositing.opacity != 1 || compositing.blend != BlendMode::normal) {
      input_.warn("/opacity in a layer", element,
                  "opacity and mix-blend-mode of " + tag(element) +
                      " mean nothing within a layer; put them on the layer, or sf:opacity on "
                      "its curves");
    }
    return group;
  }
  if (group.compositing.is_plain()) return group;
  SFUMATO_TRY(push_item(element, GroupBegin{group.compositing.opacity, group.compositing.blend}));
  group.is_open = true;
  group_height_ = 0;
  return group;
}

/// A group of one layer is that layer: its own blending meets nothing within the group.
Status StackReader::close_group(Element element, const OpenGroup& group) {
  if (!group.is_open) return ok_status();
  const int height = group_height_;
  group_height_ = group.outer_height;
  std::vector<StackItem>& stack = document_.stack;
  const std::size_t items = stack.size() - group.begin - 1;
  if (items == 0) {
    stack.pop_back();
    return ok_status();
  }
  if (auto* only = std::get_if<LayerInstance>(&stack.back()); only && items == 1) {
    only->opacity *= group.compositing.opacity;
    only->blend = group.compositing.blend;
    stack.erase(stack.end() - 2);
    return ok_status();
  }
  if (static_cast<std::size_t>(height) + 1 > input_.limits().group_depth) {
    return input_.over_limit(element, &Limits::group_depth,
                             "groups within each other that are composited by themselves");
  }
  group_height_ = std::max(group_height_, height + 1);
  return push_item(element, GroupEnd{});
}

}  // namespace sfumato::svg
