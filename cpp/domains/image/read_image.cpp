// Which reader an input is for.

#include <itkMacro.h>
#include <itkObject.h>

#include <fstream>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "geometry.hpp"
#include "header_lines.hpp"
#include "image_file.hpp"
#include "meta_header.hpp"
#include "nifti_header.hpp"
#include "nrrd_header.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// Formats that are met, but that nothing here reads: by how a file begins, or ends
/// its name.
struct Foreign {
  std::string_view beginning, extension, name;
};
constexpr Foreign foreign[] = {
    {"#INRIMAGE-4#{", ".inr", "an INR image"},
    {"\x89HDF", ".mnc", "a MINC 2 image"},
    {"CDF", ".mnc", "a MINC 1 image"},
    {"", ".mgz", "a FreeSurfer volume (MGZ)"},
    {"", ".mgh", "a FreeSurfer volume (MGH)"},
    {"", ".brik", "an AFNI volume"},
    {"", ".head", "an AFNI volume's header"},
    {"", ".par", "a PAR/REC volume's header"},
    {"\x89PNG", "", "a PNG picture"},
    {"\xff\xd8\xff", "", "a JPEG picture"},
    {"<?xml", ".vti", "a VTK image"},
};

/// What it is called, where it is known and not read; else nothing.
std::string foreign_name(const fs::path& file) {
  std::string beginning(16, '\0');
  std::ifstream(file, std::ios::binary).read(beginning.data(), 16);
  const std::string extension = lower(file.extension().string());
  for (const Foreign& one : foreign) {
    const bool begins = beginning.compare(0, one.beginning.size(), one.beginning) == 0;
    if (begins && (one.extension.empty() || !one.beginning.empty() || extension == one.extension))
      if (one.extension != ".mnc" || extension == ".mnc") return std::string(one.name);
  }
  return "";
}

Image read_any(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  std::error_code failure;
  if (fs::is_directory(file, failure)) return read_dicom(file, max_bytes, choice);
  if (!fs::is_regular_file(file, failure)) refuse(file, "is not a regular file");
  if (is_dicom(file)) return read_dicom_file(file, max_bytes, choice);
  if (!choice.series.empty()) refuse(file, "is no folder, so that it holds no DICOM series");
  if (is_tiff(file)) return read_tiff(file, max_bytes, choice);
  if (is_nrrd(file)) return read_nrrd(file, max_bytes, choice);
  if (is_nifti(file)) return read_nifti(file, max_bytes, choice);
  if (const std::string name = foreign_name(file); !name.empty())
    refuse(file, "is " + name + ", which is not supported; convert it to NIfTI or NRRD");
  if (is_meta(file)) return read_meta(file, max_bytes, choice);
  refuse(file, "is not a NIfTI, NRRD, MetaImage, TIFF or DICOM file");
}

}  // namespace

bool can_read_images() { return true; }

Image read_image(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  std::error_code failure;
  if (!fs::exists(file, failure)) refuse(file, "does not exist");
  itk::Object::SetGlobalWarningDisplay(false);
  try {
    Image image = read_any(file, max_bytes, choice);
    if (choice.spacing) {
      image.spacing = *choice.spacing;
      check_geometry(image);
    }
    return image;
  } catch (const itk::ExceptionObject&) {
    // ITK's own text has many lines, source files and addresses.
    refuse(file, "is truncated or damaged");
  }
}

}  // namespace certet
