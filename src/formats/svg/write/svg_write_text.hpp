#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// Error: limit, if a text of `bytes` bytes is too long to be read again.
Status check_length(const Context& context, std::size_t bytes);

/// The attributes of one element, in the order of writing. A '\n' in a value marks a place where
/// its line may be broken; otherwise it is written as a space. Values contain nothing that XML
/// would escape.
class Attributes {
 public:
  Attributes& add(std::string_view name, std::string value) {
    list_.emplace_back(name, std::move(value));
    return *this;
  }

  const std::vector<std::pair<std::string_view, std::string>>& list() const { return list_; }

  /// For long values.
  TableMemory& memory() { return memory_; }

 private:
  TableMemory memory_{"the document as SVG"};
  std::vector<std::pair<std::string_view, std::string>> list_;
};

/// Writes elements, indented by two columns for each that is open. Lines end at 100 columns:
/// further attributes are aligned below the first one, and values are broken where this is allowed.
/// The text is charged to the budget. After a failure nothing more is written.
class ElementWriter {
 public:
  explicit ElementWriter(const Context& context) : context_(context) {}

  void open(std::string_view name, const Attributes& attributes);
  void close(std::string_view name);
  /// <name>text</name>; the text contains nothing that XML would escape.
  void text_element(std::string_view name, std::string_view text);
  void leaf(std::string_view name, const Attributes& attributes);

  const std::string& text() const { return text_; }
  /// Ok, or why the text is incomplete: limit (memory), cancelled.
  const Status& status() const { return status_; }
  /// All that was written, or status().
  Result<std::string> take();

 private:
  void element(std::string_view name, const Attributes& attributes, std::string_view end);
  void append(std::string_view text);
  void append_blanks(std::size_t count);
  void append_on_one_line(std::string_view value);
  void append_broken(std::string_view value, std::size_t indent);

  const Context& context_;
  TableMemory memory_{"the document as SVG"};
  std::string text_;
  Status status_;
  std::size_t depth_ = 0;
};

}  // namespace sfumato::svg
