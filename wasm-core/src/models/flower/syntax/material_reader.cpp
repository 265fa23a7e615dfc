// Reads #material lines.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "expression/number_text.hpp"
#include "models/flower/syntax/reader.hpp"

namespace panicle::flower {
namespace {

using expression::TokenKind;

constexpr std::uint32_t most_material = 255;
constexpr float most_veins = 60;
constexpr std::size_t longest_name = 40;

}  // namespace

// `#material 4 petal "c8102e" "f6d55c"`
bool FlowerReader::material() {
  static constexpr const char* advice =
      "A material is a number, a kind and one or two colours: #material 4 petal \"c8102e\".";
  Material material;
  material.place = here();
  ++at_;
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::number) return wrong(here(), advice);
  const float number = tokens_[at_].number;
  if (!(number >= 0 && number <= most_material && std::floor(number) == number))
    return wrong(here(), "A material's number is a whole number from 0 to 255.");
  material.number = static_cast<std::uint32_t>(number);
  for (const Material& other : program_.materials)
    if (other.number == material.number) return wrong(here(), "This number has a material already; take one out.");
  ++at_;
  if (!on_name() || std::find(material_kinds.begin(), material_kinds.end(), found()) == material_kinds.end())
    return wrong(here(), "The kinds are stem, leaf, sepal, petal, stamen, pistil and seed; '%' is none.", {found()});
  material.kind = std::string(found());
  ++at_;
  if (!colours(material.open)) return false;
  material.bud = material.wilted = material.open;
  material.light = light_through(material.kind);
  if (!material_settings(material)) return false;
  program_.materials.push_back(std::move(material));
  return true;
}

// `margin "ffffff" 0.2 light 0.6`: each once, in any order.
bool FlowerReader::material_settings(Material& material) {
  static constexpr std::array<std::string_view, 7> setting_names = {"foot", "margin", "veins", "light",
                                                                    "bud",  "wilted", "name"};
  std::array<bool, setting_names.size()> is_set{};
  while (at_ < end_) {
    const auto word = static_cast<std::size_t>(std::find(setting_names.begin(), setting_names.end(), found()) -
                                               setting_names.begin());
    if (!on_name() || word == setting_names.size())
      return wrong(here(), "Of a material one can say foot, margin, veins, light, bud, wilted and name; '%' is none.",
                   {found()});
    if (is_set[word]) return wrong(here(), "% has been said already; take one out.", {found()});
    is_set[word] = true;
    ++at_;
    const bool fine = word == 0   ? share(material.foot, 1)
                      : word == 1 ? colour(material.margin) && share(material.margin_width, 1)
                      : word == 2 ? veins_of(material)
                      : word == 3 ? share(material.light, 1)
                      : word == 4 ? colours(material.bud)
                      : word == 5 ? colours(material.wilted)
                                  : part_name(material.name);
    if (!fine) return false;
  }
  return true;
}

// `"8a1030" 9 0.5`, optionally followed by `feathered`.
bool FlowerReader::veins_of(Material& material) {
  if (!colour(material.veins) || !share(material.vein_count, most_veins) || !share(material.vein_strength, 1))
    return false;
  material.feathered = on_name() && found() == "feathered";
  at_ += material.feathered;
  return true;
}

bool FlowerReader::part_name(std::string& name) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '-' || c == ',';
  };
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::quoted || tokens_[at_].text.empty() ||
      tokens_[at_].text.size() > longest_name || tokens_[at_].text.front() == ' ' ||
      !std::all_of(tokens_[at_].text.begin(), tokens_[at_].text.end(), plain))
    return wrong(here(), "A name stands in quotes, of letters, digits, spaces, commas and hyphens, at most %.",
                 {std::to_string(longest_name)});
  name = std::string(tokens_[at_++].text);
  return true;
}

// Reads a number from 0 to `most`.
bool FlowerReader::share(float& value, float most) {
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::number || !(tokens_[at_].number <= most))
    return wrong(here(), "A number from 0 to % stands here, not '%'.", {expression::number_text(most), found()});
  value = tokens_[at_++].number;
  return true;
}

// One, or two: where an organ begins, and where it ends.
bool FlowerReader::colours(Colours& colours) {
  if (!colour(colours.base)) return false;
  colours.tip = colours.base;
  return at_ >= end_ || tokens_[at_].kind != TokenKind::quoted || colour(colours.tip);
}

bool FlowerReader::colour(std::uint32_t& colour) {
  static constexpr const char* advice = "A colour is six hexadecimal digits in quotes, such as \"c8102e\".";
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::quoted || tokens_[at_].text.size() != 6)
    return wrong(here(), advice);
  colour = 0;
  for (const char c : tokens_[at_].text) {
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : -1;
    if (digit < 0) return wrong(here(), advice);
    colour = 16 * colour + static_cast<std::uint32_t>(digit);
  }
  return ++at_, true;
}

}  // namespace panicle::flower
