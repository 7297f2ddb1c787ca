#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "sfumato/formats/read_document.hpp"

namespace sfumato::bench {

/// Returns the CPU time of all threads of this process.
inline double cpu_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// A document and the index of its layer with the most curves.
struct LargestLayer {
  std::string name;
  Document document;
  std::uint32_t layer = 0;
  std::uint32_t curve_count = 0;
};

/// Returns nothing if the file cannot be read or has no layer.
inline std::optional<LargestLayer> read_largest_layer(Context& context, const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  LargestLayer found{path.substr(path.rfind('/') + 1), {}};
  Result<ReadDocument> read = read_document(context, text, found.name);
  if (!read || read->document.layers.empty()) return std::nullopt;
  found.document = std::move(read->document);
  const std::vector<Layer>& layers = found.document.layers;
  const auto largest =
      std::ranges::max_element(layers, {}, [](const Layer& layer) { return layer.curves.size(); });
  found.layer = static_cast<std::uint32_t>(largest - layers.begin());
  found.curve_count = static_cast<std::uint32_t>(largest->curves.size());
  return found;
}

/// Options of a program, each with a function that reads its value.
using OptionReaders = std::map<std::string, std::function<void(const char* value)>>;

/// Reads options and measures files in the order of the arguments. Complains of files that cannot
/// be measured. Returns the exit code.
inline int measure_files(int argc, char** argv, const OptionReaders& readers,
                         const std::function<bool(const std::string& path)>& measure,
                         const char* complaint) {
  bool is_good = argc > 1;
  for (int i = 1; i < argc; ++i) {
    const auto reader = readers.find(argv[i]);
    if (reader != readers.end() && i + 1 < argc) {
      reader->second(argv[++i]);
    } else if (!measure(argv[i])) {
      std::fprintf(stderr, "%s %s\n", argv[i], complaint);
      is_good = false;
    }
  }
  return is_good ? 0 : 1;
}

/// Returns a number from an argument, at least `least`.
inline int number_of(const char* value, int least) {
  return std::max(least, std::atoi(value));
}

}  // namespace sfumato::bench
