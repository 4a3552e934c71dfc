#pragma once
/// \file
/// What ITK's readers tell of a file of three or more dimensions.

#include <itkImageIOBase.h>

#include <cstdint>
#include <filesystem>
#include <functional>

#include "certet/image.hpp"
#include "number_type.hpp"

namespace certet {

/// How the numbers of a file lie: the components of a voxel beside each other, the
/// first axis fastest, volumes one after the other.
struct GridForm {
  std::array<std::int64_t, 3> size{};
  std::uint64_t voxels = 0;  ///< of one volume
  std::uint64_t components = 1, volumes = 1;
  NumberType type{};

  [[nodiscard]] std::uint64_t numbers() const { return voxels * components * volumes; }
  [[nodiscard]] std::uint64_t bytes() const { return numbers() * bytes_of(type); }
};

/// \throws Error `bad_input` for fewer than three dimensions, no voxels, dimensions
/// beyond counting, and numbers that are none of `NumberType`.
GridForm form_of(const std::filesystem::path& file, const itk::ImageIOBase& header);

/// \throws Error `bad_input` where the component type is none of `NumberType`.
NumberType number_type(const std::filesystem::path& file, itk::IOComponentEnum type);

/// Size, spacing, origin and axes, checked.
void read_geometry(const itk::ImageIOBase& header, Image& image);

/// The number of the volume or of the component that is read, from 0.
/// \throws Error as `chosen_volume`.
std::uint64_t choose_volume(const std::filesystem::path& file, const GridForm& form,
                            const ImageChoice& choice);

/// Reads all numbers by `fill` and keeps those of the volume.
Voxels load_volume(const std::filesystem::path& file, const GridForm& form, std::uint64_t volume,
                   const std::function<void(char*)>& fill);

}  // namespace certet
