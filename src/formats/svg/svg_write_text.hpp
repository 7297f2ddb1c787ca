#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// Error: limit, where a text of so many bytes is longer than what can be read.
Status check_length(const Context& context, std::size_t bytes);

/// The attributes of one element, in the order in which they are written. A '\n' in a value is a
/// place where its line may be broken, else a space. Values hold nothing that XML would escape.
class Attributes {
 public:
  Attributes& add(std::string_view name, std::string value) {
    list_.emplace_back(name, std::move(value));
    return *this;
  }

  const std::vector<std::pair<std::string_view, std::string>>& list() const { return list_; }

 private:
  std::vector<std::pair<std::string_view, std::string>> list_;
};

/// Writes elements, indented by two columns for each that is open. Lines end at 100 columns:
/// attributes go on below the first one, and values are broken where they may.
class ElementWriter {
 public:
  /// Long values are cut short where `context` says to stop: see status().
  explicit ElementWriter(const Context& context) : context_(context) {}

  void open(std::string_view name, const Attributes& attributes);
  void close(std::string_view name);
  /// <name>text</name>; the text holds nothing that XML would escape.
  void text_element(std::string_view name, std::string_view text);
  void leaf(std::string_view name, const Attributes& attributes);

  const std::string& text() const { return text_; }
  /// Ok, or cancelled: the text is not whole.
  const Status& status() const { return status_; }
  /// All that was written, or status().
  Result<std::string> take();

 private:
  void element(std::string_view name, const Attributes& attributes, std::string_view end);

  const Context& context_;
  std::string text_;
  Status status_;
  std::size_t depth_ = 0;
};

}  // namespace sfumato::svg
