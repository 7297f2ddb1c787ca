#include "formats/svg/stack_reader.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "formats/css/value.hpp"
#include "formats/svg/background.hpp"
#include "formats/svg/bare.hpp"
#include "formats/svg/paint_attributes.hpp"
#include "formats/svg/shapes.hpp"
#include "formats/svg/transform.hpp"
#include "formats/svg/view_box.hpp"
#include "formats/svg/vocabulary.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// Elements that paint nothing where they stand.
constexpr std::array<std::string_view, 16> kNotPainted{
    "defs",    "metadata",       "title",          "desc",     "style", "symbol",
    "pattern", "linearGradient", "radialGradient", "clipPath", "mask",  "filter",
    "marker",  "script",         "cursor",         "view"};

bool paints_nothing(std::string_view name) {
  return std::ranges::find(kNotPainted, name) != kNotPainted.end();
}

/// The image-domain shaders that the layer's curves use.
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

}  // namespace

Status StackReader::read() {
  Status status = visit_group(input_.root(), {});
  if (status) status = visit_open(0);
  if (status && !plain_) warn_of_unused();
  document_.shaders = paints_.take();
  return status;
}

/// Layers and paints in the element that were not asked for, all the way down.
void StackReader::note_unused(Element element, Unused& unused) const {
  const std::string_view name = element.name();
  const bool is_paint = name == "linearGradient" || name == "radialGradient" || name == "pattern";
  if (is_paint && !paints_.is_used(element)) {
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
  if (Status status = count_visit(element, place); !status) return status;
  const std::string_view name = element.name();
  if (paints_nothing(name) || input_.keyword(element, css::Property::display) == "none") {
    return ok_status();
  }
  place.is_visible = is_visible(element, place.is_visible);
  const Result<Affine> own = own_transform(element);
  if (!own) return own.status();
  place.frame_from_user = place.frame_from_user * *own;
  if (place.frame_from_user.determinant() == 0) {
    input_.warn("/flat", element,
                tag(element) + " is flattened to nothing by its transform; it is left out");
    return ok_status();
  }
  if (Status status = check_map(element, place.frame_from_user); !status) return status;
  warn_of_effects(input_, element);
  return visit_known(element, place);
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
  if (name == "svg") return visit_nested_svg(element, place);
  if (is_shape(name)) return visit_shape(element, place);
  input_.warn(name, element, tag(element) + " is not read; such elements are ignored");
  return ok_status();
}

Status StackReader::count_visit(Element element, const Place& place) {
  if (static_cast<std::size_t>(place.depth) >= input_.limits().xml_depth) {
    return input_.over_limit(element, &Limits::xml_depth,
                             "elements within each other after every use was followed");
  }
  if (!place.is_copy) return ok_status();
  return input_.charge_reading(element, "<use>");
}

Status StackReader::check_map(Element element, const Affine& map) {
  if (is_usable(map)) return ok_status();
  return input_.error(element, "the transforms around " + tag(element) +
                                   " together are too large or too small; expected entries of "
                                   "usual size");
}

Result<Affine> StackReader::own_transform(Element element) {
  if (input_.is_styled(element, css::Property::transform)) {
    input_.warn("/style transform", element,
                "a transform in style is not read; expected the attribute transform");
  }
  Result<Affine> map = parse_transform(input_.context(), element.attribute("transform").value());
  if (!map) return input_.in(element, "transform", map.status());
  return map;
}

void StackReader::open_children(Element element, const Place& place,
                                const std::optional<OpenGroup>& group) {
  OpenElement open{element, element.first_child(), place, group, false};
  ++open.inside.depth;
  open.inside.use = {};
  open_.push_back(std::move(open));
}

/// Visits what is in the open elements, and closes them, until `count` are left. A stack of our
/// own: elements may lie deeper than a thread's small stack reaches.
Status StackReader::visit_open(std::size_t count) {
  Status status = ok_status();
  while (status && open_.size() > count) {
    if (status = input_.check(); !status) break;
    OpenElement& top = open_.back();
    if (const Element child = top.next) {
      top.next = child.next_sibling();
      if (child.type() == pugi::node_element) status = visit(child, Place(top.inside));
    } else {
      const OpenElement done = top;
      open_.pop_back();
      if (done.is_use) used_.pop_back();
      if (done.group) status = close_group(done.element, *done.group);
    }
  }
  return status;
}

Status StackReader::visit_group(Element element, const Place& place) {
  const std::string_view diffuse = input_.sf(element, "diffuse").value_or("false");
  if (diffuse == "true") return draw_layer(element, place);
  if (diffuse != "false") {
    return input_.error(element, "sf:diffuse of " + tag(element) + " is " + text::quoted(diffuse) +
                                     "; expected true or false");
  }
  const Result<OpenGroup> group = open_group(element, place);
  if (!group) return group.status();
  open_children(element, place, *group);
  return ok_status();
}

/// An <svg> within the document, or a symbol: `use` gives its size where it is set.
Result<Affine> StackReader::viewport_transform(Element element, Element use) {
  const Box& viewport = document_.artboard;
  const auto size_of = [&](const char* name, Axis axis) {
    const Element bearer = use && use.attribute(name) ? use : element;
    return length_of(input_, bearer, name, viewport, axis, extent(viewport, axis));
  };
  Vec2 corner;
  if (std::string_view(element.name()) == "svg") {
    const Result<double> x = length_of(input_, element, "x", viewport, Axis::x, 0);
    if (!x) return x.status();
    const Result<double> y = length_of(input_, element, "y", viewport, Axis::y, 0);
    if (!y) return y.status();
    corner = {*x, *y};
  }
  const auto view_box = input_.attribute(element, "viewBox");
  if (!view_box) return Affine{1, 0, 0, 1, corner.x, corner.y};
  const Result<double> width = size_of("width", Axis::x);
  if (!width) return width.status();
  const Result<double> height = size_of("height", Axis::y);
  if (!height) return height.status();
  const Result<Box> box = parse_view_box(*view_box);
  if (!box) return input_.in(element, "viewBox", box.status());
  AspectRatio ratio;
  if (const auto text = input_.attribute(element, "preserveAspectRatio")) {
    const Result<AspectRatio> parsed = parse_aspect_ratio(*text);
    if (!parsed) return input_.in(element, "preserveAspectRatio", parsed.status());
    ratio = *parsed;
  }
  if (input_.keyword(element, css::Property::overflow) != "visible") {
    input_.warn("/overflow", element,
                tag(element) + " is not clipped to its viewport; expected overflow=\"visible\"");
  }
  return fit(*box, {corner, corner + Vec2{*width, *height}}, ratio);
}

Status StackReader::visit_nested_svg(Element element, Place place) {
  const Result<Affine> user_from_view = viewport_transform(element, place.use);
  if (!user_from_view) return user_from_view.status();
  place.frame_from_user = place.frame_from_user * *user_from_view;
  if (Status status = check_map(element, place.frame_from_user); !status) return status;
  return visit_group(element, place);
}

Status StackReader::visit_use(Element element, Place place) {
  const Result<Element> target = input_.referred(element);
  if (!target) return target.status();
  const Box& viewport = document_.artboard;
  const Result<double> x = length_of(input_, element, "x", viewport, Axis::x, 0);
  if (!x) return x.status();
  const Result<double> y = length_of(input_, element, "y", viewport, Axis::y, 0);
  if (!y) return y.status();
  place.frame_from_user = place.frame_from_user * Affine{1, 0, 0, 1, *x, *y};
  const Result<OpenGroup> group = open_group(element, place);
  if (!group) return group.status();
  open_.push_back({element, {}, place, *group, true});
  return visit_used(*target, element, place);
}

Status StackReader::visit_used(Element target, Element use, Place place) {
  if (std::ranges::find(used_, target) != used_.end() || target == input_.root()) {
    std::string chain;
    for (const Element element : used_) chain += hash_id(element) + " → ";
    return input_.error(use, "the <use> goes round in a circle: " + chain + hash_id(target));
  }
  used_.push_back(target);
  ++place.depth;
  place.use = use;
  place.is_copy = true;
  const bool is_symbol = std::string_view(target.name()) == "symbol";
  return is_symbol ? visit_symbol(target, place) : visit(target, place);
}

Status StackReader::visit_symbol(Element symbol, const Place& place) {
  if (Status status = count_visit(symbol, place); !status) return status;
  return visit_nested_svg(symbol, place);
}

/// The id of a curve: its own; of a copy that of its <use>, or none.
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
                                       "a layer; expected it before or after the layer");
    }
    if (!input_.has_sf(element)) input_.warn("/bare", element, why_bare(input_, element));
    return curves_.read_curves(element, place.frame_from_user, id_for(element, place),
                               place.layer->curves, *place.sources);
  }
  if (is_local) return draw_strokes(element, place);
  if (!input_.has_sf(element)) return read_background(element, place);
  return input_.error(element, tag(element) +
                                   " has attributes of a diffusion curve but stands in "
                                   "no layer; expected it in <g sf:diffuse=\"true\">, "
                                   "or with sf:radius to be a local curve");
}

/// A shape without attributes of ours, outside of layers.
Status StackReader::read_background(Element element, const Place& place) {
  const Result<BackgroundRect> rect =
      may_be_background_
          ? read_background_rect(input_, element, place.frame_from_user, document_.artboard)
          : Result<BackgroundRect>(BackgroundRect{});
  if (!rect) return rect.status();
  may_be_background_ = false;
  if (plain_ && !rect->color) return visit_plain(element, place);
  if (!rect->covers) {
    input_.warn(element.name(), element,
                tag(element) +
                    " has no attribute of Sfumato and is ignored; expected it in a "
                    "layer, or a <rect> over the whole viewBox as the background");
    return ok_status();
  }
  // What the document says outright goes before what it paints for other programs.
  if (!input_.sf(input_.root(), "background")) document_.background = rect->color;
  return ok_status();
}

Status StackReader::draw_strokes(Element element, const Place& place) {
  may_be_background_ = false;
  std::vector<LocalCurve> strokes;
  const Result<OpenGroup> group = open_group(element, place);
  if (!group) return group.status();
  Status status = curves_.read_local_curves(element, id_for(element, place), strokes);
  for (LocalCurve& stroke : strokes) {
    if (status) {
      status = push_item(element, LocalStroke{std::move(stroke), place.frame_from_user});
    }
    if (!status) return status;
  }
  input_.memory().curves.free(strokes);
  return status ? close_group(element, *group) : status;
}

Status StackReader::draw_layer(Element element, const Place& place) {
  may_be_background_ = false;
  if (place.layer) {
    return input_.error(element, "the layer " + hash_id(element) +
                                     " stands in another layer; expected layers side by side");
  }
  if (!place.is_visible) return ok_status();
  const Result<Compositing> compositing = read_compositing(input_, element);
  if (!compositing) return compositing.status();
  const Result<std::uint32_t> layer = layer_of(element, place);
  if (!layer) return layer.status();
  return push_item(element, LayerInstance{*layer, place.frame_from_user, compositing->opacity,
                                          compositing->blend});
}

Status StackReader::push_item(Element element, StackItem item) {
  if (Status status = totals_.count_stack_item(element); !status) return status;
  return input_.push_back(element, input_.memory().stack, document_.stack, std::move(item));
}

/// The layer's index; reads it where this is its first place.
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
  if (Status status = visit_open(open_around); !status) return status;
  if (layer.curves.empty()) {
    input_.warn("/empty layer", element, "the layer has no curves and paints nothing");
  }
  if (count_shaders(layer) > input_.limits().shaders_per_layer) {
    return input_.over_limit(element, &Limits::shaders_per_layer, "paints in one layer");
  }
  const auto index = static_cast<std::uint32_t>(document_.layers.size());
  Status status =
      input_.push_back(element, input_.memory().stack, document_.layers, std::move(layer));
  if (status) {
    status = input_.push_back(element, input_.memory().stack, sources_, std::move(sources));
  }
  if (!status) return status;
  layer_of_.emplace(element.internal_object(), index);
  return index;
}

Result<StackReader::OpenGroup> StackReader::open_group(Element element, const Place& place) {
  const Result<Compositing> compositing = read_compositing(input_, element);
  if (!compositing) return compositing.status();
  OpenGroup group{*compositing, document_.stack.size(), group_height_, false};
  if (place.layer) {
    if (compositing->opacity != 1 || compositing->blend != BlendMode::normal) {
      input_.warn("/opacity in a layer", element,
                  "opacity and mix-blend-mode of " + tag(element) +
                      " mean nothing within a layer; expected them on the layer, or sf:opacity on "
                      "its curves");
    }
    return group;
  }
  if (compositing->is_plain()) return group;
  Status status = push_item(element, GroupBegin{compositing->opacity, compositing->blend});
  if (!status) return status;
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
