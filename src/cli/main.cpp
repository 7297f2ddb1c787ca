#include <cxxabi.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <typeinfo>

#include "cli/commands/commands.hpp"
#include "cli/messages.hpp"

namespace {

/// Returns whether the process ends because memory was refused. If not even the exception got
/// memory, there is no exception; then a small block is refused as well.
bool is_lack_of_memory() {
  constexpr std::size_t kSmallBytes = 256;
  if (const std::type_info* thrown = abi::__cxa_current_exception_type()) {
    return *thrown == typeid(std::bad_alloc);
  }
  void* const block = std::malloc(kSmallBytes);
  std::free(block);
  return !block;
}

/// Ends the process with an exit code if memory is refused where no handler can catch it: in the
/// initialisers of global objects, and in library functions that are `noexcept` and allocate.
/// Allocates nothing.
[[noreturn]] void end_without_memory() {
  if (!is_lack_of_memory()) std::abort();
  constexpr std::string_view kText = "sfumato: error: out of memory\n";
  [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, kText.data(), kText.size());
  _exit(sfumato::cli::kResource);
}

/// Runs before the initialisers of global objects.
[[gnu::constructor(101)]] void set_end_without_memory() {
  std::set_terminate(end_without_memory);
}

}  // namespace

int main(int argc, char** argv) {
  return sfumato::cli::run(argc, argv);
}
