#include "formats/svg/svg_write_text.hpp"

#include <algorithm>
#include <utility>

#include "base/limit_error.hpp"
#include "base/poll.hpp"

namespace sfumato::svg {
namespace {

constexpr std::size_t kColumns = 100;
/// What may follow a value: `"/>`.
constexpr std::size_t kEndColumns = 3;

void append_on_one_line(std::string& text, const std::string& value) {
  const std::size_t begin = text.size();
  text += value;
  std::replace(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), '\n', ' ');
}

/// Appends the value from column `indent` on, with as much on each line as fits. Errors: cancelled.
Status append_broken(const Context& context, std::string& text, std::string_view value,
                     std::size_t indent) {
  RarePoll<4096> poll(context);
  // Once, before the value is there to be moved too; half as much again for the indents.
  text.reserve(text.size() + value.size() + value.size() / 2);
  std::size_t column = indent;
  for (bool first = true;; first = false) {
    if (poll.cancelled()) return context.cancel_status();
    const std::size_t end = value.find('\n');
    const std::string_view part = value.substr(0, end);
    if (!first && column + 1 + part.size() > kColumns - kEndColumns) {
      text += '\n';
      text.append(indent, ' ');
      column = indent;
    } else if (!first) {
      text += ' ';
      ++column;
    }
    text += part;
    column += part.size();
    if (end == std::string_view::npos) return ok_status();
    value.remove_prefix(end + 1);
  }
}

}  // namespace

Status check_length(const Context& context, std::size_t bytes) {
  if (bytes <= context.limits.input_bytes) return ok_status();
  return make_limit_error(&Limits::input_bytes,
                          "the document as SVG is longer than can be read again: " +
                              limit_text(context.limits, &Limits::input_bytes, "bytes"));
}

void ElementWriter::element(std::string_view name, const Attributes& attributes,
                            std::string_view end) {
  const std::size_t indent = 2 * depth_;
  text_.append(indent, ' ');
  text_ += '<';
  text_ += name;
  const std::size_t key_column = indent + name.size() + 2;
  std::size_t column = key_column - 1;
  for (const auto& [key, value] : attributes.list()) {
    const std::size_t length = key.size() + value.size() + 2;  // with =" before the value
    if (column + 1 + length + kEndColumns <= kColumns || column < key_column) {
      text_ += ' ';
      ++column;
    } else {
      text_ += '\n';
      text_.append(key_column, ' ');
      column = key_column;
    }
    text_ += key;
    text_ += "=\"";
    if (column + length + kEndColumns <= kColumns) {
      append_on_one_line(text_, value);
      column += length + 1;
    } else {
      Status status = append_broken(context_, text_, value, column + key.size() + 2);
      if (!status) status_ = std::move(status);
      column = kColumns;  // nothing beside the end of a broken value
    }
    text_ += '"';
  }
  text_ += end;
  text_ += '\n';
}

void ElementWriter::open(std::string_view name, const Attributes& attributes) {
  element(name, attributes, ">");
  ++depth_;
}

void ElementWriter::text_element(std::string_view name, std::string_view text) {
  text_.append(2 * depth_, ' ');
  for (const std::string_view part : {std::string_view("<"), name, std::string_view(">"), text,
                                      std::string_view("</"), name, std::string_view(">\n")}) {
    text_ += part;
  }
}

void ElementWriter::close(std::string_view name) {
  --depth_;
  text_.append(2 * depth_, ' ');
  text_ += "</";
  text_ += name;
  text_ += ">\n";
}

void ElementWriter::leaf(std::string_view name, const Attributes& attributes) {
  element(name, attributes, "/>");
}

Result<std::string> ElementWriter::take() {
  if (!status_) return status_;
  return std::move(text_);
}

}  // namespace sfumato::svg
