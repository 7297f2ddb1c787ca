#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace sfumato::cli {

/// Tells when files change, also where they are replaced by others of the same name or are not
/// there for a while. Folders are watched by inotify; where that is refused, and for file systems
/// of other machines, the files' times are looked at.
class FileWatch {
 public:
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// The files from now on, as they were at the last `look`.
  void set_files(std::vector<std::string> files);
  /// Notes what the files are now: later changes count.
  void look();
  /// Whether a file has changed since `look`. Waits for that as long as `most`; returns early where
  /// a signal comes.
  bool wait(std::chrono::milliseconds most);

 private:
  /// Device, inode, size, time of change: of what the name leads to, and of a link itself.
  using Signature = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::int64_t,
                               std::uint64_t, std::int64_t>;

  static Signature signature_of(const std::string& path);
  std::vector<Signature> signatures() const;
  void drain() const;

  int notifier_ = -1;  ///< of inotify; −1: none
  std::vector<int> watches_;
  std::vector<std::string> files_;
  std::vector<Signature> seen_;
};

}  // namespace sfumato::cli
