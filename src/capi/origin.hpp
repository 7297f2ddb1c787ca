#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sfumato/document/change.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::capi {

/// Where a document came from.
struct Origin {
  std::string name{};  ///< what sfumato_read() was told
  /// As ReadDocument::curve_sources.
  std::vector<std::vector<CurveSource>> curves{};
};

/// Bytes that it has allocated.
std::size_t bytes_of(const Origin& origin);

/// Makes room for what a change of the document may add, so that follow() cannot fail.
void make_room(Origin& origin, const Change& change);

/// Keeps the curves in step with a document to which a change was made that has this inverse.
void follow(Origin& origin, const Change& inverse);

}  // namespace sfumato::capi
