#pragma once
/// \file
/// Every target, each in the file of its name.

#include "target.hpp"

namespace fuzz {

void mesh_file(Bytes bytes);    ///< first byte: the format; then the file
void label_names(Bytes bytes);  ///< the file
void convert(Bytes bytes);      ///< first bytes: the format to write and that to read; then the file
void picture(Bytes bytes);      ///< as mesh_file
void image(Bytes bytes);        ///< first byte: the format; then the file
void dicom(Bytes bytes);        ///< two slices of one length, one behind the other
void image_parts(Bytes bytes);  ///< first byte: the format; the header's length; then header and voxels
void volume(Bytes bytes);       ///< the file, zeros packed
void surface(Bytes bytes);      ///< first byte: the format; then the file
void formula(Bytes bytes);      ///< the formula
void options(Bytes bytes);      ///< the words of a command line, a line each
void run_file(Bytes bytes);     ///< what `certet mesh --json` says
void core(Bytes bytes);         ///< lattice and options; then signs and cuts

void planted_reader(Bytes bytes);  ///< throws what no reader may throw
void planted_memory(Bytes bytes);  ///< hands on memory that nobody wrote
void planted_core(Bytes bytes);    ///< spoils the mesh before it is judged

}  // namespace fuzz
