#include "formats/text/dtd.hpp"

#include <algorithm>
#include <charconv>
#include <functional>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::text {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
/// Longer names are not looked for.
constexpr std::size_t kNameBytes = 1024;

bool is_quote(char c) {
  return c == '"' || c == '\'';
}

/// Sorted by name, and for equal names by place.
bool is_before(const Entity& a, const Entity& b) {
  const int order = a.name.compare(b.name);
  return order != 0 ? order < 0 : std::less<>()(a.name.data(), b.name.data());
}

/// Returns the ASCII character that "#38" or "#x26" refers to; 0 for others.
char ascii_character(std::string_view reference) {
  if (!reference.starts_with('#')) return 0;
  const bool is_hexadecimal = reference.starts_with("#x");
  const std::string_view digits = reference.substr(is_hexadecimal ? 2 : 1);
  const char* const end = digits.data() + digits.size();
  unsigned code = 0;
  const auto [read, error] = std::from_chars(digits.data(), end, code, is_hexadecimal ? 16 : 10);
  return error == std::errc() && read == end && code < 128 ? static_cast<char>(code) : '\0';
}

}  // namespace

std::string_view referred_name(std::string_view text) {
  const std::string_view rest = text.substr(1, kNameBytes + 1);
  const std::size_t end = rest.find_first_of(";&<>\"'% \t\r\n");
  return end == std::string_view::npos || rest[end] != ';' ? std::string_view()
                                                           : rest.substr(0, end);
}

/// Reads the prolog of a document up to the end of its DTD.
class DtdReader {
 public:
  DtdReader(const Context& context, std::string_view text, Dtd& dtd)
      : context_(context), poll_(context), text_(text), dtd_(dtd) {}

  Status read();

 private:
  bool starts_with(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  void skip_spaces() { at_ = std::min(text_.find_first_not_of(kSpaces, at_), text_.size()); }
  void skip_past(std::string_view end);
  bool skip_comment_or_instruction();
  void skip_to_any(std::string_view ends);
  std::string_view take_quoted();
  Status read_subset();
  Status read_entity();

  const Context& context_;
  RarePoll<256> poll_;
  std::string_view text_;
  Dtd& dtd_;
  std::size_t at_ = 0;
};

void DtdReader::skip_past(std::string_view end) {
  const std::size_t found = text_.find(end, at_);
  at_ = found == std::string_view::npos ? text_.size() : found + end.size();
}

bool DtdReader::skip_comment_or_instruction() {
  if (starts_with("<!--")) {
    skip_past("-->");
  } else if (starts_with("<?")) {
    skip_past("?>");
  } else {
    return false;
  }
  return true;
}

/// Up to one of these characters that is not within quotes.
void DtdReader::skip_to_any(std::string_view ends) {
  while (at_ < text_.size() && ends.find(text_[at_]) == std::string_view::npos) {
    if (is_quote(text_[at_])) {
      take_quoted();
    } else {
      ++at_;
    }
  }
}

std::string_view DtdReader::take_quoted() {
  const std::size_t begin = at_ + 1, end = std::min(text_.find(text_[at_], begin), text_.size());
  at_ = std::min(end + 1, text_.size());
  return text_.substr(begin, end - begin);
}

Status DtdReader::read() {
  if (starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  do {
    skip_spaces();
    if (poll_.cancelled()) return context_.cancel_status();
  } while (skip_comment_or_instruction());
  if (!starts_with("<!DOCTYPE")) return ok_status();
  skip_to_any("[>");
  Status status = at_ < text_.size() && text_[at_] == '[' ? read_subset() : ok_status();
  skip_to_any(">");
  dtd_.end_ = std::min(at_ + 1, text_.size());
  return status;
}

Status DtdReader::read_subset() {
  for (++at_;;) {
    if (poll_.cancelled()) return context_.cancel_status();
    skip_spaces();
    if (skip_comment_or_instruction()) continue;
    if (starts_with("<!ENTITY")) {
      SFUMATO_TRY(read_entity());
    } else if (starts_with("<!")) {
      skip_to_any(">");
      at_ = std::min(at_ + 1, text_.size());
    } else if (starts_with("%")) {
      dtd_.parameter_reference_ = std::min(dtd_.parameter_reference_, at_);
      skip_past(";");
    } else {
      return ok_status();  // ']', the end, or no XML
    }
  }
}

/// "<!ENTITY name 'text'>", "<!ENTITY name SYSTEM 'file'>", "<!ENTITY % name …>".
Status DtdReader::read_entity() {
  at_ += std::string_view("<!ENTITY").size();
  skip_spaces();
  const std::size_t name_begin = at_;
  at_ = std::min(text_.find_first_of(" \t\r\n\"'<>", at_), text_.size());
  const std::string_view name = text_.substr(name_begin, at_ - name_begin);
  skip_spaces();
  const bool is_external = at_ < text_.size() && !is_quote(text_[at_]);
  const std::string_view literal =
      at_ < text_.size() && !is_external ? take_quoted() : std::string_view();
  skip_to_any(">");
  at_ = std::min(at_ + 1, text_.size());
  if (name.empty() || name == "%") return ok_status();
  return dtd_.add(context_, {name, literal, is_external});
}

Status Dtd::read(const Context& context, std::string_view document) {
  room_ = document.size();
  Status status = DtdReader(context, document, *this).read();
  return status ? TableMemory::sort(context, entities_, is_before) : status;
}

Status Dtd::add(const Context& context, Entity entity) {
  Status status = decode(context, entity.text);
  return status ? memory_.push_back(context, entities_, entity) : status;
}

/// Replaces references to ASCII characters, which may be markup or begin further references. The
/// XML parser replaces the others.
Status Dtd::decode(const Context& context, std::string_view& literal) {
  if (literal.find("&#") == std::string_view::npos) return ok_status();
  // All at once, as texts of entities point into it.
  SFUMATO_TRY(memory_.reserve(context, decoded_, room_));
  const std::size_t begin = decoded_.size();
  RarePoll<4096> poll(context);
  for (std::size_t at = 0; at < literal.size();) {
    if (poll.cancelled()) return context.cancel_status();
    const std::string_view name =
        literal[at] == '&' ? referred_name(literal.substr(at)) : std::string_view();
    const char character = ascii_character(name);
    decoded_ += character != 0 ? character : literal[at];
    at += character != 0 ? name.size() + 2 : 1;
  }
  literal = std::string_view(decoded_).substr(begin);
  return ok_status();
}

const Entity* Dtd::find(std::string_view name) const {
  const auto found = std::ranges::lower_bound(entities_, name, {}, &Entity::name);
  return found != entities_.end() && found->name == name ? &*found : nullptr;
}

}  // namespace sfumato::text
