#include "export/html/html_text.hpp"

#include <algorithm>

#include "base/text/utf8.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view without_indentation(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kBlanks);
  return first == std::string_view::npos ? std::string_view{} : line.substr(first);
}

/// Returns a line without the comment at its beginning. `in_comment` is whether a comment continues
/// over its end.
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

/// Returns the text after a word and blanks, if the text begins with them.
std::string_view behind_word(std::string_view text, std::string_view word) {
  if (!text.starts_with(word)) return {};
  text.remove_prefix(word.size());
  const std::size_t next = text.find_first_not_of(" \t\r\n");
  const bool is_word = next != 0 || text.find_first_of("{*\"'") == 0;
  return is_word && next != std::string_view::npos ? text.substr(next) : std::string_view{};
}

/// Returns whether a text begins with an import or a list of exports; `import(…)` and `import.meta`
/// are none.
bool begins_with_linkage(std::string_view text) {
  const std::string_view imported = behind_word(text, "import");
  const std::string_view exported = behind_word(text, "export");
  return (!imported.empty() && imported.front() != '(') || exported.starts_with('{') ||
         exported.starts_with('*');
}

/// Returns the text after a statement, and after the end of its line if the rest of the line is
/// empty.
std::string_view behind_statement(std::string_view text) {
  const std::size_t end = text.find(';');
  if (end == std::string_view::npos) return {};
  text = without_indentation(text.substr(end + 1));
  return text.starts_with('\n') ? text.substr(1) : text;
}

bool is_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '$' || static_cast<unsigned char>(c) >= 0x80;
}

/// Returns whether two characters would merge into one token without a blank between them.
bool would_join(char a, char b) {
  return (is_of_word(a) && is_of_word(b)) || ((a == '+' || a == '-') && a == b);
}

void append_squeezed(std::string_view line, std::string& out) {
  const std::size_t begin = out.size();
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool ends = i + 1 == line.size() || out.size() == begin;
    if (quote == 0 && c == ' ' && (ends || !would_join(out.back(), line[i + 1]))) continue;
    out += c;
    if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    } else if (quote != 0 && c == '\\' && i + 1 < line.size()) {
      out += line[++i];
    } else if (c == quote) {
      quote = 0;
    }
  }
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

std::string squeezed(std::string_view condensed_script) {
  std::string result;
  while (!condensed_script.empty()) {
    const std::size_t end = std::min(condensed_script.find('\n'), condensed_script.size());
    const std::string_view line = condensed_script.substr(0, end);
    if (line.find_first_of("/`") == std::string_view::npos) {
      append_squeezed(line, result);
    } else {
      result += line;
    }
    condensed_script.remove_prefix(end);
    if (condensed_script.empty()) break;
    result += '\n';
    condensed_script.remove_prefix(1);
  }
  return result;
}

std::string script_of_module(std::string_view condensed_module) {
  constexpr std::string_view kExport = "export ";
  std::string result;
  for (std::string_view text = condensed_module; !text.empty();) {
    if (begins_with_linkage(text)) {
      text = behind_statement(text);
      continue;
    }
    if (text.starts_with(kExport)) text.remove_prefix(kExport.size());
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end == std::string_view::npos ? end : end + 1);
    result += line;
    text.remove_prefix(line.size());
  }
  return result;
}

}  // namespace sfumato::outputs
