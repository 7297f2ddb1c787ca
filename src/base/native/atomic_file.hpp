#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/native/posix.hpp"

namespace sfumato {

/// Whether a file outlives a power failure from the moment that it has its name.
enum class Durability : std::uint8_t {
  synced,
  fast  ///< not before sync_file_system(): of many files that are of use together only
};

/// A file that appears under its name whole or not at all. It is written in the same folder as
/// `.sfumato-NAME.N.tmp`, under a lock. The temporary file of a process that was killed is no
/// longer locked, and the next process that writes NAME removes it.
class AtomicFile {
 public:
  /// path: a regular file or nothing; not a symbolic link. Touches no file yet.
  explicit AtomicFile(std::string path);
  /// Removes the temporary file unless `commit` has put it in place.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// mode: that of the file to be replaced; none: by the process's umask. Errors: io.
  Status open(std::optional<unsigned> mode);
  Status write(std::span<const std::uint8_t> bytes);
  /// For who writes in another order, and reads back; open for both.
  int number() const { return file_.number(); }
  /// Renames the file to its final name; where synced, the bytes are on the disk before, and the
  /// folder after it. Errors: io.
  Status commit(Durability durability = Durability::synced);

 private:
  std::string slot_path(int slot) const;
  Status open_slot(int slot, std::optional<unsigned> mode);

  std::string path_;
  std::string folder_;
  std::string name_;
  std::string temporary_path_;
  FileDescriptor file_;
};

/// Writes a regular file whole, or leaves what has its name as it was. Errors: io.
Status replace_file(const std::string& path, std::span<const std::uint8_t> bytes,
                    Durability durability);

/// The mode of the file that is to be replaced; none: there is no file. Errors: io (no regular
/// file, or one that may not be written).
Result<std::optional<unsigned>> mode_of_replaced(const std::string& path);

/// Waits until what was written to the file system of `folder` is on the disk. Errors: io.
Status sync_file_system(const std::string& folder);

}  // namespace sfumato
