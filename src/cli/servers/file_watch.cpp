#include "cli/servers/file_watch.hpp"

#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

namespace sfumato::cli {
namespace {

using std::chrono::milliseconds;

constexpr std::uint32_t kEvents =
    IN_CLOSE_WRITE | IN_MODIFY | IN_MOVED_TO | IN_MOVED_FROM | IN_CREATE | IN_DELETE | IN_ATTRIB;

/// How often the files' times are polled, with inotify and without.
constexpr milliseconds kSeldom{1000};
constexpr milliseconds kOften{200};

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FileWatch::FileWatch() : notifier_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}

FileWatch::~FileWatch() {
  if (notifier_ >= 0) close(notifier_);
}

FileWatch::Signature FileWatch::signature_of(const std::string& path) {
  struct stat file {
  }, link{};
  Signature signature;
  if (stat(path.c_str(), &file) == 0) {
    std::get<0>(signature) = file.st_dev;
    std::get<1>(signature) = file.st_ino;
    std::get<2>(signature) = static_cast<std::uint64_t>(file.st_size) + 1;
    std::get<3>(signature) = nanoseconds(file.st_mtim);
  }
  if (lstat(path.c_str(), &link) == 0) {
    std::get<4>(signature) = link.st_ino;
    std::get<5>(signature) = nanoseconds(link.st_mtim);
  }
  return signature;
}

std::vector<FileWatch::Signature> FileWatch::signatures() const {
  std::vector<Signature> result;
  for (const std::string& file : files_) result.push_back(signature_of(file));
  return result;
}

void FileWatch::set_files(std::vector<std::string> files) {
  if (files == files_) return;
  std::vector<Signature> seen;
  for (const std::string& file : files) {
    const auto known = std::ranges::find(files_, file);
    const auto index = static_cast<std::size_t>(known - files_.begin());
    seen.push_back(known != files_.end() && index < seen_.size() ? seen_[index]
                                                                 : signature_of(file));
  }
  files_ = std::move(files);
  seen_ = std::move(seen);
  if (notifier_ < 0) return;
  for (const int watch : watches_) inotify_rm_watch(notifier_, watch);
  watches_.clear();
  std::set<std::string> folders;
  for (const std::string& file : files_) {
    const std::string folder = std::filesystem::path(file).parent_path().string();
    folders.insert(folder.empty() ? "." : folder);
  }
  for (const std::string& folder : folders) {
    const int watch = inotify_add_watch(notifier_, folder.c_str(), kEvents);
    if (watch >= 0) watches_.push_back(watch);
  }
}

void FileWatch::look() {
  drain();
  seen_ = signatures();
}

void FileWatch::drain() const {
  std::array<char, 4096> events;
  while (notifier_ >= 0 && read(notifier_, events.data(), events.size()) > 0) {
  }
}

bool FileWatch::wait(milliseconds most) {
  const auto end = std::chrono::steady_clock::now() + most;
  for (;;) {
    if (signatures() != seen_) return true;
    const auto left = std::chrono::ceil<milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0) return false;
    const milliseconds step = std::min(left, watches_.empty() ? kOften : kSeldom);
    pollfd request{notifier_, POLLIN, 0};
    const int woken = poll(&request, notifier_ >= 0 ? 1 : 0, static_cast<int>(step.count()));
    if (woken < 0) return false;
    if (woken > 0) drain();
  }
}

}  // namespace sfumato::cli
