#pragma once

#include <string>
#include <vector>

namespace sfumato::test {

/// A document that has hardly more in it than the one feature that it is named for.
struct SmallDocument {
  const char* name;
  std::string text;
};

/// One for every feature of the format; and Orzan's XML, and a packed one.
std::vector<SmallDocument> small_documents();

/// What exporters tell apart, in few triangles: layers, a group that is blended, a local curve.
std::string small_document_for_outputs();

/// All of SVG's features at once.
std::string document_with_everything();

}  // namespace sfumato::test
