#pragma once

#include <memory>
#include <utility>

#include "base/charge.hpp"
#include "capi/context.hpp"
#include "capi/documents/origin.hpp"
#include "capi/documents/revisions.hpp"
#include "sfumato/document/change.hpp"
#include "sfumato/document/document.hpp"

struct sfumato_document {
  explicit sfumato_document(std::shared_ptr<sfumato::capi::Workshop> w)
      : workshop(std::move(w)), held(workshop->context.budget) {}

  std::shared_ptr<sfumato::capi::Workshop> workshop;  ///< first: it outlives the charge
  sfumato::ScopedCharge held;
  std::size_t charged = 0;  ///< bytes of `held`
  sfumato::capi::Origin origin{};
  sfumato::Document document;
  sfumato::capi::Revisions revisions;
};

namespace sfumato::capi {

/// Makes a handle of a document, which is charged to the workshop of `context`.
Outcome hand_out(sfumato_context* context, Document document, Origin origin,
                 sfumato_document** out);

/// Changes a document. If that fails, the document stays as it was.
Outcome change(const Context& context, sfumato_document& handle, Change change);

/// Returns bad usage if there is no document or no such layer.
Outcome expect_layer(const sfumato_document* handle, std::uint32_t layer);

/// Returns the curve; null if there is none.
const Curve* find_curve(const sfumato_document* handle, std::uint32_t layer, std::uint32_t curve);

/// Returns the error for a document or an index that find_curve() does not know.
Outcome no_such_curve(const sfumato_document* handle, std::uint32_t layer, std::uint32_t curve);

}  // namespace sfumato::capi
