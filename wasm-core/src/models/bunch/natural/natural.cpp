#include "models/bunch/natural/natural.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "models/bunch/foliage/foliage.hpp"
#include "models/bunch/fruit/flower.hpp"
#include "models/bunch/measures/measures.hpp"
#include "models/bunch/natural/exposure.hpp"
#include "models/bunch/natural/fruit_set.hpp"
#include "models/bunch/natural/natural_plan.hpp"
#include "models/bunch/natural/ripening.hpp"
#include "models/bunch/natural/sprouting.hpp"
#include "models/bunch/natural/swelling.hpp"
#include "models/bunch/stock.hpp"

namespace panicle::bunch {
namespace {

constexpr float metres_per_millimetre = 0.001f;
constexpr float farthest = 1e5f;      // millimetres from p1 that anything may be
constexpr float least_share = 0.55f;  // width of a berry over the mean one
constexpr float most_share = 1.5f;
constexpr float stub = 0.3f;          // of the pedicel, left where a berry was
constexpr float unset_size = 0.075f;  // width of a flower's ovary over a ripe berry's

// The more berries, the smaller each is in the picture: finer patterns would not be seen, but cost.
std::uint32_t segments_for(std::size_t berries) {
  return berries <= 80 ? 24 : berries <= 160 ? 20 : berries <= 320 ? 18 : 16;
}

class NaturalGrowth {
 public:
  NaturalGrowth(const Request& request, const Values& values, const Limits& limits, Grown& grown)
      : request_(request), values_(values), limits_(limits), grown_(grown), sprouts_(limits) {}

  Diagnostic run() {
    const Diagnostic trouble = sprout();
    if (trouble.reason != Reason::none) return trouble;
    if (const Diagnostic astray = to_millimetres(); astray.reason != Reason::none) return astray;
    look_at_flowers();
    set_berries();
    swell_berries();
    write_internodes();
    write_berries();
    write_unset();
    ripen();
    remark();
    return {};
  }

 private:
  float value(Parameter key) const { return values_[key]; }
  float chance(std::string_view stream, std::uint64_t address, std::uint32_t bunch) const {
    return random_unit(bunch ? second_seed(request_.seed) : request_.seed, hash_text(stream), address);
  }

  Diagnostic sprout() {
    using enum Parameter;
    const Profile profile = values_.profile();
    auto program = program_for(request_, 4, limits_);
    if (!program) return program.error();
    program_ = std::move(program.value());
    Diagnostic trouble = sprout_one(profile, request_.seed, 0, 0, 0);
    if (trouble.reason != Reason::none || !(value(wing) > 0)) return trouble;
    return sprout_one(scaled(profile, value(wing)), second_seed(request_.seed), 1,
                      static_cast<std::int32_t>(plans_[0].arm.size()), value(wing_angle));
  }

  // Derives one bunch and interprets it.
  Diagnostic sprout_one(const Profile& profile, std::uint64_t seed, std::uint32_t index, std::int32_t first_axis,
                        float lean) {
    plans_.push_back(make_natural_plan(profile, values_, static_cast<float>(limits_.bodies)));
    const NaturalPlan& plan = plans_.back();
    (index ? grown_.second.emplace() : grown_.plan) = plan.plan;
    bounds_.push_back({plan.envelope, lean});
    auto stock = derive_stock(program_, seed, inputs_for(plan, profile, values_), limits_);
    if (!stock) return stock.error();
    stock->first_axis = first_axis;
    stock->lean = lean;
    sprouts_.begin(*stock->bound, index, first_axis);
    const Diagnostic trouble = interpret(stock.value(), limits_, sprouts_);
    return trouble.reason == Reason::none ? sprouts_.trouble() : trouble;
  }

  Diagnostic to_millimetres() {
    for (Internode& internode : sprouts_.internodes) {
      internode.start *= value(Parameter::unit);
      internode.end *= value(Parameter::unit);
      internode.radius *= value(Parameter::unit);
      internode.radius_end *= value(Parameter::unit);
      const glm::vec3& end = internode.end;
      if (!(std::abs(end.x) < farthest && std::abs(end.y) < farthest && std::abs(end.z) < farthest))
        return {Reason::limit,
                "The grammar draws farther than 100 m from where the bunch hangs; make its lengths smaller.", 0, 0};
    }
    return {};
  }

  // How far along the bunch and how much in the sun each flower is.
  void look_at_flowers() {
    const float size = value(Parameter::size);
    const glm::vec3 sun = towards_sun();
    for (const Flower& flower : sprouts_.flowers) {
      const Internode& pedicel = sprouts_.internodes[static_cast<std::size_t>(flower.pedicel)];
      const glm::vec3 place = pedicel.end + flower.heading * (0.5f * size);
      const Bound& bound = bounds_[flower.bunch];
      const SinCos lean = sincos_degrees(bound.lean);
      const glm::vec3 own{place.x * lean.cosine - place.y * lean.sine, place.x * lean.sine + place.y * lean.cosine,
                          place.z};
      const float length = bound.envelope.length();
      const float depth = std::clamp(-own.y, 0.0f, length);
      const float x = std::max(1.0f, bound.envelope.half_width(own.x >= 0 ? 0 : 1, depth));
      const float z = std::max(1.0f, bound.envelope.half_width(own.z >= 0 ? 2 : 3, depth));
      const float out = std::sqrt(own.x / x * (own.x / x) + own.z / z * (own.z / z));
      const float beyond =
          std::max(0.0f, -own.y - depth) + std::max(0.0f, own.y) + std::max(0.0f, out - 1) * std::min(x, z);
      const glm::vec3 outward = glm::vec3(place.x / x, 0.3f, place.z / z);
      const float facing = glm::dot(outward, sun) / std::max(1e-3f, glm::length(outward));
      // A raceme is as wide as its pedicels are long, whatever was drawn.
      const bool raceme =
          pedicel.parent >= 0 && sprouts_.internodes[static_cast<std::size_t>(pedicel.parent)].kind == Kind::rachis;
      buds_.push_back({place, turn_of(flower), raceme ? 0 : beyond / size, flower.strength});
      lit_.push_back(std::clamp(0.5f + 0.5f * facing * std::min(1.0f, out), 0.0f, 1.0f));
      along_.push_back(depth / std::max(1.0f, length));
    }
  }

  // A flower's turn to set, 0 … 1: spread evenly over an axis and over each end structure, so that what sets is.
  float turn_of(const Flower& flower) const {
    constexpr float golden = 0.618034f;
    // Twice the square: so that axis and depth together, in a raceme, are spread evenly as well.
    const float sum = 2 * golden * golden * static_cast<float>(flower.axis + 1) +
                      golden * static_cast<float>(flower.depth) + static_cast<float>(flower.place) / 3 +
                      0.15f * chance("set", flower.address, flower.bunch) + chance("set", 0, flower.bunch);
    return sum - std::floor(sum);
  }

  glm::vec3 towards_sun() const {
    const SinCos height = sincos_degrees(value(Parameter::sun_height)), round = sincos_degrees(value(Parameter::sun));
    return {height.cosine * round.sine, height.sine, height.cosine * round.cosine};
  }

  float most_berries() const {
    float room = 0;
    for (const NaturalPlan& plan : plans_) room += plan.room;
    return std::min(room, static_cast<float>(limits_.bodies));
  }

  // Decides which flowers set: by density, or as many as were asked for.
  void set_berries() {
    const float size = value(Parameter::size), asked = value(Parameter::count), most = most_berries();
    bool full = std::any_of(plans_.begin(), plans_.end(), [](const NaturalPlan& plan) { return plan.overfull; });
    if (asked > 0 || full) {
      set_ = choose_count(buds_, asked > 0 ? std::min(asked, most) : most, size);
    } else {
      set_ = choose_set(buds_, fill_of(value(Parameter::density)), size);
      const auto setting = std::count_if(set_.begin(), set_.end(), [](float share) { return share > 0; });
      full = setting > static_cast<std::ptrdiff_t>(limits_.bodies);
      if (full) set_ = choose_count(buds_, most, size);
    }
    if (full)
      grown_.notes.push_back("A bunch has " + std::to_string(limits_.bodies) +
                             " berries at the most; larger berries or a smaller profile fill the outline.");
  }

  // The berries of the flowers that set, and their widths.
  void size_berries() {
    chosen_.clear();
    shares_.clear();
    std::vector<float> shares;
    float sum = 0, weights = 0;
    for (std::size_t i = 0; i < buds_.size(); ++i) {
      if (!(set_[i] > 0)) continue;
      chosen_.push_back(static_cast<std::uint32_t>(i));
      shares.push_back(share_of(i));
      sum += shares.back() * set_[i];
      weights += set_[i];
    }
    for (std::size_t k = 0; k < shares.size(); ++k)
      shares_.push_back(shares[k] * weights / sum * cube_root(set_[chosen_[k]]));
  }

  // A berry's width over the mean one: its luck, its light and how far the sap has come.
  float share_of(std::size_t i) const {
    const Flower& flower = sprouts_.flowers[i];
    float luck = -6;
    for (std::uint64_t k = 0; k < 12; ++k)
      luck += random_unit(request_.seed, hash_text("size"), hash_combine(flower.address, k + 12 * flower.bunch));
    const float sun = 0.14f * value(Parameter::sunlight) * (lit_[i] - 0.5f);
    const float fed = 0.25f * (1 - value(Parameter::vigour)) * (0.5f - along_[i]);
    return std::clamp((1 + value(Parameter::spread) / 100 * luck) * (1 + sun + fed), least_share, most_share);
  }

  void swell_berries() {
    const std::vector<Branch> branches = branches_of_skeleton();
    std::vector<Branch> all;
    std::vector<Swelling> berries;
    const float asked = std::min(value(Parameter::count), most_berries());
    float wanted = asked;
    // Where some of a count find no room, others of the flowers may.
    for (int tries = 0;; ++tries) {
      size_berries();
      all = branches;
      berries = berries_on(all);
      swollen_ = swell(all, berries, bounds_, sizes_until(value(Parameter::age)));
      const auto lost = static_cast<float>(std::count(swollen_.lost.begin(), swollen_.lost.end(), Why::no_room));
      const float kept = static_cast<float>(chosen_.size()) - lost;
      if (kept >= 0.98f * asked || tries >= 2 || wanted >= std::min(most_berries(), static_cast<float>(buds_.size())))
        break;
      wanted = std::min(wanted + 1.5f * (asked - kept) + 1, most_berries());
      set_ = choose_count(buds_, wanted, value(Parameter::size));
    }
    for (std::size_t k = 0; k < berries.size(); ++k)
      if (swollen_.lost[k] != Why{})
        grown_.thinned.push_back({sprouts_.flowers[chosen_[k]].id, swollen_.lost[k],
                                  swollen_.ends[berries[k].branch] * metres_per_millimetre});
    size_now_ = size_at(value(Parameter::age));
  }

  std::vector<Branch> branches_of_skeleton() {
    branch_of_.assign(sprouts_.internodes.size(), -1);
    std::vector<Branch> branches;
    const float bending = value(Parameter::bend);
    for (std::size_t i = 0; i < sprouts_.internodes.size(); ++i) {
      const Internode& internode = sprouts_.internodes[i];
      if (internode.kind == Kind::pedicel) continue;
      const std::int32_t parent = internode.parent < 0 ? -1 : branch_of_[static_cast<std::size_t>(internode.parent)];
      const float give = internode.kind == Kind::rachis ? 0.1f : internode.kind == Kind::axis ? 0.7f : 0.8f;
      branch_of_[i] = static_cast<std::int32_t>(branches.size());
      branches.push_back({internode.start, internode.end, parent, internode.radius, give * bending});
    }
    return branches;
  }

  // A pedicel that grows from no stem gets a point to hang from, added to `branches`.
  std::vector<Swelling> berries_on(std::vector<Branch>& branches) const {
    std::vector<std::uint32_t> taken = request_.thinned;
    std::sort(taken.begin(), taken.end());
    std::vector<Swelling> berries;
    const float half = value(Parameter::size) / 2;
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      const Flower& flower = sprouts_.flowers[chosen_[k]];
      const Internode& pedicel = sprouts_.internodes[static_cast<std::size_t>(flower.pedicel)];
      const std::int32_t parent = pedicel.parent < 0 ? -1 : branch_of_[static_cast<std::size_t>(pedicel.parent)];
      Swelling berry;
      berry.branch = parent < 0 ? static_cast<std::uint32_t>(branches.size()) : static_cast<std::uint32_t>(parent);
      if (parent < 0) branches.push_back({pedicel.start, pedicel.start, -1, 0, 0});
      berry.heading = flower.heading;
      berry.stalk = glm::length(pedicel.end - pedicel.start);
      berry.half_width = half * shares_[k];
      berry.half_length = berry.half_width * value(Parameter::elongation);
      berry.bunch = flower.bunch;
      berry.taken = std::binary_search(taken.begin(), taken.end(), flower.id);
      berries.push_back(berry);
    }
    return berries;
  }

  // Bends the skeleton to where the swelling left it, and leaves out what bears nothing any more.
  void write_internodes() {
    std::vector<Internode>& internodes = sprouts_.internodes;
    std::vector<std::uint8_t> bears(internodes.size(), 0);
    const auto bear = [&](std::size_t i) { bears[i] = 1; };
    berry_of_.assign(internodes.size(), -1);
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      const std::int32_t pedicel = sprouts_.flowers[chosen_[k]].pedicel;
      berry_of_[static_cast<std::size_t>(pedicel)] = static_cast<std::int32_t>(k);
      bear(static_cast<std::size_t>(pedicel));
    }
    for (std::size_t i = 0; i < buds_.size(); ++i)
      if (!(set_[i] > 0) && hangs(i)) bear(static_cast<std::size_t>(sprouts_.flowers[i].pedicel));
    for (std::size_t i = internodes.size(); i-- > 0;) {
      if (internodes[i].kind == Kind::rachis) bear(i);
      if (bears[i] && internodes[i].parent >= 0) bear(static_cast<std::size_t>(internodes[i].parent));
    }
    place_.assign(internodes.size(), -1);
    const float girth = 0.55f + 0.45f * std::min(1.0f, size_now_ / 0.64f);
    for (std::size_t i = 0; i < internodes.size(); ++i) {
      if (!bears[i]) continue;
      Internode internode = internodes[i];
      const std::int32_t branch = branch_of_[i];
      if (internode.parent >= 0) {
        const std::int32_t above = branch_of_[static_cast<std::size_t>(internode.parent)];
        if (above >= 0) internode.start = swollen_.ends[static_cast<std::size_t>(above)];
        internode.parent = place_[static_cast<std::size_t>(internode.parent)];
      }
      if (branch >= 0)
        internode.end = swollen_.ends[static_cast<std::size_t>(branch)];
      else
        set_pedicel(internode, internodes[i], berry_of_[i]);
      internode.start *= metres_per_millimetre;
      internode.end *= metres_per_millimetre;
      internode.radius *= girth * metres_per_millimetre;
      internode.radius_end *= girth * metres_per_millimetre;
      place_[i] = static_cast<std::int32_t>(grown_.internodes.size());
      grown_.internodes.push_back(internode);
    }
  }

  // A pedicel ends where its berry sits; one that lost it is a stub.
  void set_pedicel(Internode& pedicel, const Internode& grown, std::int32_t berry) {
    const glm::vec3 full = grown.end - grown.start;
    if (berry < 0) {
      pedicel.end = pedicel.start + full * stalk_share();
      return;
    }
    const auto k = static_cast<std::size_t>(berry);
    if (swollen_.lost[k] != Why{}) {
      pedicel.state = State::withered;
      pedicel.end = pedicel.start + full * stub;
      return;
    }
    pedicel.end = swollen_.centres[k] - swollen_.directions[k] * (0.96f * half_length(k));
    pedicel.radius_end *= 1.35f;
  }

  float stalk_share() const { return stalk_at(size_now_); }
  float half_width(std::size_t k) const { return value(Parameter::size) / 2 * shares_[k] * size_now_; }
  float half_length(std::size_t k) const { return half_width(k) * value(Parameter::elongation); }

  // Whether a flower that does not set is still there.
  bool hangs(std::size_t i) const {
    const Flower& flower = sprouts_.flowers[i];
    return value(Parameter::age) < falls_at(chance("fall", flower.address, flower.bunch));
  }

  void write_berries() {
    for (std::size_t k = 0; k < chosen_.size(); ++k)
      if (swollen_.lost[k] == Why{})
        add_berry(chosen_[k], swollen_.centres[k], swollen_.directions[k], half_width(k), half_length(k));
  }

  void write_unset() {
    const float half = value(Parameter::size) / 2 * unset_size;
    for (std::size_t i = 0; i < buds_.size(); ++i) {
      if (set_[i] > 0) continue;
      const Flower& flower = sprouts_.flowers[i];
      const std::int32_t place = place_[static_cast<std::size_t>(flower.pedicel)];
      if (place < 0) {
        const Internode& pedicel = sprouts_.internodes[static_cast<std::size_t>(flower.pedicel)];
        grown_.thinned.push_back({flower.id, Why::not_set, pedicel.start * metres_per_millimetre});
        continue;
      }
      const glm::vec3 end = grown_.internodes[static_cast<std::size_t>(place)].end / metres_per_millimetre;
      add_berry(static_cast<std::uint32_t>(i), end + flower.heading * half, flower.heading, half, half);
    }
  }

  void add_berry(std::uint32_t i, const glm::vec3& centre, const glm::vec3& direction, float half_w, float half_l) {
    const Flower& flower = sprouts_.flowers[i];
    const float ball = half_w * cube_root(half_l / half_w);
    grown_.berries.push_back({centre * metres_per_millimetre, ball * metres_per_millimetre, direction,
                              place_[static_cast<std::size_t>(flower.pedicel)], flower.id});
    bodies_.push_back({centre, direction, half_w, half_l, 0, flower.id});
    bearers_.push_back(i);
  }

  void ripen() {
    const std::vector<float> exposure = sun_exposure(bodies_, towards_sun());
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      const std::uint32_t i = bearers_[k];
      const Flower& flower = sprouts_.flowers[i];
      const float luck = chance("ripen", flower.address, flower.bunch);
      const Stage stage = stage_at(
          value(Parameter::age), {along_[i], luck, exposure[k], value(Parameter::sunlight), value(Parameter::vigour)});
      const float seeds = std::floor(
          4.99f * std::clamp(0.15f + 0.5f * luck + 0.3f * chance("seeds", flower.address, flower.bunch), 0.0f, 1.0f));
      bodies_[k].shrivel = stage.shrivel;
      Traits traits{2 * bodies_[k].half_width * metres_per_millimetre,
                    2 * bodies_[k].half_length * metres_per_millimetre,
                    exposure[k],
                    stage.turned,
                    stage.opened,
                    set_[i] > 0 ? stage.set : 0,
                    stage.shrivel,
                    seeds};
      grown_.traits.push_back(traits);
    }
    grown_.form = {value(Parameter::taper), value(Parameter::blunt),
                   static_cast<Fruit>(static_cast<int>(value(Parameter::fruit)))};
    if (request_.meshes) make_meshes();
    if (request_.measures) {
      std::vector<HungEnvelope> envelopes;
      for (const Bound& bound : bounds_) envelopes.push_back({bound.envelope, bound.lean});
      grown_.measures = measure(grown_, envelopes);
    }
  }

  void make_meshes() {
    BerryOptions options;
    options.segments = segments_for(bodies_.size());
    if (request_.berry_segments) options.segments = std::clamp(request_.berry_segments, 6u, 128u);
    grown_.surfaces = press_berries(bodies_, grown_.form, options);
    for (float& x : grown_.surfaces->positions) x *= metres_per_millimetre;
    const bool flowers =
        std::any_of(grown_.traits.begin(), grown_.traits.end(), [](const Traits& t) { return t.set < 1; });
    if (flowers) grown_.flower = make_flower();
    const auto leaves = static_cast<std::uint32_t>(value(Parameter::leaves));
    if (leaves == 0 && value(Parameter::cane) == 0) return;
    const Envelope& envelope = bounds_[0].envelope;
    float width = 0;
    for (std::size_t side = 0; side < 4; ++side)
      width = std::max(width, 2 * envelope.half_width(side, envelope.length() / 3));
    const float girth = grown_.internodes.empty() ? 0.002f : grown_.internodes[0].radius;
    grown_.foliage =
        grow_foliage({request_.seed, leaves, true, value(Parameter::age), girth, width * metres_per_millimetre});
  }

  void remark() {
    note_remarks(*program_, 4, values_, limits_, grown_.notes);
    if (sprouts_.internodes.empty()) grown_.notes.push_back("The grammar drew nothing.");
    const auto lost = static_cast<std::uint32_t>(std::count_if(
        grown_.thinned.begin(), grown_.thinned.end(), [](const Thinned& one) { return one.why == Why::no_room; }));
    const auto asked = static_cast<std::uint32_t>(value(Parameter::count));
    const auto kept = static_cast<std::uint32_t>(chosen_.size()) - lost;
    if (asked == 0 || static_cast<float>(kept) >= 0.97f * static_cast<float>(asked)) return;
    const std::string wish = std::to_string(asked) + " berries asked for";
    if (buds_.size() < asked)
      grown_.notes.push_back("The grammar bears " + std::to_string(buds_.size()) + " flowers, fewer than the " + wish +
                             ".");
    else
      grown_.notes.push_back("Of the " + wish + " " + std::to_string(kept) +
                             " found room; smaller berries or a larger profile leave room for more.");
  }

  const Request& request_;
  const Values& values_;
  const Limits& limits_;
  Grown& grown_;
  std::shared_ptr<const lsystem::Program> program_;
  Sprouting sprouts_;
  std::vector<NaturalPlan> plans_;
  std::vector<Bound> bounds_;
  std::vector<Bud> buds_;              // one a flower
  std::vector<float> lit_, along_;     // likewise
  std::vector<float> set_;             // likewise: volume of its berry over that of a full one; 0: not set
  std::vector<std::uint32_t> chosen_;  // flowers that set
  std::vector<float> shares_;          // of those: width over the mean
  std::vector<std::int32_t> branch_of_, berry_of_, place_;  // per internode: branch, chosen berry, place in the result
  std::vector<BerryBody> bodies_;                           // of the result, millimetres
  std::vector<std::uint32_t> bearers_;                      // their flowers
  Swollen swollen_;
  float size_now_ = 1;
};

}  // namespace

Diagnostic grow_natural(const Request& request, const Values& values, const Limits& limits, Grown& grown) {
  return NaturalGrowth(request, values, limits, grown).run();
}

}  // namespace panicle::bunch
