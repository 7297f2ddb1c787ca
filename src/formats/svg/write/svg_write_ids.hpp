#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace sfumato::svg {

/// Makes unique ids that are XML names without a colon (letters, digits, '-', '_', '.', and
/// non-ASCII characters). An id that satisfies both already is unchanged.
class IdPool {
 public:
  /// Returns the id to write for `wanted`: other characters become '_', and an id that is in use
  /// gets "-2", "-3"…
  std::string claim(std::string_view wanted);

  /// As above, or "KIND-1", "KIND-2"… if `wanted` is empty.
  std::string claim_or_make(std::string_view wanted, std::string_view kind);

  /// Bytes of the ids given out so far.
  std::size_t kept_bytes() const { return bytes_; }

 private:
  bool take(const std::string& id);
  std::string numbered(const std::string& base, std::size_t first);

  // Not hash tables, because a document could contain ids with equal hashes.
  std::set<std::string> taken_;
  std::map<std::string, std::size_t> next_number_;
  std::size_t bytes_ = 0;
};

}  // namespace sfumato::svg
