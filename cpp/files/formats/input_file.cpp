#include "input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "certet/error.hpp"
#include "uninterrupted.hpp"

namespace certet::formats {

InputFile::InputFile(const std::filesystem::path& file, const Context* context)
    : file_(file), context_(context) {
  // Looked at before it is opened: to open a pipe would wait for its writer.
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) fail_with(errno);
  if (S_ISDIR(status.st_mode)) fail("it is a folder");
  if (!S_ISREG(status.st_mode)) fail("it is not a regular file");
  descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail_with(errno);
  size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void InputFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  constexpr std::size_t at_once = std::size_t{1} << 26;
  while (!bytes.empty()) {
    if (context_ != nullptr) stop_if_cancelled(*context_);
    const ssize_t got = uninterrupted([&] {
      return ::pread(descriptor_, bytes.data(), std::min(bytes.size(), at_once),
                     static_cast<off_t>(offset));
    });
    if (got < 0) fail_with(errno);
    if (got == 0) fail("it ends too early");
    offset += static_cast<std::uint64_t>(got);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

void InputFile::fail(const std::string& reason) const {
  // One line, whatever words of a damaged file are quoted.
  std::string sentence = "cannot read '" + file_.string() + "': " + reason;
  std::ranges::replace_if(sentence, [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  throw Error(ErrorCode::bad_input, sentence);
}

void InputFile::fail_with(int error) const { fail(std::generic_category().message(error)); }

}  // namespace certet::formats
