#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/charge.hpp"
#include "formats/text/entities.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::text {

/// The place of a byte of a text, which is counted from the text's beginning.
SourcePlace place_in(std::string_view text, const std::string& file, std::size_t offset);

/// An XML text as a tree whose elements have a place in the file. The text and the name must
/// outlive it. Entities that its own DTD declares are expanded; no external resource is ever
/// opened.
class XmlSource {
 public:
  XmlSource(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// Builds the tree; its memory is charged before, and released with this object.
  /// Errors: bad_input where the text is not well-formed; limit (bytes, entities, elements, depth,
  /// attributes, memory), cancelled.
  Status parse(Context& context);

  /// Returns the document element. Precondition: parse was ok.
  pugi::xml_node root() const { return tree_.document_element(); }

  /// The place of the element's `<`. Columns count bytes. Line and column are 0 if the text was not
  /// UTF-8 and had to be converted.
  SourcePlace place(pugi::xml_node node);
  /// Bytes of the text before the element's `<`. 0 also where the text was not UTF-8.
  std::size_t offset(pugi::xml_node node) const;
  /// The ignored parts of the DTD, one warning for each kind.
  std::vector<Diagnostic> notes();

 private:
  SourcePlace place_at(std::size_t offset);
  SourcePlace place_in_parsed(std::size_t offset);
  Status expand(Context& context);
  Status check_kind() const;
  Status check_size(Context& context);
  Status copy_text(const Context& context);
  Status check_shape(const Context& context);
  std::string element_at(pugi::xml_parse_status status, std::size_t offset, bool at_end);
  std::size_t open_tag(std::size_t end) const;
  Status syntax_error(const pugi::xml_parse_result& result);

  std::string_view text_;
  const std::string& file_;
  ExpandedText expanded_;
  std::string_view parsed_;  ///< the source of the tree: the text with its entities expanded
  ScopedCharge charge_;
  std::string copy_;  ///< the buffer of the tree; empty: the tree has its own
  pugi::xml_document tree_;
  bool is_utf8_ = true;
  // Places are mostly requested in rising order, so that counting continues from the last one.
  std::size_t counted_bytes_ = 0;
  std::size_t line_begin_ = 0;
  int counted_lines_ = 0;
};

}  // namespace sfumato::text
