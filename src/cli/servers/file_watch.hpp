#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace sfumato::cli {

/// Reports when files change, also if other files of the same name replace them or if they are
/// missing for a while. Folders are watched with inotify. If inotify is refused, and on network
/// file systems, the files' times are polled.
class FileWatch {
 public:
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Sets the files to watch. Their state counts as unchanged since the last `look`.
  void set_files(std::vector<std::string> files);
  /// Records the current state of the files; later changes count.
  void look();
  /// Returns whether a file has changed since `look`. Waits at most `most` for a change; returns
  /// early on a signal.
  bool wait(std::chrono::milliseconds most);

 private:
  /// Device, inode, size and time of change, both of the file that the name leads to and of the
  /// link.
  using Signature = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::int64_t,
                               std::uint64_t, std::int64_t>;

  static Signature signature_of(const std::string& path);
  std::vector<Signature> signatures() const;
  void drain() const;

  int notifier_ = -1;  ///< inotify's descriptor; −1: none
  std::vector<int> watches_;
  std::vector<std::string> files_;
  std::vector<Signature> seen_;
};

}  // namespace sfumato::cli
