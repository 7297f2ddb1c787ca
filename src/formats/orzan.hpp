#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "document/document.hpp"

namespace sfumato {

/// A document and what its reader had to overlook, each with its place.
struct ReadDocument {
  Document document;
  std::vector<Status>
      warnings;  ///< code bad_input; at most limits::kWarnings, then one that counts the rest
};

/// Reads Orzan et al.'s XML (`<curve_set>` and the looser dialects; docs/format-orzan.md).
/// `file` names the input in messages. Errors: bad_input, limit.
Result<ReadDocument> read_orzan(Context& context, std::string_view xml, const std::string& file);

}  // namespace sfumato
