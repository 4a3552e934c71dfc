#include "output_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "certet/error.hpp"
#include "output_file.hpp"

namespace certet::formats {
namespace {

namespace fs = std::filesystem;

/// The target without a slash behind it.
fs::path without_slash(const fs::path& target) {
  return target.has_filename() ? target : target.parent_path();
}

/// What the disk has to know of a folder's names.
void store_names(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  static_cast<void>(::fsync(descriptor));
  ::close(descriptor);
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& target, std::span<const std::string_view> names,
                           std::string_view kind)
    : asked_for_(target), target_(without_slash(target)) {
  if (!target_.has_filename()) fail("it has no name");
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(target_, error))) {
    target_ = fs::canonical(target_, error);
    if (error) fail(error.message());
  }
  check(names, kind);
  constexpr int attempts = 16;
  for (int i = 0; i < attempts; ++i) {
    const fs::path hidden = target_.parent_path() / hidden_name();
    if (fs::create_directory(hidden, error)) {
      temporary_ = hidden;
      return;
    }
    if (error) fail(error.message());
  }
  fail("no name was free for a temporary folder");
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void OutputFolder::check(std::span<const std::string_view> names, std::string_view kind) const {
  std::error_code error;
  const fs::file_status status = fs::status(target_, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) fail("it is not a folder");
  error.clear();
  for (fs::directory_iterator entry(target_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (std::ranges::find(names, name) == names.end() || !entry->is_regular_file(error))
      fail("it is a folder that holds '" + name + "', which is no file of a " + std::string(kind));
  }
  if (error) fail(error.message());
}

/// A folder cannot be renamed to one that is there and not empty: the old one steps aside, and
/// comes back where the new one cannot take its place.
void OutputFolder::publish() {
  store_names(temporary_);
  std::error_code error, ignored;
  const fs::path aside = target_.parent_path() / hidden_name();
  const bool replaces = fs::exists(target_, ignored);
  if (replaces) fs::rename(target_, aside, error);
  if (error) fail(error.message());
  fs::rename(temporary_, target_, error);
  if (error) {
    if (replaces) fs::rename(aside, target_, ignored);
    fail(error.message());
  }
  temporary_.clear();
  if (replaces) fs::remove_all(aside, ignored);
  store_names(target_.parent_path().empty() ? fs::path(".") : target_.parent_path());
}

void OutputFolder::fail(const std::string& reason) const {
  throw Error(ErrorCode::write_failed, "cannot write '" + asked_for_.string() + "': " + reason);
}

}  // namespace certet::formats
