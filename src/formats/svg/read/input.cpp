#include "formats/svg/read/input.hpp"

#include <algorithm>
#include <cstring>

#include "base/limit_error.hpp"
#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/svg/read/namespaces.hpp"
#include "formats/svg/style/vocabulary.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// Elements up to this length all cost the same, and their number has its own limit.
constexpr std::size_t kFreeBytes = 256;

/// Counting up to this many children is faster than looking up their number.
constexpr int kFewChildren = 16;

/// A class is looked up for each property.
constexpr std::size_t kClassWeight = 16;

/// The part of a message that distinguishes kinds of warnings.
constexpr std::size_t kKindBytes = 128;

/// There is one warning for each mistake. The text after these beginnings differs from element to
/// element.
std::string kind_of(const Status& status) {
  const std::size_t kind_end = std::min(status.message.find_first_of(":#\"0123456789"), kKindBytes);
  return status.message.substr(0, kind_end);
}

}  // namespace

std::string tag(Element element) {
  return "<" + std::string(element.name()).substr(0, 64) + ">";
}

std::string hash_id(Element element) {
  return "#" + std::string(element.attribute("id").value()).substr(0, 64);
}

Status Input::parse() {
  Status status = xml_.parse(context_);
  for (Diagnostic& note : xml_.notes()) {
    if (warnings_.is_new(note.message)) warnings_.add(note.message, std::move(note.where));
  }
  if (status) status = resolve_namespaces(context_, xml_);
  if (status) status = index(root());
  if (status) status = sort_ids();
  if (status) status = sort_styles();
  if (status) status = match_rules();
  return status;
}

/// Notes ids and style sheets, and checks the names of attributes, all the way down.
Status Input::index(Element element) {
  SFUMATO_TRY(check());
  SFUMATO_TRY(check_sf_attributes(*this, element));
  if (const auto id = attribute(element, "id"); id && !id->empty()) {
    if (id->size() > limits().id_bytes)
      return over_limit(element, &Limits::id_bytes, "bytes of an id");
    SFUMATO_TRY(push_back(element, id_memory_, ids_, {id->data(), element}));
  }
  SFUMATO_TRY(read_style(element));
  if (std::strcmp(element.name(), "style") == 0) {
    SFUMATO_TRY(read_style_sheet(element));
  }
  for (const Element child : element.children()) {
    if (child.type() != pugi::node_element) continue;
    SFUMATO_TRY(index(child));
  }
  return ok_status();
}

/// Sorted by id, and for equal ids by the place in the document: the tree keeps its texts in that
/// order.
bool Input::comes_before(const IdElement& a, const IdElement& b) {
  const int order = std::strcmp(a.id, b.id);
  return order != 0 ? order < 0 : std::less<>()(a.id, b.id);
}

/// Sorts the ids, and warns of the first that was given before.
Status Input::sort_ids() {
  SFUMATO_TRY(TableMemory::sort(context_, ids_, comes_before));
  const IdElement* repeated = nullptr;
  for (std::size_t i = 1; i < ids_.size(); ++i) {
    SFUMATO_TRY(check());
    if (std::strcmp(ids_[i - 1].id, ids_[i].id) != 0) continue;
    if (!repeated || std::less<>()(ids_[i].id, repeated->id)) repeated = &ids_[i];
  }
  if (!repeated) return ok_status();
  warn("/id", repeated->element,
       "the id " + text::quoted(repeated->id) + " was given before; the first one counts");
  return ok_status();
}

std::optional<std::string_view> Input::attribute(Element element, const char* name) const {
  const pugi::xml_attribute found = element.attribute(name);
  return found ? std::optional<std::string_view>(found.value()) : std::nullopt;
}

std::optional<std::string_view> Input::sf(Element element, const char* name) const {
  for (auto found = element.first_attribute(); found; found = found.next_attribute()) {
    if (found.name()[0] == ':' && std::strcmp(found.name() + 1, name) == 0) return found.value();
  }
  return std::nullopt;
}

bool Input::has_sf(Element element) const {
  for (auto found = element.first_attribute(); found; found = found.next_attribute()) {
    if (found.name()[0] == ':') return true;
  }
  return false;
}

Result<Element> Input::referred(Element element) {
  const auto href = attribute(element, "href");
  if (!href) return error(element, tag(element) + " has no href");
  const std::string_view reference = ascii_trimmed(*href);
  if (!reference.starts_with('#') || reference.size() == 1) {
    return error(element, "href of " + tag(element) + " is " + text::quoted(reference) +
                              "; use # and the id of an element of this document");
  }
  return element_of(element, reference.substr(1));
}

Result<Element> Input::element_of(Element element, std::string_view id) {
  const auto found = std::ranges::lower_bound(ids_, id, {}, &IdElement::id);
  if (found != ids_.end() && found->id == id) return found->element;
  return error(element, tag(element) + " refers to #" + std::string(id).substr(0, 64) +
                            ", but no element has that id");
}

Status Input::error(Element element, std::string message) {
  return make_error(StatusCode::bad_input, std::move(message), xml_.place(element));
}

Status Input::over_limit(Element element, std::size_t Limits::*limit, std::string_view what) {
  return limit_error(limits(), limit, what, xml_.place(element));
}

Status Input::in(Element element, std::string_view attribute, Status status) {
  if (status) return status;
  status.message = std::string(attribute) + " of " + tag(element) + ": " + status.message;
  status.where = xml_.place(element);
  return status;
}

Status Input::placed(Element element, Status status) {
  const bool is_ended = status.code == StatusCode::cancelled || status.limit == "time";
  if (!status && !is_ended) status.where = xml_.place(element);
  return status;
}

void Input::warn(std::string_view kind, Element element, std::string message) {
  if (warnings_.is_new(kind)) warnings_.add(std::move(message), xml_.place(element));
}

Status Input::leave_out(Element element, Status status) {
  if (status || !can_be_left_out(status) || !forgives(element)) return status;
  warn("/left out " + kind_of(status), element, tag(element) + " is left out: " + status.message);
  return ok_status();
}

Status Input::ignore(Element element, Status status) {
  if (status.code != StatusCode::bad_input || !forgives(element)) return status;
  warn("/ignored " + kind_of(status), element, status.message + "; it is ignored");
  return ok_status();
}

Status Input::charge_reading(Element element, std::string_view what) {
  if (++used_elements_ > limits().used_elements) {
    return over_limit(element, &Limits::used_elements,
                      "elements read through " + std::string(what));
  }
  return charge_text(element);
}

/// One for each child that is no element.
std::size_t Input::bytes_between_children(Element element) {
  std::size_t bytes = 0;
  int few = 0;
  for (auto child = element.first_child(); child; child = child.next_sibling()) {
    if (++few > kFewChildren) break;
    bytes += child.type() != pugi::node_element;
  }
  if (few <= kFewChildren) return bytes;
  const auto [counted, is_new] = counted_children_.try_emplace(element.hash_value(), 0);
  if (is_new) {
    for (const pugi::xml_node child : element.children()) {
      counted->second += child.type() != pugi::node_element;
    }
  }
  return counted->second;
}

Status Input::charge_text(Element element) {
  std::size_t bytes = std::strlen(element.name());
  for (auto attribute = element.first_attribute(); attribute;
       attribute = attribute.next_attribute()) {
    const std::size_t weight = std::strcmp(attribute.name(), "class") == 0 ? kClassWeight : 1;
    bytes += std::strlen(attribute.name()) + weight * std::strlen(attribute.value()) + 1;
  }
  bytes += bytes_between_children(element);
  if (bytes <= kFreeBytes) return ok_status();
  used_bytes_ += bytes - kFreeBytes;
  if (used_bytes_ <= limits().used_bytes) return ok_status();
  return over_limit(element, &Limits::used_bytes, "bytes read again through <use> or for paints");
}

}  // namespace sfumato::svg
