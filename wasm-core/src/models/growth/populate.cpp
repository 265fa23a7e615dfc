#include <algorithm>
#include <cmath>
#include <string>

#include "expression/diagnostics.hpp"
#include "expression/number_text.hpp"
#include "foundation/random.hpp"
#include "models/growth/messages.generated.hpp"
#include "models/growth/population.hpp"
#include "models/growth/volumes.hpp"

namespace panicle::growth {
namespace {

using expression::error_at;

// The results of the rules for one shoot at one step.
struct Outcome {
  bool known = false;
  std::uint32_t branches = 0, leaves = 0, falling = 0;  // leaves: of each new branch
  std::uint32_t foliage = 0, foliage_steps = 1;         // of each internode, and the number of steps that it lasts
  const Rule* buds = nullptr;                           // the last rule of buds that holds; none: branches need no buds
  float bud_chance = 1;
  std::vector<std::pair<const Rule*, float>> child_trunks;  // and the probability of each
  float gravitropism = 0, length = 1;
};

// Leaves of one step that are consecutive in Population::leaves.
struct LeafRange {
  std::uint32_t first = 0, count = 0;
  std::uint16_t step = 0;  // in which they came
};

// The state of a shoot between steps.
struct ShootState {
  std::uint64_t address = 0;
  std::uint32_t buds_used = 0;
  // The latest leaves: counted leaves on the shoot, and those on the branches that it made.
  LeafRange counted, of_branches;
  float gravitropism = 0, length = 1;
};

// The largest number of branches or leaves of one rule; limits stop far smaller ones.
constexpr float max_at_once = 1e7f;
constexpr std::size_t max_outcomes = 1 << 16;

// Builder of the population of shoots by the rules of a grammar, step by step. Methods that return a bool return false
// if an evaluation fails or a limit is exceeded; the error is in `evaluation_`.
class PopulationBuilder {
 public:
  PopulationBuilder(const Rules& rules, std::uint64_t seed, const Limits& limits)
      : rules_(rules), seed_(seed), limits_(limits), evaluation_(rules, seed) {}

  // Grows all steps.
  Result<Population> run(std::uint16_t steps) {
    const bool fine = steps <= limits_.steps || too_many(messages::growth::too_many_steps, limits_.steps);
    if (!fine || !begin(steps)) return evaluation_.error();
    for (std::uint16_t step = 1; step <= steps; ++step)
      if (!grow(step)) return evaluation_.error();
    plant_.steps = steps;
    for (const ShootState& state : shoot_states_) plant_.addresses.push_back(state.address);
    if (limits_.budget != nullptr) limits_.budget->spend(spent_ + evaluation_.work());
    return std::move(plant_);
  }

 private:
  // Evaluates the divisor functions and the footprint, and adds a trunk for each growth volume (the space that a crown
  // fills).
  bool begin(std::uint16_t steps) {
    if (!draw_functions(rules_, seed_, steps, evaluation_)) return false;
    std::vector<GrowthVolume> volumes;
    if (!draw_volumes(rules_, seed_, evaluation_, volumes)) return false;
    for (std::size_t i = 0; i < volumes.size(); ++i)
      if (!add_trunk(volumes[i], -1, 0, hash_combine(hash_text("trunk"), i))) return false;
    return true;
  }

  // Adds a trunk with a growth volume of its own. `parent` is the trunk's shoot that it stands beside, −1: none;
  // `address` that of its random values.
  bool add_trunk(const GrowthVolume& volume, std::int32_t parent, std::uint16_t step, std::uint64_t address) {
    const auto number = static_cast<std::uint32_t>(plant_.volumes.size());
    Environment environment;
    if (!environment_of(rules_, seed_, volume, number, evaluation_, environment)) return false;
    plant_.volumes.push_back(volume);
    plant_.environments.push_back(environment);
    trunk_born_.push_back(step);
    return add_shoot({parent, number, step, static_cast<std::uint16_t>(parent < 0 ? 0 : 1), 0, true}, address);
  }

  // Adds a shoot; `address` is that of its random values.
  bool add_shoot(const Shoot& shoot, std::uint64_t address) {
    if (plant_.shoots.size() >= limits_.segments) return too_many(messages::growth::too_many_shoots, limits_.segments);
    plant_.shoots.push_back(shoot);
    ShootState state;
    state.address = address;
    shoot_states_.push_back(state);
    plant_.branches += shoot.trunk ? 0 : 1;
    return true;
  }

  // Grows all shoots of earlier steps.
  bool grow(std::uint16_t step) {
    outcomes_.clear();
    const std::size_t standing = plant_.shoots.size();
    if (rules_.repeatable && plant_.volumes.size() * step <= max_outcomes)
      outcomes_.resize(plant_.volumes.size() * step);
    for (std::size_t i = 0; i < standing; ++i)
      if (!spend(1) || !grow(static_cast<std::uint32_t>(i), step)) return false;
    return true;
  }

  // Grows one shoot in a step: evaluates the rules, unless they give the same for all shoots of this age, and applies
  // the outcome.
  bool grow(std::uint32_t number, std::uint16_t step) {
    const Shoot shoot = plant_.shoots[number];
    const auto age = static_cast<std::uint16_t>(step - shoot.born);
    Outcome own;
    Outcome& outcome = outcomes_.empty() ? own : outcomes_[std::size_t{shoot.volume} * step + age - 1];
    if (!outcome.known && !decide(number, step, outcome)) return false;
    return deform(number, step, outcome) && shed(number, step, outcome.falling) && branch(number, step, outcome) &&
           add_child_trunks(number, step, outcome);
  }

  // Evaluates all rules for a shoot in a step: how many branches and leaves it grows, its length and gravitropism.
  // False: the evaluation failed or the work is used up.
  bool decide(std::uint32_t number, std::uint16_t step, Outcome& outcome) {
    const Shoot& shoot = plant_.shoots[number];
    const float age = static_cast<float>(step - shoot.born);
    enter_volume(plant_.volumes[shoot.volume], plant_.environments[shoot.volume], evaluation_);
    evaluation_.at(hash_combine(shoot_states_[number].address, step));
    evaluation_.set(Word::k, age);
    evaluation_.set(Word::n, static_cast<float>(step - trunk_born_[shoot.volume] + 1));
    evaluation_.set(Word::gs, step);
    evaluation_.set(Word::order, shoot.order);
    for (const Word word : {Word::ndv, Word::nbr, Word::nlf}) evaluation_.set(word, 0);
    evaluation_.set(Word::length, 1);
    for (const Rule& rule : rules_.of_shoots)
      if (!spend(1) || !apply(rule, number, step, outcome)) return false;
    if (!amount(evaluation_.get(Word::nbr), outcome.branches)) return false;
    outcome.gravitropism = evaluation_.get(Word::gravitropism) - plant_.environments[shoot.volume].gravitropism;
    outcome.length = evaluation_.get(Word::length);
    outcome.known = true;
    return true;
  }

  // Applies a rule to a shoot if its condition holds and its probability is met. Buds and lone trunks are drawn later,
  // with their probability. False: the evaluation failed.
  bool apply(const Rule& rule, std::uint32_t number, std::uint16_t step, Outcome& outcome) {
    if (!evaluation_.holds(rule.condition)) return !evaluation_.failed();
    float chance = 1;
    if (!evaluation_.probability(rule.probability, chance)) return false;
    const Consequence::Kind kind = rule.consequences[0].kind;
    if (kind == Consequence::Kind::buds) {
      outcome.buds = &rule;
      outcome.bud_chance = chance;
      return true;
    }
    if (kind == Consequence::Kind::child_trunk && rule.consequences.size() == 1) {
      if (plant_.shoots[number].trunk) outcome.child_trunks.emplace_back(&rule, chance);
      return true;
    }
    if (chance < 1 && random_unit(seed_, rule.stream, hash_combine(shoot_states_[number].address, step)) >= chance)
      return true;
    return std::all_of(rule.consequences.begin(), rule.consequences.end(),
                       [&](const Consequence& each) { return apply_consequence(rule, each, number, outcome); });
  }

  // Applies a consequence of a rule that holds for a shoot: sets a value, or adds leaves or a trunk to `outcome`.
  // False: the evaluation failed.
  bool apply_consequence(const Rule& rule, const Consequence& each, std::uint32_t number, Outcome& outcome) {
    float value = 0;
    switch (each.kind) {
      case Consequence::Kind::set:
        if (!set(each)) return false;
        break;
      case Consequence::Kind::leaf:
        return evaluation_.work_out(each.number, value) && amount(value, outcome.leaves);
      case Consequence::Kind::falling_leaf:
        return evaluation_.work_out(each.number, value) && amount(value, outcome.falling);
      case Consequence::Kind::foliage:
        return evaluation_.work_out(each.number, value) && amount(value, outcome.foliage) &&
               (!each.steps.value.given ||
                evaluation_.whole(each.steps, 1, 4096, messages::growth::term_foliage_steps, outcome.foliage_steps));
      case Consequence::Kind::child_trunk:
        if (plant_.shoots[number].trunk) outcome.child_trunks.emplace_back(&rule, 1.0f);
        break;
      case Consequence::Kind::buds:
        break;
    }
    return true;
  }

  // Evaluates an assignment of a rule and sets its word.
  bool set(const Consequence& each) {
    float value = 0;
    bool fine = false;
    if (each.word == Word::length) {
      fine = evaluation_.within(each.number, 0, 10, "length", value);
    } else if (each.word == Word::gravitropism) {
      fine = evaluation_.within(each.number, -10, 10, "gravitropism", value);
    } else {
      fine = evaluation_.work_out(each.number, value);
    }
    if (fine) evaluation_.set(each.word, value);
    return fine;
  }

  // Rounds to a whole number of at least 0; an error if it is too large.
  bool amount(float value, std::uint32_t& out) {
    if (value > max_at_once)
      return too_many(messages::growth::too_many_at_once, static_cast<std::uint32_t>(max_at_once));
    out = value > 0 ? static_cast<std::uint32_t>(std::floor(value + 0.5f)) : 0;
    return true;
  }

  // Records a change of a shoot's gravitropism or length.
  bool deform(std::uint32_t number, std::uint16_t step, const Outcome& outcome) {
    ShootState& state = shoot_states_[number];
    if (state.gravitropism == outcome.gravitropism && state.length == outcome.length) return true;
    state.gravitropism = outcome.gravitropism;
    state.length = outcome.length;
    if (plant_.deformations.size() >= limits_.pieces)
      return too_many(messages::growth::too_many_deformations, limits_.pieces);
    plant_.deformations.push_back({number, step, outcome.gravitropism, outcome.length});
    return true;
  }

  // Marks `falling` of the leaves that came in the step before as falling.
  // "Leaves that are generated in the previous step are assigned as falling leaves" (section 3.3). A leaf may sit on
  // the current branch or on one related to it (figure 1), so the shoot's own leaves fall first, then those of its
  // branches. Under the paper's rule N − k is constant while a shoot ages: a shoot with a negative count has never
  // given leaves to branches, and sheds those that it got when it came.
  bool shed(std::uint32_t number, std::uint16_t step, std::uint32_t falling) {
    const ShootState& state = shoot_states_[number];
    for (const LeafRange& range : {state.counted, state.of_branches}) {
      if (range.step + 1 != step) continue;
      for (std::uint32_t i = range.first; i < range.first + range.count && falling > 0; ++i) {
        if (plant_.leaves[i].falls != Leaf::never) continue;
        plant_.leaves[i].falls = step;
        --falling;
      }
    }
    return true;
  }

  // Adds the branches of a shoot in a step with their leaves and foliage: as many as the rules give, or as buds open.
  bool branch(std::uint32_t number, std::uint16_t step, const Outcome& outcome) {
    const Shoot shoot = plant_.shoots[number];
    const auto age = static_cast<std::uint16_t>(step - shoot.born);
    std::uint32_t grown = outcome.branches;
    if (outcome.buds != nullptr && !open_buds(number, step, outcome, grown)) return false;
    if (!add_foliage(number, step, outcome)) return false;
    if (grown == 0) return true;
    const std::uint32_t first = shoot_states_[number].buds_used;
    std::uint16_t node = age;
    std::uint32_t bud_count = 0;
    if (outcome.buds != nullptr) bud_count = buds_until(node = 1);
    const auto first_leaf = static_cast<std::uint32_t>(plant_.leaves.size());
    const auto first_branch = static_cast<std::uint32_t>(plant_.shoots.size());
    for (std::uint32_t i = 0; i < grown; ++i) {
      // Buds open in the order of their internodes.
      while (outcome.buds != nullptr && bud_count <= first + i && node < age) bud_count = buds_until(++node);
      const std::uint64_t address = hash_combine(shoot_states_[number].address, (std::uint64_t{step} << 32) + i);
      const auto order = static_cast<std::uint8_t>(std::min(shoot.order + 1, 255));
      if (!add_shoot({static_cast<std::int32_t>(number), shoot.volume, step, node, order, false}, address))
        return false;
      if (!add_leaves(step, outcome.leaves)) return false;
      shoot_states_.back().counted = {static_cast<std::uint32_t>(plant_.leaves.size()) - outcome.leaves, outcome.leaves,
                                      step};
    }
    if (outcome.buds != nullptr) shoot_states_[number].buds_used += grown;
    shoot_states_[number].of_branches = {first_leaf, static_cast<std::uint32_t>(plant_.leaves.size()) - first_leaf,
                                         step};
    for (std::uint32_t each = first_branch; each < plant_.shoots.size(); ++each)
      if (!add_foliage(each, step, outcome)) return false;
    return true;
  }

  // Adds foliage on the internode of this step. Foliage is renewed every year, so that its falling leaves fall in the
  // autumn of their own step.
  bool add_foliage(std::uint32_t shoot, std::uint16_t step, const Outcome& outcome) {
    if (plant_.leaves.size() + outcome.foliage > limits_.copies)
      return too_many(messages::growth::too_many_leaves, limits_.copies);
    const auto gone =
        static_cast<std::uint16_t>(std::min<std::uint32_t>(step + outcome.foliage_steps, Leaf::never - 1));
    for (std::uint32_t i = 0; i < outcome.foliage; ++i)
      plant_.leaves.push_back({shoot, step, i < outcome.falling ? step : Leaf::never, gone});
    plant_.has_foliage |= outcome.foliage > 0;
    return true;
  }

  // Draws for each remaining bud whether it opens. `grown`: in, the branches that the rules request; out, the number of
  // open buds, at most that many.
  bool open_buds(std::uint32_t number, std::uint16_t step, const Outcome& outcome, std::uint32_t& grown) {
    const ShootState& state = shoot_states_[number];
    const auto age = static_cast<std::uint16_t>(step - plant_.shoots[number].born);
    if (!count_buds(*outcome.buds, age)) return false;
    const std::uint32_t bud_count = buds_until(age), requested = grown;
    const std::uint64_t address = hash_combine(state.address, step);
    grown = 0;
    for (std::uint32_t bud = state.buds_used; bud < bud_count && grown < requested; ++bud) {
      if (!spend(1)) return false;
      if (outcome.bud_chance >= 1 ||
          random_unit(seed_, hash_combine(outcome.buds->stream, bud), address) < outcome.bud_chance)
        ++grown;
    }
    return true;
  }

  // The number of buds on the internodes up to an age, by the last rule of `count_buds`.
  std::uint32_t buds_until(std::uint16_t age) const { return buds_until_[age]; }

  // Counts the buds of the internodes up to an age, by a rule of buds; results are cached in `buds_until_`.
  bool count_buds(const Rule& rule, std::uint16_t age) {
    if (buds_rule_ != &rule) {
      buds_rule_ = &rule;
      buds_until_.assign(1, 0);
    }
    while (buds_until_.size() <= age) {
      evaluation_.set(Word::k, static_cast<float>(buds_until_.size()));
      float value = 0;
      std::uint32_t buds = 0;
      if (!evaluation_.work_out(rule.consequences[0].number, value) || !amount(value, buds)) return false;
      buds_until_.push_back(std::min<std::uint32_t>(buds_until_.back() + buds, 1u << 30));
    }
    return true;
  }

  // Adds leaves to the latest shoot.
  bool add_leaves(std::uint16_t step, std::uint32_t leaves) {
    if (plant_.leaves.size() + leaves > limits_.copies)
      return too_many(messages::growth::too_many_leaves, limits_.copies);
    const auto shoot = static_cast<std::uint32_t>(plant_.shoots.size() - 1);
    for (std::uint32_t i = 0; i < leaves; ++i) plant_.leaves.push_back({shoot, step, Leaf::never, Leaf::never});
    return true;
  }

  // Adds the child trunks of an outcome, each with its probability, in volumes smaller than the parent's.
  bool add_child_trunks(std::uint32_t number, std::uint16_t step, const Outcome& outcome) {
    for (std::size_t i = 0; i < outcome.child_trunks.size(); ++i) {
      const auto& [rule, chance] = outcome.child_trunks[i];
      const std::uint64_t address = hash_combine(shoot_states_[number].address, step);
      if (chance < 1 && random_unit(seed_, rule->stream, address) >= chance) continue;
      const GrowthVolume parent = plant_.volumes[plant_.shoots[number].volume];
      const float share = random_unit(seed_, hash_combine(rule->stream, 1), address);
      if (!add_trunk(smaller(parent, share), static_cast<std::int32_t>(number), step,
                     hash_combine(hash_combine(address, rule->stream), i)))
        return false;
    }
    return true;
  }

  // A growth volume for a child trunk: "A random size is determined between [1, GrowVol.size / 2]" (section 3.4). One
  // random `share` in [0, 1) for all lengths, so that a child trunk's crown has its parent's form. Where half is less
  // than 1 it is half.
  static GrowthVolume smaller(const GrowthVolume& parent, float share) {
    const auto drawn = [share](float whole) {
      const float half = whole / 2, least = std::min(1.0f, half);
      return least + (half - least) * share;
    };
    GrowthVolume volume = parent;
    volume.base = drawn(parent.base);
    volume.height = drawn(parent.height);
    volume.top = drawn(parent.top);
    volume.middle = drawn(parent.middle);
    volume.size = parent.size * volume.height / parent.height;
    return volume;
  }

  // Counts units of work and, now and then, looks at the clock.
  bool spend(std::uint64_t units) {
    spent_ += units;
    const std::uint64_t work = spent_ + evaluation_.work();
    if (limits_.budget != nullptr && work >= next_look_) {
      next_look_ = work + WorkBudget::look_interval;
      if (limits_.budget->look_at_clock())
        return evaluation_.fail(error_at(Reason::limit, {}, message(messages::growth::time_limit)));
    }
    return work <= limits_.work || too_many(messages::growth::too_much_work, limits_.work);
  }

  // Fails with the message of a limit.
  bool too_many(const MessageCode<1>& what, std::uint32_t limit) {
    return evaluation_.fail({Reason::limit, message(what, limit)});
  }

  const Rules& rules_;
  std::uint64_t seed_;
  const Limits& limits_;
  GrowthEvaluation evaluation_;
  Population plant_;
  std::vector<ShootState> shoot_states_;   // one a shoot
  std::vector<std::uint16_t> trunk_born_;  // one a volume
  std::vector<Outcome> outcomes_;          // of this step, by volume and age, where shoots do the same
  std::vector<std::uint32_t> buds_until_;  // by age
  const Rule* buds_rule_ = nullptr;
  std::uint64_t spent_ = 0, next_look_ = 0;
};

}  // namespace

// Grows the population of shoots for a number of steps.
Result<Population> populate(const Rules& rules, std::uint64_t seed, std::uint16_t steps, const Limits& limits,
                            std::vector<std::string>& notes) {
  notes.insert(notes.end(), rules.notes.begin(), rules.notes.end());
  return PopulationBuilder(rules, seed, limits).run(steps);
}

// The number of steps that the rules set or draw; `otherwise` if they do not.
Result<std::uint16_t> steps_of(const Rules& rules, std::uint64_t seed, std::uint16_t otherwise) {
  if (!rules.steps_from.value.given) return otherwise;
  GrowthEvaluation evaluation(rules, seed);
  evaluation.at(hash_text("gs"));
  std::uint32_t from = 0, to = 0;
  if (!evaluation.whole(rules.steps_from, 0, 4096, "gs", from)) return evaluation.error();
  if (!rules.steps_to.value.given) return static_cast<std::uint16_t>(from);
  if (!evaluation.whole(rules.steps_to, 0, 4096, "gs", to)) return evaluation.error();
  return static_cast<std::uint16_t>(
      random_integer(seed, hash_text("gs"), 0, static_cast<std::int32_t>(from), static_cast<std::int32_t>(to)));
}

}  // namespace panicle::growth
