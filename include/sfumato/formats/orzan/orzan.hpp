#pragma once

#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato {

/// Reads the XML of Orzan et al.'s "Diffusion Curves", in its original form and in looser dialects
/// (docs/format-orzan.md). `file` names the input in messages.
///
/// Errors: bad_input, limit, cancelled, out_of_memory.
/// Cost: O(bytes), in the calling thread.
Result<ReadDocument> read_orzan(Context& context, std::string_view xml, const std::string& file);

}  // namespace sfumato
