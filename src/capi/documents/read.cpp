#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/try.hpp"
#include "capi/documents/document.hpp"
#include "sfumato/api/draw_document.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato::capi {
namespace {

/// Holds the file that a loader passes to `deliver`.
struct Delivery {
  std::size_t most_bytes;
  std::vector<std::uint8_t> bytes{};
  Status status{};
};

/// Called by the loader; no exception may pass through it.
void deliver(void* sink, const void* bytes, std::size_t byte_count) {
  auto& delivery = *static_cast<Delivery*>(sink);
  delivery.status = caught([&]() -> Outcome {
                      if (!bytes && byte_count > 0) {
                        return make_error(StatusCode::bad_input, "the loader gave NULL");
                      }
                      if (byte_count > delivery.most_bytes) {
                        return make_error(StatusCode::limit, "a file over the limit of bytes");
                      }
                      const auto* first = static_cast<const std::uint8_t*>(bytes);
                      delivery.bytes.assign(first, first + byte_count);
                      return {};
                    }).status;
}

/// Wraps a loader of C and the images of its context.
class ForeignLoader final : public ResourceLoader {
 public:
  /// loader   may be null
  ForeignLoader(const sfumato_loader* loader, const Images& images, const Limits& limits)
      : loader_(loader), images_(images), limits_(limits) {}

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override {
    if (!loader_) return make_error(StatusCode::bad_input, "there is no loader of files");
    Delivery delivery{limits_.image_file_bytes};
    const std::string name(href);
    const std::int32_t refused = loader_->load(loader_->user, name.c_str(), deliver, &delivery);
    if (refused != 0) return make_error(StatusCode::bad_input, "the loader refused the file");
    if (!delivery.status) return delivery.status;
    return std::move(delivery.bytes);
  }

  std::optional<ImagePixels> decoded(std::span<const std::uint8_t> file) const override {
    return images_.find(file);
  }

 private:
  const sfumato_loader* loader_;
  const Images& images_;
  const Limits& limits_;
};

/// The arguments of sfumato_read() and sfumato_import_svg().
struct ReadCall {
  sfumato_context* context;
  const void* bytes;
  std::size_t byte_count;
  const char* name;
  const sfumato_loader* loader;
  sfumato_document** document;
};

Origin origin_of(std::string name, ReadDocument& read) {
  return {std::move(name), std::move(read.curve_sources)};
}
/// The boundaries of shapes are curves without a place in the text.
Origin origin_of(std::string, ImportedSvg&) {
  return {};
}

/// Calls read_document() or import_svg() and returns the document.
template <class Reader>
Outcome read_with(const ReadCall& call, Reader reader) {
  if (!call.bytes && call.byte_count > 0) return bad_usage("NULL given; pass bytes");
  if (call.loader && !call.loader->load) return bad_usage("a loader without a function");
  sfumato_context* context = call.context;
  Context& work = context->workshop->context;
  context->warnings.clear();
  const std::string_view text(static_cast<const char*>(call.bytes), call.byte_count);
  const std::string name = call.name ? call.name : "";
  const ForeignLoader foreign(call.loader, context->images, work.limits);
  const bool is_needed = call.loader || !context->images.empty();
  SFUMATO_TRY_ASSIGN(auto&& read, reader(work, text, name, is_needed ? &foreign : nullptr));
  for (const Diagnostic& warning : read.warnings) {
    context->warnings.push_back(to_string(warning));
  }
  Origin origin = origin_of(name, read);
  return hand_out(context, std::move(read.document), std::move(origin), call.document);
}

template <class Reader>
std::int32_t read_by(const ReadCall& call, Reader reader) {
  return make(call.context, call.document, [&](Workshop&) { return read_with(call, reader); });
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_read(sfumato_context* context, const void* bytes, size_t byte_count,
                     const char* name, const sfumato_loader* loader, sfumato_document** document) {
  return sfumato::capi::read_by({context, bytes, byte_count, name, loader, document},
                                [](auto&&... from) { return sfumato::read_document(from...); });
}

int32_t sfumato_import_svg(sfumato_context* context, const void* bytes, size_t byte_count,
                           const char* name, const sfumato_loader* loader,
                           sfumato_document** document) {
  return sfumato::capi::read_by(
      {context, bytes, byte_count, name, loader, document}, [](auto&&... from) {
        return sfumato::import_svg(from...,
                                   [](auto&&... tile) { return sfumato::draw_document(tile...); });
      });
}
