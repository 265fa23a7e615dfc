#include "models/flower/derivation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "expression/messages.generated.hpp"
#include "expression/number_text.hpp"
#include "foundation/bytes.hpp"
#include "foundation/random.hpp"
#include "models/flower/messages.generated.hpp"
#include "models/flower/numbers.hpp"
#include "models/flower/ranks.hpp"

namespace panicle::flower {
namespace {

using expression::error_at;
using expression::number_text;
using generalized_map::message_of;
using generalized_map::none;
using generalized_map::Refusal;

constexpr std::uint32_t max_nested = 32;  // greatest depth of modules in one another
constexpr std::size_t max_notes = 100;
constexpr std::uint64_t of_step = 0x73746570, of_face = 0x66616365;

// The name of a side face in texts: C1, C2 …
std::string name_of_side(Face face) {
  return std::string("C").append(std::to_string(generalized_map::side_number(face)));
}

// A note on a problem in a line of the text.
std::string at_line(std::uint32_t line, const Message& problem) {
  return message(messages::expression::at_line, line, problem);
}

// Derives a flower: applies the productions of a program to a generalized map (a volumetric mesh of darts). Volumes are
// numbered by the map; a record holds how a volume came to be, an instance is one call of a module. Methods that return
// a bool return false with the error in `evaluation_`.
class Deriver {
 public:
  Deriver(const Program& program, const Given& given, const Limits& limits)
      : program_(program),
        limits_(limits),
        evaluation_(program, given),
        numbers_(program, evaluation_),
        derived_(limits.darts),
        attached_(program.growths, 0),
        glued_(program.productions.size(), 0),
        displaced_(program.productions.size(), 0),
        has_label_occurred_(program.labels.size(), 0),
        cut_short_(given.steps > 0),
        condition_results_(program.productions.size(), 0),
        refusals_(program.productions.size(), Refusal::nothing) {}

  // Derives the main grammar and all modules that it calls.
  Result<Derived> run() {
    derived_.notes = program_.notes;
    if (!evaluation_.bind(limits_) || !begin()) return evaluation_.error();
    // Instances are appended while these run.
    for (std::uint32_t instance = 0; instance < derived_.instances.size() && !stopped_; ++instance)
      if (!run(instance)) return evaluation_.error();
    add_notes();
    if (limits_.budget != nullptr)
      limits_.budget->spend(std::min<std::uint64_t>(work_ + evaluation_.work(), limits_.work));
    derived_.whole = !stopped_;
    return std::move(derived_);
  }

 private:
  // A face that a volume grows on, and the number of the growth action that applies there.
  struct Chosen {
    Face face;
    std::uint32_t growth;
  };

  // The label, the grammar's symbol, of a volume.
  std::uint32_t label_of(std::uint32_t volume) const { return derived_.map.volume(volume).label; }

  // Adds the volume of the main axiom.
  bool begin() {
    const Grammar& main = program_.grammars[0];
    derived_.instances.push_back({0, 0, hash_text("flower")});
    Record record;
    record.label = main.axiom;
    record.address = derived_.instances[0].address;
    VolumeValues values;
    if (!numbers_.work_out(record, derived_.records, derived_.instances, derived_.values, 4, values)) return false;
    const auto grown = derived_.map.plant(static_cast<std::uint32_t>(values[0]), main.axiom);
    if (grown.refusal != Refusal::nothing) return stop(grown.refusal, 0, main.place), true;
    record.volume = grown.volume;
    store(record, values);
    firsts_.push_back(grown.volume);
    return true;
  }

  // Records a volume with its values.
  void store(const Record& record, const VolumeValues& values) {
    if (record.volume >= derived_.record_of.size()) derived_.record_of.resize(record.volume + 1, invalid);
    derived_.record_of[record.volume] = static_cast<std::uint32_t>(derived_.records.size());
    derived_.records.push_back(record);
    derived_.values.push_back(values);
    has_label_occurred_[record.label] = 1;
  }

  // Derives an instance of a grammar: in each step rewrites the active volumes, then glues faces that meet.
  bool run(std::uint32_t instance) {
    instance_ = instance;
    active_ = {firsts_[instance]};
    standing_ = {firsts_[instance]};
    if (!numbers_.enter(derived_.instances, instance)) return false;
    const std::uint32_t steps = evaluation_.steps();
    for (step_ = 0; step_ < steps && !stopped_; ++step_) {
      if (active_.empty()) break;
      made_.clear();
      still_.clear();
      for (const std::uint32_t volume : active_) {
        if (!rewrite(volume)) return false;
        if (stopped_) return true;
      }
      still_.insert(still_.end(), made_.begin(), made_.end());
      standing_.insert(standing_.end(), made_.begin(), made_.end());
      std::swap(active_, still_);
      glue_all();
      ++stamp_;
    }
    return true;
  }

  // Applies all productions to one volume in one step: growth, relabelling and splitting, in this order.
  bool rewrite(std::uint32_t volume) {
    const std::uint32_t record = derived_.record_of[volume];
    const Label& label = program_.labels[label_of(volume)];
    const std::uint64_t address = hash_combine(derived_.records[record].address, step_);
    std::uint32_t becomes = invalid, split = invalid, last = invalid;
    bool may_act = false;
    chosen_.clear();
    if (!numbers_.enter(derived_.instances, instance_)) return false;
    for (std::uint32_t i = label.productions.begin; i < label.productions.end; ++i) {
      const Production& production = program_.productions[i];
      if (is_spent(1)) return stop_for_work();
      if (production.kind == Production::Kind::glue) continue;
      const bool grows = production.kind == Production::Kind::grow;
      if (grows && production.becomes == invalid && !room_for(production, volume)) continue;
      may_act = true;
      evaluation_.set_volume(derived_.values[record], derived_.records[record].rank, step_);
      evaluation_.set_face(0);
      if (!evaluation_.holds(production.condition, address)) {
        if (evaluation_.failed()) return false;
        condition_results_[production.number] |= 1;
        continue;
      }
      condition_results_[production.number] |= 2;
      if (!grows) {
        mark_displaced(split == invalid ? nullptr : &program_.productions[split]);
        split = i;
      }
      if (production.becomes != invalid) {
        mark_displaced(becomes == invalid ? nullptr : &program_.productions[last]);
        becomes = production.becomes;
        last = i;
      }
      for (const GrowAction& growth : production.growths)
        if (!choose(growth, volume, address)) return false;
    }
    for (const Chosen& each : chosen_) {
      if (is_spent(0)) return stop_for_work();
      if (!grow(volume, record, each)) return false;
      if (stopped_) return true;
    }
    if (becomes != invalid) {
      derived_.map.relabel(volume, becomes);
      has_label_occurred_[becomes] = 1;
    }
    if (split != invalid && !split_volume(volume, record, program_.productions[split])) return false;
    if (may_act || becomes != invalid || split != invalid) still_.push_back(volume);
    return true;
  }

  // Adds to the work and returns whether a limit of work or time is exceeded. Work is counted by steps of searches and
  // by executed instructions.
  bool is_spent(std::uint64_t more) {
    work_ += more;
    const std::uint64_t work = work_ + evaluation_.work();
    if (limits_.budget != nullptr && work >= next_look_) {
      next_look_ = work + WorkBudget::look_interval;
      out_of_time_ |= limits_.budget->look_at_clock();
    }
    return work > limits_.work || out_of_time_;
  }

  // Marks a production that applies without effect, since a later one has the same kind of effect. Null: none.
  void mark_displaced(const Production* production) {
    if (production != nullptr) displaced_[production->number] = 1;
  }

  // Whether one of the faces that a production grows on may be free; computed faces are unknown until they are
  // evaluated.
  bool room_for(const Production& production, std::uint32_t volume) const {
    for (const GrowAction& growth : production.growths)
      for (const FaceOf& face : growth.faces)
        if (face.worked_out || !derived_.map.has(volume, face.face) || derived_.map.is_free(volume, face.face))
          return true;
    return false;
  }

  // Adds the free faces that a volume grows on; later actions displace earlier ones.
  bool choose(const GrowAction& growth, std::uint32_t volume, std::uint64_t address) {
    const bool worked_out =
        std::any_of(growth.faces.begin(), growth.faces.end(), [](const FaceOf& face) { return face.worked_out; });
    if (worked_out && !evaluation_.run(growth.blocks, address)) return false;
    for (const FaceOf& of : growth.faces) {
      Face face = of.face;
      if (of.worked_out) {
        const float side = evaluation_.at(of.source);
        if (!(side >= 1 && side <= generalized_map::largest_order && std::floor(side) == side))
          return evaluation_.fail(
              error_at(Reason::evaluation, of.place, message(messages::flower::face_number, number_text(side))));
        face = generalized_map::side(static_cast<std::uint32_t>(side));
      }
      if (!derived_.map.has(volume, face))
        return evaluation_.fail(error_at(Reason::evaluation, of.place,
                                         message(messages::flower::no_such_side, program_.labels[label_of(volume)].name,
                                                 derived_.map.volume(volume).order, name_of_side(face))));
      if (!derived_.map.is_free(volume, face)) continue;
      const auto same =
          std::find_if(chosen_.begin(), chosen_.end(), [&](const Chosen& each) { return each.face == face; });
      if (same == chosen_.end()) {
        chosen_.push_back({face, growth.number});
      } else {
        same->growth = growth.number;
      }
    }
    return true;
  }

  // Grows a new volume on the chosen face of a volume; for a module the first volume of a new instance. `before` is the
  // record of the volume that grows.
  bool grow(std::uint32_t volume, std::uint32_t before, const Chosen& chosen) {
    const GrowAction& growth = numbers_.growth(chosen.growth);
    const Instance& host = derived_.instances[instance_];
    if (growth.module && host.depth + 1 > max_nested) {
      if (too_deep_ == 0) too_deep_ = growth.arguments.place.line;
      return true;
    }
    Record record;
    record.kind = Record::Kind::grown;
    record.side = static_cast<std::uint16_t>(
        generalized_map::is_side(chosen.face) ? generalized_map::side_number(chosen.face) : 0);
    record.before = before;
    record.source = chosen.growth;
    record.label = growth.module ? program_.grammars[growth.target].axiom : growth.target;
    record.inherits = !growth.module && record.label == label_of(volume);
    record.instance = growth.module ? static_cast<std::uint32_t>(derived_.instances.size()) : instance_;
    record.maker = instance_;
    record.step = step_;
    if (!growth.module) record.rank = next_rank(derived_.records[before].rank, record.side);
    record.address =
        hash_combine(hash_combine(derived_.records[before].address, of_step + step_), of_face + chosen.face);
    if (growth.module) derived_.instances.push_back({growth.target, host.depth + 1, record.address});
    const auto order = static_cast<float>(derived_.map.degree(derived_.map.dart_of(volume, chosen.face)));
    VolumeValues values;
    if (!numbers_.work_out(record, derived_.records, derived_.instances, derived_.values, order, values)) return false;
    const auto grown = derived_.map.grow(volume, chosen.face, static_cast<std::uint32_t>(values[0]), record.label);
    if (grown.refusal != Refusal::nothing) {
      if (growth.module) derived_.instances.pop_back();
      return stop(grown.refusal, step_, growth.arguments.place), true;
    }
    attached_[chosen.growth] += grown.attached;
    record.volume = grown.volume;
    store(record, values);
    if (growth.module) {
      firsts_.push_back(grown.volume);
    } else {
      made_.push_back(grown.volume);
    }
    return numbers_.enter(derived_.instances, instance_);
  }

  // Splits a volume at a face, and records the rest and the new part with their numbers. A refused split leaves the
  // volume as it is.
  bool split_volume(std::uint32_t volume, std::uint32_t before, const Production& production) {
    // Every corner of the face is visited, also where the split is refused then.
    if (is_spent(derived_.map.volume(volume).order / 4)) return stop_for_work();
    const auto result = derived_.map.split(volume, production.face, production.rest, production.part, stamp_);
    if (result.refusal == Refusal::full) return stop(result.refusal, step_, production.place), true;
    if (result.refusal != Refusal::nothing) {
      refusals_[production.number] = result.refusal;
      return true;
    }
    for (const bool rest : {true, false}) {
      Record record;
      record.kind = rest ? Record::Kind::rest : Record::Kind::part;
      record.volume = rest ? volume : result.part;
      record.before = before;
      record.source = production.number;
      record.label = rest ? production.rest : production.part;
      record.instance = record.maker = instance_;
      record.step = step_;
      record.rank = rest ? derived_.records[before].rank : next_rank(derived_.records[before].rank, 0);
      record.address = hash_combine(hash_combine(derived_.records[before].address, of_step + step_), rest ? 1 : 2);
      VolumeValues values;
      if (!numbers_.work_out(record, derived_.records, derived_.instances, derived_.values,
                             static_cast<float>(derived_.map.volume(record.volume).order), values))
        return false;
      store(record, values);
      if (!rest) made_.push_back(result.part);
    }
    return true;
  }

  // Applies every production that glues to all volumes of the instance; faces that are not adjacent yet wait.
  void glue_all() {
    std::size_t waiting = 0;
    for (std::size_t i = 0; i < standing_.size(); ++i) {
      const std::uint32_t volume = standing_[i];
      if (stopped_ || wants_glue(volume)) standing_[waiting++] = volume;
    }
    standing_.resize(waiting);
  }

  // Whether a volume may still be glued later.
  bool wants_glue(std::uint32_t volume) {
    const Label& label = program_.labels[label_of(volume)];
    bool waits = false;
    for (std::uint32_t i = label.productions.begin; i < label.productions.end; ++i) {
      const Production& production = program_.productions[i];
      // A volume that is relabelled or split may become one that is glued.
      if (production.kind != Production::Kind::glue) {
        waits |= production.becomes != invalid || production.kind == Production::Kind::split;
        continue;
      }
      if (!derived_.map.has(volume, production.face) || !derived_.map.is_free(volume, production.face)) continue;
      if (is_spent(1 + derived_.map.volume(volume).order / 16)) return stop_for_work();
      const auto hinge = derived_.map.adjacent(volume, production.face, production.other, production.other_face,
                                               [&](std::uint32_t other) { return instance_of(other) == instance_; });
      const Refusal refusal = hinge.volume == none
                                  ? Refusal::not_adjacent
                                  : derived_.map.glue(volume, production.face, hinge.volume, production.other_face);
      const bool here = refusal == Refusal::nothing;
      glued_[production.number] += here;
      if (refusal == Refusal::unequal) refusals_[production.number] = refusal;
      waits |= !here;
    }
    return waits;
  }

  // The instance that a volume belongs to.
  std::uint32_t instance_of(std::uint32_t volume) const {
    return derived_.records[derived_.record_of[volume]].instance;
  }

  // Ends the derivation at a step because the map refuses a volume, with a note.
  void stop(Refusal refusal, std::uint32_t step, const expression::SourceLocation& place) {
    stopped_ = true;
    first_note(message(refusal == Refusal::full ? messages::flower::stopped_full : messages::flower::stopped, step,
                       place.line, message_of(refusal)));
  }

  // Adds a note before all others: the most important one.
  void first_note(std::string note) { derived_.notes.insert(derived_.notes.begin(), std::move(note)); }

  // Ends the derivation since work or time is used up, with a note. Returns true: this is no error.
  bool stop_for_work() {
    stopped_ = true;
    if (out_of_time_) {
      first_note(message(messages::flower::stopped_by_time, step_));
      return true;
    }
    first_note(message(messages::flower::stopped_by_work, step_, limits_.work));
    return true;
  }

  // A message if no volume of a label has the face that a glue production names; none if some volume has it. The number
  // of sides may be random, so this is not an error.
  std::optional<Message> without_face(std::uint32_t label, Face face) const {
    std::uint32_t order = 0;
    for (std::uint32_t volume = 0; volume < derived_.map.volumes(); ++volume) {
      if (label_of(volume) != label) continue;
      if (derived_.map.has(volume, face)) return {};
      order = derived_.map.volume(volume).order;
    }
    if (order == 0) return {};
    return message(messages::flower::glue_without_face, program_.labels[label].name, order, name_of_side(face));
  }

  // Adds one note for all attached volumes, since most flowers have such places: a leaf of four sides on a stem of
  // twelve.
  void note_attached() {
    constexpr std::size_t max_named = 6;
    const GrowAction* first = nullptr;
    std::uint32_t first_times = 0;
    std::optional<Message> others;
    std::size_t count = 0;
    for (std::size_t i = 0; i < attached_.size(); ++i) {
      if (attached_[i] == 0 || ++count > max_named) continue;
      const GrowAction& growth = numbers_.growth(static_cast<std::uint32_t>(i));
      if (first == nullptr) {
        first = &growth;
        first_times = attached_[i];
        continue;
      }
      const Message other =
          message(messages::flower::term_attached, name_of(growth), growth.arguments.place.line, attached_[i]);
      others = others ? message(messages::flower::term_list, *others, other) : other;
    }
    if (first == nullptr) return;
    if (count > max_named) others = message(messages::flower::term_and_more, *others, count - max_named);
    derived_.notes.push_back(
        at_line(first->arguments.place.line,
                others ? message(messages::flower::attached_others, name_of(*first), first_times, *others)
                       : message(messages::flower::attached, name_of(*first), first_times)));
  }

  // The name of the volume or module that a growth adds.
  const std::string& name_of(const GrowAction& growth) const {
    return growth.module ? program_.grammars[growth.target].name : program_.labels[growth.target].name;
  }

  // Adds notes on productions that had no effect or only a part of it.
  void add_notes() {
    note_attached();
    for (const Production& production : program_.productions) {
      const auto note = [&](const Message& problem) {
        derived_.notes.push_back(at_line(production.place.line, problem));
      };
      const bool glues = production.kind == Production::Kind::glue;
      const Refusal refusal = refusals_[production.number];
      if (refusal != Refusal::nothing && glues) note(message(messages::flower::some_not_glued, message_of(refusal)));
      if (refusal != Refusal::nothing && !glues) note(message(messages::flower::some_not_split, message_of(refusal)));
      if (glues && refusal == Refusal::nothing && glued_[production.number] == 0) {
        std::optional<Message> lacks = without_face(production.predecessor, production.face);
        if (!lacks) lacks = without_face(production.other, production.other_face);
        if (lacks)
          note(*lacks);
        else if (has_label_occurred_[production.predecessor] != 0 && has_label_occurred_[production.other] != 0)
          note(message(messages::flower::never_adjacent));
      }
      // Only where the text sets the number of steps.
      if (production.by_step && condition_results_[production.number] == 1 && !stopped_ && !cut_short_)
        note(message(messages::flower::never_applied));
      if (displaced_[production.number] != 0) note(message(messages::flower::displaced));
    }
    if (too_deep_ > 0)
      derived_.notes.push_back(at_line(too_deep_, message(messages::flower::modules_too_deep, max_nested)));
    if (derived_.notes.size() <= max_notes) return;
    const std::size_t more = derived_.notes.size() - max_notes;
    derived_.notes.resize(max_notes);
    derived_.notes.push_back(message(messages::flower::more_notes, more));
  }

  const Program& program_;
  const Limits& limits_;
  FlowerEvaluation evaluation_;
  Numbers numbers_;
  Derived derived_;
  std::vector<std::uint32_t> firsts_;                            // of each instance the volume that it begins with
  std::vector<std::uint32_t> active_, still_, made_, standing_;  // volumes of this instance
  std::vector<Chosen> chosen_;
  std::vector<std::uint32_t> attached_, glued_;   // of growths and productions, how often
  std::vector<std::uint8_t> displaced_;           // of productions
  std::vector<std::uint8_t> has_label_occurred_;  // labels that some volume has had
  bool cut_short_;                                // whether the number of steps is given instead of the text's
  // bits of productions: 1 the condition was false once, 2 it was true once
  std::vector<std::uint8_t> condition_results_;
  std::vector<Refusal> refusals_;  // of productions, the last
  std::uint32_t instance_ = 0, step_ = 0;
  std::uint32_t stamp_ = 0;  // number of the step among all instances: splits of one step are cut together
  std::uint64_t work_ = 0, next_look_ = 0;
  bool out_of_time_ = false;
  bool stopped_ = false;
  std::size_t too_deep_ = 0;  // the line of a call that was omitted; 0: none was
};

}  // namespace

// The sizes and angles of all volumes, for the embedding in space.
std::vector<generalized_map::Shape> Derived::shapes() const {
  std::vector<generalized_map::Shape> shapes;
  shapes.reserve(record_of.size());
  const auto of = [](const VolumeValues& all, Field field) { return all[static_cast<std::size_t>(field)]; };
  for (const std::uint32_t record : record_of) {
    const VolumeValues& v = values[record];
    shapes.push_back({of(v, Field::turn_x), of(v, Field::turn_y), of(v, Field::turn_z), of(v, Field::height),
                      of(v, Field::length), of(v, Field::width), of(v, Field::translation)});
  }
  return shapes;
}

// The memory that it holds, roughly.
std::uint64_t Derived::bytes() const {
  std::uint64_t bytes = map.bytes() + bytes_of(records) + bytes_of(values) + bytes_of(record_of) + bytes_of(instances);
  for (const std::string& note : notes) bytes += sizeof note + bytes_of(note);
  return bytes;
}

// Derives a flower from a program and given values.
Result<Derived> derive(const Program& program, const Given& given, const Limits& limits) {
  return Deriver(program, given, limits).run();
}

// Computes the values of all records again for other given values, without deriving the map anew. Returns the error of
// an evaluation.
Result<std::vector<VolumeValues>> reworked(const Program& program, const Given& given, const Derived& derived,
                                           const Limits& limits) {
  FlowerEvaluation evaluation(program, given);
  Numbers numbers(program, evaluation);
  if (!evaluation.bind(limits)) return evaluation.error();
  std::vector<VolumeValues> all(derived.records.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Record& record = derived.records[i];
    const auto order = static_cast<float>(derived.map.volume(record.volume).order);
    if (!numbers.work_out(record, derived.records, derived.instances, all, order, all[i])) return evaluation.error();
    if (evaluation.work() > limits.work)
      return error_at(Reason::limit, {}, message(messages::flower::numbers_limit, limits.work));
  }
  return all;
}

// Whether two texts derive the same map, if the values that it depends on are equal.
bool same_map(const Program& program, const Program& other) {
  return program.structure_key == other.structure_key && program.notes == other.notes &&
         std::equal(program.grammars.begin(), program.grammars.end(), other.grammars.begin(), other.grammars.end(),
                    [](const Grammar& a, const Grammar& b) { return a.once_bound.size() == b.once_bound.size(); });
}

// Whether the change of given values from `before` to `now` can change the map.
bool rebuilds(const Program& program, const Given& before, const Given& now, const Limits& limits) {
  // 0 and −0 are equal, and 1/0 and 1/−0 are far apart.
  const auto differ = [](float a, float b) { return a != b || std::signbit(a) != std::signbit(b); };
  if (before.steps != now.steps || program.values_rebuild) return true;
  if (program.draws_rebuild && before.seed != now.seed) return true;
  if (program.age_rebuilds && differ(before.age, now.age)) return true;
  // The values of the text's own variables decide, whether given, drawn or computed from others.
  FlowerEvaluation then(program, before), here(program, now);
  if (!then.bind(limits) || !here.bind(limits)) return true;
  for (std::size_t i = 0; i < program.variables.size(); ++i) {
    const Variable& variable = program.variables[i];
    if (variable.rebuilds && variable.grammar == 0 && differ(then.variables()[i], here.variables()[i])) return true;
  }
  return false;
}

}  // namespace panicle::flower
