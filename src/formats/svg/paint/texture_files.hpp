#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "codecs/image_file.hpp"
#include "formats/svg/read/input.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato::svg {

struct TextureFile {
  TableMemory memory{"texture files"};  ///< for a file from a data: URI, and for given pixels
  ScopedCharge charge;                  ///< for results of a loader and of decoders
  codecs::RgbaImage image;
  std::vector<std::uint8_t> file;  ///< as it was loaded

  Vec2 size() const {
    return {static_cast<double>(image.width), static_cast<double>(image.height)};
  }
};

/// An image as a texture of a layer.
struct TexturePlace {
  const TextureFile* file = nullptr;
  Affine layer_from_texture;
  bool repeats = true;
  Vec2 period;  ///< as in Texture
};

/// Returns the file that an <image>'s href names, percent signs decoded; no value for anything but
/// a local file: a data: URI, another scheme or host, a fragment.
std::optional<std::string> file_name_in(std::string_view href);

/// The images that a document refers to, each loaded and decoded once.
class TextureFiles {
 public:
  TextureFiles(Input& input, const ResourceLoader* loader) : input_(input), loader_(loader) {}

  /// Returns the file to which href="" of an <image> refers; lives as long as this. Errors:
  /// bad_input, limit, out_of_memory.
  Result<const TextureFile*> find(Element image);

 private:
  Result<const TextureFile*> read(Element image);
  Status load(Element image, std::string_view href, TextureFile& loaded);
  Status decode(Element image, std::string_view href, TextureFile& loaded);
  Status decode_file(TextureFile& loaded);
  Status take(const ImagePixels& given, TextureFile& loaded);

  Input& input_;
  const ResourceLoader* loader_;
  std::map<std::string_view, TextureFile> files_;  ///< by href
  /// By element, because a data: URI is long and many curves may share its pattern.
  std::map<const void*, const TextureFile*> file_of_image_;
};

}  // namespace sfumato::svg
