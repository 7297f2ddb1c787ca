#pragma once

#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "sfumato/formats/orzan/orzan.hpp"
#include "support/places.hpp"

namespace sfumato::bench {

/// The exit code of a program whose scene is missing (bench/regions.txt).
constexpr int kSkipped = 77;

/// Returns the text of a public scene; nothing if the scenes are missing.
inline std::optional<std::string> scene_text(const std::string& name) {
  std::ifstream stream(test::shared_path("scenes/") + name, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// Returns a public scene. Skips the benchmark if the scene is missing.
inline std::optional<Document> scene(benchmark::State& state, const std::string& name) {
  Context context;
  const std::optional<std::string> text = scene_text(name);
  if (text) {
    Result<ReadDocument> read = read_orzan(context, *text, name);
    if (read) return std::move(read->document);
  }
  state.SkipWithError(("the public scene " + name + " is not at hand").c_str());
  return std::nullopt;
}

}  // namespace sfumato::bench
