#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <variant>

#include "base/output_buffer.hpp"
#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "document/names.hpp"
#include "export/page.hpp"
#include "export/poll_interval.hpp"
#include "export/tables/table_list.hpp"
#include "picture/check_picture.hpp"
#include "sfumato/export/tables/tables.hpp"

namespace sfumato {
namespace outputs {
namespace {

template <class Number>
std::string json_number(const std::uint8_t* bytes) {
  Number value;
  std::memcpy(&value, bytes, sizeof(value));
  if constexpr (std::is_floating_point_v<Number>) {
    return std::isfinite(value) ? number_text(value) : "null";
  } else {
    return std::to_string(value);
  }
}

std::string json_number(NumberType type, const std::uint8_t* bytes) {
  switch (type) {
    case NumberType::u8:
      return json_number<std::uint8_t>(bytes);
    case NumberType::u32:
      return json_number<std::uint32_t>(bytes);
    case NumberType::f32:
      return json_number<float>(bytes);
    case NumberType::f64:
      break;
  }
  return json_number<double>(bytes);
}

/// "[0,1]" from doubles.
std::string json_list(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "[" : ",") + number_text(number);
  return text + "]";
}

std::string json_box(const Box& box) {
  return json_list({box.min.x, box.min.y, box.width(), box.height()});
}

std::string json_color(const std::optional<Rgb>& color) {
  return color ? json_list({color->r, color->g, color->b}) : "null";
}

/// A table of one column is a list of numbers, any other a list of rows.
Status write_table(const Context& context, const Table& table, OutputBuffer& file) {
  RarePoll<kWritesPerPoll> poll(context);
  const std::size_t size = size_of(table.type), rows = table.rows();
  const bool is_flat = table.columns == 1;
  file += '[';
  for (std::size_t row = 0; row < rows; ++row) {
    if (poll.cancelled()) return context.cancel_status();
    if (row > 0) file += is_flat ? "," : ",\n";
    if (!is_flat) file += '[';
    for (std::size_t column = 0; column < table.columns; ++column) {
      if (column > 0) file += ',';
      file += json_number(table.type, table.bytes.data() + size * (row * table.columns + column));
    }
    if (!is_flat) file += ']';
  }
  file += ']';
  return file.status();
}

/// An item of the stack as a JSON object.
struct ItemText {
  std::string operator()(const PatchInstance& item) const {
    const Affine& m = item.artboard_from_layer;
    return "{\"layer\":" + std::to_string(item.layer) +
           ",\"matrix\":" + json_list({m.a, m.b, m.c, m.d, m.e, m.f}) + look(item) + "}";
  }
  std::string operator()(const GroupBegin& item) const {
    return "{\"group\":\"begin\"" + look(item) + "}";
  }
  std::string operator()(const GroupEnd&) const { return "{\"group\":\"end\"}"; }
  std::string operator()(const LocalStroke&) const { return "{\"stroke\":true}"; }

  template <class Item>
  static std::string look(const Item& item) {
    return ",\"opacity\":" + number_text(item.opacity) + ",\"blend\":\"" +
           std::string(blend_name(item.blend)) + '"';
  }
};

Status write_stack(const Context& context, const Picture& picture, OutputBuffer& file) {
  RarePoll<kWritesPerPoll> poll(context);
  bool is_first = true;
  file += ",\n\"stack\":[";
  for (const PictureItem& item : picture.stack) {
    if (poll.cancelled()) return context.cancel_status();
    if (!is_first) file += ",\n";
    is_first = false;
    file += std::visit(ItemText{}, item);
  }
  file += ']';
  return file.status();
}

Status write_layer(const Context& context, const PatchLayer& layer, OutputBuffer& file) {
  SFUMATO_TRY_ASSIGN(const LayerTables& made, list_tables(context, layer));
  constexpr const char* kOrders[] = {"linear", "quadratic", "cubic"};
  file += "{\"frame\":" + (layer.frame.empty() ? "null" : json_box(layer.frame));
  file += std::string(",\"order\":\"") + kOrders[static_cast<std::size_t>(layer.order)] + '"';
  for (const Table& table : made.tables) {
    file += ",\n\"" + std::string(table.name) + "\":";
    SFUMATO_TRY(write_table(context, table, file));
  }
  file += '}';
  return file.status();
}

Result<std::vector<std::uint8_t>> write_json(const Context& context, const Picture& picture,
                                             ExportNotes* notes) {
  SFUMATO_TRY(check_viewport(picture.viewport));
  SFUMATO_TRY(picture::check_picture(context, picture));
  OutputBuffer file(context, "the JSON");
  file +=
      "{\"format\":\"sfumato tables\",\"version\":1,\n\"artboard\":" + json_box(picture.artboard) +
      ",\"viewport\":" + json_box(picture.viewport) + ",\n\"interpolation\":\"" +
      std::string(space_name(picture.interpolation)) +
      "\",\"background\":" + json_color(picture.background) + ",\n\"layers\":[";
  bool is_first = true;
  for (const PatchLayer& layer : picture.layers) {
    if (!is_first) file += ",\n";
    is_first = false;
    SFUMATO_TRY(write_layer(context, layer, file));
  }
  file += ']';
  SFUMATO_TRY(write_stack(context, picture, file));
  file += "}\n";
  note_omissions(picture, notes);
  return file.finish();
}

}  // namespace
}  // namespace outputs

Result<std::vector<std::uint8_t>> export_json(Context& context, const Picture& picture,
                                              ExportNotes* notes) {
  return public_verb(context, [&] { return outputs::write_json(context, picture, notes); });
}

}  // namespace sfumato
