// NRRD by ITK's reader, which is Teem's: it misses no byte that a header announces.

#include <itkNrrdImageIO.h>

#include <algorithm>
#include <future>

#include "image_file.hpp"
#include "itk_header.hpp"
#include "nrrd_header.hpp"
#include "nrrd_segments.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

void read_all(itk::NrrdImageIO& reader, void* to) {
  itk::ImageIORegion region(reader.GetNumberOfDimensions());
  for (unsigned d = 0; d < reader.GetNumberOfDimensions(); ++d)
    region.SetSize(d, reader.GetDimensions(d));
  reader.SetIORegion(region);
  reader.Read(to);
}

}  // namespace

Image read_nrrd(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  NrrdHeader header = read_nrrd_header(file);
  const auto reader = itk::NrrdImageIO::New();
  reader->SetFileName(file.string());
  reader->ReadImageInformation();
  const GridForm form = form_of(file, *reader);
  std::vector<Segment> segments = segments_of(header);
  const bool layered = !segments.empty() && form.components > 1 && form.volumes == 1 && !choice.volume;
  const std::uint64_t volume = layered ? 0 : choose_volume(file, form, choice);
  if (header.part) {
    header.part->bytes = form.bytes();
    check_length(*header.part);
  } else if (!header.detached && form.bytes() / 1040 > fs::file_size(file)) {
    refuse(file, "is too short for the dimensions in its header");
  }
  const bool one = form.components * form.volumes == 1;
  check_memory(file, form.bytes() + (one ? 0 : form.voxels * 4), max_bytes);
  Image image;
  image.name = file.string();
  read_geometry(*reader, image);
  // Teem does not look at checksums.  At the same time, for unpacking is what takes long.
  auto checked = std::async(std::launch::async, [&header] {
    if (header.part) check_part(*header.part);
  });
  const auto fill = [&](char* to) { read_all(*reader, to); };
  if (layered) {
    merge_layers(image, load_voxels(file, form.type, form.numbers(), fill), form.components,
                 std::move(segments));
  } else {
    image.voxels = load_volume(file, form, volume, fill);
    for (const Segment& segment : segments)
      if (segment.layer == volume && std::in_range<std::int32_t>(segment.value))
        image.names[static_cast<std::int32_t>(segment.value)] = segment.name;
  }
  checked.get();
  return image;
}

}  // namespace certet
