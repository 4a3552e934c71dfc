#pragma once
/// \file
/// What each format has to offer to the table in formats.cpp.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "certet/formats.hpp"

namespace certet::formats {

/// The survey of a mesh, or one of nothing where it has none.
inline const Survey& survey_of(const MeshSize& size) {
  static const Survey nothing;
  return size.survey == nullptr ? nothing : *size.survey;
}

std::unique_ptr<MeshWriter> open_vtu(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t vtu_bytes(const MeshSize& size);
FileMesh read_vtu(const std::filesystem::path& file, const Context& context);

std::unique_ptr<MeshWriter> open_vtu_zlib(const std::filesystem::path& file,
                                          const MeshSize& size);
std::uint64_t vtu_zlib_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_medit(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t medit_bytes(const MeshSize& size);
FileMesh read_medit(const std::filesystem::path& file, const Context& context);

std::unique_ptr<MeshWriter> open_medit_binary(const std::filesystem::path& file,
                                              const MeshSize& size);
std::uint64_t medit_binary_bytes(const MeshSize& size);
FileMesh read_medit_binary(const std::filesystem::path& file, const Context& context);

std::unique_ptr<MeshWriter> open_gmsh(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t gmsh_bytes(const MeshSize& size);
/// Both versions.
FileMesh read_gmsh(const std::filesystem::path& file, const Context& context);

std::unique_ptr<MeshWriter> open_gmsh22(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t gmsh22_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_abaqus(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t abaqus_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_febio(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t febio_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_tetgen(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t tetgen_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_nastran(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t nastran_bytes(const MeshSize& size);
std::vector<std::string> nastran_label_losses(const Survey& survey);

std::unique_ptr<MeshWriter> open_dyna(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t dyna_bytes(const MeshSize& size);
std::vector<std::string> dyna_label_losses(const Survey& survey);

std::unique_ptr<MeshWriter> open_mfem(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t mfem_bytes(const MeshSize& size);
std::vector<std::string> mfem_label_losses(const Survey& survey);

std::unique_ptr<MeshWriter> open_xdmf(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t xdmf_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_vtkhdf(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t vtkhdf_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_stl(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t stl_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_vtp(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t vtp_bytes(const MeshSize& size);

std::unique_ptr<MeshWriter> open_ply(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t ply_bytes(const MeshSize& size);

}  // namespace certet::formats
