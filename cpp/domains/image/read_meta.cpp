// MetaImage: what the header says is ITK's to read; the voxels are read here to the
// last byte, for ITK's reader takes what is missing from wherever its memory was.

#include <itkMetaImageIO.h>

#include "image_file.hpp"
#include "itk_header.hpp"
#include "meta_header.hpp"
#include "meta_voxels.hpp"

namespace certet {

Image read_meta(const std::filesystem::path& file, std::uint64_t max_bytes,
                const ImageChoice& choice) {
  const MetaHeader header = read_meta_header(file);
  const auto reader = itk::MetaImageIO::New();
  reader->SetFileName(file.string());
  reader->ReadImageInformation();
  const GridForm form = form_of(file, *reader);
  const std::uint64_t volume = choose_volume(file, form, choice);
  std::vector<std::uint64_t> size;
  for (unsigned d = 0; d < reader->GetNumberOfDimensions(); ++d)
    size.push_back(reader->GetDimensions(d));
  const MetaVoxels voxels = meta_voxels(file, header, form.bytes(), size);
  for (const StoredPart& part : voxels.parts)
    if (!voxels.text) check_length(part);
  const bool one = form.components * form.volumes == 1;
  check_memory(file, form.bytes() + (one ? 0 : form.voxels * bytes_of(form.type)), max_bytes);
  Image image;
  image.name = file.string();
  read_geometry(*reader, image);
  image.voxels = load_volume(file, form, volume, [&](char* to) {
    read_meta_voxels(file, voxels, form.type, form.numbers(), to);
  });
  return image;
}

}  // namespace certet
