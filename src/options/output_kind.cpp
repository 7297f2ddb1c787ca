#include "options/output_kind.hpp"

#include <algorithm>
#include <array>

#include "base/text/ascii.hpp"

namespace sfumato::options {
namespace {

constexpr KnownOutput kKnownOutputs[] = {
    {"png", OutputKind::png},   {"jpg", OutputKind::jpeg},  {"jpeg", OutputKind::jpeg},
    {"webp", OutputKind::webp}, {"html", OutputKind::html}, {"pdf", OutputKind::pdf},
    {"eps", OutputKind::eps},   {"svg", OutputKind::svg},   {"glb", OutputKind::glb},
    {"sfv", OutputKind::sfv},   {"npz", OutputKind::npz},   {"ply", OutputKind::ply},
    {"json", OutputKind::json}};

constexpr KnownOutput kKnownFrames[] = {{"rgb24", OutputKind::rgb24},
                                        {"rgba", OutputKind::rgba},
                                        {"rgb48le", OutputKind::rgb48le},
                                        {"rgba64le", OutputKind::rgba64le}};

constexpr auto kFormats = [] {
  std::array<std::string_view, std::size(kKnownOutputs) + std::size(kKnownFrames)> formats;
  const auto frames =
      std::ranges::transform(kKnownOutputs, formats.begin(), &KnownOutput::extension).out;
  std::ranges::transform(kKnownFrames, frames, &KnownOutput::extension);
  return formats;
}();

std::optional<OutputKind> find(std::span<const KnownOutput> outputs, std::string_view extension) {
  const auto known = std::ranges::find(outputs, ascii_lower(extension), &KnownOutput::extension);
  if (known == outputs.end()) return std::nullopt;
  return known->kind;
}

}  // namespace

std::span<const KnownOutput> known_outputs() {
  return kKnownOutputs;
}

std::span<const KnownOutput> known_frames() {
  return kKnownFrames;
}

std::span<const std::string_view> known_formats() {
  return kFormats;
}

std::optional<OutputKind> kind_of_extension(std::string_view extension) {
  return find(kKnownOutputs, extension);
}

std::optional<OutputKind> frame_of_extension(std::string_view extension) {
  return find(kKnownFrames, extension);
}

std::string_view name_of_frame(OutputKind kind) {
  return std::ranges::find(kKnownFrames, kind, &KnownOutput::kind)->extension;
}

}  // namespace sfumato::options
