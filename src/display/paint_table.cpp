#include "display/paint_table.hpp"

#include <initializer_list>
#include <span>
#include <utility>
#include <variant>

#include "base/try.hpp"
#include "raster/shaders/gradient.hpp"
#include "raster/shaders/texture_pyramid.hpp"

namespace sfumato::display {
namespace {

constexpr std::size_t kTableWidth = 2048;
constexpr float kTextureKind = 2;

class TableMaker {
 public:
  TableMaker(Context& context, PaintTexels texels, PaintTable& table)
      : context_(context), texels_(texels), table_(table) {}

  Status add(std::uint32_t index, const Shader& shader) {
    table_.first_value[index] = static_cast<std::uint32_t>(table_.values.size() / 4);
    if (const auto* fill = std::get_if<GradientFill>(&shader.paint)) return add(index, *fill);
    return add(index, std::get<Texture>(shader.paint));
  }

  /// Ends the table. Call it once all texels are added: the table keeps their charge.
  void finish() { table_.memory.take(std::move(texel_memory_)); }

 private:
  void put(double x, double y, double z, double w) {
    for (double value : {x, y, z, w}) table_.values.push_back(static_cast<float>(value));
  }
  void put(std::span<const double, 4> v) { put(v[0], v[1], v[2], v[3]); }

  /// Reserves room for `texels` more values.
  Status reserve(std::size_t texels) {
    return table_.memory.make_room(context_, table_.values, 4 * texels);
  }

  Status add(std::uint32_t index, const GradientFill& fill) {
    SFUMATO_TRY_ASSIGN(const raster::Gradient& gradient, raster::Gradient::create(context_, fill));
    const std::vector<raster::GradientSegment>& segments = gradient.segments();
    SFUMATO_TRY(reserve(5 + 4 * segments.size()));
    table_.paint_from_layer[index] = gradient.frame_from_layer();
    const Vec2 e = gradient.center_from_focus();
    put(gradient.is_radial() ? 1 : 0, static_cast<int>(gradient.spread()),
        static_cast<double>(segments.size()), 0);
    put(e.x, e.y, gradient.focal_radius(), gradient.is_cone() ? 1 : 0);
    put(gradient.first());
    put(gradient.last());
    put(gradient.total());
    for (const raster::GradientSegment& segment : segments) {
      put(segment.begin, segment.end, 0, 0);
      put(segment.value);
      put(segment.slope);
      put(segment.before);
    }
    return ok_status();
  }

  Status add(std::uint32_t index, const Texture& texture) {
    SFUMATO_TRY_ASSIGN(const raster::TexturePyramid& pyramid,
                       raster::TexturePyramid::create(context_, texture));
    const std::vector<raster::TextureLevel>& levels = pyramid.levels();
    const std::size_t base = table_.texel_count;
    table_.texel_count += levels.back().offset + 1;
    SFUMATO_TRY(reserve(1 + 2 * levels.size()));
    table_.paint_from_layer[index] = pyramid.texture_from_layer();
    put(kTextureKind, pyramid.repeats() ? 1 : 0, static_cast<double>(levels.size()),
        pyramid.opaque() ? 1 : 0);
    for (const raster::TextureLevel& level : levels) {
      const std::size_t first = base + level.offset;
      put(level.width, level.height, static_cast<double>(first % kTableWidth),
          static_cast<double>(first / kTableWidth));
      put(level.level_from_texture.x, level.level_from_texture.y, level.period.x, level.period.y);
    }
    return texels_ == PaintTexels::kept ? add_texels(pyramid) : ok_status();
  }

  Status add_texels(const raster::TexturePyramid& pyramid) {
    const std::size_t count = 4 * (pyramid.levels().back().offset + 1);
    const std::uint16_t* texels = pyramid.texels(pyramid.levels().front());
    return texel_memory_.append(context_, std::span(texels, count), table_.texels);
  }

  Context& context_;
  PaintTexels texels_;
  PaintTable& table_;
  TableMemory texel_memory_{"texels"};
};

}  // namespace

Result<PaintTable> make_paint_table(Context& context, const Picture& picture, PaintTexels texels) {
  PaintTable table;
  TableMemory mark_memory("the table of paints");
  std::vector<std::uint8_t> is_made;
  const std::size_t count = picture.shaders.size();
  SFUMATO_TRY(table.memory.resize_all(context, count, table.first_value, table.paint_from_layer));
  SFUMATO_TRY(mark_memory.resize(context, is_made, count));
  TableMaker maker(context, texels, table);
  for (const PatchLayer& layer : picture.layers) {
    for (const PatchField* field : {&layer.color, &layer.opacity}) {
      for (std::uint32_t index : field->shader) {
        if (is_made[index]) continue;
        is_made[index] = true;
        SFUMATO_TRY(maker.add(index, picture.shaders[index]));
      }
    }
  }
  maker.finish();
  return table;
}

}  // namespace sfumato::display
