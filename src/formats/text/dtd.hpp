#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::text {

/// A general entity that a DTD declares.
struct Entity {
  std::string_view name;
  std::string_view text;  ///< the replacement text (XML 1.0, 4.5); empty for an external entity
  bool is_external = false;
};

/// The general entities of the internal subset of a document's DTD. Parameter entities are not
/// expanded, and nothing external is read.
class Dtd {
 public:
  /// Reads the DTD of a document that begins in ASCII, which must outlive this object. A DTD that
  /// is not well-formed counts as far as it can be read; the XML parser reports the error. Errors:
  /// limit (memory), cancelled.
  Status read(const Context& context, std::string_view document);

  bool empty() const { return entities_.empty(); }
  /// Returns the first declaration of that name; null if there is none. O(log n).
  const Entity* find(std::string_view name) const;
  /// Returns the offset after the DTD; 0 if there is none.
  std::size_t end() const { return end_; }
  /// Returns the offset of the first reference to a parameter entity; npos if there is none.
  std::size_t parameter_reference() const { return parameter_reference_; }

 private:
  friend class DtdReader;

  Status add(const Context& context, Entity entity);
  Status decode(const Context& context, std::string_view& literal);

  TableMemory memory_{"entities"};
  std::vector<Entity> entities_;  ///< sorted. Not a hash table, as hashes could be made equal
  std::string decoded_;           ///< replacement texts that differ from their literals
  std::size_t room_ = 0;          ///< bytes that decoded_ needs at most
  std::size_t end_ = 0;
  std::size_t parameter_reference_ = std::string_view::npos;
};

/// Returns the name of the reference "&name;" or "%name;" that begins the text; empty if there is
/// none.
std::string_view referred_name(std::string_view text);

}  // namespace sfumato::text
