// WebAssembly has no threads.
#include "base/native/tbb_executor.hpp"

namespace sfumato {

std::unique_ptr<Executor> make_tbb_executor(int) {
  return nullptr;
}

}  // namespace sfumato
