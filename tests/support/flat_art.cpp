#include "support/flat_art.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sfumato/import/import_svg.hpp"
#include "support/draw.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace sfumato::test {
namespace {

const std::string kFolder = source_path("tests/trace/flat");

}  // namespace

std::vector<std::string> flat_art_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".svg") names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

Result<Document> flat_art(Context& context, const std::string& name, bool has_background) {
  const std::string path = kFolder + '/' + name + ".svg";
  const auto text = file_bytes(path);
  if (!text) return make_error(StatusCode::io, "cannot be read", {path});
  Result<ImportedSvg> imported = import_svg(context, *text, path);
  if (!imported) return imported.status();
  if (!imported->warnings.empty()) {
    return make_error(StatusCode::bad_input, imported->warnings.front().message, {path});
  }
  if (!has_background) imported->document.background.reset();
  return std::move(imported->document);
}

Result<Image> flat_picture(Context& context, const std::string& name, bool has_background,
                           double scale) {
  const Result<Document> document = flat_art(context, name, has_background);
  if (!document) return document.status();
  const int width = static_cast<int>(std::lround(scale * document->artboard.width()));
  const int height = static_cast<int>(std::lround(scale * document->artboard.height()));
  const PixelFormat format = document->background ? PixelFormat::rgb8 : PixelFormat::rgba8;
  return draw(context, *document, width, height, format);
}

}  // namespace sfumato::test
