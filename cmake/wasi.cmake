# Toolchain: clang 19 and wasi-libc for WebAssembly, as packaged by Debian (scripts/setup wasm). Modules
# have no threads and no exceptions; they use 128-bit SIMD.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_AR llvm-ar-19)
set(CMAKE_RANLIB llvm-ranlib-19)
foreach(language C CXX)
  set(CMAKE_${language}_COMPILER_TARGET wasm32-wasi)
  set(CMAKE_${language}_FLAGS_INIT "-msimd128 -fno-exceptions -fvisibility=hidden")
endforeach()
string(APPEND CMAKE_CXX_FLAGS_INIT " -fno-rtti")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
