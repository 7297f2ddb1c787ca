#include "formats/svg/paint/plain_image.hpp"

#include <algorithm>

#include "base/boxes.hpp"
#include "base/try.hpp"
#include "formats/svg/paint/image_place.hpp"
#include "formats/svg/paint/paint_attributes.hpp"
#include "formats/svg/read/plain_reader.hpp"

namespace sfumato::svg {
namespace {

bool has_area(const Box& box) {
  return box.width() > 0 && box.height() > 0;
}

}  // namespace

Result<PlainImage> read_plain_image(Input& input, TextureFiles& files, const StyleScope& scope,
                                    const Affine& artboard_from_user, const Box& viewport) {
  const Element element = scope.element();
  SFUMATO_TRY_ASSIGN(const TextureFile* file, files.find(element));
  const Box texels{{0, 0}, file->size()};
  SFUMATO_TRY_ASSIGN(const Box& box, read_image_box(input, scope, viewport, texels.max));
  if (!has_area(box)) return PlainImage{};
  SFUMATO_TRY_ASSIGN(const AspectRatio& ratio, read_aspect_ratio(input, element));
  const Affine user_from_texture = fit(texels, box, ratio);
  PlainImage image{{file, artboard_from_user * user_from_texture, false, {}}, {}};
  if (!is_usable(image.texture.layer_from_texture)) {
    return input.error(element,
                       "the place of the <image> cannot be computed; use sizes and "
                       "transforms of usual size");
  }
  image.visible = intersection(box, {user_from_texture(texels.min), user_from_texture(texels.max)});
  return image;
}

Result<std::vector<Subpath>> box_outline(const Context& context, const Box& box,
                                         TableMemory& memory) {
  PathBuilder builder(context, memory);
  builder.move_to(box.min);
  builder.line_to({box.max.x, box.min.y});
  builder.line_to(box.max);
  builder.line_to({box.min.x, box.max.y});
  builder.close();
  return builder.take();
}

/// Leaves out a faulty image, with a warning for each file.
Status PlainReader::visit_image(Element element, const Place& place) {
  may_be_background_ = false;
  if (!place.is_visible) return ok_status();
  Status status = read_image(element, place);
  if (status || !can_be_left_out(status)) return status;
  input_.warn("/image " + status.message, element, "<image> is left out: " + status.message);
  return ok_status();
}

/// An image is a rectangle that is filled with a texture.
Status PlainReader::read_image(Element element, const Place& place) {
  levels_.set(elements_around(open_.size()));
  SFUMATO_TRY_ASSIGN(
      const PlainImage& image,
      read_plain_image(input_, paints_.files(), StyleScope(element, levels_.around()),
                       place.frame_from_user, viewport_in(place)));
  if (!has_area(image.visible)) return ok_status();
  PlainStyle(input_, element, levels_, viewport_in(place))
      .warn_of_rendering(css::Property::image_rendering);
  TableMemory memory("control points");
  const auto outline = box_outline(input_.context(), image.visible, memory);
  if (!outline) return input_.placed(element, outline.status());
  SFUMATO_TRY_ASSIGN(const std::uint32_t shader, paints_.texture(element, image.texture));
  PlainShape shape = unpainted(element, place);
  shape.fill = PlainPaint{std::nullopt, shader, 1};
  SFUMATO_TRY_ASSIGN(shape.clip, clip_to_markers(shape, image.visible));
  return keep_plain(element, place, std::move(shape), *outline, css::kNormalPaintOrder, {});
}

Status PlainReader::paint_backdrop(const Box& box, const PlainPaint& paint) {
  const Element root = input_.root();
  TableMemory memory("control points"), kept("shapes");
  const auto outline = box_outline(input_.context(), box, memory);
  if (!outline) return input_.placed(root, outline.status());
  PlainShape shape;
  shape.fill = paint;
  SFUMATO_TRY(keep_subpaths(root, *outline, kept, shape.subpaths));
  SFUMATO_TRY(add_plain_layer(root, shape.fill, shape.fill_layer));
  input_.memory().shapes.take(std::move(kept));
  return input_.push_back(root, input_.memory().shapes, plain_.shapes, std::move(shape));
}

}  // namespace sfumato::svg
