#include "capi/documents/document.hpp"

#include <algorithm>
#include <string>
#include <variant>

#include "base/try.hpp"
#include "capi/bytes.hpp"
#include "capi/documents/read_options.hpp"
#include "capi/pictures/view.hpp"
#include "options/tables.hpp"
#include "sfumato/document/build.hpp"
#include "sfumato/formats/svg/svg_write.hpp"

namespace sfumato::capi {
namespace {

constexpr std::string_view kPurpose = "a document";

std::size_t kept_bytes(const sfumato_document& handle) {
  return bytes_of(handle.document) + bytes_of(handle.origin) + bytes_of(handle.revisions);
}

void release(std::size_t spare, sfumato_document& handle) {
  const std::size_t released = std::min(handle.charged, spare);
  handle.held.release(released);
  handle.charged -= released;
}

void release_spare(sfumato_document& handle) {
  release(handle.charged - std::min(handle.charged, kept_bytes(handle)), handle);
}

/// Returns the memory that a list of curves may need in addition if a curve is inserted.
std::size_t room_bytes(const Document& document, const Change& change) {
  const auto* insert = std::get_if<InsertCurve>(&change);
  if (!insert || insert->layer >= document.layers.size()) return 0;
  return 2 * (document.layers[insert->layer].curves.size() + 1) *
         (sizeof(Curve) + sizeof(CurveSource) + sizeof(std::uint64_t));
}

Outcome copy(sfumato_context* context, Workshop& workshop, const sfumato_document& from,
             sfumato_document** out) {
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(workshop.context, kept_bytes(from), kPurpose));
  Document document = from.document;
  Origin origin = from.origin;
  charge = {};
  return hand_out(context, std::move(document), std::move(origin), out);
}

Outcome make_empty(sfumato_context* context, const char* text, sfumato_document** out) {
  options::DocumentSettings settings;
  SFUMATO_TRY(read_options(text, options::kNewDocument, options::document_options(), settings));
  if (!settings.artboard) return bad_usage("no artboard: use artboard=X,Y,WIDTH,HEIGHT");
  Document document;
  document.artboard = *settings.artboard;
  document.interpolation = settings.interpolation;
  document.background = settings.background;
  add_layer(document, {});
  SFUMATO_TRY(validate(context->workshop->context, document));
  return hand_out(context, std::move(document), {}, out);
}

Outcome write(Workshop& workshop, const Document& document, sfumato_bytes** out) {
  SFUMATO_TRY_ASSIGN(const std::string& text, write_svg(workshop.context, document));
  *out = new sfumato_bytes{{text.begin(), text.end()}};
  return {};
}

}  // namespace

Outcome hand_out(sfumato_context* context, Document document, Origin origin,
                 sfumato_document** out) {
  auto handle = std::make_unique<sfumato_document>(context->workshop);
  handle->origin = std::move(origin);
  handle->document = std::move(document);
  handle->revisions = revisions_of(handle->document);
  Context& work = context->workshop->context;
  SFUMATO_TRY(handle->held.add(work, kept_bytes(*handle), kPurpose));
  handle->charged = kept_bytes(*handle);
  *out = handle.release();
  return {};
}

Outcome change(const Context& context, sfumato_document& handle, Change change) {
  const std::size_t bytes = bytes_of(change) + room_bytes(handle.document, change);
  SFUMATO_TRY(
      handle.held.add(context, bytes_of(change) + room_bytes(handle.document, change), kPurpose));
  handle.charged += bytes;
  const bool replaces = std::holds_alternative<ReplaceCurve>(change);
  make_room(handle.origin, change);
  make_room(change, handle.revisions);
  const Result<Change> inverse = apply_change(context, handle.document, std::move(change));
  if (inverse) {
    note(*inverse, handle.revisions);
    follow(handle.origin, *inverse);
  }
  if (replaces) {  // without checking all other curves
    release(inverse ? bytes_of(*inverse) : bytes, handle);
  } else {
    release_spare(handle);
  }
  return inverse.status();
}

Outcome expect_layer(const sfumato_document* handle, std::uint32_t layer) {
  if (!handle) return bad_usage("NULL given; pass a document");
  if (layer < handle->document.layers.size()) return {};
  return bad_usage("there is no layer " + std::to_string(layer));
}

const Curve* find_curve(const sfumato_document* handle, std::uint32_t layer, std::uint32_t curve) {
  if (!handle || layer >= handle->document.layers.size()) return nullptr;
  const std::vector<Curve>& curves = handle->document.layers[layer].curves;
  return curve < curves.size() ? &curves[curve] : nullptr;
}

Outcome no_such_curve(const sfumato_document* handle, std::uint32_t layer, std::uint32_t curve) {
  if (!handle) return bad_usage("NULL given; pass a document");
  return bad_usage("there is no curve " + std::to_string(curve) + " in layer " +
                   std::to_string(layer));
}

}  // namespace sfumato::capi

using sfumato::capi::bad_usage;
using sfumato::capi::find_curve;
using sfumato::capi::Outcome;
using sfumato::capi::Workshop;

int32_t sfumato_document_new(sfumato_context* context, const char* options,
                             sfumato_document** document) {
  return sfumato::capi::make(context, document, [&](Workshop&) {
    return sfumato::capi::make_empty(context, options, document);
  });
}

int32_t sfumato_document_copy(sfumato_context* context, const sfumato_document* from,
                              sfumato_document** document) {
  return sfumato::capi::make(context, document, [&](Workshop& workshop) -> Outcome {
    if (!from) return bad_usage("NULL given; pass a document");
    return sfumato::capi::copy(context, workshop, *from, document);
  });
}

void sfumato_document_free(sfumato_document* document) {
  delete document;
}

int32_t sfumato_document_write(sfumato_context* context, const sfumato_document* document,
                               sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](Workshop& workshop) -> Outcome {
    if (!document) return bad_usage("NULL given; pass a document");
    return sfumato::capi::write(workshop, document->document, bytes);
  });
}

int32_t sfumato_document_artboard(const sfumato_document* document, double box[4]) {
  if (!document || !box) return SFUMATO_BAD_USAGE;
  sfumato::capi::write_box(document->document.artboard, box);
  return SFUMATO_OK;
}

int32_t sfumato_document_interpolation(const sfumato_document* document) {
  static_assert(static_cast<int>(sfumato::InterpolationSpace::oklab) == SFUMATO_OKLAB);
  return document ? static_cast<int32_t>(document->document.interpolation) : SFUMATO_SRGB;
}

uint32_t sfumato_layer_count(const sfumato_document* document) {
  return document ? static_cast<uint32_t>(document->document.layers.size()) : 0;
}

uint32_t sfumato_curve_count(const sfumato_document* document, uint32_t layer) {
  if (layer >= sfumato_layer_count(document)) return 0;
  return static_cast<uint32_t>(document->document.layers[layer].curves.size());
}

const char* sfumato_layer_id(const sfumato_document* document, uint32_t layer) {
  if (layer >= sfumato_layer_count(document)) return nullptr;
  return document->document.layers[layer].id.c_str();
}

int32_t sfumato_curve_source(const sfumato_document* document, uint32_t layer, uint32_t curve,
                             size_t* byte_offset, uint32_t* subpath) {
  sfumato::CurveSource source;
  const bool is_there = find_curve(document, layer, curve) != nullptr;
  if (is_there && layer < document->origin.curves.size()) {
    source = document->origin.curves[layer][curve];
  }
  if (byte_offset) *byte_offset = source.byte_offset;
  if (subpath) *subpath = source.subpath;
  return is_there ? SFUMATO_OK : SFUMATO_BAD_USAGE;
}

const char* sfumato_curve_id(const sfumato_document* document, uint32_t layer, uint32_t curve) {
  const sfumato::Curve* found = find_curve(document, layer, curve);
  return found ? found->id.c_str() : nullptr;
}
