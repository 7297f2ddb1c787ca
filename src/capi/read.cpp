#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "capi/document.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato::capi {
namespace {

/// What a loader's call to `deliver` fills.
struct Delivery {
  std::size_t most_bytes;
  std::vector<std::uint8_t> bytes{};
  Status status{};
};

/// Called by the loader, through which no exception may pass.
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

/// A loader of C, and the images that its context has.
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

Outcome read(sfumato_context* context, std::string_view text, const std::string& name,
             const sfumato_loader* loader, sfumato_document** out) {
  Context& work = context->workshop->context;
  context->warnings.clear();
  const ForeignLoader foreign(loader, context->images, work.limits);
  const bool is_needed = loader || !context->images.empty();
  Result<ReadDocument> read = read_document(work, text, name, is_needed ? &foreign : nullptr);
  if (!read) return read.status();
  for (const Diagnostic& warning : read->warnings) {
    context->warnings.push_back(to_string(warning));
  }
  return hand_out(context, std::move(read->document), {name, std::move(read->curve_sources)}, out);
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_read(sfumato_context* context, const void* bytes, size_t byte_count,
                     const char* name, const sfumato_loader* loader, sfumato_document** document) {
  using sfumato::capi::bad_usage;
  const auto body = [&](sfumato::capi::Workshop&) -> sfumato::capi::Outcome {
    if (!bytes && byte_count > 0) return bad_usage("NULL given, expected bytes");
    if (loader && !loader->load) return bad_usage("a loader without a function");
    const std::string_view text(static_cast<const char*>(bytes), byte_count);
    return sfumato::capi::read(context, text, name ? name : "", loader, document);
  };
  return sfumato::capi::make(context, document, body);
}
