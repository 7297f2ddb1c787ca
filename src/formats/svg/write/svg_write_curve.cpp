#include "formats/svg/write/svg_write_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"

namespace sfumato::svg {
namespace {

/// Strokes for other programs: for curves without a colour.
constexpr Rgb kNoColor{136 / 255.0f, 136 / 255.0f, 136 / 255.0f};

std::string value_text(const Rgb& color) {
  return color_text(color);
}
std::string value_text(float value) {
  return number_text(value);
}

/// Returns whether the stops lie where a reader spreads them that has only the offsets of the ends,
/// to the bit: shares like a third have no exact percentage.
template <class Value>
bool is_evenly_spread(const std::vector<Stop<Value>>& stops) {
  const double first = stops.front().offset;
  const auto gaps = static_cast<double>(std::max<std::size_t>(stops.size() - 1, 1));
  const double step = (stops.back().offset - first) / gaps;
  for (std::size_t i = 1; i + 1 < stops.size(); ++i) {
    if (stops[i].offset != first + step * static_cast<double>(i)) return false;
  }
  return true;
}

/// Returns the text of stop i's offset; nothing if the reader puts the stop there without it.
template <class Value>
std::string offset_text(const StopList<Value>& list, std::size_t i, bool evenly_spread) {
  const double offset = list.stops[i].offset;
  if (list.space == StopSpace::parameter) return " @" + number_text(offset);
  const bool at_start = i == 0 && offset == 0;
  const bool is_last = i > 0 && i + 1 == list.stops.size();
  const bool between = i > 0 && !is_last;
  if (at_start || (is_last && offset == 1) || (between && evenly_spread)) return {};
  return ' ' + percent_text(offset) + '%';
}

template <class Value>
std::string stop_list_text(const StopList<Value>& list) {
  const bool evenly_spread = is_evenly_spread(list.stops);
  std::string text;
  for (std::size_t i = 0; i < list.stops.size(); ++i) {
    if (i > 0) text += ",\n";
    text += value_text(list.stops[i].value) + offset_text(list, i, evenly_spread);
  }
  return text;
}

template <class Value>
void add_stops(Attributes& attributes, std::string_view name, const StopList<Value>& list) {
  if (!list.empty()) attributes.add(name, stop_list_text(list));
}

/// Radii that are 0 everywhere are not written.
void add_radii(Attributes& attributes, std::string_view name, const ScalarStops& list) {
  const auto is_zero = [](const Stop<float>& stop) { return stop.value == 0; };
  if (!std::ranges::all_of(list.stops, is_zero)) add_stops(attributes, name, list);
}

std::string reference(const std::string& id) {
  return "url(#" + id + ')';
}

template <class Value>
void add_shader(Attributes& attributes, std::string_view name, const SideShader<Value>& shader,
                std::span<const std::string> shader_id) {
  switch (shader.kind) {
    case ShaderKind::open:
      return;
    case ShaderKind::barrier:
      attributes.add(name, "none");
      return;
    case ShaderKind::curve_domain:
      attributes.add(name, stop_list_text(shader.stops));
      return;
    case ShaderKind::image_domain:
      attributes.add(name, reference(shader_id[shader.shader]));
  }
}

/// Averages colours, to show one.
class MeanColor {
 public:
  void add(const ColorStops& list) {
    for (const Stop<Rgb>& stop : list.stops) {
      sum_[0] += stop.value.r;
      sum_[1] += stop.value.g;
      sum_[2] += stop.value.b;
      ++count_;
    }
  }

  /// To 8 bits: "#rrggbb".
  std::string text() const {
    if (count_ == 0) return color_text(kNoColor);
    const auto channel = [this](int i) {
      return static_cast<float>(std::lround(sum_[i] / count_ * 255)) / 255.0f;
    };
    return color_text({channel(0), channel(1), channel(2)});
  }

 private:
  std::array<double, 3> sum_{};
  int count_ = 0;
};

/// Image-domain shaders are mirrored in stroke and fill, so that editors keep them; else the stroke
/// is the curve's mean colour.
void add_preview(Attributes& attributes, const Curve& curve,
                 std::span<const std::string> shader_id) {
  std::vector<std::uint32_t> shaders;
  const auto note = [&shaders](const auto& side) {
    if (side.kind != ShaderKind::image_domain) return;
    if (std::ranges::find(shaders, side.shader) == shaders.end()) shaders.push_back(side.shader);
  };
  note(curve.left.color);
  note(curve.right.color);
  note(curve.left.opacity);
  note(curve.right.opacity);
  if (shaders.empty()) {
    MeanColor mean;
    mean.add(curve.left.color.stops);
    mean.add(curve.right.color.stops);
    attributes.add("stroke", mean.text());
    return;
  }
  attributes.add("stroke", reference(shader_id[shaders[0]]));
  if (shaders.size() > 1) {
    attributes.add("fill", reference(shader_id[shaders[1]])).add("fill-opacity", "0");
  }
}

double mean_radius(const ScalarStops& list) {
  double sum = 0;
  for (const Stop<float>& stop : list.stops) sum += static_cast<double>(stop.value);
  return sum / static_cast<double>(list.stops.size());
}

/// The bytes of two numbers of seventeen digits, points, signs, and the separators: typical, and at
/// most.
constexpr std::size_t kUsualPointBytes = 40;
constexpr std::size_t kPointBytes = 64;

/// Adds cubics in absolute coordinates; a chain that ends where it begins is closed.
/// Precondition: 3 n + 1 points, n ≥ 1. Errors: limit (memory), cancelled.
Status add_path_data(const Context& context, Attributes& attributes, std::span<const Vec2> points) {
  std::string text;
  // To move tens of megabytes to a larger place takes longer than the flag may go without a look.
  TableMemory& memory = attributes.memory();
  SFUMATO_TRY(memory.reserve(context, text, kUsualPointBytes * points.size() + kPointBytes));
  RarePoll<1024> poll(context);
  for (std::size_t i = 0; i < points.size(); ++i) {
    SFUMATO_TRY(memory.make_room(context, text, kPointBytes));
    if (poll.cancelled()) return context.cancel_status();
    text += i == 0 ? "M" : i == 1 ? "\nC" : "\n";
    text += number_text(points[i].x) + ' ' + number_text(points[i].y);
  }
  SFUMATO_TRY(memory.make_room(context, text, kPointBytes));
  if (points.front() == points.back()) text += "\nZ";
  attributes.add("d", std::move(text));
  return ok_status();
}

}  // namespace

Status add_curve(const Context& context, Attributes& attributes, const Curve& curve,
                 std::span<const std::string> shader_id) {
  SFUMATO_TRY(add_path_data(context, attributes, curve.control_points));
  add_shader(attributes, "sf:left", curve.left.color, shader_id);
  add_shader(attributes, "sf:right", curve.right.color, shader_id);
  if (curve.left.opacity == curve.right.opacity) {
    add_shader(attributes, "sf:opacity", curve.left.opacity, shader_id);
  } else {
    add_shader(attributes, "sf:left-opacity", curve.left.opacity, shader_id);
    add_shader(attributes, "sf:right-opacity", curve.right.opacity, shader_id);
  }
  if (curve.left.blur_radius == curve.right.blur_radius) {
    add_radii(attributes, "sf:blur", curve.left.blur_radius);
  } else {
    add_radii(attributes, "sf:left-blur", curve.left.blur_radius);
    add_radii(attributes, "sf:right-blur", curve.right.blur_radius);
  }
  if (curve.weight != 1) attributes.add("sf:weight", number_text(curve.weight));
  add_preview(attributes, curve, shader_id);
  return ok_status();
}

Status add_local_curve(const Context& context, Attributes& attributes, const LocalCurve& curve) {
  SFUMATO_TRY(add_path_data(context, attributes, curve.control_points));
  add_stops(attributes, "sf:left", curve.left_color);
  add_stops(attributes, "sf:right", curve.right_color);
  add_radii(attributes, "sf:blur", curve.blur_radius);
  add_stops(attributes, "sf:radius", curve.influence_radius);
  if (curve.alpha != 1) attributes.add("sf:alpha", number_text(curve.alpha));
  MeanColor mean;
  mean.add(curve.left_color);
  mean.add(curve.right_color);
  // As wide as the stroke is at half of its strength, about.
  attributes.add("fill", "none")
      .add("stroke", mean.text())
      .add("stroke-width", rounded_number_text(mean_radius(curve.influence_radius), 3))
      .add("stroke-opacity", rounded_number_text(std::min(1.0, curve.alpha), 3));
  return ok_status();
}

}  // namespace sfumato::svg
