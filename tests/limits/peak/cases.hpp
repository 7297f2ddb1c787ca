#pragma once

#include <functional>
#include <string>
#include <vector>

/// The calls of `sfumato` that take the most memory: inputs near the limits, and each output.
namespace sfumato::peak {

struct InputFile {
  std::string name;
  std::function<std::string()> bytes;
};

struct Case {
  std::string name;
  std::vector<InputFile> files;
  std::vector<std::string> arguments;  ///< of the command; a file of the case is DIR/name
  bool is_quick = false;               ///< small enough for every run of the tests
};

/// Returns the drawing that takes almost nothing: the process's own memory.
Case empty_drawing();

std::vector<Case> all_cases();

}  // namespace sfumato::peak
