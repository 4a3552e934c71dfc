#include "outputs.hpp"

#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "certet/error.hpp"

namespace certet::command {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_output(const fs::path& file, const std::string& reason) {
  throw Error(ErrorCode::write_failed, "'" + file.string() + "' cannot be written: " + reason);
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

}  // namespace

void check_output(const fs::path& file) {
  if (file == "-")
    throw Error(ErrorCode::bad_option,
                "'-' is not a file: this output cannot go to the standard output");
  std::error_code failure;
  const fs::path folder = folder_of(file);
  if (!fs::is_directory(folder, failure)) refuse_output(file, "there is no such folder");
  if (!file.has_filename() || fs::is_directory(file, failure))
    refuse_output(file, "it is a folder");
  if (fs::exists(file, failure) && !fs::is_regular_file(file, failure))
    refuse_output(file, "it is not a regular file");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    refuse_output(file, "no permission to write in its folder");
}

void check_room(const fs::path& file, std::uint64_t bytes) {
  std::error_code failure;
  const fs::space_info space = fs::space(folder_of(file), failure);
  if (!failure && space.available < bytes)
    refuse_output(file, "it needs " + std::to_string(bytes) + " bytes, but the disk has only " +
                     std::to_string(space.available) + " left");
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code failure;
  if (fs::equivalent(a, b, failure)) return true;
  const fs::path one = fs::weakly_canonical(a, failure);
  return !failure && one == fs::weakly_canonical(b, failure) && !failure;
}

void write_text(const std::string& target, const std::string& text) {
  if (target == "-") {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() ||
        std::fflush(stdout) != 0)
      throw Error(ErrorCode::write_failed, "the standard output cannot be written");
    return;
  }
  const fs::path temporary = target + ".part" + std::to_string(getpid());
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  std::error_code failure;
  if (file) fs::rename(temporary, target, failure);
  if (file && !failure) return;
  fs::remove(temporary, failure);
  refuse_output(target, "the disk may be full");
}

}  // namespace certet::command
