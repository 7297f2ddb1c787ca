#pragma once

#include <string>
#include <vector>

namespace sfumato::test {

/// A document with hardly more than the one feature that it is named after.
struct SmallDocument {
  const char* name;
  std::string text;
};

/// Returns one document for every feature of the format, one of Orzan's XML, and a gzipped one.
std::vector<SmallDocument> small_documents();

/// Returns a document with few triangles and everything that exporters treat differently: layers, a
/// blended group, a local curve.
std::string small_document_for_outputs();

/// Returns a document with all features of SVG.
std::string document_with_everything();

}  // namespace sfumato::test
