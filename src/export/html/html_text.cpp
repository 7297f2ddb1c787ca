#include "export/html/html_text.hpp"

#include "base/utf8.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view without_indentation(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kBlanks);
  return first == std::string_view::npos ? std::string_view{} : line.substr(first);
}

/// What of a line is no comment that begins it; `in_comment` says whether one goes over its end.
std::string_view code_of(std::string_view line, bool* in_comment) {
  line = without_indentation(line);
  while (*in_comment || line.starts_with("/*")) {
    const std::size_t end = line.find("*/", *in_comment ? 0 : 2);
    *in_comment = end == std::string_view::npos;
    if (*in_comment) return {};
    line = without_indentation(line.substr(end + 2));
  }
  return line.starts_with("//") ? std::string_view{} : line;
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string result;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result;
}

std::string condensed(std::string_view source) {
  std::string result;
  bool in_comment = false;
  while (!source.empty()) {
    const std::size_t end = source.find('\n');
    const std::string_view code = code_of(source.substr(0, end), &in_comment);
    if (!code.empty()) {
      result += code;
      result += '\n';
    }
    source.remove_prefix(end == std::string_view::npos ? source.size() : end + 1);
  }
  return result;
}

}  // namespace sfumato::outputs
