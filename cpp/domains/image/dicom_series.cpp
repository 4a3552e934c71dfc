#include "dicom_series.hpp"

#include <algorithm>
#include <fstream>
#include <map>

#include "dicom_header.hpp"
#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using Series = std::map<std::string, std::vector<fs::path>>;

std::vector<fs::path> regular_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
    if (std::error_code unknown; entry->is_regular_file(unknown) && is_dicom(entry->path()))
      files.push_back(entry->path());
  if (failure) refuse(folder, "cannot be listed");
  std::sort(files.begin(), files.end());
  return files;
}

Series all_series(const fs::path& folder) {
  Series series;
  for (const fs::path& file : regular_files(folder)) {
    const auto header = read_dicom_header(file);
    if (!header || !header->holds_voxels()) refuse_dicom(file);
    if (!header->series.empty() && header->rows > 0) series[header->series].push_back(file);
  }
  return series;
}

/// At most eight, for a sentence.
std::string list(const Series& series) {
  std::string text;
  std::size_t told = 0;
  for (const auto& [uid, files] : series) {
    if (told == 8) return text + " and " + std::to_string(series.size() - told) + " more";
    text += (told++ == 0 ? "" : ", ") + uid + " (" + std::to_string(files.size()) +
            (files.size() == 1 ? " file)" : " files)");
  }
  return text;
}

[[noreturn]] void leave_open(const fs::path& folder, const std::string& reason) {
  throw Error(ErrorCode::bad_option, "'" + folder.string() + "' " + reason);
}

}  // namespace

/// The letters DICM behind a preamble of 128 bytes.
bool is_dicom(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  char letters[5] = "";
  stream.seekg(128);
  stream.read(letters, 4);
  return stream && std::string(letters) == "DICM";
}

std::vector<fs::path> series_files(const fs::path& folder, const std::string& uid) {
  const Series series = all_series(folder);
  if (series.empty()) refuse(folder, "is a folder without a DICOM series");
  if (uid.empty() && series.size() > 1)
    leave_open(folder, "holds " + std::to_string(series.size()) +
                           " DICOM series; choose one with --series: " + list(series));
  const auto found = uid.empty() ? series.begin() : series.find(uid);
  if (found == series.end())
    leave_open(folder, "holds no DICOM series '" + uid + "' but " + list(series));
  return found->second;
}

}  // namespace certet
