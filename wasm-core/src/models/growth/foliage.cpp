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
                        stream_fall = stream_turn + 6, stream_bloom = stream_turn + 7, stream_twig = stream_turn + 8;
constexpr float golden_turn = 0.38196601f;
constexpr float least_size = 0.7f;  // of the largest
// Distance that leaves fall from below where they hung, as a share of that height, at the median; and a bound of the
// farthest: few go far, so that litter thins outwards and has no edge.
constexpr float drift = 0.12f, blown = 0.25f;
constexpr float above = 0.01f;           // height above the ground, metres
constexpr float least_internode = 0.6f;  // shortest internode with leaves of this year, as a share of a leaf's length
constexpr std::size_t max_together = 256;
// Twigs: the least distance between two on an internode, in lengths of a twig; their angles to the internode at its
// start and its end, and of one at the tip of a shoot, degrees; their lengths over the longest; the largest turn about
// their axis; the least height of their tips above the ground, metres.
constexpr float twig_distance = 0.1f, twig_base_angle = 64, twig_end_angle = 40, twig_tip_angle = 6, least_twig = 0.7f,
                max_twig_roll = 35, twig_floor = 0.1f;
// Blossoms of a spur: where they begin along the twig, and how far apart, in widths of a blossom.
constexpr float spur_end = 0.16f, cluster = 0.8f;
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
        blooms_(habit.seed, stream_bloom),
        twigs_(habit.seed, stream_twig),
        unfolded_(unfolded_by_shape(habit)) {}

  // Counts the equal counted leaves from the l-th on: these are on one twig and appear and fall together. At most
  // `max_together`, so that limits are checked in between.
  std::size_t count_equal(std::size_t l) const {
    std::size_t end = l + 1;
    const std::size_t last = std::min(population_.leaves.size(), l + max_together);
    while (end < last && population_.leaves[end] == population_.leaves[l]) ++end;
    return end - l;
  }

  // Counts the counted leaves from the l-th on that are on one internode at the same time, whether they fall or not.
  std::size_t count_together(std::size_t l) const {
    const Leaf& first = population_.leaves[l];
    std::size_t end = l + 1;
    const std::size_t last = std::min(population_.leaves.size(), l + max_together);
    while (end < last && population_.leaves[end].shoot == first.shoot && population_.leaves[end].born == first.born &&
           population_.leaves[end].gone == first.gone)
      ++end;
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

  // Adds the twigs of `count` counted leaves from the l-th on, which are together: along their internode, by the
  // arrangement of the species, and one at the tip of the shoot. A short internode has fewer.
  void add_twigs_of(std::size_t l, std::size_t count) {
    TwigPlace place;
    if (!find_twig(l, place)) return;
    const Leaf& counted = population_.leaves[l];
    const ShootPath& path = form_.paths[counted.shoot];
    const float room = glm::distance(form_.nodes[path.first + place.node], form_.nodes[path.first + place.node - 1]) /
                       (twig_distance * habit_.twig_length);
    const std::size_t many = std::min(count * habit_.many, static_cast<std::size_t>(std::max(room, 0.0f)));
    measure_internode(segments_of(moment_, path, counted.shoot, place.node));
    for (std::size_t j = 0; j < many; ++j) {
      const std::uint64_t address = hash_combine(l, j);
      place.falls = falls_now(population_.leaves[l + j * count / many]);
      const bool tip = j + 1 == many && place.node == path.count;
      const float noise = twigs_.unit(hash_combine(address, 1));
      const float along = tip ? 1 : (static_cast<float>(j) + 0.25f + 0.5f * noise) / static_cast<float>(many);
      add_twig(place, along, tip, place.node * count * habit_.many + j, address);
    }
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
    if (!form_.edited.empty() && form_.edited[q].dead) return;
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
    std::uint32_t node = 0;  // at the end of the internode
    bool falls = false;
    glm::vec3 along{0}, normal{0}, binormal{0};
  };

  // Finds the twig of the l-th counted leaf and the share of the leaf that is grown at this time. Returns false if the
  // leaf does not exist at this time.
  bool find_twig(std::size_t l, TwigPlace& place) const {
    const Leaf& counted = population_.leaves[l];
    const ShootPath& path = form_.paths[counted.shoot];
    const bool marked = is_marked(counted);
    place.falls = marked && sheds_now();
    place.share = grown_share(counted.born, time_);
    // Counted leaves about to fall hang for a step and shrink during it; foliage is renewed every year, and an earlier
    // year's shrinks while this year's grows.
    if (counted.gone != Leaf::never)
      place.share *= 1 - grown_share(counted.gone, time_);
    else if (marked)
      place.share *= 1 - std::clamp(time_ - static_cast<float>(counted.falls), 0.0f, 1.0f);
    if (!(place.share > 0) || path.count == 0 || !has_place(form_, counted)) return false;
    const std::uint32_t node =
        std::min<std::uint32_t>(counted.born > path.from ? counted.born - path.from : 0u, path.count - 1) + 1;
    place.segment = moment_.of_node[path.first + node];
    place.node = node;
    if (place.segment < 0) return false;
    const glm::vec3 internode = form_.nodes[path.first + node] - form_.nodes[path.first + node - 1];
    const Segment& twig = moment_.segments[static_cast<std::size_t>(place.segment)];
    const float length = glm::length(internode);
    // A shoot without room to grow has no leaves.
    if (counted.gone != Leaf::never && habit_.twigs.shapes == 0 && length < least_internode * habit_.size) return false;
    place.length = std::min(length, glm::distance(twig.start, twig.end));
    place.along = length > 0 ? internode / length : glm::vec3(0, 1, 0);
    place.normal = any_perpendicular(place.along);
    place.binormal = glm::cross(place.along, place.normal);
    return true;
  }

  // Whether a counted leaf has become a falling one.
  bool is_marked(const Leaf& counted) const {
    return counted.falls != Leaf::never && time_ >= static_cast<float>(counted.falls);
  }
  // Whether a counted leaf is about to fall.
  bool falls_now(const Leaf& counted) const { return is_marked(counted) && sheds_now(); }

  // Whether the grammar's falling leaves are about to fall: at any time in a tree of the paper, whose leaves stay on
  // old wood, and in autumn where foliage is renewed every year.
  bool sheds_now() const { return !population_.has_foliage || (!habit_.evergreen && habit_.season >= autumn); }

  // A place on the wood: its segment, and the unit direction there.
  struct WoodPlace {
    std::int32_t segment = -1;
    glm::vec3 position{0}, tangent{0, 1, 0};
  };

  // Measures the segments of an internode, for `on_internode`.
  void measure_internode(const SegmentRange& range) {
    first_segment_ = range.first;
    ends_.clear();
    float length = 0;
    for (std::size_t i = range.first; i < range.end; ++i)
      ends_.push_back(length += glm::distance(moment_.segments[i].start, moment_.segments[i].end));
  }

  // The place at a share 0 … 1 of the length of the measured internode.
  WoodPlace on_internode(float along) const {
    const float distance = along * ends_.back();
    std::size_t k = 0;
    while (k + 1 < ends_.size() && ends_[k] < distance) ++k;
    const Segment& wood = moment_.segments[first_segment_ + k];
    const glm::vec3 way = wood.end - wood.start;
    const float length = glm::length(way), before = k > 0 ? ends_[k - 1] : 0;
    if (!(length > 0)) return {static_cast<std::int32_t>(first_segment_ + k), wood.end};
    return {static_cast<std::int32_t>(first_segment_ + k),
            wood.start + std::clamp((distance - before) / length, 0.0f, 1.0f) * way, way / length};
  }

  // Adds a twig at a share of the measured internode, and its leaves as far as they are unfolded. `number` counts twigs
  // along the shoot and decides the side.
  void add_twig(const TwigPlace& place, float along, bool tip, std::size_t number, std::uint64_t address) {
    if (ends_.empty()) return;
    const WoodPlace wood = on_internode(along);
    const auto [chance, size] = twigs_.units(address);
    const auto [noise, roll_noise] = twigs_.units(hash_combine(address, 2));
    const TwigHabit& habit = habit_.twigs;
    const bool has_spurs = habit.spurs > 0 && habit.shapes > 1;
    const bool spur = has_spurs && !tip && chance < habit.spurs;
    const std::uint32_t long_shapes = habit.shapes - (has_spurs ? 1 : 0);
    const std::uint32_t shape = spur ? habit.shapes - 1
                                     : std::min(static_cast<std::uint32_t>(static_cast<float>(long_shapes) *
                                                                           twigs_.unit(hash_combine(address, 3))),
                                                long_shapes - 1);
    const glm::vec3 out = direction_of(wood, along, tip, number, noise);
    Organ twig;
    twig.segment = wood.segment;
    twig.position = wood.position;
    twig.scale = place.share * habit_.twig_length * (least_twig + (1 - least_twig) * size);
    twig.rotation = turn_to(out, face_of(wood.position, out, roll_noise));
    twig.mesh = static_cast<std::int32_t>(shape);
    if (twig.position.y + twig.scale * out.y < twig_floor) return;
    Organ leaves = twig;
    leaves.tag = place.falls ? falling_tag : leaf_tag;
    if (shed(address))
      lie_down(leaves, shed_tag, habit_.seed, address);
    else if (place.falls && random_unit(habit_.seed, stream_shake, address) < habit_.fallen)
      lie_down(leaves, fallen_tag, habit_.seed, address);
    if (unfolded_[shape] > 0) plant_.organs.push_back(leaves);
    twig.tag = twig_tag;
    plant_.organs.push_back(twig);
    if (spur || !has_spurs)
      for (std::uint32_t k = 0; k < habit_.blossoms; ++k)
        add_cluster_blossom(hash_combine(address, 16 + k), place, twig);
  }

  // The direction of a twig: off its internode to the side of its number, and then up or down.
  glm::vec3 direction_of(const WoodPlace& wood, float along, bool tip, std::size_t number, float noise) const {
    const glm::vec3& forward = wood.tangent;
    const glm::vec3 level = glm::cross(forward, glm::vec3(0, 1, 0));
    const glm::vec3 x = glm::length(level) > 1e-2f ? glm::normalize(level) : any_perpendicular(forward),
                    z = glm::cross(x, forward);
    float azimuth = 0;
    switch (habit_.twigs.phyllotaxis) {
      case Phyllotaxis::spiral:
        azimuth = 144 * static_cast<float>(number % 5);
        break;
      case Phyllotaxis::two_ranked:
        azimuth = 180 * static_cast<float>(number % 2);
        break;
      case Phyllotaxis::opposite:
        azimuth = 180 * static_cast<float>(number % 2) + 90 * static_cast<float>(number / 2 % 2);
        break;
    }
    const SinCos turn = sincos_degrees(azimuth + 40 * (noise - 0.5f)),
                 angle = sincos_degrees(tip ? twig_tip_angle
                                            : glm::mix(twig_base_angle, twig_end_angle, along) * (0.8f + 0.4f * noise));
    glm::vec3 out = angle.cosine * forward + angle.sine * (turn.cosine * x + turn.sine * z);
    if (habit_.lift >= 0)
      out.y += habit_.lift;
    else
      out = (1 + habit_.lift) * out + glm::vec3(0, habit_.lift, 0);
    const float length = glm::length(out);
    return length > 1e-3f ? out / length : forward;
  }

  // The direction that the upper face of a twig looks to: up and a little outwards, turned about the twig by noise.
  glm::vec3 face_of(const glm::vec3& place, const glm::vec3& out, float noise) const {
    const glm::vec3 outwards(place.x, 0, place.z);
    const float distance = glm::length(outwards);
    glm::vec3 face(0, 1, 0);
    if (distance > 1e-3f) face += 0.5f * outwards / distance;
    face -= glm::dot(face, out) * out;
    const float length = glm::length(face);
    face = length > 0.05f ? face / length : any_perpendicular(out);
    const SinCos roll = sincos_degrees(max_twig_roll * (2 * noise - 1));
    return roll.cosine * face + roll.sine * glm::cross(out, face);
  }

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

  // The share 0 … 1 of a blossom that has opened and not withered this season.
  float blossom_share(std::uint64_t address) const {
    const float late = flower_spread * blooms_.unit(address);
    return smooth_step((habit_.season - flowering - late) / opening) *
           (1 - smooth_step((habit_.season - withering - late) / withered));
  }

  // Adds a blossom of a cluster at the end of a spur.
  void add_cluster_blossom(std::uint64_t address, const TwigPlace& place, const Organ& twig) {
    const float share = place.share * blossom_share(address);
    if (!(share > 0)) return;
    const glm::vec3 up = up_of(twig.rotation), noise = blooms_.direction(hash_combine(address, 1));
    const glm::vec3 direction = noise + 0.6f * up + glm::vec3(0, 0.3f, 0);
    const glm::vec3 out = glm::length(direction) > 1e-3f ? glm::normalize(direction) : up;
    Organ blossom;
    blossom.segment = twig.segment;
    blossom.position = twig.position + spur_end * twig.scale * up + cluster * habit_.blossom_size * (0.4f * noise);
    blossom.tag = blossom_tag;
    blossom.rotation = turn_to(out, any_perpendicular(out));
    blossom.scale = share * habit_.blossom_size;
    plant_.organs.push_back(blossom);
  }

  // The image of +Y under the rotation by a unit quaternion.
  static glm::vec3 up_of(const glm::vec4& q) {
    return {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)};
  }

  // Adds a blossom on a twig, as far as it has opened and not withered this season.
  void add_blossom(std::uint64_t address, const TwigPlace& place) {
    const float share = place.share * blossom_share(address);
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
  const RandomStream turns_, faces_, sizes_, buds_, falls_, blooms_, twigs_;
  const std::vector<float> unfolded_;  // of each shape of twig
  std::size_t first_segment_ = 0;      // of the measured internode,
  std::vector<float> ends_;            // and the distances to its segments' ends
};

}  // namespace

std::vector<float> unfolded_by_shape(const LeafHabit& habit) {
  std::vector<float> shares(habit.twigs.shapes, 1);
  if (habit.evergreen || habit.season > unfolded_by) return shares;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const float begins = budburst + burst_spread * static_cast<float>(i) / static_cast<float>(shares.size());
    shares[i] = smooth_step((habit.season - begins) / unfolding);
  }
  return shares;
}

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
    const bool twigs = habit.twigs.shapes > 0;
    const std::size_t count = twigs ? crown.count_together(l) : crown.count_equal(l);
    if (twigs)
      crown.add_twigs_of(l, count);
    else
      crown.add_leaves_of(l, count);
    if (too_many()) return error;
    l += count;
  }
  for (std::size_t l = 0; habit.blossoms > 0 && habit.twigs.shapes == 0 && l < population.leaves.size(); ++l) {
    crown.add_blossoms_of(l);
    if (too_many()) return error;
  }
  for (std::uint32_t q = 0; habit.bunches > 0 && q < form.paths.size(); ++q)
    if (population.shoots[q].order == 1) crown.add_bunches_of(q);
  if (limits.budget != nullptr) limits.budget->spend(plant.organs.size());
  return {};
}

}  // namespace panicle::growth
