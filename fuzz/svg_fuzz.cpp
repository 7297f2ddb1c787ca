// Whole documents as the command reads them: SVG with styles, `use`, paints and textures, gzip, and
// other formats that the root element names.
#include <string>
#include <vector>

#include "fuzz.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/formats/read_document.hpp"

using namespace sfumato;

namespace {

/// One small picture for every name that ends in .png; no other files.
class OnePicture final : public ResourceLoader {
 public:
  OnePicture() {
    Context context;
    const Image image{2, 1, PixelFormat::rgba8, {255, 0, 0, 255, 0, 0, 255, 128}};
    Result<std::vector<std::uint8_t>> png = encode_png(context, image);
    fuzz::require_ok(png.status(), "the picture");
    png_ = std::move(*png);
  }

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override {
    if (href.ends_with(".png")) return png_;
    return make_error(StatusCode::bad_input, "there is no such file");
  }

 private:
  std::vector<std::uint8_t> png_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const OnePicture pictures;
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  {
    const Result<ReadDocument> read =
        read_document(context, fuzz::as_text({data, size}), "fuzz.svg", &pictures);
    if (read) {
      fuzz::require_ok(validate(context, read->document), "a document that is not valid");
      fuzz::require(read->warnings.size() <= limits::kWarnings + 1, "too many warnings");
    } else {
      fuzz::require_honest(read.status());
    }
  }
  fuzz::require(context.budget.used() == 0, "a reader keeps what it charged");
  return 0;
}
