#pragma once
/// \file
/// A folder of files that is there whole or not at all.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace certet::formats {

/// Grows under a hidden name beside the target and takes its place in `publish`; destroyed before
/// that, it leaves nothing.  A target that is there already is replaced if it holds nothing but
/// files of the same names, and else refused.
/// All members throw Error `write_failed` with a sentence that names the target.
class OutputFolder {
 public:
  /// `names` are those of the files that such a folder may hold, `kind` what it is called.
  OutputFolder(const std::filesystem::path& target, std::span<const std::string_view> names,
               std::string_view kind);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where the folder grows.
  [[nodiscard]] const std::filesystem::path& growing() const { return temporary_; }
  /// As the caller named it.
  [[nodiscard]] const std::filesystem::path& asked_for() const { return asked_for_; }

  /// All files are in it, and on the disk.
  void publish();

 private:
  void check(std::span<const std::string_view> names, std::string_view kind) const;
  [[noreturn]] void fail(const std::string& reason) const;

  std::filesystem::path asked_for_, target_, temporary_;
};

}  // namespace certet::formats
