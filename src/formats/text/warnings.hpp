#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/status.hpp"

namespace sfumato::text {

/// A reader's warnings: one for each kind, at most limits::kWarnings kinds, then one that counts
/// the rest.
class Warnings {
 public:
  /// Returns true if there is no warning of this kind yet; the caller must then `add` one. Else
  /// counts it.
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
