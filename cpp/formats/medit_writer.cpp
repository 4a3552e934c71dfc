#include <array>
#include <charconv>
#include <limits>
#include <string_view>

#include "announced.hpp"
#include "output_file.hpp"
#include "registry.hpp"
#include "section.hpp"

namespace certet::formats {
namespace {

/// Longer than any line that is written: three doubles of at most 24
/// characters, or four integers of at most 20, and what stands around them.
constexpr std::size_t longest_line = 128;

/// One line of numbers, in the shortest form that reads back the same.
class Line {
 public:
  template <class Number>
  Line& operator<<(Number number) {
    end_ = std::to_chars(end_, text_.data() + text_.size(), number).ptr;
    *end_++ = ' ';
    return *this;
  }
  /// The line, with its last blank made its end.
  [[nodiscard]] std::span<const char> text() {
    end_[-1] = '\n';
    return {text_.data(), end_};
  }

 private:
  std::array<char, longest_line> text_;
  char* end_ = text_.data();
};

class MeditWriter final : public MeshWriter {
 public:
  MeditWriter(const std::filesystem::path& file, const MeshSize& size)
      : size_(size), file_(file), announced_(size, file_), text_(file_, 0) {
    // Version 2 has doubles, version 4 has indices of 64 bits beside.
    const std::uint64_t greatest = std::max(size.points, size.tets);
    const bool wide = greatest > std::uint64_t{std::numeric_limits<std::int32_t>::max()};
    append(wide ? "MeshVersionFormatted 4\n" : "MeshVersionFormatted 2\n");
    append("Dimension 3\nVertices\n" + std::to_string(size.points) + "\n");
  }

  void points(std::span<const Point3> points) override {
    announced_.points(points.size());
    for (const Point3& p : points) append(Line() << p[0] << p[1] << p[2] << 0);
  }
  void tets(std::span<const Tet<std::uint32_t>> tets,
            std::span<const std::int32_t> labels) override {
    append_tets(tets, labels);
  }
  void tets(std::span<const Tet<std::uint64_t>> tets,
            std::span<const std::int32_t> labels) override {
    append_tets(tets, labels);
  }
  void finish() override {
    announced_.finish();
    open_tets();
    append("End\n");
    text_.flush();
    file_.commit();
  }

 private:
  void append(std::string_view words) { text_.append_all(std::span<const char>(words)); }
  void append(Line& line) { text_.append_all(line.text()); }

  /// The heading of the tetrahedra, once.
  void open_tets() {
    if (!tets_opened_) append("Tetrahedra\n" + std::to_string(size_.tets) + "\n");
    tets_opened_ = true;
  }

  template <class Index>
  void append_tets(std::span<const Tet<Index>> tets, std::span<const std::int32_t> labels) {
    announced_.tets(tets, labels);
    open_tets();
    const auto number = [](Index index) { return std::uint64_t{index} + 1; };
    for (std::size_t i = 0; i < tets.size(); ++i) {
      const auto& [a, b, c, d] = tets[i];
      append(Line() << number(a) << number(b) << number(c) << number(d)
                    << (labels.empty() ? 0 : labels[i]));
    }
  }

  MeshSize size_;
  OutputFile file_;
  Announced announced_;
  Section text_;
  bool tets_opened_ = false;
};

}  // namespace

std::unique_ptr<MeshWriter> open_medit(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<MeditWriter>(file, size);
}

std::uint64_t medit_bytes(const MeshSize& size) {
  // Most doubles need 17 digits, a sign or exponent now and then, and a point.
  constexpr std::uint64_t point_line = 3 * 20 + 2;
  const std::uint64_t digits = std::to_string(size.points).size();
  const std::uint64_t tet_line = 4 * (digits + 1) + (size.labels ? 5 : 2);
  return 100 + size.points * point_line + size.tets * tet_line;
}

}  // namespace certet::formats
