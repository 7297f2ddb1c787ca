#include "sfumato/formats/orzan/orzan.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/limit_error.hpp"
#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/text/number.hpp"
#include "base/try.hpp"
#include "document/gaussian.hpp"
#include "formats/text/warnings.hpp"
#include "formats/text/xml_source.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato {
namespace {

/// globalID counts tenths of a piece.
constexpr double kIdsPerPiece = 10;
/// The largest globalID of published drawings lies up to 33 past the end of its curve. Programs
/// that number stops from 0 to 10000, whatever the number of pieces, go further.
constexpr double kMostIdsPastEnd = 100;
/// A larger globalID is a mistake of one stop.
constexpr double kMostIds = 1e6;

/// The conventions of a file. Orzan's own files hold the picture transposed, as matrix indices and
/// in the byte order of a bitmap. `scene` files are not transposed, but their left is our right.
struct Dialect {
  const char* right_coordinate;  ///< attribute that grows to the right
  const char* down_coordinate;
  const char* red;
  const char* blue;
  bool sides_swapped;
};

constexpr Dialect kOrzan{"y", "x", "B", "R", false};
constexpr Dialect kScene{"x", "y", "R", "B", true};

class OrzanReader {
 public:
  OrzanReader(Context& context, text::XmlSource& xml) : context_(context), xml_(xml) {}

  Result<ReadDocument> read();

 private:
  Status read_canvas(pugi::xml_node root);
  Status read_curve_sets(pugi::xml_node root);
  Status reserve_curves(pugi::xml_node root, std::size_t count);
  Status read_curve_set(pugi::xml_node set);
  Status add_curve(pugi::xml_node element);
  Status read_curve(pugi::xml_node element, Curve& curve);
  double ids_per_piece(pugi::xml_node element, const Curve& curve);
  Status read_curve_part(pugi::xml_node part, Curve& curve);
  Status read_control_points(pugi::xml_node curve_element, Curve& curve);
  Status read_colors(pugi::xml_node set, const char* name, Side& side);
  Status read_color(pugi::xml_node element, Stop<Rgb>& stop);
  Status read_channel(pugi::xml_node element, const char* name, float& channel);
  Status read_blur(pugi::xml_node set, Curve& curve);
  Status read_weight(pugi::xml_node set, Curve& curve);

  /// Calls read_one(element, stop) for each child of that name and appends the stops.
  template <class Value, class ReadOne>
  Status read_stops(pugi::xml_node set, const char* name, StopList<Value>& list, ReadOne read_one);
  template <class Value>
  void finish_stops(StopList<Value>& list, std::size_t piece_count, double ids_per_piece);
  /// Counts the children of that name and warns of others.
  std::size_t count_children(pugi::xml_node set, const char* name);

  Status number_in(pugi::xml_node element, const char* name, double& value);
  Status coordinate_in(pugi::xml_node element, const char* name, double& value);
  Status error_at(pugi::xml_node element, std::string message);
  void ignore(pugi::xml_node element);
  void warn(std::string_view kind, pugi::xml_node element, std::string message);

  Context& context_;
  RarePoll<64> poll_{context_};
  text::XmlSource& xml_;
  Dialect dialect_ = kOrzan;
  Document document_;
  text::Warnings warnings_;
  TableMemory curve_memory_{"the curves"};
  TableMemory point_memory_{"control points"};
  TableMemory stop_memory_{"stops"};
  std::size_t control_point_count_ = 0;
  std::size_t stop_count_ = 0;
  std::size_t curve_number_ = 0;
  std::optional<Status> first_error_;  ///< of a curve that is left out
};

std::string tag(pugi::xml_node element) {
  return "<" + std::string(element.name()).substr(0, 64) + ">";
}

Result<ReadDocument> OrzanReader::read() {
  const pugi::xml_node root = xml_.root();
  const std::string_view name = root.name();
  if (name != "curve_set" && name != "scene") {
    return error_at(root, "the document is a " + tag(root) + "; use <curve_set> or <scene>");
  }
  dialect_ = name == "scene" ? kScene : kOrzan;
  SFUMATO_TRY(read_canvas(root));
  document_.layers.push_back({"curves", {}});
  document_.stack.push_back(LayerInstance{});
  SFUMATO_TRY(read_curve_sets(root));
  if (document_.layers.front().curves.empty()) {
    warn("/no curves", root, "the document has no curves: the picture is empty");
  }
  SFUMATO_TRY(validate(context_, document_));
  return ReadDocument{std::move(document_), warnings_.take(), DocumentFormat::orzan};
}

Status OrzanReader::read_canvas(pugi::xml_node root) {
  Vec2 size;
  SFUMATO_TRY(coordinate_in(root, "image_width", size.x));
  SFUMATO_TRY(coordinate_in(root, "image_height", size.y));
  if (!(size.x > 0 && size.y > 0)) {
    return error_at(root, "the canvas has no area; use image_width and image_height above 0");
  }
  document_.artboard = {{0, 0}, size};
  return ok_status();
}

Status OrzanReader::read_curve_sets(pugi::xml_node root) {
  std::vector<pugi::xml_node> sets;
  if (std::string_view(root.name()) == "curve_set") {
    sets.push_back(root);
  } else {
    for (const pugi::xml_node child : root.children()) {
      if (child.type() != pugi::node_element) continue;
      if (std::string_view(child.name()) == "curve_set") {
        sets.push_back(child);
      } else {
        ignore(child);
      }
    }
  }
  std::size_t curve_count = 0;
  for (const pugi::xml_node set : sets) {
    for ([[maybe_unused]] const pugi::xml_node curve : set.children("curve")) ++curve_count;
  }
  SFUMATO_TRY(reserve_curves(root, curve_count));
  for (const pugi::xml_node set : sets) {
    SFUMATO_TRY(read_curve_set(set));
  }
  const bool has_curves = !document_.layers.front().curves.empty();
  return first_error_ && !has_curves ? *first_error_ : ok_status();
}

Status OrzanReader::reserve_curves(pugi::xml_node root, std::size_t count) {
  if (count > context_.limits.curves) {
    return limit_error(context_.limits, &Limits::curves, "curves", xml_.place(root));
  }
  return curve_memory_.reserve(context_, document_.layers.front().curves, count);
}

Status OrzanReader::read_curve_set(pugi::xml_node set) {
  for (const pugi::xml_node child : set.children()) {
    if (child.type() != pugi::node_element) continue;
    if (poll_.cancelled()) return context_.cancel_status();
    if (std::string_view(child.name()) != "curve") {
      ignore(child);
    } else if (Status status = add_curve(child); !status) {
      return status;
    }
  }
  return ok_status();
}

/// Leaves out a curve that cannot be read, with a warning.
Status OrzanReader::add_curve(pugi::xml_node element) {
  std::vector<Curve>& curves = document_.layers.front().curves;
  ++curve_number_;
  Curve& curve = curves.emplace_back();
  Status status = read_curve(element, curve);
  if (status.code != StatusCode::bad_input) return status;
  point_memory_.free(curve.control_points);
  for (Side* const side : {&curve.left, &curve.right}) {
    stop_memory_.free(side->color.stops.stops);
    stop_memory_.free(side->blur_radius.stops);
  }
  curves.pop_back();
  const std::string number = std::to_string(curve_number_);
  if (warnings_.is_new("/curve " + number)) {
    warnings_.add("curve " + number + " is left out: " + status.message, status.where);
  }
  if (!first_error_) first_error_ = std::move(status);
  return ok_status();
}

/// Returns how many globalIDs a piece has: 10, or fewer or more where they go far past the curve's
/// end.
double OrzanReader::ids_per_piece(pugi::xml_node element, const Curve& curve) {
  double largest = 0;
  const auto look = [&largest](const auto& list) {
    for (const auto& stop : list.stops) {
      if (stop.offset <= kMostIds) largest = std::max(largest, stop.offset);
    }
  };
  look(curve.left.color.stops);
  look(curve.right.color.stops);
  look(curve.left.blur_radius);
  const auto pieces = static_cast<double>(curve.piece_count());
  if (largest <= kIdsPerPiece * pieces + kMostIdsPastEnd) return kIdsPerPiece;
  warn(
      "/ids", element,
      "stops are numbered past the end of the curve, which has at most 10 for each piece; they are "
      "scaled, so that the last one is at the end");
  return largest / pieces;
}

Status OrzanReader::read_curve(pugi::xml_node element, Curve& curve) {
  SFUMATO_TRY(read_control_points(element, curve));
  if (element.attribute("connects")) {
    warn("/portal", element, "portals (connects) are not read; the curve is an ordinary one");
  }
  for (const pugi::xml_node part : element.children()) {
    if (part.type() != pugi::node_element) continue;
    SFUMATO_TRY(read_curve_part(part, curve));
  }
  const double ids = ids_per_piece(element, curve);
  finish_stops(curve.left.color.stops, curve.piece_count(), ids);
  finish_stops(curve.right.color.stops, curve.piece_count(), ids);
  finish_stops(curve.left.blur_radius, curve.piece_count(), ids);
  const auto is_sharp = [](const Stop<float>& stop) { return stop.value == 0; };
  ScalarStops &left = curve.left.blur_radius, &right = curve.right.blur_radius;
  if (std::ranges::all_of(left.stops, is_sharp)) {
    stop_memory_.free(left.stops);
    left = {};
  }
  right.space = left.space;
  SFUMATO_TRY(stop_memory_.append(context_, left.stops, right.stops));
  if (dialect_.sides_swapped) std::swap(curve.left, curve.right);
  return ok_status();
}

Status OrzanReader::read_curve_part(pugi::xml_node part, Curve& curve) {
  const std::string_view name = part.name();
  if (name == "control_points_set") return ok_status();
  if (name == "left_colors_set") return read_colors(part, "left_color", curve.left);
  if (name == "right_colors_set") return read_colors(part, "right_color", curve.right);
  if (name == "blur_points_set") return read_blur(part, curve);
  if (name == "weight_set") return read_weight(part, curve);
  ignore(part);
  return ok_status();
}

Status OrzanReader::read_control_points(pugi::xml_node curve_element, Curve& curve) {
  const pugi::xml_node set = curve_element.child("control_points_set");
  const std::size_t count = count_children(set, "control_point");
  if (count < 4 || count % 3 != 1) {
    return error_at(set ? set : curve_element,
                    "the curve has " + std::to_string(count) +
                        " control points; use 3n+1 of them (4, 7, 10, …)");
  }
  control_point_count_ += count;
  if (control_point_count_ > context_.limits.control_points) {
    return limit_error(context_.limits, &Limits::control_points, "control points", xml_.place(set));
  }
  SFUMATO_TRY(point_memory_.reserve(context_, curve.control_points, count));
  for (const pugi::xml_node element : set.children("control_point")) {
    Vec2& point = curve.control_points.emplace_back();
    SFUMATO_TRY(coordinate_in(element, dialect_.right_coordinate, point.x));
    SFUMATO_TRY(coordinate_in(element, dialect_.down_coordinate, point.y));
  }
  return ok_status();
}

std::size_t OrzanReader::count_children(pugi::xml_node set, const char* name) {
  std::size_t count = 0;
  for (const pugi::xml_node child : set.children()) {
    if (child.type() != pugi::node_element) continue;
    if (std::string_view(child.name()) == name) {
      ++count;
    } else {
      ignore(child);
    }
  }
  return count;
}

template <class Value, class ReadOne>
Status OrzanReader::read_stops(pugi::xml_node set, const char* name, StopList<Value>& list,
                               ReadOne read_one) {
  const std::size_t count = count_children(set, name);
  stop_count_ += count;
  if (stop_count_ > context_.limits.stops) {
    return limit_error(context_.limits, &Limits::stops, "stops", xml_.place(set));
  }
  if (list.stops.size() + count > context_.limits.stops_per_list) {
    return limit_error(context_.limits, &Limits::stops_per_list, "stops in one list",
                       xml_.place(set));
  }
  // A curve may have many sets of one kind.
  SFUMATO_TRY(stop_memory_.make_room(context_, list.stops, count));
  for (const pugi::xml_node element : set.children(name)) {
    Stop<Value>& stop = list.stops.emplace_back();
    SFUMATO_TRY(number_in(element, "globalID", stop.offset));
    SFUMATO_TRY(read_one(element, stop));
  }
  return ok_status();
}

/// Sorts stably, then turns globalIDs into parameters, clamped to the curve.
template <class Value>
void OrzanReader::finish_stops(StopList<Value>& list, std::size_t piece_count,
                               double ids_per_piece) {
  std::ranges::stable_sort(list.stops, {}, &Stop<Value>::offset);
  for (Stop<Value>& stop : list.stops) {
    stop.offset = std::clamp(stop.offset / ids_per_piece, 0.0, static_cast<double>(piece_count));
  }
}

Status OrzanReader::read_colors(pugi::xml_node set, const char* name, Side& side) {
  // A Neumann side lets nothing through and has no colour.
  if (std::string_view(set.attribute("boundary").value()) == "Neumann") {
    side.color = {ShaderKind::barrier, {}, 0};
    return ok_status();
  }
  const auto read_one = [this](pugi::xml_node element, Stop<Rgb>& stop) {
    return read_color(element, stop);
  };
  Status status = read_stops(set, name, side.color.stops, read_one);
  if (!side.color.stops.empty()) side.color.kind = ShaderKind::curve_domain;
  return status;
}

Status OrzanReader::read_color(pugi::xml_node element, Stop<Rgb>& stop) {
  SFUMATO_TRY(read_channel(element, dialect_.red, stop.value.r));
  SFUMATO_TRY(read_channel(element, "G", stop.value.g));
  return read_channel(element, dialect_.blue, stop.value.b);
}

Status OrzanReader::read_channel(pugi::xml_node element, const char* name, float& channel) {
  double code_value = 0;
  SFUMATO_TRY(number_in(element, name, code_value));
  if (code_value < 0 || code_value > 255) {
    warn("/colour", element, "colours outside 0 to 255 are clamped to that range");
    code_value = std::clamp(code_value, 0.0, 255.0);
  }
  channel = static_cast<float>(code_value / 255);
  return ok_status();
}

Status OrzanReader::read_blur(pugi::xml_node set, Curve& curve) {
  const auto read_one = [this](pugi::xml_node element, Stop<float>& stop) {
    double sigma = 0;
    SFUMATO_TRY(coordinate_in(element, "value", sigma));
    if (sigma < 0) {
      warn("/blur", element, "a best_scale below 0 is read as 0");
      sigma = 0;
    }
    stop.value = static_cast<float>(std::min(kBlurRadiusOfSigma * sigma, limits::kCoordinate));
    return ok_status();
  };
  return read_stops(set, "best_scale", curve.left.blur_radius, read_one);
}

/// The curve's weight where it is constant; else a warning and 1.
Status OrzanReader::read_weight(pugi::xml_node set, Curve& curve) {
  std::optional<double> constant;
  for (const pugi::xml_node element : set.children("weight")) {
    double weight = 0;
    SFUMATO_TRY(coordinate_in(element, "w", weight));
    if (!constant) constant = weight;
    if (weight != *constant || !(weight > 0)) {
      warn("/weight", element,
           "a weight that varies along the curve or is not above 0 is ignored: 1 is used");
      return ok_status();
    }
  }
  curve.weight = constant.value_or(1);
  return ok_status();
}

/// Any finite number.
Status OrzanReader::number_in(pugi::xml_node element, const char* name, double& value) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) return error_at(element, tag(element) + " has no attribute " + name);
  const std::optional<double> number = parse_number(attribute.value());
  if (!number) {
    return error_at(element, std::string(name) + " of " + tag(element) + " is \"" +
                                 std::string(attribute.value()).substr(0, 64) +
                                 "\"; use a finite number");
  }
  value = *number;
  return ok_status();
}

Status OrzanReader::coordinate_in(pugi::xml_node element, const char* name, double& value) {
  SFUMATO_TRY(number_in(element, name, value));
  if (std::abs(value) <= limits::kCoordinate) return ok_status();
  return error_at(element, std::string(name) + " of " + tag(element) + " is " +
                               std::string(element.attribute(name).value()).substr(0, 64) +
                               "; use a magnitude of at most " +
                               std::to_string(static_cast<long>(limits::kCoordinate)));
}

Status OrzanReader::error_at(pugi::xml_node element, std::string message) {
  return make_error(StatusCode::bad_input, std::move(message), xml_.place(element));
}

void OrzanReader::ignore(pugi::xml_node element) {
  warn(element.name(), element, tag(element) + " is not read; such elements are ignored");
}

/// Kinds that are not element names start with a slash.
void OrzanReader::warn(std::string_view kind, pugi::xml_node element, std::string message) {
  if (warnings_.is_new(kind)) warnings_.add(std::move(message), xml_.place(element));
}

Result<ReadDocument> read_curve_set(Context& context, std::string_view xml,
                                    const std::string& file) {
  text::XmlSource source(xml, file);
  Status status = source.parse(context);
  if (status) {
    Result<ReadDocument> result = OrzanReader(context, source).read();
    if (result) return result;
    status = result.status();
  }
  status.where.file = file;
  return status;
}

}  // namespace

Result<ReadDocument> read_orzan(Context& context, std::string_view xml, const std::string& file) {
  return public_verb(context, [&] { return read_curve_set(context, xml, file); });
}

}  // namespace sfumato
