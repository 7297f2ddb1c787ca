// Draws scenes under several configurations, which must give the same bits (README.md).
#include <charconv>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "equal/tool/configuration.hpp"
#include "equal/tool/difference.hpp"
#include "equal/tool/scene.hpp"
#include "equal/tool/scene_check.hpp"

namespace sfumato::test {
namespace {

constexpr int kSame = 0, kDifferent = 1, kUsage = 2;

int usage() {
  std::fputs(
      "usage: equal_scenes hashes all|few|one|CONFIGURATION SCENES...\n"
      "       equal_scenes trace CONFIGURATION SCENE FILE\n"
      "       equal_scenes compare FILE_A FILE_B\n"
      "A CONFIGURATION is THREADS/sse2|avx2|avx512, a SCENE a seed or a document, SCENES also\n"
      "FIRST-LAST. Exit 0: the same bits; 1: not; 2: something is wrong.\n",
      stderr);
  return kUsage;
}

int fail(const Status& status) {
  std::fprintf(stderr, "equal_scenes: %s\n", to_string(status).c_str());
  return kUsage;
}

/// Returns "1-1000" as seeds; otherwise the text itself.
std::vector<std::string> scene_names(std::string_view text) {
  std::uint64_t first = 0, last = 0;
  const char* const end = text.data() + text.size();
  const auto from = std::from_chars(text.data(), end, first);
  if (from.ec != std::errc() || from.ptr == end || *from.ptr != '-') return {std::string(text)};
  const auto to = std::from_chars(from.ptr + 1, end, last);
  if (to.ec != std::errc() || to.ptr != end) return {std::string(text)};
  std::vector<std::string> names;
  for (std::uint64_t seed = first; seed <= last; ++seed) names.push_back(std::to_string(seed));
  return names;
}

/// Returns the configurations for a word; the seed chooses those for "few" and "one".
std::vector<Configuration> configurations(std::string_view word, std::uint64_t seed) {
  if (word == "all") return all_configurations();
  std::vector<Configuration> chosen = configurations_of(seed);
  if (word == "few") return chosen;
  if (word == "one") return {chosen[seed % chosen.size()]};
  if (const auto configuration = parse_configuration(word)) return {*configuration};
  return {};
}

int hashes(std::string_view word, const std::vector<std::string>& names) {
  SceneChecker checker;
  int code = kSame;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Result<Scene> scene = scene_of(names[i]);
    if (!scene) return fail(scene.status());
    const std::vector<Configuration> chosen = configurations(word, i);
    if (chosen.empty()) return usage();
    const SceneCheck check = checker.check(*scene, chosen);
    std::puts(check.line.c_str());
    std::fflush(stdout);
    if (check.complaint.empty()) continue;
    std::fputs(check.complaint.c_str(), stderr);
    code = kDifferent;
  }
  return code;
}

int trace(std::string_view configuration_text, const std::string& name, const std::string& path) {
  const auto configuration = parse_configuration(configuration_text);
  if (!configuration) return usage();
  const Result<Scene> scene = scene_of(name);
  if (!scene) return fail(scene.status());
  SceneChecker checker;
  const Result<Trace> traced = checker.trace(*scene, *configuration);
  if (!traced) return fail(traced.status());
  const Status saved = save_trace(path, *traced);
  return saved ? kSame : fail(saved);
}

int compare(const std::string& path_a, const std::string& path_b) {
  const Result<Trace> a = load_trace(path_a);
  if (!a) return fail(a.status());
  const Result<Trace> b = load_trace(path_b);
  if (!b) return fail(b.status());
  const auto difference = first_difference(*a, *b);
  if (!difference) {
    std::printf("the same bits in all %zu stages\n", a->size());
    return kSame;
  }
  std::fputs(to_string(*difference).c_str(), stdout);
  return kDifferent;
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() >= 3 && arguments[0] == "hashes") {
    std::vector<std::string> names;
    for (std::size_t i = 2; i < arguments.size(); ++i) {
      for (std::string& name : scene_names(arguments[i])) names.push_back(std::move(name));
    }
    return hashes(arguments[1], names);
  }
  if (arguments.size() == 4 && arguments[0] == "trace") {
    return trace(arguments[1], arguments[2], arguments[3]);
  }
  if (arguments.size() == 3 && arguments[0] == "compare") {
    return compare(arguments[1], arguments[2]);
  }
  return usage();
}

}  // namespace
}  // namespace sfumato::test

int main(int argc, char** argv) {
  return sfumato::test::run({argv + 1, argv + argc});
}
