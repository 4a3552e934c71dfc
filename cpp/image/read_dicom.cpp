// A folder of DICOM slices as one image.  Each slice is read by ITK's reader; that
// the slices make a regular grid is judged here, from their positions alone.

#include <itkGDCMImageIO.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dicom_series.hpp"
#include "geometry.hpp"
#include "image_file.hpp"
#include "itk_voxels.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using Reader = itk::GDCMImageIO;

/// Where a slice lies.
struct Slice {
  fs::path file;
  Point3 origin;
  double along = 0;  ///< of the origin, along the normal
  [[nodiscard]] std::string name() const {
    std::string text = "'";
    text += file.filename().string();
    return text + '\'';
  }
};

/// What all slices of a series share.
struct Form {
  std::array<std::int64_t, 2> size;
  std::array<double, 3> spacing;  ///< the last one is the slices' thickness
  std::array<Point3, 3> axes;     ///< directions of rows, columns and normal
  itk::IOComponentEnum type;
  std::uint64_t bytes;            ///< of one slice
};

Reader::Pointer open(const fs::path& file) {
  const auto reader = Reader::New();
  reader->SetFileName(file.string());
  reader->ReadImageInformation();
  return reader;
}

/// \throws Error for what is no single slice of one number per voxel.
Form form_of(const fs::path& file, const Reader& header) {
  if (header.GetNumberOfDimensions() > 2 && header.GetDimensions(2) > 1)
    refuse(file, "is DICOM with several frames in one file, which is not supported");
  if (header.GetNumberOfComponents() != 1)
    refuse(file, "has " + std::to_string(header.GetNumberOfComponents()) +
                     " numbers per voxel, not 1");
  Form form{};
  form.type = header.GetComponentType();
  form.bytes = header.GetComponentSize();
  for (unsigned a = 0; a < 2; ++a) {
    form.size[a] = static_cast<std::int64_t>(header.GetDimensions(a));
    form.bytes *= header.GetDimensions(a);
  }
  if (form.bytes == 0) refuse(file, "has no voxels");
  for (unsigned a = 0; a < 3; ++a) {
    form.spacing[a] = header.GetSpacing(a);
    const std::vector<double> direction = header.GetDirection(a);
    std::copy_n(direction.begin(), 3, form.axes[a].begin());
  }
  return form;
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

void judge_same(const Slice& slice, const Form& form, const Form& first) {
  if (form.size != first.size) refuse(slice.file, "has not the size of the series' other slices");
  if (form.type != first.type)
    refuse(slice.file, "has voxels of another type than the series' other slices");
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t r = 0; r < 3; ++r)
      if (!near(form.axes[a][r], first.axes[a][r], 1e-3))
        refuse(slice.file, "lies in another direction than the series' other slices");
  for (std::size_t a = 0; a < 2; ++a)
    if (!near(form.spacing[a], first.spacing[a], 1e-3 * first.spacing[a]))
      refuse(slice.file, "has other spacings than the series' other slices");
}

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::vector<Slice> read_slices(const std::vector<fs::path>& files, Form& form) {
  std::vector<Slice> slices;
  for (const fs::path& file : files) {
    const auto header = open(file);
    Slice slice{file, {header->GetOrigin(0), header->GetOrigin(1), header->GetOrigin(2)}};
    const Form own = form_of(file, *header);
    if (slices.empty()) form = own;
    judge_same(slice, own, form);
    slice.along = dot(slice.origin, form.axes[2]);
    if (!std::isfinite(slice.along)) refuse(file, "lies nowhere: its position is not finite");
    slices.push_back(std::move(slice));
  }
  std::sort(slices.begin(), slices.end(), [](const Slice& a, const Slice& b) {
    return a.along != b.along ? a.along < b.along : a.file < b.file;
  });
  return slices;
}

/// The distance of most neighbours.
double usual_gap(const std::vector<Slice>& slices) {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < slices.size(); ++k)
    gaps.push_back(slices[k].along - slices[k - 1].along);
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

/// Positions are rounded when they are written, so a tenth of a gap is let pass.
void judge_gaps(const fs::path& folder, const std::vector<Slice>& slices) {
  const double usual = usual_gap(slices);
  for (std::size_t k = 1; k < slices.size(); ++k) {
    const double gap = slices[k].along - slices[k - 1].along;
    const std::string where = slices[k - 1].name() + " and " + slices[k].name();
    if (!(gap > 1e-4 * usual) || !(gap > 0))
      refuse(folder, "has two slices at one position, " + where);
    if (near(gap, usual, 0.1 * usual)) continue;
    if (gap > 1.5 * usual)
      refuse(folder, "has a gap of " + std::to_string(gap) + " between " + where +
                         ", where slices are " + std::to_string(usual) +
                         " apart: slices are missing");
    refuse(folder, "has slices that are not equally spaced: " + std::to_string(gap) +
                       " between " + where + ", elsewhere " + std::to_string(usual));
  }
}

/// Slices that slide sideways, as those of a tilted gantry do.
void judge_stack(const fs::path& folder, const std::vector<Slice>& slices, const Form& form) {
  for (const Slice& slice : slices)
    for (std::size_t a = 0; a < 2; ++a) {
      const double aside =
          dot(slice.origin, form.axes[a]) - dot(slices.front().origin, form.axes[a]);
      if (!near(aside, 0, 0.1 * form.spacing[a]))
        refuse(folder, "has slices that do not lie straight above each other (a tilted "
                       "gantry): " + slice.name() + " is " + std::to_string(aside) + " aside");
    }
}

/// Positions are decimal numbers: what projecting them adds is not to be seen.
double rounded(double length) {
  const double unit = std::pow(10, std::floor(std::log10(length)) - 9);
  return std::round(length / unit) * unit;
}

Image grid(const fs::path& folder, const std::vector<Slice>& slices, const Form& form) {
  Image image;
  image.name = folder.string();
  image.size = {form.size[0], form.size[1], static_cast<std::int64_t>(slices.size())};
  image.spacing = form.spacing;
  if (slices.size() > 1) {
    judge_gaps(folder, slices);
    judge_stack(folder, slices, form);
    image.spacing[2] = rounded((slices.back().along - slices.front().along) /
                               static_cast<double>(slices.size() - 1));
  } else {
    image.notes.push_back("the series is a single slice, as thick as its header says");
  }
  image.origin = slices.front().origin;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t a = 0; a < 3; ++a) image.axes[r][a] = form.axes[a][r];
  judge_geometry(image);
  orthonormalise(image);
  return image;
}

void fill_slice(const Slice& slice, const Form& form, char* voxels) {
  const auto reader = open(slice.file);
  itk::ImageIORegion region(reader->GetNumberOfDimensions());
  for (unsigned d = 0; d < reader->GetNumberOfDimensions(); ++d)
    region.SetSize(d, reader->GetDimensions(d));
  reader->SetIORegion(region);
  // Its header is read again; the file may have changed meanwhile.
  if (form_of(slice.file, *reader).bytes != form.bytes) refuse(slice.file, "has changed");
  try {
    reader->Read(voxels);
  } catch (const itk::ExceptionObject&) {
    refuse(slice.file, "is truncated or damaged");
  }
}

}  // namespace

Image read_dicom(const fs::path& folder, std::uint64_t max_bytes, const std::string& series) {
  itk::Object::SetGlobalWarningDisplay(false);
  Form form{};
  const std::vector<Slice> slices = read_slices(series_files(folder, series), form);
  if (form.bytes > std::numeric_limits<std::int64_t>::max() / slices.size())
    refuse(folder, "has impossible dimensions");
  const std::uint64_t bytes = form.bytes * slices.size();
  judge_memory(folder, bytes, max_bytes);
  Image image = grid(folder, slices, form);
  image.voxels = load_voxels(folder, form.type, bytes, [&](void* voxels) {
    char* slice_voxels = static_cast<char*>(voxels);
    for (const Slice& slice : slices) {
      fill_slice(slice, form, slice_voxels);
      slice_voxels += form.bytes;
    }
  });
  return image;
}

}  // namespace certet
