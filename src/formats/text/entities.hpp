#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::text {

/// Holds an XML text with its references to general entities of its own DTD replaced (XML 1.0,
/// 4.4). References to external and to unknown entities stay as they are.
class ExpandedText {
 public:
  /// Something that was passed over, and where in the original text.
  struct Note {
    std::string message;
    std::size_t origin = 0;
  };

  /// Expands a text, which must outlive this object. Call once.
  /// Errors: bad_input, limit (entity-bytes, entity-depth, memory), cancelled; failed_at() says
  /// where.
  Status expand(Context& context, std::string_view text);

  /// Returns the text; the original itself if nothing was replaced.
  std::string_view text() const { return text_; }
  /// Where a byte of text() stands in the original text: where the reference begins that was
  /// replaced by it. Rises with the offset.
  std::size_t origin(std::size_t offset) const;
  /// Returns the place in the original text where expand() failed.
  std::size_t failed_at() const { return failed_at_; }
  /// One for each kind.
  const std::vector<Note>& notes() const { return notes_; }

 private:
  friend class Expander;

  /// A stretch of text() from `begin` to the next part.
  struct Part {
    std::size_t begin = 0;
    std::size_t origin = 0;
    bool is_copy = true;  ///< of the original; else it replaces the reference at `origin`
  };

  TableMemory memory_{"entities"};
  std::string_view text_;
  std::string expanded_;
  std::vector<Part> parts_;
  std::vector<Note> notes_;
  std::size_t failed_at_ = 0;
};

}  // namespace sfumato::text
