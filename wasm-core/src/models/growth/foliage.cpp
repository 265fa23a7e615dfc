#include "models/growth/foliage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "foundation/golden_spiral.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "foundation/rotation.hpp"
#include "models/growth/leaf_poses.hpp"
#include "models/growth/messages.generated.hpp"

namespace panicle::growth {
namespace {

constexpr std::uint64_t stream_turn = 0x6c656166, stream_face = stream_turn + 1, stream_size = stream_turn + 2,
                        stream_shake = stream_turn + 3, stream_lie = stream_turn + 4, stream_bud = stream_turn + 5,
                        stream_fall = stream_turn + 6, stream_bloom = stream_turn + 7;
constexpr float golden_turn = 0.38196601f;
constexpr float least_size = 0.7f;  // of the largest
// Distance that leaves fall from below where they hung, as a share of that height, at the median; and a bound of the
// farthest: few go far, so that litter thins outwards and has no edge.
constexpr float drift = 0.12f, blown = 0.25f;
constexpr float above = 0.01f;           // height above the ground, metres
constexpr float least_internode = 0.6f;  // shortest internode with leaves of this year, as a share of a leaf's length
constexpr std::size_t max_together = 256;
constexpr float near_tip = 0.35f;  // where leaves begin along an internode, as a share

// The year, from 0 to 1: when the first bud opens, over how long others follow, how long one takes; when the first leaf
// falls, and over how long; and the same of blossoms, which come before the leaves and wither while these unfold.
constexpr float budburst = 0.12f, burst_spread = 0.08f, unfolding = 0.16f;
constexpr float unfolded_by = budburst + burst_spread + unfolding + 1e-3f;  // with a margin for rounding
constexpr float autumn = 0.6f;  // from here on the grammar's falling leaves are about to fall
constexpr float first_fall = 0.7f, fall_spread = 0.22f;
constexpr float flowering = 0.1f, flower_spread = 0.06f, opening = 0.06f, withering = 0.26f, withered = 0.08f;

// The rotation (quaternion) of a leaf whose tip points to `out` and whose upper face looks to `face`, both unit
// vectors, as nearly as both are possible; `face` has priority.
glm::vec4 leaf_rotation(const glm::vec3& out, const glm::vec3& face) {
  const glm::vec3 in_plane = out - glm::dot(out, face) * face;
  const glm::vec3 up = glm::length(in_plane) > 1e-3f ? glm::normalize(in_plane) : any_perpendicular(face);
  return turn_to(up, face);
}

// Puts a fallen leaf on the ground: blown sideways by a random distance in proportion to the height where it hung, its
// face up but for a random tilt. Its tag becomes `tag`.
void lie_down(Organ& leaf, std::uint32_t tag, std::uint64_t seed, std::uint64_t address) {
  const SinCos direction = sincos_degrees(360 * random_unit(seed, stream_lie, address));
  const float noise = random_unit(seed, stream_lie, hash_combine(address, 1));
  const float distance = drift * leaf.position.y * noise / (1 + blown - noise);
  leaf.position += glm::vec3(distance * direction.cosine, 0, distance * direction.sine);
  leaf.position.y = above;
  const glm::vec3 face = glm::normalize(glm::vec3(0, 1, 0) + 0.25f * random_direction(seed, stream_lie, address));
  leaf.rotation = leaf_rotation({direction.sine, 0, direction.cosine}, face);
  leaf.tag = tag;
}

// 3 t² − 2 t³, with the value clamped to 0 … 1.
float smooth_step(float value) {
  const float share = std::clamp(value, 0.0f, 1.0f);
  return share * share * (3 - 2 * share);
}

// Adds a tree's leaves, blossoms and bunches as organs. A counted leaf is one of the grammar's, which stands for
// `habit.many` leaves on its twig.
class Crown {
 public:
  Crown(Plant& plant, const Population& population, const Form& form, const Moment& moment, float time,
        const LeafHabit& habit)
      : plant_(plant),
        population_(population),
        form_(form),
        moment_(moment),
        time_(time),
        habit_(habit),
        turns_(habit.seed, stream_turn),
        faces_(habit.seed, stream_face),
        sizes_(habit.seed, stream_size),
        buds_(habit.seed, stream_bud),
        falls_(habit.seed, stream_fall),
        blooms_(habit.seed, stream_bloom) {}

  // Counts the equal counted leaves from the l-th on: these are on one twig and appear and fall together. At most
  // `max_together`, so that limits are checked in between.
  std::size_t count_equal(std::size_t l) const {
    std::size_t end = l + 1;
    const std::size_t last = std::min(population_.leaves.size(), l + max_together);
    while (end < last && population_.leaves[end] == population_.leaves[l]) ++end;
    return end - l;
  }

  // Adds the leaves of `count` counted leaves from the l-th on, which are equal. Poses are computed four at a time.
  void add_leaves_of(std::size_t l, std::size_t count) {
    TwigPlace place;
    if (!find_twig(l, place)) return;
    const Twig twig{place.along, place.normal, place.binormal};
    LeafNoise noise{};
    std::array<CountedLeaf, 4> batch;
    std::uint32_t batch_size = 0;
    const auto add_batch = [&] {
      const auto poses = habit_.needles ? needle_poses(twig, noise) : leaf_poses(twig, noise, habit_.stray);
      for (std::uint32_t i = 0; i < batch_size; ++i) add_leaf(batch[i], place, poses[i]);
      batch_size = 0;
    };
    for (const std::size_t end = l + count; l < end; ++l) {
      const float first_turn = turns_.unit(hash_combine(l, 0));
      for (std::uint32_t k = 0; k < habit_.many; ++k) {
        const std::uint64_t address = hash_combine(l, k);
        const auto [height, around] = faces_.units(address);
        noise.about[batch_size] = first_turn + golden_turn * static_cast<float>(k);
        noise.height[batch_size] = 2 * height - 1;
        noise.around[batch_size] = around;
        batch[batch_size] = {l * habit_.many + k, address};
        if (++batch_size == 4) add_batch();
      }
    }
    if (batch_size > 0) add_batch();
  }

  // Adds the blossoms on the twig of the l-th counted leaf.
  void add_blossoms_of(std::size_t l) {
    TwigPlace place;
    if (!find_twig(l, place)) return;
    for (std::uint32_t k = 0; k < habit_.blossoms; ++k) add_blossom(hash_combine(l, k), place);
  }

  // Adds hanging bunches on the wood of the shoot q, a branch of a trunk, at the heights of a vine's nodes: one
  // internode here stands for several of a vine's.
  void add_bunches_of(std::uint32_t q) {
    const ShootPath& path = form_.paths[q];
    float begins = 0;
    std::uint32_t k = 0;
    for (std::uint32_t node = 1; node <= path.count && k < habit_.bunches; ++node) {
      const std::int32_t segment = moment_.of_node[path.first + node];
      if (segment < 0) return;
      const Segment& wood = moment_.segments[static_cast<std::size_t>(segment)];
      const float length = glm::distance(wood.start, wood.end);
      for (; k < habit_.bunches; ++k) {
        const float along = habit_.first_bunch + habit_.between * static_cast<float>(k) - begins;
        if (along > length) break;
        const glm::vec3 down(0, -1, 0);
        Organ bunch;
        bunch.tag = bunch_tag;
        bunch.segment = segment;
        bunch.position = glm::mix(wood.start, wood.end, length > 0 ? std::max(along / length, 0.0f) : 0.0f);
        bunch.rotation = turn_to(down, any_perpendicular(down));
        plant_.organs.push_back(bunch);
      }
      begins += length;
    }
  }

 private:
  // The index of a leaf in the whole tree, and the address of its random values.
  struct CountedLeaf {
    std::size_t number = 0;
    std::uint64_t address = 0;
  };

  // The twig of a leaf: its segment (−1: none), the frame of its internode, whether the leaf is a falling one, and the
  // share 0 … 1 of the leaf that is grown.
  struct TwigPlace {
    std::int32_t segment = -1;
    float share = 0, length = 0;
    bool falls = false;
    glm::vec3 along{0}, normal{0}, binormal{0};
  };

  // Finds the twig of the l-th counted leaf and the share of the leaf that is grown at this time. Returns false if the
  // leaf does not exist at this time.
  bool find_twig(std::size_t l, TwigPlace& place) const {
    const Leaf& counted = population_.leaves[l];
    const ShootPath& path = form_.paths[counted.shoot];
    const bool marked = counted.falls != Leaf::never && time_ >= static_cast<float>(counted.falls);
    place.falls = marked && sheds_now();
    place.share = grown_share(counted.born, time_);
    // Counted leaves about to fall hang for a step and shrink during it; foliage is renewed every year, and an earlier
    // year's shrinks while this year's grows.
    if (counted.gone != Leaf::never)
      place.share *= 1 - grown_share(counted.gone, time_);
    else if (marked)
      place.share *= 1 - std::clamp(time_ - static_cast<float>(counted.falls), 0.0f, 1.0f);
    if (!(place.share > 0) || path.count == 0) return false;
    const std::uint32_t node =
        std::min<std::uint32_t>(counted.born > path.from ? counted.born - path.from : 0u, path.count - 1) + 1;
    place.segment = moment_.of_node[path.first + node];
    if (place.segment < 0) return false;
    const glm::vec3 internode = form_.nodes[path.first + node] - form_.nodes[path.first + node - 1];
    const Segment& twig = moment_.segments[static_cast<std::size_t>(place.segment)];
    const float length = glm::length(internode);
    // A shoot without room to grow has no leaves.
    if (counted.gone != Leaf::never && length < least_internode * habit_.size) return false;
    place.length = std::min(length, glm::distance(twig.start, twig.end));
    place.along = length > 0 ? internode / length : glm::vec3(0, 1, 0);
    place.normal = any_perpendicular(place.along);
    place.binormal = glm::cross(place.along, place.normal);
    return true;
  }

  // Whether the grammar's falling leaves are about to fall: at any time in a tree of the paper, whose leaves stay on
  // old wood, and in autumn where foliage is renewed every year.
  bool sheds_now() const { return !population_.has_foliage || (!habit_.evergreen && habit_.season >= autumn); }

  // An organ on a twig, the share `back` of its internode before the end.
  Organ organ_on(const TwigPlace& place, float back) const {
    Organ organ;
    organ.segment = place.segment;
    organ.position = moment_.segments[static_cast<std::size_t>(place.segment)].end - back * place.length * place.along;
    return organ;
  }

  // The share of a leaf that has unfolded this season.
  float unfolded(std::uint64_t address) const {
    if (habit_.evergreen || habit_.season > unfolded_by) return 1;
    const float begins = budburst + burst_spread * buds_.unit(address);
    return smooth_step((habit_.season - begins) / unfolding);
  }

  // Whether a leaf has fallen by this season.
  bool shed(std::uint64_t address) const {
    return !habit_.evergreen && habit_.season > first_fall &&
           habit_.season > first_fall + fall_spread * falls_.unit(address);
  }

  // Adds a leaf in the given pose: on its twig, or on the ground if it has fallen.
  void add_leaf(const CountedLeaf& counted_leaf, const TwigPlace& place, const glm::vec4& pose) {
    const std::uint64_t address = counted_leaf.address;
    const float share = place.share * unfolded(address);
    if (!(share > 0)) return;
    const float turns = golden_ratio * static_cast<float>(counted_leaf.number);
    Organ leaf = organ_on(place, (1 - near_tip) * (turns - std::floor(turns)));
    leaf.tag = place.falls ? falling_tag : leaf_tag;
    leaf.rotation = pose;
    leaf.scale = share * habit_.size * (least_size + (1 - least_size) * sizes_.unit(address));
    if (shed(address))
      lie_down(leaf, shed_tag, habit_.seed, address);
    else if (place.falls && random_unit(habit_.seed, stream_shake, address) < habit_.fallen)
      lie_down(leaf, fallen_tag, habit_.seed, address);
    plant_.organs.push_back(leaf);
  }

  // Adds a blossom on a twig, as far as it has opened and not withered this season.
  void add_blossom(std::uint64_t address, const TwigPlace& place) {
    const float late = flower_spread * blooms_.unit(address);
    const float share = place.share * smooth_step((habit_.season - flowering - late) / opening) *
                        (1 - smooth_step((habit_.season - withering - late) / withered));
    if (!(share > 0)) return;
    const glm::vec3 noise = blooms_.direction(hash_combine(address, 1));
    const glm::vec3 direction = noise - 0.7f * glm::dot(noise, place.along) * place.along + glm::vec3(0, 0.3f, 0);
    const glm::vec3 out = glm::length(direction) > 1e-3f ? glm::normalize(direction) : place.normal;
    Organ blossom = organ_on(place, blooms_.unit(hash_combine(address, 2)));
    blossom.tag = blossom_tag;
    blossom.rotation = turn_to(out, any_perpendicular(out));
    blossom.scale = share * habit_.blossom_size;
    plant_.organs.push_back(blossom);
  }

  Plant& plant_;
  const Population& population_;
  const Form& form_;
  const Moment& moment_;
  const float time_;
  const LeafHabit& habit_;
  const RandomStream turns_, faces_, sizes_, buds_, falls_, blooms_;
};

}  // namespace

// Adds all leaves, blossoms and bunches of a tree at a time in steps. Returns an error if there are more organs than
// the limits allow.
Diagnostic add_leaves(Plant& plant, const Population& population, const Form& form, const Moment& moment, float time,
                      const LeafHabit& habit, const Limits& limits) {
  Crown crown(plant, population, form, moment, time, habit);
  plant.organs.reserve(
      std::min<std::size_t>(population.leaves.size() * (habit.many + habit.blossoms), limits.copies + std::size_t{1}));
  const auto too_many = [&] { return plant.organs.size() > limits.copies; };
  const Diagnostic error{Reason::limit, message(messages::growth::too_many_leaves, limits.copies)};
  for (std::size_t l = 0; l < population.leaves.size();) {
    const std::size_t count = crown.count_equal(l);
    crown.add_leaves_of(l, count);
    if (too_many()) return error;
    l += count;
  }
  for (std::size_t l = 0; habit.blossoms > 0 && l < population.leaves.size(); ++l) {
    crown.add_blossoms_of(l);
    if (too_many()) return error;
  }
  for (std::uint32_t q = 0; habit.bunches > 0 && q < form.paths.size(); ++q)
    if (population.shoots[q].order == 1) crown.add_bunches_of(q);
  return {};
}

}  // namespace panicle::growth
