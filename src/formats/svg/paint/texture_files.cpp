#include "formats/svg/paint/texture_files.hpp"

#include <algorithm>
#include <utility>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "codecs/base64.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// How messages call a reference.
std::string quoted_reference(std::string_view href) {
  return href.starts_with("data:") ? "the data: URI" : text::quoted(href);
}

/// "https" of "https://…", "c" of "C:\…"; nothing where there is no scheme.
std::string scheme_of(std::string_view href) {
  const std::size_t colon = href.find(':');
  if (colon == std::string_view::npos || href.find_first_of("/?#") < colon) return {};
  return ascii_lower(href.substr(0, colon));
}

bool is_elsewhere(std::string_view href) {
  return !scheme_of(href).empty() || href.starts_with("//");
}

}  // namespace

std::optional<std::string> file_name_in(std::string_view href) {
  if (href.empty() || href.starts_with('#') || is_elsewhere(href)) return std::nullopt;
  const std::vector<std::uint8_t> name = codecs::decode_percent(href);
  return std::string(name.begin(), name.end());
}

Result<const TextureFile*> TextureFiles::find(Element image) {
  const auto known = file_of_image_.find(image.internal_object());
  if (known != file_of_image_.end()) return known->second;
  const Result<const TextureFile*> file = read(image);
  if (file) file_of_image_.emplace(image.internal_object(), *file);
  return file;
}

Result<const TextureFile*> TextureFiles::read(Element image) {
  const auto attribute = input_.attribute(image, "href");
  if (!attribute) return input_.error(image, "<image> has no href");
  const std::string_view href = ascii_trimmed(*attribute);
  if (const auto known = files_.find(href); known != files_.end()) return &known->second;
  TextureFile loaded;
  SFUMATO_TRY(load(image, href, loaded));
  SFUMATO_TRY(decode(image, href, loaded));
  return &files_.emplace(href, std::move(loaded)).first->second;
}

Status TextureFiles::decode(Element image, std::string_view href, TextureFile& loaded) {
  const auto given = loader_ ? loader_->decoded(loaded.file) : std::nullopt;
  Status status = given ? take(*given, loaded) : decode_file(loaded);
  if (status) return status;
  status.message = quoted_reference(href) + ": " + status.message;
  return input_.placed(image, std::move(status));
}

Status TextureFiles::decode_file(TextureFile& loaded) {
  SFUMATO_TRY_ASSIGN(auto&& decoded, codecs::decode_image(input_.context(), loaded.file));
  SFUMATO_TRY(loaded.charge.add(input_.context(), capacity_bytes(decoded.rgba), "textures"));
  loaded.image = std::move(decoded);
  return ok_status();
}

/// Pixels that the caller has decoded.
Status TextureFiles::take(const ImagePixels& given, TextureFile& loaded) {
  const auto width = static_cast<std::size_t>(std::max(given.width, 0));
  const auto height = static_cast<std::size_t>(std::max(given.height, 0));
  SFUMATO_TRY(codecs::check_image_size(input_.limits(), width, height));
  if (width == 0 || height == 0 || given.rgba.size() != 4 * width * height) {
    return make_error(StatusCode::bad_input, "pixels that are no image were given for it");
  }
  loaded.image.width = given.width;
  loaded.image.height = given.height;
  return loaded.memory.append(input_.context(), given.rgba, loaded.image.rgba);
}

Status TextureFiles::load(Element image, std::string_view href, TextureFile& loaded) {
  if (scheme_of(href) == "data") {
    return input_.in(image, "href",
                     codecs::decode_data_uri(input_.context(), href, loaded.memory, loaded.file));
  }
  if (is_elsewhere(href)) {
    return input_.error(image, text::quoted(href) +
                                   " is not read: nothing is fetched; use a file "
                                   "beside the document, or a data: URI");
  }
  const std::optional<std::string> name = file_name_in(href);
  if (!name || loader_ == nullptr) {
    return input_.error(image, text::quoted(href) + " cannot be read; use " +
                                   (loader_ ? "a PNG or JPEG file" : "a data: URI"));
  }
  Result<std::vector<std::uint8_t>> bytes = loader_->load(*name);
  if (bytes) {
    loaded.file = std::move(*bytes);
    return input_.placed(
        image, loaded.charge.add(input_.context(), capacity_bytes(loaded.file), "texture files"));
  }
  Status status = bytes.status();
  status.message = text::quoted(href) + ": " + status.message;
  return input_.placed(image, std::move(status));
}

}  // namespace sfumato::svg
