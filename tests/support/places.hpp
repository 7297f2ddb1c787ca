#pragma once

#include <string>
#include <string_view>

/// Absolute paths of the build. One object holds them, so that all others are the same in every
/// checkout and a compile cache can share them.
namespace sfumato::test {

/// Returns a path of the checkout: source_path("examples/fish.svg").
std::string source_path(std::string_view relative);

/// Returns a path of the measured material beside the checkout, which may be missing.
std::string shared_path(std::string_view relative);

/// Returns the path of the built command.
std::string sfumato_program();

/// Returns the path of the built shared library of the C interface.
std::string c_library();

}  // namespace sfumato::test
