// hostile [--binary FILE] [--jobs N] [--family NAME] [--case NAME] [--at-most N]
//         [--list | --table | --check-table | --growth | --keep DIR]
//
// Runs `sfumato` against the cases of this folder. Exit 1 if one fails; each failure is a line "not
// ok FAMILY/CASE: why". The last lines count.
//   --binary  another build of the command; also by SFUMATO_HOSTILE_BINARY
//   --at-most N cases of each larger family, evenly spread
//   --table   the maxima of each family, as the table of README.md
//   --check-table  checks the counts in that table against the cases; runs nothing
//   --growth  runs the generators of growing.cpp instead, or the one that --family names
//   --keep    writes the cases' files there, in FAMILY/CASE/, and runs nothing
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "hostile/crew.hpp"
#include "hostile/growth.hpp"
#include "hostile/sandbox.hpp"
#include "hostile/table.hpp"
#include "support/places.hpp"

namespace sfumato::hostile {
namespace {

struct Options {
  std::string binary;
  std::string family;
  std::string name;
  std::string keep;
  int jobs = 1;
  std::size_t at_most = SIZE_MAX;
  bool list = false;
  bool table = false;
  bool check_table = false;
  bool growth = false;
};

[[noreturn]] void fail(const std::string& message) {
  std::fprintf(stderr, "hostile: %s\n", message.c_str());
  std::exit(2);
}

Options parse(int argc, char** argv) {
  Options options;
  const char* named = std::getenv("SFUMATO_HOSTILE_BINARY");
  options.binary = named ? named : test::sfumato_program();
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const auto value = [&] { return ++i < argc ? argv[i] : (fail("a value is missing"), ""); };
    if (word == "--binary") {
      options.binary = value();
    } else if (word == "--jobs") {
      options.jobs = std::max(1, std::atoi(value()));
    } else if (word == "--at-most") {
      options.at_most = static_cast<std::size_t>(std::max(1, std::atoi(value())));
    } else if (word == "--family") {
      options.family = value();
    } else if (word == "--case") {
      options.name = value();
    } else if (word == "--keep") {
      options.keep = value();
    } else if (word == "--list") {
      options.list = true;
    } else if (word == "--table") {
      options.table = true;
    } else if (word == "--check-table") {
      options.check_table = true;
    } else if (word == "--growth") {
      options.growth = true;
    } else {
      fail("unknown argument " + std::string(word));
    }
  }
  options.binary = std::filesystem::absolute(options.binary);
  return options;
}

/// Returns whether the item at `index` of `count` is in an even sample of at most `most`.
bool is_in_sample(std::size_t index, std::size_t count, std::size_t most) {
  const std::size_t share = std::min(most, count);
  return (index + 1) * share / count > index * share / count;
}

/// Returns the requested cases. A name that occurs twice in a family is our mistake.
std::vector<Job> jobs_of(const std::vector<Family>& families, const Options& options) {
  std::vector<Job> jobs;
  for (const Family& family : families) {
    if (!options.family.empty() && family.name() != options.family) continue;
    std::map<std::string, int> count_of;
    std::size_t index = 0;
    for (const Case& attack : family.cases()) {
      const bool is_chosen = is_in_sample(index++, family.cases().size(), options.at_most);
      if (++count_of[attack.name] > 1) fail("two cases " + family.name() + "/" + attack.name);
      if (attack.exit_code != kDone && attack.message.empty()) {
        fail(family.name() + "/" + attack.name + " expects no message");
      }
      if (!is_chosen || (!options.name.empty() && attack.name != options.name)) continue;
      jobs.push_back({&family, &attack});
    }
  }
  if (jobs.empty()) fail("there is no such case");
  return jobs;
}

struct Figures {
  std::map<int, int> count_of_exit;
  int count = 0;
  double most_seconds = 0;
  std::size_t most_bytes = 0;

  void add(const Result& result) {
    ++count;
    ++count_of_exit[result.exit_code];
    most_seconds = std::max(most_seconds, result.cpu_seconds);
    most_bytes = std::max(most_bytes, result.peak_bytes);
  }
  void print(const char* name) {
    std::printf("| %s | %d | %d | %d | %d | %d | %.2f | %zu |\n", name, count, count_of_exit[kDone],
                count_of_exit[kBadInput], count_of_exit[kBadUsage], count_of_exit[kLimit],
                most_seconds, most_bytes >> 20);
  }
};

int report(const std::vector<Job>& jobs, const std::vector<Result>& results,
           const Options& options) {
  Figures all;
  std::map<std::string, Figures> of_family;
  int failed = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    all.add(results[i]);
    of_family[jobs[i].family->name()].add(results[i]);
    if (results[i].complaint[0] == '\0') continue;
    ++failed;
    std::printf("not ok %s: %s\n", jobs[i].name().c_str(), results[i].complaint);
  }
  if (options.table) {
    std::printf("| family | cases | exit 0 | 1 | 2 | 3 | most CPU s | most MiB |\n");
    std::printf("|---|---|---|---|---|---|---|---|\n");
    for (auto& [name, figures] : of_family) figures.print(name.c_str());
    all.print("all");
  }
  std::printf("%zu cases, %d failed; most: %.2f s of processor time, %zu MiB\n", jobs.size(),
              failed, all.most_seconds, all.most_bytes >> 20);
  return failed == 0 ? 0 : 1;
}

void keep(const std::vector<Job>& jobs, const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path base = fs::absolute(folder);
  for (const Job& job : jobs) {
    const Sandbox sandbox;
    if (!sandbox.prepare(*job.attack)) fail("cannot make " + job.name());
    fs::create_directories(base / job.family->name());
    const fs::path to = base / job.name();
    std::error_code ignored;  // pipes and links without a target cannot be copied
    fs::copy(sandbox.path() + "/case", to,
             fs::copy_options::recursive | fs::copy_options::copy_symlinks, ignored);
  }
}

int run(int argc, char** argv) {
  const Options options = parse(argc, argv);
  if (options.growth) return run_growth(options.binary, options.family);
  const std::vector<Family> families = all_families();
  if (options.check_table) {
    return check_table(families, test::source_path("tests/hostile/README.md")) ? 0 : 1;
  }
  const std::vector<Job> jobs = jobs_of(families, options);
  if (options.list) {
    for (const Job& job : jobs) std::printf("%s\n", job.name().c_str());
    return 0;
  }
  if (!options.keep.empty()) return keep(jobs, options.keep), 0;
  if (access(options.binary.c_str(), X_OK) != 0) fail("cannot run " + options.binary);
  return report(jobs, run_all(jobs, options.binary, options.jobs), options);
}

}  // namespace
}  // namespace sfumato::hostile

int main(int argc, char** argv) {
  return sfumato::hostile::run(argc, argv);
}
