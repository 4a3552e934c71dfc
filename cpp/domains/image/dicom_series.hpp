#pragma once
/// \file
/// Which DICOM series a folder holds.

#include <filesystem>
#include <string>
#include <vector>

namespace certet {

/// The files of the series with this UID or, where `uid` is empty, of the only one.
/// Files that are not DICOM, or belong to no series, are passed over.
/// \throws Error `bad_input` for a folder without a series; `bad_option` where the
/// choice is open, naming the UIDs there are.
std::vector<std::filesystem::path> series_files(const std::filesystem::path& folder,
                                                const std::string& uid);

}  // namespace certet
