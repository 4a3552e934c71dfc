#pragma once
/// \file
/// The types of numbers that files have.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>

#include "certet/image.hpp"

namespace certet {

enum class NumberType { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };

std::size_t bytes_of(NumberType type);

/// Room for `count` numbers, which `fill` writes, all of them, in the byte order of
/// this machine; labels of 64 bits are kept where they fit 32 bits.
/// \throws Error `bad_input` naming the file.
Voxels load_voxels(const std::filesystem::path& file, NumberType type, std::uint64_t count,
                   const std::function<void(char*)>& fill);

/// Turns round the bytes of each number.
void swap_bytes(char* numbers, std::uint64_t count, std::size_t bytes_of_one);

/// The numbers slope * v + intercept: whole ones where slope, intercept and v are and
/// the type is too narrow for the result to leave 32 bits, else of 64 bits.
/// \throws Error `bad_input` naming the file.
Voxels rescaled(const Voxels& voxels, double slope, double intercept);

/// The bytes of one number of what `rescaled` gives, at most.
inline constexpr std::size_t most_rescaled_bytes = sizeof(double);

/// Of numbers that lie in several volumes, one: number `first` and every `step`-th
/// after it, `count` of them.
Voxels every(const Voxels& all, std::uint64_t first, std::uint64_t step, std::uint64_t count);

}  // namespace certet
