// In which coordinates a file speaks of a patient.

#include <fstream>
#include <string>

#include "certet/patient_axes.hpp"
#include "header_lines.hpp"
#include "image_file.hpp"
#include "meta_header.hpp"
#include "nifti_header.hpp"
#include "nrrd_header.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// A time may be behind the axes.
std::optional<PatientAxes> axes_named(std::string_view space) {
  for (const std::string_view lps : {"left-posterior-superior", "lps"})
    if (space.starts_with(lps)) return PatientAxes::lps;
  for (const std::string_view ras : {"right-anterior-superior", "ras"})
    if (space.starts_with(ras)) return PatientAxes::ras;
  return std::nullopt;
}

std::optional<PatientAxes> axes_of_nrrd(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  while (std::getline(stream, line) && !line.empty() && line != "\r")
    if (const HeaderLine field = split_line(line, ":"); lower(field.key) == "space")
      return axes_named(lower(field.value));
  return std::nullopt;
}

}  // namespace

std::optional<PatientAxes> axes_of_file(const fs::path& image) {
  std::error_code failure;
  if (fs::is_directory(image, failure) || is_dicom(image)) return PatientAxes::lps;
  if (is_tiff(image)) return std::nullopt;
  if (is_nrrd(image)) return axes_of_nrrd(image);
  if (is_nifti(image)) return PatientAxes::ras;
  if (is_meta(image)) return PatientAxes::lps;
  return std::nullopt;
}

}  // namespace certet
