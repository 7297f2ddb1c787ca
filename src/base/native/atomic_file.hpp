#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/native/posix.hpp"

namespace sfumato {

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
  /// Syncs the bytes, renames the file to its final name, syncs the folder. Errors: io.
  Status commit();

 private:
  std::string slot_path(int slot) const;
  Status open_slot(int slot, std::optional<unsigned> mode);

  std::string path_;
  std::string folder_;
  std::string name_;
  std::string temporary_path_;
  FileDescriptor file_;
};

}  // namespace sfumato
