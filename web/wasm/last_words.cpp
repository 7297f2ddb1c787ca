// Debian's C++ library prints a message before it ends a program, which would pull in printf, and
// nobody reads it. These functions replace its own.
#include <cstdlib>
#include <vector>  // declares the first function, as all containers do

void std::__libcpp_verbose_abort(const char* /*format*/, ...) {
  std::abort();
}

extern "C" [[noreturn]] void abort_message(const char* /*format*/, ...) {
  std::abort();
}
