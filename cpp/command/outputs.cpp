#include "outputs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

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

void check_folder_of(const fs::path& file) {
  std::error_code failure;
  const fs::path folder = folder_of(file);
  if (!fs::is_directory(folder, failure)) refuse_output(file, "there is no such folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    refuse_output(file, "no permission to write in its folder");
}

/// \param files  all that it may hold, named as in a folder of its own
void check_output_folder(const fs::path& folder, const std::vector<fs::path>& files) {
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  check_folder_of(named);
  std::error_code failure;
  if (!fs::exists(named, failure)) return;
  if (!fs::is_directory(named, failure)) refuse_output(folder, "it is not a folder");
  for (const fs::directory_entry& entry : fs::directory_iterator(named, failure))
    if (std::ranges::find(files, entry.path().filename(), &fs::path::filename) == files.end())
      refuse_output(folder, "it is a folder that holds '" + entry.path().filename().string() +
                                "', which is no file of a polyMesh");
}

}  // namespace

void check_mesh_output(const fs::path& file, Format format) {
  const std::vector<fs::path> files = files_of(file, format);
  if (format == Format::polymesh) return check_output_folder(file, files);
  for (const fs::path& one : files) check_output(one);
}

void check_output(const fs::path& file) {
  if (file == "-")
    throw Error(ErrorCode::bad_option,
                "'-' is not a file: this output cannot go to the standard output");
  std::error_code failure;
  if (!fs::is_directory(folder_of(file), failure)) refuse_output(file, "there is no such folder");
  if (!file.has_filename() || fs::is_directory(file, failure))
    refuse_output(file, "it is a folder");
  if (fs::exists(file, failure) && !fs::is_regular_file(file, failure))
    refuse_output(file, "it is not a regular file");
  check_folder_of(file);
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
