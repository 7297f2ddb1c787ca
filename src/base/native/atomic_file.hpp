#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/native/posix.hpp"

namespace sfumato {

/// A file that appears under its name whole or not at all. It is written beside its place, as
/// `.sfumato-NAME.N.tmp`, under a lock; the file of a process that was killed is not locked any
/// more and is removed by the next one that writes NAME.
class AtomicFile {
 public:
  /// path: a regular file or nothing; no symbolic link. Nothing happens yet.
  explicit AtomicFile(std::string path);
  /// Removes what `commit` did not put in place.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// mode: of the file that is replaced; none: as the process's umask says. Errors: io.
  Status open(std::optional<unsigned> mode);
  Status write(std::span<const std::uint8_t> bytes);
  /// Syncs the bytes, gives them their name, syncs the folder.
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
