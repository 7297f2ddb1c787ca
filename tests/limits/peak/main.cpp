// Peak resident memory of `sfumato` compared with its --max-memory: tests/limits/README.md.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_command.hpp"
#include "limits/peak/cases.hpp"
#include "support/places.hpp"

namespace sfumato::peak {
namespace {

using test::CommandResult;
using test::TemporaryFolder;

constexpr double kMebibyte = 1 << 20;
/// Allowance beyond the budget: fragmented heaps, stacks, small objects.
constexpr double kLargestRatio = 1.25;

struct Options {
  std::string binary = test::sfumato_program();
  std::vector<std::string> words;  ///< only cases whose names contain one of them
  std::vector<int> budgets_mib{64, 128, 256, 512, 1024};
  int steps_between = 3;  ///< between the last refused budget and the first sufficient one
  bool quick = false;
};

/// Runs in a separate process, because a process that is large at its fork passes that peak on to
/// the child.
bool write_files(const Case& of, const TemporaryFolder& folder) {
  const pid_t id = fork();
  if (id == 0) {
    for (const InputFile& file : of.files) folder.add(file.name, file.bytes());
    _exit(0);
  }
  int status = 0;
  return id > 0 && waitpid(id, &status, 0) == id && status == 0;
}

CommandResult run(const Options& options, const Case& of, const TemporaryFolder& folder,
                  int budget_mib) {
  std::vector<std::string> arguments{options.binary};
  for (std::string word : of.arguments) {
    if (word.starts_with("DIR/")) word = folder.path(word.substr(4));
    arguments.push_back(std::move(word));
  }
  arguments.insert(arguments.end(), {"--max-memory", std::to_string(budget_mib)});
  return test::run_command(arguments);
}

bool is_wanted(const Options& options, const Case& of) {
  if (options.quick && !of.is_quick) return false;
  if (options.words.empty()) return true;
  return std::ranges::any_of(options.words, [&](const std::string& word) {
    return of.name.find(word) != std::string::npos;
  });
}

/// One case under increasing budgets.
class Measurement {
 public:
  Measurement(const Options& options, const Case& of, std::size_t base_bytes)
      : options_(options), of_(of), base_bytes_(static_cast<double>(base_bytes)) {}

  /// Runs the budgets in order up to the first that suffices, then some between it and the previous
  /// one, because the relative peak is highest at the smallest sufficient budget. Returns whether
  /// all stayed within their limits.
  bool run_all();

 private:
  /// Prints a line. Returns whether the budget sufficed.
  bool is_enough(int budget_mib);

  const Options& options_;
  const Case& of_;
  double base_bytes_;
  TemporaryFolder folder_;
  bool keeps_ = true;
};

bool Measurement::run_all() {
  if (!write_files(of_, folder_)) {
    std::printf("%s: its files cannot be written\n", of_.name.c_str());
    return false;
  }
  int refused = 0;
  for (const int budget_mib : options_.budgets_mib) {
    if (!is_enough(budget_mib)) {
      refused = budget_mib;
      continue;
    }
    int enough = budget_mib;
    for (int step = 0; step < options_.steps_between && enough - refused > 4; ++step) {
      const int between = (refused + enough) / 2;
      (is_enough(between) ? enough : refused) = between;
    }
    break;
  }
  return keeps_;
}

bool Measurement::is_enough(int budget_mib) {
  const CommandResult result = run(options_, of_, folder_, budget_mib);
  const auto peak = static_cast<double>(result.peak_bytes);
  const double ratio = (peak - base_bytes_) / kMebibyte / budget_mib;
  const bool good = ratio <= kLargestRatio && (result.exit_code == 0 || result.exit_code == 3);
  std::printf("| %s | %d | %d | %.0f | %.2f | %.1f |%s\n", of_.name.c_str(), budget_mib,
              result.exit_code, peak / kMebibyte, ratio, result.cpu_seconds, good ? "" : " <-");
  std::fflush(stdout);
  keeps_ = keeps_ && good;
  return result.exit_code == 0;
}

std::vector<int> numbers(const std::string& list) {
  std::vector<int> found;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) found.push_back(std::atoi(word.c_str()));
  return found;
}

Options parsed(int count, char** words) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const bool has_value = i + 1 < count;
    if (word == "--quick") {
      options.quick = true;
      options.budgets_mib = {24, 64, 128};
      options.steps_between = 2;
    } else if (word == "--budgets" && has_value) {
      options.budgets_mib = numbers(words[++i]);
    } else if (word == "--binary" && has_value) {
      options.binary = words[++i];
    } else {
      options.words.push_back(word);
    }
  }
  return options;
}

std::size_t base_bytes(const Options& options) {
  const TemporaryFolder folder;
  const Case empty = empty_drawing();
  write_files(empty, folder);
  return run(options, empty, folder, 64).peak_bytes;
}

}  // namespace
}  // namespace sfumato::peak

int main(int argc, char** argv) {
  using namespace sfumato::peak;
  const Options options = parsed(argc, argv);
  const std::size_t base = base_bytes(options);
  std::printf("an empty drawing: %.1f MiB\n\n", static_cast<double>(base) / kMebibyte);
  std::printf("| drawing | budget MiB | exit | peak MiB | (peak - empty) / budget | CPU s |\n");
  std::printf("|---|---|---|---|---|---|\n");
  bool keeps = true;
  for (const Case& one : all_cases()) {
    if (is_wanted(options, one)) keeps = Measurement(options, one, base).run_all() && keeps;
  }
  return keeps ? 0 : 1;
}
