#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/limit_error.hpp"
#include "capi/documents/document.hpp"

namespace sfumato::capi {
namespace {

/// Identifies a list of stops.
struct ListName {
  std::uint32_t side;
  std::uint32_t attribute;

  bool is_known() const { return side <= SFUMATO_RIGHT && attribute <= SFUMATO_BLUR; }
};

/// Returns the side of a curve. The curve may be const.
template <class AnyCurve>
auto& side_of(AnyCurve& curve, std::uint32_t side) {
  return side == SFUMATO_LEFT ? curve.left : curve.right;
}

/// Converts a number. A number that does not fit becomes a NaN, which validate() refuses.
float to_float(double value) {
  const bool fits = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
  return fits ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
}

void put(const Rgb& color, double* row) {
  row[0] = color.r;
  row[1] = color.g;
  row[2] = color.b;
}
void put(float number, double* row) {
  row[0] = number;
}

void take(const double* row, Rgb& color) {
  color = {to_float(row[0]), to_float(row[1]), to_float(row[2])};
}
void take(const double* row, float& number) {
  number = to_float(row[0]);
}

/// Doubles of a row: an offset and the numbers of a value.
template <class Value>
constexpr std::size_t kRowNumbers = 1 + sizeof(Value) / sizeof(float);

template <class Value>
std::size_t read_list(const StopList<Value>& list, std::int32_t* space, double* rows,
                      std::size_t capacity) {
  if (space) {
    *space = list.space == StopSpace::arc_length ? SFUMATO_ARC_LENGTH : SFUMATO_PARAMETER;
  }
  const std::size_t count = rows ? std::min(capacity, list.stops.size()) : 0;
  for (std::size_t i = 0; i < count; ++i, rows += kRowNumbers<Value>) {
    rows[0] = list.stops[i].offset;
    put(list.stops[i].value, rows + 1);
  }
  return list.stops.size();
}

template <class Value>
StopList<Value> make_list(std::int32_t space, const double* rows, std::size_t count) {
  StopList<Value> list;
  list.space = space == SFUMATO_ARC_LENGTH ? StopSpace::arc_length : StopSpace::parameter;
  list.stops.resize(count);
  for (Stop<Value>& stop : list.stops) {
    stop.offset = rows[0];
    take(rows + 1, stop.value);
    rows += kRowNumbers<Value>;
  }
  return list;
}

template <class Value>
void set_shader(SideShader<Value>& shader, std::int32_t kind, StopList<Value> list) {
  shader = {};
  shader.kind = kind == SFUMATO_STOPS     ? ShaderKind::curve_domain
                : kind == SFUMATO_BARRIER ? ShaderKind::barrier
                                          : ShaderKind::open;
  shader.stops = std::move(list);
}

/// Holds the stops that the caller sets on a side.
struct NewStops {
  std::int32_t kind;
  std::int32_t space;
  const double* rows;
  std::size_t count;
};

/// Returns the faults of the call other than its numbers.
std::optional<Outcome> complaint(const Context& context, const ListName& name,
                                 const NewStops& wanted) {
  if (!name.is_known()) return bad_usage("an unknown side or attribute");
  const bool is_blur = name.attribute == SFUMATO_BLUR;
  if (wanted.kind < SFUMATO_OPEN || wanted.kind > SFUMATO_STOPS ||
      (is_blur && wanted.kind == SFUMATO_BARRIER)) {
    return bad_usage("a kind that cannot be set");
  }
  if (wanted.space != SFUMATO_ARC_LENGTH && wanted.space != SFUMATO_PARAMETER) {
    return bad_usage("an unknown space of offsets");
  }
  if ((wanted.kind == SFUMATO_STOPS) != (wanted.count > 0)) {
    return bad_usage("rows are expected with SFUMATO_STOPS, and with nothing else");
  }
  if (!wanted.rows && wanted.count > 0) return bad_usage("NULL given; pass rows");
  if (wanted.count > context.limits.stops_per_list) {
    return limit_error(context.limits, &Limits::stops_per_list, "stops of a list");
  }
  return std::nullopt;
}

void set(Side& side, std::uint32_t attribute, const NewStops& wanted) {
  if (attribute == SFUMATO_COLOR) {
    set_shader(side.color, wanted.kind, make_list<Rgb>(wanted.space, wanted.rows, wanted.count));
  } else if (attribute == SFUMATO_OPACITY) {
    set_shader(side.opacity, wanted.kind,
               make_list<float>(wanted.space, wanted.rows, wanted.count));
  } else {
    side.blur_radius = make_list<float>(wanted.space, wanted.rows, wanted.count);
  }
}

Outcome set_stops(const Context& context, sfumato_document* handle, std::uint32_t layer,
                  std::uint32_t curve, const ListName& name, const NewStops& wanted) {
  const Curve* old = find_curve(handle, layer, curve);
  if (!old) return no_such_curve(handle, layer, curve);
  if (std::optional<Outcome> wrong = complaint(context, name, wanted)) return *wrong;
  Curve changed = *old;
  set(side_of(changed, name.side), name.attribute, wanted);
  return change(context, *handle, ReplaceCurve{layer, curve, std::move(changed)});
}

std::int32_t kind_of(ShaderKind kind) {
  switch (kind) {
    case ShaderKind::open:
      return SFUMATO_OPEN;
    case ShaderKind::barrier:
      return SFUMATO_BARRIER;
    case ShaderKind::curve_domain:
      return SFUMATO_STOPS;
    case ShaderKind::image_domain:
      break;
  }
  return SFUMATO_PAINT;
}

std::int32_t kind_of(const Side& side, std::uint32_t attribute) {
  if (attribute == SFUMATO_COLOR) return kind_of(side.color.kind);
  if (attribute == SFUMATO_OPACITY) return kind_of(side.opacity.kind);
  return side.blur_radius.empty() ? SFUMATO_OPEN : SFUMATO_STOPS;
}

}  // namespace
}  // namespace sfumato::capi

size_t sfumato_curve_stops(const sfumato_document* document, uint32_t layer, uint32_t curve,
                           uint32_t side, uint32_t attribute, int32_t* kind, int32_t* space,
                           double* rows, size_t capacity) {
  using namespace sfumato::capi;
  if (kind) *kind = SFUMATO_OPEN;
  if (space) *space = SFUMATO_ARC_LENGTH;
  const sfumato::Curve* found = find_curve(document, layer, curve);
  if (!found || !ListName{side, attribute}.is_known()) return 0;
  const sfumato::Side& asked = side_of(*found, side);
  if (kind) *kind = kind_of(asked, attribute);
  if (attribute == SFUMATO_COLOR) return read_list(asked.color.stops, space, rows, capacity);
  if (attribute == SFUMATO_OPACITY) return read_list(asked.opacity.stops, space, rows, capacity);
  return read_list(asked.blur_radius, space, rows, capacity);
}

int32_t sfumato_set_curve_stops(sfumato_context* context, sfumato_document* document,
                                uint32_t layer, uint32_t curve, uint32_t side, uint32_t attribute,
                                int32_t kind, int32_t space, const double* rows, size_t row_count) {
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::set_stops(workshop.context, document, layer, curve, {side, attribute},
                                    {kind, space, rows, row_count});
  });
}
