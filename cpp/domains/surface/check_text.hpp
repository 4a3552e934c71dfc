#pragma once
/// \file
/// Text files that assimp reads, looked at before: it reads on where a line has too few
/// numbers, and blames what comes after.

#include "files/formats/input_file.hpp"

namespace certet {

/// Points of an OBJ file have three numbers or more, and faces name points by numbers
/// that are there.  \throws Error `bad_input`, the sentence names the line.
void check_obj(const formats::InputFile& file);

/// Points of an STL file that is text have three numbers, and triangles three points.
/// \throws Error `bad_input`, the sentence names the line.
void check_text_stl(const formats::InputFile& file);

}  // namespace certet
