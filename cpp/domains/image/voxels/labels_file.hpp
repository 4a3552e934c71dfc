#pragma once
/// \file
/// The formats that label images go out in.

#include <filesystem>

namespace certet {

enum class LabelsFile { nrrd, meta, nifti, nifti_packed };

/// By the extension.  \throws Error `bad_option`.
LabelsFile labels_file_kind(const std::filesystem::path& file);

}  // namespace certet
