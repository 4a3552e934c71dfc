#pragma once
/// \file
/// A file that is there whole or not at all.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "certet/shared_file.hpp"

namespace certet::formats {

/// Grows under a hidden name in the target's folder and takes the target's name
/// in `commit`; destroyed before that, it leaves nothing.  A symbolic link as
/// target is followed, not replaced.
/// All members throw Error `write_failed` with a sentence that names the target.
class OutputFile final : public WritableFile {
 public:
  /// Refuses a target that is a folder, a device or read-only.
  explicit OutputFile(const std::filesystem::path& target) : OutputFile(target, target) {}
  /// Sentences name `asked_for` in its place.
  OutputFile(const std::filesystem::path& target, const std::filesystem::path& asked_for);
  ~OutputFile() override;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Sets the room for so many bytes aside, where the file system can: a disk
  /// too small is noticed before the work is done.
  void reserve(std::uint64_t bytes);

  void write_at(std::uint64_t offset, std::span<const std::byte> bytes) override;
  /// Reads what was written.
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const;

  /// Everything reaches the disk, then the file appears under its name.
  void commit();

  /// Where it grows, for libraries that write files themselves.
  [[nodiscard]] const std::filesystem::path& growing() const { return temporary_; }

  /// The two halves of `commit`, for files that belong together.
  void store();
  void publish();
  /// Takes a file that was published away again.
  void retract();

  [[noreturn]] void fail(const std::string& reason) const override;

 private:
  void create();
  /// Lets the disk begin, so that `commit` need not wait for all of the file.
  void start_write_back(std::uint64_t offset, std::size_t bytes) const;
  [[noreturn]] void fail_with(int error) const;

  std::filesystem::path asked_for_;  ///< as the caller named it
  std::filesystem::path target_, temporary_;
  bool published_ = false;
  int descriptor_ = -1;
};

/// A name for what is not whole yet: too short for any limit on names, and so random that no other
/// run has it.
std::string hidden_name();

/// All of them are whole on the disk before the first one takes its name, and where one cannot,
/// none does.
void commit_together(std::span<OutputFile* const> files);

}  // namespace certet::formats
