#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/native/posix.hpp"

namespace sfumato {

/// Whether a file survives a power failure from the moment of its renaming.
enum class Durability : std::uint8_t {
  synced,
  fast  ///< only after sync_file_system(): use it for many files that are only useful together
};

/// A file that appears under its name either complete or not at all. It is written in the same
/// folder as `.sfumato-NAME.N.tmp`, under a lock. The temporary file of a process that was killed
/// is no longer locked, and the next process that writes NAME removes it.
class AtomicFile {
 public:
  /// path: a regular file or no file; not a symbolic link. Touches no file yet.
  explicit AtomicFile(std::string path);
  /// Removes the temporary file unless `commit` has put it in place.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Opens the temporary file. mode: the mode of the file to be replaced; none: by the process's
  /// umask. Errors: io.
  Status open(std::optional<unsigned> mode);
  Status write(std::span<const std::uint8_t> bytes);
  /// Returns the descriptor, open for reading and writing. Use it to write in another order, or to
  /// read back.
  int number() const { return file_.number(); }
  /// Renames the file to its final name. With `synced`, the bytes are on the disk before, and the
  /// folder after it. Errors: io.
  Status commit(Durability durability = Durability::synced);
  /// Gives the file its final name, synced, only if that name is free. Returns false if it is not.
  /// Errors: io.
  Result<bool> commit_new();

 private:
  Status finish(Durability durability);
  std::string slot_path(int slot) const;
  Status open_slot(int slot, std::optional<unsigned> mode);

  std::string path_;
  std::string folder_;
  std::string name_;
  std::string temporary_path_;
  FileDescriptor file_;
};

/// Writes a whole regular file, or leaves the existing file unchanged. Errors: io.
Status replace_file(const std::string& path, std::span<const std::uint8_t> bytes,
                    Durability durability);

/// Writes a whole file if the name is free; returns false if it is not. A symbolic link counts as a
/// file. Errors: io.
Result<bool> create_file(const std::string& path, std::span<const std::uint8_t> bytes);

/// Returns the mode of the file to be replaced; none: there is no file. Errors: io (not a regular
/// file, or not writable).
Result<std::optional<unsigned>> mode_of_replaced(const std::string& path);

/// Waits until all bytes written to the file system of `folder` are on the disk. Errors: io.
Status sync_file_system(const std::string& folder);

}  // namespace sfumato
