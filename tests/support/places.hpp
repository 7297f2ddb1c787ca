#pragma once

#include <string>
#include <string_view>

/// Absolute paths that the build knows. One object has them, so that all others are the same in
/// every checkout and a compile cache can share them.
namespace sfumato::test {

/// A path of the checkout: source_path("examples/fish.svg").
std::string source_path(std::string_view relative);

/// A path of the measured material beside the checkout, which may be missing.
std::string shared_path(std::string_view relative);

/// The built command.
std::string sfumato_program();

/// The built shared library of the C interface.
std::string c_library();

}  // namespace sfumato::test
