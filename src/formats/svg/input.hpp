#pragma once

#include <array>
#include <deque>
#include <optional>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "formats/css/style.hpp"
#include "formats/css/style_sheet.hpp"
#include "formats/text/warnings.hpp"
#include "formats/text/xml_source.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

using Element = pugi::xml_node;

/// The charges for the tables of the document that is being read; held until the reader is done.
struct DocumentMemory {
  TableMemory curves{"the curves"};
  TableMemory stops{"stops"};
  TableMemory textures{"textures"};
  TableMemory texture_files{"texture files"};
  TableMemory shaders{"shaders"};
  TableMemory stack{"the stack"};
  TableMemory shapes{"shapes"};
};

/// The document as a tree without syntax: prefixes are resolved, elements of other namespaces are
/// gone, ids are found, styles are looked up. It is also the only place that adds positions to
/// errors and warnings.
class Input {
 public:
  Input(Context& context, std::string_view text, const std::string& file)
      : context_(context), poll_(context), text_poll_(context), xml_(text, file) {}

  /// Errors: bad_input, limit, cancelled, out_of_memory.
  Status parse();

  Element root() const { return xml_.root(); }
  Context& context() const { return context_; }
  /// Ok, or why to stop; checks the cancel flag from time to time.
  Status check() { return poll_.cancelled() ? context_.cancel_status() : ok_status(); }
  const Limits& limits() const { return context_.limits; }

  /// An attribute of SVG.
  std::optional<std::string_view> attribute(Element element, const char* name) const;
  /// An attribute of Sfumato's namespace, without its prefix.
  std::optional<std::string_view> sf(Element element, const char* name) const;
  bool has_sf(Element element) const;
  /// The value of a property that is specified for an element.
  struct Cascaded {
    css::WideKeyword keyword = css::WideKeyword::none;  ///< never revert_layer
    std::optional<std::string_view> value{};            ///< raw; no value if there is a keyword
  };

  /// The winner among style="", the style sheets and the element's attribute, in the order of CSS.
  /// Values from style="" and the sheets are valid CSS; an attribute is as it was written.
  Cascaded cascaded(Element element, css::Property property);
  /// The element's value of a property, or its parent's if CSS inherits it; no value if it is
  /// initial. Inheritance follows the document's tree, not <use>.
  std::optional<std::string_view> property(Element element, css::Property property);
  /// The value of a property that is one keyword, in lower case; empty if it is not a keyword.
  std::string keyword(Element element, css::Property property);
  /// Whether style="" or a style sheet gives a property a value other than `none`.
  bool is_styled(Element element, css::Property property);
  /// The poll for texts that are read with the CSS tokenizer.
  css::TextPoll& text_poll() { return text_poll_; }

  /// The element that href="" refers to. Errors: bad_input.
  Result<Element> referred(Element element);
  /// The element with that id, to which `element` refers. Errors: bad_input.
  Result<Element> element_of(Element element, std::string_view id);

  Status error(Element element, std::string message);
  /// "more than the limit of N curves", with the place.
  Status over_limit(Element element, std::size_t Limits::*limit, std::string_view what);
  /// A parser's status with "d of <path>: " prepended to its message, and with the place.
  Status in(Element element, std::string_view attribute, Status status);
  /// The status with the element's place.
  Status placed(Element element, Status status);
  /// One warning for each kind.
  void warn(std::string_view kind, Element element, std::string message);
  /// Where the element begins in the text; 0 where that is not known.
  std::size_t offset(Element element) const { return xml_.offset(element); }
  /// Counts an element that is read again because `what` ("<use>") refers to it, and its text.
  /// Errors: limit.
  Status charge_reading(Element element, std::string_view what);
  /// Counts its text alone.
  Status charge_text(Element element);
  DocumentMemory& memory() { return memory_; }
  /// table.push_back(item), charged to `memory`; a failure gets the element's place.
  template <class Item>
  Status push_back(Element element, TableMemory& memory, std::vector<Item>& table,
                   std::type_identity_t<Item> item) {
    return placed(element, memory.push_back(context_, table, std::move(item)));
  }
  std::vector<Diagnostic> take_warnings() { return warnings_.take(); }

 private:
  struct IdElement {
    const char* id;  ///< of the tree
    Element element;
  };

  /// A property in some style="".
  struct Styled {
    const void* element;
    css::Property property;
    css::Setting setting;
  };

  /// The content of an element's own style="".
  struct ElementStyle {
    const void* element = nullptr;
    std::span<const Styled> settings{};
  };

  /// The last results for the parents of elements.
  struct Inherited {
    const void* parent = nullptr;
    std::optional<std::string_view> value{};
  };

  std::size_t bytes_between_children(Element element);
  Status index(Element element);
  Status sort_ids();
  static bool comes_before(const IdElement& a, const IdElement& b);
  Status read_style(Element element);
  Status sort_styles();
  static bool is_before(const Styled& a, const Styled& b);
  Status read_style_sheet(Element element);
  bool applies(Element style);
  void warn_of_dropped(Element element, const std::optional<css::Declaration>& dropped);
  std::optional<css::Setting> styled(Element element, css::Property property);
  std::optional<css::Setting> in_sheet(Element element, css::Property property) const;
  css::WideKeyword wide_keyword(std::string_view value);

  Context& context_;
  RarePoll<256> poll_;
  css::TextPoll text_poll_;
  text::XmlSource xml_;
  text::Warnings warnings_;
  DocumentMemory memory_;
  TableMemory id_memory_{"ids"};
  TableMemory style_memory_{"styles"};
  TableMemory sheet_memory_{"style sheets"};
  /// Sorted. Not a hash table, because a document could contain ids with equal hashes.
  std::vector<IdElement> ids_;
  std::size_t used_elements_ = 0;
  std::size_t used_bytes_ = 0;
  /// Number of children of elements with many, by address; a paint is read for each curve.
  std::unordered_map<std::size_t, std::size_t> counted_children_;
  css::StyleSheet sheet_;
  std::deque<std::string> sheet_texts_;  ///< texts of sheets that consist of several pieces
  std::vector<Styled> styles_;           ///< sorted by element and property
  ElementStyle last_styled_;
  std::array<Inherited, css::kPropertyCount> inherited_{};
};

/// "<path>", for messages.
std::string tag(Element element);

/// "#sky", for messages.
std::string hash_id(Element element);

}  // namespace sfumato::svg
