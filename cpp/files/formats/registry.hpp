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

/// Begins a file.
using OpenWriter = std::unique_ptr<MeshWriter>(const std::filesystem::path& file,
                                               const MeshSize& size);
/// How long a file becomes: exactly for binary formats, an estimate for others.
using FileBytes = std::uint64_t(const MeshSize& size);
using ReadFile = FileMesh(const std::filesystem::path& file, const Context& context);
/// The labels that do not keep their numbers, a sentence each.
using LabelLosses = std::vector<std::string>(const Survey& survey);

OpenWriter open_vtu; FileBytes vtu_bytes; ReadFile read_vtu;
OpenWriter open_vtu_zlib; FileBytes vtu_zlib_bytes;
OpenWriter open_medit; FileBytes medit_bytes; ReadFile read_medit;
OpenWriter open_medit_binary; FileBytes medit_binary_bytes; ReadFile read_medit_binary;
OpenWriter open_gmsh; FileBytes gmsh_bytes; ReadFile read_gmsh;  // both versions
OpenWriter open_gmsh22; FileBytes gmsh22_bytes;
OpenWriter open_abaqus; FileBytes abaqus_bytes;
OpenWriter open_febio; FileBytes febio_bytes;
OpenWriter open_tetgen; FileBytes tetgen_bytes;
OpenWriter open_nastran; FileBytes nastran_bytes; LabelLosses nastran_label_losses;
OpenWriter open_dyna; FileBytes dyna_bytes; LabelLosses dyna_label_losses;
OpenWriter open_mfem; FileBytes mfem_bytes; LabelLosses mfem_label_losses;
OpenWriter open_polymesh; FileBytes polymesh_bytes;
OpenWriter open_xdmf; FileBytes xdmf_bytes;
OpenWriter open_vtkhdf; FileBytes vtkhdf_bytes;
OpenWriter open_stl; FileBytes stl_bytes;
OpenWriter open_vtp; FileBytes vtp_bytes;
OpenWriter open_ply; FileBytes ply_bytes;

}  // namespace certet::formats
