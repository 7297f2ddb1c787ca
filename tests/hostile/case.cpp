#include "hostile/case.hpp"

#include <map>

namespace sfumato::hostile {
namespace {

std::map<std::string, void (*)(Family&)>& fillers() {
  static std::map<std::string, void (*)(Family&)> all;
  return all;
}

}  // namespace

Register::Register(const char* name, void (*fill)(Family&)) {
  fillers()[name] = fill;
}

std::vector<Family> all_families() {
  std::vector<Family> families;
  for (const auto& [name, fill] : fillers()) fill(families.emplace_back(name));
  return families;
}

}  // namespace sfumato::hostile
