#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "base/text/json.hpp"
#include "cli/files/solved_input.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"

/// The text of `sfumato info`: the lines that drawings and solved pictures share, and all lines of
/// solved pictures.
namespace sfumato::cli {

/// The table, a line for each fact.
class InfoTable {
 public:
  explicit InfoTable(const std::string& name);

  void row(std::string label, const std::string& content);
  void count(std::string label, std::size_t number) {
    row(std::move(label), std::to_string(number));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Write the members of a JSON object that have parts.
void write_box(JsonWriter& json, const char* key, const Box& box);
void write_size(JsonWriter& json, Vec2 size_px);

/// Returns the shortest decimal that reads back as the number.
std::string shortest(double number);

/// Returns "640 x 480", followed by " at 10,20" if the box does not begin at the origin.
std::string size_text(const Box& box);

/// Returns "#rrggbb" or "none".
std::string background_text(const std::optional<Rgb>& background);

/// Returns the description of a solved picture, as a table or as a JSON object on one line. name:
/// of the file. bytes: its size.
std::string solved_text(const std::string& name, const SolvedInput& solved, std::size_t bytes,
                        bool as_json);

}  // namespace sfumato::cli
