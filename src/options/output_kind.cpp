#include "options/output_kind.hpp"

#include <algorithm>

#include "base/ascii.hpp"

namespace sfumato::options {
namespace {

constexpr KnownOutput kKnownOutputs[] = {
    {"png", OutputKind::png},   {"jpg", OutputKind::jpeg},  {"jpeg", OutputKind::jpeg},
    {"webp", OutputKind::webp}, {"html", OutputKind::html}, {"pdf", OutputKind::pdf},
    {"eps", OutputKind::eps},   {"svg", OutputKind::svg},   {"glb", OutputKind::glb},
    {"sfv", OutputKind::sfv},   {"npz", OutputKind::npz},   {"ply", OutputKind::ply},
    {"json", OutputKind::json}};

}  // namespace

std::span<const KnownOutput> known_outputs() {
  return kKnownOutputs;
}

std::optional<OutputKind> kind_of_extension(std::string_view extension) {
  const auto known =
      std::ranges::find(kKnownOutputs, ascii_lower(extension), &KnownOutput::extension);
  if (known == std::end(kKnownOutputs)) return std::nullopt;
  return known->kind;
}

}  // namespace sfumato::options
