#include "dicom_frames.hpp"

#include <cmath>

#include "dicom_elements.hpp"
#include "geometry.hpp"
#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

// Elements, and the sequences of functional groups that hold them.
constexpr DicomTag shared_groups = 0x52009229, groups_of_frames = 0x52009230;
constexpr DicomTag plane_position = 0x00209113, position = 0x00200032;
constexpr DicomTag plane_orientation = 0x00209116, orientation = 0x00200037;
constexpr DicomTag pixel_measures = 0x00289110, pixel_spacing = 0x00280030,
                   slice_distance_tag = 0x00180088, slice_thickness = 0x00180050;
constexpr DicomTag transformation = 0x00289145, slope_tag = 0x00281053,
                   intercept_tag = 0x00281052;
constexpr DicomTag segment_of_frame = 0x0062000a, segment_referred = 0x0062000b;
constexpr DicomTag segment_sequence = 0x00620002, segment_number = 0x00620004,
                   segment_label = 0x00620005, segmentation_type = 0x00620001,
                   greatest_fraction = 0x0062000e;
constexpr DicomTag rows = 0x00280010, columns = 0x00280011, samples = 0x00280002;
constexpr DicomTag frame_offsets = 0x3004000c, dose_scale = 0x3004000e;
constexpr DicomTag columns_of_slide = 0x00480006;
constexpr DicomTag increment = 0x00280009, frame_time = 0x00181063, frame_times = 0x00181065,
                   slice_vector = 0x00540080;

/// The groups of one frame, and the others it may take an element from.
struct Groups {
  const gdcm::DataSet* own = nullptr;
  const gdcm::DataSet* shared = nullptr;
  const gdcm::DataSet* file = nullptr;

  /// Numbers in a sequence of one item, in the order frame, shared, whole file.
  [[nodiscard]] std::vector<double> numbers(DicomTag sequence, DicomTag tag) const {
    for (const gdcm::DataSet* data : {own, shared}) {
      if (data == nullptr) continue;
      const auto items = dicom_items(*data, sequence);
      if (items.empty()) continue;
      if (auto found = dicom_numbers(items[0], tag); !found.empty()) return found;
    }
    return dicom_numbers(*file, tag);
  }
  [[nodiscard]] double number(DicomTag sequence, DicomTag tag, double otherwise) const {
    const auto found = numbers(sequence, tag);
    return found.empty() ? otherwise : found[0];
  }
};

Point3 unit(const Point3& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

std::array<Point3, 3> axes_of(const fs::path& file, const Groups& groups) {
  auto six = groups.numbers(plane_orientation, orientation);
  if (six.empty()) six = {1, 0, 0, 0, 1, 0};
  if (six.size() != 6) refuse(file, "has frames whose direction is not six numbers");
  const Point3 x = unit({six[0], six[1], six[2]}), y = unit({six[3], six[4], six[5]});
  return {x, y, unit({x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                      x[0] * y[1] - x[1] * y[0]})};
}

SliceForm form_of(const fs::path& file, const Groups& groups) {
  SliceForm form;
  form.size = {dicom_short(*groups.file, columns).value_or(0),
               dicom_short(*groups.file, rows).value_or(0)};
  if (form.size[0] == 0 || form.size[1] == 0) refuse(file, "has no voxels");
  const auto spacing = groups.numbers(pixel_measures, pixel_spacing);
  if (spacing.size() != 2) refuse(file, "has frames that tell no size of their pixels");
  form.spacing = {spacing[1], spacing[0]};  // DICOM has that of rows first
  form.axes = axes_of(file, groups);
  return form;
}

void check_same(const fs::path& file, const SliceForm& one, const SliceForm& first) {
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t r = 0; r < 3; ++r)
      if (!is_near(one.axes[a][r], first.axes[a][r], 1e-3))
        refuse(file, "has frames that lie in several directions");
  for (std::size_t a = 0; a < 2; ++a)
    if (!is_near(one.spacing[a], first.spacing[a], 1e-3 * first.spacing[a]))
      refuse(file, "has frames with several sizes of pixels");
}

DicomFrame frame_of(const Groups& groups) {
  DicomFrame frame;
  const auto place = groups.own == nullptr ? std::vector<double>{}
                                           : groups.numbers(plane_position, position);
  if (place.size() == 3) frame.position = Point3{place[0], place[1], place[2]};
  frame.slope = groups.number(transformation, slope_tag, 1);
  frame.intercept = groups.number(transformation, intercept_tag, 0);
  for (const gdcm::DataSet* data : {groups.own, groups.shared}) {
    if (data == nullptr || frame.segment != 0) continue;
    const auto items = dicom_items(*data, segment_of_frame);
    if (!items.empty()) frame.segment = dicom_short(items[0], segment_referred).value_or(0);
  }
  return frame;
}

/// Of files without groups: along the normal from the file's own position.
void place_along_normal(const fs::path& file, const gdcm::DataSet& data, DicomFrames& result) {
  const auto origin = dicom_numbers(data, position);
  const auto offsets = dicom_numbers(data, frame_offsets);
  const double step = result.distance > 0 ? result.distance : result.thickness;
  if (!offsets.empty() && offsets.size() != result.frames.size())
    refuse(file, "has frames whose offsets are not as many as they are");
  if (offsets.empty() && step <= 0 && result.frames.size() > 1)
    refuse(file, "has frames that do not tell how far apart they are");
  if (origin.size() != 3)
    result.notes.push_back("the file says nothing of the place of its frames; the first is at the "
                           "origin");
  if (offsets.empty() && result.distance == 0 && result.frames.size() > 1)
    result.notes.push_back("the file says nothing of the distance of its frames, which was taken "
                           "to be the slices' thickness");
  for (std::size_t f = 0; f < result.frames.size(); ++f) {
    Point3 place{};
    const double along =
        offsets.empty() ? step * static_cast<double>(f) : offsets[f] - offsets[0];
    for (std::size_t r = 0; r < 3; ++r)
      place[r] = (origin.size() == 3 ? origin[r] : 0) + along * result.form.axes[2][r];
    result.frames[f].position = place;
  }
}

/// The increment names an element by which frames differ.
void check_not_times(const fs::path& file, const gdcm::DataSet& data) {
  const auto group = dicom_text(data, increment);
  if (group.size() < 4) return;
  const auto byte = [&](std::size_t i) {
    return static_cast<DicomTag>(static_cast<unsigned char>(group[i]));
  };
  const DicomTag tag = (byte(0) | byte(1) << 8) << 16 | (byte(2) | byte(3) << 8);
  if (tag == frame_time || tag == frame_times)
    refuse(file, "has frames that are times of one picture, not slices of a volume");
  if (tag >> 16 == 0x0054 && tag != slice_vector)
    refuse(file, "has frames that are energies, detectors or times, not slices of a volume alone");
}

void read_segments(const gdcm::DataSet& data, DicomFrames& result) {
  const std::string type = dicom_text(data, segmentation_type);
  if (type.empty()) return;
  result.kind = type == "FRACTIONAL"  ? DicomFrames::Kind::fractional
                : type == "LABELMAP" ? DicomFrames::Kind::labels
                                     : DicomFrames::Kind::binary;
  result.greatest_fraction = dicom_short(data, greatest_fraction).value_or(255);
  for (const gdcm::DataSet& item : dicom_items(data, segment_sequence)) {
    const std::uint32_t number = dicom_short(item, segment_number).value_or(0);
    if (number == 0) continue;  // the background of a label map
    result.segments.push_back({0, number, static_cast<std::int32_t>(number),
                               dicom_text(item, segment_label)});
  }
}

}  // namespace

DicomFrames read_dicom_frame_headers(const fs::path& file, const gdcm::DataSet& data,
                                     std::uint64_t frames) {
  if (const auto count = dicom_short(data, samples).value_or(1); count != 1)
    refuse(file, "has " + std::to_string(count) + " numbers per voxel, not 1");
  check_not_times(file, data);
  if (!dicom_text(data, columns_of_slide).empty())
    refuse(file, "has frames that are tiles of a slide, not slices of a volume");
  const auto shared = dicom_items(data, shared_groups);
  const auto own = dicom_items(data, groups_of_frames);
  if (!own.empty() && own.size() != frames)
    refuse(file, "describes " + std::to_string(own.size()) + " frames, but has " +
                     std::to_string(frames));
  DicomFrames result;
  for (std::size_t f = 0; f < frames; ++f) {
    const Groups groups{own.empty() ? nullptr : &own[f], shared.empty() ? nullptr : &shared[0],
                        &data};
    const bool first = f == 0;
    if (first || !own.empty()) {
      const SliceForm form = form_of(file, groups);
      if (first) result.form = form;
      check_same(file, form, result.form);
    }
    if (first) {
      result.distance = std::fabs(groups.number(pixel_measures, slice_distance_tag, 0));
      result.thickness = std::fabs(groups.number(pixel_measures, slice_thickness, 0));
    }
    result.frames.push_back(frame_of(groups));
  }
  if (own.empty()) place_along_normal(file, data, result);
  if (const auto scale = dicom_numbers(data, dose_scale); !scale.empty())
    for (DicomFrame& frame : result.frames) frame.slope = scale[0];
  for (const DicomFrame& frame : result.frames)
    if (!frame.position) refuse(file, "has frames without a position in the patient");
  read_segments(data, result);
  return result;
}

}  // namespace certet
