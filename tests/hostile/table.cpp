#include "hostile/table.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace sfumato::hostile {
namespace {

/// The number of cases, and the number for each exit code.
struct Counts {
  std::size_t all = 0;
  std::array<std::size_t, 4> of_exit{};

  void add(const Case& attack) {
    ++all;
    ++of_exit.at(static_cast<std::size_t>(attack.exit_code));
  }
  /// Returns the beginning of a table's row.
  std::string row(const std::string& name) const {
    std::string text = "| " + name + " | " + std::to_string(all) + " |";
    for (const std::size_t count : of_exit) text += " " + std::to_string(count) + " |";
    return text;
  }
};

}  // namespace

bool check_table(const std::vector<Family>& families, const std::string& readme) {
  std::ifstream file(readme, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::string> expected;
  Counts all;
  for (const Family& family : families) {
    Counts counts;
    for (const Case& attack : family.cases()) {
      counts.add(attack);
      all.add(attack);
    }
    expected.push_back("\n" + counts.row(family.name()));
  }
  expected.push_back("\n" + all.row("all"));
  expected.push_back("\n" + std::to_string(all.all) + " attacks on `sfumato` in " +
                     std::to_string(families.size()) + " families.");
  bool agrees = true;
  for (const std::string& line : expected) {
    if (text.find(line) != std::string::npos) continue;
    agrees = false;
    std::printf("not ok %s lacks: %s\n", readme.c_str(), line.c_str() + 1);
  }
  return agrees;
}

}  // namespace sfumato::hostile
