#pragma once
/// \file
/// Which way the axes of the world go in a patient.

#include <filesystem>
#include <optional>
#include <string_view>

#include "certet/frame.hpp"

namespace certet {

/// x, y and z to the left, the back and the head, or to the right, the front and the head.
enum class PatientAxes { lps, ras };

/// lps, ras; and in capitals, as MeshSize::space has it.
std::string_view name(PatientAxes axes);
std::string_view space(PatientAxes axes);

/// What the coordinates in an image's file are in, where it tells: RAS in NIfTI, what `space` says
/// in NRRD, LPS in MetaImage and DICOM; nothing of TIFF, or of other axes than these two.
/// `read_image` makes LPS of both.
std::optional<PatientAxes> axes_of_file(const std::filesystem::path& image);

/// The same points, where both their x and their y change their signs: from one to the other.
Frame turned_over(const Frame& frame);

}  // namespace certet
