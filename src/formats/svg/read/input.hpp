#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "formats/css/length.hpp"
#include "formats/css/style.hpp"
#include "formats/css/style_sheet.hpp"
#include "formats/svg/style/length.hpp"
#include "formats/svg/style/style_scope.hpp"
#include "formats/text/warnings.hpp"
#include "formats/text/xml_source.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg {

class SelectorMatcher;

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

/// Returns whether the import continues with a warning after this error: a mistake in the document,
/// or a file that a loader cannot read.
inline bool can_be_left_out(const Status& status) {
  return status.code == StatusCode::bad_input || status.code == StatusCode::io;
}

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

  /// Returns an attribute of SVG.
  std::optional<std::string_view> attribute(Element element, const char* name) const;
  /// Returns an attribute of Sfumato's namespace, without its prefix.
  std::optional<std::string_view> sf(Element element, const char* name) const;
  bool has_sf(Element element) const;
  /// The value of a property that is specified for an element.
  struct Cascaded {
    css::WideKeyword keyword = css::WideKeyword::none;  ///< never revert_layer
    std::optional<std::string_view> value{};            ///< raw; no value if there is a keyword
    bool is_attribute = false;                          ///< the value is that of the attribute
  };

  /// Returns the winner among style="", the style sheets and the element's attribute, in the order
  /// of CSS, with each var() replaced. Values from style="" and the sheets are valid CSS; an
  /// attribute is as it was written.
  Cascaded cascaded(const StyleScope& scope, css::Property property);
  /// Returns the same for a custom property, whose value is as it was written.
  Cascaded declared_variable(Element element, std::string_view name);
  /// Returns the element's value of a property, or its parent's if CSS inherits it; no value if it
  /// is initial. Inheritance follows the document's tree, not <use>.
  std::optional<std::string_view> property(Element element, css::Property property);
  /// Returns the value of a property that is one keyword, in lower case; empty if it is not a
  /// keyword.
  std::string keyword(Element element, css::Property property);
  /// Returns the font size and the other sizes to which units refer.
  css::UnitSizes unit_sizes(const StyleScope& scope);
  /// Returns a length in user units. Errors: bad_input, without a place.
  Result<double> length(const StyleScope& scope, std::string_view text, const Box& viewport,
                        Axis axis);
  /// The picture's size in px, for vw and vh, and the user units of a px of the picture.
  void set_picture(Vec2 size_px, double units_per_px) {
    picture_px_ = size_px;
    units_per_px_ = units_per_px;
    sized_element_ = nullptr;
    sized_.clear();
  }
  double units_per_px() const { return units_per_px_; }
  /// Counts bytes that var() of all values read and write. False beyond the limit or without
  /// memory.
  bool take_variable_bytes(std::size_t bytes);
  /// Returns the poll for texts that are read with the CSS tokenizer.
  css::TextPoll& text_poll() { return text_poll_; }

  /// Returns the element that href="" refers to. Errors: bad_input.
  Result<Element> referred(Element element);
  /// Returns the element with that id, to which `element` refers. Errors: bad_input.
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
  /// From now on faulty content of ordinary SVG is left out with a warning: an import continues
  /// where a document of Sfumato would be refused.
  /// `mix-blend-mode` and `isolation` are no attributes of such content, as in browsers.
  void read_as_ordinary() { is_ordinary_ = true; }
  /// Returns whether a mistake of the element costs no more than the element.
  bool forgives(Element element) const { return is_ordinary_ && !has_sf(element); }
  /// Warns that the element is left out and returns ok, if the failure is a mistake of an element
  /// that is forgiven. Otherwise returns the failure.
  Status leave_out(Element element, Status status);
  /// Warns that an attribute of the element is ignored and returns ok, if the failure is a mistake
  /// in it and the element is forgiven: as in browsers. Otherwise returns the failure.
  Status ignore(Element element, Status status);
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
    css::PropertyName property;
    css::Setting setting;
  };

  /// A setting of a rule with a selector of several parts that matches an element.
  struct Matched {
    const void* element;
    std::uint32_t rule;
    std::uint32_t setting;
  };

  /// The content of an element's own style="".
  struct ElementStyle {
    const void* element = nullptr;
    std::span<const Styled> settings{};
  };

  /// Summarises the names of an element's attributes.
  struct ElementNames {
    const void* element = nullptr;
    std::uint64_t bits = 0;
  };

  /// Returns a bit of 64 for the beginning and the length of a name.
  static std::uint64_t name_bit(std::string_view name) {
    const std::size_t first = name.empty() ? 0 : static_cast<unsigned char>(name.front());
    return std::uint64_t{1} << ((7 * first + name.size()) % 64);
  }
  static std::array<std::uint64_t, css::kPropertyCount> property_bits();

  /// The settings of rules that match an element.
  struct ElementMatches {
    const void* element = nullptr;
    std::span<const Matched> settings{};
  };

  /// The sizes to which units of an element refer.
  struct SizedElement {
    Element element;
    css::UnitSizes sizes;
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
  Status match_rules();
  Status match_rules_of(Element element, SelectorMatcher& matcher);
  css::RankedSetting ranked(const Matched& matched) const;
  std::optional<css::RankedSetting> matched(Element element, const css::PropertyName& property);
  Cascaded declared(Element element, const css::PropertyName& property);
  Cascaded with_variables(const StyleScope& scope, css::Property property);
  bool may_be_written(Element element, css::Property property);
  std::optional<std::string_view> written(Element element, css::Property property);
  std::optional<std::string_view> substituted(const StyleScope& scope, std::string_view value);
  Status read_style_sheet(Element element);
  bool applies(Element style);
  void warn_of_dropped(Element element, const std::optional<css::Declaration>& dropped);
  std::optional<css::Setting> styled(Element element, const css::PropertyName& property);
  std::optional<css::Setting> in_sheet(Element element, const css::PropertyName& property);
  css::WideKeyword wide_keyword(std::string_view value);

  Context& context_;
  RarePoll<256> poll_;
  css::TextPoll text_poll_;
  text::XmlSource xml_;
  text::Warnings warnings_;
  DocumentMemory memory_;
  TableMemory id_memory_{"ids"};
  TableMemory style_memory_{"styles"};
  TableMemory match_memory_{"styles"};
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
  ElementNames last_names_;
  const std::array<std::uint64_t, css::kPropertyCount> property_bit_ = property_bits();
  std::vector<Matched> matched_;  ///< sorted by element; the winner for each property
  ElementMatches last_matched_;
  bool has_variables_ = false;  ///< something declares a custom property
  std::size_t variable_bytes_ = 0;
  ScopedCharge variable_charge_;
  std::set<std::string, std::less<>> substituted_;  ///< values with var() replaced
  Vec2 picture_px_{};
  double units_per_px_ = 1;
  bool is_ordinary_ = false;
  /// The sizes of the last element of the document that was asked for.
  const void* sized_element_ = nullptr;
  css::UnitSizes unit_sizes_{};
  /// The last requested element and the elements around it, the outermost first.
  std::vector<SizedElement> sized_;
  std::array<Inherited, css::kPropertyCount> inherited_{};
};

/// "<path>", for messages.
std::string tag(Element element);

/// "#sky", for messages.
std::string hash_id(Element element);

}  // namespace sfumato::svg
