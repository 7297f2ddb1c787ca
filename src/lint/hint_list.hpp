#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/lint/hint.hpp"

namespace sfumato::lint_detail {

/// Counts the hints that are not notes.
std::size_t count_hints(std::span<const Hint> hints);

/// Returns one line of JSON, UTF-8: an object with the members "file", "hints" (a list, whose
/// objects have "kind", "severity", the indices and ids of the place, and "message") and
/// "hint_count". docs/cli.md ("lint") has an example.
///
/// name: of the document, for "file". hints: of this document, from lint(). Errors: limit (memory),
/// cancelled.
Result<std::vector<std::uint8_t>> hints_json(const Context& context, const std::string& name,
                                             const Document& document, std::span<const Hint> hints);

}  // namespace sfumato::lint_detail
