#include "sfumato/formats/read_document.hpp"

#include <algorithm>

#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/file_kind.hpp"
#include "codecs/gunzip.hpp"
#include "formats/text/xml_source.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/formats/orzan/orzan.hpp"
#include "sfumato/formats/svg/svg.hpp"

namespace sfumato {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// Behind the first `end`, or the end of the text.
std::string_view behind(std::string_view text, std::string_view end) {
  const std::size_t at = text.find(end);
  return at == std::string_view::npos ? std::string_view() : text.substr(at + end.size());
}

/// Behind a <!DOCTYPE …> with the declarations that it may hold.
std::string_view behind_doctype(std::string_view text) {
  bool in_brackets = false;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == ']') {
      in_brackets = c == '[';
    } else if (c == '>' && !in_brackets) {
      return text.substr(i + 1);
    }
  }
  return {};
}

/// Returns the name of the first element, without its prefix; nothing if there is none.
std::string_view root_name(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (text.starts_with("<?")) {
      text = behind(text, "?>");
    } else if (text.starts_with("<!--")) {
      text = behind(text, "-->");
    } else if (text.starts_with("<!")) {
      text = behind_doctype(text);
    } else {
      break;
    }
  }
  if (!text.starts_with('<')) return {};
  const std::string_view name = text.substr(1, text.find_first_of(" \t\r\n/>", 1) - 1);
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

struct Root {
  std::string name;
  SourcePlace place;
};

/// Parses a text that the fast check could not read: slightly invalid XML, or UTF-16.
Result<Root> parsed_root(Context& context, std::string_view text, const std::string& file) {
  text::XmlSource source(text, file);
  Status status = source.parse(context);
  if (!status) {
    status.where.file = file;
    return status;
  }
  const std::string name = source.root().name();
  return Root{name.substr(name.find(':') + 1), source.place(source.root())};
}

Result<Root> find_root(Context& context, std::string_view text, const std::string& file) {
  const std::string_view name = root_name(text);
  if (name.empty()) return parsed_root(context, text, file);
  const auto offset = static_cast<std::size_t>(name.data() - text.data());
  return Root{std::string(name), text::place_in(text, file, text.rfind('<', offset))};
}

Result<ReadDocument> read_drawing_text(Context& context, std::string_view text,
                                       const std::string& file, const ResourceLoader* loader) {
  SFUMATO_TRY_ASSIGN(const Root& root, find_root(context, text, file));
  if (root.name == "svg") return read_svg(context, text, file, loader);
  if (root.name == "curve_set" || root.name == "scene") return read_orzan(context, text, file);
  return make_error(StatusCode::bad_input,
                    "the document is a <" + root.name.substr(0, 64) +
                        ">; use <svg>, or Orzan's <curve_set> or <scene>",
                    root.place);
}

Result<ReadDocument> read_bytes(Context& context, std::string_view bytes, const std::string& file,
                                const ResourceLoader* loader) {
  if (!codecs::is_gzip(bytes)) return read_drawing_text(context, bytes, file, loader);
  TableMemory memory("unpacked gzip");
  Result<std::string> text = codecs::gunzip(context, bytes, memory);
  if (text && codecs::file_kind(*text) == codecs::FileKind::solved) {
    return make_error(StatusCode::bad_input,
                      "is a solved picture that is packed by gzip; unpack it first", {file});
  }
  if (text) {
    Result<ReadDocument> read = read_drawing_text(context, *text, file, loader);
    if (read) read->curve_sources.clear();  // they say where in the text, not in the file
    return read;
  }
  Status status = text.status();
  status.where.file = file;
  return status;
}

}  // namespace

Result<ReadDocument> read_document(Context& context, std::string_view bytes,
                                   const std::string& file, const ResourceLoader* loader) {
  return public_verb(context, [&] { return read_bytes(context, bytes, file, loader); });
}

}  // namespace sfumato
