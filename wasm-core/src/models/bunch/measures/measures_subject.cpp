#include "models/bunch/measures/measures_subject.hpp"

#include "foundation/mathematics.hpp"
#include "models/bunch/berry/berry_meridian.hpp"

namespace panicle::bunch {
namespace {

constexpr float millimetres = 1000;  // to a metre
constexpr float unit_ball = 4 * pi / 3;

// Per internode, 1 if it is of the first bunch: it hangs from the first root, and not from the second bunch's. Parents
// come before their children.
std::vector<std::uint8_t> of_first_bunch(const GrownBunch& grown) {
  const std::vector<Internode>& internodes = grown.internodes;
  std::vector<std::uint8_t> first(internodes.size(), 0);
  for (std::size_t i = 0; i < internodes.size(); ++i) {
    const std::int32_t parent = internodes[i].parent;
    first[i] = parent < 0 ? i == 0 : first[static_cast<std::size_t>(parent)];
    if (static_cast<std::int32_t>(i) == grown.second_root) first[i] = 0;
  }
  return first;
}

}  // namespace

// Collects the parts that are measured, in millimetres: stems, berries, their volumes, and which belong to the first
// bunch.
Subject::Subject(const GrownBunch& grown) {
  for (const Internode& one : grown.internodes) {
    stems.push_back(one);
    scale(stems.back(), millimetres);
  }
  const std::vector<std::uint8_t> of_first = of_first_bunch(grown);
  const bool natural = grown.traits.size() == grown.berries.size();
  const float form = form_volume(grown.form, 1, 1);
  for (std::size_t i = 0; i < grown.berries.size(); ++i) {
    const Berry& berry = grown.berries[i];
    const float width = millimetres * (natural ? grown.traits[i].width / 2 : berry.radius);
    const float length = millimetres * (natural ? grown.traits[i].length / 2 : berry.radius);
    berries.push_back({millimetres * berry.centre, berry.direction, width, length, 0, berry.id});
    volumes.push_back(form * width * width * length);
    balls.push_back(cube_root(volumes.back() / unit_ball));
    mean_radius += balls.back();
    const bool is_attached = berry.parent >= 0 && static_cast<std::size_t>(berry.parent) < stems.size();
    first.push_back(is_attached ? of_first[static_cast<std::size_t>(berry.parent)] : 1);
    if (is_attached) pedicels.push_back(stems[static_cast<std::size_t>(berry.parent)]);
  }
  if (!berries.empty()) mean_radius /= static_cast<float>(berries.size());
}

}  // namespace panicle::bunch
