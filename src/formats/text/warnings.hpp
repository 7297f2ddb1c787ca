#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/status.hpp"

namespace sfumato::text {

/// What a reader had to overlook: one warning for each kind, at most limits::kWarnings kinds, then
/// one that counts the rest.
class Warnings {
 public:
  /// True where a warning of this kind is still to be made: `add` it then. Else it is counted.
  bool is_new(std::string_view kind);

  void add(std::string message, SourcePlace place);

  /// The warnings in order of arrival. Call once, last.
  std::vector<Diagnostic> take();

 private:
  std::set<std::string, std::less<>> kinds_;
  std::vector<Diagnostic> warnings_;
  std::size_t left_out_ = 0;
};

}  // namespace sfumato::text
