#include "options/settings.hpp"

namespace sfumato::options {

std::optional<Deadline> deadline_of(const Resources& resources) {
  if (!resources.seconds) return std::nullopt;
  return Deadline::in(*resources.seconds);
}

}  // namespace sfumato::options
