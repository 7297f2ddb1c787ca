#include "base/native/folder.hpp"

#include <filesystem>
#include <system_error>

namespace sfumato {

Status make_folder(const std::string& path) {
  std::error_code error, ignored;
  std::filesystem::create_directories(path, error);
  if (std::filesystem::is_directory(path, ignored)) return ok_status();
  return make_error(StatusCode::io, "cannot be made: " + error.message(), {path});
}

}  // namespace sfumato
