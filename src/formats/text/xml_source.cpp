#include "formats/text/xml_source.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/limit_error.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "codecs/file_kind.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::text {
namespace {

// The memory of a node and an attribute in pugixml's tree on a 64-bit machine.
constexpr std::size_t kNodeBytes = 64;
constexpr std::size_t kAttributeBytes = 40;
constexpr std::size_t kTreeBytes = std::size_t{64} << 10;

/// Upper bounds for the text, because comments may look like tags.
struct TagCounts {
  std::size_t tags = 0;
  std::size_t elements = 0;
};

TagCounts count_tags(std::string_view text) {
  TagCounts counts;
  for (std::size_t i = text.find('<'); i != std::string_view::npos; i = text.find('<', i + 1)) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    ++counts.tags;
    counts.elements += next != '/' && next != '!' && next != '?';
  }
  return counts;
}

std::size_t count_attributes(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    // Counts that fit a byte are added sixteen or more at a time.
    const std::string_view block = text.substr(0, 255);
    std::uint8_t block_count = 0;
    for (const char c : block) block_count = static_cast<std::uint8_t>(block_count + (c == '='));
    count += block_count;
    text.remove_prefix(block.size());
  }
  return count;
}

/// Returns whether the text is certainly UTF-8: it begins like XML, and no XML declaration names an
/// encoding.
bool is_plainly_utf8(std::string_view text) {
  if (text.size() < 4 || text[0] != '<' || text[1] == '\0') return false;
  const std::string_view declaration = text.substr(0, text.find("?>"));
  return !text.starts_with("<?xml") || declaration.find("encoding") == std::string_view::npos ||
         declaration.find("\"UTF-8\"") != std::string_view::npos;
}

/// Visits every element. Ends at the first element that exceeds a limit, or when the work stops.
class ShapeCheck : public pugi::xml_tree_walker {
 public:
  explicit ShapeCheck(const Context& context) : context_(context), poll_(context) {}

  bool for_each(pugi::xml_node& node) override {
    if (poll_.cancelled()) status = context_.cancel_status();
    if (node.type() != pugi::node_element) return status.ok();
    const Limits& limits = context_.limits;
    // Text lies one deeper than the element that holds it.
    if (static_cast<std::size_t>(depth()) >= limits.xml_depth) {
      fail(node, limit_error(limits, &Limits::xml_depth, "elements within each other"));
    } else if (!collect_names(node, limits.xml_attributes)) {
      fail(node, limit_error(limits, &Limits::xml_attributes, "attributes of one element"));
    } else {
      check_duplicates(node);
    }
    return status.ok();
  }

  Status status;
  pugi::xml_node offender;

 private:
  /// False: there are more than `most`.
  bool collect_names(pugi::xml_node node, std::size_t most) {
    names_.clear();
    for (pugi::xml_attribute a = node.first_attribute(); a; a = a.next_attribute()) {
      if (names_.size() == most) return false;
      if (poll_.cancelled()) status = context_.cancel_status();
      names_.push_back(a.name());
    }
    if (names_.size() > 1) std::ranges::sort(names_);
    return true;
  }

  void check_duplicates(pugi::xml_node node) {
    const auto twice = std::ranges::adjacent_find(names_);
    if (twice == names_.end()) return;
    fail(node, make_error(StatusCode::bad_input, "not well-formed XML: the attribute \"" +
                                                     std::string(twice->substr(0, 64)) +
                                                     "\" is given twice"));
  }

  void fail(pugi::xml_node node, Status error) {
    offender = node;
    status = std::move(error);
  }

  const Context& context_;
  RarePoll<4096> poll_;
  std::vector<std::string_view> names_;  ///< of the attributes of one node, sorted
};

}  // namespace

SourcePlace place_in(std::string_view text, const std::string& file, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = static_cast<int>(std::ranges::count(before, '\n')) + 1;
  const std::size_t newline = before.rfind('\n');
  const std::size_t line_begin = newline == std::string_view::npos ? 0 : newline + 1;
  return {file, line, static_cast<int>(before.size() - line_begin) + 1};
}

Status XmlSource::expand(Context& context) {
  if (text_.size() > context.limits.input_bytes) {
    return limit_error(context.limits, &Limits::input_bytes, "bytes of input", {file_});
  }
  Status status = expanded_.expand(context, text_);
  parsed_ = expanded_.text();
  if (!status && status.code != StatusCode::cancelled) {
    status.where = place_at(expanded_.failed_at());
  }
  return status;
}

std::vector<Diagnostic> XmlSource::notes() {
  std::vector<Diagnostic> notes;
  for (const ExpandedText::Note& note : expanded_.notes()) {
    notes.push_back({note.message, place_at(note.origin)});
  }
  return notes;
}

Status XmlSource::check_size(Context& context) {
  const Limits& limits = context.limits;
  if (context.cancelled()) return context.cancel_status();
  const TagCounts counts = count_tags(parsed_);
  if (context.cancelled()) return context.cancel_status();
  if (counts.elements > limits.xml_elements) {
    return limit_error(limits, &Limits::xml_elements, "XML elements", {file_});
  }
  // The text, its copy, and a text node before every tag.
  const std::size_t tree_bytes = 2 * parsed_.size() + 2 * counts.tags * kNodeBytes +
                                 count_attributes(parsed_) * kAttributeBytes + kTreeBytes;
  return charge_.add(context, tree_bytes, "the XML tree");
}

Status XmlSource::check_shape(const Context& context) {
  ShapeCheck walker(context);
  tree_.traverse(walker);
  if (walker.offender) walker.status.where = place(walker.offender);
  return walker.status;
}

/// pugixml would copy the text and parse it without polling the flag in between. It gets only texts
/// that may need conversion.
Status XmlSource::copy_text(const Context& context) {
  constexpr std::size_t kPart = std::size_t{1} << 20;
  if (!is_plainly_utf8(parsed_)) return context.check();
  copy_.reserve(parsed_.size());
  while (copy_.size() < parsed_.size()) {
    if (context.cancelled()) return context.cancel_status();
    copy_ += parsed_.substr(copy_.size(), kPart);
  }
  return context.check();
}

/// Errors: bad_input, if the file is of another kind that is known.
Status XmlSource::check_kind() const {
  const codecs::FileKind kind = codecs::file_kind(text_);
  const std::string_view text = codecs::kind_text(kind);
  const bool is_text = kind == codecs::FileKind::xml || kind == codecs::FileKind::empty;
  if (is_text || text.empty()) return ok_status();
  const bool is_traceable = kind == codecs::FileKind::png || kind == codecs::FileKind::jpeg ||
                            kind == codecs::FileKind::webp;
  return make_error(StatusCode::bad_input,
                    "is " + std::string(text) + "; use a drawing (SVG or Orzan XML)" +
                        (is_traceable ? ", or trace the picture to make one" : ""),
                    {file_});
}

Status XmlSource::parse(Context& context) {
  SFUMATO_TRY(check_kind());
  SFUMATO_TRY(expand(context));
  SFUMATO_TRY(check_size(context));
  SFUMATO_TRY(copy_text(context));
  const pugi::xml_parse_result result = copy_.empty()
                                            ? tree_.load_buffer(parsed_.data(), parsed_.size())
                                            : tree_.load_buffer_inplace(copy_.data(), copy_.size());
  is_utf8_ = result.encoding == pugi::encoding_utf8;
  if (result.status == pugi::status_out_of_memory) {
    return make_error(StatusCode::out_of_memory, "no memory for the XML tree", {file_});
  }
  if (result.status == pugi::status_no_document_element) {
    return make_error(StatusCode::bad_input,
                      text_.empty() ? "the file is empty; use an SVG or Orzan XML file"
                                    : "no XML element found; use an SVG or Orzan XML file",
                      {file_});
  }
  if (!result) return syntax_error(result);
  if (context.cancelled()) return context.cancel_status();
  return check_shape(context);
}

Status XmlSource::syntax_error(const pugi::xml_parse_result& result) {
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
  const bool at_end = parsed_.find_first_not_of(" \t\r\n", offset + 1) == std::string_view::npos;
  std::string message = at_end ? "the XML is cut short: " : "not well-formed XML: ";
  message += result.description();
  if (is_utf8_) message += element_at(result.status, offset, at_end);
  return make_error(StatusCode::bad_input, std::move(message), place_in_parsed(offset));
}

/// Returns the name of the element of a syntax error, after a colon or " of "; nothing if there is
/// none.
std::string XmlSource::element_at(pugi::xml_parse_status status, std::size_t offset, bool at_end) {
  const auto named = [&](std::size_t tag) {
    const std::string_view name = parsed_.substr(tag, 64);
    return '<' + std::string(name.substr(1, name.find_first_of("/> \t\r\n", 2) - 1)) + '>';
  };
  std::size_t tag = parsed_.rfind('<', offset);
  // A start tag that ends with the next tag's '<' is wrong there.
  if (tag == offset && tag > 0) tag = parsed_.rfind('<', tag - 1);
  if (tag == std::string_view::npos) return {};
  switch (status) {
    case pugi::status_bad_attribute:
    case pugi::status_bad_start_element:
    case pugi::status_bad_end_element:
      return " of " + named(tag);
    case pugi::status_end_element_mismatch:
      break;
    default:
      return {};
  }
  const std::string_view told = parsed_.substr(tag, offset + 1 - tag);
  const bool is_cut_short = at_end && !(told.starts_with("</") && told.find('>') == told.npos);
  const std::string behind = is_cut_short ? " is not closed" : " is still open at " + named(tag);
  const std::size_t open = open_tag(is_cut_short ? parsed_.size() : tag);
  if (open == std::string_view::npos) return ": no element is open at " + named(tag);
  return ": " + named(open) + " of line " + std::to_string(place_in_parsed(open).line) + behind;
}

/// Returns the beginning of the tag of the innermost element that is open at `end`; npos if there
/// is none. Searches back through earlier tags; a comment that looks like a tag may mislead it.
std::size_t XmlSource::open_tag(std::size_t end) const {
  constexpr std::size_t kMostBytes = std::size_t{1} << 20;
  const std::size_t least = end > kMostBytes ? end - kMostBytes : 0;
  for (std::size_t closed = 0; end > least;) {
    const std::size_t begin = parsed_.rfind('<', end - 1);
    if (begin == std::string_view::npos) break;
    const std::string_view tag =
        parsed_.substr(begin, parsed_.substr(begin, end - begin).find('>'));
    end = begin;
    if (tag.starts_with("<!") || tag.starts_with("<?") || tag.ends_with('/')) continue;
    if (tag.starts_with("</")) {
      ++closed;
    } else if (closed-- == 0) {
      return begin;
    }
  }
  return std::string_view::npos;
}

SourcePlace XmlSource::place(pugi::xml_node node) {
  // pugixml counts to the element's name, which follows its '<'.
  const std::ptrdiff_t offset = node.offset_debug();
  return offset > 0 ? place_in_parsed(static_cast<std::size_t>(offset - 1)) : SourcePlace{file_};
}

std::size_t XmlSource::offset(pugi::xml_node node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  return is_utf8_ && offset > 0 ? expanded_.origin(static_cast<std::size_t>(offset - 1)) : 0;
}

SourcePlace XmlSource::place_in_parsed(std::size_t offset) {
  return place_at(expanded_.origin(offset));
}

SourcePlace XmlSource::place_at(std::size_t offset) {
  if (!is_utf8_) return {file_};
  offset = std::min(offset, text_.size());
  if (offset < counted_bytes_) counted_bytes_ = counted_lines_ = line_begin_ = 0;
  const std::string_view unseen = text_.substr(counted_bytes_, offset - counted_bytes_);
  if (const std::size_t newline = unseen.rfind('\n'); newline != std::string_view::npos) {
    counted_lines_ += static_cast<int>(std::ranges::count(unseen, '\n'));
    line_begin_ = counted_bytes_ + newline + 1;
  }
  counted_bytes_ = offset;
  return {file_, counted_lines_ + 1, static_cast<int>(offset - line_begin_) + 1};
}

}  // namespace sfumato::text
