// Reads #material lines.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <utility>

#include "expression/number_text.hpp"
#include "models/flower/messages.generated.hpp"
#include "models/flower/syntax/reader.hpp"

namespace panicle::flower {
namespace {

using expression::TokenKind;

constexpr std::uint32_t most_material = 255;
constexpr float most_veins = 60;
constexpr std::size_t longest_name = 40;

}  // namespace

// Reads `#material 4 petal "c8102e" "f6d55c"` and the settings behind it.
bool FlowerReader::material() {
  Material material;
  material.place = here();
  ++at_;
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::number)
    return wrong(here(), message(messages::flower::material_syntax));
  const float number = tokens_[at_].number;
  if (!(number >= 0 && number <= most_material && std::floor(number) == number))
    return wrong(here(), message(messages::flower::material_number_syntax));
  material.number = static_cast<std::uint32_t>(number);
  for (const Material& other : program_.materials)
    if (other.number == material.number) return wrong(here(), message(messages::flower::material_twice));
  ++at_;
  if (!on_name() || std::find(material_kinds.begin(), material_kinds.end(), found()) == material_kinds.end())
    return wrong(here(), message(messages::flower::material_kind, found_text()));
  material.kind = std::string(found());
  ++at_;
  if (!colours(material.open)) return false;
  material.bud = material.wilted = material.open;
  material.light = light_through(material.kind);
  if (!material_settings(material)) return false;
  program_.materials.push_back(std::move(material));
  return true;
}

// Reads `margin "ffffff" 0.2 light 0.6`: each setting once, in any order.
bool FlowerReader::material_settings(Material& material) {
  using Read = bool (*)(FlowerReader&, Material&);
  static constexpr expression::NamedReader<Read> settings[] = {
      {"foot", [](FlowerReader& reader, Material& of) { return reader.share(of.foot, 1); }},
      {"margin",
       [](FlowerReader& reader, Material& of) { return reader.colour(of.margin) && reader.share(of.margin_width, 1); }},
      {"veins", [](FlowerReader& reader, Material& of) { return reader.veins_of(of); }},
      {"light", [](FlowerReader& reader, Material& of) { return reader.share(of.light, 1); }},
      {"bud", [](FlowerReader& reader, Material& of) { return reader.colours(of.bud); }},
      {"wilted", [](FlowerReader& reader, Material& of) { return reader.colours(of.wilted); }},
      {"name", [](FlowerReader& reader, Material& of) { return reader.part_name(of.name); }}};
  std::array<bool, std::size(settings)> is_set{};
  while (at_ < end_) {
    const auto* const setting = find_named(settings);
    if (setting == nullptr) return wrong(here(), message(messages::flower::material_setting, found_text()));
    bool& was_set = is_set[static_cast<std::size_t>(setting - settings)];
    if (was_set) return wrong(here(), message(messages::flower::set_twice, found()));
    was_set = true;
    ++at_;
    if (!setting->read(*this, material)) return false;
  }
  return true;
}

// Reads the colour, count and strength of veins, `"8a1030" 9 0.5`, optionally followed by `feathered`.
bool FlowerReader::veins_of(Material& material) {
  if (!colour(material.veins) || !share(material.vein_count, most_veins) || !share(material.vein_strength, 1))
    return false;
  material.feathered = on("feathered");
  at_ += material.feathered;
  return true;
}

// Reads a quoted name: up to 40 letters, digits, spaces, hyphens and commas, not beginning with a space.
bool FlowerReader::part_name(std::string& name) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '-' || c == ',';
  };
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::quoted || tokens_[at_].text.empty() ||
      tokens_[at_].text.size() > longest_name || tokens_[at_].text.front() == ' ' ||
      !std::all_of(tokens_[at_].text.begin(), tokens_[at_].text.end(), plain))
    return wrong(here(), message(messages::flower::part_name, longest_name));
  name = std::string(tokens_[at_++].text);
  return true;
}

// Reads a number from 0 to `most`.
bool FlowerReader::share(float& value, float most) {
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::number || !(tokens_[at_].number <= most))
    return wrong(here(), message(messages::flower::number_up_to, expression::number_text(most), found_text()));
  value = tokens_[at_++].number;
  return true;
}

// Reads one or two colours: where an organ begins, and where it ends.
bool FlowerReader::colours(Colours& colours) {
  if (!colour(colours.base)) return false;
  colours.tip = colours.base;
  return at_ >= end_ || tokens_[at_].kind != TokenKind::quoted || colour(colours.tip);
}

// Reads a quoted colour of six hexadecimal digits: red, green and blue from the highest bits down.
bool FlowerReader::colour(std::uint32_t& colour) {
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::quoted || tokens_[at_].text.size() != 6)
    return wrong(here(), message(messages::flower::colour_syntax));
  colour = 0;
  for (const char c : tokens_[at_].text) {
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : -1;
    if (digit < 0) return wrong(here(), message(messages::flower::colour_syntax));
    colour = 16 * colour + static_cast<std::uint32_t>(digit);
  }
  return ++at_, true;
}

}  // namespace panicle::flower
