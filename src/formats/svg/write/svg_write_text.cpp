#include "formats/svg/write/svg_write_text.hpp"

#include <algorithm>
#include <span>

#include "base/limit_error.hpp"
#include "base/poll.hpp"

namespace sfumato::svg {
namespace {

constexpr std::size_t kColumns = 100;
/// The text that may follow a value: `"/>`.
constexpr std::size_t kEndColumns = 3;
/// Bytes that are appended without a check of the cancel flag.
constexpr std::size_t kSmall = std::size_t{64} << 10;

}  // namespace

Status check_length(const Context& context, std::size_t bytes) {
  if (bytes <= context.limits.input_bytes) return ok_status();
  return make_limit_error(&Limits::input_bytes,
                          "the document as SVG is longer than can be read again: " +
                              limit_text(context.limits, &Limits::input_bytes, "bytes"));
}

void ElementWriter::append(std::string_view text) {
  const bool has_room = text.size() <= text_.capacity() - text_.size();
  if (!status_) return;
  if (has_room && text.size() <= kSmall) {
    text_ += text;
  } else {
    status_ = memory_.append(context_, std::span<const char>(text), text_);
  }
}

void ElementWriter::append_blanks(std::size_t count) {
  constexpr std::string_view kBlanks = "                                ";
  for (; count > kBlanks.size(); count -= kBlanks.size()) append(kBlanks);
  append(kBlanks.substr(0, count));
}

void ElementWriter::append_on_one_line(std::string_view value) {
  const std::size_t begin = text_.size();
  append(value);
  std::replace(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.end(), '\n', ' ');
}

/// Appends the value from column `indent` on, with as much on each line as fits.
void ElementWriter::append_broken(std::string_view value, std::size_t indent) {
  RarePoll<4096> poll(context_);
  // Once, before the value is there to be moved too; half as much again for the indents.
  const std::size_t room = value.size() + value.size() / 2;
  if (status_) status_ = memory_.make_room(context_, text_, room);
  std::size_t column = indent;
  for (bool first = true; status_; first = false) {
    if (poll.cancelled()) status_ = context_.cancel_status();
    const std::size_t end = value.find('\n');
    const std::string_view part = value.substr(0, end);
    if (!first && column + 1 + part.size() > kColumns - kEndColumns) {
      append("\n");
      append_blanks(indent);
      column = indent;
    } else if (!first) {
      append(" ");
      ++column;
    }
    append(part);
    column += part.size();
    if (end == std::string_view::npos) return;
    value.remove_prefix(end + 1);
  }
}

void ElementWriter::element(std::string_view name, const Attributes& attributes,
                            std::string_view end) {
  const std::size_t indent = 2 * depth_;
  append_blanks(indent);
  append("<");
  append(name);
  const std::size_t key_column = indent + name.size() + 2;
  std::size_t column = key_column - 1;
  for (const auto& [key, value] : attributes.list()) {
    const std::size_t length = key.size() + value.size() + 2;  // with =" before the value
    if (column + 1 + length + kEndColumns <= kColumns || column < key_column) {
      append(" ");
      ++column;
    } else {
      append("\n");
      append_blanks(key_column);
      column = key_column;
    }
    append(key);
    append("=\"");
    if (column + length + kEndColumns <= kColumns) {
      append_on_one_line(value);
      column += length + 1;
    } else {
      append_broken(value, column + key.size() + 2);
      column = kColumns;  // nothing beside the end of a broken value
    }
    append("\"");
  }
  append(end);
  append("\n");
}

void ElementWriter::open(std::string_view name, const Attributes& attributes) {
  element(name, attributes, ">");
  ++depth_;
}

void ElementWriter::text_element(std::string_view name, std::string_view text) {
  append_blanks(2 * depth_);
  for (const std::string_view part : {std::string_view("<"), name, std::string_view(">"), text,
                                      std::string_view("</"), name, std::string_view(">\n")}) {
    append(part);
  }
}

void ElementWriter::close(std::string_view name) {
  --depth_;
  append_blanks(2 * depth_);
  append("</");
  append(name);
  append(">\n");
}

void ElementWriter::leaf(std::string_view name, const Attributes& attributes) {
  element(name, attributes, "/>");
}

Result<std::string> ElementWriter::take() {
  if (!status_) return status_;
  return std::move(text_);
}

}  // namespace sfumato::svg
