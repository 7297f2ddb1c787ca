#include "cli/resources.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.hpp"
#include "cli/option_helpers.hpp"
#include "cli/values.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kGroup = "Limits";
constexpr std::uint64_t kLargestMemoryMib = std::uint64_t{1} << 24;
constexpr double kLargestSeconds = 1e9;

bool set_seconds(const std::string& text, std::optional<double>& seconds) {
  seconds.reset();
  if (text == "off") return true;
  seconds = parse_positive(text);
  return seconds && *seconds <= kLargestSeconds;
}

/// All names, and which of them was probably meant.
std::string expected_names(std::string_view given) {
  std::string list;
  std::vector<std::string_view> names;
  for (const LimitName& known : limit_names()) {
    list += (list.empty() ? "" : ", ") + std::string(known.name);
    names.push_back(known.name);
  }
  return list + text::did_you_mean(given, names);
}

/// What is wrong with "NAME=VALUE"; empty: nothing, and the limit is set.
std::string complaint_about(std::string_view text, Limits& limits) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = text.substr(0, equals);
  const auto known = std::ranges::find(limit_names(), name, &LimitName::name);
  if (known == limit_names().end()) return "NAME=VALUE, NAME one of " + expected_names(name);
  const std::string_view digits = text.substr(std::min(equals + 1, text.size()));
  const std::optional<std::uint64_t> value = parse_count(digits, known->highest);
  if (!value) {
    return std::string(name) + "= and a whole number from 0 to " + std::to_string(known->highest) +
           ", perhaps with k, M, KiB or MiB behind it";
  }
  limits.*(known->value) = static_cast<std::size_t>(*value);
  return {};
}

void set_limits(const std::vector<std::string>& texts, Limits& limits) {
  for (const std::string& text : texts) {
    const std::string expected = complaint_about(text, limits);
    if (expected.empty()) continue;
    throw CLI::ValidationError("--limit", "\"" + text + "\" given, expected " + expected);
  }
}

#if defined(__GLIBC__)
constexpr int kMiB = 1 << 20;
#endif

/// What is freed is taken again by the next table: to fetch it from the system anew, page by page
/// and in one thread, takes up to a sixth of the time.
void keep_freed_memory() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 32 * kMiB);
  mallopt(M_TRIM_THRESHOLD, 1024 * kMiB);
#endif
}

/// For those who give a bound: freed blocks of a MiB go back to the system, where glibc would keep
/// them beside what is charged.
void return_freed_memory() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, kMiB);
  mallopt(M_TRIM_THRESHOLD, kMiB / 8);
#endif
}

}  // namespace

void add_resources(CLI::App& app, Resources& resources) {
  keep_freed_memory();
  add_value(
      app, "--max-memory", {"a whole number of MiB, at least 1", "MIB"},
      "Give up before taking more memory [" + std::to_string(limits::kMemoryBytes >> 20) + "]",
      [&bytes = resources.memory_bytes](const std::string& text) {
        const auto value = parse_whole(text, 1, kLargestMemoryMib);
        bytes = static_cast<std::size_t>(value.value_or(0)) << 20;
        return_freed_memory();
        return value.has_value();
      })
      ->group(kGroup);
  add_value(
      app, "--max-time", {"a number of seconds above 0, or off", "SECONDS|off"},
      "Give a drawing up after this time [" + JsonWriter().value(limits::kSeconds).text() + "]",
      [&seconds = resources.seconds](const std::string& text) {
        return set_seconds(text, seconds);
      })
      ->group(kGroup);
  app.add_option_function<std::vector<std::string>>(
         "--limit",
         [&resources](const std::vector<std::string>& texts) {
           set_limits(texts, resources.limits);
         },
         "Set another limit on the input, as curves=300k; may be\ngiven several times")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->group(kGroup);
}

std::optional<Deadline> deadline_of(const Resources& resources) {
  if (!resources.seconds) return std::nullopt;
  return Deadline::in(*resources.seconds);
}

}  // namespace sfumato::cli
