// Runs a target without a fuzzer over files, folders and tar archives, as `make check` does with
// the corpus.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz.hpp"

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTarBlock = 512;
constexpr std::size_t kTarNameBytes = 100;
constexpr std::size_t kTarSizeAt = 124;
constexpr std::size_t kTarTypeAt = 156;

int input_count = 0;

void fail(const std::string& message) {
  std::fprintf(stderr, "replay: %s\n", message.c_str());
  std::exit(1);
}

void run(const std::string& name, const char* bytes, std::size_t size) {
  // Printed before the run, because a crash leaves no time for it.
  std::printf("%s\n", name.c_str());
  std::fflush(stdout);
  // A copy of exactly this size detects reads beyond the end.
  const std::vector<std::uint8_t> input(bytes, bytes + size);
  LLVMFuzzerTestOneInput(input.data(), input.size());
  ++input_count;
}

/// Runs the files in a tar archive in the ustar format.
void run_archive(const std::string& archive, const std::vector<char>& bytes) {
  for (std::size_t at = 0; at + kTarBlock <= bytes.size() && bytes[at] != 0;) {
    const char* header = &bytes[at];
    const std::string name(header, std::find(header, header + kTarNameBytes, '\0'));
    const std::size_t size = std::strtoul(&header[kTarSizeAt], nullptr, 8);
    at += kTarBlock;
    if (size > bytes.size() - at) fail(archive + ": cut short in " + name);
    if (header[kTarTypeAt] == '0') run(archive + ": " + name, &bytes[at], size);
    at += (size + kTarBlock - 1) / kTarBlock * kTarBlock;
  }
}

void run_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail(file.string() + ": cannot be read");
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  if (file.extension() == ".tar") return run_archive(file.string(), bytes);
  run(file.string(), bytes.data(), bytes.size());
}

void run_folder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) run_file(file);
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (fs::is_directory(argv[i])) {
      run_folder(argv[i]);
    } else {
      run_file(argv[i]);
    }
  }
  std::printf("%d inputs, none failed\n", input_count);
  return input_count > 0 ? 0 : 1;
}
