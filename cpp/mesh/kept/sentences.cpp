#include <cstdio>

#include "certet/kept.hpp"
#include "digits.hpp"

namespace certet {
namespace {

using core::digits;

std::string percent(double share) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.1f %%", 100 * share);
  return text.data();
}

/// Digits in groups of three.
std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ',');
  return text;
}

std::string pieces(std::uint64_t count) {
  return std::to_string(count) + (count == 1 ? " piece" : " pieces");
}

/// What a size that was tried has of the volume.
std::string share_at(const TriedSize& tried) {
  return "has " + percent(tried.share) + " of it, in " + grouped(tried.tets) + " tetrahedra";
}

constexpr const char* none_tried = "smaller sizes would take too many tetrahedra to try";

std::string on_volume(const Losses& losses, const SizedShape& shape, std::string_view size) {
  const OtherVolume& volume = *losses.volume;
  return "the mesh has " + percent(volume.mesh / volume.shape.volume) + " of the volume of '" +
         shape.name + "', " + digits(volume.mesh, 6) + " of " +
         (volume.shape.exact ? "" : "about ") + digits(volume.shape.volume, 6) + "; " +
         advice_on_volume(losses.sizes, shape, size);
}

/// Of pieces that are known on lattices alone.
std::string advice_on_samples(const KeepingSizes& sizes, std::string_view size) {
  if (!sizes.kept) return advice_on_pieces(sizes, size);
  return std::string(size) + digits(sizes.kept->size, 6) + " has " +
         std::to_string(sizes.kept->pieces) + ", and so have its samples at half of it";
}

std::string on_pieces(const Losses& losses, const SizedShape& shape, std::string_view size) {
  const OtherPieces& other = *losses.pieces;
  const auto& [least, most] = other.shape;
  const std::string bounds = least == most ? "" : std::to_string(least) + " to ";
  return "the mesh of '" + shape.name + "' has " + pieces(other.mesh.by_faces) +
         (other.finer_size == 0 ? ", and the shape " + bounds + std::to_string(most)
                                : ", and its samples at size " + digits(other.finer_size, 4) +
                                      " have " + std::to_string(most)) +
         "; " +
         (other.finer_size == 0 ? advice_on_pieces(losses.sizes, size)
                                : advice_on_samples(losses.sizes, size));
}

}  // namespace

std::string advice_on_volume(const KeepingSizes& sizes, const SizedShape& shape,
                             std::string_view option) {
  const std::string size(option);
  if (sizes.kept) return size + digits(sizes.kept->size, 6) + " " + share_at(*sizes.kept);
  const std::string parts =
      shape.thin > 0 ? "parts of it are " + digits(shape.thin, 3) + " thick, and " : "";
  if (sizes.finest.size == 0) return parts + none_tried;
  if (sizes.finest.share == 0)
    return parts + "no size down to " + digits(sizes.finest.size, 4) + " keeps any of it";
  return parts + size + digits(sizes.finest.size, 6) + ", the smallest that was tried, " +
         share_at(sizes.finest);
}

std::string advice_on_pieces(const KeepingSizes& sizes, std::string_view size) {
  if (sizes.kept) return std::string(size) + digits(sizes.kept->size, 6) + " keeps them";
  return sizes.finest.size == 0
             ? none_tried
             : "no size was found that keeps them, down to " + digits(sizes.finest.size, 4);
}

std::string sentence_on(const UncomparedPieces& uncompared) {
  return "pieces were not compared with those of finer samples: at size " +
         digits(uncompared.size, 4) + " " +
         grouped(static_cast<std::uint64_t>(uncompared.cells)) + " cells would be looked at";
}

std::vector<std::string> sentences_on(const Losses& losses, const SizedShape& shape,
                                      std::string_view size) {
  std::vector<std::string> sentences;
  if (losses.volume) sentences.push_back(on_volume(losses, shape, size));
  if (losses.pieces) sentences.push_back(on_pieces(losses, shape, size));
  return sentences;
}

}  // namespace certet
