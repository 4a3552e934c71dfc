#include "nrrd_segments.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

#include "certet/error.hpp"

namespace certet {
namespace {

using Place = std::pair<std::uint64_t, std::int64_t>;  ///< layer and value

std::int64_t number(const std::string& text, std::int64_t otherwise) {
  std::int64_t value = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// More than any program writes; each costs a row of counts.
constexpr std::size_t most_segments = 4096;

template <class T>
std::set<Place> places_of(const Buffer<T>& all, std::uint64_t layers) {
  std::set<Place> places;
  std::vector<T> last(layers, 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    T& before = last[i % layers];
    if (all[i] == before || all[i] == 0) continue;
    places.insert({i % layers, static_cast<std::int64_t>(before = all[i])});
    if (places.size() > most_segments) break;
  }
  return places;
}

/// Values without a segment in the header: a value of their own where it is free.
std::vector<Segment> without_name(const std::set<Place>& places,
                                  const std::vector<Segment>& segments) {
  std::set<Place> named;
  for (const Segment& segment : segments) named.insert({segment.layer, segment.value});
  std::vector<Segment> result;
  for (const auto& [layer, value] : places)
    if (!named.contains({layer, value})) result.push_back({layer, value, 0, {}});
  return result;
}

void label_rest(std::vector<Segment>& rest, const std::vector<Segment>& segments) {
  std::set<std::int32_t> taken;
  for (const Segment& segment : segments) taken.insert(segment.label);
  std::int32_t next = 1;
  for (Segment& segment : rest) {
    const bool fits = std::in_range<std::int32_t>(segment.value) &&
                      !taken.contains(static_cast<std::int32_t>(segment.value));
    while (taken.contains(next)) ++next;
    segment.label = fits ? static_cast<std::int32_t>(segment.value) : next;
    taken.insert(segment.label);
  }
}

std::string list(const std::vector<Segment>& segments) {
  std::string text;
  for (std::size_t i = 0; i < segments.size() && i < 8; ++i)
    text += (i == 0 ? "" : ", ") + std::string("value ") + std::to_string(segments[i].value) +
            " of layer " + std::to_string(segments[i].layer) + " is label " +
            std::to_string(segments[i].label);
  return segments.size() > 8 ? text + " and so on" : text;
}

}  // namespace

std::vector<Segment> segments_of(const NrrdHeader& header) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < most_segments; ++i) {
    const std::string key = "Segment" + std::to_string(i) + "_";
    const auto value = header.value(key + "LabelValue");
    if (!value && !header.value(key + "ID")) break;
    Segment segment;
    segment.value = number(value.value_or(""), 1);
    segment.layer =
        static_cast<std::uint64_t>(std::max<std::int64_t>(number(header.value(key + "Layer").value_or(""), 0), 0));
    segment.name = header.value(key + "Name").value_or(header.value(key + "ID").value_or(""));
    segments.push_back(std::move(segment));
  }
  return segments;
}

void merge_layers(Image& image, const Voxels& all, std::uint64_t layers,
                  std::vector<Segment> segments) {
  choose_labels(segments, image.notes);
  std::visit(
      [&]<class T>(const Buffer<T>& numbers) {
        if constexpr (!std::is_integral_v<T>) {
          throw Error(ErrorCode::bad_input,
                      "'" + image.name + "' has segments whose voxels are not whole numbers");
        } else {
          auto rest = without_name(places_of(numbers, layers), segments);
          if (rest.size() + segments.size() > most_segments)
            throw Error(ErrorCode::bad_input, "'" + image.name + "' has too many segments");
          label_rest(rest, segments);
          if (!rest.empty())
            image.notes.push_back("the header has no segment for some values: " + list(rest) +
                                  ", below all segments");
          rest.insert(rest.end(), segments.begin(), segments.end());
          std::map<Place, std::size_t> place;
          for (std::size_t s = 0; s < rest.size(); ++s) place[{rest[s].layer, rest[s].value}] = s;
          LabelLayers labels(image, std::move(rest));
          for (std::size_t i = 0; i < numbers.size(); ++i)
            if (numbers[i] != 0)
              labels.add(i / layers, place.at({i % layers, static_cast<std::int64_t>(numbers[i])}));
          labels.finish();
        }
      },
      all);
}

}  // namespace certet
