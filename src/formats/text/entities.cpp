#include "formats/text/entities.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/limit_error.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "formats/text/dtd.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::text {
namespace {

/// Bytes that are read between two polls.
constexpr std::size_t kStride = std::size_t{1} << 16;

struct Markup {
  std::string_view begin;
  std::string_view end;
};

/// In these nothing is replaced.
constexpr std::array<Markup, 3> kVerbatim{{{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}};

/// Returns the place of the first of two or three characters, or the end; searches kStride bytes.
std::size_t find_any(std::string_view text, std::size_t at, char a, char b, char c) {
  const std::size_t end = text.size() - at > kStride ? at + kStride : text.size();
  while (at < end && text[at] != a && text[at] != b && text[at] != c) ++at;
  return at;
}

/// How a character of an entity is written in an attribute, where quotes do not end the value.
std::string_view escaped(char c) {
  switch (c) {
    case '<':
      return "&lt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

}  // namespace

/// Copies a text while it replaces references.
class Expander {
 public:
  Expander(Context& context, const Dtd& dtd, ExpandedText& out)
      : context_(context), poll_(context), dtd_(dtd), out_(out) {}

  /// Copies the text after the DTD.
  Status run(std::string_view text);

 private:
  /// The place in the text of an element, of an entity's replacement or of the document.
  struct Cursor {
    std::string_view text;
    std::size_t at = 0;
    std::size_t copied = 0;  ///< bytes that were copied already
    bool in_tag = false;
    char quote = 0;       ///< around the attribute's value; 0 outside of values
    bool is_cut = false;  ///< a comment or the like does not end

    bool is_content() const { return !in_tag && !is_cut; }
  };

  Status content(Cursor& cursor);
  Status step(Cursor& cursor);
  void open_markup(Cursor& cursor);
  Status value(std::string_view text);
  Status replace(const Entity& entity, bool in_value);
  Status replace_at(Cursor& cursor, const Entity& entity, std::size_t end, bool in_value);
  const Entity* entity_at(std::string_view text, std::size_t at, std::size_t& end);
  Status copy(std::string_view piece);
  Status count(std::size_t bytes);
  Status begin_part(std::size_t origin, bool is_copy);
  void note(std::string message);

  Context& context_;
  RarePoll<64> poll_;
  const Dtd& dtd_;
  ExpandedText& out_;
  std::size_t depth_ = 0;   ///< of entities within each other
  std::size_t bytes_ = 0;   ///< that replace references; each reference counts as one more
  std::size_t origin_ = 0;  ///< of the reference in the document that is being replaced
  bool has_noted_ = false;
};

Status Expander::run(std::string_view text) {
  Cursor cursor{text, dtd_.end()};
  Status status = begin_part(0, true);
  return status ? content(cursor) : status;
}

/// Returns the entity of the reference at `at`, which ends at `end`; null if it stays as it is.
const Entity* Expander::entity_at(std::string_view text, std::size_t at, std::size_t& end) {
  const std::string_view name = referred_name(text.substr(at));
  if (name.empty() || name.starts_with('#')) return nullptr;
  if (depth_ == 0) origin_ = at;
  const Entity* entity = dtd_.find(name);
  if (entity && entity->is_external) {
    note("the entity " + quoted(name) + " is external and is not read");
    return nullptr;
  }
  end = at + name.size() + 2;
  return entity;
}

void Expander::note(std::string message) {
  if (!std::exchange(has_noted_, true)) out_.notes_.push_back({std::move(message), origin_});
}

Status Expander::content(Cursor& cursor) {
  Status status;
  while (status && cursor.at < cursor.text.size()) status = step(cursor);
  return status ? copy(cursor.text.substr(cursor.copied)) : status;
}

/// Up to behind the next character that means something.
Status Expander::step(Cursor& cursor) {
  if (poll_.cancelled()) return context_.cancel_status();
  const std::string_view text = cursor.text;
  const char quote = cursor.quote;
  cursor.at = quote != 0      ? find_any(text, cursor.at, quote, '&', '&')
              : cursor.in_tag ? find_any(text, cursor.at, '"', '\'', '>')
                              : find_any(text, cursor.at, '<', '&', '&');
  if (cursor.at == text.size()) return ok_status();
  const char c = text[cursor.at];
  if (c == '&' && (quote != 0 || !cursor.in_tag)) {
    std::size_t end = 0;
    if (const Entity* entity = entity_at(text, cursor.at, end)) {
      return replace_at(cursor, *entity, end, quote != 0);
    }
  } else if (quote != 0) {
    if (c != quote) return ok_status();
    cursor.quote = 0;
  } else if (cursor.in_tag) {
    if (c == '"' || c == '\'') cursor.quote = c;
    if (c == '>') cursor.in_tag = false;
  } else if (c == '<') {
    open_markup(cursor);
    return ok_status();
  } else {
    return ok_status();
  }
  ++cursor.at;
  return ok_status();
}

/// A tag begins, or a comment and the like is skipped.
void Expander::open_markup(Cursor& cursor) {
  const std::string_view rest = cursor.text.substr(cursor.at);
  for (const Markup& markup : kVerbatim) {
    if (!rest.starts_with(markup.begin)) continue;
    const std::size_t end = cursor.text.find(markup.end, cursor.at + markup.begin.size());
    cursor.is_cut = end == std::string_view::npos;
    cursor.at = cursor.is_cut ? cursor.text.size() : end + markup.end.size();
    return;
  }
  cursor.in_tag = true;
  ++cursor.at;
}

Status Expander::replace_at(Cursor& cursor, const Entity& entity, std::size_t end, bool in_value) {
  Status status = copy(cursor.text.substr(cursor.copied, cursor.at - cursor.copied));
  if (status && depth_ == 0) status = begin_part(origin_, false);
  if (status) status = replace(entity, in_value);
  cursor.at = cursor.copied = end;
  if (status && depth_ == 0) status = begin_part(end, true);
  return status;
}

Status Expander::replace(const Entity& entity, bool in_value) {
  out_.failed_at_ = origin_;
  if (depth_ >= context_.limits.entity_depth) {
    return limit_error(context_.limits, &Limits::entity_depth, "entities within each other");
  }
  SFUMATO_TRY(count(1));
  ++depth_;
  Status status;
  if (in_value) {
    status = value(entity.text);
  } else {
    Cursor cursor{entity.text};
    status = content(cursor);
    if (status && !cursor.is_content()) {
      status = make_error(StatusCode::bad_input, "not well-formed XML: the entity " +
                                                     quoted(entity.name) + " ends within a tag");
    }
  }
  --depth_;
  return status;
}

/// A replacement text in an attribute.
Status Expander::value(std::string_view text) {
  std::size_t copied = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (poll_.cancelled()) return context_.cancel_status();
    std::size_t end = at + 1;
    const Entity* entity = text[at] == '&' ? entity_at(text, at, end) : nullptr;
    const std::string_view escape = escaped(text[at]);
    if (entity || !escape.empty()) {
      SFUMATO_TRY(copy(text.substr(copied, at - copied)));
      SFUMATO_TRY(entity ? replace(*entity, true) : copy(escape));
      copied = end;
    }
    at = entity ? end : at + 1;
  }
  return copy(text.substr(copied));
}

Status Expander::copy(std::string_view piece) {
  SFUMATO_TRY(depth_ > 0 ? count(piece.size()) : ok_status());
  return out_.memory_.append(context_, std::span(piece), out_.expanded_);
}

Status Expander::count(std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ <= context_.limits.entity_bytes) return ok_status();
  return limit_error(context_.limits, &Limits::entity_bytes, "bytes of entities");
}

Status Expander::begin_part(std::size_t origin, bool is_copy) {
  return out_.memory_.push_back(context_, out_.parts_, {out_.expanded_.size(), origin, is_copy});
}

Status ExpandedText::expand(Context& context, std::string_view text) {
  text_ = text;
  Dtd dtd;
  SFUMATO_TRY(dtd.read(context, text));
  if (dtd.parameter_reference() != std::string_view::npos) {
    notes_.push_back({"parameter entities of a DTD are not read", dtd.parameter_reference()});
  }
  if (dtd.empty() || text.find('&', dtd.end()) == std::string_view::npos) return ok_status();
  SFUMATO_TRY(memory_.reserve(context, expanded_, text.size()));
  SFUMATO_TRY(Expander(context, dtd, *this).run(text));
  text_ = expanded_;
  return ok_status();
}

std::size_t ExpandedText::origin(std::size_t offset) const {
  if (parts_.empty()) return offset;
  const auto after = std::ranges::upper_bound(parts_, offset, {}, &Part::begin);
  if (after == parts_.begin()) return 0;
  const Part& part = *(after - 1);
  return part.is_copy ? part.origin + (offset - part.begin) : part.origin;
}

}  // namespace sfumato::text
