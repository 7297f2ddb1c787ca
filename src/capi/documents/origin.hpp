#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sfumato/document/change.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::capi {

/// Holds the origin of a document: for each curve its place in the text.
struct Origin {
  std::string name{};  ///< the settings of sfumato_read()
  /// As ReadDocument::curve_sources.
  std::vector<std::vector<CurveSource>> curves{};
};

/// Returns the bytes that it has allocated.
std::size_t bytes_of(const Origin& origin);

/// Reserves memory for a change of the document, so that follow() cannot fail.
void make_room(Origin& origin, const Change& change);

/// Updates the curves after a change of the document that has this inverse.
void follow(Origin& origin, const Change& inverse);

}  // namespace sfumato::capi
