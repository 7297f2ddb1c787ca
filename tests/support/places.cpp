#include "support/places.hpp"

namespace sfumato::test {

std::string source_path(std::string_view relative) {
  return std::string(SFUMATO_SOURCE_DIR "/").append(relative);
}

std::string shared_path(std::string_view relative) {
  return std::string(SFUMATO_SOURCE_DIR "/../shared/").append(relative);
}

std::string sfumato_program() {
  return SFUMATO_PROGRAM;
}

std::string c_library() {
  return SFUMATO_C_LIBRARY;
}

}  // namespace sfumato::test
