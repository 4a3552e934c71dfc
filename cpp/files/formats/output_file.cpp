#include "output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <random>
#include <system_error>

#include "certet/error.hpp"
#include "uninterrupted.hpp"

namespace certet::formats {
namespace {

namespace fs = std::filesystem;

/// Opens a file that was not there; -1 and errno if that fails.
int create_new(const fs::path& file) {
  return uninterrupted(
      [&] { return ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
}

}  // namespace

std::string hidden_name() {
  std::random_device random;
  const std::uint64_t number = std::uint64_t{random()} << 32 | random();
  std::array<char, 16> digits;
  const auto end = std::to_chars(digits.begin(), digits.end(), number, 16).ptr;
  return ".certet-" + std::string(digits.begin(), end) + ".tmp";
}

OutputFile::OutputFile(const fs::path& target, const fs::path& asked_for)
    : asked_for_(asked_for), target_(target) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) fail("it is a folder");
  if (fs::exists(status)) {
    if (!fs::is_regular_file(status)) fail("it is not a regular file");
    if (::access(target.c_str(), W_OK) != 0) fail_with(errno);
    const fs::path real = fs::canonical(target, error);
    if (error) fail(error.message());
    target_ = real;
  }
  if (!target_.has_filename()) fail("it has no file name");
  create();
}

void OutputFile::create() {
  constexpr int attempts = 16;
  for (int i = 0; i < attempts && descriptor_ < 0; ++i) {
    temporary_ = target_.parent_path() / hidden_name();
    descriptor_ = create_new(temporary_);
    if (descriptor_ < 0 && errno != EEXIST) fail_with(errno);
  }
  if (descriptor_ < 0) fail("no name was free for a temporary file");
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::reserve([[maybe_unused]] std::uint64_t bytes) {
#ifdef __linux__
  if (bytes == 0) return;
  if (::fallocate(descriptor_, 0, 0, static_cast<off_t>(bytes)) == 0) return;
  // Other errors tell that the file system cannot do it, which is no harm.
  if (errno == ENOSPC || errno == EFBIG || errno == EDQUOT) fail_with(errno);
#endif
}

void OutputFile::start_write_back([[maybe_unused]] std::uint64_t offset,
                                  [[maybe_unused]] std::size_t bytes) const {
#ifdef __linux__
  // A hint: whether the bytes arrive is asked in `commit`.
  constexpr std::size_t worth_it = std::size_t{1} << 20;
  if (bytes >= worth_it)
    ::sync_file_range(descriptor_, static_cast<off_t>(offset), static_cast<off_t>(bytes),
                      SYNC_FILE_RANGE_WRITE);
#endif
}

void OutputFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  // Linux writes at most 2 GiB at once.
  constexpr std::size_t at_once = std::size_t{1} << 30;
  while (!bytes.empty()) {
    const ssize_t written = uninterrupted([&] {
      return ::pwrite(descriptor_, bytes.data(), std::min(bytes.size(), at_once),
                      static_cast<off_t>(offset));
    });
    if (written < 0) fail_with(errno);
    if (written == 0) fail("the disk takes no more");
    start_write_back(offset, static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void OutputFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = uninterrupted([&] {
      return ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    });
    if (got < 0) fail_with(errno);
    if (got == 0) fail("what was written is gone");
    offset += static_cast<std::uint64_t>(got);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

void OutputFile::commit() {
  store();
  publish();
}

void OutputFile::store() {
  if (::fsync(descriptor_) != 0) fail_with(errno);
  const int descriptor = descriptor_;
  descriptor_ = -1;  // closed even if closing reports an error
  if (::close(descriptor) != 0) fail_with(errno);
}

void OutputFile::publish() {
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(error.message());
  temporary_.clear();
  published_ = true;
}

void OutputFile::retract() {
  if (published_) ::unlink(target_.c_str());
  published_ = false;
}

void commit_together(std::span<OutputFile* const> files) {
  for (OutputFile* file : files) file->store();
  try {
    for (OutputFile* file : files) file->publish();
  } catch (...) {
    for (OutputFile* file : files) file->retract();
    throw;
  }
}

void OutputFile::fail(const std::string& reason) const {
  throw Error(ErrorCode::write_failed, "cannot write '" + asked_for_.string() + "': " + reason);
}

void OutputFile::fail_with(int error) const {
  fail(std::generic_category().message(error));
}

}  // namespace certet::formats
